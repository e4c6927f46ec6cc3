"""What check prints by default and with --verbose, and where --fail-fast ends it.

usage: printing_test.py PROGRAM SOURCES"""
import json
import os
import re
import shlex
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCES = (os.path.abspath(path) for path in sys.argv[1:3])
MODEL = "CoverageEqualsTheModel"
SHARED = "SharedEdgeSamplesAreCoveredOnce"
DEPTH = "FragmentDepthStaysInTheHull"


def check(*arguments, cases=12):
    return subprocess.run([PROGRAM, "check", "--cases", str(cases), "--no-cause", *arguments],
                          capture_output=True, cwd=SOURCES, timeout=900, check=False,
                          encoding="utf-8")  # fmt: skip


def outcomes(text):
    """The first words of the lines of results, in their order."""
    found = re.findall(r"^(violated|quality|holds|not applicable|not exercised) ", text, re.M)
    return [word for k, word in enumerate(found) if k == 0 or found[k - 1] != word]


class Screen(unittest.TestCase):
    def test_a_reader_that_has_seen_enough_is_no_error(self):
        for arguments, status in ((("list",), 0),
                                  (("check", "--subject", "textbook", "--property", SHARED,
                                    "--no-cause"), 1)):  # fmt: skip
            reading, writing = os.pipe()
            os.close(reading)
            done = subprocess.run([PROGRAM, *arguments], stdout=writing, stderr=subprocess.PIPE,
                                  check=False)  # fmt: skip
            os.close(writing)
            self.assertEqual(done.returncode, status, arguments)
            self.assertNotIn(b"written", done.stderr)

    def test_the_worst_comes_first_and_the_rest_is_counted(self):
        text = check("--subject", "textbook").stdout
        self.assertEqual(outcomes(text), ["violated", "quality"])
        self.assertLess(len(text.splitlines()), 70, text)
        self.assertEqual(text.count("\nscene: "), 1, text)  # one failure in full
        hold = re.search(r"^textbook: (\d+) hold, (\d+) violated, (\d+) not exercised, (\d+) not",
                         text, re.M)  # fmt: skip
        self.assertEqual(text.count("\nreplay: "), int(hold[2]) + 1, text)
        rest = re.search(r"^--verbose shows \d+ more failures in full, (\d+) properties that hold "
                         r"or are not exercised, why (\d+) properties are not applicable$",
                         text, re.M)  # fmt: skip
        self.assertEqual(int(rest[1]), int(hold[1]) + int(hold[3]), text)
        self.assertEqual(rest[2], hold[4], text)

    def test_verbose_has_every_property_and_every_failure_in_full(self):
        text = check("--subject", "textbook", "--verbose").stdout
        self.assertEqual(outcomes(text), ["violated", "quality", "holds", "not applicable"])
        self.assertEqual(text.count("\nscene: "), text.count("\nreplay: "), text)
        self.assertNotIn("--verbose", text)

    def test_few_properties_are_all_printed(self):
        text = check("--subject", "f32-direct", "--property", "EdgeIsZeroAtItsEnds",
                     "FragmentDepthStaysInTheHull").stdout  # fmt: skip
        self.assertEqual(outcomes(text), ["holds", "not applicable"])
        self.assertIn("shows no fragments", text)

    def test_fail_fast_ends_with_the_first_violation(self):
        done = check("--subject", "textbook", "--fail-fast", "--jobs", "1")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertRegex(done.stdout, r" 1 violated, .* \d+ not asked after the first failure; ")
        done = check("--subject", "spans-exact", "--fail-fast")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertNotIn("not asked after", done.stdout)

    def test_fail_fast_of_scenes_counts_the_scenes_that_were_left_out(self):
        scenes = [f"scenes/{name}.json" for name in ("ties", "fan")]
        done = check(*scenes, "--subject", "textbook", "--property", MODEL, "--fail-fast")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn(", 1 not asked after the first failure; ", done.stdout)


