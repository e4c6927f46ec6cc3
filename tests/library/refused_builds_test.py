"""The library refuses, in a sentence, to be compiled so that it would not be exact.

usage: refused_builds_test.py CXX SOURCES
"""
import os
import subprocess
import sys
import unittest

CXX, SOURCES = sys.argv[1], os.path.realpath(sys.argv[2])
FILES = ("library/rasterize.cc", "library/exact_sign.cc", "library/exact_sum.cc",
         "library/row_crossing.cc", "library/kernels/kernels_scalar.cc")  # fmt: skip
UNDO = ("-fno-fast-math", "-fno-unsafe-math-optimizations", "-fno-associative-math",
        "-fno-reciprocal-math", "-fno-finite-math-only", "-fsigned-zeros")  # fmt: skip


def compiled(file, *flags):
    return subprocess.run([CXX, "-std=c++20", "-I", SOURCES, *flags, "-fsyntax-only",
                           "-Wfatal-errors", os.path.join(SOURCES, file)], capture_output=True,
                          text=True, timeout=900, check=False)  # fmt: skip


def is_gcc():
    said = subprocess.run([CXX, "--version"], capture_output=True, text=True, check=True).stdout
    return "clang" not in said


class Builds(unittest.TestCase):
    def refused(self, words, *flags):
        for file in FILES:
            done = compiled(file, *flags)
            self.assertNotEqual(done.returncode, 0, (file, flags))
            self.assertIn(words, done.stderr, (file, flags))

    def test_with_fast_math_are_refused(self):
        self.refused("rasterproof: -ffast-math, or a part of it", "-ffast-math")
        self.refused("rasterproof: -ffast-math, or a part of it", "-ffinite-math-only")

    @unittest.skipUnless(is_gcc(), "only g++ tells these in a macro")
    def test_with_a_part_of_fast_math_are_refused(self):
        regrouped = ("-fassociative-math", "-fno-signed-zeros", "-fno-trapping-math")
        for part in (regrouped, ("-freciprocal-math",), ("-funsafe-math-optimizations",)):
            self.refused("rasterproof: -ffast-math, or a part of it", *part)

    @unittest.skipUnless(is_gcc() and os.uname().machine == "x86_64", "wants g++ for the 387")
    def test_in_the_format_of_the_387_are_refused(self):
        self.refused("use -mfpmath=sse -msse2", "-mfpmath=387")

    def test_whose_flags_are_undone_are_taken(self):
        for file in FILES:
            for flags in (("-O3",), ("-Ofast", *UNDO), ("-funsafe-math-optimizations", *UNDO)):
                done = compiled(file, *flags)
                self.assertEqual(done.returncode, 0, (file, flags, done.stderr))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
