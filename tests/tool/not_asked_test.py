"""What a run did not ask, in one line: outputs by space, and sizes of targets.

usage: not_asked_test.py PROGRAM SOURCES PLUGINS
"""
import glob
import json
import os
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCES, PLUGINS = (os.path.abspath(path) for path in sys.argv[1:4])


def run(*arguments):
    done = subprocess.run([PROGRAM, *arguments], capture_output=True, cwd=SOURCES, timeout=300,
                          check=False)  # fmt: skip
    return done.stdout.decode() + done.stderr.decode()


def plugin(name):
    return "--plugin", os.path.join(PLUGINS, f"shown_{name}.so")


def not_asked(text):
    lines = [line for line in text.splitlines() if line.startswith("not asked ")]
    return lines[0] if len(lines) == 1 else lines


class Check(unittest.TestCase):
    def test_what_no_property_judges_is_named_in_one_line_and_as_data(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "found.json")
            text = run("check", *plugin("BOTH_SPACES"), "--cases", "30", "--no-cause", "--json",
                       path)  # fmt: skip
            with open(path, encoding="utf-8") as file:
                unasked = json.load(file)["subjects"][0]["unasked"]
        line = not_asked(text)
        self.assertIn("centroids in clip space (no property judges them)", line, text)
        self.assertRegex(line, r"targets above [0-9]+ samples")
        self.assertEqual(unasked[0], {"statement": "centroids in clip space",
                                      "by": "no property judges them"})  # fmt: skip
        self.assertTrue(unasked[-1]["statement"].startswith("targets above"), unasked)

    def test_a_space_that_is_not_taken_is_none_of_its_business(self):
        line = not_asked(run("check", *plugin("FRAGMENTS"), "--cases", "6"))
        self.assertRegex(line, r"^not asked +\S+ +targets above [0-9]+ samples$")

    def test_a_run_of_chosen_properties_says_nothing_of_the_others(self):
        text = run("check", *plugin("BOTH_SPACES"), "--cases", "6", "--property",
                   "ReversalSwapsFacing", "--property", "TriangleOrderKeepsCoverage")  # fmt: skip
        self.assertEqual(not_asked(text), [])


class Certify(unittest.TestCase):
    def test_certificate_page_and_summary_have_it(self):
        with tempfile.TemporaryDirectory() as folder:
            text = run("certify", *plugin("BOTH_SPACES"), "--cases", "12", "--out", folder)
            self.assertRegex(text, r"\n  not asked: .*centroids in clip space \(no ")
            (path,) = glob.glob(os.path.join(folder, "*", "certificate.json"))
            with open(path, encoding="utf-8") as file:
                not_asked_of = json.load(file)["not_asked"]
            self.assertIn("centroids in clip space",
                          [one["statement"] for one in not_asked_of])  # fmt: skip
            with open(os.path.join(os.path.dirname(path), "report.html"), encoding="utf-8") as file:
                self.assertIn("centroids in clip space", file.read())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
