"""legal: what its verdict says was compared, and what it lets one suspect.

usage: legal_hints_test.py PROGRAM SOURCES
"""
import json
import sys
import unittest
import xml.etree.ElementTree

from legal_case import SQUARE, LegalCase, png, run


class LegalHintsTest(LegalCase):
    def test_ids_that_no_model_shows_are_told_with_those_that_one_does(self):
        # Both triangles cover the first row; the second is drawn last.
        scene = dict(SQUARE, triangles=[[0, 1, 2], [0, 1, 2]])
        self.scene = self.write("over.json", json.dumps(scene))
        shown = self.as_text([[1, 1, 0, 0], [0, 2, 2, 0], [0, 0, 2, 2], [0, 0, 0, 0]])
        for visible, told in (("any", ("2 row 0: shows no triangle; legal: 0 or 1\n",)),
                              ("last", ("1 row 0: shows triangle 0; legal: 1\n",
                                        "2 row 0: shows no triangle; legal: 1\n")),
                              ("first", ("2 row 1: shows triangle 1; legal: 0\n",))):
            done = self.legal(shown, "vulkan", "--ids", "--visible", visible)
            self.assertEqual(done.returncode, 1)
            for one in told:
                self.assertIn("  column " + one, done.stdout)
            self.assertIn("column 3 row 2: no legal model lets any triangle", done.stdout)

    def test_ids_that_are_counted_from_0_are_suspected(self):
        right = [[1, 1, 1, 0], [2, 1, 1, 0], [2, 2, 1, 0], [0, 0, 0, 0]]
        from_zero = [[max(n - 1, 0) for n in row] for row in right]
        done = self.legal(self.as_text(from_zero), "vulkan", "--ids", "--json",
                          self.path("out.json"))  # fmt: skip
        self.assertEqual(done.returncode, 1)
        self.assertIn("hint: the numbers would name triangles that cover their samples if they "
                      "were counted from 0: write 1 +", done.stdout)
        with open(self.path("out.json")) as file:
            self.assertEqual(len(json.load(file)["hints"]), 1)
        for row, column, number in ((0, 0, 0), (3, 3, 1), (3, 3, 2)):
            wrong = [list(r) for r in right]
            wrong[row][column] = number
            done = self.legal(self.as_text(wrong), "vulkan", "--ids")
            self.assertEqual(done.returncode, 1)
            self.assertNotIn("hint:", done.stdout)
        blank = self.legal(self.as_text([[0] * 4] * 4), "vulkan", "--ids")
        self.assertEqual(blank.returncode, 1)
        self.assertNotIn("hint:", blank.stdout)
        self.assertNotIn("hint:", self.legal(self.as_text(right), "vulkan", "--ids").stdout)

    def test_a_background_of_another_colour_is_suspected(self):
        picture = self.path("white.png")
        self.assertEqual(run("coverage", self.scene, "--png", picture).returncode, 0)
        done = self.legal(picture, "vulkan")
        self.assertEqual(done.returncode, 1)
        self.assertIn("hint: all 16 pixels differ from the background 000000; a corner is ffffff: "
                      "give --background ffffff\n", done.stdout)
        self.assertEqual(self.legal(picture, "vulkan", "--background", "ffffff").returncode, 0)
        done = self.listed({"name": "white", "scene": "scene.json", "image": "white.png",
                            "profile": "vulkan"})  # fmt: skip
        self.assertIn("; hint: all 16 pixels differ", done.stdout)
        rows = [[16 + 100 * bool(n) for n in row] for row in self.drawn("vulkan-canonical")]
        rows[3][2] = 0
        grey = self.legal(self.write("grey.png", png(rows)), "vulkan")
        self.assertIn("hint: 15 of 16 pixels differ from the background 000000; a corner is 101010",
                      grey.stdout)
        for head, channels in ((b"P5 4 4 255\n", 1), (b"P6 4 4 255\n", 3)):
            body = bytes(n for row in rows for n in row for _ in range(channels))
            done = self.legal(self.write("grey.pnm", head + body), "vulkan")
            self.assertIn("a corner is 101010: give --background 101010", done.stdout)
        # The background is right; one of the samples is wrong, and the corners are covered.
        rows = [[200 * bool(n) for n in row] for row in self.drawn("vulkan-canonical")]
        rows[1][1], rows[3][0] = 0, 200
        done = self.legal(self.write("wrong.png", png(rows)), "vulkan")
        self.assertEqual(done.returncode, 1)
        self.assertNotIn("hint:", done.stdout)

    def test_clip_space_that_is_not_scaled_to_the_viewport_is_suspected(self):
        for scale, told in ((1, True), (2, True), (2.5, False)):
            scene = dict(SQUARE, vertices=[[scale * x, scale * y, 0, 2] for x, y in
                                           ((-1, -1), (1, -1), (1, 1), (-1, 1))])  # fmt: skip
            clip = self.write("clip.json", json.dumps(scene))
            blank = self.as_text([[0] * 4] * 4)
            done = run("legal", clip, blank, "--profile", "d3d11", "--assume-transform-error", "2")
            self.assertIn(done.returncode, (0, 1), done.stderr)
            self.assertEqual("looks like normalised device coordinates" in done.stdout, told)

    def test_all_wrong_samples_are_told(self):
        rows = self.drawn("vulkan-canonical")
        rows[0] = [0] * 4
        done = self.legal(self.as_text(rows), "vulkan", "--json", self.path("out.json"))
        self.assertIn("the values of 3 samples contradict every legal model", done.stdout)
        for column in range(3):
            self.assertIn(f"  column {column} row 0: 0 of triangles", done.stdout)
        with open(self.path("out.json")) as file:
            core = json.load(file)["core"]
        self.assertEqual((core["wrong_by_themselves"], [one["index"] for one in core["samples"]]),
                         (3, [0, 1, 2]))  # fmt: skip
        side = 40
        large = {"rasterproof_scene": 1, "width": side, "height": side,
                 "vertices": [[-100, -100], [300, -100], [-100, 300]], "triangles": [[0, 1, 2]]}
        self.scene = self.write("large.json", json.dumps(large))
        done = self.legal(self.as_text([[0] * side] * side), "vulkan", "--json", "-")
        core = json.loads(done.stdout)["core"]
        self.assertEqual((core["wrong_by_themselves"], len(core["samples"])), (1600, 1000))

    def test_a_verdict_says_what_was_compared(self):
        rows = self.drawn("vulkan-canonical")
        counts = self.as_text(rows)
        picture = self.write("image.png", png([[255 * bool(n) for n in row] for row in rows]))
        once = "covered or not; double coverage is not seen"
        for drawing, told in (
                ((picture,), once + ": give counts (or --ids)"),
                ((counts,), "counts; facings are not seen"),
                ((counts, "--ids"), "ids: each covers its sample; which of several triangles is on "
                                    "top is not judged"),
                ((counts, "--ids", "--visible", "last"), "ids; of several triangles, the last "
                                                         "one's"),
                (("--subject", "i64-snap8"), "counts and facings"),
                (("--subject", "legal:vulkan-farthest-mask"), once)):
            done = run("legal", self.scene, *drawing, "--profile", "vulkan", "--json",
                       self.path("out.json"))
            self.assertIn(f"\ncompared: {told}\n", done.stdout, done.stderr)
            with open(self.path("out.json")) as file:
                self.assertEqual(json.load(file)["compared"], told)
        entry = {"name": "shown", "scene": "scene.json", "image": "image.png", "profile": "vulkan"}
        done = self.listed(entry, options=("--junit", self.path("out.xml")))
        self.assertIn("compared: " + once, done.stdout)
        (case,) = xml.etree.ElementTree.parse(self.path("out.xml")).getroot().iter("testcase")
        self.assertIn("compared: " + once, case.find("system-out").text)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=0)
