"""Clauses and who asks for a property, as users of the command meet them.

usage: authority_test.py PROGRAM SOURCES
"""
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.path.abspath(sys.argv[1])
SOURCES = os.path.abspath(sys.argv[2])
# It forgets how far right a box may end: what it covers depends on the triangle before.
FORGETFUL = "mutant:box-limited-by-last"
ORDER = "TriangleOrderKeepsCoverage"


def run(*arguments):
    result = subprocess.run([PROGRAM, *arguments], stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                            cwd=SOURCES, timeout=900, text=True)  # fmt: skip
    return result.returncode, result.stdout, result.stderr


class ClausesTest(unittest.TestCase):
    def test_clauses_are_listed_as_text_and_as_data(self):
        status, text, _ = run("list", "clauses")
        self.assertEqual(status, 0)
        self.assertIn("vulkan.common-edge (Basic Polygon Rasterization; required)", text)
        status, text, _ = run("list", "clauses", "--json")
        self.assertEqual(status, 0)
        specifications = json.loads(text)
        self.assertGreaterEqual(sum(len(one["clauses"]) for one in specifications), 60)

    def test_clauses_of_one_specification_are_listed(self):
        status, text, _ = run("list", "clauses", "vulkan")
        self.assertEqual(status, 0)
        self.assertIn("vulkan.common-edge", text)
        self.assertNotIn("gl.common-edge", text)
        specifications = json.loads(run("list", "clauses", "gl.common", "--json")[1])
        self.assertEqual([clause["id"] for one in specifications for clause in one["clauses"]],
                         ["gl.common-edge"])  # fmt: skip
        title = json.loads(run("list", "clauses", "--json")[1])[0]["title"]
        self.assertIn(title, run("list", "clauses", title)[1])
        for arguments, told in ((("clauses", "vulcan"), "vulkan"), (("keys", "x"), "list clauses")):
            status, text, error = run("list", *arguments)
            self.assertEqual((status, text), (2, ""))
            self.assertIn(told, error)

    def test_profile_keys_are_listed_with_their_kind_and_values(self):
        status, text, _ = run("list", "keys")
        self.assertEqual(status, 0)
        self.assertIn("nan_z (freedom)\n    values:  ignored, nothing, unspecified\n", text)

    def test_the_long_tables_are_not_part_of_all(self):
        self.assertNotIn("vulkan.hub", run("list")[1])
        self.assertNotIn("nan_z", run("list")[1])

    def test_nothing_else_is_listed_as_json(self):
        status, _, error = run("list", "subjects", "--json")
        self.assertEqual(status, 2)
        self.assertIn("list clauses --json", error)


class AuthorityTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()

    def tearDown(self):
        self.folder.cleanup()

    def profile(self, name):
        """A profile of this name that leaves more than one result legal: the preset, if any."""
        if re.search(rf"^  {name} ", run("list", "profiles")[1], re.MULTILINE):
            return name
        path = os.path.join(self.folder.name, f"{name}.json")
        with open(path, "w", encoding="utf-8") as file:
            json.dump({"name": name, "subpixel_bits": 8, "snap_rule": "nearest-even",
                       "snap_tolerance": 0.6}, file)  # fmt: skip
        return path

    def check(self, profile, *more):
        return run("check", "--subject", FORGETFUL, "--property", ORDER, "--profile",
                   self.profile(profile), "--no-cause", *more)  # fmt: skip

    def test_what_no_clause_requires_is_quality_and_fails_nothing(self):
        status, text, _ = self.check("x11")
        self.assertEqual(status, 0, text)
        self.assertTrue(text.startswith("quality "), text)
        self.assertIn("quality: no clause requires it", text)
        self.assertIn("0 violated", text)
        self.assertIn("1 short of quality", text)

    def test_quality_fails_where_it_is_asked_to(self):
        status, text, _ = self.check("x11", "--fail-on", "quality")
        self.assertEqual(status, 1, text)
        self.assertTrue(text.startswith("violated "), text)

    def test_a_clause_fails_and_is_named(self):
        status, text, _ = self.check("webgpu")
        self.assertEqual(status, 1, text)
        self.assertIn("required by webgpu.independent-primitives", text)

    def test_the_stated_model_fails(self):
        status, text, _ = self.check("mine")
        self.assertEqual(status, 1, text)
        self.assertIn("by the stated model", text)
        self.assertNotIn("assumed", text)

    def test_assumptions_are_printed_with_verdicts_of_a_specification(self):
        text = self.check("webgpu")[1]
        self.assertRegex(text, r"assumed +webgpu\.one-position: Polygons that share a vertex, or ")

    def test_a_rule_that_flips_by_tile_breaks_opengl_and_is_vulkans_to_allow(self):
        moved = ("check", "--subject", "mutant:ties-per-tile", "--property",
                 "IntegerTranslationMovesCoverage", "--profile")  # fmt: skip
        status, text, _ = run(*moved, "gl")
        self.assertEqual(status, 1, text)
        self.assertIn("required by gl.translation", text)
        status, text, _ = run(*moved, "vulkan")
        self.assertEqual(status, 0, text)
        self.assertTrue(text.startswith("quality "), text)

    def test_a_tie_covered_twice_breaks_a_common_edge_and_webgpu_leaves_it_open(self):
        status, text, _ = run("check", "--subject", "mutant:ties-inclusive", "--profile", "vulkan",
                              "--property", "SharedEdgeSamplesAreCoveredOnce")  # fmt: skip
        self.assertEqual(status, 1, text)
        self.assertIn("required by vulkan.common-edge", text)
        status, text, _ = run("check", "--subject", "mutant:ties-inclusive", "--profile", "webgpu",
                              "--property", "OpenTiesAreCoveredOnce")  # fmt: skip
        self.assertEqual(status, 0, text)
        self.assertTrue(text.startswith("quality "), text)

    def joint(self, profile, *more):
        return run("check", "--subject", "i32-snap4", "--property", "OneLegalModelExplainsTheMesh",
                   "--cases", "30", "--profile", profile, *more)  # fmt: skip

    def test_a_device_is_held_to_the_bits_that_it_reports(self):
        for bits, expected in ((4, 0), (8, 1)):
            path = os.path.join(self.folder.name, f"{bits}.json")
            with open(path, "w", encoding="utf-8") as file:
                json.dump({"name": "card", "specification": "vulkan", "subpixel_bits": bits}, file)
            status, text, _ = self.joint(path)
            self.assertEqual(status, expected, text)
            self.assertIn("required by vulkan.point-sampling", text)
            self.assertIn("assumed ", text)

    def test_a_subjects_numbers_fill_the_set_in(self):
        status, text, _ = self.joint("vulkan", "--device")
        self.assertEqual(status, 0, text)
        self.assertIn("required by vulkan.point-sampling", text)
        # 4 bits are no legal grid of Direct3D, and a device cannot make them one.
        status, text, _ = self.joint("d3d11", "--device")
        self.assertEqual(status, 1, text)

    def test_numbers_are_put_into_legal_sets_alone(self):
        for profile in ("vulkan-canonical", "real"):
            status, _, error = self.joint(profile, "--device")
            self.assertEqual(status, 2)
            self.assertIn(f"profile {profile} is not a specification's legal set", error)
        status, _, error = run("check", "--subject", "i32-snap4", "--device")
        self.assertEqual(status, 2)
        self.assertIn("give --profile d3d11, vulkan, gl or webgpu", error)

    def test_an_unknown_kind_is_refused(self):
        status, _, error = self.check("x11", "--fail-on", "everything")
        self.assertEqual(status, 2)
        self.assertIn("--fail-on", error)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
