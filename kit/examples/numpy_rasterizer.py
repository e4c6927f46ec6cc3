#!/usr/bin/env python3
"""A rasterizer in numpy, put to the test:

    python3 numpy_rasterizer.py

It is right for one triangle, but for ties: a shared edge's samples are covered twice.
"""
import numpy as np
import rasterproof


def draw(triangles, size):
    width, height = size
    counts = np.zeros((height, width), np.uint32)
    for (x0, y0), (x1, y1), (x2, y2) in triangles[np.isfinite(triangles).all(axis=(1, 2))]:
        left, right = np.clip([min(x0, x1, x2), max(x0, x1, x2) + 1], 0, width).astype(int)
        top, bottom = np.clip([min(y0, y1, y2), max(y0, y1, y2) + 1], 0, height).astype(int)
        y, x = np.mgrid[top:bottom, left:right] + 0.5
        e = [(x - a) * (d - b) - (y - b) * (c - a)
             for a, b, c, d in ((x0, y0, x1, y1), (x1, y1, x2, y2), (x2, y2, x0, y0))]
        area = (x2 - x0) * (y1 - y0) - (y2 - y0) * (x1 - x0)
        if area != 0:
            counts[top:bottom, left:right] += np.all(np.sign(area) * np.array(e) >= 0, axis=0)
    return counts


if __name__ == "__main__":
    report = rasterproof.check(draw, "real", cases=50)
    print(report.text)
    raise SystemExit(report.status)
