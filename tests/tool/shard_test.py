"""certify --shard and --cases A..B, --merge: the certificate of the whole, however it was cut.

usage: shard_test.py PROGRAM SOURCES EXAMPLES
"""
import json
import os
import re
import signal
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCES, EXAMPLES = (os.path.abspath(path) for path in sys.argv[1:4])
PLUGIN = os.path.join(EXAMPLES, "example_plugin.so")
SCENES = os.path.join(SOURCES, "scenes/quick.json")
SOUND, WRONG = "spans-exact", "mutant:box-single-column"
ENGINES = ("GTEST_", "SLURM_", "OMPI_")


class Parts(unittest.TestCase):
    cases = "30"

    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = os.path.realpath(folder.name)

    def start(self, *arguments, **variables):
        """The command in the folder, without variables that an engine has set for this test."""
        clean = {name: value for name, value in os.environ.items() if not name.startswith(ENGINES)}
        return subprocess.Popen([PROGRAM, *arguments], cwd=self.folder, text=True,
                                env={**clean, **variables}, stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE)  # fmt: skip

    def run_it(self, *arguments, **variables):
        process = self.start(*arguments, **variables)
        out, err = process.communicate(timeout=900)
        return subprocess.CompletedProcess(arguments, process.returncode, out, err)

    def good(self, done):
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        return done

    def part(self, *arguments, out="parts", subject=("--subject", SOUND), cases=None, **variables):
        """The file that one part writes."""
        done = self.good(self.run_it("certify", *subject, "--cases", cases or self.cases,
                                     *arguments, "--jobs", "1", "--out", out,
                                     **variables))  # fmt: skip
        return re.search(r": ([^ ]+\.json)\n$", done.stdout)[1]

    def merge(self, *parts, subject=(), out="out"):
        return self.run_it("certify", "--merge", *parts, *subject, "--scenes", SCENES,
                           "--out", out)  # fmt: skip

    def refused(self, done, *words):
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertEqual(done.stderr.count("\n"), 1, done.stderr)
        for word in words:
            self.assertIn(word, done.stderr)
        self.assertFalse(os.path.exists(os.path.join(self.folder, "out")))

    def files(self, out="out"):
        """Returns the files that describe the one subject, but for times."""
        contents = {}
        for folder, _, names in os.walk(os.path.join(self.folder, out)):
            for name in names:
                if name.endswith(".json") and name != "certificate-times.json":
                    with open(os.path.join(folder, name), "rb") as file:
                        contents[name] = file.read()
        self.assertIn("certificate.json", contents)
        return contents


