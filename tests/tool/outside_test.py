"""Subjects outside: plugins, programs on a pipe, types of the user's own; sound, faulty and absent.

usage: outside_test.py PROGRAM SOURCES EXAMPLES PLUGINS"""
import os
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCES, EXAMPLES, PLUGINS = (os.path.abspath(path) for path in sys.argv[1:5])
MODEL = "CoverageEqualsTheModel"
SHARED_EDGE = "SharedEdgeSamplesAreCoveredOnce"
EMBEDDED_MESH = "EmbeddedMeshSamplesAreCoveredOnce"
SHARED_TIES = ('{"name": "ties", "contract": "watertight", "tie_rule": "inclusive", '
               '"edge_samples": "may-be-shared"}')  # fmt: skip
DEGENERATE = "DegenerateTrianglesCoverNothing"
SCENE = "scenes/ties.json"


def run(*arguments, program=PROGRAM):
    if arguments[:1] == ("check",):  # explaining takes longer than finding: causes_test.py has it
        arguments += ("--no-cause",)
    return subprocess.run([program, *arguments], capture_output=True, cwd=SOURCES,
                          timeout=900, check=False)  # fmt: skip


def buggy(name):
    return os.path.join(PLUGINS, f"buggy_{name}.so")


def shown(name):
    return os.path.join(PLUGINS, f"shown_{name}.so")


def held(text):
    return sum(line.startswith("holds ") for line in text.splitlines())


class SoundSubjects(unittest.TestCase):
    def test_the_c_example_keeps_what_its_profile_states(self):
        done = run("check", "--plugin", f"{EXAMPLES}/example_plugin.so", "--cases", "70")
        self.assertEqual(done.returncode, 0, done.stdout.decode() + done.stderr.decode())
        self.assertRegex(done.stdout, rb": \d\d hold, 0 violated,")

    def test_the_console_example_keeps_what_its_profile_states(self):
        done = run("check", "--plugin", f"{EXAMPLES}/example_console.so", "--cases", "120")
        self.assertEqual(done.returncode, 0, done.stdout.decode() + done.stderr.decode())
        self.assertRegex(done.stdout, rb": \d\d hold, 0 violated,")

    def test_a_library_of_the_first_header_still_loads(self):
        done = run("check", "--plugin", buggy("FIRST_SIZE"), "--property", DEGENERATE,
                   "--cases", "10")  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stdout.decode() + done.stderr.decode())

    def test_the_rust_example_keeps_what_its_profile_states(self):
        done = run("check", "--plugin", f"{EXAMPLES}/example_rust.so", "--cases", "40", "--verbose")
        self.assertEqual(done.returncode, 0, done.stdout.decode() + done.stderr.decode())
        self.assertGreater(held(done.stdout.decode()), 15, done.stdout)

    def test_a_plugin_draws_what_the_oracle_says(self):
        drawn = run("coverage", SCENE, "--plugin", f"{EXAMPLES}/example_plugin.so")
        exact = run("coverage", SCENE, "--profile", "gl-canonical")
        self.assertEqual(drawn.returncode, 0, drawn.stderr)
        self.assertEqual(drawn.stdout, exact.stdout)

    def test_the_python_example_keeps_what_a_plain_program_states(self):
        done = run("check", "--exec", "kit/examples/program.py", "--cases", "5",
                   "--property", MODEL, "--property", SHARED_EDGE)  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stdout.decode() + done.stderr.decode())

    def test_a_type_of_ones_own_is_the_subject(self):
        done = run("check", "--property", MODEL, program=f"{EXAMPLES}/example_own_type")
        self.assertEqual(done.returncode, 1, done.stderr)  # float32 and no tie rule
        self.assertIn(b"Naive", done.stdout)

    def test_a_type_of_ones_own_shows_primitive_ids_in_batches(self):
        own = ("PrimitiveIdFollowsTheStatedOrder", "BatchDrawsLikeSingleCalls", MODEL, SHARED_EDGE)
        chosen = [word for p in own for word in ("--property", p)]
        done = run("check", "--cases", "30", *chosen, program=f"{EXAMPLES}/own_primitive_ids")
        self.assertEqual(done.returncode, 0, done.stdout.decode() + done.stderr.decode())
        self.assertEqual(held(done.stdout.decode()), 4, done.stdout)

    def test_a_subject_file_says_what_a_program_states(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "mine.subject")
            with open(path, "w", encoding="utf-8") as file:
                file.write("# a program\ncommand kit/examples/program.py\nprofile real\n"
                           "coverage counts\ninput float64\n")  # fmt: skip
            done = run("check", "--subject", path, "--property", MODEL, "--cases", "3")
        self.assertEqual(done.returncode, 0, done.stdout.decode() + done.stderr.decode())


