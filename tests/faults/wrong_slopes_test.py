"""Faults of derivatives in a rasterizer that shares no code with the product: found, and named.

usage: wrong_slopes_test.py PROGRAM LIBRARY      LIBRARY is wrong_slopes.c
"""
import concurrent.futures
import json
import os
import subprocess
import sys
import tempfile
import unittest

PROGRAM, LIBRARY = (os.path.abspath(path) for path in sys.argv[1:3])

ASKED = ("DerivativesStayWithinTheirError", "QuadDifferencesEqualDifferencesOfValues")

# How derivatives are stated, whether the place of quads is, and what is told of the fault.
FAULTS = {
    "dy-negated": ("analytic", False, "negates derivatives by y"),
    "pixel-before": ("analytic", False, "takes derivatives of the pixel that lies (-1, 0) away"),
    "triangle-before": ("analytic", False,
                        "takes derivatives of the triangle before in the list"),
    "quad-right": ("fine", False, "takes derivatives of the quad that lies (2, 0) away"),
    "quad-below": ("coarse", True, "takes derivatives of the quad that lies (0, 2) away"),
    "quad-across": ("fine", False, "takes derivatives of the quad that lies (2, 2) away"),
    "left-minus-right": ("fine", False, "negates derivatives by x"),
    "odd-quads": ("fine", True, "begins quads at odd pixels, where even ones are stated, or the "
                                "other way round"),
    "from-target": ("fine", False, "takes differences from pixels that show other triangles"),
}  # fmt: skip
# Legal: no quads' place is stated.
SOUND = [("", by, quads) for by in ("analytic", "fine", "coarse") for quads in (False, True)]
SOUND += [("odd-quads", "fine", False), ("odd-quads", "coarse", False)]


def check(fault, by, has_quads):
    """The status, and the causes that are told."""
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "found.json")
        quads = {"RASTERPROOF_QUADS": "even"} if has_quads else {}
        done = subprocess.run(
            [PROGRAM, "check", "--plugin", LIBRARY, "--cases", "100", "--jobs", "1",
             "--json", path, *(word for name in ASKED for word in ("--property", name))],
            env={**os.environ, "RASTERPROOF_FAULT": fault, "RASTERPROOF_DERIVATIVES": by, **quads},
            capture_output=True, text=True, check=False)  # fmt: skip
        if done.returncode not in (0, 1):
            raise AssertionError(done.stdout + done.stderr)
        with open(path, encoding="utf-8") as file:
            failures = json.load(file)["subjects"][0]["failures"]
    return done.returncode, {failure["cause"] for failure in failures}, done.stdout


class WrongSlopes(unittest.TestCase):
    def test_sound_ones_hold(self):
        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            for how, found in zip(SOUND, pool.map(lambda how: check(*how), SOUND), strict=True):
                self.assertEqual(found[0], 0, (how, found[2]))

    def test_each_fault_is_found_and_named(self):
        def of(item):
            fault, (by, has_quads, _) = item
            return check(fault, by, has_quads)

        with concurrent.futures.ThreadPoolExecutor(2) as pool:
            for item, found in zip(FAULTS.items(), pool.map(of, FAULTS.items()), strict=True):
                fault, (_, _, told) = item
                status, causes, said = found
                with self.subTest(fault):
                    self.assertEqual(status, 1, said)
                    self.assertEqual(causes, {"wrong-derivative"}, said)
                    self.assertIn("rasterizer that " + told + " (", said)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