class TheSameBytes(Parts):
    def unbroken(self, *arguments, status=0):
        done = self.run_it("certify", *arguments, "--scenes", SCENES, "--out", "out")
        self.assertEqual(done.returncode, status, done.stdout + done.stderr)
        contents = self.files()
        os.rename(os.path.join(self.folder, "out"), os.path.join(self.folder, "unbroken"))
        return contents

    def compare(self, subject, status, cuts=(2, 5)):
        whole = self.unbroken(*subject, "--cases", "30", status=status)
        for cut in cuts:
            with self.subTest(subject=subject, cut=cut):
                parts = [self.part("--shard", f"{k}/{cut}", subject=subject, out=f"in-{cut}")
                         for k in range(1, cut + 1)]  # fmt: skip
                self.assertEqual(len(set(parts)), cut)
                # In no order: merge sorts them.
                done = self.merge(*parts[1:], parts[0], subject=subject)
                self.assertEqual(done.returncode, status, done.stdout + done.stderr)
                self.assertEqual(self.files(), whole)
                subprocess.run(["rm", "-r", os.path.join(self.folder, "out")], check=True)
        return json.loads(whole["certificate.json"])

    def test_of_a_sound_subject(self):
        certificate = self.compare(("--subject", SOUND), 0, cuts=(3,))
        self.assertGreater(certificate["oracle_tiers"]["filter"], 0)
        self.assertNotIn("--jobs", certificate["command"])

    def test_of_one_that_fails_in_some_parts(self):
        certificate = self.compare(("--subject", WRONG), 1)
        failed = [one for one in certificate["tested"] if one["outcome"] == "violated"]
        self.assertTrue(failed)
        late = [one for one in failed if one["cases"] > 6]
        self.assertTrue(late, "one that holds in a first part of five")
        for one in failed:
            self.assertLess(one["cases"], 30)

    def test_of_one_that_fails_where_the_property_changed_the_scene(self):
        self.compare(("--subject", "mutant:target-odd-width"), 1, cuts=(2,))

    def test_of_a_plugin(self):
        self.compare(("--plugin", PLUGIN), 0, cuts=(2,))

    def test_of_ranges_of_cases(self):
        whole = self.unbroken("--subject", SOUND, "--cases", "30")
        parts = [self.part(cases=cases) for cases in ("0..1", "1..23", "23..30")]
        self.good(self.merge(*parts))
        self.assertEqual(self.files(), whole)

    def test_of_more_shards_than_cases(self):
        whole = self.unbroken("--subject", SOUND, "--cases", "2")
        parts = [self.part("--shard", f"{k}/3", cases="2") for k in (1, 2, 3)]
        self.good(self.merge(*parts))
        self.assertEqual(self.files(), whole)

    def test_of_worlds(self):
        arguments = ("--exhaustive", "pairs-3x3")
        whole = self.unbroken("--subject", SOUND, "--cases", "3", *arguments)
        parts = [self.part("--shard", f"{k}/2", *arguments, cases="3") for k in (1, 2)]
        done = self.good(self.merge(*parts))
        self.assertIn("all 6561 of 6561 cases", done.stdout)
        self.assertEqual(self.files(), whole)

    def test_times_are_beside_the_certificate(self):
        self.unbroken("--subject", SOUND, "--cases", "3")
        folder = os.path.join(self.folder, "unbroken", SOUND)
        with open(os.path.join(folder, "certificate.json"), encoding="utf-8") as file:
            self.assertNotIn('"seconds"', file.read())
        with open(os.path.join(folder, "certificate-times.json"), encoding="utf-8") as file:
            times = json.load(file)
        self.assertTrue(all("seconds" in one for one in times["tested"] + times["measured"]))
        self.assertTrue(times["tested"] and times["measured"])


