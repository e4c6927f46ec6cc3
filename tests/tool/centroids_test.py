"""Centroids from outside: of a library, and of a program on a pipe with four samples.

usage: centroids_test.py PROGRAM SOURCES PLUGINS
"""
import os
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCES, PLUGINS = (os.path.abspath(path) for path in sys.argv[1:4])
MANY = 12 if "RASTERPROOF_MORE" in os.environ else 0  # cases, in scripts/test_more
CENTROIDS = "CentroidsLieWhereStated"
BESIDE = ("FragmentBarycentricsStayWithinTheirError", "FragmentDepthFollowsItsBarycentrics")
DESCRIPTION = """command {program}
coverage fragments
shows centroids
barycentrics-of snapped
barycentric-error 1e-12
takes window wants
profile {{"name": "mine", "subpixel_bits": 8, "coordinate_limit": 32768, \
"infinite_vertex": "unspecified", "sample_locations": "standard-4", "centroid": "{rule}"}}
"""


def run(*arguments):
    done = subprocess.run([PROGRAM, *arguments], capture_output=True, cwd=SOURCES, timeout=900,
                          check=False)  # fmt: skip
    return done.returncode, done.stdout.decode() + done.stderr.decode()


def check(subject, properties, cases):
    chosen = [word for name in properties for word in ("--property", name)]
    return run("check", *subject, "--no-cause", "--cases", str(cases), *chosen)


def held(text):
    return sum(line.startswith("holds ") for line in text.splitlines())


class Libraries(unittest.TestCase):
    def check(self, name):
        return check(["--plugin", os.path.join(PLUGINS, f"shown_{name}.so")],
                     [CENTROIDS, *BESIDE], 60)  # fmt: skip

    def test_what_it_shows_is_judged(self):
        status, text = self.check("CENTROIDS")
        self.assertEqual((status, held(text)), (0, 3), text)

    def test_a_fault_is_found(self):
        status, text = self.check("CENTROID")
        self.assertEqual((status, held(text)), (1, 2), text)
        self.assertIn("the centroid of a fragment lies elsewhere", text)

    def test_one_that_shows_none_is_not_judged_by_them(self):
        status, text = self.check("FRAGMENTS")
        self.assertEqual((status, held(text)), (0, 2), text)
        self.assertIn("the subject shows no centroids", text)


class Programs(unittest.TestCase):
    def check(self, rule, fault="", properties=(CENTROIDS,), cases=12):
        program = f"{sys.executable} {SOURCES}/tests/tool/shows_centroids.py {fault}"
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "mine.subject")
            with open(path, "w", encoding="utf-8") as file:
                file.write(DESCRIPTION.format(program=program, rule=rule))
            return check(["--subject", path], properties, cases)

    def test_direct3ds_point_is_one_of_the_region(self):
        for rule in ("direct3d", "inside"):
            status, text = self.check(rule)
            self.assertEqual((status, held(text)), (0, 1), text)

    def test_what_is_shown_beside_them_keeps_its_own_properties(self):
        # Of all triangles of a case the program, in Python, shows all fragments.
        status, text = self.check("inside", properties=(CENTROIDS, *BESIDE), cases=MANY or 4)
        self.assertEqual((status, held(text)), (0, 3), text)

    def test_another_sample_is_no_fault_of_the_region_alone(self):
        self.assertEqual(self.check("inside", "last")[0], 0)
        status, text = self.check("direct3d", "last")
        self.assertEqual(status, 1)
        self.assertIn("those of the first covered sample", text)

    def test_what_nobody_asks_for_does_not_come(self):
        status, text = self.check("inside", "unasked", properties=BESIDE[:1], cases=MANY or 4)
        self.assertEqual(status, 1, text)

    def test_what_nobody_states_is_not_judged(self):
        status, text = self.check("unstated")
        self.assertEqual(status, 4, text)
        self.assertIn("the profile does not state where centroids lie", text)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