class MeshProperties(unittest.TestCase):
    """Subjects that state meshes alone: they are put to the test, or the run says why not."""

    def checked(self, program, profile, takes="clip"):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "mine.subject")
            with open(path, "w", encoding="utf-8") as file:
                file.write(f"command {program}\ntakes {takes}\nprofile {profile}\n")
            return run("check", "--subject", path, "--property", SHARED_EDGE,
                       "--property", EMBEDDED_MESH, "--cases", "36")  # fmt: skip

    def test_are_put_to_a_clip_space_subject_that_shares_ties(self):
        done = self.checked("tests/tool/clip_program.py", SHARED_TIES)
        self.assertEqual(done.returncode, 0, done.stdout.decode() + done.stderr.decode())
        self.assertEqual(held(done.stdout.decode()), 2, done.stdout)

    def test_find_a_crack_in_a_clip_space_subject(self):
        done = self.checked("tests/tool/clip_program.py crack", SHARED_TIES)
        self.assertEqual(done.returncode, 1, done.stdout.decode() + done.stderr.decode())
        self.assertIn(b"a gap in the mesh", done.stdout)

    def test_that_nothing_can_be_asked_about_is_said_and_inconclusive(self):
        profile = '{"name": "ties", "contract": "watertight", "tie_rule": "exclusive"}'
        done = self.checked("kit/examples/program.py", profile, takes="window")
        self.assertEqual(done.returncode, 4, done.stdout.decode() + done.stderr.decode())
        self.assertIn(b"an exclusive tie rule never covers shared edges", done.stdout)