class Refused(Parts):
    cases = "6"  # what they found is not looked at

    def test_holes_and_overlaps(self):
        shards = [self.part("--shard", f"{k}/3") for k in (1, 2, 3)]
        self.refused(self.merge(*shards[:2]), "part-2-of-3.json", "shard 3 of 3 is missing",
                     "--shard 3/3")  # fmt: skip
        self.refused(self.merge(shards[0], shards[2]), "part-1-of-3.json", "shard 2 of 3")
        self.refused(self.merge(shards[2]), "part-3-of-3.json", "shards 1, 2 of 3 are missing",
                     "run each (--shard 1/3, --shard 2/3)")  # fmt: skip
        self.refused(self.merge(*shards, shards[1]), "shard 2/3 is in", "part-2-of-3.json too",
                     "give one of them")  # fmt: skip
        self.refused(self.run_it("certify", "--merge", "--subject", "spans-exact"),
                     "--merge: it takes --subject for a file", "before it")  # fmt: skip
        low, high, both = (self.part(cases=cases) for cases in ("0..10", "20..30", "5..30"))
        self.refused(self.merge(low, high), "part-20-to-30.json", "--cases 10..20")
        self.refused(self.merge(high), "part-20-to-30.json", "--cases 0..20")
        self.refused(self.merge(low, both), "part-5-to-30.json", "overlap", "part-0-to-10.json")
        self.refused(self.merge(low, shards[1]), "its cut", "part-2-of-3.json")

    def test_parts_of_different_campaigns(self):
        one = self.part("--shard", "1/2")
        for words, part in (
            (("its seed (7)", "(1)"), self.part("--shard", "2/2", "--seed", "7", out="a")),
            (("its subject (i64-snap8)",), self.part("--shard", "2/2", out="b",
                                                         subject=("--subject", "i64-snap8"))),
            (("its number of cases (31)",), self.part("--shard", "2/2", out="c", cases="31")),
            (("its options",), self.part("--shard", "2/2", "--exhaustive", "pairs-3x3", out="d")),
            (("its cut (into 3 shards)",), self.part("--shard", "2/3", out="e")),
        ):  # fmt: skip
            self.refused(self.merge(one, part), *words, one, part, "run this part again")

    def changed(self, path, key, value):
        """A copy of the part with another value of the key."""
        with open(os.path.join(self.folder, path), encoding="utf-8") as file:
            part = json.load(file)
        self.assertIn(key, part)
        part[key] = value
        copy = path.replace(".json", f"-{key}.json")
        with open(os.path.join(self.folder, copy), "w", encoding="utf-8") as file:
            json.dump(part, file)
        return copy

    def test_parts_of_other_programs(self):
        one, two = (self.part("--shard", f"{k}/2") for k in (1, 2))
        self.refused(self.merge(one, self.changed(two, "tool_version", "0.0.1")),
                     "its version (0.0.1)", one)  # fmt: skip
        both = [self.changed(part, "tool_version", "0.0.1") for part in (one, two)]
        self.refused(self.merge(*both), "another build of rasterproof", "by one build")
        self.refused(self.merge(one, self.changed(two, "stated", "profile gl")), "its profile")
        both = [self.changed(part, "stated", "profile gl") for part in (one, two)]
        self.refused(self.merge(*both), "has changed since")
        self.refused(self.merge(self.changed(one, "tests", []), two), "it has other properties")
        self.refused(self.merge(self.changed(one, "rasterproof_part", 9), two), "version 9")

    def edited(self, path, edit):
        """A copy of the part, edited in place."""
        with open(os.path.join(self.folder, path), encoding="utf-8") as file:
            part = json.load(file)
        edit(part)
        copy = path.replace(".json", "-edited.json")
        with open(os.path.join(self.folder, copy), "w", encoding="utf-8") as file:
            json.dump(part, file)
        return copy

    def test_a_part_is_checked_as_a_whole_before_anything_is_added(self):
        part = self.part("--shard", "1/1", cases="10")
        self.good(self.merge(self.edited(part, lambda part: None), out="spelt-otherwise"))

        def of_test(**values):
            def edit(part):
                test = next(one for one in part["tests"] if one["end"] == "all run")
                test.update(values)
            return edit

        def of_domain(**values):
            def edit(part):
                next(one for one in part["tests"] if one["domains"])["domains"][0].update(values)
            return edit

        for edit, words in (
            (lambda part: part.update(shards=0), ("shards",)),
            (lambda part: part.update(shard=0), ("shard",)),
            (lambda part: part.update(shards=10**7), ("shards",)),
            (lambda part: part.update(first=2**62 + 1, end=2**62 + 2), ("first",)),
            (lambda part: part.update(end=2**62 + 1), ("end",)),
            (lambda part: part.update(cases=0), ("cases",)),
            (lambda part: part.update(seed=""), ("is not a seed",)),
            (lambda part: part.update(seed=str(2**64 + 1)), ("is not a seed",)),
            (lambda part: part.update(seed="01"), ("is not a seed",)),
            (lambda part: part["environment"].append("odd"), ("has no value",)),
            (of_test(cases=0, cases_exercised=0, exercised=0), ("more cases than were run",)),
            (of_test(cases=0, cases_exercised=0, exercised=0, domains=[]), ("it lists",)),
            (of_test(end="not applicable"), ("not applicable, with 10 cases run",)),
            (of_test(end="failed"), ("found",)),
            (of_test(cases_exercised=11), ("of 10 cases",)),
            (of_test(exercised=2**62), ("no run can reach a count",)),
            (of_test(cases_refused=11), ("refused",)),
            (of_test(refused_within_limits=1), ("refused",)),
            (of_test(not_applicable=11), ("not applicable",)),
            (of_test(places=[]), ("wrong number of entries",)),
            (of_test(places=[{"asked": 1, "refused": 2}] * 10), ("kind of place",)),
            (of_test(worst_ratio="nan"), ("error",)),
            (of_test(domains=[]), ("it lists",)),
            (of_domain(drawn=2**63 - 1), ("more cases than were run",)),
            (of_domain(on_edge=2**40), ("more of its samples lie near edges",)),
            # Nothing contradicts it; it is not what was written.
            (of_test(seconds="0x1p+0"), ("its digest differs",)),
            (lambda part: part.update(digest="0" * 16), ("its digest differs",)),
        ):
            with self.subTest(words=words):
                done = self.merge(self.edited(part, edit))
                self.assertTrue(any(word in done.stderr for word in words), done.stderr)
                self.refused(done)

    def test_a_failure_is_checked_too(self):
        subject = ("--subject", WRONG)
        part = self.part("--shard", "1/1", subject=subject, cases="10")

        def found(part):
            return next(one["found"] for one in part["tests"] if "witness" in one.get("found", {}))

        def seen(value):
            return lambda part: found(part)["witness"].update(observed=value)

        for edit, words in (
            (lambda part: found(part)["witness"].update(triangle=10**6), "its witness is triangle"),
            (lambda part: found(part)["witness"].update(edge=3), "its witness is edge 3"),
            (lambda part: found(part)["witness"].update(x=10**6), "its witness is pixel"),
            (lambda part: found(part)["witness"].update(sample=-1), "its witness is sample"),
            (seen("two"), "is a string, not an array"),
            (seen([True]), "not a value of a witness"),
            (seen([{"back": 1}]), "not a value of a witness"),
            (seen([{"front": 1}]), '"back" is missing'), (seen([{"counts": [64]}]), "out of range"),
            (seen([{"double": "2"}]), "observed[0].double"), (seen([1.5]), "is not an integer"),
            (seen([{"rational": "1/x"}]), "is not a rational number"),
            (seen(["front 1, back 0"]), "its digest differs"),
            (lambda part: found(part).update(outcome="holds"), "but its outcome is 'holds'"),
            (lambda part: found(part).update(said_outcome="holds"), "not said to violate it"),
            (lambda part: found(part).update(message="fine"), "its digest differs"),
        ):
            with self.subTest(words=words):
                self.refused(self.merge(self.edited(part, edit), subject=subject), words)

    def test_what_is_no_part(self):
        for name, text in (("cut.json", '{"rasterproof_part": 1, "tool_'), ("other.json", "{}")):
            with open(os.path.join(self.folder, name), "w", encoding="utf-8") as file:
                file.write(text)
            self.refused(self.merge(name), name)

    def test_a_file_decides_not_what_is_run(self):
        part = self.part("--shard", "1/1", subject=("--plugin", PLUGIN))
        self.refused(self.merge(part), f"name it yourself: --plugin {PLUGIN}")
        self.refused(self.merge(part, subject=("--subject", SOUND)), "merge it with --plugin")

    def test_options_that_a_part_does_not_take(self):
        for arguments, words in (
            (("--shard", "1/2", "--seconds", "1"), "does not take --seconds"),
            (("--shard", "1/2", "--scenes", SCENES), "give it to --merge"),
            (("--shard", "1/2", "--fail-on", "quality"), "give it to --merge"),
            (("--shard", "1/2", "--cases", "0..5"), "does not take --shard beside it"),
            (("--cases", "0..5", "--exhaustive", "pairs-3x3"), "--shard, which cuts worlds"),
            (("--shard", "0/2"), "not a shard"), (("--shard", "3/2"), "not a shard"),
            (("--shard", "1/"), "not a shard"), (("--shard", "one"), "not a shard"),
            (("--cases", "5..5"), "the range is empty"), (("--cases", "5.."), "not two numbers"),
            (("--cases", "0"), "not a number of cases"), (("--cases", "1e3"), "not a number"),
        ):  # fmt: skip
            with self.subTest(arguments=arguments):
                self.refused(self.run_it("certify", *arguments, "--out", "out"), words)


