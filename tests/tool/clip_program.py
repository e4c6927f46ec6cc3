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


def determinant(a, b, c):
    return (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
            + a[2] * (b[0] * c[1] - b[1] * c[0]))  # fmt: skip


def covers(v, p):
    facing = determinant(*v)
    if facing == 0:
        return 0
    sides = [determinant(v[a], v[b], p) * facing for a, b in ((0, 1), (1, 2), (2, 0))]
    return int(all(side > 0 for side in sides) if CRACKED else all(side >= 0 for side in sides))


for line in sys.stdin:
    _, number, width, height, _, _, vertices, triangles = line.split()[:8]
    rows = [[float(word) for word in sys.stdin.readline().split()] for _ in range(int(vertices))]
    v = [(x, y, w) for x, y, _, w in rows]
    t = [[v[int(word)] for word in sys.stdin.readline().split()] for _ in range(int(triangles))]
    t = [[[Fraction(c) for c in p] for p in q] for q in t if all(isfinite(c) for p in q for c in p)]
    print("counts", number)
    for j in range(int(height)):
        at = [(Fraction(2 * i + 1, 2), Fraction(2 * j + 1, 2), 1) for i in range(int(width))]
        print(*(sum(covers(q, p) for q in t) for p in at), flush=True)
