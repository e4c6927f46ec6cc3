#!/usr/bin/env python3
"""Runs PROGRAM, but refuses scenes of more than MOST triangles.

usage: refuses.py MOST PROGRAM...    one that reports facings
"""
import subprocess
import sys

MOST, PROGRAM = int(sys.argv[1]), sys.argv[2:]

with subprocess.Popen(PROGRAM, stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as child:
    for line in sys.stdin:
        _, number, _, height, _, _, vertices, triangles = line.split()[:8]
        scene = [sys.stdin.readline() for _ in range(int(vertices) + int(triangles))]
        if int(triangles) > MOST:
            print("refused", number, f"{triangles} triangles are too many", flush=True)
            continue
        child.stdin.writelines([line, *scene])
        child.stdin.flush()
        for _ in range(1 + 2 * int(height)):
            print(child.stdout.readline(), end="", flush=True)
