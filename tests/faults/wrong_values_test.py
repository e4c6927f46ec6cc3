"""Faults of values in a rasterizer that shares no code with the product: found, and named.

usage: wrong_values_test.py PROGRAM LIBRARY EXAMPLE

LIBRARY is wrong_values.c, EXAMPLE is kit/examples/values.c. A fault is named wrongly if a cause is
claimed that is not its own.
"""
import concurrent.futures
import json
import os
import subprocess
import sys
import tempfile
import unittest

PROGRAM, LIBRARY, EXAMPLE = (os.path.abspath(path) for path in sys.argv[1:4])
CASES = "100"
SEEDS = ("1",) if os.environ.get("RASTERPROOF_MORE", "") in ("", "0") else "12345"

# The section of docs/causes.md that names it.
FAULTS = {
    "affine": "affine-weights",
    "linear-curved": "affine-weights",
    "twice": "weights-by-w",
    "multiplied": "weights-by-w",
    "not-divided": "missing-division",
    "first-two": "exchanged-weights",
    "last-two": "exchanged-weights",
    "last-two-of-back": "exchanged-weights",
    "rotated": "exchanged-weights",
    "flat-last": "wrong-provoking-vertex",
    "corner": "wrong-place",
    "half": "few-bits",
    "depth-in-perspective": "affine-weights",
    "depth-mapped": "depth-range",
    "depth-reversed": "depth-range",
    "depth-cut": "depth-rounding",
    "next-channel": "wrong-quantity",
    "w": "wrong-quantity",
    "clamped": "clamped-values",
}


def check(fault, seed="1", weights="perspective", library=LIBRARY):
    """The status, and the names of the causes that are told of each violated property."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "found.json")
        done = subprocess.run(
            [PROGRAM, "check", "--plugin", library, "--cases", CASES, "--jobs", "1", "--seed", seed,
             "--json", path],
            env={**os.environ, "RASTERPROOF_FAULT": fault, "RASTERPROOF_WEIGHTS": weights},
            capture_output=True, text=True, check=False)  # fmt: skip
        if done.returncode not in (0, 1):
            raise AssertionError(done.stdout + done.stderr)
        with open(path, encoding="utf-8") as file:
            found = json.load(file)["subjects"][0]
    return done.returncode, {failure["cause"] for failure in found["failures"]}, done.stdout


class WrongValues(unittest.TestCase):
    def test_the_sound_one_holds(self):
        for weights in ("perspective", "screen"):
            for seed in SEEDS:
                status, _, said = check("", seed, weights)
                self.assertEqual(status, 0, said)

    def test_the_example_holds_in_float32(self):
        for seed in SEEDS:
            status, _, said = check("", seed, library=EXAMPLE)
            self.assertEqual(status, 0, said)
            self.assertIn("12 hold", said)

    def test_each_fault_is_found_and_named(self):
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            for fault, found in zip(FAULTS, pool.map(check, FAULTS), strict=True):
                status, causes, said = found
                with self.subTest(fault):
                    self.assertEqual(status, 1, said)
                    self.assertEqual(causes, {FAULTS[fault]}, said)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
