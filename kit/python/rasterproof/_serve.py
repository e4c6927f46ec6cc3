"""Answers requests with arrays in NPY, with a function that draws."""

import io
import os
import traceback

import numpy as np


class Refused(Exception):
    """Raised by a draw for a scene that it can't take."""


def read_array(stream):
    """An array of the format NPY. (numpy.load wants to seek, which a pipe can't.)"""
    version = np.lib.format.read_magic(stream)
    read = np.lib.format.read_array_header_1_0 if version == (1, 0) else (
        np.lib.format.read_array_header_2_0)  # fmt: skip
    shape, is_fortran, dtype = read(stream)
    size = int(np.prod(shape)) * dtype.itemsize
    array = np.frombuffer(stream.read(size), dtype).reshape(shape, order="FC"[not is_fortran])
    return array


def array_bytes(array):
    array = np.ascontiguousarray(array)
    text = io.BytesIO()
    np.lib.format.write_array_header_1_0(text, np.lib.format.header_data_from_array_1_0(array))
    return text.getvalue() + array.tobytes()


class Requests:
    """The requests of a stream, a call at a time: lists of (id, triangles, size)."""

    def __init__(self, stream, clip=False):
        self.stream, self.columns, self.vertices = stream, 4 if clip else 2, None

    def __iter__(self):
        while line := self.stream.readline():
            words = line.decode().split()
            if not words:
                continue
            count = int(words[1]) if words[0] == "batch" else 1
            if words[0] == "batch":
                words = self.stream.readline().decode().split()
            call = [self.request(words)]
            for _ in range(count - 1):
                call.append(self.request(self.stream.readline().decode().split()))
            yield call

    def request(self, words):
        if words[:1] != ["draw"] or "npy" not in words[8:]:
            raise ValueError(f"a request with npy was expected, not {' '.join(words)!r}; say "
                             "takes window npy in the description")  # fmt: skip
        if words[6] != "same":
            self.vertices = read_array(self.stream)
        triangles = read_array(self.stream)
        corners = self.vertices[:, : self.columns][triangles]
        return words[1], corners, (int(words[2]), int(words[3]))


def where(error):
    """The exception and the last place of the user's own code."""
    frames = traceback.extract_tb(error.__traceback__)
    frame = frames[-1] if frames else None
    at = f" ({os.path.basename(frame.filename)}, line {frame.lineno})" if frame else ""
    return " ".join(f"{type(error).__name__}: {error}{at}".split())


def of_wrong_type(counts):
    """What is wrong with the type of an answer's numbers, or nothing."""
    if counts.dtype.kind in "bui":
        return ""
    if counts.dtype == object:
        inside = "None" if counts.ndim == 0 and counts.item() is None else "not an array of numbers"
        return f"it returned {inside}; return an array of integers"
    return f"it returned {counts.dtype} numbers, not integers"


def answer(number, act):
    """The answer to one request: an array, or how it ended. A traceback is shown once."""
    try:
        counts = np.asarray(act())
    except Refused as refusal:
        return f"refused {number} {' '.join(str(refusal).split()) or 'no reason given'}\n".encode()
    except Exception as error:  # whatever the user's code raises is a finding
        if not answer.has_shown:
            traceback.print_exc()
            answer.has_shown = True
        return f"fault {number} {where(error)}\n".encode()
    if said := of_wrong_type(counts):
        return f"fault {number} {said}\n".encode()
    return f"counts {number} npy\n".encode() + array_bytes(counts)


answer.has_shown = False


def serve(draw, requests, replies, *, clip=False, batches=False):
    """Answers requests until their end. With `batches`, draw takes a list of (triangles, size)."""
    for call in Requests(requests, clip):
        numbers = [number for number, _, _ in call]
        if not batches:
            for number, triangles, size in call:
                replies.write(answer(number, lambda t=triangles, s=size: draw(t, s)))
                replies.flush()
            continue
        drawn = None

        def one(k):
            nonlocal drawn
            if drawn is None:
                drawn = list(draw([(triangles, size) for _, triangles, size in call]))
                if len(drawn) != len(call):
                    raise ValueError(f"{len(drawn)} arrays for {len(call)} scenes")
            return drawn[k]

        for k, number in enumerate(numbers):
            replies.write(answer(number, lambda k=k: one(k)))
        replies.flush()
