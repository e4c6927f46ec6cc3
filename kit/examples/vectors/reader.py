"""Judges a rasterizer of whole numbers by vectors: 8 subpixel bits, one sample, y down.

usage: reader.py VECTORS.jsonl [inclusive]      inclusive: a wrong tie rule, which is convicted
"""
import json
import sys


def covers(corners, x, y, inclusive):
    """Your rasterizer in its place. All numbers in 1/256 pixel; the rule is top-left."""
    a, b, c = corners
    area = (c[0] - a[0]) * (b[1] - a[1]) - (c[1] - a[1]) * (b[0] - a[0])
    for p, q in ((a, b), (b, c), (c, a)) if area > 0 else ((a, c), (c, b), (b, a)):
        dx, dy = q[0] - p[0], q[1] - p[1]
        e = (x - p[0]) * dy - (y - p[1]) * dx
        if e < 0 or (e == 0 and not (inclusive or dy > 0 or (dy == 0 and dx < 0))):
            return False
    return area != 0


def bit(top, rows, column, row):
    return top <= row < top + len(rows) and int(rows[row - top], 16) >> column & 1


def main():
    inclusive = sys.argv[2:] == ["inclusive"]
    cases = wrong = 0
    with open(sys.argv[1], encoding="utf-8") as file:
        header = json.loads(next(file))
        assert header["rasterproof_vectors"] == 1 and header["lattice_bits"] == 8
        for v in map(json.loads, file):
            if "joint" in v:  # of the case above it
                x, y = v["column"], v["row"]
                if drawn and sum(drawn[t][y][x] for t in v["triangles"]) not in v["counts"]:
                    wrong += 1
                    print(f'{v["joint"]} column {x} row {y}: {v["says"]}: {v["clauses"]}')
                continue
            drawn = []
            if v["fixed"] is None:  # a vertex lies between points of the lattice
                continue
            assert v["y_axis"] == "down" and v["samples_256"] == [[128, 128]]
            cases += 1
            for t in v["triangles"]:
                corners = [v["fixed"][k] for k in t["vertices"]]
                drawn.append([[covers(corners, 256 * x + 128, 256 * y + 128, inclusive)
                               for x in range(v["width"])] for y in range(v["height"])])
                for y in range(v["height"]):
                    for x in range(v["width"]):
                        must = bit(t["must_top"], t["must"], x, y)
                        may = bit(t["may_top"], t["may"], x, y)
                        if not may and drawn[-1][y][x] != must:
                            wrong += 1
                            print(f'{v["case"]} triangle {len(drawn) - 1} column {x} row {y}: '
                                  f'{"must" if must else "must not"} be covered: {v["clauses"]}')
    print(f"{wrong} contradictions" if wrong else "no contradiction", f"in {cases} cases")
    return 1 if wrong or not cases else 0


sys.exit(main())
