"""Judges a rasterizer of whole numbers by vectors: 8 subpixel bits, one sample, y down.

usage: reader.py VECTORS.jsonl [inclusive]      inclusive: a wrong tie rule, which is convicted
"""
import json
import sys


# The reader: load, compare, say what contradicts.
def samples(top, rows):
    """Rows of hexadecimal digits as a set of (column, row)."""
    return {(x, top + y) for y, row in enumerate(rows) for x in range(4 * len(row))
            if int(row, 16) >> x & 1}  # fmt: skip


def contradictions(line, drawn):
    if "joint" in line:  # of the case above it
        at = line["column"], line["row"]
        if sum(at in drawn[t] for t in line["triangles"]) not in line["counts"]:
            yield f'{line["joint"]} at {at}: {line["says"]}: {line["clauses"]}'
        return
    for n, t in enumerate(line["triangles"]):
        must, may = samples(t["must_top"], t["must"]), samples(t["may_top"], t["may"])
        for at in sorted((drawn[n] ^ must) - may):
            verb = "must" if at in must else "must not"
            yield f'{line["case"]} triangle {n} at {at}: {verb} be covered: {line["clauses"]}'


def judge(lines, draw):
    header = json.loads(next(lines))
    assert header["rasterproof_vectors"] == 1 and header["lattice_bits"] == 8
    cases = wrong = 0
    for line in map(json.loads, lines):
        if "case" in line:  # without `fixed` a vertex lies between points of the lattice
            drawn = line["fixed"] and [draw(line, t["vertices"]) for t in line["triangles"]]
            cases += 1 if drawn else 0
        for text in contradictions(line, drawn) if drawn else ():
            wrong += 1
            print(text)
    print(f"{wrong} contradictions" if wrong else "no contradiction", f"in {cases} cases")
    return 1 if wrong or not cases else 0


# Your rasterizer in place of this one. All numbers in 1/256 pixel; the rule is top-left.
def covers(corners, x, y, inclusive):
    a, b, c = corners
    area = (c[0] - a[0]) * (b[1] - a[1]) - (c[1] - a[1]) * (b[0] - a[0])
    for p, q in ((a, b), (b, c), (c, a)) if area > 0 else ((a, c), (c, b), (b, a)):
        dx, dy = q[0] - p[0], q[1] - p[1]
        e = (x - p[0]) * dy - (y - p[1]) * dx
        if e < 0 or (e == 0 and not (inclusive or dy > 0 or (dy == 0 and dx < 0))):
            return False
    return area != 0


def draw_triangle(case, vertices):
    """The set of (column, row) that a triangle of the case covers."""
    assert case["y_axis"] == "down" and case["samples_256"] == [[128, 128]]
    corners = [case["fixed"][k] for k in vertices]
    inclusive = sys.argv[2:] == ["inclusive"]
    return {(x, y) for y in range(case["height"]) for x in range(case["width"])
            if covers(corners, 256 * x + 128, 256 * y + 128, inclusive)}  # fmt: skip


with open(sys.argv[1], encoding="utf-8") as file:
    sys.exit(judge(file, draw_triangle))
