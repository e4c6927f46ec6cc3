#!/usr/bin/env python3
"""`bench` as it is typed: scenes, a plugin, data, a picture, bad options; no times.

usage: bench_command_test.py PROGRAM SOURCES EXAMPLES
"""
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

    def test_limits_are_cases_that_replay(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "limits.json")
            cases = os.path.join(folder, "cases")
            done = bench("--limits", "--subject", "f32-direct", "--json", path, "--save", cases)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("proved to 4096, first seen failing at 4098", done.stdout)
            with open(path, encoding="utf-8") as file:
                result = json.load(file)
            cliffs = {one["parameter"]: one for one in result["cliffs"]}
            self.assertEqual(cliffs["values"]["first_failing"], 4097)
            self.assertEqual(cliffs["grid-8"]["proved_to"], 4096)
            for curve in result["curves"]:
                self.assertEqual(curve["method"], "f32-direct")
                self.assertTrue(curve["points"], curve["parameter"])
            case = os.path.join(cases, "f32-direct-grid-8.json")
            replayed = subprocess.run([PROGRAM, "replay", case], stdout=subprocess.PIPE, text=True)
            self.assertEqual(replayed.returncode, 1, replayed.stdout)

    def test_limits_of_a_plugin_are_sought_in_its_own_process(self):
        plugin = os.path.join(EXAMPLES, "example_plugin.so")
        done = bench("--limits", "--plugin", plugin)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("grid-8", done.stdout)
        self.assertNotIn("f32-direct", done.stdout)

    def test_the_picture_is_a_picture_that_names_every_point(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "bench.svg")
            done = bench("--scene", "scenes/ties.json", *FEW, "--svg", path)
            self.assertEqual(done.returncode, 0, done.stderr)
            titles = xml.dom.minidom.parse(path).getElementsByTagName("title")
            said = " ".join(title.firstChild.data for title in titles)
            for name in ("textbook", "f32-incremental", "kernel-exact"):
                self.assertIn(name, said)

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
