#!/usr/bin/env python3
"""A program that takes `same`, and passes draws on to the example, which does not."""
import os
import subprocess
import sys

EXAMPLE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../kit/examples/program.py")

with subprocess.Popen([EXAMPLE], stdin=subprocess.PIPE) as child:
    vertices = []
    for line in sys.stdin.buffer:
        words = line.split()
        if words[6] == b"same":
            print("it was sent the same vertices", file=sys.stderr, flush=True)
            words[6] = str(len(vertices)).encode()
        else:
            vertices = [sys.stdin.buffer.readline() for _ in range(int(words[6]))]
        triangles = [sys.stdin.buffer.readline() for _ in range(int(words[7]))]
        child.stdin.writelines([b" ".join(words) + b"\n", *vertices, *triangles])
        child.stdin.flush()
