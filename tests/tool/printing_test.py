"""What check prints by default and with --verbose, and where --fail-fast ends it.

usage: printing_test.py PROGRAM SOURCES"""
import os
import re
import subprocess
import sys
import unittest

PROGRAM, SOURCES = (os.path.abspath(path) for path in sys.argv[1:3])
MODEL = "CoverageEqualsTheModel"


def check(*arguments, cases=12):
    return subprocess.run([PROGRAM, "check", "--cases", str(cases), "--no-cause", *arguments],
                          capture_output=True, cwd=SOURCES, timeout=300, check=False,
                          encoding="utf-8")  # fmt: skip


def outcomes(text):
    """The first words of the lines of results, in their order."""
    found = re.findall(r"^(violated|quality|holds|not applicable|not exercised) ", text, re.M)
    return [word for k, word in enumerate(found) if k == 0 or found[k - 1] != word]


class Screen(unittest.TestCase):
    def test_the_worst_comes_first_and_the_rest_is_counted(self):
        text = check("--subject", "textbook").stdout
        self.assertEqual(outcomes(text), ["violated", "quality"])
        self.assertLess(len(text.splitlines()), 70, text)
        self.assertEqual(text.count("\nscene: "), 1, text)  # one failure in full
        hold = re.search(r"^textbook: (\d+) hold, (\d+) violated, (\d+) not exercised, (\d+) not",
                         text, re.M)  # fmt: skip
        self.assertEqual(text.count("\nreplay: "), int(hold[2]) + 1, text)
        rest = re.search(r"^--verbose shows \d+ more failures in full, (\d+) properties that hold or "
                         r"are not exercised, why (\d+) properties are not applicable$",
                         text, re.M)  # fmt: skip
        self.assertEqual(int(rest[1]), int(hold[1]) + int(hold[3]), text)
        self.assertEqual(rest[2], hold[4], text)

    def test_verbose_has_every_property_and_every_failure_in_full(self):
        text = check("--subject", "textbook", "--verbose").stdout
        self.assertEqual(outcomes(text), ["violated", "quality", "holds", "not applicable"])
        self.assertEqual(text.count("\nscene: "), text.count("\nreplay: "), text)
        self.assertNotIn("--verbose", text)

    def test_few_properties_are_all_printed(self):
        text = check("--subject", "f32-direct", "--property", "EdgeIsZeroAtItsEnds",
                     "FragmentDepthStaysInTheHull").stdout  # fmt: skip
        self.assertEqual(outcomes(text), ["holds", "not applicable"])
        self.assertIn("shows no fragments", text)

    def test_fail_fast_ends_with_the_first_violation(self):
        done = check("--subject", "textbook", "--fail-fast", "--jobs", "1")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertRegex(done.stdout, r" 1 violated, .* \d+ not asked after the first failure; ")
        done = check("--subject", "spans-exact", "--fail-fast")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertNotIn("not asked", done.stdout)

    def test_fail_fast_of_scenes_counts_the_scenes_that_were_left_out(self):
        scenes = [f"scenes/{name}.json" for name in ("ties", "fan")]
        done = check(*scenes, "--subject", "textbook", "--property", MODEL, "--fail-fast")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn(", 1 not asked after the first failure; ", done.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
