"""Tests of verdict_dump and scripts/compare_dumps: a dump says the same twice, and a change shows.

usage: verdict_dump_test.py DUMP ROOT
"""

import pathlib
import subprocess
import sys
import tempfile
import unittest

DUMP, ROOT = sys.argv[1:3]
# A method with edge values and barycentrics, a mutant that holds state, a bug, models with every
# way to answer.
SUBJECTS = ("f32-direct", "mutant:target-every-third-draw",
            "planted-bug:BatchDrawsLikeSingleCalls:1", "model:counts:window:breaks-down",
            "model:fragments:transform:nan-barycentrics", "model:mask:clip:refuses")  # fmt: skip


class VerdictDumpTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.root = pathlib.Path(folder.name)

    def run_command(self, *command):
        return subprocess.run(command, text=True, timeout=250, stdout=subprocess.PIPE,
                              stderr=subprocess.PIPE, check=False)  # fmt: skip

    def dump(self, name, *more, subjects=SUBJECTS):
        """Returns the folder of a dump of one seed, four cases a property."""
        out = self.root / name
        only = [word for subject in subjects for word in ("--only", subject)]
        done = self.run_command(DUMP, "--out", out, "--seeds", "7", "--cases", "4", "--bug-cases",
                                "4", *only, *more)  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stderr)
        return out

    def compare(self, *words):
        return self.run_command(ROOT + "/scripts/compare_dumps", *words)

    def test_the_dump_is_the_same_for_every_number_of_jobs(self):
        one, three = self.dump("one", "--jobs", "1"), self.dump("three", "--jobs", "3")
        self.assertEqual(len(list(one.iterdir())), len(SUBJECTS))
        done = self.compare(one, three)
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_rows_say_what_came_of_a_case(self):
        text = "".join(path.read_text() for path in self.dump("all").iterdir())
        for outcome in ("holds", "violated", "refused", "inconclusive", "not applicable"):
            self.assertIn(f"\t{outcome}\t", text)
        for query in ("edges:", "steps:", "barycentrics:", "interpolations:", "distances:"):
            self.assertIn(query, text)
        self.assertNotIn("FAULT", text)

    def test_a_case_is_another_one_under_another_seed(self):
        property = ("--property", "ReversedEdgeChangesSign")
        one = self.dump("one", *property, subjects=SUBJECTS[:1])
        two = self.dump("two", *property, "--seeds", "8", subjects=SUBJECTS[:1])
        drawn = [row.split("\t")[3] for folder in (one, two)
                 for row in (folder / "f32-direct.txt").read_text().splitlines()[1:]]  # fmt: skip
        self.assertEqual(len(drawn), 8)
        self.assertEqual(len(set(drawn)), 8)

    def test_digests_differ_where_a_row_does(self):
        property = ("--property", "VertexRotation*", "--digests")
        one = self.dump("one", *property, subjects=SUBJECTS[:1])
        two = self.dump("two", *property, subjects=SUBJECTS[:1])
        self.assertEqual(self.compare(one, two).returncode, 0)
        three = self.dump("three", *property, "--seeds", "8", subjects=SUBJECTS[:1])
        done = self.compare(one, three)
        self.assertEqual(done.returncode, 1)
        self.assertIn("  digest 1\n", done.stdout)

    def test_a_verdict_that_changed_is_shown_with_its_case(self):
        property = ("--property", "VertexRotation*")
        one = self.dump("one", *property, subjects=SUBJECTS[:1])
        two = self.dump("two", *property, subjects=SUBJECTS[:1])
        path = two / "f32-direct.txt"
        text = path.read_text()
        self.assertIn("\tholds\t", text)
        path.write_text(text.replace("\tholds\t", "\tviolated\t", 1))
        done = self.compare(one, two)
        self.assertEqual(done.returncode, 1)
        self.assertIn("1 times holds -> violated\n  f32-direct, seed 7, case ", done.stdout)
        self.assertIn("1 rows differ, of 1 properties", done.stdout)
        self.assertEqual(self.compare("--ignore", "outcome", one, two).returncode, 0)

    def test_a_row_or_a_subject_that_is_gone_is_a_difference(self):
        property = ("--property", "VertexRotation*")
        one = self.dump("one", *property, subjects=SUBJECTS[:2])
        two = self.dump("two", *property, subjects=SUBJECTS[:2])
        path = two / "f32-direct.txt"
        path.write_text("\n".join(path.read_text().split("\n")[:-2]) + "\n")
        self.assertIn("row missing 1", self.compare(one, two).stdout)
        path.unlink()
        done = self.compare(one, two)
        self.assertEqual(done.returncode, 1)
        self.assertIn("f32-direct\n", done.stdout)

    def test_folders_without_a_dump_are_no_equal_dumps(self):
        self.assertEqual(self.compare(self.root, self.root).returncode, 2)

    def test_an_option_or_subject_that_does_not_exist_is_refused(self):
        out = ("--out", self.root)
        for words in ((*out, "--only", "no-such"), (*out, "--property", "NoSuch"),
                      (*out, "--case", "3"), (*out, "--seeds", "1,x"), ("--out",), ()):  # fmt: skip
            self.assertEqual(self.run_command(DUMP, *words).returncode, 2, words)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
