"""What `check` names as the cause of faults that share no code with its suspects.

usage: causes_test.py PROGRAM LIBRARY [--table] [FAULT ...]

LIBRARY is faulty.c. A fault is named wrongly if a cause is claimed that is not among its own; that
must never be. --table prints a row for each fault.
"""
import collections
import concurrent.futures
import json
import os
import subprocess
import sys
import tempfile

PROGRAM, LIBRARY = (os.path.abspath(path) for path in sys.argv[1:3])
MORE = os.environ.get("RASTERPROOF_MORE", "") not in ("", "0")
CASES = "60"
# A circumstance says that no suspect explains it, and is no claim; earlier draws are one.
# Of each fault the sections of docs/causes.md that are right; none: no suspect is made for it.
SINGLE = {
    "truncates": "truncation", "truncates-y": "truncation", "floors": "truncation",
    "ceils": "rounding truncation", "half-up": "rounding", "half-down": "rounding",
    "half-away": "rounding", "half-up-in-float": "rounding", "4-bits": "subpixel-bits",
    "7-bits": "subpixel-bits", "whole-pixels": "subpixel-bits", "float16": "",
    "clamps-negative": "range", "clamps-2048": "range", "clamps-to-target": "",
    "int16-coordinates": "overflow", "int20-coordinates": "overflow",
    "int32-products": "overflow", "int32-all": "overflow", "int24-all": "overflow",
    "int28-all": "overflow", "int33-all": "overflow", "int32-edges": "overflow",
    "int36-edges": "overflow", "int32-area": "overflow", "int24-area": "overflow",
    "float-direct": "float-edges", "float-direct-all": "float-edges facing-arithmetic",
    "float-affine": "float-edges", "float-affine-all": "float-edges facing-arithmetic",
    "float-stepped": "float-edges", "drops-4-bits": "edge-precision",
    "drops-8-bits": "edge-precision", "epsilon-inside": "edge-precision",
    "epsilon-outside": "edge-precision", "ties-inclusive": "tie-rule",
    "ties-exclusive": "tie-rule", "ties-bottom-left": "tie-rule", "ties-top-right": "tie-rule",
    "ties-bottom-right": "tie-rule", "ties-no-top": "tie-rule", "ties-all-level": "tie-rule",
    "ties-no-upright": "tie-rule", "ties-of-front-alone": "tie-rule", "ties-by-index": "tie-rule",
    "ties-opposite-first": "", "ties-first-edge-inclusive": "tie-rule",
    "facing-of-input": "facing-arithmetic facing", "exchanged": "facing", "all-front": "facing",
    "culls-back": "facing", "culls-front": "facing", "lost-small": "lost-triangles",
    "lost-tiny": "lost-triangles", "lost-box-of-a-pixel": "lost-triangles",
    "lost-narrow": "lost-triangles", "lost-between-corners": "", "lost-thin": "",
    "lost-far": "lost-triangles", "lost-from-16": "lost-triangles", "lost-by-hash": "",
    "lost-each-third": "list", "lost-behind-half": "", "lost-on-vertices": "vertices",
    "sample-corner": "sample-location", "sample-off-x": "sample-location",
    "sample-off-y": "sample-location", "no-last-column": "target-border",
    "no-first-row": "target-border", "no-column-from-16": "", "no-row-of-odd-height":
    "target-border", "seams-twice": "tile-borders", "seams-lost": "tile-borders",
    "right-half-lost": "", "box-ends-early-x": "bounding-box", "box-ends-early-y": "bounding-box",
    "box-begins-late": "bounding-box", "box-row-lost": "bounding-box", "counts-once": "counting",
    "counts-parity": "", "upside-down": "y-axis", "block-accepted": "", "block-rejected": "",
    "budget-of-a-tile": "list", "flat-as-lines": "flat-triangles", "nan-is-zero": "not-finite",
    "index-of-8-bits": "", "keeps-last-edge": "list",
    "each-third-draw-lost": "earlier-draws", "race": "not-repeatable", "garbage":
    "not-repeatable", "fills-all": "", "draws-nothing": "nothing-drawn",
}  # fmt: skip
PAIRS = [
    "truncates ties-exclusive", "half-up no-last-column", "4-bits lost-small",
    "ties-inclusive box-row-lost", "int32-area truncates", "exchanged sample-corner",
    "culls-back ties-inclusive", "lost-far float-direct", "upside-down half-away",
    "clamps-2048 ties-bottom-right", "counts-once lost-small", "seams-twice ties-exclusive",
    "nan-is-zero truncates", "flat-as-lines half-up", "drops-4-bits culls-front",
    "int16-coordinates no-first-row", "lost-by-hash ties-inclusive", "block-accepted truncates",
    "race ties-inclusive", "budget-of-a-tile floors",
]  # fmt: skip
# A few of all kinds, where every test runs.
FEW = ["int32-all", "lost-between-corners", "draws-nothing", "garbage", "truncates ties-exclusive"]


def names(fault):
    return {name for part in fault.split() for name in SINGLE[part].split()}


def claims(fault):
    """The names and words of the causes that are told."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "found.json")
        done = subprocess.run(
            [PROGRAM, "check", "--plugin", LIBRARY, "--cases", CASES, "--jobs", "1",
             "--cause-seconds", "60", "--json", path],
            env={**os.environ, "RASTERPROOF_FAULT": fault.replace(" ", "+")},
            capture_output=True, text=True, check=False)  # fmt: skip
        if done.returncode != 1:
            return [("not found", f"status {done.returncode}")]
        with open(path, encoding="utf-8") as file:
            found = json.load(file)["subjects"][0]["causes"]
    return [(cause["cause"], cause["text"]) for cause in found]


def judged(fault):
    own = names(fault)
    named = claims(fault)
    wrong = [name for name, text in named
             if name not in own | {"none", "not found"}
             and (name == "earlier-draws" or not text.startswith("no suspect"))]  # fmt: skip
    claimed = {name for name, _ in named} & own
    if not named:  # what is not deterministic has no counterexample
        verdict = "none"
    elif named[0][0] == "not found":
        verdict = "NOT FOUND"
    elif wrong:
        verdict = "WRONG"
    elif own and claimed:
        verdict = "right" if len(fault.split()) == 1 or len(claimed) > 1 else "right, one of two"
    else:
        verdict = "none"
    return fault, verdict, "; ".join(f"{name}: {text}" for name, text in named)


def main():
    arguments = [a for a in sys.argv[3:] if a != "--table"]
    faults = arguments or ([*SINGLE, *PAIRS] if MORE else FEW)
    counts = collections.Counter()
    failed = []
    with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
        for fault, verdict, text in pool.map(judged, faults):
            kind = "pair" if " " in fault else "single"
            counts[kind, verdict] += 1
            if verdict in ("WRONG", "NOT FOUND"):
                failed.append(f"{fault}: {text}")
            if "--table" in sys.argv:
                print(f"| {fault} | {' '.join(sorted(names(fault)))} | {verdict} | {text} |",
                      flush=True)
    for kind in ("single", "pair"):
        own = {verdict: n for (k, verdict), n in sorted(counts.items()) if k == kind}
        print(f"{kind} faults: {sum(own.values())}; " +
              ", ".join(f"{verdict} {n}" for verdict, n in own.items()))
    if failed:
        sys.exit("named wrongly, or not found:\n" + "\n".join(failed))


if __name__ == "__main__":
    main()
