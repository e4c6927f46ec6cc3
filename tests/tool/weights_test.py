"""Barycentrics of a library that states their error, under the legal sets of the APIs.

usage: weights_test.py PROGRAM SOURCES PLUGINS
"""
import os
import subprocess
import sys
import unittest

PROGRAM, SOURCES, PLUGINS = (os.path.abspath(path) for path in sys.argv[1:4])
CLAUSES = {"gl": "gl.barycentric", "vulkan": "vulkan.barycentric", "d3d11": "d3d11.interpolator",
           "webgpu": "webgpu.barycentric"}  # fmt: skip
PROPERTY = "FragmentBarycentricsStayWithinTheirError"


def check(name, profile):
    done = subprocess.run(
        [PROGRAM, "check", "--plugin", os.path.join(PLUGINS, f"shown_{name}.so"), "--profile",
         profile, "--property", PROPERTY, "--cases", "40", "--no-cause"],
        capture_output=True, cwd=SOURCES, timeout=300, check=False)  # fmt: skip
    return done.returncode, done.stdout.decode() + done.stderr.decode()


class Weights(unittest.TestCase):
    def test_equal_and_exchanged_ones_break_a_clause(self):
        for profile, clause in CLAUSES.items():
            for name in ("EQUAL_WEIGHTS", "BARYCENTRICS_PERMUTED"):
                with self.subTest(profile=profile, name=name):
                    status, text = check(name, profile)
                    self.assertEqual(status, 1, text)
                    self.assertIn(f"required by {clause}", text)

    def test_those_of_snapped_vertices_hold(self):
        for profile in CLAUSES:
            with self.subTest(profile=profile):
                status, text = check("FRAGMENTS", profile)
                self.assertEqual(status, 0, text)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