class FaultySubjects(unittest.TestCase):
    def check(self, name, words, *more):
        done = run("check", "--plugin", buggy(name), "--property", MODEL, "--property",
                   DEGENERATE, "--cases", "30", *more)  # fmt: skip
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn(words, done.stdout.decode())
        self.assertIn("replay", done.stdout.decode())
        # The run goes on: both properties were judged.
        self.assertIn(DEGENERATE, done.stdout.decode())

    def test_a_crash_is_a_finding_with_its_signal(self):
        self.check("CRASH", "killed by signal 11")

    def test_an_exit_is_a_finding_with_its_status(self):
        self.check("EXIT", "ended with status 3")

    def test_a_hang_is_a_finding_with_its_limit(self):
        done = run("check", "--plugin", buggy("HANG"), "--property", DEGENERATE, "--cases", "30",
                   "--time-limit", "0.3")  # fmt: skip
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("it hangs", done.stdout.decode())
        self.assertIn("of processor time", done.stdout.decode())

    def test_writes_outside_the_target_are_findings(self):
        self.check("RIGHT_OF_ROW", "it wrote outside its target: column")
        self.check("ABOVE", "it wrote outside its target: column 0 of row -1")
        self.check("FAR_BELOW", "killed by signal 11")

    def test_what_depends_on_earlier_calls_is_a_finding(self):
        done = run("check", "--plugin", buggy("UNSTEADY"), "--property",
                   "EqualDrawsGiveEqualCounts", "--cases", "20")  # fmt: skip
        self.assertEqual(done.returncode, 1, done.stderr)

    def test_what_a_plugin_prints_is_no_answer(self):
        done = run("coverage", "scenes/slivers.json", "--plugin", buggy("PRINTS"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(b"this is no answer", done.stderr)

    def test_a_finding_without_a_place_prints_its_scene(self):
        done = run("check", "--plugin", buggy("CRASH"), "--property", DEGENERATE, "--cases", "9")
        text = done.stdout.decode()
        self.assertNotIn("observed ,", text)
        self.assertIn(f"{DEGENERATE}: the subject failed: it was killed by signal 11", text)
        scene = re.search(r"^scene: (\{.*\})$", text, re.M)
        self.assertIn('"vertices": [["0x', scene.group(1))
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "scene.json")
            with open(path, "w", encoding="utf-8") as file:
                file.write(scene.group(1))
            again = run("check", path, "--plugin", buggy("CRASH"), "--property", DEGENERATE)
        self.assertEqual(again.returncode, 1, again.stderr)

    def test_the_status_of_several_subjects_is_the_worst(self):
        sound, refuses = f"plugin:{EXAMPLES}/example_plugin.so", f"plugin:{buggy('REFUSES')}"
        crashes = f"plugin:{buggy('CRASH')}"
        for subjects, status in (((sound, refuses), 4), ((refuses, sound), 4), ((sound, sound), 0),
                                 ((crashes, refuses), 1), ((refuses, crashes), 1)):  # fmt: skip
            named = [word for name in subjects for word in ("--subject", name)]
            done = run("check", *named, "--property", MODEL, "--cases", "9")
            self.assertEqual(done.returncode, status, done.stdout.decode() + str(subjects))


class Outputs(unittest.TestCase):
    """Every kind of output, sound and with one fault each."""

    ALL = ("CoverageEqualsTheModel", "OneCallDrawsLikeItsTriangles", "BatchDrawsLikeSingleCalls",
           "PrimitiveIdFollowsTheStatedOrder", "FragmentBarycentricsSumToOne",
           "FragmentBarycentricsStayWithinTheirError", "FragmentDepthStaysInTheHull",
           "FragmentDepthFollowsItsBarycentrics", "ScissorOnlyCutsCoverage",
           "CullingRemovesOneFacing")  # fmt: skip

    def check(self, name, properties, cases="44", status=0):
        chosen = [word for p in properties for word in ("--property", p)]
        done = run("check", "--plugin", shown(name), "--cases", cases, *chosen)
        self.assertEqual(done.returncode, status, done.stdout.decode() + done.stderr.decode())
        return done.stdout.decode()

    def test_a_sound_plugin_of_every_kind_keeps_what_it_states(self):
        serves = {"FACING_COUNTS": 5, "COUNTS": 5, "MASK": 5, "PRIMITIVE_IDS": 6, "FRAGMENTS": 10}
        for kind, count in serves.items():
            text = self.check(kind, self.ALL)
            self.assertEqual(held(text), count, text)

    def test_a_library_of_an_older_header_goes_on_working(self):
        text = self.check("OLD_SIZE", self.ALL)
        self.assertEqual(held(text), 4, text)

    def test_every_fault_of_an_output_is_found_by_its_property(self):
        for name, found_by in (
            ("MESH_FACING_COUNTS", "OneCallDrawsLikeItsTriangles"),
            ("MESH_COUNTS", "OneCallDrawsLikeItsTriangles"),
            ("MESH_MASK", "OneCallDrawsLikeItsTriangles"),
            ("MESH_PRIMITIVE_IDS", "OneCallDrawsLikeItsTriangles"),
            ("MANY_FACING_COUNTS", "OneCallDrawsLikeItsTriangles"),
            ("MANY_COUNTS", "OneCallDrawsLikeItsTriangles"),
            ("MANY_MASK", "OneCallDrawsLikeItsTriangles"),
            ("MANY_PRIMITIVE_IDS", "OneCallDrawsLikeItsTriangles"),
            ("FIRST_WINS", "OneCallDrawsLikeItsTriangles"),
            ("FIRST_WINS", "PrimitiveIdFollowsTheStatedOrder"),
            ("ID", "PrimitiveIdFollowsTheStatedOrder"),
            ("BARYCENTRICS_PERMUTED", "FragmentBarycentricsStayWithinTheirError"),
            ("SUM", "FragmentBarycentricsSumToOne"),
            ("DEPTH", "FragmentDepthFollowsItsBarycentrics"),
            ("HULL", "FragmentDepthStaysInTheHull"),
            ("SCISSOR", "ScissorOnlyCutsCoverage"),
            ("CULLING", "CullingRemovesOneFacing"),
            ("BATCH_LAST", "BatchDrawsLikeSingleCalls"),
            ("BATCH_LEAK", "BatchDrawsLikeSingleCalls"),
            ("BATCH_INDICES", "BatchDrawsLikeSingleCalls"),
            *((f"BATCH_{what}", "BatchDrawsLikeSingleCalls") for what in ("VERTICES", "OPTIONS")),
        ):
            with self.subTest(name=name):
                self.assertIn("violated", self.check(name, [found_by], status=1))

    def test_a_primitive_id_that_the_scene_does_not_have_is_a_finding(self):
        text = self.check("NO_ID", [MODEL], status=1)
        self.assertIn("triangle 100000 as visible at a sample, in a scene of 1 triangles", text)


class FirstSteps(unittest.TestCase):
    """What a newcomer stumbles over."""

    def test_a_program_that_says_more_than_its_answer_is_reported(self):
        program = ("import sys\n"
                   "for line in sys.stdin:\n"
                   "    word, number, w, h, s, space, vs, ts = line.split()[:8]\n"
                   "    for _ in range(int(vs) + int(ts)):\n"
                   "        sys.stdin.readline()\n"
                   "    rows = ' '.join(['0'] * int(w)) + '\\n'\n"
                   "    sys.stdout.write('counts ' + number + '\\n' + rows * 2 * int(h))\n"
                   "    sys.stdout.flush()\n")  # fmt: skip
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "twice.py")
            with open(path, "w", encoding="utf-8") as file:
                file.write(program)
            done = run("check", "--exec", f"{sys.executable} {path}", "--property", MODEL,
                       "--cases", "3")  # fmt: skip
            self.assertEqual(done.returncode, 1)
            self.assertIn(b"it printed more than its answer", done.stdout)
            self.assertIn(b"facing-counts", done.stdout)

    def test_a_scene_behind_a_plugin_is_a_scene(self):
        done = run("check", "--plugin", f"{EXAMPLES}/example_plugin.so", SCENE,
                   "--property", MODEL)  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(SCENE.encode(), done.stdout)

    def test_a_scene_is_explained_by_what_the_plugin_states(self):
        done = run("explain", SCENE, "--plugin", f"{EXAMPLES}/example_plugin.so")
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_counterexamples_of_plugins_with_a_path_are_saved(self):
        with tempfile.TemporaryDirectory() as folder:
            done = run("check", "--plugin", shown("SCISSOR"), "--save", folder,
                       "--property", "ScissorOnlyCutsCoverage", "--cases", "64")  # fmt: skip
            self.assertEqual(done.returncode, 1, done.stderr)
            self.assertEqual(len(os.listdir(folder)), 1)


