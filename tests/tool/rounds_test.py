"""rounds:FOLDER: check, replay and infer in rounds as on a pipe, and what is refused.

usage: rounds_test.py PROGRAM SOURCES
"""
import json
import os
import re
import shlex
import subprocess
import sys
import tempfile
import unittest

PROGRAM = os.path.abspath(sys.argv[1])
SOURCES = os.path.abspath(sys.argv[2])
DRAWS = os.path.join(SOURCES, "tests", "tool", "draws_fast.py")
PROPERTY = "SharedEdgeSamplesAreCoveredOnce"
MOST_ROUNDS_OF_SHRINK = 15
MOST_ROUNDS_OF_INFER = 10
CHECKED = [PROPERTY, "CoverageEqualsTheModel", "ReversalSwapsFacing", "SamplesLieInTheirPixel"]


class Rounds:
    """A folder in which a verb is asked and a program answers."""

    def __init__(self, folder, verb, *options):
        self.folder = folder
        self.directory = os.path.join(folder, "rounds")
        self.command = [PROGRAM, verb, "--subject", "rounds:rounds", *options]

    def path(self, number, ending):
        return os.path.join(self.directory, f"round-{number}.{ending}")

    def ask(self):
        return subprocess.run(self.command, capture_output=True, cwd=self.folder, timeout=900,
                              text=True)  # fmt: skip

    def answer(self, number, *how):
        with open(self.path(number, "requests"), encoding="utf-8") as requests, \
             open(self.path(number, "answers"), "w", encoding="utf-8") as answers:  # fmt: skip
            subprocess.run([sys.executable, DRAWS, *how], stdin=requests, stdout=answers,
                           timeout=900, check=True)  # fmt: skip

    def to_the_end(self, *how):
        """Returns the last call, and how many rounds there were."""
        for number in range(1, 40):
            done = self.ask()
            if not os.path.exists(self.path(number, "requests")):
                return done, number - 1
            assert done.returncode == 4, done.stderr
            self.answer(number, *how)
        raise AssertionError("there is no end")