class Data(unittest.TestCase):
    def data(self, *arguments, status=1, **more):
        done = check(*arguments, "--json", "-", **more)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        found = json.loads(done.stdout)
        self.assertEqual(found["status"], status)
        return found["subjects"][0]

    def test_each_property_has_its_outcome_and_each_failure_its_place_and_case(self):
        found = self.data("--subject", "textbook", "--property", MODEL, SHARED, DEPTH)
        outcomes_of = {p["property"]: p["outcome"] for p in found["properties"]}
        self.assertEqual(outcomes_of, {MODEL: "violated", SHARED: "violated",
                                       DEPTH: "not applicable"})  # fmt: skip
        self.assertEqual([f["property"] for f in found["failures"]], [MODEL, SHARED])
        shared = found["failures"][1]
        self.assertIsNone(shared["cause"])  # --no-cause
        self.assertEqual(shared["expected"], "exactly once")
        self.assertEqual(shared["actual"], "covered 2 times")
        self.assertTrue(shared["fails"])
        self.assertEqual(len(shared["edge"]), 2)
        self.assertIn(SHARED, shared["next"])
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "case.json")
            with open(path, "w", encoding="utf-8") as file:
                json.dump(shared["case"], file)
            again = subprocess.run([PROGRAM, "replay", path], capture_output=True, check=False)
            self.assertEqual(again.returncode, 1, again.stderr)

    def test_causes_are_named_with_their_properties(self):
        done = subprocess.run([PROGRAM, "check", "--subject", "mutant:snap-truncates", "--property",
                               MODEL, "--cases", "60", "--json", "-"], capture_output=True,
                              check=False)  # fmt: skip
        found = json.loads(done.stdout)["subjects"][0]
        self.assertEqual(found["failures"][0]["cause"], "truncation")
        self.assertEqual([(c["cause"], c["properties"]) for c in found["causes"]],
                         [("truncation", [MODEL])])  # fmt: skip

    def test_text_and_data_are_written_by_one_run(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "found.json")
            done = check("--subject", "spans-exact", "--property", MODEL, "--json", path)
            self.assertIn("1 hold, 0 violated", done.stdout)
            with open(path, encoding="utf-8") as file:
                self.assertEqual(json.load(file)["subjects"][0]["failures"], [])