class Edges(unittest.TestCase):
    """Edge values and steps that a subject outside shows."""

    VALUES = ("EdgeErrorStaysWithinItsBound", "EdgeSignIsRightOutsideItsBand")
    STEPS = ("SteppingStaysWithinItsBound", "LongSteppingStaysWithinItsBound")

    def check(self, *arguments, properties):
        named = [word for name in properties for word in ("--property", name)]
        return run("check", *arguments, *named, "--cases", "64")

    def verdicts(self, fault, properties):
        text = self.check("--plugin", shown(f"EDGES_{fault}"), properties=properties).stdout
        said = re.findall(r"^(holds|violated|not \w+) +\S+ (\w+) ", text.decode(), re.M)
        return {name: outcome for outcome, name in said if name in properties}

    def test_sound_ones_hold_and_every_property_is_put_to_the_test(self):
        everything = self.VALUES + self.STEPS + ("ReversedEdgeChangesSign", "EdgeIsZeroAtItsEnds")
        self.assertEqual(set(self.verdicts("SOUND", everything).values()), {"holds"})

    def test_faults_are_found_by_the_property_that_they_break(self):
        for fault, name in (
            ("SIGN", self.VALUES[1]),
            ("NAN", self.VALUES[0]),
            ("STATES_EXACT", self.VALUES[0]),
            ("STEPS_LATE", self.STEPS[0]),
            ("STEPS_CRASHES", self.STEPS[0]),
            ("STEPS_TOO_LONG", self.STEPS[0]),
        ):
            self.assertEqual(self.verdicts(fault, [name]), {name: "violated"}, fault)

    def test_the_first_step_that_diverges_is_named(self):
        done = self.check("--plugin", shown("EDGES_STEPS_LATE"), properties=self.STEPS[:1])
        self.assertIn(b"after 6 steps", done.stdout)

    def test_what_is_not_shown_or_not_claimed_does_not_count_as_held(self):
        self.assertNotIn("holds", self.verdicts("NO_STEPS", self.STEPS).values())
        self.assertNotIn("holds", self.verdicts("STATES_NOTHING", self.VALUES).values())

    def test_a_program_on_a_pipe_shows_them_too(self):
        program = """import sys
for line in sys.stdin:
    word, number, *rest = line.split()
    ax, ay, bx, by, px, py = map(float, rest[:6])
    along_y, step, steps = False, 0, 0
    if word == "steps":
        along_y, step, steps = rest[6] == "y", int(rest[7]) * int(rest[8]), int(rest[9])
    values = []
    for n in range(steps + 1):
        x, y = (px, py + n * step) if along_y else (px + n * step, py)
        values.append((x - ax) * (by - ay) - (y - ay) * (bx - ax))
    print("values", number, *map(repr, values), flush=True)
"""
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "program.py")
            with open(path, "w", encoding="utf-8") as file:
                file.write(program)
            subject = os.path.join(folder, "mine.subject")
            with open(subject, "w", encoding="utf-8") as file:
                file.write(f"command {sys.executable} {path}\nshows edges steps\n"
                           "edge-error 1e-6\nstepping-error 1e-6\n")  # fmt: skip
            done = self.check("--subject", subject, properties=self.VALUES + self.STEPS[:1])
            self.assertEqual(done.returncode, 0, done.stdout.decode() + done.stderr.decode())


