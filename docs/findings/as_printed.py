#!/usr/bin/env python3
"""A subject on a pipe that answers whatever it is asked with the rows of a file: what a program of
this folder printed, where no plugin draws as that program does.

usage: as_printed.py FILE
"""
import pathlib
import sys

rows = pathlib.Path(__file__).with_name(sys.argv[1]).read_text(encoding="utf-8").splitlines()
for request in sys.stdin:
    _, number, _, _, _, _, vertices, triangles = request.split()[:8]
    for _ in range(int(vertices) + int(triangles)):
        sys.stdin.readline()
    print("counts", number)
    for row in rows:
        print(*row, flush=True)
