"""Saved cases: what a file may bring to run (nothing), and commands that are printed to be typed.

usage: saved_case_test.py PROGRAM SOURCES EXAMPLES PLUGINS
"""
import json
import os
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCES, EXAMPLES, PLUGINS = (os.path.abspath(path) for path in sys.argv[1:5])
PYTHON_EXAMPLE = os.path.join(SOURCES, "kit/examples/program.py")
CANARY_LIBRARY = os.path.join(PLUGINS, "canary.so")
MODEL = "CoverageEqualsTheModel"
VERBS = (("replay",), ("explain",), ("replay", "--shrink", "-"), ("convert", "--to", "case"))


def run(*arguments, program=PROGRAM, data=None, **environment):
    return subprocess.run([program, *arguments], input=data, capture_output=True, cwd=SOURCES,
                          timeout=900, check=False, env={**os.environ, **environment})  # fmt: skip


def content(path):
    with open(os.path.join(SOURCES, path)) as file:
        return file.read()


def type_in_bash(line):
    """Runs a printed command as a reader would: typed into a shell."""
    line = f"rasterproof() {{ {shlex.quote(PROGRAM)} \"$@\"; }}\n{line}"
    return subprocess.run(["bash", "-c", line], capture_output=True, cwd=SOURCES, timeout=900,
                          check=False)  # fmt: skip


def printed_command(text, verb):
    """Returns the command after "replay: " or at a message's end."""
    begin = text.rindex(f"rasterproof {verb}")
    return text[begin:].splitlines()[0]


