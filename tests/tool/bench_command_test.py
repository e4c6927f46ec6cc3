#!/usr/bin/env python3
"""`bench` as it is typed: scenes, a plugin, data, a picture, bad options; no times.

usage: bench_command_test.py PROGRAM SOURCES EXAMPLES
"""
import html
import json
import os
import re
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

    def test_the_page_begins_with_it_and_its_commands_show_what_is_wrong(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "bench.json")
            done = bench("--scene", "scenes/ties.json", *FEW, "--json", path)
            self.assertEqual(done.returncode, 0, done.stderr)
            certify = [PROGRAM, "certify", "--subject", "spans-exact", "--cases", "1",
                       "--out", folder]  # fmt: skip
            done = subprocess.run([*certify, "--bench", path], cwd=SOURCES, capture_output=True,
                                  text=True, timeout=200)  # fmt: skip
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(os.path.join(folder, "report.html"), encoding="utf-8") as file:
                page = html.unescape(re.sub("</?span>", "", file.read()))
            self.assertLess(page.index('id="which"'), page.index('id="verdicts"'))
            command = re.search(r"rasterproof (explain \S+ties-textbook[^<]*)", page)[1].split()
            done = subprocess.run([PROGRAM, *command], capture_output=True, text=True, timeout=60)
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertIn("samples differ", done.stdout)

            with open(path, encoding="utf-8") as file:
                old = file.read().replace('"rasterproof_bench": 3', '"rasterproof_bench": 2')
            with open(path, "w", encoding="utf-8") as file:
                file.write(old)
            for more in ((), ("--shard", "1/2")):
                done = subprocess.run([*certify, "--bench", path, *more], cwd=SOURCES,
                                      capture_output=True, text=True, timeout=60)  # fmt: skip
                self.assertEqual(done.returncode, 2)
                self.assertIn("a page is made" if more else "measure again", done.stderr)

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