class Known(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = os.path.join(folder.name, "known.json")

    def check(self, entries, *arguments, subject="textbook"):
        with open(self.path, "w", encoding="utf-8") as file:
            json.dump({"rasterproof_known_failures": 1, "failures": entries}, file)
        return check("--subject", subject, "--known", self.path, *arguments)

    def entry(self, name, until="9999-12-31", **more):
        return {"property": name, "owner": "Ada", "until": until, **more}

    def test_only_new_failures_fail(self):
        done = self.check([self.entry(MODEL)], "--property", MODEL)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("Ada fixes it by 9999-12-31", done.stdout)
        self.assertIn("0 violated", done.stdout)
        self.assertIn(", 1 known to fail; ", done.stdout)
        self.assertNotIn("violated  ", done.stdout)
        done = self.check([self.entry(MODEL)], "--property", MODEL, SHARED)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("1 violated", done.stdout)
        other = self.check([self.entry(MODEL, subject="f32-direct")], "--property", MODEL)
        self.assertEqual(other.returncode, 1, other.stdout)

    def test_an_unexpected_pass_is_told_and_fails_nothing(self):
        done = self.check([self.entry(MODEL)], "--property", MODEL, subject="spans-exact")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertRegex(done.stdout, f"(?m)^passes +spans-exact +{MODEL}[^\n]* passes now")
        # What was not asked has not passed.
        done = self.check([self.entry(SHARED)], "--property", MODEL, subject="spans-exact")
        self.assertNotIn("passes now", done.stdout)

    def test_an_entry_past_its_day_fails_and_says_so(self):
        for name, status in ((MODEL, 1), (SHARED, 0)):  # the second was not asked for
            done = self.check([self.entry(name, until="2001-02-03")], "--property", MODEL,
                              subject="spans-exact")  # fmt: skip
            self.assertEqual(done.returncode, status, done.stdout + done.stderr)
            self.assertEqual("Ada was to fix it by 2001-02-03" in done.stdout, status == 1)

    def test_a_cause_covers_its_own_failures_alone(self):
        for cause, status in (("truncation", 0), ("rounding", 1)):
            with open(self.path, "w", encoding="utf-8") as file:
                json.dump({"rasterproof_known_failures": 1,
                           "failures": [self.entry(MODEL, cause=cause)]}, file)  # fmt: skip
            done = subprocess.run([PROGRAM, "check", "--subject", "mutant:snap-truncates",
                                   "--property", MODEL, "--cases", "60", "--known", self.path],
                                  capture_output=True, check=False)  # fmt: skip
            self.assertEqual(done.returncode, status, done.stdout)
        done = self.check([self.entry(MODEL, cause="truncation")])
        self.assertEqual(done.returncode, 2, done.stdout)
        self.assertIn("failures[0]", done.stderr)

    def test_a_known_failure_ends_no_run(self):
        done = self.check([self.entry(MODEL)], "--property", MODEL, SHARED, "--fail-fast",
                          "--jobs", "1")  # fmt: skip
        self.assertIn("1 violated", done.stdout)
        self.assertIn("1 known to fail", done.stdout)

    def test_a_bad_list_is_refused_with_its_place(self):
        good = self.entry(MODEL)
        for bad, words in (
            ({**good, "until": "2027-02-30"}, r"failures\[0\].until: .*is no date"),
            ({**good, "until": "soon"}, r"failures\[0\].until: .*is no date"),
            ({**good, "property": "Nonesuch"}, r"failures\[0\].property: .*is no property"),
            ({**good, "owner": ""}, r"failures\[0\].owner: "),
            ({**good, "cause": "tie-rules"},
             r"failures\[0\].cause: .tie-rules. is no cause; did you mean tie-rule\? "),
            ({**good, "why": "?"}, r"failures\[0\]"),
            ({"property": MODEL}, r"failures\[0\]"),
        ):
            done = self.check([bad], "--property", MODEL)
            self.assertEqual(done.returncode, 2, done.stdout)
            self.assertRegex(done.stderr, words)
            self.assertEqual(done.stdout, "")


class Failure(unittest.TestCase):
    def test_the_command_runs_the_shrunk_case_itself(self):
        text = check("--subject", "textbook", "--property", SHARED).stdout
        scene = re.search(r"^scene: (.*)$", text, re.M)[1]
        replay = shlex.split(re.search(r"^replay: rasterproof (.*)$", text, re.M)[1])
        self.assertEqual(replay[-1], scene)
        for verb in ("replay", "explain"):
            again = subprocess.run([PROGRAM, verb, *replay[1:]], capture_output=True, check=False,
                                   encoding="utf-8")  # fmt: skip
            self.assertEqual(again.returncode, 1, again.stderr)
            self.assertIn(scene, again.stdout)
        self.assertRegex(text, r"(?m)^shrunk from [a-z0-9-]+:\d+@1$")

    def test_a_saved_case_is_named_by_its_file(self):
        with tempfile.TemporaryDirectory() as folder:
            text = check("--subject", "textbook", "--property", SHARED, "--save", folder).stdout
            replay = shlex.split(re.search(r"^replay: rasterproof (.*)$", text, re.M)[1])
            self.assertEqual(os.path.dirname(replay[1]), folder)
            again = subprocess.run([PROGRAM, *replay], capture_output=True, check=False)
            self.assertEqual(again.returncode, 1, again.stderr)

    def test_edges_are_named_by_their_vertices(self):
        text = check("--subject", "textbook", "--property", SHARED).stdout
        self.assertRegex(text, r"(?m)^SharedEdge.*: triangle 1 .* edge v\d-v\d ")
        self.assertRegex(text, r"(?m)^triangle 0, edge v1-v2: E = ")
        self.assertNotRegex(text, r"edge \d")

    def test_counts_have_facings_only_where_the_subject_gives_them(self):
        with tempfile.TemporaryDirectory() as folder:
            program = os.path.join(folder, "program.py")
            with open(os.path.join(SOURCES, "kit/examples/program.py"), encoding="utf-8") as file:
                text = file.read().replace("e < 0 or", "e <= 0 or")  # no tie has an owner
            with open(program, "w", encoding="utf-8") as file:
                file.write(text)
            found = check("--exec", f"{sys.executable} {program}", "--property", MODEL).stdout
        self.assertRegex(found, "=> observed 0, expected 1; exact E ")
        self.assertNotIn("observed front", found)
        found = check("--subject", "textbook", "--property", MODEL).stdout
        self.assertIn("=> observed front 0, back 1, expected front 0, back 0; exact", found)

    def explain(self, subject, vertices):
        scene = {"rasterproof_scene": 1, "width": 4, "height": 4, "vertices": vertices,
                 "triangles": [[0, 1, 2]]}  # fmt: skip
        return subprocess.run(
            [PROGRAM, "replay", json.dumps(scene), "--subject", subject, "--property", MODEL],
            capture_output=True, check=False, encoding="utf-8").stdout  # fmt: skip

    def test_numbers_are_decimal_where_that_is_short_and_exact(self):
        text = self.explain("mutant:box-left", [[0.5, 0.5], [3.5, 0.5], [0.5, 3.5]])
        self.assertIn("(0x1p-1, 0x1p-1) = (0.5, 0.5)", text)
        text = self.explain("mutant:box-left", [[0.5, 0.5], [3.5, 1 / 3], [0.5, 3.5]])
        self.assertRegex(text, r"\(0x1.cp\+1, 0x1.55\w+p-2\) \(0x1p-1")


class Profile(unittest.TestCase):
    def test_another_profile_judges_a_certificate_and_is_part_of_its_command(self):
        for more, status in (((), 0), (("--profile", "real"), 1)):
            with tempfile.TemporaryDirectory() as folder:
                done = subprocess.run(
                    [PROGRAM, "certify", "--subject", "i64-snap8", "--cases", "10", "--scenes",
                     "scenes/quick.json", "--out", folder, *more],
                    capture_output=True, cwd=SOURCES, check=False)  # fmt: skip
                self.assertEqual(done.returncode, status, done.stderr)
                path = os.path.join(folder, "i64-snap8", "certificate.json")
                with open(path, encoding="utf-8") as file:
                    command = json.load(file)["command"]
                self.assertEqual("--profile real" in command, bool(more))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
