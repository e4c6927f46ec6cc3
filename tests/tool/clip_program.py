#!/usr/bin/env python3
"""A rasterizer of clip space on a pipe, exact by rationals: it covers shared edges from both sides.

usage: clip_program.py [crack]

A ray through the sample meets a triangle if the three determinants of the sample and an edge have
the sign of the vertices' own or are zero. With `crack` zero is outside: samples on edges are lost.
"""
import sys
from fractions import Fraction
from math import isfinite

CRACKED = sys.argv[1:] == ["crack"]


def scaled(p):
    """The same ray through integers."""
    exact = [Fraction(c) for c in p]
    unit = max(c.denominator for c in exact)  # powers of two
    return [int(c * unit) for c in exact]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def edges(v):
    """Three vectors whose products with the sample are not negative inside; none: no area."""
    facing = dot(cross(v[0], v[1]), v[2])
    sign = (facing > 0) - (facing < 0)
    if sign == 0:
        return []
    return [[sign * c for c in cross(v[a], v[b])] for a, b in ((0, 1), (1, 2), (2, 0))]


def covers(q, p):
    return int(all(dot(e, p) > 0 for e in q) if CRACKED else all(dot(e, p) >= 0 for e in q))


for line in sys.stdin:
    _, number, width, height, _, _, vertices, triangles = line.split()[:8]
    rows = [[float(word) for word in sys.stdin.readline().split()] for _ in range(int(vertices))]
    v = [(x, y, w) for x, y, _, w in rows]
    t = [[v[int(word)] for word in sys.stdin.readline().split()] for _ in range(int(triangles))]
    t = [edges([scaled(p) for p in q]) for q in t if all(isfinite(c) for p in q for c in p)]
    t = [q for q in t if q]  # without those of no area
    print("counts", number)
    for j in range(int(height)):
        at = [(2 * i + 1, 2 * j + 1, 2) for i in range(int(width))]
        print(*(sum(covers(q, p) for q in t) for p in at), flush=True)
