"""Subjects that misbehave as processes: what is said of each, with which status, and what is left.

usage: misbehaving_test.py PROGRAM SOURCES PLUGINS
"""
import glob
import json
import os
import re
import select
import signal
import subprocess
import sys
import tempfile
import unittest
import uuid

PROGRAM, SOURCES, PLUGINS = (os.path.abspath(path) for path in sys.argv[1:4])
SUBJECT = os.path.join(SOURCES, "tests/tool/misbehaves.py")
PYTHON = f"{sys.executable} -I -S"  # starts in a tenth of the limit
# What a subject that covers nothing keeps.
DEGENERATE = "DegenerateTrianglesCoverNothing"
# Of a subject's own time; a hang is given ten times that.
LIMIT = ("--time-limit", "0.3")
CHECK = ("check", "--no-cause")  # explaining takes longer than finding: causes_test.py has it
ENOUGH = 900  # seconds; a test that waits for so long has failed
TOKEN = "RASTERPROOF_TEST_TOKEN"


class Run:
    """A command, and every process that it leaves: they inherit a word in their environment."""

    def __init__(self, arguments, **more):
        self.token = f"{TOKEN}={uuid.uuid4()}"
        name, value = self.token.split("=")
        more = {"stdout": subprocess.PIPE, "stderr": subprocess.PIPE, **more}
        self.process = subprocess.Popen(arguments, cwd=SOURCES, env={**os.environ, name: value},
                                        **more)  # fmt: skip

    def end(self):
        """Waits until nobody holds the outputs. Returns the status and all that was said."""
        out, error = self.process.communicate(timeout=ENOUGH)
        text = (out or b"").decode() + (error or b"").decode()
        return self.process.returncode, text

    def wait_for(self, words):
        """Reads standard error up to the line."""
        for line in self.process.stderr:
            if words in line.decode():
                return
        raise AssertionError(f"it never said {words!r}")

    def left(self):
        """The processes that are still there once each was given the time to end."""
        left = []
        for name in os.listdir("/proc"):
            if not name.isdigit() or int(name) == self.process.pid:
                continue
            try:
                process = os.pidfd_open(int(name))
            except OSError:
                continue
            try:
                with open(f"/proc/{name}/environ", "rb") as file:
                    is_ours = self.token.encode() in file.read().split(b"\0")
                if is_ours and not select.select([process], [], [], ENOUGH)[0]:
                    left.append(name)
            except OSError:  # it ended in the meantime, or is another user's
                pass
            finally:
                os.close(process)
        return left

    def kill_left(self):
        for name in self.left():
            os.kill(int(name), signal.SIGKILL)


