#!/usr/bin/env python3
"""`bench` as it is typed: scenes, a plugin, data, a picture, bad options; no times.

usage: bench_command_test.py PROGRAM SOURCES EXAMPLES
"""
import base64
import html
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
import xml.dom.minidom

PROGRAM, SOURCES, EXAMPLES = (os.path.abspath(path) for path in sys.argv[1:4])
# Draws nothing, and takes repeats.
BLANK = """
import sys
for line in iter(sys.stdin.readline, ""):
    words = line.split()
    if not words or words[0] != "draw":
        continue
    for _ in range(int(words[6]) + int(words[7])):
        sys.stdin.readline()
    if len(sys.argv) == 1:  # as often as it is told to
        for word in words:
            if word.startswith("repeats="):
                for _ in range(int(word[8:])):
                    sum(range(20000))
    row = " ".join(["0"] * (int(words[2]) * int(words[4]))) + "\\n"
    sys.stdout.write("counts " + words[1] + "\\n" + row * int(words[3]))
    sys.stdout.flush()
"""
FEW = ("--budget", "0.1s", "--subject", "textbook", "--subject", "kernel-exact")


def bench(*arguments):
    return subprocess.run([PROGRAM, "bench", *arguments], cwd=SOURCES, timeout=900,
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
                                     "kernel-exact", "spans-known"})  # fmt: skip
        self.assertGreater(rows["textbook"]["real"]["unexpected"], 0)
        self.assertGreater(rows["textbook"]["overlaps"], 0)
        self.assertEqual(rows["kernel-exact"]["drawing_wrong"], 0)
        for row in rows.values():
            # At least as many as an interval needs; how many more is a matter of time.
            self.assertGreaterEqual(len(row["runs"]), 6)
            low, median, high = row["ratio"]
            self.assertLessEqual(low, median)
            self.assertLessEqual(median, high)
        for key in ("processor", "compiler", "flags", "command", "date"):
            self.assertTrue(result[key], key)
        for key in ("load_before", "load_after"):
            self.assertGreaterEqual(result[key], 0, key)
        self.assertEqual(rows["spans-known"]["drawing_wrong"], 0)
        self.assertTrue(all(claim["sentence"] for claim in result["claims"]))

    def test_kernels_draw_by_the_instruction_set_asked_for(self):
        result = measured("--scene", "scenes/ties.json", *FEW, "--target", "scalar")
        self.assertEqual({row["target"] for row in result["rows"]}, {"compiler", "scalar"})
        done = bench("--scene", "scenes/ties.json", *FEW, "--target", "mmx")
        self.assertEqual(done.returncode, 2)
        self.assertIn("scalar", done.stderr)

    def test_what_a_plugin_was_compiled_for_is_read_from_its_file(self):
        with tempfile.TemporaryDirectory() as folder:
            plugin = os.path.join(folder, "mine.so")
            shutil.copy(os.path.join(EXAMPLES, "example_plugin.so"), plugin)
            with open(plugin, "ab") as file:
                file.write(b"GNU C++20 12.2.0 -march=x86-64-v3 -O3\0")
            result = measured("--scene", "scenes/ties.json", *FEW, "--plugin", plugin)
        method = next(one for one in result["methods"] if one["users"])
        self.assertEqual(method["march"], "x86-64-v3")
        self.assertEqual(method["traversal"], "its own")

    def test_a_plugin_is_timed_less_what_is_converted(self):
        plugin = os.path.join(EXAMPLES, "example_plugin.so")
        result = measured("--scene", "scenes/ties.json", *FEW, "--plugin", plugin)
        method = next(one for one in result["methods"] if one["users"])
        self.assertEqual(method["name"], "example_plugin.so")
        row = next(row for row in result["rows"] if row["method"] == method["name"])
        self.assertGreater(row["conversion_seconds"], 0)
        self.assertEqual(row["drawing_wrong"], 0)

    def test_the_kernel_behind_the_interface_of_plugins_draws_what_the_kernel_draws(self):
        plugin = os.path.join(EXAMPLES, "../test_plugins/kernel.so")
        result = measured("--scene", "scenes/glyphs.json", *FEW, "--plugin", plugin)
        row = next(row for row in result["rows"] if row["method"] == "kernel.so")
        self.assertEqual(row["drawing_wrong"], 0)
        self.assertEqual(row["real"]["missing"] + row["real"]["unexpected"], 0)
        self.assertGreater(row["judged_triangles"], 0)

    def test_a_program_is_timed_by_repeats_and_left_out_if_it_breaks_down(self):
        with tempfile.TemporaryDirectory() as folder:
            program = os.path.join(folder, "blank.py")
            with open(program, "w", encoding="utf-8") as file:
                file.write(BLANK)
            said = os.path.join(folder, "blank.subject")
            with open(said, "w", encoding="utf-8") as file:
                file.write(f"command {sys.executable} {program}\ntakes window repeats\n")
            path = os.path.join(folder, "bench.json")
            done = bench("--scene", "scenes/ties.json", *FEW, "--subject", said, "--exec", "false",
                         "--json", path)  # fmt: skip
            self.assertEqual(done.returncode, 4, done.stderr)  # one of the user's has no row
            with open(path, encoding="utf-8") as file:
                result = json.load(file)
        method = next(one for one in result["methods"] if one["name"] == said)
        self.assertEqual((method["clock"], method["times_requests"]), ("program", False))
        row = next(row for row in result["rows"] if row["method"] == said)
        self.assertGreater(row["real"]["missing"], 0)
        self.assertEqual(row["real"]["unexpected"], 0)
        out = [one for one in result["left_out"] if one["method"] == "exec:false"]
        self.assertEqual(len(out), 1)
        self.assertIn("status 1", out[0]["why"])

    def test_a_program_that_says_it_repeats_and_does_not_is_left_out(self):
        with tempfile.TemporaryDirectory() as folder:
            program = os.path.join(folder, "blank.py")
            with open(program, "w", encoding="utf-8") as file:
                file.write(BLANK)
            said = os.path.join(folder, "once.subject")
            with open(said, "w", encoding="utf-8") as file:
                file.write(f"name liar\ncommand {sys.executable} {program} once\n"
                           "takes window repeats\n")  # fmt: skip
            done = bench("--scene", "scenes/ties.json", *FEW, "--subject", said)
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertIn("liar is left out: its answer to 1024 draws takes no longer than to one",
                      done.stdout)  # fmt: skip

    def test_what_the_budget_has_no_time_for_is_said(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "bench.json")
            done = bench("--family", "ties", "--family", "glyphs", "--family", "mesh", *FEW,
                         "--json", path)  # fmt: skip
            again = bench("--from", path)
            with open(path, encoding="utf-8") as file:
                result = json.load(file)
        measured = [family["name"] for family in result["families"]]
        lacking = ["families: " + name for name in ("mesh", "ties", "glyphs")
                   if name not in measured]  # fmt: skip
        self.assertTrue(lacking, done.stdout)
        self.assertEqual(len(result["not_measured"]), len(lacking))
        for said, name in zip(result["not_measured"], lacking):
            self.assertRegex(said, name + r" with [0-9.]+ s left, of which one takes [0-9.]+$")
        said = "Not measured, for want of time: families ("
        self.assertIn(said, done.stdout)
        self.assertIn(said, again.stdout)

    def test_a_plugin_that_crashes_is_left_out_and_ends_nothing(self):
        plugin = os.path.join(EXAMPLES, "../test_plugins/buggy_CRASH.so")
        done = bench("--scene", "scenes/ties.json", *FEW, "--plugin", plugin)
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertIn("buggy_CRASH.so is left out: it was killed by signal 11", done.stdout)
        self.assertIn("kernel-exact", done.stdout)

    def test_a_place_that_cannot_be_written_is_reported_first(self):
        done = bench("--scene", "scenes/ties.json", "--budget", "1h", "--json", "/proc/x/y.json")
        self.assertEqual(done.returncode, 2, done.stderr)

    def test_a_run_is_read_again_and_compared_with_an_earlier_one(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "bench.json")
            done = bench("--scene", "scenes/ties.json", *FEW, "--json", path)
            self.assertEqual(done.returncode, 0, done.stderr)
            same = bench("--from", path, "--against", path)
            self.assertEqual(same.returncode, 0, same.stderr)
            with open(path, encoding="utf-8") as file:
                result = json.load(file)
            self.assertIn(f"{len(result['rows'])} rows compared", same.stdout)
            for row in result["rows"]:
                if row["method"] == "kernel-exact":
                    row["real"]["unexpected"] += 1
            worse = os.path.join(folder, "worse.json")
            with open(worse, "w", encoding="utf-8") as file:
                json.dump(result, file)
            done = bench("--from", worse, "--against", path)
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertIn("more wrong: ties: kernel-exact", done.stdout)
            self.assertEqual(bench("--from", path, "--against", "none.json").returncode, 2)

    def test_plan_names_a_method_for_an_error(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "bench.json")
            bench("--scene", "scenes/ties.json", *FEW, "--json", path)
            plan = lambda *more: subprocess.run(  # noqa: E731
                [PROGRAM, "plan", "scenes/ties.json", *more], cwd=SOURCES, text=True,
                stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=900)  # fmt: skip
            done = plan("--error", "0", "--bench", path)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("method      kernel-exact", done.stdout)
            for arguments in (("--error", "0"), ("--error", "-1", "--bench", path),
                              ("--error", "1", "--bench", "scenes/ties.json")):  # fmt: skip
                self.assertEqual(plan(*arguments).returncode, 2, arguments)
    def test_values_are_measured_recorded_and_read_again(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "values.json")
            done = bench("--values", "--family", "cancelling", "--family", "w-20", "--json", path)
            if "no AVX2" in done.stderr:
                self.skipTest("no AVX2")
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(path, encoding="utf-8") as file:
                record = json.load(file)
            rows = record["value_rows"]
            self.assertEqual({row["family"] for row in rows}, {"cancelling", "w-20"})
            nearest = [row for row in rows if row["method"] == "library-nearest"]
            self.assertEqual(len(nearest), 2)
            self.assertTrue(all(row["ulps"] <= 0.5 for row in nearest))
            for row in rows:
                if isinstance(row["share_of_bound"], float):
                    self.assertLessEqual(row["share_of_bound"], 1, row["method"])
            for advice in ("Differences from one vertex", "one Newton step", "in double",
                           "Derivatives by differences"):  # fmt: skip
                self.assertIn(advice, done.stdout)
            self.assertEqual(bench("--from", path).stdout, done.stdout)
            certify = [PROGRAM, "certify", "--subject", "spans-exact", "--cases", "1",
                       "--out", folder, "--bench", path]  # fmt: skip
            done = subprocess.run(certify, cwd=SOURCES, capture_output=True, text=True,
                                  timeout=900)  # fmt: skip
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(os.path.join(folder, "report.html"), encoding="utf-8") as file:
                page = html.unescape(re.sub("</?span>", "", file.read()))
            section = page[page.index('id="interpolation"'):]
            self.assertIn("library-nearest", section)

    def test_growth_is_measured_and_recorded(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "growth.json")
            more = ("--growth", "--budget", "1s", "--json", path)
            done = bench(*more)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("costs over triangles from", done.stdout)
            self.assertEqual(bench("--growth", "--from", path).returncode, 2)
            done = bench("--growth", "--subject", "library", "--json", path)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("Threads of the library", done.stdout)
            with open(path, encoding="utf-8") as file:
                result = json.load(file)
            curves = {(one["method"], one["sink"], one["parameter"]) for one in result["curves"]}
            self.assertEqual(len(curves), len(result["curves"]))
            self.assertIn(("library", "mask", "threads"), curves)

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

    def test_the_page_begins_with_it_and_its_commands_show_what_is_wrong(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "bench.json")
            done = bench("--scene", "scenes/ties.json", *FEW, "--json", path)
            self.assertEqual(done.returncode, 0, done.stderr)
            certify = [PROGRAM, "certify", "--subject", "spans-exact", "--cases", "1",
                       "--out", folder]  # fmt: skip
            done = subprocess.run([*certify, "--bench", path], cwd=SOURCES, capture_output=True,
                                  text=True, timeout=900)  # fmt: skip
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(os.path.join(folder, "report.html"), encoding="utf-8") as file:
                page = html.unescape(re.sub("</?span>", "", file.read()))
            self.assertLess(page.index('id="which"'), page.index('id="verdicts"'))
            command = re.search(r"rasterproof (explain \S+ties-textbook[^<]*)", page)[1].split()
            done = subprocess.run([PROGRAM, *command], capture_output=True, text=True, timeout=900)
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertIn("samples differ", done.stdout)

            with open(path, encoding="utf-8") as file:
                old = file.read().replace('"rasterproof_bench": 3', '"rasterproof_bench": 2')
            with open(path, "w", encoding="utf-8") as file:
                file.write(old)
            for more in ((), ("--shard", "1/2")):
                done = subprocess.run([*certify, "--bench", path, *more], cwd=SOURCES,
                                      capture_output=True, text=True, timeout=900)  # fmt: skip
                self.assertEqual(done.returncode, 2)
                self.assertIn("give it to --merge" if more else "measure again", done.stderr)

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
            (("--subject", "f32"), "bench has no such method"),
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
