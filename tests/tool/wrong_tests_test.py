"""What docs/wrong-tests.md says of published tests. Its commands are run by scripts/check_readme.

usage: wrong_tests_test.py PROGRAM SOURCES
"""
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.path.abspath(sys.argv[1])
SOURCES = pathlib.Path(os.path.abspath(sys.argv[2]))
FOLDER = SOURCES / "docs" / "wrong-tests"
# The samples that VK-GL-CTS 165 names, as columns and rows.
NAMED = [(111, 44), (60, 107)]


def run(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, cwd=FOLDER, timeout=900,
                          text=True)  # fmt: skip


def decided(scene, profile):
    result = run("legal", scene, "--decided", "--profile", profile, "--json", "-")
    assert result.returncode == 0, result.stderr
    return json.loads(result.stdout)


def rows(scene, profile):
    return [line.split() for line in
            run("coverage", scene, "--profile", profile).stdout.splitlines()]  # fmt: skip


class WrongTestsTest(unittest.TestCase):
    def test_the_scenes_are_what_the_script_writes(self):
        with tempfile.TemporaryDirectory() as folder:
            shutil.copy(FOLDER / "make_scenes.py", folder)
            subprocess.run([sys.executable, "make_scenes.py"], cwd=folder, check=True)
            scenes = sorted(pathlib.Path(folder).glob("*.json"))
            self.assertEqual(len(scenes), 6)
            for scene in scenes:
                self.assertEqual(scene.read_bytes(), (FOLDER / scene.name).read_bytes())

    def test_what_mends_the_webgpu_test_depends_on_bits_and_rounding(self):
        is_open = {(scene, profile): decided(f"gpuweb_cts_4638{scene}.json", profile)["open"] == 1
                   for scene in ("", "_mended", "_any")
                   for profile in ("six_bits.json", "six_bits_any.json", "vulkan", "webgpu")}
        still_open = {key for key, value in is_open.items() if value}
        self.assertEqual(still_open, {
            ("", "six_bits.json"), ("", "six_bits_any.json"), ("", "vulkan"), ("", "webgpu"),
            ("_mended", "six_bits_any.json"), ("_mended", "vulkan"), ("_mended", "webgpu"),
            # Its corners leave the target: a clip may move its edges by less than a pixel.
            ("_any", "webgpu")})

    def test_the_samples_that_the_vulkan_issue_names_are_open(self):
        first = decided("vk_gl_cts_165_first.json", "vulkan")
        places = [(may["column"], may["row"]) for may in first["may"]]
        self.assertEqual(len(places), 14)
        self.assertLessEqual(set(NAMED), set(places))
        may = [[column + 128 * row, 1] for column, row in places]
        self.assertEqual(first["triangles"][0]["may"], may)

    def test_nearest_and_truncation_decide_them_as_the_issue_says(self):
        nearest = rows("vk_gl_cts_165_first.json", "six_bits.json")
        truncated = rows("vk_gl_cts_165_first.json", "six_bits_truncated.json")
        differ = [(x, y) for y in range(128) for x in range(128)
                  if nearest[y][x] != truncated[y][x]]  # fmt: skip
        self.assertEqual(differ, NAMED)
        self.assertEqual([nearest[y][x] for x, y in NAMED], ["1", "0"])
        with tempfile.TemporaryDirectory() as folder:
            for drawn in (nearest, truncated):
                path = pathlib.Path(folder) / "counts.txt"
                path.write_text("\n".join(map(" ".join, drawn)), encoding="utf-8")
                legal = run("legal", "vk_gl_cts_165_first.json", str(path), "--profile", "vulkan")
                self.assertEqual(legal.returncode, 0, legal.stdout)

    def test_all_of_the_hlsl_test_is_decided_and_its_tolerance_forgives_what_is_wrong(self):
        whole = decided("offload_441.json", "vulkan")
        self.assertEqual((whole["open"], whole["bounded"]), (0, 0))
        self.assertLessEqual(126, 256 * 256 * 0.2 / 100)
        narrow = run("legal", "offload_441.json", "offload_441_narrow.png", "--profile", "vulkan")
        self.assertEqual(narrow.returncode, 1, narrow.stderr)
        self.assertIn("0 samples are open", narrow.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=0)
