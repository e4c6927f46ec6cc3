"""Resolved pictures, k of n samples a pixel, are judged by what legal models cover least and most.

usage: resolved_test.py PROGRAM
"""
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.path.abspath(sys.argv[1])
WIDTH, HEIGHT, SAMPLES = 6, 5, 4
SCENE = json.dumps({"rasterproof_scene": 1, "width": WIDTH, "height": HEIGHT,
                    "vertices": [[0.5, 0.25], [5.25, 1.5], [1.5, 4.75]],
                    "triangles": [[0, 1, 2]]})  # fmt: skip


def run(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, check=False)


class Resolved(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.scene = self.write("scene.json", SCENE)
        decided = json.loads(run("legal", self.scene, "--decided", "--profile", "d3d11-4x",
                                 "--json", "-").stdout)  # fmt: skip
        self.assertEqual(decided["least"], decided["most"])
        self.right = [sum(decided["least"][k:k + SAMPLES])
                      for k in range(0, len(decided["least"]), SAMPLES)]  # fmt: skip
        self.assertEqual(set(self.right), {0, 1, 2, 3, 4})

    def write(self, name, content):
        path = os.path.join(self.folder.name, name)
        with open(path, "wb" if isinstance(content, bytes) else "w") as file:
            file.write(content)
        return path

    def rows(self, covered):
        lines = [covered[k:k + WIDTH] for k in range(0, len(covered), WIDTH)]
        return self.write("rows.txt", "".join(" ".join(map(str, line)) + "\n" for line in lines))

    def pgm(self, covered, white=255, rounded=round):
        levels = [rounded(n * white / SAMPLES) for n in covered]
        size = 1 if white < 256 else 2
        return self.write("picture.pgm", f"P5 {WIDTH} {HEIGHT} {white}\n".encode() +
                          b"".join(level.to_bytes(size, "big") for level in levels))  # fmt: skip

    def legal(self, image, profile="d3d11-4x", *more):
        return run("legal", self.scene, image, "--resolved", "--profile", profile, *more)

    def test_a_right_picture_is_legal_in_every_form(self):
        for image in (self.rows(self.right), self.pgm(self.right), self.pgm(self.right, 65535),
                      self.pgm(self.right, rounded=int)):  # fmt: skip
            done = self.legal(image)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertTrue(done.stdout.startswith("legal: profile d3d11-4x; all 30 pixels"))

    def test_one_sample_more_or_less_is_not(self):
        for pixel, count in enumerate(self.right):
            wrong = list(self.right)
            wrong[pixel] = count + 1 if count < SAMPLES else count - 1
            done = self.legal(self.pgm(wrong))
            self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
            self.assertIn(f"column {pixel % WIDTH} row {pixel // WIDTH}: {wrong[pixel]} of 4 "
                          f"samples are covered, in legal models {count} of 4", done.stdout)
        told = json.loads(self.legal(self.pgm(wrong), "d3d11-4x", "--json", "-").stdout)
        self.assertEqual(told["verdict"], "not legal")
        self.assertEqual(told["wrong"], [{"column": WIDTH - 1, "row": HEIGHT - 1, "covered": 1}])

    def test_a_mask_is_an_array_in_the_language_of_its_file(self):
        masks = {}
        for ending in ("h", "ts", "py"):
            path = os.path.join(self.folder.name, "mask." + ending)
            done = run("legal", self.scene, "--decided", "--profile", "webgpu", "--mask", path)
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(path, encoding="utf-8") as file:
                masks[ending] = file.read()
        names = {}
        exec(masks["py"], names)
        mask = [list(row) for row in names["mask"]]
        self.assertEqual((len(mask), {len(row) for row in mask}), (HEIGHT, {WIDTH}))
        self.assertLessEqual({128, 0, 255}, {level for row in mask for level in row})
        self.assertIn(f"constexpr unsigned char kMask[][{WIDTH}] = {{\n", masks["h"])
        for ending in ("h", "ts"):
            rows = re.findall(r"^    [{\[](.*)[}\]],$", masks[ending], re.M)
            self.assertEqual([list(map(int, row.split(", "))) for row in rows], mask)

    def test_a_picture_has_pixel_numbers_and_a_legend_where_there_is_room(self):
        def size(scale):
            path = os.path.join(self.folder.name, "decided.ppm")
            run("legal", self.scene, "--decided", "--profile", "webgpu", "--png", path, "--scale",
                str(scale))  # fmt: skip
            with open(path, "rb") as file:
                return tuple(map(int, file.read().split()[1:3]))

        self.assertEqual(size(7), (7 * WIDTH, 7 * HEIGHT))
        width, height = size(40)
        self.assertGreater(width, 40 * WIDTH)
        self.assertGreater(height, 40 * HEIGHT + 30)

    def test_a_saved_drawing_is_not_explained_by_another_subject(self):
        wrong = self.write("wrong.txt", "\n".join(" ".join("1" * WIDTH) for _ in range(HEIGHT)))
        core = os.path.join(self.folder.name, "core.json")
        done = run("legal", self.scene, wrong, "--profile", "vulkan", "--save", core)
        self.assertEqual(done.returncode, 1, done.stderr)
        refused = run("replay", core)
        self.assertEqual(refused.returncode, 2, refused.stdout)
        self.assertIn(f"judge the drawing by 'rasterproof legal {core}'", refused.stderr)
        shown = run("explain", core)
        self.assertEqual(shown.returncode, 1, shown.stderr)
        self.assertIn("not legal: profile vulkan; ", shown.stdout)
        self.assertNotIn("exact holds", shown.stdout)
        self.assertNotRegex(shown.stdout, r"(?m)^ *\d+ .*!")  # facings are not seen
        self.assertEqual(run("legal", core, "--profile", "vulkan").returncode, 1)
        self.assertEqual(run("explain", core, "--subject", "spans-exact").returncode, 0)

    def test_what_is_open_is_not_told_as_legal(self):
        done = self.legal(self.pgm(self.right), "webgpu-4x")
        self.assertEqual(done.returncode, 4, done.stdout + done.stderr)
        self.assertRegex(done.stdout, r"not judged: .*; legal models differ on \d+ of 30 pixels")
        outside = [4] * len(self.right)
        self.assertEqual(self.legal(self.pgm(outside), "webgpu-4x").returncode, 1)

    def test_a_picture_that_can_not_be_one_is_refused_with_its_place(self):
        levels = bytes([100] * (WIDTH * HEIGHT))
        cases = {
            self.write("a.pgm", b"P5 6 5 255\n" + levels): "level 100 of 255 is not a share of 4",
            self.write("b.ppm", b"P6 6 5 255\n" + levels * 2 + bytes([0, 64, 0]) * 10):
                "the level 100",
            self.write("c.ppm", b"P6 6 5 255\n" + bytes([0, 64, 0]) * 30): "it has a colour",
            self.rows([5] * 30): "5 samples are covered, and a pixel has 4"}  # fmt: skip
        for image, words in cases.items():
            done = self.legal(image)
            self.assertEqual(done.returncode, 2, done.stdout)
            self.assertIn("column 0", done.stderr)
            self.assertIn(words, done.stderr)
        done = self.legal(self.pgm(self.right), "gl-4x")
        self.assertEqual(done.returncode, 2)
        self.assertIn("does not state where samples lie", done.stderr)
        self.assertEqual(run("legal", self.scene, "--resolved", "--profile", "d3d11-4x").returncode,
                         2)  # fmt: skip


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
