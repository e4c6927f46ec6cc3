"""Programs on a pipe that refuse, change their answers, or answer what is no number.

usage: answers_test.py PROGRAM SOURCES EXAMPLES PLUGINS
"""
import os
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCES, EXAMPLES, PLUGINS = (os.path.abspath(path) for path in sys.argv[1:5])
MODEL = "CoverageEqualsTheModel"
DEGENERATE = "DegenerateTrianglesCoverNothing"
SCENE = "scenes/ties.json"


def run(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, cwd=SOURCES,
                          timeout=900, check=False)  # fmt: skip


def buggy(name):
    return os.path.join(PLUGINS, f"buggy_{name}.so")


def answering(row, head="'counts ' + number"):
    """A program that answers every request by the value of `row` for each of its rows, 0."""
    return (f"{sys.executable} -c \"\n"
            "import sys\n"
            "calls, row = 0, 0\n"
            "for line in sys.stdin:\n"
            "    word, number, w, h, s, space, vs, ts = line.split()[:8]\n"
            "    for _ in range(int(vs) + int(ts)): sys.stdin.readline()\n"
            "    calls += 1\n"
            f"    print({head}, flush=False)\n"
            f"    if not ({head}).startswith('refused'):\n"
            f"        for _ in range(int(h)): print(*[{row}] * int(w))\n"
            "    sys.stdout.flush()\n\"")  # fmt: skip


class Greetings(unittest.TestCase):
    def test_a_greeting_is_no_violation(self):
        with tempfile.TemporaryDirectory() as folder:
            greets = os.path.join(folder, "greets.py")
            with open(greets, "w", encoding="utf-8") as file:
                file.write("print('Mine 1.0', flush=True)\nimport sys\nsys.stdin.read()\n")
            done = run("check", "--exec", f"{sys.executable} {greets}", "--cases", "3")
        self.assertEqual(done.returncode, 2, done.stdout)
        self.assertIn(b'its first line is "Mine 1.0", not "counts 1"; write only',
                      done.stderr)  # fmt: skip


class Refusals(unittest.TestCase):
    def check(self, *arguments, cases="120"):
        done = run("check", *arguments, "--property", DEGENERATE, "--cases", cases)
        return done.returncode, done.stdout.decode()

    def test_are_reported_and_what_holds_holds_where_it_did_not_refuse(self):
        often = "('refused ' + number + ' odd' if int(w) % 3 == 0 else 'counts ' + number)"
        status, text = self.check("--exec", answering("row", often))
        self.assertEqual(status, 0, text)
        self.assertRegex(text, "holds where it did not refuse: "
                         r"exercised in \d+ of 120 cases, \d+ refused")  # fmt: skip

    def test_of_more_than_half_are_inconclusive_not_green(self):
        all_but_two = "('refused ' + number + ' tired' if calls > 2 else 'counts ' + number)"
        status, text = self.check("--exec", answering("row", all_but_two))
        self.assertEqual(status, 4, text)
        self.assertRegex(text, "the subject refuses too much: "
                         r"exercised in 2 of 120 cases, \d+ refused")  # fmt: skip
        status, text = self.check("--plugin", buggy("REFUSES"), cases="9")
        self.assertEqual(status, 4, text)

    def test_of_all_that_was_drawn_for_one_place_are_inconclusive(self):
        def checked(which):
            with tempfile.NamedTemporaryFile("w", suffix=".subject") as file:
                print(f"command {sys.executable} {SOURCES}/tests/tool/refuses_ties.py {which} "
                      f"{PROGRAM} pipe answer plugin:{EXAMPLES}/example_plugin.so\n"
                      "profile gl-canonical\ncoverage facing-counts\ninput float32",
                      file=file, flush=True)  # fmt: skip
                return run("check", "--subject", file.name, "--property", MODEL, "--cases", "600")

        done = checked("horizontal")
        text = done.stdout.decode()
        self.assertEqual(done.returncode, 4, text)
        self.assertRegex(text, r"refuses all \d+ cases with a sample on a horizontal edge: "
                         r"exercised in \d+ of 600 cases, \d+ refused")  # fmt: skip
        self.assertNotIn("refuses too much", text)
        done = checked("tenth")
        self.assertEqual(done.returncode, 0, done.stdout.decode())
        self.assertIn(b"holds where it did not refuse", done.stdout)

    def test_of_a_given_scene_are_inconclusive(self):
        done = run("check", SCENE, "--plugin", buggy("REFUSES"), "--property", MODEL)
        self.assertEqual(done.returncode, 4, done.stdout)
        self.assertIn(b"refused ", done.stdout)
        for verb in ("replay", "explain"):
            done = run(verb, SCENE, "--plugin", buggy("REFUSES"), "--property", MODEL)
            self.assertEqual(done.returncode, 4, done.stdout + done.stderr)


class NoNumbers(unittest.TestCase):
    def test_a_depth_that_is_none_is_a_finding_with_its_witness(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "nan.subject")
            program = os.path.join(folder, "nan.sh")
            row = "-1 if ts == '0' else '0 1 0 0 nan'"
            with open(program, "w", encoding="utf-8") as file:
                file.write("exec " + answering(row, "'fragments ' + number"))
            with open(path, "w", encoding="utf-8") as file:
                file.write(f"command /bin/sh {program}\ncoverage fragments\ntakes window\n")
            done = run("check", "--subject", path, "--property", "FragmentDepthStaysInTheHull",
                       "--cases", "9", "--no-cause")  # fmt: skip
        self.assertEqual(done.returncode, 1, done.stdout.decode() + done.stderr.decode())
        self.assertIn(b"observed nan, expected a depth of [", done.stdout)


class ChangingAnswers(unittest.TestCase):
    def test_an_answer_that_does_not_come_again_is_inconclusive_with_both(self):
        done = run("check", "--exec", answering("row + (1 if calls == 2 else 0)"), "--property",
                   DEGENERATE, "--cases", "9")  # fmt: skip
        self.assertEqual(done.returncode, 4, done.stdout)
        self.assertRegex(done.stdout.decode(),
                         "not deterministic.*; first violated: .*; then holds")  # fmt: skip


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=0)