SLURM = {"SLURM_ARRAY_TASK_ID": "30", "SLURM_ARRAY_TASK_MIN": "10", "SLURM_ARRAY_TASK_MAX": "30",
         "SLURM_ARRAY_TASK_COUNT": "3", "SLURM_ARRAY_TASK_STEP": "10"}  # fmt: skip
GTEST = {"GTEST_SHARD_INDEX": "2", "GTEST_TOTAL_SHARDS": "3"}
OMPI = {"OMPI_COMM_WORLD_RANK": "2", "OMPI_COMM_WORLD_SIZE": "3"}


class Automatic(Parts):
    def auto(self, **variables):
        done = ("certify", "--shard", "auto", "--cases", "3", "--out", "out")
        return self.run_it(*done, **variables)

    def test_each_engine_says_which_shard_it_is(self):
        for variables in (SLURM, GTEST, OMPI, {**SLURM, **OMPI}):
            path = self.part("--shard", "auto", cases="3", **variables)
            self.assertTrue(path.endswith("/part-3-of-3.json"), path)
            os.remove(os.path.join(self.folder, path))

    def test_nothing_is_read_without_being_asked(self):
        done = self.good(self.run_it("certify", "--subject", SOUND, "--cases", "3", "--scenes",
                                     SCENES, **SLURM, **GTEST, **OMPI))  # fmt: skip
        self.assertIn(f"{SOUND} ", done.stdout)
        self.assertEqual(json.loads(self.files()["certificate.json"])["tested"][0]["cases"], 3)
        path = self.part("--shard", "1/2", cases="3", **SLURM, **GTEST, **OMPI)
        self.assertTrue(path.endswith("/part-1-of-2.json"), path)

    def test_what_is_missing_or_contradictory_is_refused(self):
        for variables, words in (
            ({}, "none of GTEST_SHARD_INDEX"),
            ({"GTEST_SHARD_INDEX": "2"}, "GTEST_TOTAL_SHARDS is not set"),
            ({"GTEST_TOTAL_SHARDS": "2"}, "GTEST_SHARD_INDEX is not set"),
            ({"OMPI_COMM_WORLD_RANK": "1"}, "OMPI_COMM_WORLD_SIZE is not set"),
            ({**GTEST, "GTEST_SHARD_INDEX": "3"}, "say shard 4 of 3"),
            ({**GTEST, "GTEST_SHARD_INDEX": "-1"}, "is '-1', not a count"),
            ({**OMPI, "OMPI_COMM_WORLD_SIZE": ""}, "not a count"),
            ({**SLURM, "SLURM_ARRAY_TASK_ID": "25"}, "in an array from 10 in steps of 10"),
            ({**SLURM, "SLURM_ARRAY_TASK_COUNT": "2"}, "say shard 3 of 2"),
            ({**SLURM, **OMPI, "OMPI_COMM_WORLD_RANK": "1"}, "say 3/3, but"),
        ):
            with self.subTest(variables=variables):
                self.refused(self.auto(**variables), "--shard auto", words, "--shard 1/3")