class RoundsTest(unittest.TestCase):
    def setUp(self):
        self.holder = tempfile.TemporaryDirectory()
        self.folder = self.holder.name

    def tearDown(self):
        self.holder.cleanup()

    def describe(self, *how, profile="d3d11-canonical"):
        os.makedirs(os.path.join(self.folder, "rounds"), exist_ok=True)
        for name in ("mine.subject", os.path.join("rounds", "program.subject")):
            with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
                file.write(f"command {sys.executable} {DRAWS} {' '.join(how)}\n"
                           f"name draws\nprofile {profile}\n")  # fmt: skip

    def shrink(self, *options):
        return Rounds(self.folder, "replay", os.path.join(SOURCES, "scenes", "ties.json"),
                      "--property", PROPERTY, "--shrink", "small.json", *options)  # fmt: skip

    def infer(self, *options):
        return Rounds(self.folder, "infer", *options)

    def run_here(self, *arguments):
        return subprocess.run([PROGRAM, *arguments], capture_output=True, cwd=self.folder,
                              timeout=900, text=True)  # fmt: skip

    def small(self):
        with open(os.path.join(self.folder, "small.json"), encoding="utf-8") as file:
            return file.read()

    def assert_refused(self, done, *words):
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertFalse(os.path.exists(os.path.join(self.folder, "small.json")))

    def test_shrinks_as_replay_does(self):
        self.describe("inclusive")
        done, rounds = self.shrink().to_the_end("inclusive")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertLessEqual(rounds, MOST_ROUNDS_OF_SHRINK)
        in_rounds = self.small()
        here = self.run_here("replay", os.path.join(SOURCES, "scenes", "ties.json"),
                             "--property", PROPERTY, "--subject", "mine.subject",
                             "--shrink", "small.json")  # fmt: skip
        self.assertEqual(here.returncode, 1, here.stderr)
        self.assertEqual(in_rounds.replace("rounds:rounds", "mine.subject"), self.small())
        self.assertEqual(done.stdout.replace("rounds:rounds", "mine.subject"), here.stdout)
        self.assertEqual(len(json.loads(in_rounds)["scene"]["triangles"]), 2)

    def test_printed_commands_work_as_printed(self):
        self.describe("inclusive")
        done, rounds = Rounds(self.folder, "check", "--property", PROPERTY,
                              "--cases", "10").to_the_end("inclusive")  # fmt: skip
        self.assertEqual(done.returncode, 1, done.stderr)
        replay = re.search("^replay: rasterproof (.*)$", done.stdout, re.M)[1]
        infer = re.search("^to find .*: rasterproof (.*)$", done.stdout, re.M)[1]
        again = self.run_here(*shlex.split(replay))  # what it asks was answered before
        self.assertEqual(again.returncode, 1, again.stdout + again.stderr)
        self.assertIn(f"replay: rasterproof {replay}\n", again.stdout)
        asked = self.run_here(*shlex.split(infer))
        self.assertEqual(asked.returncode, 4, asked.stderr)
        self.assertIn(f"round-{rounds + 1}.requests", asked.stdout)

    def test_replays_as_replay_does(self):
        self.describe("inclusive")
        case = (os.path.join(SOURCES, "scenes", "ties.json"), "--property", PROPERTY)
        done, _ = Rounds(self.folder, "replay", *case).to_the_end("inclusive")
        here = self.run_here("replay", *case, "--subject", "mine.subject")
        self.assertEqual((done.returncode, here.returncode), (1, 1), done.stderr)
        self.assertEqual(done.stdout.replace("rounds:rounds", "mine.subject"), here.stdout)

    def test_former_verbs_name_the_new_command(self):
        for verb in ("ask", "judge", "shrink", "infer"):
            for more in (("--cases", "5"), ("--help",)):
                done = self.run_here("pipe", verb, *more)
                self.assertEqual(done.returncode, 2)
                self.assertIn("--subject rounds:FOLDER", done.stderr)

    def test_a_refusal_is_counted_and_a_fault_is_shrunk(self):
        self.describe()
        for word, said in (("refused", r"exercised in \d+ of 9 cases, 1 refused"),
                           ("fault", "round 2 has ")):  # fmt: skip
            verb = Rounds(self.folder, "check", "--property", "DegenerateTrianglesCoverNothing",
                          "--cases", "9")  # fmt: skip
            verb.ask()
            verb.answer(1)
            with open(verb.path(1, "answers"), encoding="utf-8") as file:
                answers = file.read()
            with open(verb.path(1, "answers"), "w", encoding="utf-8") as file:
                file.write(f"{word} 1 no\n" + answers[answers.index("counts 2"):])
            with self.subTest(word):
                self.assertRegex(verb.ask().stdout, said)
            for name in ("rounds.json", "round-1.requests", "round-1.answers"):
                os.remove(os.path.join(verb.directory, name))

    def test_other_verbs_refuse_the_subject(self):
        self.describe()
        self.assert_refused(self.run_here("survey", "--subject", "rounds:rounds"), "infer")

    def check_both_ways(self, how, *options):
        """The saved files, the text and the data are those of the direct run."""
        self.describe(*how)
        os.mkdir(os.path.join(self.folder, "saved"))
        chosen = [*(f"--property={name}" for name in CHECKED), "--cases", "12", "--verbose",
                  *options]  # fmt: skip
        files = ["--save", "saved", "--json", "found.json", "--cases-json", "cases.json"]
        verb = Rounds(self.folder, "check", *chosen, *files)
        done, rounds = verb.to_the_end(*how)
        self.assertLessEqual(rounds, MOST_ROUNDS_OF_SHRINK)
        in_rounds = self.take_files()
        here = self.run_here("check", "--subject", "mine.subject", "--no-cause", *chosen, *files)
        self.assertEqual(done.returncode, here.returncode, done.stderr)
        self.assertEqual(done.stdout.replace("rounds:rounds", "mine.subject"), here.stdout)
        self.assertEqual(in_rounds, self.take_files())
        return done, in_rounds

    def take_files(self):
        """What a run wrote, without times and the subject's name; it is there no longer."""
        saved = os.path.join(self.folder, "saved")
        paths = [os.path.join(self.folder, name) for name in ("found.json", "cases.json")]
        paths += [os.path.join(saved, name) for name in sorted(os.listdir(saved))]
        texts = {}
        for path in paths:
            with open(path, encoding="utf-8") as file:
                text = file.read().replace("rounds:rounds", "mine.subject")
            texts[path] = re.sub(r'"seconds": [0-9.e-]+', "", text)
            os.remove(path)
        return texts

    def test_checks_as_check_does(self):
        done, files = self.check_both_ways([])
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertEqual(len(files), 2)

    def test_checks_a_wrong_program_as_check_does(self):
        done, files = self.check_both_ways(["inclusive"])
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertGreater(len(files), 2)

    def test_check_refuses_what_rounds_do_not_give(self):
        self.describe()
        ties = os.path.join(SOURCES, "scenes", "ties.json")
        far = ("check", "--subject", "rounds:rounds")
        self.assert_refused(self.run_here(*far, ties), "rounds are about one subject")
        self.assert_refused(self.run_here(*far, "--subject", "exact"), "rounds are about one")

    def test_a_case_that_holds_has_nothing_to_shrink(self):
        self.describe()
        done, rounds = self.shrink().to_the_end()
        self.assert_refused(done, "it does not fail, so there is nothing to shrink")
        self.assertEqual(rounds, 1)

    def infer_both_ways(self, how, profile):
        self.describe(*how, profile=profile)
        done, rounds = self.infer("--json", "found.json").to_the_end(*how)
        self.assertLessEqual(rounds, MOST_ROUNDS_OF_INFER)
        here = self.run_here("infer", "--subject", "mine.subject", "--json", "here.json")
        self.assertEqual(done.returncode, here.returncode, done.stderr)
        found = []
        for name in ("found.json", "here.json"):
            with open(os.path.join(self.folder, name), encoding="utf-8") as file:
                text = file.read().replace("rounds:rounds", "mine.subject")
                found.append({**json.loads(text), "seconds": 0})
        self.assertEqual(*found)
        return done, found[0]

    def test_infers_as_infer_does(self):
        done, found = self.infer_both_ways([], "d3d11-canonical")
        self.assertEqual(done.returncode, 0)
        self.assertTrue(found["agrees"])

    def test_infers_what_contradicts_the_statement(self):
        done, found = self.infer_both_ways(["inclusive"], "gl-canonical")
        self.assertEqual(done.returncode, 1)
        self.assertTrue(found["fits"])
        self.assertFalse(found["agrees"])

    @unittest.skipUnless("RASTERPROOF_MORE" in os.environ, "45 s: a part of ./run test-more")
    def test_finds_the_nearest_where_no_model_fits(self):
        done, found = self.infer_both_ways(["odd"], "d3d11-canonical")
        self.assertEqual(done.returncode, 1)
        self.assertFalse(found["fits"])
        self.assertIn("witness", found)

    def test_waits_for_answers_and_asks_the_same_again(self):
        self.describe("inclusive")
        shrink = self.shrink()
        first = shrink.ask()
        with open(shrink.path(1, "requests"), encoding="utf-8") as file:
            requests = file.read()
        again = shrink.ask()
        self.assertEqual((first.returncode, again.returncode), (4, 4))
        self.assertIn("round-1.answers", first.stdout)
        self.assertIn("round-1.answers is missing", again.stdout)
        with open(shrink.path(1, "requests"), encoding="utf-8") as file:
            self.assertEqual(file.read(), requests)

    def test_a_folder_of_another_program_is_refused(self):
        self.describe("inclusive")
        self.shrink().ask()
        self.assert_refused(self.shrink("--profile", "gl-canonical").ask(),
                            "rounds.json", "about another description or profile")  # fmt: skip
        self.describe("other")
        self.assert_refused(self.infer().ask(), "about another description or profile")

    def damage(self, change):
        """The call after a round whose answers were changed."""
        self.describe("inclusive")
        shrink = self.shrink()
        shrink.ask()
        shrink.answer(1, "inclusive")
        with open(shrink.path(1, "answers"), encoding="utf-8") as file:
            lines = file.read().splitlines()
        with open(shrink.path(1, "answers"), "w", encoding="utf-8") as file:
            file.write("".join(line + "\n" for line in change(lines)))
        return shrink

    def test_answers_that_are_none_are_told_with_their_line(self):
        short = self.damage(lambda lines: lines[:-1])
        self.assert_refused(short.ask(), "round-1.answers: line ", "the file ends before request")
        os.remove(short.path(1, "requests"))
        os.remove(os.path.join(short.directory, "rounds.json"))
        os.remove(short.path(1, "answers"))
        heads = []

        def spoil(lines):
            heads.extend(k for k, line in enumerate(lines) if line.startswith("counts"))
            lines[heads[1]] = "what?"
            return lines

        spoilt = self.damage(spoil)
        self.assert_refused(spoilt.ask(), f"round-1.answers: line {heads[1] + 1}: ", "what?")

    def test_lines_after_the_last_answer_are_told(self):
        self.assert_refused(self.damage(lambda lines: [*lines, "counts 9999"]).ask(),
                            "it goes on after the last answer")  # fmt: skip

    def test_files_that_change_later_are_refused(self):
        shrink = self.damage(lambda lines: lines)
        self.assertEqual(shrink.ask().returncode, 4)
        with open(shrink.path(1, "answers"), "a", encoding="utf-8") as file:
            file.write("\n")
        self.assert_refused(shrink.ask(), "round-1.answers: it changed after it was read")
        with open(shrink.path(1, "requests"), "a", encoding="utf-8") as file:
            file.write("\n")
        self.assert_refused(shrink.ask(), "round-1.requests: it changed after it was written")

    def test_answers_before_their_requests_are_refused(self):
        self.describe("inclusive")
        shrink = self.shrink()
        with open(shrink.path(1, "answers"), "w", encoding="utf-8") as file:
            file.write("counts 1\n")
        self.assert_refused(shrink.ask(), "it exists before anything was asked")

    def test_a_program_that_changes_its_answers_is_inconclusive(self):
        self.describe("inclusive")
        shrink = self.shrink()
        shrink.ask()
        shrink.answer(1, "inclusive")
        shrink.ask()
        shrink.answer(2, "inclusive", "moody")
        shrink_again = shrink.ask()
        number = 3
        while os.path.exists(shrink.path(number, "requests")):
            shrink.answer(number, "inclusive", "moody")
            shrink_again = shrink.ask()
            number += 1
        self.assertEqual(shrink_again.returncode, 4, shrink_again.stdout)
        self.assertIn("the program is not deterministic", shrink_again.stdout)
        self.assertIn("round-1.answers, line ", shrink_again.stdout)

    def test_what_is_about_a_sequence_of_calls_is_refused(self):
        self.describe()
        verb = self.shrink()
        verb.command[verb.command.index(PROPERTY)] = "EqualDrawsGiveEqualCounts"
        self.assert_refused(verb.ask(), "it needs a sequence of calls")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