class Misbehaving(unittest.TestCase):
    def start(self, what, *more, **options):
        run = Run([PROGRAM, *CHECK, "--exec", f"{PYTHON} {SUBJECT} {what}", *LIMIT,
                   "--property", DEGENERATE, "--cases", "8", *more], **options)  # fmt: skip
        self.addCleanup(run.process.kill)
        self.addCleanup(run.kill_left)
        return run

    def expect(self, what, status, *words):
        run = self.start(what)
        got, text = run.end()
        self.assertEqual(got, status, text)
        for word in words:
            self.assertIn(word, text)
        self.assertEqual(run.left(), [], text)

    def test_a_sound_one_holds(self):
        self.expect("sound", 0, "1 hold")

    def test_what_it_says_is_marked_and_limited(self):
        run = self.start("warns")
        status, text = run.end()
        self.assertEqual(status, 0, text)
        said = re.findall(r"(?m)^program: a(?:nd another| warning)$", text)
        self.assertEqual(len(said), 20, text)
        self.assertRegex(text, r"(?m)^program: \.\.\. [1-9]\d* more lines$")
        self.assertEqual(text.count("another"), 10, text)

    def test_a_crash_is_reported_with_its_signal(self):
        self.expect("crashes", 1, "killed by signal 11")
        self.expect("dies-half-way", 1, "killed by signal 9", "before its answer was whole")

    def test_a_hang_is_reported_with_what_it_did(self):
        self.expect("spins", 1, "it hangs", "of processor time")
        self.expect("sleeps", 1, "it hangs", "slept for")
        self.expect("closes-input", 1, "it hangs", "slept for")

    def test_an_edge_value_that_hangs_among_quick_ones_is_reported_as_such(self):
        # Those before it are kept back while it is worked on.
        run = Run([PROGRAM, *CHECK, "--plugin", os.path.join(PLUGINS, "shown_EDGES_HANGS.so"),
                   *LIMIT, "--property", "EdgeErrorStaysWithinItsBound",
                   "--cases", "64"])  # fmt: skip
        status, text = run.end()
        self.assertEqual(status, 1, text)
        self.assertIn("it hangs: alone, on a fresh process", text)

    def test_a_line_without_an_end_is_reported_as_such(self):
        self.expect("floods-a-line", 1, "the most that a correct answer")
        run = Run([PROGRAM, *CHECK, "--exec", "cat /dev/zero", "--property", DEGENERATE,
                   "--cases", "8", "--memory-limit", "0"],
                  preexec_fn=lambda: limit_memory(1 << 30))  # fmt: skip
        status, text = run.end()
        self.assertEqual(status, 1, text)
        # Whether it has begun to speak when it is first asked is a matter of time.
        self.assertRegex(text, r"the most that a correct answer|before it was asked: \"(\\x00)+")

    def test_a_greeting_is_quoted_and_is_no_violation(self):
        # Whether it has begun to speak when it is first asked is a matter of time.
        status, text = self.start("greets").end()
        self.assertEqual(status, 2, text)
        self.assertRegex(text, r"(printed before it was asked:|its first line is) "
                               r'"hello\\x00\\x1b\[31m"')  # fmt: skip

    def test_answers_that_nobody_asked_for_are_reported_as_such(self):
        self.expect("says-more", 1, "it printed more than its answer")
        self.expect("answers-ahead", 1, "it printed more than its answer")

    def test_answers_without_an_end_are_reported_as_such(self):
        # Whether the second one is there when the first one was read is a matter of time.
        run = self.start("floods-lines")
        status, text = run.end()
        self.assertIn(status, (1, 4), text)
        self.assertRegex(text, "it printed more than|left over from an earlier answer")
        self.assertEqual(run.left(), [])

    def test_a_refusal_is_neither_good_nor_bad(self):
        self.expect("refuses", 4)

    def test_what_is_no_count_is_reported(self):
        self.expect("nan", 1, '"nan')

    def test_a_closed_output_is_reported(self):
        self.expect("closes-output", 1, "it closed its output before its answer was whole")

    def test_what_hung_once_is_a_finding_whatever_a_fresh_process_does(self):
        with tempfile.TemporaryDirectory() as folder:
            self.expect(f"hangs-once {folder}/marker", 1, "it hangs: it slept for",
                        "it did not happen again")  # fmt: skip

    def test_what_was_slow_once_is_judged_by_its_answer(self):
        # It needs 0.5 s and has 0.3; ten times the limit is 3 s.
        with tempfile.TemporaryDirectory() as folder:
            self.expect(f"slow-once {folder}/marker 0.5", 0, "1 hold")

    def test_children_of_a_subject_do_not_stay(self):
        self.expect("leaves-children", 0, "1 hold")
        self.expect("spins-with-children", 1, "it hangs")

    def test_a_slow_subject_is_too_slow_and_not_wrong(self):
        # It needs 2 s and has 0.3: alone, with ten times the limit, it answers. A busy machine
        # looks at it late, and takes what it did not see for less.
        run = self.start("needs 2")
        status, text = run.end()
        self.assertEqual(status, 4, text)
        self.assertIn("--time-limit", text)
        self.assertNotIn("violated  ", text)


