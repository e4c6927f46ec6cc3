"""Values of real drivers, where they are built (real_subjects): no clause accuses one of an error
that its specification leaves open, and what is exact of them holds.

usage: shaded_values_test.py PROGRAM FOLDER
"""
import glob
import os
import subprocess
import sys
import unittest

PROGRAM, FOLDER = (os.path.abspath(path) for path in sys.argv[1:3])
DRIVERS = glob.glob(os.path.join(FOLDER, "*-values.so"))


def check(driver, *options):
    done = subprocess.run(
        [PROGRAM, "check", "--plugin", driver, "--memory-limit", "0", "--no-cause", *options],
        capture_output=True, timeout=300, check=False, text=True)  # fmt: skip
    return done.returncode, done.stdout + done.stderr


@unittest.skipUnless(DRIVERS, "no driver: build real_subjects")
class ShadedValues(unittest.TestCase):
    def test_the_legal_set_of_the_api_is_kept(self):
        for driver in DRIVERS:
            with self.subTest(driver=driver):
                api = os.path.basename(driver).split("-")[0]
                _, text = check(driver, "--profile", api, "--device", "--cases", "40")
                self.assertIn(", 0 violated,", text)

    def test_flat_values_and_differences_are_exact(self):
        for driver in DRIVERS:
            with self.subTest(driver=driver):
                status, text = check(
                    driver, "--cases", "40", "--property", "FlatValuesComeFromTheProvokingVertex",
                    "--property", "QuadDifferencesEqualDifferencesOfValues")  # fmt: skip
                self.assertEqual(status, 0, text)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
