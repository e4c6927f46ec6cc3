"""decided and legal: what a specification leaves open, and whether one model explains an image.

usage: legal_test.py PROGRAM SOURCES [TEST ...]
"""
import json
import os
import struct
import subprocess
import sys
import unittest
import xml.etree.ElementTree

from legal_case import SOURCES, SQUARE, LegalCase, png, run


class LegalTest(LegalCase):
    def decided(self, profile, *more):
        return run("legal", self.scene, "--decided", "--profile", profile, *more)

    def test_an_inner_sample_is_decided_though_its_owner_is_not(self):
        decided = self.decided("vulkan")
        self.assertEqual(decided.returncode, 0, decided.stderr)
        # The diagonal's samples have one owner of two; on the outline nothing lies.
        self.assertEqual(decided.stdout, "1 1 1 0\n1 1 1 0\n1 1 1 0\n0 0 0 0\n")
        open_ties = self.decided("webgpu")
        self.assertIn("?", open_ties.stdout.splitlines()[1])

    def test_what_is_open_is_reported_with_the_edge_and_its_distance(self):
        printed = json.loads(self.decided("webgpu", "--json", "-").stdout)
        self.assertEqual(printed["rasterproof_decided"], 1)
        self.assertGreater(printed["open"], 0)
        on_diagonal = [may for may in printed["may"] if may["column"] == may["row"] == 1]
        self.assertEqual({may["triangle"] for may in on_diagonal}, {0, 1})
        for may in on_diagonal:
            self.assertEqual(may["distance_pixels"], 0)
        self.assertEqual(printed["least"][5], 0)
        self.assertEqual(printed["most"][5], 2)

    def test_counts_of_a_legal_model_are_legal_and_a_lost_sample_is_not(self):
        rows = self.drawn("vulkan-canonical")
        result = self.legal(self.as_text(rows), "vulkan")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        self.assertTrue(result.stdout.startswith("legal: profile vulkan"), result.stdout)
        rows[1][1] = 2
        twice = self.legal(self.as_text(rows), "vulkan", "--save", self.path("core.json"))
        self.assertEqual(twice.returncode, 1, twice.stderr)
        self.assertIn("column 1 row 1: 2 of triangles 0, 1 cover it", twice.stdout)
        with open(self.path("core.json")) as file:
            self.assertEqual(json.load(file)["scene"]["triangles"], SQUARE["triangles"])
        self.assertEqual(self.legal(self.as_text(rows), "webgpu").returncode, 0)

    def test_an_inner_sample_that_is_lost_is_named_though_its_owner_depends_on_the_grid(self):
        square = {"rasterproof_scene": 1, "name": "square", "width": 64, "height": 64,
                  "vertices": [[3.21, 2.17], [60.83, 4.71], [58.39, 61.13], [2.57, 59.91]],
                  "triangles": [[0, 1, 2], [0, 2, 3]]}
        self.scene = self.write("square.json", json.dumps(square))
        drawn = run("coverage", self.scene, "--subject", "i32-snap4")
        rows = [[int(n) for n in line.split()] for line in drawn.stdout.splitlines()]
        legal = self.legal(self.as_text(rows), "vulkan")
        self.assertEqual(legal.returncode, 0, legal.stdout)
        self.assertNotIn("samples are open", legal.stdout)  # counted of what is not legal
        self.assertEqual(rows[30][30], 1)
        rows[30][30] = 0
        lost = self.legal(self.as_text(rows), "vulkan", "--save", self.path("core.json"))
        self.assertEqual(lost.returncode, 1)
        self.assertIn("the value of one sample contradicts every legal model", lost.stdout)
        self.assertIn("column 30 row 30: 0 of triangles", lost.stdout)
        printed = self.decided("vulkan").stderr
        number = printed.split("; ")[1].split()[0]
        self.assertIn(f"{number} samples are open", lost.stdout)
        self.assertIn("in every legal model 1 does", lost.stdout)
        with open(self.path("core.json")) as file:
            case = json.load(file)
        self.assertGreaterEqual(len(case["scene"]["triangles"]), 1)
        self.assertEqual(case["scene"]["width"], 64)
        shown = run("explain", self.path("core.json"))
        self.assertEqual(shown.returncode, 1, shown.stdout + shown.stderr)
        self.assertIn("not legal: profile vulkan; ", shown.stdout)
        self.assertNotIn("holds", shown.stdout)
        self.assertRegex(shown.stdout, r"(?m)^ *30 .*\[\.\].*\[-\]")  # not drawn, and missing

    def test_certify_judges_each_scene_of_a_legal_set(self):
        scenes = self.write("set.json", json.dumps({
            "rasterproof_scene_set": 1,
            "scenes": [{"name": name, "path": f"{SOURCES}/scenes/{name}.json"}
                       for name in ("ties", "duplicates")]}))
        for name, outcome, status in (("legal:vulkan-4-bits", "holds", 0),
                                      ("mutant:vulkan-two-owners", "violated", 1)):
            out = self.path(outcome)
            done = run("certify", "--subject", name, "--cases", "10", "--scenes", scenes, "--out",
                       out)
            self.assertEqual(done.returncode, status, done.stdout + done.stderr)
            (folder,) = [entry.path for entry in os.scandir(out)
                         if os.path.exists(entry.path + "/certificate.json")]
            with open(folder + "/certificate.json") as file:
                rows = {row["property"]: row for row in json.load(file)["tested"]}
            row = rows["OneLegalModelExplainsTheMesh on ties"]
            self.assertEqual(row["outcome"], outcome, row["message"])
            self.assertGreater(row["exercised"], 0)
            for file_name in ("junit.xml", "report.html"):
                with open(f"{folder}/{file_name}") as file:
                    text = file.read().replace("<wbr>", "")
                self.assertIn("OneLegalModelExplainsTheMesh on ties", text)
            if outcome == "holds":
                self.assertIn("2 of 2 scenes have a legal model", done.stdout)
            else:
                self.assertIn("contradict", row["message"])

    def grey_levels(self, path, width, height):
        """Of a PNG of RGB whose three channels are equal and whose rows are not filtered."""
        done = subprocess.run(
            [sys.executable, "-c", "import sys, struct, zlib\n"
             "data = open(sys.argv[1], 'rb').read()\n"
             "at, lines = 8, b''\n"
             "while at < len(data):\n"
             "    size = struct.unpack('>I', data[at:at + 4])[0]\n"
             "    if data[at + 4:at + 8] == b'IDAT': lines += data[at + 8:at + 8 + size]\n"
             "    at += 12 + size\n"
             "print(*zlib.decompress(lines))\n", path],
            capture_output=True, text=True, check=True)  # fmt: skip
        numbers = [int(word) for word in done.stdout.split()]
        rows = [numbers[k:k + 1 + 3 * width] for k in range(0, len(numbers), 1 + 3 * width)]
        self.assertEqual(len(rows), height)
        levels, above = [], [0] * 3 * width
        for row in rows:
            kind, row = row[0], row[1:]
            for k in range(3 * width):
                left = row[k - 3] if k >= 3 else 0
                corner = above[k - 3] if k >= 3 else 0
                nearest = min((left, above[k], corner),
                              key=lambda x, k=k, left=left, corner=corner:
                              abs(left + above[k] - corner - x))  # fmt: skip
                row[k] = (row[k] + (0, left, above[k], (left + above[k]) // 2, nearest)[kind]) % 256
            levels.append(row[::3])
            above = row
        return levels

    def test_a_mask_says_what_a_comparison_may_look_at(self):
        # One step beside the square's left side is open; the rest is decided.
        scene = dict(SQUARE, vertices=[[0.5, 0.25], [3.25, 0.25], [3.25, 3.25], [0.5, 3.25]])
        done = run("legal", self.write("beside.json", json.dumps(scene)), "--decided", "--profile",
                   "vulkan", "--mask", self.path("mask.png"))  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.grey_levels(self.path("mask.png"), 4, 4),
                         [[128, 255, 255, 0]] * 3 + [[0, 0, 0, 0]])  # fmt: skip
        done = run("legal", self.scene, "--mask", self.path("other.png"), "--profile", "gl")
        self.assertEqual(done.returncode, 2)
        self.assertIn("--decided", done.stderr)

    def test_clip_space_is_judged_under_an_error_that_is_assumed_and_said(self):
        scene = dict(SQUARE, vertices=[[2 * x, 2 * y, 0, 2] for x, y in SQUARE["vertices"]])
        clip = self.write("clip.json", json.dumps(scene))
        right = self.write("right.txt", "1 1 1 0\n" * 3 + "0 0 0 0\n")
        wrong = self.write("wrong.txt", "1 1 1 0\n" * 2 + "1 0 1 0\n" + "0 0 0 0\n")
        judged = ("--profile", "d3d11", "--assume-transform-error", "2")
        done = run("legal", clip, right, "--profile", "d3d11")
        self.assertEqual(done.returncode, 2)
        self.assertIn("states no error of its transform", done.stderr)
        self.assertIn("or --assume-transform-error 2, which judges it", done.stderr)
        done = run("legal", clip, "--decided", "--profile", "d3d11")
        self.assertIn("or --assume-transform-error 2", done.stderr)
        whole = {"name": "whole", "scene": "scene.json", "image": "right.txt"}
        done = self.listed(whole, dict(whole, name="clipped", scene="clip.json"),
                           options=("--profile", "d3d11"))
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        for told in ("[1] (clipped)", "or --assume-transform-error 2"):
            self.assertIn(told, done.stderr)
        done = run("legal", clip, right, *judged, "--json", self.path("legal.json"))
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("assumed, for no specification states it: the transform", done.stdout)
        with open(self.path("legal.json"), encoding="utf-8") as file:
            self.assertEqual(json.load(file)["assumed_transform_error"], 2)
        self.assertEqual(run("legal", clip, wrong, *judged).returncode, 1)
        done = run("legal", clip, "--decided", *judged)
        self.assertIn("assumed, for no", done.stderr)
        stated = self.write("stated.json", '{"name": "mine", "subpixel_bits": 8}')
        done = run("legal", clip, right, "--profile", stated, "--assume-transform-error", "2")
        self.assertEqual(done.returncode, 2)
        self.assertIn("states the error of its transform", done.stderr)

    def test_a_picture_says_where_and_not_how_often(self):
        rows = self.drawn("vulkan-canonical")
        image = self.write("image.png", png([[255 * bool(n) for n in row] for row in rows]))
        self.assertEqual(self.legal(image, "vulkan").returncode, 0)
        self.assertEqual(self.legal(image, "vulkan", "--background", "ffffff").returncode, 1)

    def test_a_picture_may_be_pgm_ppm_or_raw_bytes(self):
        rows = self.drawn("vulkan-canonical")
        levels = [200 * bool(n) for row in rows for n in row]
        wrong = [*levels[:5], 0, *levels[6:]]  # column 1 row 1 is lost
        for name, head, channels in (("a.pgm", b"P5 4 4 255\n", 1), ("a.ppm", b"P6 4 4 255\n", 3),
                                     ("a.raw", b"", 1), ("b.raw", b"", 3), ("c.raw", b"", 4)):
            for shown, status in ((levels, 0), (wrong, 1)):
                body = bytes(n for level in shown for n in [level] * channels)
                done = self.legal(self.write(name, head + body), "vulkan")
                self.assertEqual(done.returncode, status, name + done.stdout + done.stderr)
        wide = b"".join(struct.pack(">H", level // 200) for level in levels)  # faint, and not black
        for background, status in (("000000", 0), ("ffffff", 1)):
            done = self.legal(self.write("w.pgm", b"P5 4 4 65535\n" + wide), "vulkan",
                              "--background", background)  # fmt: skip
            self.assertEqual(done.returncode, status, done.stdout + done.stderr)

    def test_levels_are_counts_only_if_asked(self):
        done = run("coverage", self.scene, "--png", self.path("counts.pgm"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(self.legal(self.path("counts.pgm"), "vulkan", "--counts").returncode, 0)
        twice = bytearray(sum(self.drawn("vulkan-canonical"), []))
        twice[5] = 2
        for name, head in (("twice.pgm", b"P5 4 4 255\n"), ("twice.raw", b"")):
            image = self.write(name, head + twice)
            self.assertEqual(self.legal(image, "vulkan").returncode, 0)
            done = self.legal(image, "vulkan", "--counts")
            self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
            self.assertIn("column 1 row 1: 2 of triangles 0, 1 cover it", done.stdout)
        wide = self.write("wide.raw", b"".join(struct.pack("<I", n) for n in twice))
        self.assertEqual(self.legal(wide, "vulkan", "--counts").returncode, 1)

    def test_ids_are_judged_in_any_order_or_in_that_of_drawing(self):
        # Two triangles lie over each other; the second is drawn last.
        scene = dict(SQUARE, triangles=[[0, 1, 2], [0, 1, 2]])
        self.scene = self.write("over.json", json.dumps(scene))
        first, last = ([[1, 1, 1, 0], [0, 1, 1, 0], [0, 0, 1, 0], [0, 0, 0, 0]],
                       [[2, 2, 2, 0], [0, 2, 2, 0], [0, 0, 2, 0], [0, 0, 0, 0]])
        mixed = [first[0], *last[1:]]
        for rows, visible, status in ((first, "any", 0), (last, "any", 0), (mixed, "any", 0),
                                      (first, "first", 0), (first, "last", 1), (last, "last", 0),
                                      (mixed, "last", 1)):
            done = self.legal(self.as_text(rows), "vulkan", "--ids", "--visible", visible)
            self.assertEqual(done.returncode, status, visible + done.stdout + done.stderr)
        done = self.legal(self.as_text(mixed), "vulkan", "--ids")
        self.assertIn("which of several triangles is on top is not judged", done.stdout)
        lost = [[1, 1, 0, 0], *mixed[1:]]
        for rows in (lost, [*mixed[:3], [0, 1, 0, 0]]):  # one is lost, one is where none may be
            levels = b"".join(struct.pack(">H", n) for row in rows for n in row)
            image = self.write("ids.pgm", b"P5 4 4 65535\n" + levels)
            done = self.legal(image, "vulkan", "--ids")
            self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        raw = self.write("ids.raw", b"".join(struct.pack("<I", n) for row in mixed for n in row))
        self.assertEqual(self.legal(raw, "vulkan", "--ids").returncode, 0)
        self.refused("legal", self.scene, self.as_text([[3] * 4] * 4), "--ids", "--profile", "gl",
                     names=["column 0 row 0", "id is 3", "2 triangles"])

    def test_the_triangle_that_an_id_names_covers_its_sample(self):
        right = [[1, 1, 1, 0], [2, 1, 1, 0], [2, 2, 1, 0], [0, 0, 0, 0]]
        self.assertEqual(self.legal(self.as_text(right), "vulkan", "--ids").returncode, 0)
        right[1][1] = 2  # of the diagonal: either
        self.assertEqual(self.legal(self.as_text(right), "vulkan", "--ids").returncode, 0)
        right[0][2] = 2  # of the first triangle alone
        wrong = self.legal(self.as_text(right), "vulkan", "--ids")
        self.assertEqual(wrong.returncode, 1)
        self.assertIn("column 2 row 0: shows triangle 1; legal: 0\n", wrong.stdout)

    def test_facings_are_judged_where_a_subject_tells_them(self):
        square = ("legal", self.scene, "--profile", "vulkan", "--subject")
        for subject, status, told in (
                ("i64-snap8", 0, "compared: counts and facings\n"),
                ("legal:vulkan-facing-exchanged", 0, "the side that is clockwise on screen"),
                ("mutant:vulkan-facing-by-place", 1, "a model explains the counts alone")):
            done = run(*square, subject)
            self.assertEqual(done.returncode, status, subject + done.stdout + done.stderr)
            self.assertIn(told, done.stdout)
        self.assertIn("column 0 row 1: 1 front and 0 back of triangles 1 cover it; legal: "
                      "0 front and 1 back\n", done.stdout)  # fmt: skip

    def test_a_list_is_judged_entry_by_entry(self):
        rows = self.drawn("vulkan-canonical")
        self.as_text(rows)
        rows[1][1] = 2
        self.write("twice.txt", "\n".join(" ".join(map(str, row)) for row in rows))
        right = {"name": "right", "scene": "scene.json", "image": "counts.txt", "profile": "vulkan"}
        wrong = dict(right, name="wrong", image="twice.txt")
        known = dict(wrong, name="known", expected="illegal", reason="ticket 7")
        passes = dict(right, name="passes", expected="illegal", reason="ticket 8")
        done = self.listed(right, known)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        lines = done.stdout.splitlines()
        self.assertRegex(lines[0], "^legal +right: profile vulkan; one model")
        self.assertRegex(lines[1], "^known +known: ticket 7$")
        self.assertEqual(lines[2], "2 drawings: 1 legal; 1 not legal as expected")
        done = self.listed(right, wrong, passes, options=("--junit", self.path("out.xml")))
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertRegex(done.stdout, "not legal +wrong: .*column 1 row 1: 2 of triangles 0, 1")
        self.assertRegex(done.stdout, r"passes +passes: .*ticket 8.*list.json: \[2\]")
        suite = xml.etree.ElementTree.parse(self.path("out.xml")).getroot()[0]
        self.assertEqual((suite.get("tests"), suite.get("failures")), ("3", "2"))
        self.assertEqual([case.get("name") for case in suite.findall("testcase/failure/..")],
                         ["wrong", "passes"])  # fmt: skip
        self.assertEqual(self.listed(passes).returncode, 1)
        for day, status in (("2999-01-31", 0), ("2001-01-31", 1)):
            done = self.listed(dict(known, owner="ada", until=day))
            self.assertEqual(done.returncode, status, done.stdout)
            self.assertIn("ada", done.stdout)

    def test_a_subject_draws_what_has_no_image_in_a_list(self):
        drawn = {"name": "square", "scene": "scene.json"}
        for subject, status in (("i64-snap8", 0), ("textbook", 1)):
            done = self.listed(drawn, dict(drawn, name="again", profile="gl"),
                               options=("--subject", subject, "--profile", "vulkan"))
            self.assertEqual(done.returncode, status, done.stdout + done.stderr)

    def test_a_list_with_a_fault_judges_nothing(self):
        self.as_text(self.drawn("vulkan-canonical"))
        good = {"name": "good", "scene": "scene.json", "image": "counts.txt", "profile": "vulkan"}
        for bad, names in (
                (dict(good, name="bad", image="gone.txt"), ["[1] (bad)", "gone.txt"]),
                (dict(good, name="bad", scene="gone.json"), ["[1] (bad)", "gone.json"]),
                (dict(good, name="bad", profile="no-such"), ["[1] (bad)", "no-such"]),
                (dict(good, name="bad", expected="wrong"), ["[1].expected", "wrong"]),
                (dict(good, name="bad", expected="illegal"), ["[1]", "reason"]),
                (dict(good, name="bad", reason="none"), ["[1].reason", "illegal"]),
                (dict(good, name="bad", colour="red"), ["[1]", "colour"]),
                (good, ["[1].name", "good"]),
                ({"name": "bad", "scene": "scene.json"}, ["[1]", "image"])):
            done = self.listed(good, bad)
            self.assertEqual((done.returncode, done.stdout), (2, ""), done.stderr)
            for name in names:
                self.assertIn(name, done.stderr)
        self.assertEqual(self.listed().returncode, 2)
        self.assertEqual(run("legal", "--list", self.path("list.json"), self.scene).returncode, 2)
        self.assertEqual(run("legal").returncode, 2)

    def test_pictures_are_written_as_their_ending_says(self):
        mask = ("legal", self.scene, "--decided", "--profile", "vulkan", "--mask")
        self.assertEqual(run(*mask, self.path("mask.pgm")).returncode, 0)
        with open(self.path("mask.pgm"), "rb") as file:
            self.assertEqual(file.read(), b"P5\n4 4\n255\n" + (b"\xff" * 3 + b"\0") * 3 + b"\0" * 4)
        shown = ("coverage", self.scene, "--subject", "textbook", "--against", "exact", "--png")
        self.assertEqual(run(*shown, self.path("wrong.ppm")).returncode, 1)
        with open(self.path("wrong.ppm"), "rb") as file:
            self.assertTrue(file.read().startswith(b"P6\n4 4\n255\n"))
        self.refused(*shown, self.path("wrong.pgm"), names=["wrong.pgm", "colours", ".ppm"])
        self.assertFalse(os.path.exists(self.path("wrong.pgm")))

    def test_a_subject_draws_what_is_judged(self):
        drawn = run("legal", self.scene, "--subject", "i32-snap4", "--profile", "gl", "--json", "-")
        self.assertEqual(drawn.returncode, 0, drawn.stderr)
        printed = json.loads(drawn.stdout)
        self.assertEqual(printed["verdict"], "legal")
        self.assertIn("gl.one-position", [one["statement"] for one in printed["assumed"]])
        twice = run("legal", self.scene, "--subject", "textbook", "--profile", "gl")
        self.assertEqual(twice.returncode, 1, twice.stdout + twice.stderr)

    def test_bad_input_is_refused_with_the_place(self):
        rows = self.drawn("real")
        legal = ("legal", self.scene)
        self.refused(*legal, names=["--subject"])
        self.refused(*legal, self.as_text(rows), names=["--profile"])
        self.refused(*legal, self.as_text(rows[:3]), "--profile", "gl", names=["3 rows", "4"])
        self.refused(*legal, self.as_text([*rows[:3], [1, 2]]), "--profile", "gl",
                     names=["line 4", "2 counts"])
        self.refused(*legal, self.write("x.txt", "1 2 x 4\n" * 4), "--profile", "gl",
                     names=["line 1"])
        self.refused(*legal, self.write("x.png", b"\x89PNG broken"), "--profile", "gl",
                     names=["x.png", "PNG"])
        small = self.write("small.png", png([[0, 0], [0, 0]]))
        self.refused(*legal, small, "--profile", "gl", names=["2 x 2", "4 x 4"])
        self.refused(*legal, small, "--profile", "gl", "--background", "red", names=["red"])
        raw = self.write("x.raw", b"12345")
        self.refused(*legal, raw, "--profile", "gl", names=["5 bytes", "4 x 4", "16, 48 or 64"])
        self.refused(*legal, raw, "--profile", "gl", "--counts", names=["5 bytes", "16 samples"])
        self.refused(*legal, self.write("x.pgm", b"P5 3 4 255\n"), "--profile", "gl",
                     names=["x.pgm", "3 x 4", "4 x 4"])
        self.refused(*legal, small, "--profile", "gl", "--counts", names=["small.png", "PGM"])
        watertight = self.write("p.json", '{"name": "mine", "contract": "watertight"}')
        decided = (*legal, "--decided")
        self.refused(*decided, "--profile", watertight, names=["single samples"])
        self.refused(*decided, names=["give --profile"])
        for drawing in ((self.as_text(rows),), ("--subject", "exact")):
            self.refused(*decided, *drawing, "--profile", "gl", names=["judges no drawing"])
        self.refused(*legal, "--subject", "exact", "--profile", "gl", "--png", "x.png",
                     names=["--decided"])  # fmt: skip


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:], verbosity=0)
