"""compare --mode: what depends on the caller's floating-point mode, and in which way it is reached.

usage: float_modes_test.py PROGRAM SOURCES PLUGINS
"""
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCES, PLUGINS = (os.path.abspath(path) for path in sys.argv[1:4])


def compare(*arguments, modes="ftz,daz,up,down,zero,trap", cases=200):
    return subprocess.run([PROGRAM, "compare", "--mode", modes, "--cases", str(cases), *arguments],
                          capture_output=True, text=True, cwd=SOURCES, timeout=900,
                          check=False)  # fmt: skip


def plugin(name):
    return ("--plugin", os.path.join(PLUGINS, f"shown_MODES_{name}.so"))


class FloatModes(unittest.TestCase):
    def cells(self, *arguments, **how):
        """{(mode, way): cell}, of those in which a case was compared"""
        done = compare(*arguments, "--json", "-", **how)
        (subject,) = json.loads(done.stdout)["subjects"]
        return {(row["mode"], way): row[way] for row in subject["cells"]
                for way in ("call", "load", "workers") if row[way]["cases"]}  # fmt: skip

    def fails(self, cell):
        return cell["state"] == "fails"

    def test_exact_subjects_depend_on_no_mode(self):
        for name in ("spans-exact", "filtered-exact", "hom-exact", "i64-snap8", "planned"):
            done = compare("--subject", name)
            self.assertEqual(done.returncode, 0, done.stdout)
            self.assertRegex(done.stdout, r"\n  up +(proved, )?\d+ tested")
            self.assertRegex(done.stdout, r"call: \d modes stand, 0 fail")

    def test_float32_depends_on_most(self):
        done = compare("--subject", "f32-direct")
        self.assertEqual(done.returncode, 0, "it states nothing")
        for mode in ("daz", "up", "down", "zero"):
            self.assertRegex(done.stdout, rf"\n  {mode} +fails \d+ of \d+, ")
        self.assertRegex(done.stdout, r"\n  trap .*broke down.*\n +.*ends a program that traps it")
        self.assertEqual(compare("--subject", "f32-direct", "--fail-on", "quality").returncode, 1)

    def test_a_bug_of_each_kind_is_found_in_its_mode_alone(self):
        for name, modes in (("needs-subnormals", {"ftz", "daz"}), ("traps", {"trap"}),
                            ("magic-snap", {"up", "down", "zero"})):  # fmt: skip
            cells = self.cells("--subject", f"mutant:mode-{name}", cases=400)
            found = {mode for (mode, _), cell in cells.items() if self.fails(cell)}
            self.assertTrue(found, name)
            self.assertLessEqual(found, modes, name)
        done = compare("--subject", "mutant:mode-magic-snap", modes="up,down,zero", cases=400)
        alone = r"fails (\d+) of \d+, .* px, \1 by the snap alone"
        self.assertEqual(len(re.findall(alone, done.stdout)), 3, done.stdout)

    def test_the_way_that_reaches_a_plugin_is_told(self):
        caller = self.cells(*plugin("CALLER"), modes="up")
        self.assertTrue(self.fails(caller["up", "call"]), caller)
        self.assertTrue(self.fails(caller["up", "load"]), caller)
        self.assertFalse(self.fails(caller["up", "workers"]), caller)
        pooled = self.cells(*plugin("POOLED"), modes="up")
        self.assertTrue(self.fails(pooled["up", "workers"]), pooled)
        self.assertTrue(self.fails(pooled["up", "load"]), "a thread inherits its mode")
        own = self.cells(*plugin("OWN"), modes="up,ftz,trap")
        self.assertFalse([place for place, cell in own.items() if self.fails(cell)])

    def test_a_library_that_leaves_another_mode_is_told(self):
        cells = self.cells(*plugin("LEFT"), modes="up,down")
        self.assertIn("did not restore it", cells["down", "call"]["why"])
        self.assertFalse(self.fails(cells["up", "call"]), "it leaves that very mode")

    def test_the_worst_case_is_saved(self):
        with tempfile.TemporaryDirectory() as folder:
            compare("--subject", "f32-direct", "--save", folder, modes="up")
            with open(os.path.join(folder, "f32-direct-up.json"), encoding="utf-8") as file:
                case = json.load(file)
            self.assertEqual(case["property"], "EnvironmentKeepsCoverage")
            again = subprocess.run([PROGRAM, "replay", os.path.join(folder, "f32-direct-up.json")],
                                   capture_output=True, text=True, timeout=900,
                                   check=False)  # fmt: skip
            self.assertEqual(again.returncode, 1, again.stdout + again.stderr)

    def test_a_case_that_a_replay_could_not_show_is_not_saved(self):
        with tempfile.TemporaryDirectory() as folder:
            cells = self.cells(*plugin("POOLED"), "--save", folder, modes="up")
            self.assertFalse(self.fails(cells["up", "call"]), cells)
            self.assertEqual(os.listdir(folder), [])

    def test_what_can_not_be_asked_says_what_to_do(self):
        unknown = compare("--subject", "f32-direct", modes="ftz,fast")
        self.assertEqual(unknown.returncode, 2)
        self.assertIn("'fast' is not a floating-point mode; give a comma-separated list of ftz",
                      unknown.stderr)  # fmt: skip
        program = compare("--exec", "cat", modes="ftz")
        self.assertEqual(program.returncode, 2)
        self.assertIn("give it as a plugin", program.stderr)
        for other in (["--families", "needles"], ["--by", "own"], ["scenes/ties.json"]):
            both = compare(*other, modes="ftz")
            self.assertEqual(both.returncode, 2, other)
            self.assertIn("--mode", both.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
