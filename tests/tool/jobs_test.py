"""Work that is shared: what is printed is the same for every number of workers and every batch.

usage: jobs_test.py PROGRAM SOURCES PLUGINS
"""
import json
import os
import re
import resource
import signal
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCES, PLUGINS = (os.path.abspath(path) for path in sys.argv[1:4])
JOBS = (1, 7)
BATCHES = (1, 32)
MODEL = "CoverageEqualsTheModel"


def run(*arguments):
    if arguments[:1] == ("check",):  # explaining takes longer than finding: causes_test.py has it
        arguments += ("--no-cause",)
    return subprocess.run([PROGRAM, *arguments], capture_output=True, cwd=SOURCES, timeout=900,
                          check=False)  # fmt: skip


def content(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def plugin(name):
    return ("--plugin", os.path.join(PLUGINS, f"{name}.so"))


def forbid_files():
    """Writing to files fails, as on a full disk."""
    signal.signal(signal.SIGXFSZ, signal.SIG_IGN)
    resource.setrlimit(resource.RLIMIT_FSIZE, (0, 0))


class LinesOfCases(unittest.TestCase):
    """check --cases-json: a line a drawn case, the same for every number of workers."""

    def lines(self, *arguments):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "cases.jsonl")
            done = run("check", "--cases", "60", "--cases-json", path, *arguments)
            self.assertIn(done.returncode, (0, 1), done.stderr)
            return [json.loads(line) for line in content(path).splitlines()]

    def test_name_each_case_and_what_it_reached(self):
        lines = self.lines("--property", MODEL, "--subject", "spans-exact")
        self.assertEqual(len({line["case"] for line in lines}), 60)
        self.assertEqual({line["outcome"] for line in lines}, {"holds", "not exercised"})
        self.assertTrue(any(line["near_edges"]["on_edge"] for line in lines))
        self.assertFalse(all(line["near_edges"]["on_edge"] for line in lines))

    def test_end_with_the_case_that_fails(self):
        lines = self.lines("--property", MODEL, "--subject", "mutant:ties-inclusive")
        self.assertLess(len(lines), 60)
        violated = [line["outcome"] == "violated" for line in lines]
        self.assertEqual(violated, [False] * (len(lines) - 1) + [True])

    def test_that_could_not_be_written_are_refused_before_any_case(self):
        done = run("check", "--cases-json", "no-such-folder/cases.jsonl")
        self.assertEqual((done.returncode, done.stdout), (2, b""))
        self.assertIn(b"no-such-folder/cases.jsonl: can't be written", done.stderr)

    def test_do_not_depend_on_the_workers(self):
        chosen = ("--subject", "spans-exact", "--property", MODEL,
                  "--property", "TriangleOrderKeepsCoverage")  # fmt: skip
        self.assertEqual(self.lines(*chosen, "--jobs", "1"), self.lines(*chosen, "--jobs", "2"))


