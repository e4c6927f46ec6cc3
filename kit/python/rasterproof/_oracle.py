"""rasterproof_oracle.h by ctypes: arrays in, arrays out."""

import ctypes
import json
import math
import os
import pathlib
from typing import NamedTuple

import numpy as np

VERSION = 1  # of the header that this file follows
MUST_NOT, MUST, MAY = 0, 1, 2
_NAME = "librasterproof_oracle.so.1"


class BadArgument(ValueError):
    """The message names the argument and the remedy."""


class NotDecided(ValueError):
    """The profile states nothing of what was asked; the message says why."""


class Verdict(NamedTuple):
    """Whether one legal rasterizer draws all of something. It is true if one does."""

    is_legal: bool
    is_judged: bool  # else the search was given up: neither legal nor not
    reason: str

    def __bool__(self):
        return self.is_legal


class _Scene(ctypes.Structure):
    _fields_ = [
        ("width", ctypes.c_int32), ("height", ctypes.c_int32), ("clip_space", ctypes.c_int32),
        ("vertices", ctypes.c_void_p), ("vertex_count", ctypes.c_size_t),
        ("triangles", ctypes.c_void_p), ("triangle_count", ctypes.c_size_t),
    ]  # fmt: skip


def _load():
    named = os.environ.get("RASTERPROOF_ORACLE")
    beside = pathlib.Path(__file__).with_name(_NAME)
    path = named or (str(beside) if beside.exists() else _NAME)
    picosat = beside.with_name("libpicosat.so.1")
    try:
        if path == str(beside) and picosat.exists():  # in a wheel; loaded by its name from then on
            ctypes.CDLL(str(picosat), mode=ctypes.RTLD_GLOBAL)
        library = ctypes.CDLL(path)
    except OSError as error:
        raise ImportError(f"{path}: {error}; install rasterproof, or name the library in the "
                          "environment variable RASTERPROOF_ORACLE") from error  # fmt: skip
    if (found := library.rasterproof_oracle_version()) != VERSION:
        raise ImportError(f"{path}: it is of version {found}, and this package of {VERSION}; "
                          "install both from one release")  # fmt: skip
    double, size, pointer = ctypes.c_double, ctypes.c_size_t, ctypes.c_void_p
    library.rasterproof_oracle_message.restype = ctypes.c_char_p
    library.rasterproof_oracle_close.argtypes = [pointer]
    library.rasterproof_oracle_samples.argtypes = [pointer]
    library.rasterproof_oracle_open.argtypes = [ctypes.c_char_p, ctypes.POINTER(pointer)]
    library.rasterproof_oracle_place.argtypes = [
        pointer, ctypes.c_int32, ctypes.c_int32, double, double,
        ctypes.POINTER(double), ctypes.POINTER(double)]  # fmt: skip
    scene = ctypes.POINTER(_Scene)
    library.rasterproof_oracle_counts.argtypes = [pointer, scene, pointer, pointer, size]
    library.rasterproof_oracle_decide.argtypes = [pointer, scene, pointer, size]
    library.rasterproof_oracle_bounds.argtypes = [pointer, scene, pointer, pointer, size]
    library.rasterproof_oracle_judge.argtypes = [
        pointer, scene, pointer, size, ctypes.c_int32, ctypes.POINTER(ctypes.c_int32)]  # fmt: skip
    library.rasterproof_oracle_edge_sign.argtypes = [double] * 6
    library.rasterproof_oracle_barycentrics.argtypes = [double] * 8 + [ctypes.POINTER(double)] * 3
    library.rasterproof_oracle_value.argtypes = (
        [ctypes.POINTER(double)] * 2 + [ctypes.c_int32] + [double] * 2
        + [ctypes.POINTER(double)] * 3)  # fmt: skip
    return library


_library = _load()


def _require(status):
    if status == 0:
        return
    message = _library.rasterproof_oracle_message().decode(errors="replace")
    raise {-1: BadArgument, -2: NotDecided, -3: MemoryError}.get(status, RuntimeError)(message)


def profile_text(profile):
    """A profile as the text of a file, or the name of a preset."""
    if isinstance(profile, Profile):
        return profile.text
    if isinstance(profile, dict):
        return json.dumps(profile)
    if isinstance(profile, os.PathLike):
        return pathlib.Path(profile).read_text(encoding="utf-8")
    if isinstance(profile, str):
        return profile
    raise BadArgument(f"profile: a {type(profile).__name__}; give a preset's name, a dict with the "
                      "keys of a profile, its text, or a path")  # fmt: skip


