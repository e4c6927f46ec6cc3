#!/usr/bin/env python3
"""`bench` as it is typed: scenes, a plugin, data, a picture, bad options; no times.

usage: bench_command_test.py PROGRAM SOURCES EXAMPLES
"""
import base64
import json
import os
import subprocess
import sys
import tempfile
import unittest
import xml.dom.minidom

PROGRAM, SOURCES, EXAMPLES = (os.path.abspath(path) for path in sys.argv[1:4])
FEW = ("--budget", "0.1s", "--subject", "textbook", "--subject", "kernel-exact")


def bench(*arguments):
    return subprocess.run([PROGRAM, "bench", *arguments], cwd=SOURCES, timeout=200,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, text=True)  # fmt: skip


def measured(*arguments):
    with tempfile.TemporaryDirectory() as folder:
        path = os.path.join(folder, "bench.json")
        done = bench(*arguments, "--json", path)
        if done.returncode:
            raise AssertionError(done.stderr)
        with open(path, encoding="utf-8") as file:
            return json.load(file)


class Bench(unittest.TestCase):
    def test_times_and_errors_are_of_the_same_scene(self):
        result = measured("--scene", "scenes/ties.json", *FEW)
        self.assertEqual([family["name"] for family in result["families"]], ["ties"])
        rows = {row["method"]: row for row in result["rows"] if row["sink"] == "facing"}
        self.assertEqual(set(rows), {"f32-incremental", "f32-incremental again", "textbook",
                                     "kernel-exact"})  # fmt: skip
        self.assertGreater(rows["textbook"]["real"]["unexpected"], 0)
        self.assertGreater(rows["textbook"]["overlaps"], 0)
        self.assertEqual(rows["kernel-exact"]["drawing_wrong"], 0)
        for row in rows.values():
            self.assertGreaterEqual(len(row["runs"]), 9)
            low, median, high = row["ratio"]
            self.assertLessEqual(low, median)
            self.assertLessEqual(median, high)
        for key in ("processor", "compiler", "flags", "command", "date"):
            self.assertTrue(result[key], key)

    def test_a_plugin_is_timed_less_what_is_converted(self):
        plugin = os.path.join(EXAMPLES, "example_plugin.so")
        result = measured("--scene", "scenes/ties.json", *FEW, "--plugin", plugin)
        method = next(one for one in result["methods"] if one["users"])
        self.assertEqual(method["name"], "example_plugin.so")
        self.assertGreater(method["conversion_seconds"], 0)
        row = next(row for row in result["rows"] if row["method"] == method["name"])
        self.assertEqual(row["drawing_wrong"], 0)

    def test_the_picture_is_a_picture_that_names_every_point(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "bench.svg")
            done = bench("--scene", "scenes/ties.json", *FEW, "--svg", path)
            self.assertEqual(done.returncode, 0, done.stderr)
            titles = xml.dom.minidom.parse(path).getElementsByTagName("title")
            said = " ".join(title.firstChild.data for title in titles)
            for name in ("textbook", "f32-incremental", "kernel-exact"):
                self.assertIn(name, said)

    def test_fingerprints_are_pictures_and_counts_of_wrong_places(self):
        plugin = os.path.join(EXAMPLES, "example_plugin.so")
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "bench.json")
            done = bench("--fingerprint", "--subject", "f32-direct", "--subject", "textbook",
                         "--plugin", plugin, "--out", folder, "--json", path)  # fmt: skip
            self.assertEqual((done.returncode, done.stderr), (0, ""))
            with open(path, encoding="utf-8") as file:
                prints = json.load(file)["fingerprints"]
            wrong = {(one["method"], one["step"]): one["wrong"] for one in prints}
            self.assertEqual(wrong["f32-direct", "1 ulp"], 9047)
            self.assertEqual(wrong["f32-direct", "1/16"], 0)
            # Both triangles take the sample on their edge.
            self.assertEqual(wrong["textbook", "1/256"], 256)
            for one in prints:
                if one["method"].endswith(".so"):
                    self.assertIn(one["places"], (64 * 64, 32 * 32, 16 * 16, 8 * 8))
            for name in ("f32-direct-1-ulp", "textbook-1_256", "example_plugin.so-2^-12"):
                with open(os.path.join(folder, name + ".png"), "rb") as file:
                    picture = file.read()
                self.assertEqual(picture[:8], b"\x89PNG\r\n\x1a\n", name)
                self.assertIn(base64.b64encode(picture).decode(), {one["png"] for one in prints})
        self.assertRegex(done.stdout, r"f32-direct +real +9047 +0 +0 +0\n")
        self.assertEqual(bench("--out", "anywhere").returncode, 2)

    def test_names_and_times_that_are_none_are_refused(self):
        for arguments, words in (
            (("--family", "tie"), "choose of px5, px100"),
            (("--subject", "f32"), "no method that bench draws"),
            (("--budget", "soon"), "give seconds or minutes"),
            (("--budget", "-3s"), "give seconds or minutes"),
            (("--scene", "scenes/none.json"), "none.json"),
            (("--plugin", "scenes/ties.json"), "ties.json"),
        ):
            done = bench(*arguments)
            self.assertEqual(done.returncode, 2, arguments)
            self.assertEqual(done.stdout, "")
            self.assertIn(words, done.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
