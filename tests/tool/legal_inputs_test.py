"""legal: facings from a file beside counts or ids, and saved cores that are replayed.

usage: legal_inputs_test.py PROGRAM SOURCES
"""
import json
import shlex
import struct
import subprocess
import sys
import unittest

from legal_case import PROGRAM, SOURCES, SQUARE, LegalCase, png, run

IDS = [[1, 1, 1, 0], [2, 1, 1, 0], [2, 2, 1, 0], [0, 0, 0, 0]]
NO_FRONT = [[0] * 4] * 4


class LegalFacingsTest(LegalCase):
    def judged(self, image, facings, profile, *more):
        done = self.legal(self.rows("image.txt", image), profile, "--facings",
                          self.rows("facings.txt", facings), *more)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        return done

    def test_one_side_is_the_front_of_all_triangles(self):
        counts = self.drawn("vulkan-canonical")
        mixed = [[0] * 4, [1, 0, 0, 0], *NO_FRONT[2:]]  # a sample of the second triangle alone
        mine = self.write("mine.json", json.dumps({"name": "mine", "subpixel_bits": 8}))
        for facings, profile, status in (
                (NO_FRONT, "vulkan", 0), (counts, "vulkan", 0), (mixed, "vulkan", 1),
                (NO_FRONT, mine, 0), (counts, mine, 1)):
            done = self.judged(counts, facings, profile)
            self.assertEqual(done.returncode, status, profile + done.stdout)
            self.assertIn("compared: counts and facings", done.stdout)
        done = self.judged(counts, mixed, "vulkan")
        self.assertIn("column 0 row 1: 1 front and 0 back of triangles 1 cover it; legal: "
                      "0 front and 1 back\n", done.stdout)  # fmt: skip
        self.assertIn("required by      vulkan.facing: ", done.stdout)
        counts[0][2] = 0
        done = self.judged(counts, NO_FRONT, "vulkan")
        self.assertEqual(done.returncode, 1)
        self.assertIn("counts; no model explains them, whatever the facings", done.stdout)

    def test_the_triangle_of_an_id_shows_the_side_that_it_has(self):
        every = [[min(n, 1) for n in row] for row in IDS]
        mixed = [[0] * 4, [1, 0, 0, 0], *NO_FRONT[2:]]
        for visible in ("any", "last"):
            more = ("--ids", "--visible", visible)
            for facings, status in ((NO_FRONT, 0), (every, 0), (mixed, 1)):
                done = self.judged(IDS, facings, "vulkan", *more)
                self.assertEqual(done.returncode, status, done.stdout)
                self.assertIn("compared: facings and ids", done.stdout)
            done = self.judged(IDS, mixed, "vulkan", *more, "--json", self.path("out.json"))
            self.assertIn("column 0 row 1: shows the front of triangle 1; legal: its back\n",
                          done.stdout)
            with open(self.path("out.json"), encoding="utf-8") as file:
                result = json.load(file)
            self.assertEqual(result["required_by"], ["vulkan.facing"])
            self.assertEqual(result["core"]["samples"][0]["shown_side"], "front")

    def test_facings_have_the_forms_of_counts(self):
        counts = self.rows("counts.txt", self.drawn("vulkan-canonical"))
        mixed = bytes([0] * 4 + [1] + [0] * 11)
        for name, content in (("f.raw", mixed), ("f.pgm", b"P5 4 4 255\n" + mixed),
                              ("g.raw", b"".join(struct.pack("<I", n) for n in mixed))):
            done = self.legal(counts, "vulkan", "--facings", self.write(name, content))
            self.assertEqual(done.returncode, 1, name + done.stderr)
            self.assertIn("column 0 row 1: 1 front and 0 back", done.stdout)

    def test_a_wrong_file_is_named(self):
        counts = self.rows("counts.txt", self.drawn("vulkan-canonical"))
        judge = ("legal", self.scene, counts, "--profile", "vulkan", "--facings")
        self.refused(*judge, self.path("gone.txt"), names=["gone.txt"])
        self.refused(*judge, self.rows("short.txt", NO_FRONT[1:]), names=["short.txt", "3 rows"])
        twice = self.rows("twice.txt", [[0, 2, 0, 0], *NO_FRONT[1:]])
        self.refused(*judge, twice, names=["twice.txt: column 1 row 0", "2 front-facing",
                                          "shows 1"])  # fmt: skip
        outside = self.rows("outside.txt", [[0, 0, 0, 1], *NO_FRONT[1:]])
        for image, more in ((counts, ()), (self.rows("ids.txt", IDS), ("--ids",))):
            self.refused("legal", self.scene, image, "--profile", "vulkan", "--facings", outside,
                         *more, names=["outside.txt: column 3 row 0", "1 front-facing", "shows 0"])
        picture = self.write("image.png", png([[255] * 3 + [0]] * 3 + [[0] * 4]))
        none = self.rows("none.txt", NO_FRONT)
        self.refused("legal", self.scene, picture, "--profile", "vulkan", "--facings", none,
                     names=["--facings", "not how often", "--counts"])
        self.refused("legal", self.scene, "--subject", "i64-snap8", "--profile", "vulkan",
                     "--facings", none, names=["--facings", "their own facings"])

    def test_a_list_has_facings_beside_its_images(self):
        self.rows("counts.txt", self.drawn("vulkan-canonical"))
        self.rows("none.txt", NO_FRONT)
        self.rows("mixed.txt", [[0] * 4, [1, 0, 0, 0], *NO_FRONT[2:]])
        right = {"name": "right", "scene": "scene.json", "image": "counts.txt",
                 "profile": "vulkan", "facings": "none.txt"}
        done = self.listed(right, dict(right, name="mixed", facings="mixed.txt"))
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("2 drawings: 1 legal; 1 not legal\n", done.stdout)
        done = self.listed(right, dict(right, name="gone", facings="gone.txt"))
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("gone.txt", done.stderr)
        del right["image"]
        done = self.listed(right, options=("--subject", "i64-snap8"))
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("[0].facings", done.stderr)


