#!/usr/bin/env python3
"""Unknown names and impossible folders are reported before any work, with what may be meant.

usage: names_test.py PROGRAM SOURCES
"""
import json
import os
import re
import struct
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCES = (os.path.abspath(path) for path in sys.argv[1:3])
SCENE = os.path.join(SOURCES, "scenes/drtk9.json")


def run(*arguments):
    return subprocess.run([PROGRAM, *arguments], stdin=subprocess.DEVNULL, capture_output=True,
                          text=True, cwd=SOURCES, timeout=900)  # fmt: skip


class Names(unittest.TestCase):
    def refused(self, *arguments):
        done = run(*arguments)
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertEqual(done.stdout, "")
        return done.stderr

    def told(self, *arguments):
        """Refuses all but the last of them, which its message has."""
        self.assertIn(arguments[-1], self.refused(*arguments[:-1]))

    def test_what_is_nearly_right_is_told(self):
        self.told("check", "--caes", "5", "did you mean --cases?")
        self.told("list", "mutnts", "did you mean mutants?")
        self.told("check", "--cases", "ten", "ten is no number above 0")
        self.told("check", "--subject", "lib/mine.so", "--plugin lib/mine.so")
        self.told("compare", "--mode", "ftz,daz,up,down,zero,trap")
        self.told("check", "--profile", "watertight", "--subject", "i64-snap8",
                     "it is a contract: write '{\"contract\": \"watertight\"}'")
        self.told("coverage", SCENE, "--png", "x.jpg", "name it .png or .ppm")
        with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
            file.write('{"rasterproof_scene": 1, "width": NaN}')
            file.flush()
            self.told("coverage", file.name, 'write "nan", "inf" or "-inf"')

    def test_a_profile_may_be_its_text_and_the_last_of_an_option_counts(self):
        done = run("check", "--subject", "i64-snap8", "--profile",
                   '{"name": "mine", "subpixel_bits": 8}', "--property",
                   "DegenerateTrianglesCoverNothing", "--cases", "500", "--cases", "7")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn(" 7 cases", done.stdout)

    def test_no_name_decides_by_its_beginning(self):
        for name in ("exactt", "exact-", "exact:canonical", "exact-integer"):
            for verb in (("coverage", SCENE, "--subject", "f32-direct", "--against", name),
                         ("coverage", SCENE, "--subject", name)):  # fmt: skip
                with self.subTest(verb=verb):
                    printed = self.refused(*verb)
                    self.assertIn(f"subject '{name}': there is no such subject", printed)
        self.assertIn("did you mean exact?", self.refused("coverage", SCENE, "--subject", "exactt"))
        for name in ("exact", "exact-integers", "exact-cgal"):
            done = run("coverage", SCENE, "--subject", "spans-exact", "--against", name)
            self.assertEqual(done.returncode, 0, done.stderr)

    def test_what_may_be_meant_is_said(self):
        for arguments, meant in (
            (("chek",), "check"),
            (("check", "--subject", "f32-dirct"), "f32-direct"),
            (("check", "--profile", "vulcan"), "vulkan"),
            (("check", "--property", "CoverageEqualTheModel"), "CoverageEqualsTheModel"),
            (("check", "--case", "near-egde:1@1"), "near-edge"),
            (("replay", "--subject", "f32-direct", "--case", "near-egde:1@1"), "near-edge"),
            (("certify", "--exhaustive", "pears-3x3"), "pairs-3x3"),
            (("selftest", "--only", "mutant:box-single-colum"), "mutant:box-single-column"),
        ):
            with self.subTest(arguments=arguments):
                self.assertIn(f"did you mean {meant}? ", self.refused(*arguments))
        self.assertNotIn("did you mean", self.refused("frobnicate"))

    def test_a_former_verb_says_what_to_write_now(self):
        for old, now in (("diff", "coverage SCENE --subject S --against exact"),
                         ("render", "coverage SCENE --mode flat --png FILE"),
                         ("decided", "legal SCENE --decided --profile P"),
                         ("shrink", "replay CASE --shrink FILE"),
                         ("encode", "convert FILE --to fuzz-input --subject S"),
                         ("decode", "convert FILE --to case --subject S"),
                         ("gen", "check --subject rounds:FOLDER"),
                         ("ver", "check --subject rounds:FOLDER"),
                         ("host", "pipe answer plugin:PATH"),
                         ("merge", "certify --merge PART...")):  # fmt: skip
            with self.subTest(old):
                verb, *rest = now.split()
                self.assertEqual(self.refused(old, "--help"),
                                 f"rasterproof: verb '{old}': {old} is now a part of {verb}; "
                                 f"write rasterproof {now}\n")  # fmt: skip
                printed = run(verb, *(w for w in rest if w == "answer"), "--help")
                for option in filter(lambda word: word.startswith("--"), rest):
                    self.assertIn(f"{option} ", printed.stdout.replace(",", " "))

    def test_help_has_each_verb_once_in_its_group(self):
        """The groups, and the verbs of each, are those of the tables of docs/commands.md."""
        printed = run("--help").stdout
        blocks = re.findall(r"^(\w[\w ]*):\n((?:  [a-z]\S* .*\n)+)", printed, re.M)
        groups = [(group.lower(), sorted(line.split()[0] for line in lines.splitlines()))
                  for group, lines in blocks]  # fmt: skip
        with open(os.path.join(SOURCES, "docs/commands.md"), encoding="utf-8") as file:
            tables, _, _ = file.read().partition("\n```")
        told, seen = [], set()
        table = re.compile(r"^\| (\w[\w ]*) \|.*\n\| --- .*\n((?:\|.*\n)+)", re.M)
        for title, rows in table.findall(tables):
            cells = " ".join(row.split(" | ")[0] for row in rows.splitlines())
            told.append((title, sorted(set(re.findall(r"`(\w+)", cells)) - seen)))
            seen.update(told[-1][1])
        self.assertEqual(groups, told, "a verb has a row in the table of its group")
        self.assertGreater(len(seen), 20)

    def test_keys_of_files(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "profile.json")
            for profile, meant in (({"name": "x", "tie_rul": "top-left"}, "tie_rule"),
                                   ({"name": "x", "contract": "watertigt"}, "watertight"),
                                   ("vulcan", "vulkan")):  # fmt: skip
                with open(path, "w", encoding="utf-8") as file:
                    json.dump(profile, file)
                printed = self.refused("check", "--profile", path)
                self.assertIn(f"did you mean {meant}? ", printed)

    def test_lists_of_names_are_no_wider_than_a_terminal(self):
        for arguments in (("check", "--subject", "zzzzzzzz"), ("check", "--profile", "zzzzzzzz")):
            lines = self.refused(*arguments).splitlines()
            self.assertGreater(len(lines), 3)
            for line in lines[1:]:
                self.assertLessEqual(len(line), 80)

    def test_help_names_what_fails_once(self):
        for verb in ("check", "certify"):
            printed = run(verb, "--help").stdout
            self.assertIn("{stated,quality}", " ".join(printed.split()))
            self.assertNotIn("->", printed)

    def test_a_folder_that_cannot_be_is_refused_before_the_campaign(self):
        for verb in (("check", "--subject", "spans-exact", "--cases", "2000"),
                     ("survey", "--subject", "spans-exact", "--cases", "2000")):  # fmt: skip
            printed = self.refused(*verb, "--save", "/proc/x")
            self.assertIn("/proc/x: can't be made a folder", printed)
        with tempfile.TemporaryDirectory() as folder:
            done = run("check", "--subject", "spans-exact", "--cases", "2", "--save",
                       os.path.join(folder, "a/b/c/"))  # fmt: skip
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            self.assertEqual(os.listdir(folder), [], "nothing failed, and nothing is left")


