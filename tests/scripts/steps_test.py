"""Tests of scripts/steps.sh: what a step prints, keeps and returns; and of scripts/test_stages."""

import os
import pathlib
import pty
import subprocess
import tempfile
import unittest

SCRIPTS = pathlib.Path(__file__).resolve().parents[2] / "scripts"
STEPS = SCRIPTS / "steps.sh"
ENOUGH = 900  # seconds; a test that waits for so long has failed


class StepsTest(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.root = pathlib.Path(self.folder.name)

    def run_steps(self, text, **more):
        script = f"set -euo pipefail\nsource {STEPS}\n{text}\n"
        return subprocess.run(["bash", "-c", script], cwd=self.root, text=True, timeout=ENOUGH,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, check=False,
                              **more)  # fmt: skip

    def log(self, name):
        return (self.root / "out/logs" / name).read_text(encoding="utf-8")

    def test_what_a_step_prints_goes_to_its_log_alone(self):
        done = self.run_steps("step 'package lists' sh -c 'echo chatter; echo more >&2'")
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stdout, r"\A   package lists: \d+ s\n\Z")
        self.assertEqual(self.log("package-lists.log"), "chatter\nmore\n")

    def test_a_step_that_fails_keeps_its_status_and_shows_the_end_of_its_log(self):
        done = self.run_steps("step build sh -c 'seq 1000; echo error: no; exit 7'")
        self.assertEqual(done.returncode, 7)
        self.assertIn("build: FAILED with status 7", done.stdout)
        self.assertIn("out/logs/build.log\n", done.stdout)
        self.assertTrue(done.stdout.endswith("   | 1000\n   | error: no\n"), done.stdout)
        self.assertNotIn("| 900\n", done.stdout)
        self.assertIn("900\n", self.log("build.log"))

    def test_a_failure_is_shown_as_the_caller_says(self):
        done = self.run_steps("show() { echo seen: $(cat $1); }\n"
                              "SHOW_FAILURE=show step a sh -c 'echo x ${SHOW_FAILURE-y}; false' ||"
                              " echo status $?")  # fmt: skip
        self.assertIn("seen: x y\nstatus 1\n", done.stdout)

    def test_without_a_terminal_a_long_step_says_how_far_it_is(self):
        # The looks at the log follow each other at once, and the step ends when it was looked at.
        quick = STEPS.read_text(encoding="utf-8").replace("readonly TICK=1 ", "readonly TICK=0.01 ")
        quick = quick.replace("readonly STALL=8 ", "readonly STALL=0 ")
        self.assertIn("STALL=0", quick)
        (self.root / "quick.sh").write_text(quick, encoding="utf-8")
        script = ("set -euo pipefail\nsource ./quick.sh\n: >said\n"
                  "until_seen() { echo half way; until grep -q 'half way' said; do :; done; }\n"
                  "step long until_seen >said\n")  # fmt: skip
        done = subprocess.run(["bash", "-c", script], cwd=self.root, timeout=ENOUGH, check=False)
        said = (self.root / "said").read_text(encoding="utf-8")
        self.assertEqual(done.returncode, 0)
        self.assertRegex(said, r"(?m)^   long: \d+ s  half way$")
        self.assertRegex(said, r"long: \d+ s\n\Z")

    def test_on_a_terminal_there_is_one_line(self):
        leader, follower = pty.openpty()
        environment = {**os.environ, "TERM": "xterm"}
        environment.pop("CI", None)
        script = f"source {STEPS}\nstep short sh -c 'echo chatter'"
        done = subprocess.run(["bash", "-c", script], cwd=self.root, timeout=ENOUGH, check=False,
                              stdout=follower, stderr=follower, env=environment)  # fmt: skip
        os.close(follower)
        said = os.read(leader, 65536).decode()
        os.close(leader)
        self.assertEqual(done.returncode, 0)
        self.assertEqual(said.count("\n"), 1, said)
        self.assertRegex(said, r"\r\x1b\[K   short: \d+ s\r\n\Z")

    def test_a_folder_that_cannot_be_written_is_the_callers_to_mend(self):
        (self.root / "out").write_text("a file", encoding="utf-8")
        done = self.run_steps("step build echo built")
        self.assertEqual(done.returncode, 2)
        self.assertIn("cannot write out/logs/build.log", done.stdout)

    def test_nothing_is_left_running(self):
        done = self.run_steps("step a true\nstep b true\njobs -p")
        self.assertRegex(done.stdout, r"\A   a: \d+ s\n   b: \d+ s\n\Z")


class StagesTest(unittest.TestCase):
    STAGES = ("checks", "proofs", "release", "sanitized", "tidy", "readme")

    def run_stages(self, **bodies):
        """Runs all stages, each of them `true` but those given. Returns the status and a line for
        each."""
        lines = [f"stage_{name}() {{ {bodies.get(name, 'true')}; }}" for name in self.STAGES]
        begin = f"source {SCRIPTS / 'test_stages'}"
        end = ('run_stages "${STAGES[@]}"', 'printf "summary %s\\n" "${summary[@]}"',
               'exit "$status"')  # fmt: skip
        script = "\n".join([begin, *lines, *end])
        done = subprocess.run(["bash", "-c", script], text=True, timeout=ENOUGH, check=False,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT)  # fmt: skip
        said = [line.removeprefix("summary ") for line in done.stdout.splitlines()
                if line.startswith("summary ")]  # fmt: skip
        self.assertEqual([line.split(":")[0] for line in said], list(self.STAGES), done.stdout)
        return done.returncode, [line.split(": ", 1)[1] for line in said]

    def test_all_stages_run_and_pass(self):
        status, said = self.run_stages()
        self.assertEqual(status, 0)
        for line in said:
            self.assertRegex(line, r"\Apassed, \d+ s\Z")

    def test_a_stage_that_fails_hides_no_other(self):
        status, said = self.run_stages(checks="(exit 8)", sanitized="false; echo never")
        self.assertEqual(status, 1)
        self.assertRegex(said[0], r"\AFAILED with status 8, \d+ s\Z")
        self.assertRegex(said[3], r"\AFAILED with status 1, \d+ s\Z")
        for line in (said[1], said[2], said[4], said[5]):
            self.assertRegex(line, r"\Apassed, ")

    def test_what_needs_a_build_that_failed_says_so(self):
        status, said = self.run_stages(release="die 3 'it does not compile'", tidy="false")
        self.assertEqual(status, 3)
        self.assertRegex(said[2], r"\AFAILED with status 3, ")
        self.assertRegex(said[3], r"\Apassed, ")
        self.assertRegex(said[4], r"\AFAILED with status 1, ")
        self.assertEqual(said[5], "not run, because the build of stage release failed")

    def test_the_status_is_that_of_the_first_that_failed(self):
        self.assertEqual(self.run_stages(proofs="false", tidy="(exit 3)")[0], 1)
        self.assertEqual(self.run_stages(checks="die 2 'no disk'", proofs="false")[0], 2)


if __name__ == "__main__":
    unittest.main()