class SavedCoreTest(LegalCase):
    def saved(self, *arguments):
        """Saves the core, runs the command that is printed; returns the case and both texts."""
        path = self.path("core.json")
        done = run("legal", *arguments, "--save", path)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        (line,) = (line for line in done.stdout.splitlines() if line.startswith("replay: "))
        words = shlex.split(line.removeprefix("replay: "))
        self.assertEqual(words[:3], ["rasterproof", "legal", path])
        again = subprocess.run([PROGRAM, *words[1:]], capture_output=True, text=True, cwd=SOURCES,
                               timeout=900)
        self.assertEqual(again.returncode, 1, line + again.stdout + again.stderr)
        with open(path, encoding="utf-8") as file:
            case = json.load(file)
        for side in ("width", "height"):
            self.assertEqual(case["scene"][side], SQUARE[side])
        return case, done.stdout.replace(line + "\n", ""), again.stdout

    def test_a_saved_image_is_judged_again_with_the_same_words(self):
        twice = self.drawn("vulkan-canonical")
        twice[1][1] = 2
        lost = [row[:] for row in twice]
        lost[1][1], lost[0][2] = 1, 0
        ids = [row[:] for row in IDS]
        ids[0][2] = 2
        picture = self.write("image.png", png([[255 * n for n in row] for row in lost]))
        fronts = self.rows("fronts.txt", [[0] * 4, [1, 0, 0, 0], *NO_FRONT[2:]])
        for image, more in (
                (self.rows("twice.txt", twice), ()),
                (picture, ()),
                (self.rows("ids.txt", ids), ("--ids", "--visible", "last")),
                (self.rows("ids2.txt", IDS), ("--ids", "--facings", fronts)),
                (self.rows("right.txt", self.drawn("vulkan-canonical")), ("--facings", fronts))):
            _, first, again = self.saved(self.scene, image, "--profile", "vulkan", *more)
            self.assertEqual(first, again)

    def test_a_sample_that_no_triangle_may_cover_is_saved_with_its_scene(self):
        rows = self.drawn("vulkan-canonical")
        rows[3][3] = 1
        case, first, again = self.saved(self.scene, self.as_text(rows), "--profile", "vulkan")
        self.assertIn("column 3 row 3: no legal model lets any triangle cover it", first)
        self.assertEqual(first, again)
        self.assertEqual(case["scene"]["triangles"], SQUARE["triangles"])

    def test_what_was_assumed_is_assumed_again(self):
        scene = dict(SQUARE, vertices=[[2 * x, 2 * y, 0, 2] for x, y in SQUARE["vertices"]])
        clip = self.write("clip.json", json.dumps(scene))
        twice = self.drawn("vulkan-canonical")
        twice[1][1] = 2
        _, first, again = self.saved(clip, self.as_text(twice), "--profile", "d3d11",
                                     "--assume-transform-error", "2")
        self.assertIn("assumed, for no specification", first)
        self.assertEqual(first, again)

    def test_a_subject_draws_the_saved_case_and_is_not_legal_there(self):
        """With a third triangle that has no part in it."""
        scene = dict(SQUARE, vertices=[*SQUARE["vertices"], [0.25, 3.25], [3.75, 3.25], [2, 3.75]],
                     triangles=[*SQUARE["triangles"], [4, 5, 6]])
        other = self.write("other.json", json.dumps(scene))
        case, _, _ = self.saved(other, "--subject", "textbook", "--profile", "vulkan")
        self.assertEqual(case["scene"]["triangles"], SQUARE["triangles"])
        self.assertEqual(case["subject"], "textbook")
        # Its facings go by the place in the list: of two triangles one alone has another place.
        case, _, again = self.saved(self.scene, "--subject", "mutant:vulkan-facing-by-place",
                                    "--profile", "vulkan")
        self.assertIn("vulkan.facing", again)
        self.assertEqual(case["scene"]["triangles"], SQUARE["triangles"])

    def test_a_fault_of_a_saved_drawing_is_named(self):
        twice = self.drawn("vulkan-canonical")
        twice[1][1] = 2
        case, _, _ = self.saved(self.scene, self.as_text(twice), "--profile", "vulkan")
        numbers = case["drawing"]["numbers"]
        for change, names in (
                ({"numbers": numbers[1:]}, ["drawing.numbers", "3 rows", "4"]),
                ({"numbers": [row[1:] for row in numbers]}, ["drawing.numbers", "12 numbers"]),
                ({"numbers": [numbers[0][1:], *numbers[1:]]}, ["drawing.numbers[1]", "4 numbers"]),
                ({"numbers": [[-1] * 4] * 4}, ["drawing.numbers[0][0]"]),
                ({"shows": "ids", "numbers": [[3] * 4] * 4}, ["column 0 row 0", "id is 3"]),
                ({"shows": "colours"}, ["drawing.shows", "colours"]),
                ({"shows": "mask", "fronts": NO_FRONT}, ["drawing.fronts", "no facings"]),
                ({"fronts": [[2] * 4] * 4}, ["drawing.fronts: column 0 row 0", "2 front-facing"])):
            broken = dict(case, drawing=dict(case["drawing"], **change))
            self.refused("legal", self.write("broken.json", json.dumps(broken)),
                         names=["broken.json", *names])
        culls = dict(case, options={"cull": "back"})
        self.refused("legal", self.write("culls.json", json.dumps(culls)),
                     names=["culls.json", "culls or has a scissor", "replay"])
        del case["drawing"]
        self.refused("legal", self.write("case.json", json.dumps(case)), names=["no drawing"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:], verbosity=0)