class Batches(unittest.TestCase):
    """Many scenes in one call, or asked for before the first answer."""

    def verdicts(self, name, cases="120"):
        done = run("check", "--plugin", shown(name), "--cases", cases, "--property", MODEL,
                   "--property", SHARED_EDGE)  # fmt: skip
        return done.returncode, done.stdout.decode()

    def test_batches_do_not_change_a_verdict(self):
        def results(name):
            status, text = self.verdicts(name)
            return status, re.sub(r"shown_\w+|[0-9.]+ m?s\b", "", text)
        self.assertEqual(results("FACING_COUNTS"), results("NO_BATCHES"))
        self.assertEqual(results("BATCH_REFUSED"), results("NO_BATCHES"))

    def test_a_crash_in_a_batch_is_found_by_its_case(self):
        status, text = self.verdicts("BATCH_CRASH")
        self.assertEqual(status, 1)
        self.assertIn("killed by signal 6", text)
        self.assertIn("replay", text)
        self.assertNotIn("alone", text)

    def test_a_crash_of_scenes_together_names_the_run_that_does_it(self):
        status, text = self.verdicts("BATCH_CRASH_TOGETHER")
        self.assertEqual(status, 1)
        self.assertIn("killed by signal 6", text)
        self.assertIn("not alone, but after the 1 draws before it in the same call", text)

    def test_a_crash_that_needs_earlier_calls_says_after_how_many(self):
        status, text = self.verdicts("CRASHES_THIRD")
        self.assertEqual(status, 1)
        self.assertIn("not alone, but after the 2 draws before it; alone the case", text)

    def test_requests_and_answers_larger_than_a_pipe_do_not_block(self):
        # An answer can be longer than the pipe holds; it is written before the program reads on.
        done = run("check", "--exec", "tests/tool/paints_all.py", "--property", DEGENERATE,
                   "--property", MODEL, "--cases", "64")  # fmt: skip
        self.assertEqual(done.returncode, 1, done.stderr)

    def check(self, description, *arguments):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "mine.subject")
            with open(path, "w", encoding="utf-8") as file:
                file.write(description)
            done = run("check", "--subject", path, "--property", MODEL, *arguments)
        self.assertEqual(done.returncode, 0, done.stdout.decode() + done.stderr.decode())
        return done.stdout.decode().replace(path, "mine.subject"), done.stderr.decode()

    def test_a_program_may_take_batches(self):
        text, errors = self.check("command tests/tool/batches.py\ntakes window batches\n",
                                  "--cases", "3", "--property", "BatchDrawsLikeSingleCalls")
        self.assertEqual(held(text), 2, text)
        self.assertIn("it was sent a batch ", errors)

    def test_a_program_may_be_sent_vertices_once(self):
        every, once, former = (self.check(f"command tests/tool/same_vertices.py\n{line}\n",
                                          "--cases", "4")
                               for line in ("takes window", "takes window same",
                                            "protocol 2\ntakes window"))  # fmt: skip
        self.assertEqual([text for text, _ in (once, former)], [every[0], every[0]])
        self.assertEqual(["sent the same" in errors for _, errors in (every, once, former)],
                         [False, True, True])  # fmt: skip


