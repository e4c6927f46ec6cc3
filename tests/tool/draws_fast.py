"""A rasterizer on a pipe, in doubles: top-left ties on vertices rounded to 1/256 pixel.

usage: draws_fast.py [inclusive] [odd] [moody]
inclusive: every edge owns its samples, so that shared edges count twice. odd: so does every edge of
a triangle whose first corner has an odd x, and no model fits. moody: now and then a draw is not
what it was.
"""
import sys

INCLUSIVE = "inclusive" in sys.argv
ODD = "odd" in sys.argv
MOODY = "moody" in sys.argv


def owns(all_of_them, dx, dy):
    return all_of_them or dy > 0 or (dy == 0 and dx < 0)


def rows_of(corners, width, height):
    """Yields (row, column) of the samples that a triangle covers."""
    (ax, ay), (bx, by), (cx, cy) = corners
    area = (cx - ax) * (by - ay) - (cy - ay) * (bx - ax)
    if area == 0:
        return
    inclusive = INCLUSIVE or (ODD and ax % 2 == 1)
    if area < 0:
        corners = corners[::-1]
    edges = []
    for (px, py), (qx, qy) in zip(corners, corners[1:] + corners[:1]):
        edges.append((px, py, qx - px, qy - py, owns(inclusive, qx - px, qy - py)))
    lowest = max(0, int(min(p[1] for p in corners)) // 256 - 1)
    highest = min(height, int(max(p[1] for p in corners)) // 256 + 2)
    for row in range(lowest, highest):
        y = row * 256 + 128
        for column in range(width):
            x = column * 256 + 128
            for px, py, dx, dy, owned in edges:
                e = (x - px) * dy - (y - py) * dx
                if e < 0 or (e == 0 and not owned):
                    break
            else:
                yield row, column


drawn = 0
for line in sys.stdin:
    _, number, width, height, _, _, vertices, triangles = line.split()[:8]
    width, height = int(width), int(height)
    v = []
    for _ in range(int(vertices)):
        x, y = map(float, sys.stdin.readline().split()[:2])
        fits = abs(x) < 1e5 and abs(y) < 1e5
        v.append((round(x * 256), round(y * 256)) if fits else None)
    counts = [[0] * width for _ in range(height)]
    for _ in range(int(triangles)):
        corners = [v[int(k)] for k in sys.stdin.readline().split()]
        if None in corners:
            continue
        for row, column in rows_of(corners, width, height):
            counts[row][column] += 1
    drawn += 1
    if MOODY and drawn % 7 == 0:
        counts[0][0] += 1
    print("counts", number)
    for row in counts:
        print(*row)
    sys.stdout.flush()
