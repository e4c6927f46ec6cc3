"""check --fp-env: what depends on the caller's floating-point mode, and in which way it is reached.

usage: float_modes_test.py PROGRAM SOURCES PLUGINS
"""
import json
import os
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCES, PLUGINS = (os.path.abspath(path) for path in sys.argv[1:4])


def check(*arguments, modes="ftz,daz,up,down,zero,trap", cases=200):
    return subprocess.run([PROGRAM, "check", "--fp-env", modes, "--cases", str(cases), *arguments],
                          capture_output=True, text=True, cwd=SOURCES, timeout=900,
                          check=False)  # fmt: skip


def plugin(name):
    return ("--plugin", os.path.join(PLUGINS, f"shown_MODES_{name}.so"))


class FloatModes(unittest.TestCase):
    def rows(self, done):
        """{(mode, way): sentence}"""
        rows = [line.split(None, 2) for line in done.stdout.splitlines() if line.startswith("  ")]
        self.assertTrue(rows, done.stdout + done.stderr)
        return {(mode, way): sentence for mode, way, sentence in rows}

    def test_exact_subjects_depend_on_no_mode(self):
        for name in ("spans-exact", "filtered-exact", "hom-exact", "i64-snap8", "planned"):
            done = check("--subject", name)
            self.assertEqual(done.returncode, 0, done.stdout)
            for sentence in self.rows(done).values():
                self.assertRegex(sentence, r"^unchanged, \d+ of \d+ could be touched")

    def test_float32_depends_on_most(self):
        done = check("--subject", "f32-direct")
        self.assertEqual(done.returncode, 0, "it states nothing")
        rows = self.rows(done)
        for mode in ("daz", "up", "down", "zero"):
            self.assertRegex(rows[mode, "call"], r"^changed \d+ of \d+, ")
        self.assertIn("ends a program that traps it", rows["trap", "call"])
        self.assertEqual(check("--subject", "f32-direct", "--fail-on", "quality").returncode, 1)

    def test_a_bug_of_each_kind_is_found_in_its_mode_alone(self):
        for name, modes in (("needs-subnormals", {"ftz", "daz"}), ("traps", {"trap"}),
                            ("magic-snap", {"up", "down", "zero"})):  # fmt: skip
            rows = self.rows(check("--subject", f"mutant:mode-{name}", cases=400))
            found = {mode for (mode, _), said in rows.items() if not said.startswith("unchanged")}
            self.assertTrue(found, name)
            self.assertLessEqual(found, modes, name)
            if name == "magic-snap":
                for mode in modes:
                    self.assertRegex(rows[mode, "call"],
                                     r"changed (\d+) of.*; \1 by the snap alone")

    def test_the_way_that_reaches_a_plugin_is_told(self):
        caller = self.rows(check(*plugin("CALLER"), modes="up"))
        self.assertTrue(caller["up", "call"].startswith("changed"), caller)
        self.assertTrue(caller["up", "load"].startswith("changed"), caller)
        self.assertTrue(caller["up", "workers"].startswith("unchanged"), caller)
        pooled = self.rows(check(*plugin("POOLED"), modes="up"))
        self.assertTrue(pooled["up", "workers"].startswith("changed"), pooled)
        self.assertTrue(pooled["up", "load"].startswith("changed"), "a thread inherits its mode")
        own = self.rows(check(*plugin("OWN"), modes="up,ftz,trap"))
        for sentence in own.values():
            self.assertTrue(sentence.startswith("unchanged"), own)

    def test_a_library_that_leaves_another_mode_is_told(self):
        rows = self.rows(check(*plugin("LEFT"), modes="up,down"))
        self.assertIn("did not restore it", rows["down", "call"])
        self.assertTrue(rows["up", "call"].startswith("unchanged"), "it leaves that very mode")

    def test_the_first_case_is_saved(self):
        with tempfile.TemporaryDirectory() as folder:
            check("--subject", "f32-direct", "--save", folder, modes="up")
            with open(os.path.join(folder, "f32-direct-up.json"), encoding="utf-8") as file:
                case = json.load(file)
            self.assertEqual(case["property"], "EnvironmentKeepsCoverage")
            again = subprocess.run([PROGRAM, "replay", os.path.join(folder, "f32-direct-up.json")],
                                   capture_output=True, text=True, timeout=900,
                                   check=False)  # fmt: skip
            self.assertEqual(again.returncode, 1, again.stdout + again.stderr)

    def test_a_case_that_a_replay_could_not_show_is_not_saved(self):
        with tempfile.TemporaryDirectory() as folder:
            rows = self.rows(check(*plugin("POOLED"), "--save", folder, modes="up"))
            self.assertTrue(rows["up", "call"].startswith("unchanged"), rows)
            self.assertEqual(os.listdir(folder), [])

    def test_what_can_not_be_asked_says_what_to_do(self):
        unknown = check("--subject", "f32-direct", modes="ftz,fast")
        self.assertEqual(unknown.returncode, 2)
        self.assertIn("'fast' is no floating-point mode; give some of ftz", unknown.stderr)
        program = check("--exec", "cat", modes="ftz")
        self.assertEqual(program.returncode, 2)
        self.assertIn("give it as a plugin", program.stderr)
        for other in (["--catalogue"], ["--seconds", "3"], ["--cases-json", "none.jsonl"]):
            both = check(*other, modes="ftz")
            self.assertEqual(both.returncode, 2, other)
            self.assertIn("--fp-env", both.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
