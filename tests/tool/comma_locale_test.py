"""A right rasterizer is right where the user's locale writes 3,5 for 3.5.

usage: comma_locale_test.py PROGRAM SOURCES [SERVER_HEADERS]

SERVER_HEADERS: a folder whose kit/ is taken in place of SOURCES's, to see what another one does.
"""
import os
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCES = (os.path.abspath(path) for path in sys.argv[1:3])
HEADERS = [os.path.abspath(sys.argv[3])] if len(sys.argv) > 3 else []
COMMA = os.path.join(SOURCES, "tests", "tool", "comma", "comma.c")
DRIVER = os.path.join(SOURCES, "kit", "plugin_driver.c")
PROPERTY = "CoverageEqualsTheModel"
PACKAGE = f"""
import locale
locale.setlocale(locale.LC_ALL, "")
import rasterproof
draw = lambda triangles, size: rasterproof.coverage(triangles, size, "gl-canonical")
report = rasterproof.check(draw, "gl-canonical", cases=20, properties="{PROPERTY}")
print(report.text)
raise SystemExit(report.status)
"""
SUITE = """
#include "kit/gtest.h"
struct Comma {
  static void Describe(rasterproof_plugin& plugin) { plugin = *rasterproof_plugin_describe(); }
  static bool Draw(const rasterproof_scene&, const rasterproof_target&) { return false; }
};
RASTERPROOF_TEST(Comma, Comma, "gl-canonical", 60)
"""


class CommaLocale(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        made = subprocess.run(["localedef", "-i", "de_DE", "-f", "UTF-8", cls.path("de_DE.UTF-8")],
                              capture_output=True, text=True, check=False)  # fmt: skip
        if not os.path.exists(cls.path("de_DE.UTF-8")):
            raise AssertionError("localedef makes no de_DE; install the package locales: " +
                                 made.stderr)  # fmt: skip
        cls.environment = {**os.environ, "LOCPATH": cls.folder.name, "LC_ALL": "de_DE.UTF-8"}

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @classmethod
    def path(cls, name):
        return os.path.join(cls.folder.name, name)

    def built(self, name, *more):
        out = self.path(name)
        includes = [f"-I{folder}" for folder in (*HEADERS, SOURCES)]
        subprocess.run(["cc", "-std=c11", "-O1", "-ffp-contract=off", *includes, *more, COMMA, "-o",
                        out, "-lm"], check=True, cwd=self.folder.name)  # fmt: skip
        return out

    def run_here(self, *arguments):
        return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, check=False,
                              env=self.environment, timeout=900)  # fmt: skip

    def expect_held(self, *subject, cases=60):
        done = self.run_here("check", *subject, "--property", PROPERTY, "--cases", str(cases),
                             "--no-cause")  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn(": 1 hold, 0 violated", done.stdout)

    def test_the_locale_is_one_that_writes_a_comma(self):
        done = subprocess.run([sys.executable, "-c", "import locale; "
                               "print(locale.setlocale(locale.LC_ALL, ''), locale.str(3.5))"],
                              capture_output=True, text=True, env=self.environment,
                              check=True)  # fmt: skip
        self.assertIn("3,5", done.stdout)

    def test_a_plugin(self):
        self.expect_held("--plugin", self.built("comma.so", "-shared", "-fPIC"))

    def test_a_program_of_the_kits_server(self):
        program = self.built("comma", DRIVER)
        lines = subprocess.run([program, "--describe"], capture_output=True, text=True,
                               check=True).stdout  # fmt: skip
        with open(self.path("comma.subject"), "w", encoding="utf-8") as file:
            file.write(f"command {program}\n{lines}")
        self.expect_held("--subject", self.path("comma.subject"))

    def test_a_googletest_suite(self):
        program = self.path("comma_suite")
        with open(self.path("suite.cc"), "w", encoding="utf-8") as file:
            file.write(SUITE)
        includes = [f"-I{folder}" for folder in (*HEADERS, SOURCES)]
        subprocess.run(["cc", "-std=c11", "-O1", "-ffp-contract=off", *includes, "-c", COMMA, "-o",
                        self.path("comma.o")], check=True)  # fmt: skip
        subprocess.run(["c++", "-std=c++17", *includes, self.path("suite.cc"),
                        self.path("comma.o"), "-o", program, "-lgtest_main", "-lgtest", "-pthread",
                        "-lm"], check=True)  # fmt: skip
        done = subprocess.run([program, f"--gtest_filter=*.{PROPERTY}"], capture_output=True,
                              text=True, check=False,
                              env={**self.environment, "RASTERPROOF_COMMAND": PROGRAM})  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn("1 test.", done.stdout)

    def test_a_program_in_python(self):
        program = self.path("mine.py")
        with open(os.path.join(SOURCES, "kit/examples/program.py"), encoding="utf-8") as file:
            text = file.read()
        with open(program, "w", encoding="utf-8") as file:
            file.write("import locale; locale.setlocale(locale.LC_ALL, '')\n" + text)
        self.expect_held("--exec", f"{sys.executable} {program}", cases=2)

    def test_the_python_package_and_its_oracle(self):
        oracle = os.path.join(os.path.dirname(PROGRAM), "librasterproof_oracle.so.1")
        python = "/usr/bin/python3"  # Debian's has its numpy
        asked = [python, "-c", "import numpy"]
        has_numpy = os.path.exists(python) and subprocess.run(
            asked, capture_output=True, check=False).returncode == 0  # fmt: skip
        if not has_numpy or not os.path.exists(oracle):
            self.skipTest("no numpy, or no oracle beside the command")
        done = subprocess.run(
            [python, "-c", PACKAGE], capture_output=True, text=True, check=False,
            env={**self.environment, "RASTERPROOF_ORACLE": oracle, "RASTERPROOF_COMMAND": PROGRAM,
                 "PYTHONPATH": os.path.join(SOURCES, "kit/python"),
                 "PYTHONDONTWRITEBYTECODE": "1"})  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertIn(": 1 hold, 0 violated", done.stdout)

    def test_builds_that_are_swept(self):
        done = self.run_here("sweep", COMMA, "--build", "-O2 -ffp-contract=off", "--cases", "20")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_the_command_itself(self):
        done = self.run_here("coverage", os.path.join(SOURCES, "scenes/ties.json"))
        plain = subprocess.run([PROGRAM, "coverage", os.path.join(SOURCES, "scenes/ties.json")],
                               capture_output=True, text=True, check=True)  # fmt: skip
        self.assertEqual(done.stdout, plain.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
