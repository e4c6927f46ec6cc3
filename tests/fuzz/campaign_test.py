"""scripts/fuzz_campaign: it goes on where it was interrupted, an input found is an exit status, and
a campaign.json that can't be true is refused. The fuzzer is a program that prints lines as
libFuzzer does; its slices take less than a second of processor time, and count as one.

usage: campaign_test.py SOURCES
"""
import json
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPT = pathlib.Path(sys.argv[1]).resolve() / "scripts/fuzz_campaign"

# Its folder says what it does in which slice: "SEED WHAT" lines of the file `does`.
FUZZER = """#!/usr/bin/env python3
import os, pathlib, signal, sys
here = pathlib.Path(sys.argv[0]).parent
flags = dict(a[1:].split("=", 1) for a in sys.argv[1:] if a.startswith("-"))
paths = [a for a in sys.argv[1:] if not a.startswith("-")]
if "help" in flags:
    sys.exit("Usage: libFuzzer")
if "seed" not in flags:  # replays a file
    sys.exit(1 if pathlib.Path(paths[0]).read_text() == "bad" else 0)
seed = int(flags["seed"])
with open(here / "ran", "a") as ran:
    print(seed, flags["max_total_time"], file=ran)
does = dict(line.split() for line in (here / "does").read_text().splitlines()).get(str(seed))
if does in ("SIGTERM", "SIGKILL"):
    (here / "does").write_text("")
    os.kill(os.getppid(), getattr(signal, does))
    if does == "SIGTERM":
        signal.pause()  # until the campaign ends it
print(f"#5 INITED cov: {10 * seed} ft: 9 corp: 3/9b")
if does == "crash":
    pathlib.Path(flags["artifact_prefix"] + "crash-1234").write_text("bad")
    sys.exit("==1== ERROR: libFuzzer: deadly signal")
if does == "fail":
    sys.exit("no memory for the shadow")
(pathlib.Path(paths[0]) / f"new-{seed}").write_text("x")
print(f"#900 NEW cov: {10 * seed + 7} ft: 9 corp: 4/9b")
print(f"Done 1200 runs in {flags['max_total_time']} second(s)")
print("stat::number_of_executed_units: 1200")
print("340 exact signs")
"""


class CampaignTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.build, self.out = (pathlib.Path(folder.name) / name for name in ("build", "out"))
        self.file = self.out / "campaign.json"
        self.add_target("edge_sign")

    def add_target(self, name):
        fuzz = self.build / "fuzz"
        (fuzz / "seeds" / name).mkdir(parents=True)
        (fuzz / f"{name}_fuzzer").write_text(FUZZER)
        (fuzz / f"{name}_fuzzer").chmod(0o755)
        (fuzz / "does").write_text("")

    def does(self, *lines):
        (self.build / "fuzz/does").write_text("\n".join(lines))

    def ran(self):
        """(seed, seconds) of each slice that began."""
        return [tuple(map(int, line.split()))
                for line in (self.build / "fuzz/ran").read_text().splitlines()]  # fmt: skip

    def campaign(self, *arguments, minutes="0.05"):
        return subprocess.run(
            [sys.executable, "-B", SCRIPT, "--minutes", minutes, "--out", self.out, self.build,
             *arguments], capture_output=True, text=True, check=False)  # fmt: skip

    def expect(self, status, sentence, *arguments):
        done = self.campaign(*arguments)
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        self.assertIn(sentence, done.stdout + done.stderr)
        self.assertNotIn("Traceback", done.stderr)

    def change(self, change):
        told = json.loads(self.file.read_text())
        change(told, told["targets"]["edge_sign"])
        self.file.write_text(json.dumps(told))

    ROW = "| edge_sign | 0.1 | 3,600 | 1,200 | 1,020 | 10 | 37 | 0 |\n"

    def test_minutes_are_run_in_slices_with_their_number_as_seed(self):
        self.expect(0, self.ROW)
        self.assertEqual(self.ran(), [(1, 3), (2, 2), (3, 1)])
        self.assertEqual(sorted(p.name for p in (self.out / "edge_sign/corpus").iterdir()),
                         ["new-1", "new-2", "new-3"])  # fmt: skip
        self.expect(0, self.ROW)
        self.assertEqual(len(self.ran()), 3)

    def test_parsers_have_minutes_of_their_own(self):
        self.add_target("parse_case")
        done = self.campaign("--parser-minutes", "0.1", "--jobs", "1")
        self.assertIn("| parse_case | 0.1 | 7,200 |", done.stdout)
        self.assertIn(self.ROW, done.stdout)

    def test_an_interrupted_campaign_goes_on_with_the_slice_that_was_lost(self):
        for signal, status in (("SIGTERM", 130), ("SIGKILL", -9)):
            with self.subTest(signal):
                self.setUp()
                self.does(f"2 {signal}")
                self.assertEqual(self.campaign().returncode, status)
                slices = json.loads(self.file.read_text())["targets"]["edge_sign"]["slices"]
                self.assertEqual([piece["seed"] for piece in slices], [1])
                self.expect(0, self.ROW)
                self.assertEqual(self.ran(), [(1, 3), (2, 2), (2, 2), (3, 1)])

    def test_an_input_found_is_kept_and_ends_with_status_1(self):
        self.does("2 crash")
        crash = self.out / "edge_sign/crash-1234"
        for _ in range(2):
            self.expect(1, f"open: edge_sign, slice 2: {crash}; to see it: {self.build}/fuzz/"
                        f"edge_sign_fuzzer {crash}\n")  # fmt: skip
        self.assertEqual(len(self.ran()), 2, "an open target is not run on")
        self.assertIn('"status": "open"', self.file.read_text())
        self.assertIn("deadly signal", (self.out / "edge_sign/slice-2.log").read_text())

    def test_a_failure_without_an_input_is_open_too(self):
        self.does("1 fail")
        self.expect(1, "slice 1, exit status 1, no input saved")

    def test_an_input_that_campaign_json_does_not_name_is_replayed(self):
        folder = self.out / "edge_sign"
        folder.mkdir(parents=True)
        (folder / "crash-mended").write_text("good")
        self.expect(0, self.ROW)
        self.assertTrue((folder / "corpus/crash-mended").is_file())
        (folder / "oom-again").write_text("bad")
        self.expect(1, "found before")

    def test_a_campaign_json_that_lies_is_refused(self):
        self.assertEqual(self.campaign().returncode, 0)
        told = self.file.read_text()
        for change, sentence in (
            (lambda all, row: all.update(commit="0123"), "is of commit 0123, and the tree is at"),
            (lambda all, row: all.update(rasterproof_fuzz_campaign=1), "of another version than 2"),
            (lambda all, row: row.update(program="0" * 64), "is another program than the one of"),
            (lambda all, row: row["slices"].pop(0), "slice 1 has seed 2"),
            (lambda all, row: row["slices"][1].update(seconds=4000), "slice 2 took 4000 s"),
            (lambda all, row: row["slices"][1].update(executions=-1), "slice 2 has a count"),
            (lambda all, row: row["slices"][1].pop("edges"), "that can be read (KeyError: 'edges'"),
            (lambda all, row: row.update(status="open"), "its status is open with 0 inputs found"),
            (lambda all, row: row.update(status="open", found={"crash-9": ""}), "isn't there"),
        ):
            self.change(change)
            self.expect(2, sentence)
            self.expect(2, "to begin anew from the corpora in")
            self.file.write_text(told)
        for text in ("{", "[]", told[:-9]):
            self.file.write_text(text)
            self.expect(2, "is no campaign of fuzz targets that can be read")
            self.assertEqual(self.file.read_text(), text)

    def test_what_is_not_built_is_said(self):
        self.expect(2, "The target edge_sing is not built in", "edge_sing")
        (self.build / "fuzz/edge_sign_fuzzer").write_text("#!/bin/sh\necho Usage\n")
        self.expect(2, "only replays inputs: give a build of the preset fuzz.")
        (self.build / "fuzz/edge_sign_fuzzer").unlink()
        self.expect(2, "No fuzz target is built in")
        self.assertFalse(self.out.exists())


unittest.main(argv=sys.argv[:1])
