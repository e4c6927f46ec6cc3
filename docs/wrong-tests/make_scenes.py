#!/usr/bin/env python3
"""Writes the scenes and the image of docs/wrong-tests.md beside itself: window pixels, y down.

Vertices are what the tests' float32 arithmetic gives, so they are written exactly.
"""
import json
import pathlib
import struct
import zlib


def rounded(x):
    """The float32 nearest to x."""
    return struct.unpack("f", struct.pack("f", x))[0]


def window(x, y, size, y_up):
    """Clip coordinates (w = 1) through a viewport of the whole target, rounded once more."""
    half = size / 2
    return [rounded(x * half + half), rounded((-y if y_up else y) * half + half)]


def write(name, size, corners):
    scene = {"rasterproof_scene": 1, "name": name, "width": size, "height": size,
             "precision": "float32"}  # fmt: skip
    lines = [json.dumps(scene)[:-1] + ',\n"vertices": [']
    lines.append(",\n".join(json.dumps([x.hex(), y.hex()]) for x, y in corners))
    lines.append('],\n"triangles": [')
    lines.append(",\n".join(json.dumps([k, k + 1, k + 2]) for k in range(0, len(corners), 3)))
    path = pathlib.Path(__file__).with_name(name + ".json")
    path.write_text("\n".join(lines) + "]}\n", encoding="utf-8")


def xorshift(seed):
    """Marsaglia's xorshift (128 bits of state, 32 a call), seeded as the test's generator."""
    mask = 0xFFFFFFFF
    state = [(-seed & mask) ^ 123456789, 362436069 * seed & mask, 521288629 ^ (seed >> 7),
             88675123 ^ (seed << 3 & mask)]  # fmt: skip
    while True:
        t = state[0] ^ (state[0] << 11 & mask)
        state = [*state[1:], state[3] ^ (state[3] >> 19) ^ t ^ (t >> 8)]
        yield state[3]


def random_triangles(count, size):
    """For each triangle a depth, which is left out, and three pairs from -1 to 1."""
    numbers = (rounded(bits & 0xFFFFFFF) / 2**28 for bits in xorshift(5))
    corners = []
    for _ in range(count):
        next(numbers)
        for _ in range(3):
            x, y = (rounded(2 * next(numbers) - 1) for _ in "xy")
            corners.append(window(x, y, size, y_up=False))
    return corners


def narrow_triangle():
    """offload_441 without the first and the last pixel of each row, as a grey PNG."""
    rows = []
    for row in range(256):
        half = max(row + 0.5 - 96, 0) / 2 if row < 160 else 0
        inner = [k for k in range(256) if abs(k + 0.5 - 128) < half][1:-1]
        rows.append(b"\0" + bytes(255 * (k in inner) for k in range(256)))
    png = b"\x89PNG\r\n\x1a\n"
    for kind, data in ((b"IHDR", struct.pack(">IIBBBBB", 256, 256, 8, 0, 0, 0, 0)),
                       (b"IDAT", zlib.compress(b"".join(rows), 9)), (b"IEND", b"")):  # fmt: skip
        body = kind + data
        png += struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))
    pathlib.Path(__file__).with_name("offload_441_narrow.png").write_bytes(png)


def pixel(extent):
    corners = ((-1, extent), (extent, -1), (-1, -1))
    return [window(rounded(x), rounded(y), 1, y_up=True) for x, y in corners]


write("gpuweb_cts_4638", 1, pixel(1.01))
write("gpuweb_cts_4638_mended", 1, pixel(1.03))
write("gpuweb_cts_4638_any", 1, pixel(3))
write("vk_gl_cts_165", 128, random_triangles(128, 128))
write("vk_gl_cts_165_first", 128, random_triangles(1, 128))
corners_441 = ((0, 0.25), (0.25, -0.25), (-0.25, -0.25))
write("offload_441", 256, [window(x, y, 256, y_up=True) for x, y in corners_441])
narrow_triangle()
