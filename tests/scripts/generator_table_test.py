"""Tests of what scripts/generator_table makes of runs: medians, the cap, bounds on rates."""

import importlib.machinery
import importlib.util
import pathlib
import sys
import unittest

SCRIPTS = pathlib.Path(__file__).resolve().parents[2] / "scripts"
sys.path.insert(0, str(SCRIPTS))
LOADER = importlib.machinery.SourceFileLoader("generator_table", str(SCRIPTS / "generator_table"))
TABLE = importlib.util.module_from_spec(importlib.util.spec_from_loader("generator_table", LOADER))
LOADER.exec_module(TABLE)


def runs(*seconds, violating=1, cases=1000):
    return {seed: {"seconds_to_first": "" if s is None else str(s),
                   "violating": "0" if s is None else str(violating), "cases": str(cases)}
            for seed, s in enumerate(seconds, 1)}  # fmt: skip


class GeneratorTableTest(unittest.TestCase):
    def time(self, *seconds):
        return TABLE.time_cell(runs(*seconds), 8, 30)

    def test_the_median_of_eight(self):
        self.assertEqual(self.time(1, 2, 3, 4, 6, 7, 8, 9), "5.00")
        self.assertEqual(self.time(9, 8, 7, 6, 4, 3, 2, 1), "5.00")

    def test_runs_past_the_cap_count_as_longer(self):
        self.assertEqual(self.time(1, 2, 3, 4, 6, None, None, None), "5.00 (5 of 8)")
        self.assertEqual(self.time(1, 2, 3, 4, None, None, None, None), "> 30 (4 of 8)")
        self.assertEqual(self.time(1, 2, None, None, None, None, None), "> 30 (2 of 7)")

    def test_a_row_that_was_stopped_is_past_the_cap(self):
        self.assertEqual(self.time(None, None), "> 30 (0 of 2)")

    def test_a_row_ends_when_its_median_is_known_or_nothing_was_found_at_first(self):
        def ends(*seconds):
            return TABLE.is_decided(runs(*seconds), 2)

        self.assertTrue(ends(None, None))
        self.assertFalse(ends(None))
        self.assertFalse(ends(None, 1, None, None))
        self.assertTrue(ends(None, 1, None, None, None, None))

    def test_a_run_that_is_not_there(self):
        self.assertEqual(TABLE.time_cell({}, 8, 30), "")
        self.assertEqual(TABLE.rate_cell({}), "")

    def test_rates(self):
        self.assertEqual(TABLE.rate_cell(runs(1, 2, violating=5, cases=1000)), "5,000")
        self.assertEqual(TABLE.rate_cell(runs(None, None, cases=500_000)), "< 3.00")

    def test_figures_are_rounded(self):
        figures = (0, 0.00051, 0.0123, 1.234, 45.67, 234.5, 123456)
        self.assertEqual([TABLE.short(x) for x in figures],
                         ["0", "0.001", "0.01", "1.23", "45.7", "234", "123,000"])  # fmt: skip


if __name__ == "__main__":
    unittest.main()