class Killed(Parts):
    def test_a_worker_that_is_killed_leaves_no_part_and_can_be_run_again(self):
        whole = self.run_it("certify", "--subject", SOUND, "--cases", "30", "--scenes", SCENES)
        self.good(whole)
        contents = self.files()
        one = self.part("--shard", "1/2")
        # Its program never answers: it is killed while it works, however fast the machine is.
        waits = os.path.join(self.folder, "waits")
        os.mkfifo(waits)
        killed = self.start("certify", "--exec", f"cat {waits}", "--time-limit", "1000", "--cases",
                            "30", "--shard", "2/2", "--jobs", "1", "--out", "killed")  # fmt: skip
        with open(waits, "w", encoding="utf-8"):  # opens once the worker has begun
            killed.send_signal(signal.SIGKILL)
            killed.communicate(timeout=900)
        left = [name for _, _, names in os.walk(os.path.join(self.folder, "killed"))
                for name in names]  # fmt: skip
        self.assertEqual(left, [])
        # One of our own, somewhere on its way, or done.
        killed = self.start("certify", "--subject", SOUND, "--cases", "3000", "--shard", "2/2",
                            "--jobs", "1", "--out", "parts")  # fmt: skip
        killed.send_signal(signal.SIGKILL)
        killed.communicate(timeout=900)
        self.assertFalse(os.path.exists(os.path.join(self.folder, "parts", SOUND,
                                                     "part-2-of-2.json")))  # fmt: skip
        self.refused_merge(one)
        two = self.part("--shard", "2/2")
        self.good(self.merge(one, two))
        self.assertEqual(self.files(), contents)

    def refused_merge(self, one):
        done = self.merge(one, out="out-refused")
        self.assertEqual(done.returncode, 2, done.stdout)
        self.assertIn("shard 2 of 2 is missing", done.stderr)

    def test_an_interrupted_worker_writes_no_part(self):
        waits = os.path.join(self.folder, "waits")
        os.mkfifo(waits)
        worker = self.start("certify", "--exec", f"cat {waits}", "--time-limit", "1000", "--cases",
                            "3", "--shard", "1/2", "--jobs", "1", "--out", "parts")  # fmt: skip
        with open(waits, "w", encoding="utf-8"):
            worker.send_signal(signal.SIGTERM)
            out, err = worker.communicate(timeout=900)
        self.assertEqual(worker.returncode, 128 + signal.SIGTERM, err)
        self.assertIn("no part is written; run it again", out)
        self.assertFalse(os.path.exists(os.path.join(self.folder, "parts")))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[4:])
