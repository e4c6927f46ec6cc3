"""One plain triangle, drawn in a copy of this process before all else."""

import os
import select
import signal

import numpy as np

from . import _serve

_SIZE = (7, 5)
_TRIANGLE = np.array([[[1, 1], [6, 1], [1, 4]]], float)
_LONGEST = 2.0  # seconds; what takes longer is left to the command, which has a limit of its own


def _wanted(samples, coverage):
    """Shapes that are taken; of no samples: of any number of them."""
    width, height = _SIZE
    front = (2,) if coverage == "facing-counts" else ()
    if samples == 1:
        return [(*front, height, width), (*front, height, width, 1)]
    return [(*front, height, width, samples), (*front, height, width * samples)]


def _wrong(drawn, samples, coverage):
    counts = np.asarray(drawn)
    shapes = _wanted(samples, coverage)
    at = f"draw: for a triangle on a target of {_SIZE[0]} x {_SIZE[1]} pixels "
    remedy = f"give integers of shape {shapes[0]}"
    if said := _serve.of_wrong_type(counts):
        return f"{at}{said}; {remedy}"
    if samples and counts.shape not in shapes:
        return f"{at}it returned an array of shape {counts.shape}; {remedy}"
    return ""


def _ask(draw, samples, coverage, clip, batches):
    triangles = _TRIANGLE
    if clip:
        triangles = np.zeros((1, 3, 4))
        triangles[..., :2] = _TRIANGLE / _SIZE * 2 - 1
        triangles[..., 3] = 1
    if not batches:
        return _wrong(draw(triangles, _SIZE), samples, coverage)
    answers = draw([(triangles, _SIZE)])
    if not isinstance(answers, (list, tuple, np.ndarray)) or len(answers) != 1:
        return (f"draw: it returned {type(answers).__name__} for a list of one scene; give a list "
                "of one array")  # fmt: skip
    return _wrong(answers[0], samples, coverage)


def wrong_answer(draw, samples, coverage, *, clip, batches):
    """What is wrong with what it returns for one triangle, or nothing. Exceptions, crashes and
    hangs are not told: the command finds them with their case."""
    if coverage == "fragments":
        return ""
    end, start = os.pipe()
    pid = os.fork()
    if pid == 0:
        try:
            nowhere = os.open(os.devnull, os.O_WRONLY)
            os.dup2(nowhere, 1)
            os.dup2(nowhere, 2)
            os.write(start, _ask(draw, samples, coverage, clip, batches).encode())
        finally:
            os._exit(0)
    os.close(start)
    with os.fdopen(end, "rb") as answer:
        is_ready = select.select([answer], [], [], _LONGEST)[0]
        if not is_ready:
            os.kill(pid, signal.SIGKILL)
        os.waitpid(pid, 0)
        return answer.read().decode() if is_ready else ""