class OnACall(unittest.TestCase):
    """What a process does on each fiftieth call, and a fresh one does not do again."""

    def check(self, what, *more, takes="window"):
        with tempfile.TemporaryDirectory() as folder:
            described = os.path.join(folder, "mine.subject")
            with open(described, "w", encoding="utf-8") as file:
                file.write(f"command {PYTHON} {SUBJECT} {what}\ntakes {takes}\n")
            run = Run([PROGRAM, *CHECK, "--subject", described, *LIMIT, "--property", DEGENERATE,
                       "--cases", "120", "--jobs", "1", *more])  # fmt: skip
            self.addCleanup(run.kill_left)
            status, text = run.end()
        self.assertEqual(run.left(), [], text)
        return status, text

    def test_a_hang_is_a_finding_with_its_case(self):
        for what, did in (("sleeps", "slept for"), ("spins", "of processor time")):
            for takes in ("window", "window batches"):
                with self.subTest(what=what, takes=takes):
                    status, text = self.check(f"{what}-on-a-call", takes=takes)
                    self.assertEqual(status, 1, text)
                    self.assertIn("it hangs: ", text)
                    self.assertIn(did, text)
                    self.assertIn("it did not happen again", text)
                    self.assertIn("replay: ", text)

    def test_a_crash_is_a_finding(self):
        for takes in ("window", "window batches"):
            with self.subTest(takes=takes):
                status, text = self.check("crashes-on-a-call", takes=takes)
                self.assertEqual(status, 1, text)
                self.assertIn("killed by signal 11", text)

    def test_what_is_slow_there_is_not_accused(self):
        for takes in ("window", "window batches"):
            with self.subTest(takes=takes):
                status, text = self.check("needs-on-a-call 0.5", takes=takes)
                self.assertEqual(status, 0, text)
                self.assertIn("1 hold", text)

    def test_what_the_limit_on_memory_ends_is_inconclusive_and_names_it(self):
        # A GiB at once, and 16 MiB a draw until there is no more.
        for what in ("allocates-on-a-call", "leaks"):
            for takes in ("window", "window batches"):
                with self.subTest(what=what, takes=takes):
                    status, text = self.check(what, "--memory-limit", "0.5", takes=takes)
                    self.assertEqual(status, 4, text)
                    self.assertIn("under --memory-limit (now 0.5 GiB)", text)
                    self.assertNotIn("violated  ", text)

    def test_a_crash_under_the_limit_on_memory_stays_a_finding(self):
        status, text = self.check("crashes-on-a-call", "--memory-limit", "0.5")
        self.assertEqual(status, 1, text)
        self.assertNotIn("--memory-limit", text)

    def test_one_that_restarts_by_design_holds(self):
        for takes in ("window", "window batches"):
            with self.subTest(takes=takes):
                status, text = self.check("restarts", takes=takes)
                self.assertEqual(status, 0, text)
                self.assertIn("1 hold", text)

    def test_one_that_ends_over_a_scene_has_not_restarted(self):
        status, text = self.check("ends-over-a-scene")
        self.assertEqual(status, 1, text)
        self.assertIn("ended with status 0", text)


def limit_memory(most_bytes):
    import resource  # pylint: disable=import-outside-toplevel

    resource.setrlimit(resource.RLIMIT_AS, (most_bytes, most_bytes))


