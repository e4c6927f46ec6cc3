"""The oracle's libraries as others link them: the examples in C, Rust and SystemVerilog, what the
shared library shows, and what it needs.

usage: oracle_library_test.py SOURCES BUILD CC
"""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

SOURCES, BUILD = (os.path.abspath(path) for path in sys.argv[1:3])
CC = sys.argv[3]
EXAMPLES = os.path.join(SOURCES, "kit/examples/oracle")
SHARED = os.path.join(BUILD, "librasterproof_oracle.so")


def run(*command, **options):
    return subprocess.run(command, capture_output=True, text=True, check=False, timeout=900,
                          **options)  # fmt: skip


class OracleLibrary(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = folder.name
        self.program = os.path.join(self.folder, "program")

    def build(self, *command):
        done = run(*command, cwd=self.folder)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def c_says_which_samples_are_wrong(self, *libraries):
        self.build(CC, "-std=c99", "-Wall", "-Wextra", "-Werror", "-pedantic", "-I",
                   os.path.join(BUILD, "include"), os.path.join(EXAMPLES, "oracle.c"), "-o",
                   self.program, *libraries)  # fmt: skip
        done = run(self.program)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("column 0 row 0: not covered, and must cover it\n", done.stdout)
        self.assertIn("11 of 64 samples contradict it\n", done.stdout)

    def test_from_c_shared(self):
        self.c_says_which_samples_are_wrong(SHARED, f"-Wl,-rpath,{BUILD}")

    def test_from_c_static(self):
        self.c_says_which_samples_are_wrong(os.path.join(BUILD, "librasterproof_oracle.a"),
                                            "-lstdc++", "-lm", "-lpicosat")  # fmt: skip

    def test_from_rust(self):
        self.build("rustc", "-o", self.program, os.path.join(EXAMPLES, "oracle.rs"), "-L", BUILD,
                   "-l", "rasterproof_oracle")  # fmt: skip
        done = run(self.program, env=os.environ | {"LD_LIBRARY_PATH": BUILD})
        self.assertEqual(done.stdout, "###?\n##?.\n#?..\n?...\n", done.stderr)

    def test_from_a_simulation(self):
        if not shutil.which("verilator"):
            self.skipTest("no Verilator; install verilator")
        self.build("verilator", "--binary", os.path.join(EXAMPLES, "oracle_dpi.sv"), "-LDFLAGS",
                   f"{SHARED} -Wl,-rpath,{BUILD}",
                   "-MAKEFLAGS", "OPT_FAST=-O0 OPT_GLOBAL=-O0")  # fmt: skip
        for argument, status, said in (((), 0, "no contradiction in 64 samples"),
                                       (("+inclusive",), -6, "7 samples contradict every legal")):
            done = run(os.path.join(self.folder, "obj_dir/Voracle_dpi"), *argument)
            self.assertEqual(done.returncode, status, done.stdout + done.stderr)
            self.assertIn(said, done.stdout + done.stderr)

    def test_shows_its_functions_and_nothing_else(self):
        shown = run("nm", "-D", "--defined-only", "--format=posix", SHARED).stdout.split("\n")
        names = {line.split()[0].split("@")[0] for line in shown if line}
        with open(os.path.join(SOURCES, "kit/rasterproof_oracle.h"), encoding="utf-8") as file:
            header = file.read()
        self.assertIn("rasterproof_oracle_covers", names)
        for name in names - {"RASTERPROOF_ORACLE_1"}:
            self.assertTrue(name.startswith("rasterproof_oracle_"), name)
            self.assertIn(f"{name}(", header)

    def test_needs_neither_gmp_nor_mpfr(self):
        needed = run("objdump", "-p", SHARED).stdout
        self.assertIn("libpicosat.so.1", needed)
        for library in ("libgmp", "libmpfr", "libassimp", "libpng"):
            self.assertNotIn(library, needed)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
