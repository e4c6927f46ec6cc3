"""widths: how many bits the values of an integer edge function take, and the inputs that need them.

usage: widths_test.py PROGRAM
"""
import json
import os
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.path.abspath(sys.argv[1])
KNOWN = ("--fixed", "12.4", "--target", "4096x4096", "--tile", "8")


def run(*arguments, folder=None):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, cwd=folder, timeout=900,
                          text=True)  # fmt: skip


def edge(a, b, p):
    """E in units of a 256th of a square pixel: 4 bits after the point of each factor."""
    (ax, ay), (bx, by), (px, py) = [[int(16 * v) for v in point] for point in (a, b, p)]
    return (px - ax) * (by - ay) - (py - ay) * (bx - ax)


class WidthsTest(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name

    def test_the_table_and_the_json_say_the_same(self):
        text = run("widths", *KNOWN)
        self.assertEqual(text.returncode, 0, text.stderr)
        told = run("widths", *KNOWN, "--json", "-")
        self.assertEqual(told.returncode, 0, told.stderr)
        widths = json.loads(told.stdout)["widths"]
        rows = text.stdout.split("\n\n")[1].splitlines()[1:]
        self.assertEqual(len(rows), len(widths))
        for row, width in zip(rows, widths):
            self.assertIn(f" {width['bits']}  a (", row)
            self.assertTrue(row.startswith(width["form"]), row)
        bits = {width["id"]: width["bits"] for width in widths}
        self.assertEqual([bits[name] for name in ("direct-b-a", "direct-e-box", "direct-e-target",
                                                  "direct-e-pixel-past", "stepped-step",
                                                  "stepped-tile-step", "affine-c")],
                         [17, 33, 34, 35, 21, 24, 32])  # fmt: skip

    def test_each_witness_of_e_takes_the_value_that_one_bit_less_does_not_hold(self):
        widths = json.loads(run("widths", *KNOWN, "--json", "-").stdout)["widths"]
        checked = 0
        for width in widths:
            if not width["value"].startswith("E"):
                continue
            witness = width["witness"]
            value = int(witness["value"])
            biases = (0, 1) if width["form"] == "biased" else (0,)
            self.assertIn(edge(witness["a"], witness["b"], witness["p"]) - value, biases)
            half = 2 ** (width["bits"] - 2)
            self.assertFalse(-half <= value < half, width["id"])
            self.assertTrue(-2 * half <= value < 2 * half, width["id"])
            checked += 1
        self.assertEqual(checked, 21)

    def test_witnesses_are_cases_that_a_sound_subject_draws(self):
        done = run("widths", "--fixed", "7.2", "--target", "64x48", "--save", "cases",
                   folder=self.folder)  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stderr)
        names = os.listdir(os.path.join(self.folder, "cases"))
        self.assertEqual(sum("-beyond-" not in name for name in names), 49)
        areas = sorted(int(name.split("-")[-1][:-5]) for name in names
                       if name.startswith("area-e-vertex-beyond-"))  # fmt: skip
        self.assertEqual(areas, list(range(8, 17)))  # 17 bits take legs as long as the range
        for name in ("direct-e-box", "direct-e-target", "affine-c", "area-e-vertex-beyond-12"):
            replayed = run("replay", f"cases/{name}.json", folder=self.folder)
            self.assertEqual(replayed.returncode, 0, replayed.stdout + replayed.stderr)

    def test_of_several_samples_witnesses_are_cases_too(self):
        done = run("widths", "--fixed", "7.2", "--target", "64x48", "--samples", "standard-4",
                   "--save", "cases", "--json", "widths.json", folder=self.folder)  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("2^-3 pixel; samples at (0.375, 0.125)", done.stdout)
        with open(os.path.join(self.folder, "widths.json"), encoding="utf-8") as file:
            told = json.load(file)
        self.assertEqual(told["samples"], [[0.375, 0.125], [0.875, 0.375], [0.125, 0.625],
                                           [0.625, 0.875]])  # fmt: skip
        for name in ("direct-e-box", "direct-e-target"):
            for subject in ((), ("--subject", "exact-integers")):
                replayed = run("replay", f"cases/{name}.json", *subject, folder=self.folder)
                self.assertEqual(replayed.returncode, 0, replayed.stdout + replayed.stderr)
                self.assertIn("holds", replayed.stdout)
            noted = run("check", f"cases/{name}.json", "--subject", "spans-exact", "--property",
                        "CoverageEqualsTheModel", folder=self.folder)  # fmt: skip
            self.assertIn("judged by spans-exact's profile", noted.stderr)
            other = run("replay", f"cases/{name}.json", "--subject", "spans-exact",
                        folder=self.folder)  # fmt: skip
            self.assertEqual((other.returncode, other.stdout), (2, ""))
            self.assertIn("spans-exact draws one sample a pixel, and this case has 4",
                          other.stderr)  # fmt: skip

    def test_bad_input_is_told_and_writes_nothing(self):
        for wrong, said in ((("--fixed", "12", "--target", "64x64"), "before and after the point"),
                            (("--fixed", "12.-4", "--target", "64x64"), "before and after"),
                            (("--fixed", "40.4", "--target", "64x64"), "1 to 31"),
                            (("--fixed", "1.0", "--target", "4x4"), "no sample lies in the range"),
                            (("--fixed", "12.4", "--target", "0x64"), "width and height"),
                            (("--fixed", "12.4", "--target", "64"), "width and height"),
                            (("--fixed", "12.4", "--target", "64x64", "--tile", "0"), "--tile"),
                            (("--fixed", "12.4", "--target", "64x64", "--samples", "standard-3"),
                             "--samples"),
                            (("--fixed", "12.4", "--target", "64x64", "--samples", "[[2, 0]]"),
                             "--samples"),
                            (("--fixed", "12.4", "--target", "65536x65536"), "--target")):
            done = run("widths", *wrong, "--save", "cases", folder=self.folder)
            self.assertEqual(done.returncode, 2, wrong)
            self.assertIn(said, done.stderr)
            self.assertEqual((done.stdout, os.listdir(self.folder)), ("", []))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
