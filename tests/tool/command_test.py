"""The command as its users meet it: output, exit statuses, bad input.

usage: command_test.py PROGRAM SOURCES
"""
import json
import os
import random
import shlex
import struct
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import exact_model

PROGRAM = os.path.abspath(sys.argv[1])
SOURCES = os.path.abspath(sys.argv[2])
SHARED_EDGE = "SharedEdgeSamplesAreCoveredOnce"
MODEL = "CoverageEqualsTheModel"
PROFILE_BITS = {"real": None, "d3d11-canonical": 8, "vulkan-canonical": 8, "gl-canonical": 8}


def run(*arguments, data=None, stdout=subprocess.PIPE):
    return subprocess.run([PROGRAM, *arguments], input=data, stdout=stdout, stderr=subprocess.PIPE,
                          cwd=SOURCES, timeout=900)


def float32(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def coordinate_text(c):
    if c != c:
        return "nan"
    return c.hex() if abs(c) != float("inf") else ("inf" if c > 0 else "-inf")


def scene_text(width, height, vertices, triangles, **more):
    coordinates = [[coordinate_text(c) for c in v] for v in vertices]
    return json.dumps({"rasterproof_scene": 1, "name": "test", "width": width, "height": height,
                       "vertices": coordinates, "triangles": triangles, **more})


class TemporaryFolder(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()

    def tearDown(self):
        self.folder.cleanup()

    def write(self, text, name="scene.json"):
        path = os.path.join(self.folder.name, name)
        with open(path, "wb") as file:
            file.write(text if isinstance(text, bytes) else text.encode())
        return path


class InferTest(TemporaryFolder):
    def test_where_no_model_fits_the_draw_that_refuted_the_last_is_reported_and_replays(self):
        subject = ("--subject", "mutant:overflow-int16-deltas")
        text = run("infer", *subject).stdout.decode()
        first = text.splitlines()[0]
        self.assertIn(": 8 subpixel bits, nearest-even", first)
        self.assertTrue(first.endswith("; differs in no sample of random draws, only in "
                                       "an aimed one: no model fits"), first)  # fmt: skip
        rounded = run("infer", "--subject", "f32-direct").stdout.decode().splitlines()[0]
        self.assertRegex(rounded, r"^f32-direct: no grid; .*; differs in 0\.0\d+ % of samples: "
                                  r"no model fits$")
        self.assertRegex(text, r"(?m)^last refuted     .*, by the draw of \(.*\) on \d+x\d+$")
        self.assertIn(" 0 of 307200 samples, 0 of 1200 draws, drawn at random", text)
        case, _, replay = text.partition("a case that it draws differently:\n")[2].partition(
            "replay: save it as case.json, then: rasterproof ")
        self.assertEqual(run("replay", self.write(case, "case.json"), *subject).returncode, 1, case)
        self.assertEqual(replay, "replay case.json " + " ".join(subject) + "\n")

    def test_a_subject_is_found_as_it_declares_itself(self):
        result = run("infer", "--subject", "i32-snap4")
        self.assertEqual(result.returncode, 0, result.stdout)
        first = result.stdout.splitlines()[0]
        self.assertIn(b"i32-snap4: 4 subpixel bits, nearest-even", first)
        self.assertNotIn(b"CONTRADICTED", result.stdout)

    def test_an_untrue_declaration_is_contradicted_with_a_case(self):
        path = os.path.join(self.folder.name, "inference.json")
        result = run("infer", "--subject", "i32-snap4", "--profile", "d3d11-canonical",
                     "--json", path)
        self.assertEqual(result.returncode, 1, result.stdout)
        self.assertIn(b"CONTRADICTED     stated 8, found 4", result.stdout)
        with open(path, encoding="utf-8") as file:
            inference = json.load(file)
        self.assertTrue(inference["fits"])
        self.assertFalse(inference["agrees"])
        self.assertEqual(inference["remaining"][0]["subpixel_bits"], 4)
        case = self.write(json.dumps(inference["witness"]), "case.json")
        self.assertEqual(run("replay", case, "--subject", "i32-snap4").returncode, 1)

    def test_a_subject_that_no_model_fits_is_reported_with_the_nearest(self):
        result = run("infer", "--subject", "f32-incremental", "--json", "-")
        inference = json.loads(result.stdout)
        self.assertEqual(result.returncode, 1, inference["message"])
        self.assertFalse(inference["fits"])
        self.assertEqual(inference["remaining"], [])
        self.assertIsNone(inference["nearest"]["profile"]["subpixel_bits"])
        self.assertLess(inference["nearest"]["wrong_samples"], inference["nearest"]["samples"])
        self.assertEqual(inference["witness"]["subject"], "f32-incremental")

    def test_only_who_promises_samples_breaks_a_promise_by_following_no_model(self):
        subject = ("infer", "--subject", "mutant:ties-by-slope")
        self.assertEqual(run(*subject).returncode, 1)
        text = '{"name": "c", "subpixel_bits": 8, "contract": "at-least-model"}'
        over = self.write(text, "c.json")
        self.assertEqual(run(*subject, "--profile", over).returncode, 4)


class CoverageTest(TemporaryFolder):
    def check(self, width, height, vertices, triangles, **more):
        path = self.write(scene_text(width, height, vertices, triangles, **more))
        for profile, bits in PROFILE_BITS.items():
            for subject in ("exact", "exact-integers", "exact-cgal"):
                result = run("coverage", path, "--subject", subject, "--profile", profile)
                self.assertEqual(result.returncode, 0, result.stderr)
                lines = result.stdout.decode().splitlines()
                self.assertEqual([[int(n) for n in line.split()] for line in lines],
                                 exact_model.coverage(width, height, vertices, triangles, bits),
                                 f"{profile} {subject} {vertices} {triangles}")

    def test_ties_follow_the_top_left_rule_for_either_winding(self):
        square = [(0.5, 0.5), (3.5, 0.5), (3.5, 3.5), (0.5, 3.5)]
        self.check(5, 5, square, [[0, 1, 2], [0, 2, 3]])
        self.check(5, 5, square, [[0, 2, 1], [0, 3, 2]])

    def test_slivers_and_magnitudes_at_both_ends(self):
        self.check(4, 3, [(0.5, 0.5), (1e30, 0.5 + 2**-20), (float32(1e30), 0.5)], [[0, 1, 2]],
                   precision="float64")
        tiny = float32(1e-30)
        self.check(4, 3, [(-1.0, tiny), (float32(1e30), 0.0), (tiny, float32(1e30))], [[0, 1, 2]])
        self.check(3, 3, [(0.5, 0.0), (0.5, 3.0), (0.5 + 1e-15, 3.0)], [[0, 1, 2], [0, 2, 1]],
                   precision="float64")

    def test_subnormals_duplicates_and_degenerates(self):
        low = 2.0**-149
        self.check(2, 2, [(-low, -low), (low, 2.0), (2.0, -low)], [[0, 1, 2], [0, 1, 2], [0, 0, 1]])
        self.check(2, 2, [(5e-324, 0.0), (1.7e308, -1.7e308), (0.0, 1.7e308)], [[0, 1, 2]],
                   precision="float64")

    def test_non_finite_triangles_cover_nothing(self):
        nan, inf = float("nan"), float("inf")
        self.check(3, 3, [(0.0, 0.0), (3.0, 0.0), (0.0, 3.0), (nan, 1.0), (inf, 0.0), (1.0, -inf)],
                   [[0, 1, 2], [0, 1, 3], [0, 4, 2], [5, 1, 2]])

    def test_random_scenes_on_half_pixels_and_off_every_lattice(self):
        random.seed(7)
        for kind in range(12):
            vertices = []
            for _ in range(6):
                if kind % 3 == 0:
                    x, y = random.randrange(-2, 20) / 2, random.randrange(-2, 20) / 2
                elif kind % 3 == 1:
                    x, y = random.uniform(-3, 12), random.uniform(-3, 12)
                else:
                    scale = 2.0 ** random.randrange(-140, 120)
                    x, y = random.uniform(-scale, scale), random.uniform(0, 9)
                vertices.append((float32(x), float32(y)))
            triangles = [[random.randrange(6) for _ in range(3)] for _ in range(4)]
            self.check(9, 7, vertices, triangles)

    def test_exact_methods_print_what_the_oracle_prints(self):
        for name in ("ties", "slivers", "mixed_magnitude", "subnormal", "duplicates", "nan", "fan"):
            path = os.path.join(SOURCES, "scenes", name + ".json")
            expected = run("coverage", path, "--subject", "exact").stdout
            for subject in ("spans-exact", "filtered-exact"):
                self.assertEqual(run("coverage", path, "--subject", subject).stdout, expected, name)

    def test_scene_from_standard_input(self):
        text = scene_text(1, 1, [(0.0, 0.0), (2.0, 0.0), (0.0, 2.0)], [[0, 1, 2]])
        self.assertEqual(run("coverage", "-", data=text.encode()).stdout, b"1\n")


class BadInputTest(TemporaryFolder):
    GOOD = {"rasterproof_scene": 1, "name": "g", "width": 4, "height": 4,
            "vertices": [[0, 0], [4, 0], [0, 4]], "triangles": [[0, 1, 2]]}

    def refused(self, *arguments, names, data=None):
        result = run(*arguments, data=data)
        self.assertEqual(result.returncode, 2, (arguments, result.stdout, result.stderr))
        self.assertEqual(result.stdout, b"")
        for name in [names] if isinstance(names, str) else names:
            self.assertIn(name, result.stderr.decode())

    def refused_scene(self, text, *fragments):
        path = self.write(text)
        for verb in ("coverage", "plan", "check"):
            self.refused(verb, path, names=[path, *fragments])

    def changed(self, **changes):
        return json.dumps({**self.GOOD, **changes})

    def test_files_that_are_no_scenes(self):
        good = json.dumps(self.GOOD)
        self.refused_scene(good[:-20])
        self.refused_scene("")
        self.refused_scene(b"\xff\xfe\x00")
        self.refused_scene("[" * 100000)
        self.refused_scene(self.changed(vertecies=[]), "vertecies")

    def test_wrong_indices_and_arities(self):
        self.refused_scene(self.changed(triangles=[[0, 1, 3]]), "triangles[0][2]")
        self.refused_scene(self.changed(triangles=[[0, 1, -1]]), "triangles[0][2]")
        self.refused_scene(self.changed(triangles=[[0, 1, 0.5]]), "triangles[0][2]")
        self.refused_scene(self.changed(triangles=[[0, 1]]), "triangles[0]")
        self.refused_scene(self.changed(vertices=[[0], [4, 0], [0, 4]]), "vertices[0]")
        self.refused_scene(self.changed(vertices=[[0, 0], [4, 0, 0, 0, 0], [0, 4]]), "vertices[1]")

    def test_numbers_that_the_precision_does_not_hold(self):
        for bad in ("0x1.0000001p+0", "0x1p", "1.5", "0x1.8p0 ", "nan(7)", "infinity", "",
                    "0x1p+128"):
            self.refused_scene(self.changed(vertices=[[bad, 0], [4, 0], [0, 4]]), "vertices[0][0]")
        self.refused_scene(json.dumps(self.GOOD).replace("[4, 0]", "[1e400, 0]"), "vertices[1][0]")
        self.refused_scene(json.dumps(self.GOOD).replace("[4, 0]", "[4e38, 0]"), "vertices[1][0]")
        self.refused_scene(json.dumps(self.GOOD).replace("[4, 0]", "[NaN, 0]"))

    def test_targets_of_impossible_size(self):
        self.refused_scene(self.changed(width=0, height=0), "width")
        self.refused_scene(self.changed(width=2**31), "width")
        self.refused_scene(self.changed(width=65536, height=65536))
        self.refused_scene(self.changed(height=-1), "height")

    def test_files_that_cannot_be_read(self):
        missing = os.path.join(self.folder.name, "absent.json")
        for verb in ("coverage", "plan", "check", "replay", "explain"):
            subject = ["--subject", "exact"] if verb in ("replay", "explain") else []
            self.refused(verb, missing, *subject, names=missing)
        self.refused("coverage", self.folder.name, names=self.folder.name)
        mesh = self.write("v 0 0\nf 1 2 nonsense\n", "broken.obj")
        self.refused("coverage", mesh, names=mesh)
        self.refused("coverage", self.write("", "empty.ply"), names="empty.ply")

    def test_options_that_do_not_exist(self):
        path = self.write(json.dumps(self.GOOD))
        self.refused("coverage", path, "--colour-of-magic", names="--colour-of-magic")
        self.refused("coverage", path, "--subject", "nonesuch", names="nonesuch")
        self.refused("coverage", path, "--profile", "nonesuch", names="nonesuch")
        for legal_set in ("vulkan", "gl", "d3d11", "webgpu"):  # none names one grid point
            self.refused("coverage", path, "--subject", "f32-direct", "--profile", legal_set,
                         names="canonical")  # fmt: skip
        self.refused("check", "--property", "Nonesuch", names="Nonesuch")
        self.refused("check", "--seed", "12x", names="12x")
        self.refused("check", "--cases", "-4", names="--cases")
        self.refused("nonesuch", names="nonesuch")
        self.refused(names="subcommand")

    def test_names_of_no_case(self):
        for verb in (("check",), ("replay",), ("explain",), ("replay", "--shrink", "-"),
                     ("convert", "--to", "case")):  # fmt: skip
            def refused(name, *names, verb=verb):
                self.refused(*verb, "--subject", "f32-direct", "--case", name, names=[name, *names])

            refused("17", "not the name of a case", "near-edge:17@1", "list domains")
            refused("near-edge:seven@1", "'seven' is no index")
            refused("near-edge:17@", "'' is no seed")
            refused("long-walk:17@1", "'long-walk', which is long-rows now")
            refused("near-edges:17@1", "no domain", "did you mean near-edge?", "list domains")
            refused("mixed-w:0@1", "takes no scenes of domain mixed-w")
        self.refused("replay", "--case", "near-edge:17@1", names="--subject")
        scene = self.write(json.dumps(self.GOOD))
        self.refused("replay", scene, "--case", "near-edge:17@1", names="give one of them")

    def test_a_profile_with_a_presets_name_and_another_content(self):
        path = self.write(json.dumps(self.GOOD))
        profile = self.write('{"name": "vulkan-canonical", "subpixel_bits": 4}', "vulkan.json")
        for verb in ("check", "coverage", "plan", "infer", "certify"):
            scene = [] if verb in ("infer", "certify") else [path]
            options = ["--profile", profile]
            if verb == "certify":
                options = ["--subject",
                           self.write(f'command true\nprofile {{"name": "vulkan-canonical", '
                                                   '"subpixel_bits": 4}\n', "x.subject"),
                           "--out", self.folder.name]  # fmt: skip
            self.refused(verb, *scene, *options, names=["vulkan-canonical", "another name"])
        case = self.write(json.dumps({"rasterproof_case": 2, "scene": self.GOOD, "subject": "exact",
                                      "profile": {"name": "gl-canonical", "subpixel_bits": 5}}))
        self.refused("replay", case, names=["gl-canonical", "another name"])

    def test_deciders_and_plans_that_know_no_rounded_crossings(self):
        path = self.write(json.dumps(self.GOOD))
        profile = self.write('{"name": "rows", "scanline_rounding": {"bits": 8}}', "rows.json")
        self.assertEqual(run("coverage", path, "--profile", profile).returncode, 0)
        for subject in ("exact-integers", "exact-cgal"):
            self.refused("coverage", path, "--subject", subject, "--profile", profile,
                         names=[subject, "scanline_rounding"])
        self.refused("plan", path, "--profile", profile, names=["scanline", "scanline_rounding"])

    def test_subjects_say_which_scenes_they_do_not_take(self):
        behind = [(0.0, 0.0, 0.0, 1.0), (2.0, 0.0, 0.0, 1.0), (0.0, 2.0, 0.0, -1.0)]
        clip = self.write(scene_text(2, 2, behind, [[0, 1, 2]]))
        self.refused("coverage", clip, "--subject", "f32-direct", names=[clip, "clip space"])
        self.refused("coverage", clip, "--subject", "exact", "--profile", "d3d11-canonical",
                     names="w")
        text = scene_text(2, 2, [(0.1, 0.0), (2.0, 0.0), (0.0, 2.0)], [[0, 1, 2]],
                          precision="float64")
        double = self.write(text, "double.json")
        self.refused("coverage", double, "--subject", "f32-direct", names=[double, "float64"])


class FullDeviceTest(TemporaryFolder):
    def test_a_full_device_is_reported(self):
        vertices = [(0.0, 0.0), (64.0, 0.0), (0.0, 64.0)]
        path = self.write(scene_text(64, 64, vertices, [[0, 1, 2]]))
        with open("/dev/full", "wb") as full:
            for arguments in (("coverage", path), ("list",), ("plan", path)):
                result = run(*arguments, stdout=full)
                self.assertEqual(result.returncode, 2, result.stderr)
                self.assertIn(b"standard output", result.stderr)
        result = run("coverage", path, "-o", "/dev/full")
        self.assertEqual(result.returncode, 2)
        self.assertIn(b"/dev/full", result.stderr)

    def test_an_unwritable_output_leaves_nothing_behind(self):
        path = self.write(scene_text(2, 2, [(0.0, 0.0), (2.0, 0.0), (0.0, 2.0)], [[0, 1, 2]]))
        target = os.path.join(self.folder.name, "no", "such", "folder.png")
        result = run("coverage", path, "--mode", "flat", "--png", target)
        self.assertEqual(result.returncode, 2)
        self.assertIn(target.encode(), result.stderr)
        self.assertEqual(sorted(os.listdir(self.folder.name)), ["scene.json"])


class VerdictTest(TemporaryFolder):
    def test_a_sound_method_holds_and_a_naive_one_is_violated(self):
        ties = os.path.join(SOURCES, "scenes", "ties.json")
        against = ("coverage", ties, "--against", "exact", "--subject")
        self.assertEqual(run(*against, "spans-exact").returncode, 0)
        result = run(*against, "textbook")
        self.assertEqual(result.returncode, 1)
        self.assertIn(b"unexpected", result.stdout)
        self.assertEqual(run("check", ties, "--subject", "textbook", "--no-cause").returncode, 1)
        self.assertEqual(run("check", ties, "--subject", "spans-exact").returncode, 0)

    def test_a_violation_names_its_replay_and_the_replay_fails_again(self):
        result = run("check", "--subject", "textbook", "--property", SHARED_EDGE)
        self.assertEqual(result.returncode, 1, result.stderr)
        line = next(l for l in result.stdout.decode().splitlines() if "rasterproof replay" in l)
        replay = shlex.split(line[line.index("rasterproof replay"):])[1:]
        again = run(*replay)
        self.assertEqual(again.returncode, 1, again.stderr)
        self.assertIn(b"0x", again.stdout)

    def test_saved_counterexamples_are_small_and_fail_again(self):
        saved = os.path.join(self.folder.name, "cases")
        run("check", "--subject", "textbook", "--property", SHARED_EDGE, "--save", saved,
            "--no-cause")  # fmt: skip
        (name,) = os.listdir(saved)
        path = os.path.join(saved, name)
        with open(path) as file:
            case = json.load(file)
        self.assertLessEqual(len(case["scene"]["triangles"]), 2)
        self.assertEqual(run("replay", path).returncode, 1)
        svg = os.path.join(self.folder.name, "e.svg")
        self.assertEqual(run("explain", path, "--svg", svg).returncode, 1)

    def test_the_same_seed_gives_the_same_output(self):
        arguments = ("check", "--subject", "f32-direct", "--property", MODEL, "--seed", "5")
        self.assertEqual(run(*arguments).stdout, run(*arguments).stdout)

    def test_nothing_exercised_is_inconclusive(self):
        result = run("check", "--subject", "hom-f32", "--property", "SteppingStaysWithinItsBound")
        self.assertEqual(result.returncode, 4, result.stdout)

    def test_progress_never_reaches_standard_output(self):
        result = run("check", "--subject", "i64-snap8", "--property", MODEL, "--cases", "50")
        self.assertEqual(result.returncode, 0, result.stdout)
        self.assertEqual(len(result.stdout.decode().splitlines()), 2)

    def test_a_check_ends_with_its_counts_and_a_line_for_each_reason_not_to_ask(self):
        result = run("check", "--subject", "f32-direct", "--cases", "1", "--verbose", "--no-cause")
        lines = result.stdout.decode().splitlines()
        named = [l for l in lines if l.startswith("not applicable")]
        (fragments,) = (l for l in named if "the subject shows no fragments: " in l)
        self.assertEqual(fragments.count("Fragment"), 4)
        left_out = sum(l.rsplit(": ", 1)[1].count(",") + 1 for l in named)
        self.assertRegex(lines[-1], "^f32-direct: .* cases$")
        self.assertIn(f" {left_out} not applicable", lines[-1])

    def test_each_scene_says_for_itself_what_was_not_asked(self):
        scenes = [os.path.join(SOURCES, "scenes", name) for name in ("ties.json", "fan.json")]
        done = run("check", *scenes, "--subject", "f32-direct", "--verbose", "--no-cause")
        lines = done.stdout.decode().splitlines()
        printed = [l for l in lines if "the subject shows no fragments: " in l]
        self.assertEqual(len(printed), 2, lines)
        for scene, line in zip(scenes, printed):
            self.assertIn(f" {scene}: ", line)
            self.assertEqual(line.count("FragmentBarycentricsSumToOne"), 1)

    def test_a_drawn_case_is_checked_by_its_name(self):
        chosen = ("--subject", "textbook", "--property", SHARED_EDGE, "--no-cause")
        found = run("check", *chosen)
        line = next(l for l in found.stdout.decode().splitlines() if l.startswith("shrunk from "))
        name = line.split()[2]
        self.assertRegex(name, "^[a-z0-9-]+:[0-9]+@1$")
        again = run("check", *chosen, "--case", name)
        self.assertEqual(again.returncode, 1, again.stderr)
        text = again.stdout.decode()
        self.assertRegex(text, f"(?m)^violated +textbook +{SHARED_EDGE} +{name}: exercised ")
        self.assertIn(f"replay --subject textbook --property {SHARED_EDGE} --case {name}", text)
        self.assertIn(" 1 violated, ", text)
        # Without a property: every one that applies.
        result = run("check", "--subject", "spans-exact", "--case", "near-edge:17@1",
                     "--case", "fans:0@2", "--verbose")  # fmt: skip
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        for case in ("near-edge:17@1", "fans:0@2"):
            self.assertRegex(result.stdout.decode(), f"holds +spans-exact +{MODEL} +{case}: ")

    def test_a_replay_is_judged_as_the_check_was(self):
        chosen = ("--subject", "i64-snap8", "--property", MODEL)
        self.assertEqual(run("check", *chosen, "--cases", "60").returncode, 0)
        result = run("check", *chosen, "--profile", "real")
        self.assertEqual(result.returncode, 1, result.stdout)
        line = next(l for l in result.stdout.decode().splitlines() if "rasterproof replay" in l)
        replay = shlex.split(line[line.index("rasterproof replay"):])[1:]
        self.assertIn("--profile", replay)
        self.assertEqual(run(*replay).returncode, 1)

    def test_the_picture_is_of_what_the_property_compares(self):
        result = run("check", "--subject", "mutant:nan-poisons", "--property",
                     "BadTrianglesPoisonNoOthers")  # fmt: skip
        self.assertEqual(result.returncode, 1, result.stdout)
        self.assertIn(b"[-]", result.stdout)

    def test_what_was_drawn_is_reported_and_saved_where_it_is_not_the_case(self):
        folder = os.path.join(self.folder.name, "saved")
        result = run("check", "--subject", "mutant:nan-poisons", "--property",
                     "BadTrianglesPoisonNoOthers", "--save", folder)  # fmt: skip
        drawn = next(line for line in result.stdout.decode().splitlines()
                     if line.startswith("drawn by the property, scene: "))  # fmt: skip
        self.assertIn('"nan"', drawn)
        path = os.path.join(folder, os.listdir(folder)[0])
        with open(path, encoding="utf-8") as file:
            saved = json.load(file)
        self.assertNotIn("nan", json.dumps(saved["scene"]))
        self.assertIn("nan", json.dumps(saved["drawn"]["scene"]))
        for verb in ("replay", "explain"):
            again = run(verb, path)
            self.assertEqual(again.returncode, 1, again.stderr)
            self.assertIn(drawn, again.stdout.decode())
        # A witness beside the case's own target is one of the wider target.
        wide = run("check", "--subject", "mutant:target-last-column", "--property",
                   "TargetWidthKeepsCoverage")  # fmt: skip
        self.assertIn(b"drawn by the property, scene: ", wide.stdout)

    def test_a_name_that_is_nearly_right_is_suggested(self):
        for given, meant in (("coverageEqualsTheModel", MODEL), ("EdgeIsZeroAtItsEnd", "Ends?")):
            result = run("check", "--property", given)
            self.assertEqual(result.returncode, 2)
            self.assertRegex(result.stderr.decode(), f"did you mean [A-Za-z]*{meant}")
        result = run("check", "--subject", "f32-drect")
        self.assertIn(b"did you mean f32-direct?", result.stderr)
        self.assertNotIn(b"did you mean", run("check", "--subject", "zzzzzz").stderr)

    def test_selftest_holds_where_mutants_die_and_legal_variants_live(self):
        path = os.path.join(self.folder.name, "kills.json")
        result = run("selftest", "--cases", "100", "--json", path, "--only",
                     "mutant:ties-inclusive", "legal:snap-floor")
        self.assertEqual(result.returncode, 0, result.stdout)
        self.assertIn("1 of 1 killed", result.stdout.decode())
        with open(path, encoding="utf-8") as file:
            results = json.load(file)["results"]
        self.assertEqual([r["violated"] for r in results], [True, False, False, False])
        killed = results[0]
        replay = run("replay", "--subject", killed["name"], "--property", killed["property"],
                     "--case", killed["case"])  # fmt: skip
        self.assertTrue(killed["case"].endswith(f"@{killed['seed']}"), killed)
        self.assertEqual(replay.returncode, 1, replay.stdout)

    def test_selftest_fails_for_a_mutant_that_survives_and_for_an_unknown_name(self):
        result = run("selftest", "--cases", "1", "--only", "mutant:lost-1-in-1e6")
        self.assertEqual(result.returncode, 1, result.stdout)
        self.assertIn("survived", result.stdout.decode())
        self.assertEqual(run("selftest", "--only", "mutant:none-such").returncode, 2)

    def test_doctor_and_plan_verify(self):
        self.assertEqual(run("doctor").returncode, 0)
        for name in ("ties", "slivers", "mixed_magnitude", "clip_behind"):
            result = run("plan", os.path.join(SOURCES, "scenes", name + ".json"), "--verify")
            self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        result = run("plan", os.path.join(SOURCES, "scenes", "ties.json"), "--measure")
        self.assertEqual(result.returncode, 0, result.stdout + result.stderr)
        rows = result.stdout.decode().split("measured")[1].splitlines()[1:]
        self.assertRegex(rows[0], r"^  planned +[0-9.]+ ns per triangle +1\.00$")
        self.assertRegex(rows[-1], r"^  everything kept +[0-9.]+ ns per triangle +[0-9.]+$")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:], verbosity=2)
