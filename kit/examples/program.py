#!/usr/bin/env python3
"""A rasterizer on a pipe, exact by rational numbers:

         rasterproof check --exec kit/examples/program.py
"""
import sys
from fractions import Fraction
from math import isfinite


def covers(v, x, y):
    for a, b, c in ((0, 1, 2), (1, 2, 0), (2, 0, 1)):
        dx, dy = v[b][0] - v[a][0], v[b][1] - v[a][1]
        facing = (v[c][0] - v[a][0]) * dy - (v[c][1] - v[a][1]) * dx
        e = ((x - v[a][0]) * dy - (y - v[a][1]) * dx) * facing
        left_or_top = dy * facing > 0 or (dy == 0 and dx * facing < 0)
        if e < 0 or facing == 0 or (e == 0 and not left_or_top):
            return 0
    return 1


for line in sys.stdin:
    _, number, width, height, _, _, vertices, triangles = line.split()[:8]
    v = [[float(w) for w in sys.stdin.readline().split()[:2]] for _ in range(int(vertices))]
    t = [[v[int(w)] for w in sys.stdin.readline().split()] for _ in range(int(triangles))]
    t = [[[Fraction(c) for c in p] for p in q] for q in t if all(isfinite(c) for p in q for c in p)]
    print("counts", number)
    for j in range(int(height)):
        at = [(Fraction(2 * i + 1, 2), Fraction(2 * j + 1, 2)) for i in range(int(width))]
        print(*(sum(covers(q, *p) for q in t) for p in at), flush=True)
