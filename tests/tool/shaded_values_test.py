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
MULTISAMPLED = glob.glob(os.path.join(FOLDER, "*-values-4x.so"))


def check(driver, *options):
    done = subprocess.run(
        [PROGRAM, "check", "--plugin", driver, "--memory-limit", "0", "--no-cause", *options],
        capture_output=True, timeout=300, check=False, text=True)  # fmt: skip
    return done.returncode, done.stdout + done.stderr


def legal_set_of(driver):
    name = os.path.basename(driver)
    is_vulkan = name.startswith("vulkan-")
    if name.endswith("-4x.so"):
        return "vulkan-standard-4x" if is_vulkan else "gl-4x"
    return "vulkan" if is_vulkan else "gl"


@unittest.skipUnless(DRIVERS + MULTISAMPLED, "no driver: build real_subjects")
class ShadedValues(unittest.TestCase):
    def test_the_legal_set_of_the_api_is_kept(self):
        for driver in DRIVERS + MULTISAMPLED:
            if "softpipe" in driver:  # its coverage breaks it: docs/findings.md, 2
                continue
            with self.subTest(driver=driver):
                judged_by = ["--profile", legal_set_of(driver), "--device"]
                _, text = check(driver, *judged_by, "--cases", "40")
                self.assertIn(", 0 violated,", text)

    def test_flat_values_and_differences_are_exact(self):
        for driver in DRIVERS + MULTISAMPLED:
            with self.subTest(driver=driver):
                status, text = check(
                    driver, "--cases", "40", "--property", "FlatValuesComeFromTheProvokingVertex",
                    "--property", "QuadDifferencesEqualDifferencesOfValues")  # fmt: skip
                self.assertEqual(status, 0, text)

    @unittest.skipUnless(MULTISAMPLED, "no driver with four samples: build real_subjects")
    def test_weights_at_samples_are_those_of_findings_16_and_17(self):
        """docs/findings.md. A driver that mends it fails here: then say so there."""
        for driver in MULTISAMPLED:
            if "-gpu-" in os.path.basename(driver):
                continue
            with self.subTest(driver=driver):
                _, text = check(
                    driver, "--cases", "20", "--property", "ClipBarycentricsStayWithinTheirError",
                )  # fmt: skip
                self.assertIn("observed 0x1p-2, 0x1.8p-1, 0x1p-2, expected 1/5", text)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
