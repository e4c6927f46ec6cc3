"""Culling filters as plugins: three sound ones hold, and what wrong ones drop is found.

usage: filter_test.py PROGRAM SOURCES C_COMPILER
"""
import os
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.path.abspath(sys.argv[1])
SOURCES = os.path.abspath(sys.argv[2])
COMPILER = sys.argv[3]
EXAMPLE = os.path.join(SOURCES, "kit/examples/filter.c")
# The widest and the laziest of sound filters.
KEEPS_ALL = """#include "kit/filter_plugin.h"
static int keep(const double v[6], int width, int height) {
  return v != 0 && width > 0 && height > 0;
}
RASTERPROOF_FILTER("keeps all", keep)
"""


class FilterTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def judged(self, source, bug, cases):
        """(exit status, output) of a check of the filter."""
        library = os.path.join(self.folder, f"filter{bug}.so")
        made = subprocess.run([COMPILER, "-std=c11", "-O2", "-Wall", "-Wextra", "-Werror",
                               "-shared", "-fPIC", "-I", SOURCES, f"-DBUG={bug}", source,
                               "-o", library, "-lm"],
                              capture_output=True, text=True, timeout=900, check=False)  # fmt: skip
        self.assertEqual(made.returncode, 0, made.stderr)
        done = subprocess.run([PROGRAM, "check", "--plugin", library, "--no-cause", "--cases",
                               str(cases), "--property", "CoverageEqualsTheModel"],
                              capture_output=True, text=True, timeout=900,
                              check=False)  # fmt: skip
        return done.returncode, done.stdout + done.stderr

    def test_sound_filters_hold(self):
        source = os.path.join(self.folder, "keeps_all.c")
        with open(source, "w", encoding="utf-8") as file:
            file.write(KEEPS_ALL)
        for filters, cases in ((EXAMPLE, 2000), (source, 200)):
            status, said = self.judged(filters, 0, cases)
            self.assertEqual(status, 0, said)

    def test_what_a_wrong_filter_drops_is_missing(self):
        for bug in (1, 2, 3):
            status, said = self.judged(EXAMPLE, bug, 2000)
            self.assertEqual(status, 1, f"{bug}: {said}")
            self.assertRegex(said, "observed front 0, back 0, expected front [01], back [01];")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