class Ending(unittest.TestCase):
    """The command ends while its subject hangs."""

    def start(self, what="spins-with-children", limit="1000", **options):
        run = Run([PROGRAM, *CHECK, "--exec", f"{PYTHON} {SUBJECT} {what}",
                   "--property", DEGENERATE, "--cases", "8", "--time-limit", limit],
                  **options)  # fmt: skip
        self.addCleanup(run.process.kill)
        self.addCleanup(run.kill_left)
        return run

    def test_no_signal_leaves_a_hung_subject(self):
        for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGKILL):
            for what in ("spins-with-children", "ignores-its-end"):
                with self.subTest(number=number, what=what):
                    run = self.start(what)
                    run.wait_for("it hangs")
                    run.process.send_signal(number)
                    status, text = run.end()  # nobody holds its outputs
                    killed = number == signal.SIGKILL
                    self.assertEqual(status, -9 if killed else 128 + number, text)
                    if not killed:
                        self.assertIn("interrupted", text)
                    self.assertEqual(run.left(), [])

    def test_a_signal_to_ignore_is_ignored(self):
        def ignore():
            signal.signal(signal.SIGHUP, signal.SIG_IGN)

        run = self.start(preexec_fn=ignore)
        run.wait_for("it hangs")
        run.process.send_signal(signal.SIGHUP)
        run.process.send_signal(signal.SIGTERM)
        self.assertEqual(run.end()[0], 128 + signal.SIGTERM)

    def test_other_verbs_end_at_once_and_leave_nothing(self):
        run = Run([PROGRAM, "coverage", "scenes/ties.json", "--exec",
                   f"{PYTHON} {SUBJECT} spins-with-children",
                   "--time-limit", "1000"])  # fmt: skip
        run.wait_for("it hangs")
        run.process.send_signal(signal.SIGTERM)
        self.assertEqual(run.end()[0], -signal.SIGTERM)
        self.assertEqual(run.left(), [])

    def test_a_hung_plugin_goes_with_the_command(self):
        for number in (signal.SIGTERM, signal.SIGKILL):
            run = Run([PROGRAM, *CHECK, "--plugin", f"{PLUGINS}/buggy_HANG.so", "--property",
                       DEGENERATE, "--cases", "30", "--time-limit", "1000"])  # fmt: skip
            run.wait_for("it hangs")
            run.process.send_signal(number)
            run.end()
            self.assertEqual(run.left(), [])

    def test_a_pipe_behind_the_command_ends(self):
        words = (f"{PROGRAM} check --exec '{PYTHON} {SUBJECT} leaves-children' "
                 f"--property {DEGENERATE} --cases 8")  # fmt: skip
        for end in ("| cat", "2>&1 | cat", "2>&1 | head -1", "2>/dev/full | cat"):
            with self.subTest(end=end):
                run = Run(["/bin/sh", "-c", f"{words} {end}"])
                status, text = run.end()
                self.assertEqual(status, 0, text)
                self.assertEqual(run.left(), [])


class DoesNotRun(unittest.TestCase):
    """A program that ends by itself before its first answer, and those that end otherwise."""

    def ends(self, begin, at_each, *more):
        """Checks a program that covers nothing, runs `begin` first and `at_each` at each scene."""
        program = (f"import os, signal, sys\n{begin}\n"
                   "for number, line in enumerate(sys.stdin):\n"
                   "    word, number_of, w, h, s, space, vs, ts = line.split()[:8]\n"
                   "    w, h = int(w), int(h)\n"
                   "    for _ in range(int(vs) + int(ts)):\n"
                   "        sys.stdin.readline()\n"
                   f"    {at_each}\n"
                   "    rows = ' '.join(['0'] * w) + '\\n'\n"
                   "    sys.stdout.write('counts ' + number_of + '\\n' + rows * h)\n"
                   "    sys.stdout.flush()\n")  # fmt: skip
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "ends.py")
            with open(path, "w", encoding="utf-8") as file:
                file.write(program)
            return subprocess.run([PROGRAM, *CHECK, "--exec", f"{PYTHON} {path}", "--cases", "3",
                                   *more],
                                  capture_output=True, timeout=ENOUGH, check=False)  # fmt: skip

    def test_a_program_that_does_not_run_is_reported_once_with_its_last_words(self):
        for begin, at_each, words in (
            ("sys.exit('there is no module seen')", "pass", b"there is no module seen"),
            ("pass", "raise ValueError('no such word')", b"ValueError: no such word"),
            ("sys.exit(0)", "pass", b"with nothing"),
        ):
            for more in (("--property", DEGENERATE), ()):
                with self.subTest(begin=begin, more=more):
                    done = self.ends(begin, at_each, *more)
                    self.assertEqual(done.returncode, 2, done.stdout)
                    self.assertNotIn(b"violated", done.stdout)
                    self.assertEqual(done.stderr.count(b"before its first answer"), 1, done.stderr)
                    last = done.stderr[done.stderr.index(b"before its first answer"):]
                    self.assertIn(words, last)
                    self.assertIn(b"read requests from standard input", last)

    def test_a_program_that_ends_over_a_scene_or_by_a_signal_is_a_finding(self):
        for begin, at_each, words in (
            ("pass", "number == 1 and sys.exit(3)", b"ended with status 3"),
            ("pass", "w * h > 16 and sys.exit(3)", b"ended with status 3"),
            ("pass", "os.kill(os.getpid(), signal.SIGSEGV)", b"killed by signal 11"),
        ):
            with self.subTest(at_each=at_each):
                done = self.ends(begin, at_each, "--property", "DrawStaysInsideItsTarget")
                self.assertEqual(done.returncode, 1, done.stderr)
                self.assertIn(words, done.stdout)