class TemporaryFolder(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.mkdtemp(prefix="it's a folder ")
        self.addCleanup(shutil.rmtree, self.folder)
        self.canary = os.path.join(self.folder, "canary")

    def path(self, name):
        return os.path.join(self.folder, name)

    def write(self, name, text):
        with open(self.path(name), "w", encoding="utf-8") as file:
            file.write(text)
        return self.path(name)

    def case(self, subject, name="case.json", vertices=((0, 0), (4.25, 0), (0, 4.25)), **more):
        scene = {"rasterproof_scene": 1, "width": 4, "height": 4, "vertices": vertices,
                 "triangles": [[0, 1, 2]]}  # fmt: skip
        return self.write(name, json.dumps({"rasterproof_case": 2, "scene": scene,
                                            "subject": subject, **more}))  # fmt: skip


class FuzzInputs(TemporaryFolder):
    """A case as bytes for a fuzzer, and what a fuzzer saved as a case."""

    def encoded(self, source, *arguments):
        target = self.path("input")
        result = run("convert", source, *arguments, "--to", "fuzz-input", "-o", target)
        self.assertEqual(result.returncode, 0, result.stderr)
        return target

    def scene(self, path):
        with open(path, encoding="utf-8") as file:
            return json.load(file)["scene"]

    def test_an_encoded_scene_decodes_to_its_own_bits(self):
        for name, subject in (("ties", "f32-direct"), ("subnormal", "spans-exact")):
            source = os.path.join(SOURCES, "scenes", f"{name}.json")
            bytes_of_it = self.encoded(source, "--subject", subject)
            back = self.path("back.json")
            run("convert", bytes_of_it, "--subject", subject, "--to", "case", "-o", back)
            scene = self.write("scene.json", json.dumps(self.scene(back)))
            self.assertEqual(run("coverage", scene, "--subject", "exact").stdout,
                             run("coverage", source, "--subject", "exact").stdout)  # fmt: skip
            again = self.path("again")
            run("convert", back, "--subject", subject, "--to", "fuzz-input", "-o", again)
            with open(bytes_of_it, "rb") as one, open(again, "rb") as other:
                self.assertEqual(one.read(), other.read())

    def test_a_saved_input_is_replayed_as_it_is(self):
        ties = os.path.join(SOURCES, "scenes", "ties.json")
        saved = self.encoded(ties, "--subject", "textbook")
        asked = ("--subject", "textbook", "--property", "SharedEdgeSamplesAreCoveredOnce")
        result = run("replay", saved, *asked)
        self.assertEqual(result.returncode, 1, result.stderr)
        typed = type_in_bash(printed_command(result.stdout.decode(), "replay"))
        self.assertEqual(typed.stdout, result.stdout)
        self.assertEqual(run("replay", saved, "--subject", "spans-exact").returncode, 0)

    def test_bytes_mean_nothing_without_a_subject(self):
        saved = self.path("crash")
        with open(saved, "wb") as file:
            file.write(bytes([0, 11, 11, 0]))
        result = run("replay", saved)
        self.assertEqual(result.returncode, 2)
        self.assertIn(b"--subject", result.stderr)

    def test_text_is_a_fuzz_input_where_that_is_said(self):
        saved = self.write("crash", "AAAAAAAAAAAA")
        self.assertEqual(run("replay", saved, "--subject", "f32-direct").returncode, 2)
        result = run("replay", saved, "--subject", "spans-exact", "--fuzz-input")
        self.assertEqual(result.returncode, 0, result.stderr)


class Shrinking(TemporaryFolder):
    TIES = ("replay", "scenes/ties.json", "--property", "SharedEdgeSamplesAreCoveredOnce",
            "--subject")  # fmt: skip

    def test_the_smallest_case_takes_the_place_of_the_given_one(self):
        small = self.path("small.json")
        done = run(*self.TIES, "textbook", "--shrink", small)
        self.assertEqual(done.returncode, 1, done.stderr)
        scene = json.loads(content(small))["scene"]
        self.assertLess(len(scene["triangles"]),
                        len(json.loads(content("scenes/ties.json"))["triangles"]))  # fmt: skip
        again = type_in_bash(printed_command(done.stdout.decode(), "replay"))
        self.assertEqual((again.returncode, again.stdout), (1, done.stdout))
        piped = run(*self.TIES, "textbook", "--shrink", "-")
        self.assertEqual((piped.returncode, piped.stdout.decode()), (1, content(small)))
        few = run(*self.TIES, "textbook", "--shrink", "-", "--evaluations", "1")
        self.assertGreater(len(json.loads(few.stdout)["scene"]["triangles"]),
                           len(scene["triangles"]))  # fmt: skip

    def test_what_does_not_fail_is_refused(self):
        small = self.path("small.json")
        done = run(*self.TIES, "spans-exact", "--shrink", small)
        self.assertEqual((done.returncode, done.stdout), (2, b""))
        self.assertIn(b"nothing to shrink", done.stderr)
        self.assertFalse(os.path.exists(small))


class WhatAFileMayBring(TemporaryFolder):
    def outside(self):
        """A subject of each kind that sings when it is run or loaded, and its option."""
        touch = f"touch {shlex.quote(self.canary)}"
        described = self.write("x.subject", f"command sh -c {shlex.quote(touch)}\n")
        command = f"sh -c {shlex.quote(touch)}"
        return {
            f"exec:{command}": ("--exec", command),
            f"plugin:{CANARY_LIBRARY}": ("--plugin", CANARY_LIBRARY),
            described: ("--subject", described),
        }

    def sings(self):
        sang = os.path.exists(self.canary)
        if sang:
            os.remove(self.canary)
        return sang

    def test_a_canary_sings_if_the_command_line_names_it(self):
        for option in self.outside().values():
            run("replay", self.case("spans-exact"), *option, CANARY=self.canary)
            self.assertTrue(self.sings(), option)

    def test_no_file_makes_anything_run_that_is_not_ours(self):
        for subject, (option, value) in self.outside().items():
            path = self.case(subject)
            for verb in VERBS:
                with self.subTest(subject=subject, verb=verb):
                    done = run(*verb, path, "--property", MODEL, CANARY=self.canary)
                    self.assertFalse(self.sings())
                    self.assertEqual((done.returncode, done.stdout), (2, b""))
                    typed = shlex.split(printed_command(done.stderr.decode(), verb[0]))
                    self.assertEqual(typed, ["rasterproof", *verb, path, "--property", MODEL,
                                             option, value])  # fmt: skip

    def test_nothing_runs_of_a_case_on_standard_input(self):
        for subject in self.outside():
            with open(self.case(subject), "rb") as file:
                done = run("replay", "-", data=file.read(), CANARY=self.canary)
            self.assertFalse(self.sings())
            self.assertEqual(done.returncode, 2, done.stderr)

    def test_check_takes_only_the_scene_of_a_file(self):
        for subject in self.outside():
            done = run("check", self.case(subject), "--property", MODEL, CANARY=self.canary)
            self.assertFalse(self.sings())
            self.assertEqual(done.returncode, 0, done.stderr)

    def test_the_command_line_outdoes_the_file(self):
        for subject in self.outside():
            done = run("replay", self.case(subject), "--subject", "spans-exact", CANARY=self.canary)
            self.assertFalse(self.sings())
            self.assertEqual(done.returncode, 0, done.stderr)

    def test_subjects_of_ours_are_taken_from_the_file(self):
        ours = ("f32-direct", "exact-integers", "mutant:ties-inclusive", "legal:snap-floor")
        for subject in ours:
            done = run("replay", self.case(subject))
            self.assertIn(done.returncode, (0, 1), (subject, done.stderr))

    def test_a_program_with_a_subject_of_its_own_takes_that_one_too(self):
        own = os.path.join(EXAMPLES, "example_own_type")
        self.assertEqual(run("replay", self.case("Naive"), program=own).returncode, 0)
        self.assertEqual(run("replay", self.case(""), program=own).returncode, 0)
        refused = run("replay", self.case("Naive"))
        self.assertEqual(refused.returncode, 2)
        self.assertIn(b"there is no subject Naive", refused.stderr)

    def test_the_line_to_type_does_what_it_says(self):
        program = self.path("a program.py")
        shutil.copy(PYTHON_EXAMPLE, program)
        command = shlex.quote(program)
        done = run("replay", self.case(f"exec:{command}", "a case.json"))
        self.assertEqual(done.returncode, 2, done.stderr)
        again = type_in_bash(printed_command(done.stderr.decode(), "replay"))
        self.assertEqual(again.returncode, 0, again.stderr)

    def test_what_is_shown_of_a_name_is_all_that_is_in_it(self):
        hidden = "sh -c 'true'\r\x1b[2K\u202e harmless \u009b\x07"
        done = run("replay", self.case(f"exec:{hidden}"))
        self.assertEqual(done.returncode, 2)
        self.assertTrue(done.stderr.decode().strip().isprintable(), done.stderr)
        word = printed_command(done.stderr.decode(), "replay").split("--exec ")[1]
        echoed = subprocess.check_output(["bash", "-c", f"printf %s {word}"])
        self.assertEqual(echoed.decode(), hidden)

    def test_a_name_is_never_shown_at_a_length_that_nobody_reads(self):
        done = run("replay", self.case("exec:true " + "x" * 100000))
        self.assertEqual(done.returncode, 2)
        self.assertLess(len(done.stderr), 1000)
        self.assertIn(b"--exec", done.stderr)


class PrintedCommands(TemporaryFolder):
    def test_a_command_with_blanks_and_quotes_is_read_back_as_it_was(self):
        program = self.path("it's a \"program\".py")
        with open(PYTHON_EXAMPLE, encoding="utf-8") as file:
            inclusive = file.read().replace("not left_or_top", "False")
        self.write(program, inclusive)
        os.chmod(program, 0o755)
        chosen = ("--exec", shlex.quote(program))
        done = run("check", *chosen, "--property", MODEL, "--cases", "12", "--no-cause")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        again = type_in_bash(printed_command(done.stdout.decode(), "replay"))
        self.assertEqual(again.returncode, 1, again.stderr)
        self.assertIn(b"violated", again.stdout)
        hint = shlex.split(printed_command(done.stdout.decode(), "infer"))
        self.assertEqual(hint, ["rasterproof", "infer", *chosen])

    def test_files_with_blanks_and_quotes_are_read_back_as_they_were(self):
        ties = ((0.5, 0.5), (3.5, 0.5), (0.5, 3.5))
        for name in ("a 'case'.json", "$(touch x).json", "-case.json"):
            path = self.case("f32-direct-fma", name, vertices=ties)
            done = run("explain", path, "--subject", "mutant:ties-inclusive")
            self.assertEqual(done.returncode, 1, done.stderr)
            again = type_in_bash(printed_command(done.stdout.decode(), "explain"))
            self.assertEqual(again.returncode, 1, again.stderr)


class Explain(TemporaryFolder):
    DRTK9 = ("explain", "scenes/drtk9.json", "--subject", "f32-direct-fma")

    def test_a_chosen_pixel_has_its_own_counts(self):
        done = run(*self.DRTK9, "--pixel", "7,7")
        self.assertEqual(done.returncode, 1, done.stderr)
        first, chosen, *_ = done.stdout.decode().splitlines()
        self.assertIn("pixel (20, 0) => observed 2, expected 1", first)
        self.assertEqual(chosen, "chosen pixel (7, 7): observed 0, expected 1")

    def test_a_chosen_pixel_that_is_right_is_said_to_be_so(self):
        done = run(*self.DRTK9, "--pixel", "3,7")
        self.assertIn("chosen pixel (3, 7): observed 1, expected 1\n", done.stdout.decode())

    def test_the_command_that_is_printed_looks_at_the_same_pixel(self):
        done = run(*self.DRTK9, "--pixel", "7,7")
        again = type_in_bash(printed_command(done.stdout.decode(), "explain"))
        self.assertEqual(again.stdout, done.stdout)

    def test_a_case_that_exercised_nothing_is_inconclusive_as_in_a_replay(self):
        path = self.case("spans-exact", property="SharedEdgeSamplesAreCoveredOnce")
        self.assertEqual(run("replay", path).returncode, 4)
        self.assertEqual(run("explain", path).returncode, 4)


class SavedFailuresComeFirst(TemporaryFolder):
    FEW = ("--property", MODEL, "--cases", "1")

    @classmethod
    def setUpClass(cls):
        cls.found = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.found.cleanup)
        found = run("check", "--subject", "mutant:cracks-far-off", "--property", MODEL, "--cases",
                    "2000", "--no-cause", "--save", cls.found.name)  # fmt: skip
        assert found.returncode == 1, found.stdout
        (cls.name,) = os.listdir(cls.found.name)

    def setUp(self):
        super().setUp()
        self.saved = shutil.copytree(self.found.name, os.path.join(self.folder, "saved"))

    def check(self, subject, *arguments):
        return run("check", "--subject", subject, "--no-cause", "--save", self.saved, *arguments)

    def test_what_was_saved_is_asked_before_any_case_is_drawn(self):
        alone = run("check", "--subject", "mutant:cracks-far-off", *self.FEW)
        self.assertEqual(alone.returncode, 0, "the case drawn first does not show the bug")
        again = self.check("mutant:cracks-far-off", *self.FEW)
        self.assertEqual(again.returncode, 1, again.stdout)
        self.assertIn(self.name, again.stdout.decode())
        self.assertIn("1 cases\n", again.stdout.decode())
        self.assertEqual(os.listdir(self.saved), [self.name], "it is there already")

    def test_what_was_mended_goes_on_to_drawn_cases(self):
        held = self.check("spans-exact", "--property", MODEL, "--cases", "64")
        self.assertEqual(held.returncode, 0, held.stdout)
        self.assertIn("64 cases", held.stdout.decode())

    def test_another_failure_leaves_the_one_that_was_saved(self):
        path = os.path.join(self.saved, self.name)
        other = os.path.join(self.saved, f"mutant+ties-inclusive-{MODEL}.json")
        os.rename(path, other)  # ties are right there
        before = content(other)
        found = self.check("mutant:ties-inclusive", "--property", MODEL)
        self.assertEqual(found.returncode, 1, found.stdout)
        self.assertEqual(len(os.listdir(self.saved)), 2)
        self.assertEqual(content(other), before)

    def test_a_file_that_is_no_saved_failure_is_refused(self):
        for text, why in (("{", "bad.json"), (content("scenes/ties.json"), "no property")):
            with open(os.path.join(self.saved, "bad.json"), "w") as file:
                file.write(text)
            refused = self.check("f64-direct", *self.FEW)
            self.assertEqual(refused.returncode, 2, refused.stdout)
            self.assertIn(why, refused.stderr.decode())
            self.assertEqual(refused.stdout, b"")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=0)
