"""Values from outside: what a description may say of them, and a library behind its host's pipe.

usage: shown_values_test.py PROGRAM PLUGINS
"""
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM, PLUGINS = (os.path.abspath(path) for path in sys.argv[1:3])
VALUES = f"plugin:{PLUGINS}/shown_VALUES.so"
REQUEST = """draw 1 2 1 1 window 3 1 wants=primitive-ids,values,derivatives channels=2
-2 -2 0 1
-2 6 0 1
6 -2 0 1
u perspective sample 0 0 8
q inverse-w centre
0 1 2
"""


def run(*arguments, given=""):
    return subprocess.run([PROGRAM, *arguments], input=given, text=True, capture_output=True,
                          timeout=60, check=False)  # fmt: skip


class Descriptions(unittest.TestCase):
    def test_contradictions_are_told_with_the_remedy(self):
        for lines, said in (
            ("shows values\n", "values need fragments, and requests that want them"),
            ("coverage fragments\nshows values\n", "the word wants under takes"),
            ("coverage counts\nprotocol 2\nshows values derivatives\n", "values need fragments"),
            ("coverage fragments\nprotocol 2\nshows derivatives\n", "shows values derivatives"),
            ("shows value\n", "edges, steps, centroids, values, derivatives"),
        ):
            with tempfile.NamedTemporaryFile("w", suffix=".subject", encoding="utf-8") as file:
                file.write("command true\n" + lines)
                file.flush()
                done = run("check", "--cases", "1", "--subject", file.name)
            self.assertEqual(done.returncode, 2, done.stdout)
            self.assertIn(said, done.stderr)

    def test_a_host_says_what_its_library_shows(self):
        described = run("pipe", "answer", VALUES, "--describe").stdout
        self.assertIn("\nshows values derivatives\n", described)
        with tempfile.NamedTemporaryFile("w", suffix=".subject", encoding="utf-8") as file:
            file.write(f"command {PROGRAM} pipe answer {VALUES}\n{described}")
            file.flush()
            done = run("check", "--cases", "2", "--no-cause", "--subject", file.name,
                       "--property", "FragmentBarycentricsSumToOne")  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)


class WideErrors(unittest.TestCase):
    def check(self, error):
        with tempfile.NamedTemporaryFile("w", suffix=".json", encoding="utf-8") as file:
            values = {"weights": "perspective", "error": {"absolute": error}}
            json.dump({"name": "mine", "contract": "none", "values": values}, file)
            file.flush()
            return run("check", "--subject", "mutant:values-exchanged", "--profile", file.name,
                       "--property", "ValuesStayWithinTheirError", "--cases", "20", "--no-cause")

    def test_an_error_by_which_exchanged_corners_pass_is_told(self):
        wide = self.check(1e30)
        self.assertEqual(wide.returncode, 4, wide.stdout + wide.stderr)
        told = re.search(r"the stated error is so wide that exchanged corners, or the other plane, "
                         r"would pass on (\d+) of (\d+) values", wide.stdout)  # fmt: skip
        self.assertTrue(told, wide.stdout)
        self.assertEqual(told[1], told[2])
        self.assertGreater(int(told[1]), 1000)
        narrow = self.check(1e-30)
        self.assertEqual(narrow.returncode, 1, narrow.stdout + narrow.stderr)
        self.assertNotIn("so wide", narrow.stdout)

    def test_a_sound_rasterizer_of_a_narrow_error_is_not_told_so(self):
        held = run("check", "--subject", "legal:values-rounded-correctly", "--property",
                   "ValuesStayWithinTheirError", "--cases", "20")  # fmt: skip
        self.assertEqual(held.returncode, 0, held.stdout + held.stderr)
        self.assertNotIn("so wide", held.stdout)


class Hosted(unittest.TestCase):
    def test_a_library_is_given_channels_and_answers(self):
        done = run("pipe", "answer", VALUES, given=REQUEST)
        self.assertEqual(done.stdout, "fragments 1\n0 2.5 1 0 1 0 0 0 3.5 1 0 1 0 0\n", done.stderr)

    def test_malformed_channels_are_told_with_their_place(self):
        for wrong, right in (("u smooth", "u perspective"), ("0 0\n", "0 0 8\n"), ("=65", "=2")):
            done = run("pipe", "answer", VALUES, given=REQUEST.replace(right, wrong))
            self.assertEqual((done.returncode, done.stdout), (2, ""))
            self.assertRegex(done.stderr, r"standard input: .*(channel 0|draw line).*; give .+")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=0)
