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
    def rows(self, name, rows):
        return self.write(name, "\n".join(" ".join(map(str, row)) for row in rows))

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
                     "--facings", none, names=["--facings", "its own facings"])

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


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=0)