class BadNames(unittest.TestCase):
    def check(self, *arguments, words):
        done = run(*arguments)
        self.assertEqual(done.returncode, 2, done.stdout)
        self.assertEqual(done.stdout, b"")
        for word in words:
            self.assertIn(word, done.stderr.decode())

    def test_a_library_that_is_none(self):
        self.check("check", "--plugin", "no/such.so", words=["no/such.so"])
        self.check("check", "--plugin", "README.md", words=["README.md"])
        self.check("check", "--plugin", buggy("NO_SYMBOL"), words=["rasterproof_plugin_describe"])
        self.check("check", "--plugin", buggy("VERSION"), words=["version 99"])
        self.check("check", "--plugin", buggy("PROFILE"), words=["profile", "snap"])
        self.check("check", "--plugin", buggy("AT_LOAD"), words=["signal 6"])
        self.check("check", "--plugin", buggy("FIXED_BITS"),
                   words=["32 bits before the point", "set fixed_integer_bits"])  # fmt: skip

    def test_a_program_that_is_none(self):
        self.check("coverage", SCENE, "--exec", "./no-such-program", words=["no-such-program"])
        self.check("check", "--exec", "./nothing -x", words=["no program ./nothing"])
        self.check("check", "--exec", "./README.md", words=["README.md is not a program", "chmod"])
        self.check("check", "--exec", "./tests", words=["./tests is not a program"])

    def test_a_subject_file_that_is_none(self):
        self.check("coverage", SCENE, "--subject", "no.subject", words=["no.subject"])
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "x.subject")
            for text, word in (
                ("coverage some\n", "facing-counts"),
                ("wins last-drawn\n", "'wins', which is visible now"),
                ("coverage winning-id\n", "which is primitive-id now"),
                ('profile {"no_' 'clip": null}\n', "which is guard_band now"),
                ("takes window\n", "command"),
                ("command true\nvisible first-drawn\n", "primitive-id"),
                ("command true\nedge-error exact\n", "shows edges steps"),
                ("command true\nshows edges\nedge-error none\n", "none"),
                ("command true\nshows colours\n", "edges, steps"),
                ("command true\ncoverage primitive-id\nbarycentric-error 1e-5\n", "fragments"),
                ("command true\ncoverage fragments\nbarycentric-error -1\n", "-1"),
                ("command true\ncoverage fragments\ndepth-error much\n", "much"),
                ("command true\ncoverage primitive-id\nvisible all\n", "first-drawn"),
                ("command true\ntakes tiles\n", "neither window nor clip"),
                ("command true\nprotocol 4\n", "does not speak version '4' of the protocol"),
                ("command true\ninput fixed 12 signed\n", "format is malformed"),
                ("command true\ninput fixed 32.4 signed\n", "N from 1 to 31"),
                ("command true\ninput fixed 12.4\n", "the fixed-point format lacks its sign"),
                ("command true\ninput fixed 12.4 signed wraps\n", "'wraps' is not known"),
                ("command true\ninput fixed 12.4 signed\ntakes clip\n", "take clip space"),
                ('command true\ninput fixed 12.4 signed\nprofile {"name": "p", "fixed": '
                 '{"integer_bits": 11, "fraction_bits": 4}}\n', "different fixed-point formats"),
            ):
                with open(path, "w", encoding="utf-8") as file:
                    file.write(text)
                self.check("coverage", SCENE, "--subject", path, words=[path, word])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=0)
