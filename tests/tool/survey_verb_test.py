"""The verb survey: the nearest model, what is found beside it, and its cases replayed.

usage: survey_verb_test.py PROGRAM SOURCES
"""
import json
import os
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCES = (os.path.abspath(path) for path in sys.argv[1:3])
MISBEHAVES = f"{sys.executable} -I -S tests/tool/misbehaves.py"
FEW = ("--cases", "20")


def run(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, cwd=SOURCES, timeout=900,
                          check=False)  # fmt: skip


YARDSTICKS = ["nearest model", "gaps", "overlaps", "batch"]


def cells(survey, yardstick=None):
    keys = [name.replace(" ", "_") for name in ([yardstick] if yardstick else YARDSTICKS)]
    return [row[key] for row in survey["subjects"][0]["cells"] for key in keys]


def total(survey, yardstick, key):
    return sum(cell[key] for cell in cells(survey, yardstick))


class Survey(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def survey(self, *arguments, status=0):
        file = os.path.join(self.folder, "survey.json")
        done = run("survey", *arguments, *FEW, "--json", file, "--save", self.folder)
        self.assertEqual(done.returncode, status, done.stdout.decode() + done.stderr.decode())
        with open(file, encoding="utf-8") as text:
            return json.load(text), done.stdout.decode()

    def test_of_a_right_rasterizer_nothing_is_found(self):
        survey, text = self.survey("--subject", "i64-snap8")
        self.assertEqual(survey["yardsticks"], YARDSTICKS)
        self.assertIn("nearest model: 8 subpixel bits", text)
        self.assertIn("this model explains all", text)
        self.assertEqual(sum(cell["wrong"] for cell in cells(survey)), 0)
        self.assertEqual(total(survey, "nearest model", "excused"), 0)
        self.assertGreater(total(survey, "gaps", "cases"), 50)

    def test_what_is_found_is_found_again_by_replay(self):
        survey, _ = self.survey("--subject", "f32-direct")
        found = [cell for cell in cells(survey) if cell["wrong"]]
        self.assertTrue(found)
        saved = [f for f in os.listdir(self.folder) if f != "survey.json"]
        self.assertEqual(len(saved), len(found))
        for file in saved:
            done = run("replay", os.path.join(self.folder, file))
            self.assertEqual(done.returncode, 1, f"{file}: {done.stdout.decode()}")

    def test_the_same_survey_is_the_same_by_any_number_of_jobs(self):
        first, _ = self.survey("--subject", "f32-direct", "--jobs", "3")
        second, _ = self.survey("--subject", "f32-direct", "--jobs", "1")
        self.assertEqual(first, second)

    def test_a_crash_is_reported_with_its_case(self):
        survey, text = self.survey("--exec", f"{MISBEHAVES} crashes", status=1)
        for cell in cells(survey, "nearest model"):
            self.assertGreater(cell["ended"], 0)
            self.assertIn("signal 11", cell["why"])
        self.assertIn("this model is the stated one", text)

    def test_a_program_that_covers_nothing_is_all_gaps(self):
        survey, _ = self.survey("--exec", f"{MISBEHAVES} sound")
        self.assertGreater(total(survey, "gaps", "wrong_samples"), 0)
        self.assertEqual(total(survey, "overlaps", "wrong_samples"), 0)

    def test_the_report_shows_surveys_and_refuses_what_is_none(self):
        page = os.path.join(self.folder, "page")
        certify = ("certify", "--subject", "spans-exact", "--cases", "1", "--out", page,
                   "--survey", self.folder)  # fmt: skip
        done = run(*certify)
        self.assertEqual(done.returncode, 2)
        self.assertIn(b"the folder holds no survey", done.stderr)
        surveys = [os.path.join(self.folder, name) for name in ("a.json", "b.json")]
        for path, subject in zip(surveys, ("--subject=f32-direct", f"--exec={MISBEHAVES} crashes")):
            run("survey", subject, *FEW, "--json", path)
        done = run(*certify)
        self.assertEqual(done.returncode, 0, done.stderr)
        with open(os.path.join(page, "report.html"), encoding="utf-8") as file:
            report = file.read()
        for path in surveys:
            with open(path, encoding="utf-8") as file:
                survey = json.load(file)
            for cell in cells(survey):
                self.assertIn(cell["worst_case"], report)
        self.assertIn("signal 11", report)
        done = run(*certify, "--shard", "1/2")
        self.assertEqual(done.returncode, 2)
        self.assertIn(b"give it to --merge", done.stderr)
        with open(surveys[1], "r+", encoding="utf-8") as file:
            file.truncate(1000)
        done = run(*certify)
        self.assertEqual(done.returncode, 2)
        self.assertIn(b"b.json", done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
