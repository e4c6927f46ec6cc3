"""The seeds that scripts/fuzz_seeds writes: every target has some, and those of cases are what
`rasterproof convert` makes of the cases.

usage: seeds_test.py RASTERPROOF SOURCES SEEDS
"""
import pathlib
import subprocess
import sys
import tempfile
import unittest

COMMAND = sys.argv[1]
SOURCES, SEEDS = (pathlib.Path(path).resolve() for path in sys.argv[2:4])
FOLDERS = ("scenes", "scenes/worst", "scenes/bugs", "docs/findings")
RAW = b"\xff\0"


def encoded(path, subject):
    """What the command makes of a case for a subject; nothing if the subject does not take it."""
    command = [COMMAND, "convert", path, "--to", "fuzz-input", "--subject", subject, "-o", "-"]
    return subprocess.run(command, capture_output=True, check=False).stdout


class Seeds(unittest.TestCase):
    def test_every_target_has_some_and_no_more_than_the_script_writes(self):
        targets = {path.name.removesuffix("_fuzzer.cc")
                   for path in (SOURCES / "fuzz").rglob("*_fuzzer.cc")}  # fmt: skip
        self.assertGreater(len(targets), 15)
        with tempfile.TemporaryDirectory() as folder:
            subprocess.run([SOURCES / "scripts/fuzz_seeds", folder], check=True)
            for target in targets:
                again = {path.name: path.read_bytes()
                         for path in pathlib.Path(folder, target).iterdir()}  # fmt: skip
                built = {path.name: path.read_bytes() for path in (SEEDS / target).iterdir()}
                self.assertTrue(built, target)
                self.assertEqual(built, again, target)

    def test_the_raw_code_of_a_case_is_the_command_s(self):
        compared = set()
        for seed in sorted((SEEDS / "cases").iterdir()):
            folder, _, name = seed.name.partition("-")
            paths = [SOURCES / where / f"{name}.json" for where in FOLDERS
                     if where.split("/")[-1] == folder]  # fmt: skip
            for subject in ("f32-direct", "f64-direct", "hom-exact") if paths else ():
                code = encoded(paths[0], subject)
                if code.startswith(RAW):
                    self.assertEqual(seed.read_bytes(), code, seed.name)
                    compared.add(seed.name)
                    break
        for name in ("scenes-nan", "scenes-clip_behind", "findings-gd_large_triangle",
                     "worst-f32-direct-BarycentricsSumToOne",
                     "worst-f32-direct-EdgeErrorStaysWithinItsBound",
                     "worst-f64-direct-BarycentricsSumToOne",
                     "worst-f64-direct-EdgeErrorStaysWithinItsBound"):  # fmt: skip
            self.assertIn(name, compared)


unittest.main(argv=sys.argv[:1])
