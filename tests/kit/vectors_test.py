"""The readers of vectors in kit/examples/vectors: each judges its rasterizer, and convicts it once
its tie rule is wrong. Those whose language is not installed are skipped, which is said.

usage: vectors_test.py PROGRAM SOURCES C-COMPILER
"""
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.path.abspath(sys.argv[1])
READERS = os.path.join(os.path.abspath(sys.argv[2]), "kit/examples/vectors")
COMPILER = sys.argv[3]
CASES = "50"
FEW_CASES = "20"  # of a profile that only one reader is asked about


class ReadersTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()

    def tearDown(self):
        self.folder.cleanup()

    def run_here(self, *command):
        return subprocess.run(command, capture_output=True, cwd=self.folder.name, timeout=900,
                              text=True)  # fmt: skip

    def generate(self, profile, form, out, *more):
        cases = FEW_CASES if os.path.exists(profile) else CASES
        done = self.run_here(PROGRAM, "vectors", "generate", "--profile", profile,
                             "--cases", cases, "--format", form, "--out", out, *more)  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stderr)

    def judge(self, profile, right, wrong):
        """Both are commands, run where the vectors lie."""
        done = self.run_here(*right)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertRegex(done.stdout, r"\Ano contradiction in \d+ cases\n\Z")
        done = self.run_here(*wrong)
        self.assertRegex(done.stdout, r"\n\d+ contradictions in \d+ cases\n\Z", profile)

    def both_profiles(self, form, out, more=()):
        for profile in ("vulkan", "d3d11-canonical", *more):
            with self.subTest(profile):
                self.generate(profile, form, out)
                yield profile

    def test_python(self):
        reader = [sys.executable, os.path.join(READERS, "reader.py"), "v.jsonl"]
        for profile in self.both_profiles("jsonl", "v.jsonl"):
            self.judge(profile, reader, [*reader, "inclusive"])

    @unittest.skipUnless(shutil.which("node"), "node is not installed")
    def test_javascript(self):
        reader = ["node", os.path.join(READERS, "reader.mjs"), "v.jsonl"]
        for profile in self.both_profiles("jsonl", "v.jsonl"):
            self.judge(profile, reader, [*reader, "inclusive"])

    def test_c(self):
        for profile in self.both_profiles("c", "vectors.h"):
            for inclusive in ("0", "1"):
                done = self.run_here(COMPILER, "-std=c99", "-O1", "-Wall", "-Wextra", "-Werror",
                                     "-I.", f"-DINCLUSIVE={inclusive}",
                                     os.path.join(READERS, "reader.c"),
                                     "-o", f"reader{inclusive}")  # fmt: skip
                self.assertEqual(done.returncode, 0, done.stderr)
            self.judge(profile, ["./reader0"], ["./reader1"])

    def judge_values(self, right, wrong):
        done = self.run_here(*right)
        self.assertRegex(done.stdout, r"\A0 of \d{4,} values are wrong\n\Z", done.stderr)
        done = self.run_here(*wrong)
        counts = re.search(r"^(\d+) of (\d+) values are wrong\n\Z", done.stdout, re.M)
        self.assertGreater(int(counts[1]), int(counts[2]) // 4, "affine for perspective")

    def test_values_in_c(self):
        profile = os.path.join(self.folder.name, "linear.json")
        values = {"linear": True, "inverse_w": True, "centres": True}
        with open(profile, "w", encoding="utf-8") as file:
            json.dump({"name": "mine", "subpixel_bits": 8, "coordinate_limit": 4096,
                       "values": values}, file)  # fmt: skip
        for name in ("d3d11-canonical", profile):
            self.generate(name, "c", "vectors.h", "--values")
            for affine in ("0", "1"):
                done = self.run_here(COMPILER, "-std=c99", "-O1", "-Wall", "-Wextra", "-Werror",
                                     "-I.", f"-DAFFINE={affine}",
                                     os.path.join(READERS, "values.c"),
                                     "-o", f"values{affine}")  # fmt: skip
                self.assertEqual(done.returncode, 0, done.stderr)
            self.judge_values(["./values0"], ["./values1"])

    @unittest.skipUnless(shutil.which("iverilog"), "iverilog is not installed")
    def test_values_in_systemverilog(self):
        self.generate("d3d11-canonical", "readmemh", ".", "--values")
        for affine in ("0", "1"):
            done = self.run_here("iverilog", "-g2012", "-I.", "-P", f"values.AFFINE={affine}",
                                 "-o", f"values{affine}", os.path.join(READERS, "values.sv"))
            self.assertEqual(done.returncode, 0, done.stderr)
        self.judge_values(["vvp", "-n", "values0"], ["vvp", "-n", "values1"])

    @unittest.skipUnless(shutil.which("iverilog"), "iverilog is not installed")
    def test_systemverilog(self):
        """Also of grids beside the locations' and of several samples, which the header states."""
        mine = {"name": "mine", "contract": "sample-exact", "coordinate_limit": 4096}
        four = [[0.375, 0.125], [0.875, 0.375], [0.125, 0.625], [0.625, 0.875]]
        files = [os.path.join(self.folder.name, name) for name in ("4.json", "12.json")]
        for path, bits, locations in zip(files, (4, 12), (four, four[:2])):
            with open(path, "w", encoding="utf-8") as file:
                json.dump(dict(mine, subpixel_bits=bits, sample_locations=locations), file)
        for profile in self.both_profiles("readmemh", ".", files):
            for inclusive in ("0", "1"):
                done = self.run_here("iverilog", "-g2012", "-I.", "-P",
                                     f"reader.INCLUSIVE={inclusive}", "-o", f"reader{inclusive}",
                                     os.path.join(READERS, "reader.sv"))  # fmt: skip
                self.assertEqual(done.returncode, 0, done.stderr)
            self.judge(profile, ["vvp", "-n", "reader0"], ["vvp", "-n", "reader1"])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)  # names what is skipped
