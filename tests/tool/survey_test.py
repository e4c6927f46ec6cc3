"""The verb survey: the nearest model, what is found beside it, and its cases replayed.

usage: survey_test.py PROGRAM SOURCES
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


def total(survey, key):
    return sum(domain[key] for domain in survey["domains"])


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
        self.assertEqual(survey["rasterproof_survey"], 4)
        self.assertEqual(survey["model"]["profile"]["subpixel_bits"], 8)
        self.assertIn("this model explains all", text)
        for key in ("wrong", "gaps", "overlaps", "refused", "unjudged"):
            self.assertEqual(total(survey, key), 0, key)
        self.assertGreater(total(survey, "meshes"), 50)
        self.assertEqual([d["findings"] for d in survey["domains"] if d["findings"]], [])

    def test_what_is_found_is_found_again_by_replay(self):
        survey, text = self.survey("--subject", "f32-direct")
        findings = [f for domain in survey["domains"] for f in domain["findings"]]
        self.assertIn("wrong", {f["fault"] for f in findings})
        self.assertIn("first case of each kind", text)
        for found in findings:
            self.assertIn(found["name"], text)
        saved = [f for f in os.listdir(self.folder) if f != "survey.json"]
        self.assertEqual(len(saved), len(findings))
        for file in saved:
            done = run("replay", os.path.join(self.folder, file))
            self.assertEqual(done.returncode, 1, f"{file}: {done.stdout.decode()}")

    def test_the_same_survey_is_the_same_by_any_number_of_jobs(self):
        first, _ = self.survey("--subject", "f32-direct", "--jobs", "3")
        second, _ = self.survey("--subject", "f32-direct", "--jobs", "1")
        for survey in (first, second):
            for domain in survey["domains"]:
                for key in ("seconds", "subject_seconds", "alone_seconds"):
                    domain.pop(key)
        self.assertEqual(first, second)

    def test_a_crash_is_reported_with_its_case(self):
        survey, text = self.survey("--exec", f"{MISBEHAVES} crashes", status=1)
        ends = [f for d in survey["domains"] for f in d["findings"] if f["fault"] == "end"]
        self.assertEqual(len(ends), len(survey["domains"]))
        self.assertIn("signal 11", ends[0]["end"])
        self.assertIn("this model is the stated one", text)

    def test_a_program_that_covers_nothing_is_all_gaps(self):
        survey, _ = self.survey("--exec", f"{MISBEHAVES} sound")
        self.assertGreater(total(survey, "gaps"), 0)
        self.assertEqual(total(survey, "overlaps"), 0)

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
        for path, row in zip(surveys, ("survey-0", "survey-1")):
            with open(path, encoding="utf-8") as file:
                survey = json.load(file)
            self.assertIn(f'<a class="name" href="#{row}">', report)
            for found in (f for domain in survey["domains"] for f in domain["findings"]):
                self.assertIn(found["name"], report)
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
