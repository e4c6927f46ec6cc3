"""A rasterizer in exact fractions, written apart from the oracle: sample by sample."""
from fractions import Fraction
import math


def snap(value, bits):
    """The multiple of 2^-bits nearest to the value, ties to even; the value itself without bits."""
    if bits is None:
        return Fraction(value)
    scaled = Fraction(value) * 2**bits
    return Fraction(round(scaled), 2**bits)  # Python rounds halves to even


def edge(a, b, p):
    return (p[0] - a[0]) * (b[1] - a[1]) - (p[1] - a[1]) * (b[0] - a[0])


def owns(a, b, p):
    """Whether p is inside a -> b of a front-facing triangle, or on it and it is top or left."""
    e = edge(a, b, p)
    if e != 0:
        return e > 0
    dx, dy = b[0] - a[0], b[1] - a[1]
    # y down, inside is where E > 0: the interior of a horizontal edge that runs left lies below it,
    # and that of an edge that runs down (dy > 0) lies to its right.
    return dy > 0 or (dy == 0 and dx < 0)


def covers(v, p):
    area = edge(v[0], v[1], v[2])
    if area == 0:
        return 0
    if area < 0:
        v = [v[0], v[2], v[1]]
    return int(all(owns(v[k], v[(k + 1) % 3], p) for k in range(3)))


def coverage(width, height, vertices, triangles, bits=None):
    """Rows of counts, top row first."""
    rows = [[0] * width for _ in range(height)]
    for triangle in triangles:
        corners = [vertices[k] for k in triangle]
        if any(not math.isfinite(c) for v in corners for c in v[:2]):
            continue
        v = [(snap(x, bits), snap(y, bits)) for x, y in (c[:2] for c in corners)]
        for j in range(height):
            for i in range(width):
                rows[j][i] += covers(v, (Fraction(2 * i + 1, 2), Fraction(2 * j + 1, 2)))
    return rows
