#!/usr/bin/env python3
"""The values of a rasterizer in numpy and their derivatives, such as those of a texture's u and v:

    python3 numpy_values.py

It states how far they may be off, and nothing of its coverage. A corner's w may be 0 or negative.
"""
import numpy as np
import rasterproof

PROFILE = {"name": "numpy", "contract": "none",
           "values": {"weights": "perspective", "derivatives": "analytic",
                      "error": {"ulps": 1}, "derivative_error": {"ulps": 1, "conditions": 1}}}


@np.errstate(all="ignore")
def draw(scene):
    shape = scene.size[::-1]
    ids, depths = np.full(shape, -1), np.zeros(shape)
    weights, values = np.zeros((*shape, 3)), np.zeros((*shape, len(scene.channels)))
    slopes = np.zeros((*shape, len(scene.channels), 2))
    corners_of = np.array([each.values for each in scene.channels.values()])  # (channels, n, 3)
    y, x = np.mgrid[: shape[0], : shape[1]][..., np.newaxis] + 0.5
    for n, (xs, ys, zs, ws) in enumerate(scene.triangles.transpose(0, 2, 1)):
        dx, dy = xs - x * ws, ys - y * ws  # of each corner, times its w
        (bx, by, bw), (cx, cy, cw) = (np.roll([dx, dy, ws + 0 * dx], -k, axis=-1) for k in (1, 2))
        e = bx * cy - cx * by  # edge functions: of corner k the one opposite to it
        area = (e * ws).sum(axis=-1, keepdims=True)
        inside = np.all(np.sign(area) * e >= 0, axis=-1) & (area[..., 0] != 0)
        ids[inside] = n
        w = weights[inside] = e[inside] / e[inside].sum(axis=-1, keepdims=True)
        depths[inside] = (e / area)[inside] @ zs
        for c, at in enumerate(corners_of[:, n] if scene.channels else []):
            values[inside, c] = w @ at
            apart = at - values[..., c : c + 1]
            for k, along in enumerate((cw * by - bw * cy, bw * cx - cw * bx)):
                slopes[inside, c, k] = ((along * apart).sum(axis=-1) / e.sum(axis=-1))[inside]
    return rasterproof.Fragments(ids, weights, depths, values, slopes)


if __name__ == "__main__":
    report = rasterproof.check(draw, PROFILE, cases=20, coverage="fragments", clip=True,
                               shows="values derivatives")
    print(report.text)
    raise SystemExit(report.status)
