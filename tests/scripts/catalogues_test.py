"""Tests of scripts/compare_catalogues: two seeds that agree, and files that can't both be true."""

import copy
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(__file__).resolve().parents[2] / "scripts/compare_catalogues"


def cell(state, wrong=0, cases=100):
    return {"state": state, "cases": cases, "wrong": wrong}


def catalogue(seed):
    """Each state once, by both yardsticks."""
    rows = {"needles": cell("fails", 40), "grids": cell("tested"), "fans": cell("proved"),
            "mixed-w": cell("excused", cases=0), "tiny": cell("exhausted", cases=81),
            "pairs": cell("fails", 7, 81)}  # fmt: skip
    return {
        "rasterproof_comparison": 1, "seed": seed, "cases": 100,
        "families": [{"name": name, "theme": "small worlds" if name in ("tiny", "pairs") else "it"}
                     for name in rows],
        "subjects": [{"subject": "it", "cells": [
            {"family": name, "own_model": dict(row), "real_geometry": dict(row)}
            for name, row in rows.items()]}],
    }  # fmt: skip


class CataloguesTest(unittest.TestCase):
    def run_script(self, *texts):
        with tempfile.TemporaryDirectory() as folder:
            paths = [pathlib.Path(folder) / f"{k}.json" for k in range(len(texts))]
            for path, text in zip(paths, texts):
                path.write_text(text if isinstance(text, str) else json.dumps(text),
                                encoding="utf-8")  # fmt: skip
            return subprocess.run([sys.executable, "-B", SCRIPT, *paths], capture_output=True,
                                  text=True, check=False)  # fmt: skip

    def compare(self, **changed):
        """The comparison of two equal files, but for the own model's cells that are named."""
        a, b = catalogue(1), catalogue(2)
        for row in b["subjects"][0]["cells"]:
            row["own_model"] = changed.get(row["family"].replace("-", "_"), row["own_model"])
        done, turned = self.run_script(a, b), self.run_script(b, a)
        self.assertEqual(turned.returncode, done.returncode, "either file may be the first")
        return done

    def expect_difference(self, sentence, **changed):
        done = self.compare(**changed)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn(f"different: {sentence}", done.stdout)
        self.assertIn("12 cells compared: 1 different, 0 notes.\n", done.stdout)

    def test_equal_cells_agree(self):
        done = self.compare()
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stdout, "12 cells compared: 0 different, 0 notes.\n")

    def test_what_is_proved_under_one_seed_is_so_under_the_other(self):
        self.expect_difference(
            "fans of it, own model, is proved, 0 of 100 wrong under seed 1 and fails, 1 of 100 "
            "wrong under seed 2: the state must not depend on the seed.\n",
            fans=cell("fails", 1))  # fmt: skip
        self.expect_difference("fans of it, own model, is proved", fans=cell("tested"))
        self.expect_difference("tiny of it, own model, is exhausted",
                               tiny=cell("tested", cases=81))  # fmt: skip
        self.expect_difference("mixed-w of it, own model, is excused", mixed_w=cell("tested"))

    def test_a_small_world_has_the_same_counts(self):
        self.expect_difference("pairs of it, own model, is fails, 7 of 81 wrong under seed 1 and "
                               "fails, 8 of 81", pairs=cell("fails", 8, 81))  # fmt: skip

    def test_no_case_that_fails_and_some_is_a_note_while_the_intervals_overlap(self):
        done = self.compare(grids=cell("fails", 4))
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("note: grids of it, own model, is tested, 0 of 100 wrong under seed 1 and "
                      "fails, 4 of 100 wrong under seed 2: the intervals of 95 % overlap.\n",
                      done.stdout)  # fmt: skip
        self.expect_difference("grids of it, own model, is tested", grids=cell("fails", 25))

    def test_shares_whose_intervals_of_99_9_percent_overlap_are_a_note(self):
        # 40 of 100: [30.9, 49.8] at 95 %, [25.8, 56.2] at 99.9 %.
        done = self.compare(needles=cell("fails", 62))
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("note: needles", done.stdout)
        self.expect_difference("needles of it, own model, is fails", needles=cell("fails", 73))
        self.assertIn(" 0 different, 0 notes.", self.compare(needles=cell("fails", 50)).stdout)

    def test_a_cell_that_one_file_lacks_is_a_difference(self):
        less = copy.deepcopy(catalogue(2))
        less["subjects"][0]["cells"].pop(0)
        done = self.run_script(catalogue(1), less)
        self.assertEqual(done.returncode, 1)
        self.assertIn("different: needles of it, own model, is only in the file of seed 1.\n",
                      done.stdout)  # fmt: skip

    def test_a_file_that_lies_or_is_no_catalogue_is_refused(self):
        lying, unknown = catalogue(2), catalogue(2)
        lying["subjects"][0]["cells"][1]["own_model"]["wrong"] = 3
        unknown["rasterproof_comparison"] = 2
        for text, message in (
            (lying, "grids of it, own model, can't be tested with 3 of 100 cases wrong."),
            (unknown, "is a catalogue of another version than 1."),
            (catalogue(1), "Both files are of seed 1: give one of another seed."),
            ("{", "is no catalogue.json of `certify --catalogue`"),
            ("[]", "is no catalogue.json of `certify --catalogue`"),
        ):
            done = self.run_script(catalogue(1), text)
            self.assertEqual(done.returncode, 2, done.stdout)
            self.assertIn(message, done.stderr)


if __name__ == "__main__":
    unittest.main()
