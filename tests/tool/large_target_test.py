"""Targets of more than 2^24 samples: bugs there are found by default, right subjects hold, programs
are told that they are not asked, and memory that runs out is nobody's violation. And the inputs
that need the last bit of an integer edge function.

usage: large_target_test.py PROGRAM SOURCES EXAMPLES PLUGINS
"""
import os
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCES, EXAMPLES, PLUGINS = (os.path.abspath(path) for path in sys.argv[1:5])
LARGE = "LargeTargetIsCoveredLikeASmallOne"
MODEL = "CoverageEqualsTheModel"
SAME = "EarlierScenesLeaveNoTrace"

ENDS_UNDER_A_LIMIT = """#!{python}
# Draws nothing once, then ends where its memory is limited; elsewhere it gives no answer.
import os, resource, sys, time
draws = 0
for line in sys.stdin:
    _, number, width, height, _, _, vertices, triangles = line.split()[:8]
    for _ in range(int(vertices) + int(triangles)):
        sys.stdin.readline()
    draws += 1
    if resource.getrlimit(resource.RLIMIT_AS)[0] == resource.RLIM_INFINITY:
        time.sleep(1000)
    if draws > 1:
        os._exit(2)
    print("counts", number)
    print("\\n".join([" ".join("0" * int(width))] * int(height)), flush=True)
"""


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

    def test_verdicts_come_within_the_usual_memory_limit(self):
        def run(plugin):
            return check("--plugin", plugin, "--property", MODEL, "--case", "large-target:0@0")

        held = run(f"{EXAMPLES}/example_plugin.so")
        self.assertEqual(held.returncode, 0, held.stdout + held.stderr)
        found = run(f"{PLUGINS}/buggy_ROUNDS.so")
        self.assertEqual(found.returncode, 1, found.stdout + found.stderr)
        self.assertIn("of 67108864 samples", found.stdout)

    def test_what_ends_under_the_limit_and_hangs_without_it_is_not_decided(self):
        with tempfile.TemporaryDirectory() as folder:
            program = os.path.join(folder, "program.py")
            with open(program, "w", encoding="utf-8") as file:
                file.write(ENDS_UNDER_A_LIMIT.format(python=sys.executable))
            os.chmod(program, 0o755)
            told = check("--exec", program, "--property", SAME, "--cases", "1",
                         "--time-limit", "1", "--memory-limit", "8")  # fmt: skip
        self.assertEqual(told.returncode, 4, told.stdout + told.stderr)
        self.assertIn("without it it gave no answer in 4 s: raise --time-limit", told.stdout)


class WidthInputs(unittest.TestCase):
    def test_are_put_to_fixed_point_input_whatever_else_is_drawn(self):
        for mutant in ("width-values-32", "width-products-32"):
            found = check("--subject", f"mutant:{mutant}", "--property", MODEL, "--cases", "1")
            self.assertEqual(found.returncode, 1, mutant + found.stdout + found.stderr)
        held = check("--subject", "legal:width-values-34", "--property", MODEL, "--cases", "1")
        self.assertEqual(held.returncode, 0, held.stdout + held.stderr)

    def test_that_were_not_judged_are_not_held(self):
        with open(os.path.join(SOURCES, "kit", "examples", "console.c"), encoding="utf-8") as file:
            console = file.read()
        with tempfile.TemporaryDirectory() as folder:
            for most, status in ((4096, 0), (500, 4)):  # the inputs' target is wider than 500
                source, plugin = (os.path.join(folder, f"{most}.{end}") for end in ("c", "so"))
                with open(source, "w", encoding="utf-8") as file:
                    file.write(console.replace(
                        "  (void)state;\n", f"  if (scene->width > {most}) return 1;\n"
                        "  (void)state;\n"))  # fmt: skip
                subprocess.run(["cc", "-std=c11", "-O2", "-shared", "-fPIC", f"-I{SOURCES}", source,
                                "-o", plugin], check=True)  # fmt: skip
                done = check("--plugin", plugin, "--property", MODEL, "--cases", "20")
                self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        self.assertIn("refuses", done.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
