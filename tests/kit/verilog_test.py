"""The unit in SystemVerilog as a plugin: it holds, and with one bit less it does not.

usage: verilog_test.py PROGRAM SOURCES COMPILER
Exit status 77 where Verilator is not installed.
"""
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.path.abspath(sys.argv[1])
SOURCES = os.path.abspath(sys.argv[2])
COMPILER = sys.argv[3]
UNIT = os.path.join(SOURCES, "kit/examples/verilog")


class VerilogTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = folder.name
        root = cls.done("verilator", "--getenv", "VERILATOR_ROOT").stdout.strip()
        cls.include = os.path.join(root, "include")
        # The units' common part, which docs/hardware.md compiles with each.
        cls.support = [f"{name}.o" for name in ("verilated", "verilated_threads")]
        made = cls.compiled("-O0", "-c", *(os.path.join(cls.include, name[:-1] + "cpp")
                                           for name in cls.support))  # fmt: skip
        assert made.returncode == 0, made.stderr

    @classmethod
    def compiled(cls, *arguments):
        return cls.done(COMPILER, "-std=c++20", "-fPIC", "-I", SOURCES, "-isystem", cls.include,
                        "-isystem", os.path.join(cls.include, "vltstd"), *arguments)  # fmt: skip

    @classmethod
    def done(cls, *command):
        return subprocess.run(command, capture_output=True, cwd=cls.folder, timeout=900, text=True)

    def make(self, bits):
        """The unit of so many bits as a library."""
        name = f"unit{bits}"
        made = self.done("verilator", "--cc", "--build", "-CFLAGS", "-O1 -fPIC",
                         f"-GEDGE_BITS={bits}", "-Mdir", name,
                         os.path.join(UNIT, "triangle.sv"))  # fmt: skip
        self.assertEqual(made.returncode, 0, made.stderr)
        made = self.compiled("-O1", "-shared", "-isystem", name, os.path.join(UNIT, "plugin.cc"),
                             *self.support, os.path.join(name, "Vtriangle__ALL.a"),
                             "-o", f"{name}.so", "-pthread")  # fmt: skip
        self.assertEqual(made.returncode, 0, made.stderr)
        return f"./{name}.so"

    def test_one_bit_less_than_widths_says_is_convicted_by_its_input(self):
        saved = self.done(PROGRAM, "widths", "--fixed", "12.4", "--target", "2048x2048",
                          "--save", "widths")  # fmt: skip
        self.assertEqual(saved.returncode, 0, saved.stderr)
        witness = "widths/direct-e-box.json"
        judged = (PROGRAM, "check", witness, "--no-cause", "--property", "CoverageEqualsTheModel")
        sound = self.make(33)
        holds = self.done(*judged, "--plugin", sound)
        self.assertEqual(holds.returncode, 0, holds.stdout + holds.stderr)
        drawn = self.done(PROGRAM, "check", "--plugin", sound, "--cases", "30", "--no-cause",
                          "--property", "CoverageEqualsTheModel",
                          "--property", "SharedEdgeSamplesAreCoveredOnce")  # fmt: skip
        self.assertEqual(drawn.returncode, 0, drawn.stdout + drawn.stderr)
        violated = self.done(*judged, "--plugin", self.make(32))
        self.assertEqual(violated.returncode, 1, violated.stdout + violated.stderr)
        self.assertIn("observed front 0, back 0, expected front 1, back 0", violated.stdout)


if __name__ == "__main__":
    if not shutil.which("verilator"):
        print("verilator is not installed: the unit in SystemVerilog is not built")
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
