#!/usr/bin/env python3
"""Another program, but for scenes that it refuses.

usage: refuses_ties.py WHICH PROGRAM...    one that tells facings and has eight subpixel bits
WHICH is 'horizontal': scenes with a pixel centre on a horizontal edge; or 'tenth': a tenth of all.
"""
import math
import random
import subprocess
import sys

WHICH, PROGRAM = sys.argv[1], sys.argv[2:]
TENTHS = random.Random(30)


def snapped(text):
    x = float(text)
    return round(x * 256) / 256 if math.isfinite(x) else x


def has_tie(vertices, triangles, width, height):
    for triangle in triangles:
        corners = [vertices[k] for k in triangle]
        for (ax, ay), (bx, by) in zip(corners, corners[1:] + corners[:1]):
            left, right = sorted((ax, bx))
            if not all(map(math.isfinite, (ax, ay, bx, by))):
                continue
            if ay != by or ay % 1 != 0.5 or not 0 < ay < height:
                continue
            first = max(0, -(-(left - 0.5) // 1))
            if first <= min(width - 1, (right - 0.5) // 1) and left != right:
                return True
    return False


with subprocess.Popen(PROGRAM, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as child:
    for line in sys.stdin:
        _, number, width, height, _, _, vertices, triangles = line.split()[:8]
        scene = [sys.stdin.readline() for _ in range(int(vertices) + int(triangles))]
        places = [tuple(map(snapped, row.split()[:2])) for row in scene[: int(vertices)]]
        corners = [tuple(map(int, row.split()[:3])) for row in scene[int(vertices) :]]
        if (
            TENTHS.random() < 0.1
            if WHICH == "tenth"
            else has_tie(places, corners, int(width), int(height))
        ):
            print("refused", number, "not today", flush=True)
            continue
        child.stdin.writelines([line, *scene])
        child.stdin.flush()
        for _ in range(1 + 2 * int(height)):
            print(child.stdout.readline(), end="", flush=True)
