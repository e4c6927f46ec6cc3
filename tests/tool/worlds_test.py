"""certify --exhaustive: what holds in every case of a world, what one case shows, what is refused.

usage: worlds_test.py PROGRAM SOURCES
"""
import json
import os
import shlex
import subprocess
import sys
import tempfile
import unittest
import xml.etree.ElementTree

PROGRAM, SOURCES = (os.path.abspath(path) for path in sys.argv[1:3])


def run(*arguments):
    return subprocess.run([PROGRAM, *arguments], cwd=SOURCES, capture_output=True, text=True,
                          timeout=900, check=False)  # fmt: skip


class Worlds(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.out = os.path.join(os.path.realpath(folder.name), "out")

    def certify(self, subject, *worlds, jobs="1"):
        chosen = [word for world in worlds for word in ("--exhaustive", world)]
        return run("certify", "--subject", subject, *chosen, "--cases", "1", "--jobs", jobs,
                   "--scenes", "scenes/quick.json", "--out", self.out)  # fmt: skip

    def certificate(self, subject):
        path = os.path.join(self.out, subject.replace(":", "+"), "certificate.json")
        with open(path, encoding="utf-8") as file:
            return json.load(file)

    def test_a_sound_subject_exhausts_a_world(self):
        for jobs in ("1", "2"):
            done = self.certify("spans-exact", "pairs-3x3", "triangles-7x7", jobs=jobs)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertIn("exhausted: CoverageEqualsTheModel on pairs-3x3: all 6561 of 6561 cases",
                          done.stdout)  # fmt: skip
            certificate = self.certificate("spans-exact")
            exhausted = [one["statement"] for one in certificate["exhausted"]]
            self.assertEqual(exhausted, ["CoverageEqualsTheModel on pairs-3x3",
                                         "SharedEdgeSamplesAreCoveredOnce on pairs-3x3",
                                         "CoverageEqualsTheModel on triangles-7x7"])  # fmt: skip
            self.assertEqual([one for one in certificate["tested"] if "world" in one], [])
            junit = xml.etree.ElementTree.parse(os.path.join(self.out, "spans-exact", "junit.xml"))
            tests = {test.get("name"): test for test in junit.iter("testcase")}
            test = tests["CoverageEqualsTheModel on triangles-7x7"]
            self.assertEqual(test.findtext("system-out"), "exhausted: all 117649 of 117649 cases\n")

    def test_a_wrong_one_is_found_with_a_case_that_can_be_replayed(self):
        subject = "mutant:ties-inclusive"
        done = self.certify(subject, "pairs-3x3")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertNotIn("exhausted:", done.stdout)
        certificate = self.certificate(subject)
        self.assertEqual(certificate["exhausted"], [])
        shared = [one for one in certificate["tested"] if one.get("world") == "pairs-3x3"
                  and one["property"] == "SharedEdgeSamplesAreCoveredOnce"]  # fmt: skip
        self.assertEqual(len(shared), 1)
        found = shared[0]["counterexample"]
        self.assertRegex(found["found_as_case"], r"^pairs-3x3:\d+@0$")
        replayed = run(*shlex.split(found["replay"])[1:])
        self.assertEqual(replayed.returncode, 1, replayed.stdout + replayed.stderr)
        named = run("check", "--subject", subject, "--case", found["found_as_case"], "--property",
                    "SharedEdgeSamplesAreCoveredOnce")  # fmt: skip
        self.assertEqual(named.returncode, 1, named.stdout + named.stderr)

    def test_names_that_are_none_are_refused_before_any_work(self):
        for worlds, words in ((("pairs-5x5",), "there is no world pairs-5x5"),
                              (("pairs-3x3", "pairs-3x3"), "is named twice")):  # fmt: skip
            done = self.certify("spans-exact", *worlds)
            self.assertEqual(done.returncode, 2, done.stdout)
            self.assertIn(words, done.stderr)
            self.assertFalse(os.path.exists(self.out))

    def test_the_list_has_each_world_with_its_number_of_cases(self):
        done = run("list", "worlds")
        self.assertEqual(done.returncode, 0, done.stderr)
        for name, cases in (("triangles-7x7", 49**3), ("pairs-7x7", 49**4), ("fans-4x4", 16**7)):
            self.assertRegex(done.stdout, rf"\n  {name} +{cases} cases ")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
