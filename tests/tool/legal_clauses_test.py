"""legal: the clauses that a drawing breaks which no legal model explains.

usage: legal_clauses_test.py PROGRAM SOURCES
"""
import json
import sys
import unittest
import xml.etree.ElementTree

from legal_case import SQUARE, LegalCase, run

PLACED = ["vulkan.point-sampling", "vulkan.subpixel-bits"]
OWNER = "vulkan.common-edge"


class LegalClausesTest(LegalCase):
    def required_by(self, *arguments, status=1):
        """The ids in JSON; the text has a line for each, or one for the stated model."""
        path = self.path("legal.json")
        done = run("legal", *arguments, "--json", path)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        with open(path, encoding="utf-8") as file:
            result = json.load(file)
        if status == 0:
            self.assertNotIn("required_by", result)
            self.assertNotIn("required by", done.stdout)
            return []
        lines = [line for line in done.stdout.splitlines() if line.startswith("required by ")]
        told = [line.split()[2].rstrip(":") for line in lines if "the stated model: " not in line]
        self.assertEqual(told, result["required_by"], done.stdout)
        self.assertTrue(lines, done.stdout)
        if told:
            self.assertIn("required by " + ", ".join(told), result["why"])
        for name in told:
            self.assertIn(f"\n  {name} ", run("list", "clauses", name).stdout)
        return told or result["why"]

    def test_the_owner_of_a_sample_and_its_coverage_are_told_apart(self):
        right = self.drawn("vulkan-canonical")
        twice, lost, both, thrice = ([row[:] for row in right] for _ in range(4))
        thrice[1][1] = 3  # of two triangles
        twice[1][1] = both[1][1] = 2  # on the diagonal
        lost[0][2] = both[0][2] = 0  # inside of the first triangle
        for rows, profile, expected in (
                (right, "vulkan", []),
                (twice, "vulkan", [OWNER]),
                (lost, "vulkan", PLACED),
                (both, "vulkan", [OWNER, *PLACED]),
                (twice, "gl", ["gl.common-edge"]),
                (twice, "d3d11", ["d3d11.top-left", "d3d11.two-edges"]),
                (lost, "d3d11", ["d3d11.point-sampling", "d3d11.snap-tolerance",
                                 "d3d11.eight-bits"]),
                (thrice, "webgpu", ["webgpu.point-sampling"]),
                (twice, "vulkan-canonical", "by the stated model: who owns a sample on an edge"),
                (both, "vulkan-canonical", "by the stated model: who owns a sample on an edge; "
                 "samples inside a placed triangle are covered, others are not")):  # fmt: skip
            found = self.required_by(self.scene, self.as_text(rows), "--profile", profile,
                                     status=1 if expected else 0)
            self.assertEqual(found, expected, profile)

    def test_an_order_and_a_facing_have_their_clauses(self):
        self.scene = self.write("over.json", json.dumps(dict(SQUARE, triangles=[[0, 1, 2]] * 2)))
        first = self.as_text([[1, 1, 1, 0], [0, 1, 1, 0], [0, 0, 1, 0], [0, 0, 0, 0]])
        ids = (self.scene, first, "--ids", "--visible", "last", "--profile")
        self.assertEqual(self.required_by(*ids, "vulkan"), ["vulkan.rasterization-order"])
        self.assertEqual(self.required_by(*ids, "d3d11"),
                         "by the stated model: which of several triangles is visible")
        square = self.write("square.json", json.dumps(SQUARE))
        self.assertEqual(self.required_by(square, "--profile", "vulkan", "--subject",
                                          "mutant:vulkan-facing-by-place"), ["vulkan.facing"])

    def test_a_triangle_that_draws_nothing_has_its_clause(self):
        nothing = [[0] * 4] * 4
        one = [[0] * 4, [0, 1, 0, 0], *nothing[2:]]
        for name, vertices, clause in (
                ("flat", [[0.5, 0.5], [2.5, 2.5], [1.5, 1.5]], ["d3d11.zero-area"]),
                ("nan", [[0.5, 0.5], [2.5, 2.5], ["nan", 0.5]], ["d3d11.nan"])):
            scene = {"rasterproof_scene": 1, "name": name, "width": 4, "height": 4,
                     "vertices": vertices, "triangles": [[0, 1, 2]]}
            self.scene = self.write("scene.json", json.dumps(scene))
            for rows, expected in ((nothing, []), (one, clause)):
                found = self.required_by(self.scene, self.as_text(rows), "--profile", "d3d11",
                                         status=1 if expected else 0)
                self.assertEqual(found, expected, name)

    def test_a_list_and_its_junit_name_clauses_and_what_is_assumed(self):
        scene = dict(SQUARE, vertices=[[2 * x, 2 * y, 0, 2] for x, y in SQUARE["vertices"]])
        self.write("clip.json", json.dumps(scene))
        self.write("right.txt", "1 1 1 0\n" * 3 + "0 0 0 0\n")
        self.write("twice.txt", "1 1 1 0\n1 2 1 0\n1 1 1 0\n0 0 0 0\n")
        drawings = [{"name": name, "scene": "clip.json", "image": name + ".txt"}
                    for name in ("right", "twice")]
        done = self.listed(*drawings, options=("--profile", "d3d11", "--assume-transform-error",
                                               "2", "--junit", self.path("out.xml")))
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        lines = done.stdout.splitlines()
        self.assertNotIn("required by", lines[0])
        self.assertIn("; required by d3d11.top-left, d3d11.two-edges; compared: ", lines[1])
        suite = xml.etree.ElementTree.parse(self.path("out.xml")).getroot()[0]
        cases = suite.findall("testcase")
        for case in cases:
            self.assertIn("assumed, for no specification states it: the transform",
                          case.find("system-out").text)
        failure = cases[1].find("failure")
        self.assertIn("required by d3d11.top-left", failure.get("message"))
        for told in ("d3d11.top-left: A sample on an edge is inside if", "assumed, for no"):
            self.assertIn(told, failure.text)
        self.write("square.json", json.dumps(SQUARE))
        entry = dict(drawings[1], scene="square.json")
        self.listed(entry, options=("--profile", "gl", "--junit", self.path("out.xml")))
        with open(self.path("out.xml"), encoding="utf-8") as file:
            text = file.read()
        self.assertIn("gl.one-position: ", text)  # a reading that no sentence settles
        self.assertNotIn("assumed, for no specification", text)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=0)