class Check(unittest.TestCase):
    def same(self, *arguments, status=0, batches=BATCHES, jobs=JOBS):
        """What is printed for every number of jobs and every batch: one text."""
        said = {}
        for n, batch in [(n, batches[0]) for n in jobs] + [(2, batch) for batch in batches[1:]]:
            done = run("check", *arguments, "--jobs", str(n), "--batch", str(batch), "--verbose")
            self.assertEqual(done.returncode, status, done.stdout.decode() + done.stderr.decode())
            said.setdefault(done.stdout, []).append((n, batch))
        self.assertEqual(len(said), 1, f"{list(said.values())} differ")
        (text,) = said
        return text.decode()

    def test_a_builtin_subject(self):
        text = self.same("--subject", "spans-exact", "--cases", "8")
        self.assertGreater(text.count("\nholds "), 35, text)

    def test_several_failures_at_once(self):
        text = self.same("--subject", "textbook", "--cases", "24", status=1)
        self.assertGreater(text.count("\nviolated "), 1, text)

    def test_a_profile_from_a_pipe_is_read_once(self):
        read, write = os.pipe()
        os.write(write, b'{"name": "piped", "subpixel_bits": 8}')
        os.close(write)
        command = [PROGRAM, "check", "--subject", "i64-snap8", "--profile", f"/dev/fd/{read}",
                   "--property", MODEL, "SharedEdgeSamplesAreCoveredOnce", "--cases", "8",
                   "--jobs", "2"]  # fmt: skip
        done = subprocess.run(command, capture_output=True, pass_fds=(read,), timeout=900,
                              check=False)  # fmt: skip
        os.close(read)
        self.assertEqual(done.returncode, 0, done.stdout.decode() + done.stderr.decode())

    def test_a_mutant(self):
        text = self.same("--subject", "mutant:box-left", "--cases", "24", status=1)
        self.assertIn("replay: ", text)

    def test_a_plugin_of_every_kind(self):
        for kind in ("COUNTS", "MASK", "PRIMITIVE_IDS", "FRAGMENTS"):
            with self.subTest(kind=kind):
                text = self.same(*plugin(f"shown_{kind}"), "--cases", "11")
                self.assertGreater(text.count("\nholds "), 15, text)

    def test_plugins_that_fail(self):
        for name, found in (("SCISSOR", "ScissorOnlyCutsCoverage"),
                            ("FIRST_WINS", "PrimitiveIdFollowsTheStatedOrder"),
                            ("SUM", "FragmentBarycentricsSumToOne"),
                            ("MESH_MASK", "OneCallDrawsLikeItsTriangles")):  # fmt: skip
            with self.subTest(name=name):
                text = self.same(*plugin(f"shown_{name}"), "--property", found, "--property",
                                 "SharedEdgeSamplesAreCoveredOnce", "--cases", "22", status=1)
                self.assertIn("replay: ", text)

    def test_given_scenes(self):
        scenes = [os.path.join("scenes", name) for name in ("ties.json", "fan.json")]
        self.same(*scenes, "--subject", "textbook", status=1, batches=(32,))

    def test_a_folder_of_counterexamples(self):
        kept = []
        for n in JOBS:
            with tempfile.TemporaryDirectory() as folder:
                run("check", "--subject", "textbook", "--cases", "24", "--save", folder,
                    "--jobs", str(n))  # fmt: skip
                names = sorted(os.listdir(folder))
                kept.append([(name, content(os.path.join(folder, name))) for name in names])
        self.assertGreater(len(kept[0]), 1)
        self.assertEqual(kept[0], kept[1])

    def test_a_subject_whose_draws_depend_on_others_is_reported_with_both_answers(self):
        for batch in BATCHES:
            for n in (1, 2):
                done = run("check", *plugin("shown_EVERY_THIRD"), "--property", MODEL,
                           "--cases", "64", "--batch", str(batch), "--jobs", str(n))  # fmt: skip
                self.assertIn(done.returncode, (1, 4), done.stderr)
                text = done.stdout.decode()
                self.assertRegex(text, "depends on other scenes|is not deterministic")
                self.assertRegex(text, "first violated: .*; then (holds|not exercised)")

    def test_a_leak_between_the_scenes_of_a_call_is_reported_with_both_answers(self):
        text = run("check", *plugin("shown_BATCH_LEAK"), "--property", MODEL,
                   "--cases", "64").stdout.decode()  # fmt: skip
        self.assertIn("alone the case does not fail: what the subject draws depends on other "
                      "scenes; first violated: ", text)  # fmt: skip
        self.assertRegex(text, "; then (holds|not exercised)")

    def test_bad_numbers_are_refused(self):
        for option, most in (("--jobs", 256), ("--batch", 4096)):
            for bad in ("0", "-1", str(most + 1), "two", "1.5"):
                done = run("check", "--subject", "spans-exact", option, bad)
                self.assertEqual(done.returncode, 2, bad)
                self.assertEqual(done.stdout, b"")
                self.assertIn(f"give an integer of 1 to {most}", done.stderr.decode())

    def test_what_was_found_before_an_error_is_reported(self):
        # The folder takes no byte: the first violation that is to be saved ends the run.
        with tempfile.TemporaryDirectory() as folder:
            for n in JOBS:
                done = subprocess.run(
                    [PROGRAM, "check", "--subject", "textbook", "--cases", "24", "--save", folder,
                     "--verbose", "--jobs", str(n)],
                    cwd=SOURCES, timeout=900, stdout=subprocess.PIPE, stderr=subprocess.PIPE,
                    preexec_fn=forbid_files)  # fmt: skip
                self.assertEqual(done.returncode, 2, done.stderr)
                if n == 1:
                    first = done.stdout
                    self.assertIn(b"holds ", first)
                self.assertEqual(done.stdout, first)


class Certify(unittest.TestCase):
    def certificates(self, n, *arguments):
        with tempfile.TemporaryDirectory() as folder:
            done = run("certify", *arguments, "--jobs", str(n), "--out", folder,
                       "--scenes", "scenes/quick.json")  # fmt: skip
            self.assertIn(done.returncode, (0, 1), done.stderr)
            contents = {}
            for name in sorted(os.listdir(folder)):
                path = os.path.join(folder, name, "certificate.json")
                if not os.path.exists(path):
                    continue
                text = content(path).replace(folder, "FOLDER")
                text = re.sub(r'"seconds": [-+.e0-9]+', '"seconds": 0', text)
                contents[name] = re.sub(r'"command": "[^"]*"', '"command": ""', text, count=1)
            return contents

    def test_certificates_are_the_same_but_for_times(self):
        arguments = ("--subject", "spans-exact", "--subject", "textbook", "--cases", "6",
                     *plugin("shown_MASK"))  # fmt: skip
        one = self.certificates(1, *arguments)
        self.assertEqual(len(one), 3)
        for text in one.values():
            self.assertGreater(json.loads(text)["oracle_tiers"]["filter"], 0)
        self.assertEqual(self.certificates(7, *arguments), one)


class Selftest(unittest.TestCase):
    def test_its_table_is_the_same_but_for_times(self):
        only = [word for name in ("mutant:snap-truncates", "mutant:target-every-third-draw",
                                  "legal:ties-top-right", "mutant:tile-seams")
                for word in ("--only", name)]  # fmt: skip
        texts = set()
        for n in JOBS:
            done = run("selftest", *only, "--cases", "60", "--jobs", str(n))
            self.assertIn(done.returncode, (0, 1), done.stderr)
            texts.add(re.sub(r", \d+ s in all", "", done.stdout.decode()))
        self.assertEqual(len(texts), 1, texts)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
