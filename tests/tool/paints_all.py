#!/usr/bin/env python3
"""A program that covers every sample, and answers before it reads on."""
import sys

for line in sys.stdin:
    _, number, width, height, samples, _, vertices, triangles = line.split()[:8]
    for _ in range(int(vertices) + int(triangles)):
        sys.stdin.readline()
    row = " ".join(["1"] * (int(width) * int(samples)))
    print("counts", number)
    print("\n".join([row] * int(height)), flush=True)
