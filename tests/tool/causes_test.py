"""The lines that say what explains violations: of one fault, of several, and where nobody asks.

usage: causes_test.py PROGRAM SOURCES"""
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCES = (os.path.abspath(path) for path in sys.argv[1:3])
MODEL = "CoverageEqualsTheModel"


def check(subject, *arguments, cases=60):
    return subprocess.run([PROGRAM, "check", "--subject", subject, "--cases", str(cases),
                           *arguments], capture_output=True, cwd=SOURCES, timeout=900,
                          check=False, encoding="utf-8")  # fmt: skip


def causes(text):
    return [line for line in text.splitlines() if line.startswith("cause: ")]


class Causes(unittest.TestCase):
    def test_truncation_is_named_with_the_draws_that_it_gives(self):
        done = check("mutant:snap-truncates", "--property", MODEL)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        found = causes(done.stdout)
        self.assertEqual(len(found), 1, done.stdout)
        draws = re.search(r"truncates coordinates toward zero \((\d+) of (\d+) draws\)", found[0])
        self.assertIsNotNone(draws, found[0])
        self.assertEqual(draws[1], draws[2])
        self.assertTrue(found[0].endswith("; docs/causes.md#truncation"), found[0])
        self.assertIn("1 violated property, 1 cause\n", done.stdout)

    def test_several_properties_of_one_cause_are_told_once(self):
        done = check("mutant:ties-inclusive", "--property", MODEL, "--property",
                     "SharedEdgeSamplesAreCoveredOnce")  # fmt: skip
        self.assertEqual(len(causes(done.stdout)), 1, done.stdout)
        self.assertIn(f"  explains {MODEL}, SharedEdgeSamplesAreCoveredOnce\n", done.stdout)
        self.assertIn("2 violated properties, 1 cause\n", done.stdout)

    def test_nothing_is_named_where_no_suspect_draws_alike(self):
        done = check("mutant:lost-1-in-1e4", "--property", MODEL, cases=400)
        self.assertIn("cause: no suspect explains it", done.stdout)
        self.assertIn("1 violated property, 0 causes\n", done.stdout)

    def test_a_subject_that_passes_has_no_cause(self):
        done = check("spans-exact", "--property", MODEL)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertNotIn("cause", done.stdout)

    def test_a_lack_of_quality_has_a_cause_only_where_it_fails_the_run(self):
        about = ("mutant:mode-magic-snap", "--property", "EnvironmentKeepsCoverage")
        done = check(*about, cases=200)
        self.assertIn(" 1 short of quality;", done.stdout, done.stderr)
        self.assertNotIn("cause", done.stdout)
        done = check(*about, "--fail-on", "quality", cases=200)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertTrue(causes(done.stdout)[0].endswith("; docs/causes.md#float-mode"), done.stdout)

    def test_nobody_asks_with_no_cause(self):
        done = check("mutant:snap-truncates", "--property", MODEL, "--no-cause")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertNotIn("cause", done.stdout)

    def test_the_time_is_given_in_seconds_and_too_little_is_told(self):
        about = ("mutant:snap-truncates", "--property", MODEL, "--cause-seconds")
        done = check(*about, "0.001")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("the search for causes ran out of time", done.stdout)
        self.assertIn("raise --cause-seconds", done.stdout)
        for bad in ("0", "-1", "nan", "inf", "soon"):
            done = check(*about[:-1], f"--cause-seconds={bad}")
            self.assertEqual(done.returncode, 2, done.stdout)
            self.assertEqual(done.stdout, "")
            self.assertIn(f"--cause-seconds {bad}: it is not a time", done.stderr)
        done = check(*about, "9", "--no-cause")
        self.assertNotIn("cause", done.stdout)

    def test_the_number_of_wrong_scenes_is_told_to_programs(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "found.json")
            done = check("mutant:snap-truncates", "--property", MODEL, "--json", path)
            self.assertNotIn("too few", done.stdout)
            with open(path, encoding="utf-8") as file:
                cause = json.load(file)["subjects"][0]["causes"][0]
        self.assertGreaterEqual(cause["wrong_scenes"], 4)
        self.assertIs(cause["too_few"], False)

    def names(self):
        """What a list of known failures may name, as the error about another name has them."""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "known.json")
            with open(path, "w", encoding="utf-8") as file:
                json.dump({"rasterproof_known_failures": 1,
                           "failures": [{"property": MODEL, "owner": "Ada", "until": "9999-12-31",
                                         "cause": "?"}]}, file)  # fmt: skip
            done = check("spans-exact", "--property", MODEL, "--known", path)
        self.assertEqual(done.returncode, 2, done.stdout)
        self.assertIn("failures[0].cause", done.stderr)
        return re.findall(r"[a-z-]+", done.stderr.split("docs/causes.md has")[1])

    def test_each_cause_has_its_section(self):
        with open(os.path.join(SOURCES, "docs/causes.md"), encoding="utf-8") as document:
            titles = re.findall(r"^## (.*)$", document.read(), re.MULTILINE)
        sections = [title.lower().replace(" ", "-") for title in titles]
        self.assertEqual(sections.pop(), "what-was-measured")
        self.assertEqual(self.names(), sections)
        names = set()
        folder = os.path.join(SOURCES, "props/cause")
        for name in sorted(os.listdir(folder)):
            if not re.fullmatch(r"(suspects_.*|circumstances|cause)\.cc", name):
                continue
            with open(os.path.join(folder, name), encoding="utf-8") as source:
                text = source.read()
            names |= set(re.findall(r'push_back\(\s*\{"([a-z-]+)", ', text))
            names |= set(re.findall(r'(?:cause\.name = |return \{)"([a-z-]+)"', text))
        self.assertGreater(len(names), 20)
        self.assertEqual(names - set(sections), set())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
