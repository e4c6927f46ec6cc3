"""Targets of more than 2^24 samples: bugs there are found by default, right subjects hold, programs
are told that they are not asked, and memory that runs out is nobody's violation. And the inputs
that need the last bit of an integer edge function.

usage: large_target_test.py PROGRAM SOURCES EXAMPLES
"""
import os
import subprocess
import sys
import unittest

PROGRAM, SOURCES, EXAMPLES = (os.path.abspath(path) for path in sys.argv[1:4])
LARGE = "LargeTargetIsCoveredLikeASmallOne"
MODEL = "CoverageEqualsTheModel"


def check(*arguments):
    return subprocess.run([PROGRAM, "check", "--no-cause", *arguments], capture_output=True,
                          cwd=SOURCES, timeout=200, text=True, check=False)  # fmt: skip


class LargeTargets(unittest.TestCase):
    def test_bugs_beyond_a_float_and_8_bits_are_found(self):
        for mutant in ("target-index-in-float", "target-bins-of-8-bits"):
            found = check("--subject", f"mutant:{mutant}", "--property", LARGE)
            self.assertEqual(found.returncode, 1, mutant + found.stdout + found.stderr)
            self.assertIn("4097 x 4097", found.stdout)

    def test_right_subjects_hold(self):
        for name in ("spans-exact", "legal:snap-floor", "legal:y-up", "legal:sample-corner"):
            held = check("--subject", name, "--property", LARGE)
            self.assertEqual(held.returncode, 0, name + held.stdout + held.stderr)
        plugin = f"{EXAMPLES}/example_plugin.so"
        for profile in ((), ("--profile", "vulkan"), ("--profile", "gl"), ("--profile", "d3d11"),
                        ("--profile", "webgpu")):  # fmt: skip
            held = check("--plugin", plugin, "--property", LARGE, *profile)
            self.assertEqual(held.returncode, 0, str(profile) + held.stdout + held.stderr)
            self.assertIn("1 hold", held.stdout)

    def test_a_program_is_told_that_it_is_not_asked(self):
        told = check("--exec", "kit/examples/program.py", "--property", LARGE, "--cases", "3",
                     "--verbose")  # fmt: skip
        self.assertIn("is not asked above 2^24 samples", told.stdout)

    def test_memory_that_runs_out_is_no_violation(self):
        plugin = f"{EXAMPLES}/example_plugin.so"
        ran_out = check("--plugin", plugin, "--property", MODEL, "--case", "large-target:0@0",
                        "--memory-limit", "0.5")  # fmt: skip
        self.assertEqual(ran_out.returncode, 4, ran_out.stdout + ran_out.stderr)
        self.assertIn("512 MiB (--memory-limit)", ran_out.stdout)
        self.assertIn("raise --memory-limit", ran_out.stdout)


class WidthInputs(unittest.TestCase):
    def test_are_put_to_fixed_point_input_whatever_else_is_drawn(self):
        for mutant in ("width-values-32", "width-products-32"):
            found = check("--subject", f"mutant:{mutant}", "--property", MODEL, "--cases", "1")
            self.assertEqual(found.returncode, 1, mutant + found.stdout + found.stderr)
        held = check("--subject", "legal:width-values-34", "--property", MODEL, "--cases", "1")
        self.assertEqual(held.returncode, 0, held.stdout + held.stderr)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