class Profile:
    """What a rasterizer states: open it once to ask many questions."""

    def __init__(self, profile="real"):
        self.text = profile_text(profile)
        self.handle = ctypes.c_void_p()
        _require(_library.rasterproof_oracle_open(self.text.encode(), ctypes.byref(self.handle)))
        self.samples = _library.rasterproof_oracle_samples(self.handle)

    def __del__(self):
        if getattr(self, "handle", None) and _library is not None:
            _library.rasterproof_oracle_close(self.handle)

    def __repr__(self):
        return f"Profile({self.text!r})"


def _opened(profile):
    return profile if isinstance(profile, Profile) else Profile(profile)


def vertices_and_indices(triangles):
    """Triangles in either form: float64 (v, 4), with w = 1 where none is given, int32 (n, 3)."""
    if isinstance(triangles, tuple) and len(triangles) == 2:
        corners, indices = (np.asarray(part) for part in triangles)
    else:
        corners = np.asarray(triangles)
        if corners.size == 0:
            corners = corners.reshape(0, 3, 2)
        if corners.ndim != 3 or corners.shape[1] != 3:
            raise BadArgument(f"triangles: shape {corners.shape}; give (n, 3, 2), or a pair of "
                              "vertices (v, 2) and indices (n, 3)")  # fmt: skip
        corners = corners.reshape(-1, corners.shape[2])
        indices = np.arange(len(corners), dtype=np.int32).reshape(-1, 3)
    if corners.ndim != 2 or not 2 <= corners.shape[1] <= 4:
        raise BadArgument(f"vertices: shape {corners.shape}; give two to four numbers each")
    if indices.size == 0:
        indices = indices.reshape(0, 3)
    if indices.ndim != 2 or indices.shape[1] != 3 or indices.dtype.kind not in "iuf":
        raise BadArgument(f"indices: shape {indices.shape} of {indices.dtype}; give integers, "
                          "(n, 3)")  # fmt: skip
    full = np.zeros((len(corners), 4))
    full[:, 3] = 1
    full[:, : corners.shape[1]] = corners
    return full, np.ascontiguousarray(indices, dtype=np.int32)


class _Asked:
    """A profile and a scene as the library takes them; the arrays live as long as this."""

    def __init__(self, triangles, size, profile, clip=False):
        self.profile = _opened(profile)
        self.vertices, self.indices = vertices_and_indices(triangles)
        try:
            width, height = (int(side) for side in size)
        except (TypeError, ValueError):
            raise BadArgument(f"size: {size!r}; give (width, height)") from None
        if not (0 < width < 2**31 and 0 < height < 2**31):
            raise BadArgument(f"size: {size!r}; give (width, height), each 1 or more")
        self.scene = _Scene(width, height, int(clip), self.vertices.ctypes.data, len(self.vertices),
                            self.indices.ctypes.data, len(self.indices))  # fmt: skip
        self.shape = (height, width)
        if self.profile.samples != 1:
            self.shape += (self.profile.samples,)

    def call(self, function, *arguments):
        _require(function(self.profile.handle, ctypes.byref(self.scene), *arguments))


def coverage(triangles, size, profile="real", *, clip=False, facings=False):
    """How many triangles the profile's canonical model counts at each sample.

    Returns uint32 of shape (height, width), with several samples a pixel (height, width, samples),
    the top row first; with `facings` (2, ...), front faces (positive area) before back faces.
    """
    asked = _Asked(triangles, size, profile, clip)
    counts = np.zeros((2, *asked.shape), np.uint32)
    asked.call(_library.rasterproof_oracle_counts, counts[0].ctypes.data, counts[1].ctypes.data,
               counts[0].size)  # fmt: skip
    return counts if facings else counts.sum(axis=0, dtype=np.uint32)


def decided(triangles, size, profile, *, clip=False):
    """What legal rasterizers do with each triangle alone: MUST_NOT, MUST or MAY cover it.

    Returns uint8 of shape (n, height, width), or (n, height, width, samples). Of two neighbours a
    sample on their edge may be MAY for both though exactly one covers it: legal() judges together.
    """
    asked = _Asked(triangles, size, profile, clip)
    decisions = np.zeros((len(asked.indices), *asked.shape), np.uint8)
    asked.call(_library.rasterproof_oracle_decide, decisions.ctypes.data, decisions.size)
    return decisions