class Pictures(unittest.TestCase):
    def look(self, *arguments):
        return subprocess.run([PROGRAM, "coverage", SCENE, *arguments], capture_output=True,
                              cwd=SOURCES, timeout=900)  # fmt: skip

    def test_each_mode_is_a_picture_of_the_target(self):
        shown = [(), ("--against", "textbook")]
        shown += [("--mode", mode) for mode in ("flat", "barycentrics", "depth", "wireframe")]
        pictures = [self.look("--png", "-", *more).stdout for more in shown]
        with open(SCENE, encoding="utf-8") as file:
            scene = json.load(file)
        for picture in pictures:
            self.assertEqual(picture[:8], b"\x89PNG\r\n\x1a\n")
            self.assertEqual(struct.unpack(">II", picture[16:24]),
                             (scene["width"], scene["height"]))  # fmt: skip
        self.assertEqual(len(set(pictures)), len(pictures))
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "difference.png")
            printed = self.look("--against", "textbook", "--png", path)
            self.assertIn(b"\nmissing ", printed.stdout)
            with open(path, "rb") as file:
                self.assertEqual(file.read(), pictures[1])

    def test_what_does_not_go_together_is_refused(self):
        for more in (("--mode", "depth"), ("--png", "-", "--mode", "depth", "--against", "exact"),
                     ("--png", "-", "-o", "rows"),
                     ("--png", "-", "--mode", "depth", "--subject", "exact")):  # fmt: skip
            refused = self.look(*more)
            self.assertEqual((refused.returncode, refused.stdout), (2, b""), more)

    def test_the_guilty_pair_stands_first(self):
        done = run("explain", SCENE, "--subject", "f32-direct-fma")
        lines = [line for line in done.stdout.splitlines() if ": E = " in line]
        named = [line.split(",")[0] for line in lines]
        self.assertEqual(named[:6], ["triangle 2"] * 3 + ["triangle 3"] * 3, done.stdout)
        # The sample lies 2^-34 off the edge that they share.
        self.assertIn("triangle 2, edge v2-v0: E = -1/17179869184", lines)
        self.assertIn("triangle 3, edge v0-v1: E = 1/17179869184", lines)


class Plan(unittest.TestCase):
    def why(self, **profile):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "profile.json")
            with open(path, "w", encoding="utf-8") as file:
                json.dump({"name": "x", **profile}, file)
            done = run("plan", os.path.join(SOURCES, "scenes/ties.json"), "--profile", path)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done.stdout

    def test_it_says_only_what_the_profile_states(self):
        fixed = {"integer_bits": 11, "fraction_bits": 4, "signed": True, "wrap": False}
        printed = self.why(fixed=fixed)
        self.assertIn("takes integers of 11.4 bits", printed)
        self.assertNotIn("wraps", printed)
        self.assertNotIn("drops", printed)
        printed = self.why(fixed={**fixed, "wrap": True})
        self.assertIn("wraps coordinates of 11.4 bits", printed)
        self.assertNotIn("drops", printed)
        printed = self.why(max_primitive_extent=[1023, 511])
        self.assertIn("drops large triangles", printed)
        self.assertNotIn("wraps", printed)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
