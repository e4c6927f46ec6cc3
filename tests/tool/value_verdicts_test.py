"""What the texts of four APIs say of planted bugs of values: tests/tool/value_verdicts.json.

usage: value_verdicts_test.py PROGRAM SOURCES
"""
import importlib.machinery
import importlib.util
import json
import os
import sys
import unittest

PROGRAM, SOURCES = (os.path.abspath(path) for path in sys.argv[1:3])


def load():
    path = os.path.join(SOURCES, "scripts/value_verdicts")
    loader = importlib.machinery.SourceFileLoader("value_verdicts", path)
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    loader.exec_module(module)
    return module


SCRIPT = load()
with open(os.path.join(SOURCES, "tests/tool/value_verdicts.json"), encoding="utf-8") as file:
    KNOWN = json.load(file)

# One of each kind: required whatever the error, with a stated error, by two APIs, by none, axes.
SOME = ("values-flat-last", "values-flushed", "values-coarse-for-fine", "values-affine",
        "values-depth-remapped", "values-upside-down")  # fmt: skip


class Verdicts(unittest.TestCase):
    def test_every_bug_has_one_under_every_api(self):
        self.assertEqual(sorted(KNOWN), SCRIPT.bugs(PROGRAM))
        for bug, of_apis in KNOWN.items():
            self.assertEqual(tuple(of_apis), SCRIPT.APIS, bug)
            for api, (word, *clauses) in of_apis.items():
                self.assertIn(word, ("violated", "quality", "open", "not asked"), bug)
                self.assertEqual(bool(clauses), word == "violated", bug)
                for clause in clauses:
                    self.assertTrue(clause.startswith(api + "."), (bug, clause))

    def test_some_are_as_they_are_kept(self):
        self.assertEqual(SCRIPT.verdicts(PROGRAM, SOME), {bug: KNOWN[bug] for bug in SOME})

    def test_without_a_stated_error_only_exact_numbers_are_required(self):
        for bug in ("values-affine", "values-exchanged", "values-half"):
            for api in SCRIPT.APIS:
                self.assertNotEqual(KNOWN[bug][api][0], "violated", (bug, api))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