def bounds(triangles, size, profile, *, clip=False):
    """How often legal rasterizers cover each sample: (least, most), each as from coverage()."""
    asked = _Asked(triangles, size, profile, clip)
    both = np.zeros((2, *asked.shape), np.uint32)
    asked.call(_library.rasterproof_oracle_bounds, both[0].ctypes.data, both[1].ctypes.data,
               both[0].size)  # fmt: skip
    return both[0], both[1]


def legal(triangles, size, counts, profile, *, clip=False, mask=False):
    """Whether one legal rasterizer of the profile draws these counts; with `mask`, whether it
    covers just the samples where `counts` is not 0. Returns a Verdict, which says why not."""
    asked = _Asked(triangles, size, profile, clip)
    drawn = np.asarray(counts)
    if drawn.dtype.kind not in "bui":
        raise BadArgument(f"counts: of type {drawn.dtype}; give integers, or booleans with mask")
    if drawn.shape != asked.shape:
        raise BadArgument(f"counts: shape {drawn.shape}; give {asked.shape}")
    if drawn.size and (drawn.min() < 0 or drawn.max() >= 2**32):
        raise BadArgument("counts: a count below 0 or past 2^32; give how many triangles cover it")
    drawn = np.ascontiguousarray(drawn, dtype=np.uint32)
    verdict = ctypes.c_int32()
    asked.call(_library.rasterproof_oracle_judge, drawn.ctypes.data, drawn.size, int(mask),
               ctypes.byref(verdict))  # fmt: skip
    if verdict.value == 0:
        return Verdict(True, True, "")
    reason = _library.rasterproof_oracle_message().decode(errors="replace")
    return Verdict(False, verdict.value == 1, reason)


def edge_sign(a, b, p):
    """The sign of E(a, b; p): 1 if a, b, p turn counter-clockwise on the screen, -1 if clockwise, 0
    if they are collinear. Exact for every finite double."""
    sign = _library.rasterproof_oracle_edge_sign(*a, *b, *p)
    if sign == 2:
        raise BadArgument(f"a coordinate of {a}, {b}, {p} is not finite; give finite numbers")
    return sign


def barycentrics(triangle, p):
    """The three barycentrics of p, each rounded once to the nearest double."""
    (x0, y0), (x1, y1), (x2, y2) = triangle
    three = [ctypes.c_double(math.nan) for _ in range(3)]
    _require(_library.rasterproof_oracle_barycentrics(
        x0, y0, x1, y1, x2, y2, *p, *(ctypes.byref(b) for b in three)))  # fmt: skip
    return tuple(b.value for b in three)


_INTERPOLATIONS = {"linear": 1, "perspective": 2, "over-w": 3}


def value(corners, numbers, p, interpolation="perspective"):
    """(value, d/dx, d/dy) at p of one number a corner, each rounded once to the nearest double.

    Corners are (x, y) of the window, or (x, y, w) before the division by w, which may have any
    sign. "over-w" gives the number over w: 1/w of the numbers 1, a depth of the corners' z."""
    if interpolation not in _INTERPOLATIONS:
        raise BadArgument(f"interpolation: {interpolation!r}; give one of {list(_INTERPOLATIONS)}")
    flat = [float(c) for corner in corners for c in (*corner, 1.0)[:3]]
    if len(flat) != 9 or len(numbers) != 3:
        raise BadArgument("give three corners of two or three coordinates, and three numbers")
    three = [ctypes.c_double(math.nan) for _ in range(3)]
    _require(_library.rasterproof_oracle_value(
        (ctypes.c_double * 9)(*flat), (ctypes.c_double * 3)(*map(float, numbers)),
        _INTERPOLATIONS[interpolation], *p, *(ctypes.byref(x) for x in three)))  # fmt: skip
    return tuple(x.value for x in three)


def place(point, size, profile):
    """Where the profile's canonical model places a vertex on a target of that size."""
    profile = _opened(profile)
    x, y = ctypes.c_double(), ctypes.c_double()
    _require(_library.rasterproof_oracle_place(
        profile.handle, *size, *point, ctypes.byref(x), ctypes.byref(y)))  # fmt: skip
    return x.value, y.value
