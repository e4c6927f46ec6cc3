"""A program on a pipe, exact in fractions: fragments of four samples, and their centroids.

usage: shows_centroids.py [FAULT]
FAULT: last (the last covered sample), unasked (centroids though nobody wants them).
"""
import sys
from fractions import Fraction
from math import isfinite

from exact_model import covers, edge, snap

FAULT = sys.argv[1] if len(sys.argv) > 1 else ""
LOCATIONS = [(Fraction(x, 16), Fraction(y, 16)) for x, y in ((6, 2), (14, 6), (2, 10), (10, 14))]


def barycentrics(v, p):
    area = edge(v[0], v[1], v[2])
    return [edge(v[1], v[2], p) / area, edge(v[2], v[0], p) / area, edge(v[0], v[1], p) / area]


def shown(v, depths, places, covered, wants):
    """Returns the words after the triangle's number at each of the pixel's samples."""
    whole = all(covered)
    order = [s for s in range(4) if covered[s]]
    centre = (places[0][0] - LOCATIONS[0][0] + Fraction(1, 2),
              places[0][1] - LOCATIONS[0][1] + Fraction(1, 2))  # fmt: skip
    at = centre if whole else places[order[-1 if FAULT == "last" else 0]]
    words = []
    for s in range(4):
        numbers = []
        if "barycentrics" in wants:
            numbers += barycentrics(v, places[s])
        if "depths" in wants:
            numbers.append(sum(l * z for l, z in zip(barycentrics(v, places[s]), depths)))
        if "centroids" in wants or FAULT == "unasked":
            numbers += barycentrics(v, at)
        words.append([repr(float(n)) for n in numbers])
    return words


vertices = []
for line in sys.stdin:
    words = line.split()
    number, width, height, count, total = words[1], *(int(w) for w in words[2:4]), *words[6:8]
    wanted = [w.removeprefix("wants=") for w in words if w.startswith("wants=")]
    wants = (wanted or ["primitive-ids,barycentrics,depths"])[0].split(",")
    if count != "same":
        vertices = [[float(w) for w in sys.stdin.readline().split()] for _ in range(int(count))]
    triangles = [[vertices[int(w)] for w in sys.stdin.readline().split()]
                 for _ in range(int(total))]  # fmt: skip
    rows = [[["-1"] for _ in range(4 * width)] for _ in range(height)]
    for t, corners in enumerate(triangles):
        if not all(isfinite(c) for corner in corners for c in corner):
            continue
        v = [(snap(x, 8), snap(y, 8)) for x, y, _, _ in corners]
        for j in range(height):
            for i in range(width):
                places = [(i + x, j + y) for x, y in LOCATIONS]
                covered = [covers(v, p) != 0 for p in places]
                if not any(covered):
                    continue
                depths = [Fraction(z) for _, _, z, _ in corners]
                fragment = shown(v, depths, places, covered, wants)
                for s in range(4):
                    if covered[s]:
                        rows[j][4 * i + s] = [str(t), *fragment[s]]
    if wants == ["coverage"]:
        print("counts", number)
        rows = [[["0" if sample == ["-1"] else "1"] for sample in row] for row in rows]
    else:
        print("primitive-ids" if wants == ["primitive-ids"] else "fragments", number)
    for row in rows:
        print(" ".join(" ".join(sample) for sample in row))
    sys.stdout.flush()