class Start(unittest.TestCase):
    """What the command was started with is no matter of the subject's."""

    def check(self, what, status, words, **options):
        run = Run([PROGRAM, *CHECK, "--exec", f"{PYTHON} {SUBJECT} {what}", *LIMIT,
                   "--property", DEGENERATE, "--cases", "8"], **options)  # fmt: skip
        got, text = run.end()
        self.assertEqual(got, status, text)
        self.assertIn(words, text)

    def test_a_crash_is_one_where_the_ends_of_children_are_ignored(self):
        def ignore():
            signal.signal(signal.SIGCHLD, signal.SIG_IGN)

        self.check("crashes", 1, "killed by signal 11", preexec_fn=ignore)
        self.check("sound", 0, "1 hold", preexec_fn=ignore)

    def test_signals_that_are_blocked_are_not_blocked_for_subjects(self):
        def block():
            signal.pthread_sigmask(signal.SIG_BLOCK, {signal.SIGSEGV, signal.SIGTERM})

        self.check("says-its-signals", 0, "blocked: set()", preexec_fn=block)

    def test_closed_standard_files_do_not_matter(self):
        self.check("sound", 0, "1 hold", preexec_fn=lambda: os.close(0))
        self.check("sound", 0, "1 hold", preexec_fn=lambda: os.close(2))
        self.check("sound", 0, "1 hold", preexec_fn=lambda: (os.close(0), os.close(2)))

    def test_a_closed_standard_output_is_reported(self):
        self.check("sound", 2, "standard output", preexec_fn=lambda: os.close(1))

    def test_scenes_after_one_that_hangs_get_a_short_time(self):
        with tempfile.TemporaryDirectory() as folder:
            run = Run([PROGRAM, "certify", "--exec", f"{PYTHON} {SUBJECT} sleeps", *LIMIT,
                       "--scenes", "scenes/quick.json", "--cases", "1",
                       "--jobs", "1", "--out", folder])  # fmt: skip
            status, text = run.end()
            self.assertEqual(status, 1, text)
            (path,) = glob.glob(os.path.join(folder, "*", "certificate.json"))
            with open(path) as file:
                said = "\n".join(scene["message"] for scene in json.load(file)["measured"])
        self.assertEqual(said.count("it hangs: "), 1, said)
        self.assertIn("after a hang, scenes get less", said)

    def test_a_full_standard_error_ends_nothing(self):
        with open("/dev/full", "wb") as full:
            run = Run([PROGRAM, *CHECK, "--property", DEGENERATE, "--cases", "1", "--seed",
                       "random"], stderr=full)  # fmt: skip
            status, text = run.end()
        # 4: the one case drawn at random may have no degenerate triangle; still a verdict.
        self.assertIn(status, (0, 4), text)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[4:], verbosity=0)
