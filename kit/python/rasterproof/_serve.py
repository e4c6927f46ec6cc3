"""Answers requests with arrays in NPY, with a function that draws."""

import io
import os
import traceback
from typing import NamedTuple

import numpy as np


class Refused(Exception):
    """Raised by a draw for a scene that it can't take."""


class Wrong(Exception):
    """What a draw returned is no answer."""


class Channel(NamedTuple):
    """A number at each corner, to be interpolated."""

    interpolation: str  # flat, linear, perspective or inverse-w
    at: str  # sample, centre or centroid
    values: object  # float64 (n, 3), of the triangles' corners; None for inverse-w


class Scene(NamedTuple):
    """What a draw of fragments gets."""

    triangles: object  # float64 (n, 3, 4): x, y, z, w
    size: tuple  # (width, height)
    samples: int
    wants: frozenset  # of primitive-ids, barycentrics, depths, values, derivatives
    channels: dict  # by name; empty unless values are wanted


class Fragments(NamedTuple):
    """What it returns: arrays of (height, width), or (height, width, samples) if they are several,
    and more. They are looked at where the scene wants them and the ids are not -1."""

    ids: object  # of the visible triangle, counted from 0; -1 where there is none
    barycentrics: object = None  # (..., 3)
    depths: object = None  # (...)
    values: object = None  # (..., channels), or a dict by name
    derivatives: object = None  # (..., channels, 2), by x and by y; or by name (..., 2)


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
    """The requests of a stream, a call at a time: lists of (id, scene)."""

    def __init__(self, stream, columns):
        self.stream, self.columns, self.vertices, self.channels = stream, columns, None, {}

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
        options = dict(word.partition("=")[::2] for word in words[8:])
        if (count := options.get("channels", "same")) != "same":
            self.channels = dict(self.channel() for _ in range(int(count)))
        triangles = read_array(self.stream)
        corners = self.vertices[:, : self.columns][triangles]
        wants = options.get("wants", "primitive-ids,barycentrics,depths").split(",")
        channels = self.channels if "values" in wants else {}
        return words[1], Scene(
            corners, (int(words[2]), int(words[3])), int(words[4]), frozenset(wants) - {"coverage"},
            {name: Channel(*kind, None if values is None else values[triangles])
             for name, (*kind, values) in channels.items()})  # fmt: skip

    def channel(self):
        name, interpolation, at = self.stream.readline().decode().split()
        values = None if interpolation == "inverse-w" else read_array(self.stream)[:, 0]
        return name, (interpolation, at, values)


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


def integers(drawn):
    drawn = np.asarray(drawn)
    if said := of_wrong_type(drawn):
        raise Wrong(said)
    return drawn


def shown(what, drawn, shape):
    """A part of the fragments, of this shape."""
    if drawn is None:
        raise Wrong(f"it returned no {what}; give an array of shape {shape}")
    drawn = np.asarray(drawn, float)
    if drawn.shape != shape:
        raise Wrong(f"it returned {what} of shape {drawn.shape}, not {shape}")
    return drawn


def of_channels(what, drawn, names, shape, last=()):
    """Values or derivatives, which may come by name."""
    if isinstance(drawn, dict):
        each = [shown(f"{what} of {name}", drawn.get(name), (*shape, *last)) for name in names]
        drawn = np.stack(each, axis=len(shape))
    return shown(what, drawn, (*shape, len(names), *last)).reshape(*shape, len(names), -1)


def fragments(drawn, scene):
    """The word and the bytes of an answer of fragments."""
    if not isinstance(drawn, Fragments):
        raise Wrong(f"it returned {type(drawn).__name__}; return rasterproof.Fragments(ids, ...)")
    shape = (*scene.size[::-1], scene.samples)[: 3 if scene.samples > 1 else 2]
    ids = integers(drawn.ids)
    if ids.shape != shape:
        raise Wrong(f"it returned ids of shape {ids.shape}, not {shape}")
    numbers = []
    if "barycentrics" in scene.wants:
        numbers.append(shown("barycentrics", drawn.barycentrics, (*shape, 3)))
    if "depths" in scene.wants:
        numbers.append(shown("depths", drawn.depths, shape)[..., np.newaxis])
    if "values" in scene.wants:
        each = of_channels("values", drawn.values, scene.channels, shape)
        if "derivatives" in scene.wants:
            along = of_channels("derivatives", drawn.derivatives, scene.channels, shape, (2,))
            each = np.concatenate([each, along], axis=-1)
        numbers.append(each.reshape(*shape, -1))
    if not numbers:
        return ids_or_counts(ids, scene)
    words, at = ["-1"] * ids.size, np.flatnonzero(ids >= 0)
    rows = np.concatenate(numbers, axis=-1).reshape(ids.size, -1)[at].tolist()
    for k, index, row in zip(at.tolist(), ids.flat[at].tolist(), rows):
        words[k] = " ".join(map(repr, (index, *row)))
    columns = ids.size // len(ids)
    lines = (words[k : k + columns] for k in range(0, ids.size, columns))
    return "fragments", b"".join(" ".join(line).encode() + b"\n" for line in lines)


def ids_or_counts(ids, scene):
    if "primitive-ids" in scene.wants:
        return "primitive-ids", ids
    return "counts", ids >= 0


ANSWERS = {"fragments": fragments,
           "primitive-id": lambda drawn, scene: ids_or_counts(integers(drawn), scene)}  # fmt: skip


def answer(number, act):
    """The answer to one request, or how it ended. A traceback is shown once."""
    try:
        word, said = act()
    except Wrong as wrong:
        return f"fault {number} {wrong}\n".encode()
    except Refused as refusal:
        return f"refused {number} {' '.join(str(refusal).split()) or 'no reason given'}\n".encode()
    except Exception as error:  # whatever the user's code raises is a finding
        if not answer.has_shown:
            traceback.print_exc()
            answer.has_shown = True
        return f"fault {number} {where(error)}\n".encode()
    if isinstance(said, bytes):
        return f"{word} {number}\n".encode() + said
    return f"{word} {number} npy\n".encode() + array_bytes(said)


answer.has_shown = False


def serve(draw, requests, replies, *, clip=False, batches=False, coverage="counts"):
    """Answers requests until their end. With `batches`, draw takes a list of (triangles, size), or
    of scenes if it shows fragments."""
    shows_fragments = coverage == "fragments"
    answer_of = ANSWERS.get(coverage, lambda drawn, _: ("counts", integers(drawn)))

    def given(scene):
        return scene if shows_fragments else (scene.triangles, scene.size)

    def act(scene):
        return draw(scene) if shows_fragments else draw(*given(scene))

    for call in Requests(requests, 4 if clip or shows_fragments else 2):
        if not batches:
            for number, scene in call:
                replies.write(answer(number, lambda s=scene: answer_of(act(s), s)))
                replies.flush()
            continue
        drawn = None

        def one(k):
            nonlocal drawn
            if drawn is None:
                drawn = list(draw([given(scene) for _, scene in call]))
                if len(drawn) != len(call):
                    raise ValueError(f"{len(drawn)} arrays for {len(call)} scenes")
            return answer_of(drawn[k], call[k][1])

        for k, (number, _) in enumerate(call):
            replies.write(answer(number, lambda k=k: one(k)))
        replies.flush()
