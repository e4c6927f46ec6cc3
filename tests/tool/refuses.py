#!/usr/bin/env python3
"""The example program, but for scenes of more triangles than it is told: those it refuses.

usage: refuses.py MOST
"""
import os
import subprocess
import sys

EXAMPLE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../kit/examples/program.py")

with subprocess.Popen([EXAMPLE], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True) as child:
    for line in sys.stdin:
        _, number, _, height, _, _, vertices, triangles = line.split()[:8]
        scene = [sys.stdin.readline() for _ in range(int(vertices) + int(triangles))]
        if int(triangles) > int(sys.argv[1]):
            print("refused", number, f"{triangles} triangles are too many", flush=True)
            continue
        child.stdin.writelines([line, *scene])
        child.stdin.flush()
        for _ in range(1 + int(height)):
            print(child.stdout.readline(), end="", flush=True)
