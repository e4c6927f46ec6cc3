"""The Python package: arrays in and out, verdicts on functions of this process, strategies.

usage: python_test.py PACKAGE_FOLDER ORACLE COMMAND EXAMPLES [TEST...]
Without numpy, Hypothesis or pytest the tests that need them are skipped and say so.
"""
import contextlib
import io
import json
import os
import pathlib
import re
import shlex
import signal
import subprocess
import sys
import tempfile
import unittest

PACKAGE, ORACLE, COMMAND, EXAMPLES = (os.path.abspath(path) for path in sys.argv[1:5])
os.environ |= {"RASTERPROOF_ORACLE": ORACLE, "RASTERPROOF_COMMAND": COMMAND,
               "PYTHONPATH": PACKAGE, "PYTHONDONTWRITEBYTECODE": "1"}  # fmt: skip
sys.path[:0] = [PACKAGE, EXAMPLES]
sys.dont_write_bytecode = True
try:
    import numpy as np
    import rasterproof as rp
    from numpy_rasterizer import draw as textbook
except ModuleNotFoundError as lacking:
    print(f"skipped: {lacking}; install python3-numpy")
    sys.exit(77)

SIZE = (8, 8)
SQUARE = np.array([[[0, 0], [8, 0], [0, 8]], [[8, 0], [8, 8], [0, 8]]], float)


def exact(triangles, size):
    return rp.coverage(triangles, size, "real")


def covers_both_sides_of_horizontal_edges(triangles, size):
    counts = np.zeros(size[::-1], int)
    for triangle in triangles:
        covered = exact(triangle[np.newaxis], size)
        for (x, y), (end, other) in zip(triangle, np.roll(triangle, -1, axis=0)):
            if y == other and y % 1 == 0.5 and 0 <= y < size[1]:
                x, end = np.clip([min(x, end) + 0.5, max(x, end) - 0.5], 0, size[0]).astype(int)
                covered[int(y), x:end] = 1
        counts += covered
    return counts


class Arrays(unittest.TestCase):
    def test_counts_have_the_shape_of_the_target(self):
        counts = rp.coverage(SQUARE, (8, 6))
        self.assertEqual((counts.shape, counts.dtype), ((6, 8), np.uint32))
        self.assertTrue((counts == 1).all())
        self.assertEqual(rp.coverage(SQUARE, SIZE, "d3d11-canonical-4x").shape, (8, 8, 4))
        facings = rp.coverage(SQUARE, SIZE, facings=True)
        self.assertEqual([int(side.sum()) for side in facings], [0, 64])
        self.assertEqual(rp.coverage(np.zeros((0, 3, 2)), SIZE).sum(), 0)

    def test_a_mesh_is_the_same_with_indices_of_its_vertices(self):
        vertices = np.array([[0, 0], [8, 0], [0, 8], [8, 8]], np.float32)
        mesh = (vertices, np.array([[0, 1, 2], [1, 3, 2]]))
        self.assertTrue((rp.coverage(mesh, SIZE) == rp.coverage(SQUARE, SIZE)).all())

    def test_decisions_say_what_is_open(self):
        decisions = rp.decided(SQUARE, SIZE, "vulkan")
        self.assertEqual(decisions.shape, (2, 8, 8))
        self.assertEqual(decisions[0, 0, 0], rp.MUST)
        self.assertEqual(decisions[0, 7, 7], rp.MUST_NOT)
        self.assertTrue((decisions[:, range(8), range(7, -1, -1)] == rp.MAY).all(), "the diagonal")
        least, most = rp.bounds(SQUARE, SIZE, "vulkan")
        self.assertTrue((least == 1).all() and (most == 1).all(), "each has one owner")

    def test_drawings_are_judged_together(self):
        counts = rp.coverage(SQUARE, SIZE)
        self.assertTrue(rp.legal(SQUARE, SIZE, counts, "gl"))
        counts[0, 7] = 2
        verdict = rp.legal(SQUARE, SIZE, counts, "gl")
        self.assertFalse(verdict)
        self.assertTrue(verdict.is_judged)
        self.assertIn("column 7 row 0: covered 2 times", verdict.reason)
        self.assertTrue(rp.legal(SQUARE, SIZE, counts > 0, "gl", mask=True))

    def test_single_questions_are_exact(self):
        tiny = 5e-324
        self.assertEqual([rp.edge_sign((0, 0), (1, 0), (0, y)) for y in (-tiny, 0, tiny)],
                         [1, 0, -1])  # fmt: skip
        self.assertEqual(rp.barycentrics(((0, 0), (3, 0), (0, 3)), (1, 1)), (1 / 3,) * 3)
        corners = ((0, 0, 1), (16, 0, 4), (0, 4, 1))
        self.assertEqual(rp.value(corners, (1, 4, 1), (2, 0)), (8 / 5, 12 / 25, 0.0))
        self.assertEqual(rp.value(corners, (1, 4, 1), (2, 0), "linear")[0], 5 / 2)
        with self.assertRaises(rp.BadArgument):
            rp.value(corners, (1, 4, 1), (2, 0), "flat")
        floor = {"name": "floor", "subpixel_bits": 2, "snap_rule": "floor"}
        self.assertEqual(rp.place((1.49, -0.01), SIZE, floor), (1.25, -0.25))

    def test_bad_arguments_are_named_with_the_remedy(self):
        for said, act in (
            ("give (n, 3, 2)", lambda: rp.coverage(np.zeros((3, 2)), SIZE)),
            ("two to four numbers", lambda: rp.coverage(np.zeros((1, 3, 5)), SIZE)),
            ("index 4 of 3", lambda: rp.coverage((np.zeros((3, 2)), [[0, 1, 4]]), SIZE)),
            ("give (width, height)", lambda: rp.coverage(SQUARE, 8)),
            ("65536", lambda: rp.coverage(SQUARE, (8, 70000))),
            ("vulkan", lambda: rp.coverage(SQUARE, SIZE, "vulcan")),
            ("subpixel_bits", lambda: rp.Profile({"name": "n", "subpixel_bits": -1})),
            ("give integers", lambda: rp.legal(SQUARE, SIZE, np.zeros(SIZE), "gl")),
            ("give (8, 8)", lambda: rp.legal(SQUARE, SIZE, np.zeros((4, 4), int), "gl")),
            ("below 0", lambda: rp.legal(SQUARE, SIZE, np.full(SIZE, -1), "gl")),
            ("not finite", lambda: rp.edge_sign((0, 0), (1, 0), (0, np.nan))),
            ("a function of", lambda: rp.check(7)),
            ("give float32", lambda: rp.check(exact, format="half")),
        ):
            with self.subTest(said), self.assertRaises(rp.BadArgument) as raised:
                act()
            self.assertIn(said, str(raised.exception))
        with self.assertRaisesRegex(rp.NotDecided, "not state where samples lie"):
            rp.decided(SQUARE, SIZE, "vulkan-4x")


class Fragments(unittest.TestCase):
    HEAD = b"draw 7 2 1 1 window 3 1 wants=primitive-ids,values,derivatives channels=2 npy\n"

    def answered(self, draw, *later, batches=False):
        from rasterproof import _serve

        array = _serve.array_bytes
        vertices = array(np.array([[0, 0, 0, 1], [4, 0, 0, 1], [0, 4, 0, 1]], float))
        triangles = array(np.array([[0, 1, 2]], np.int32))
        request = self.HEAD + vertices + b"u flat centre\n" + array(np.array([[1.0], [2], [4]]))
        request += b"q inverse-w sample\n" + triangles + b"".join(
            line + b" npy\n" + triangles for line in later)  # fmt: skip
        replies = io.BytesIO()
        _serve.serve(draw, io.BytesIO(request), replies, batches=batches, coverage="fragments")
        return replies.getvalue()

    def test_a_scene_has_its_channels_and_values_are_answered(self):
        scenes = []

        def draw(scene):
            scenes.append(scene)
            return rp.Fragments(
                np.array([[0, -1]]), values={"u": [[0.1, 9]], "q": [[np.inf, 9]]},
                derivatives=np.arange(8.0).reshape(1, 2, 2, 2))  # fmt: skip

        lines = (b"draw 8 2 1 1 window same 1 wants=primitive-ids,values channels=same",
                 b"draw 9 2 1 1 window same 1 wants=coverage")  # fmt: skip
        said = self.answered(draw, *lines)
        self.assertEqual(said[: said.index(b"npy")], b"fragments 7\n0 0.1 0.0 1.0 inf 2.0 3.0 -1\n"
                         b"fragments 8\n0 0.1 inf -1\ncounts 9 ")  # fmt: skip
        self.assertEqual(scenes[0].triangles.shape, (1, 3, 4))
        for scene in scenes[:2]:
            self.assertEqual(list(scene.channels), ["u", "q"])
            self.assertEqual(scene.channels["u"][:2], ("flat", "centre"))
            self.assertEqual(scene.channels["u"].values.tolist(), [[1, 2, 4]])
            self.assertIsNone(scene.channels["q"].values)
        self.assertEqual((scenes[2].wants, scenes[2].channels), (frozenset(), {}))

    def test_what_is_lacking_is_named(self):
        ids = np.zeros((1, 2), int)
        for said, drawn in (
            ("it returned ndarray; return rasterproof.Fragments(ids, ...)", ids),
            ("it returned ids of shape (2,), not (1, 2)", rp.Fragments(ids[0])),
            ("it returned no values; give an array of shape (1, 2, 2)", rp.Fragments(ids)),
            ("it returned no values of u; give an array of shape (1, 2)",
             rp.Fragments(ids, values={"q": ids})),
            ("it returned values of shape (1, 2), not (1, 2, 2)", rp.Fragments(ids, values=ids)),
            ("it returned no derivatives; give an array of shape (1, 2, 2, 2)",
             rp.Fragments(ids, values=np.zeros((1, 2, 2)))),
        ):
            fault = f"fault 7 {said}\n".encode()
            self.assertEqual(self.answered(lambda scene, d=drawn: d), fault)
            self.assertEqual(self.answered(lambda scenes, d=drawn: [d], batches=True), fault)


class Verdicts(unittest.TestCase):
    def test_a_right_function_holds(self):
        report = rp.check(exact, "real", cases=20).require()
        self.assertRegex(report.text, r"(?m)^exact.subject: \d\d hold, 0 violated,")
        self.assertEqual(report.violated, ())

    def test_many_scenes_a_call_are_judged_alike(self):
        calls = []

        def many(scenes):
            calls.append(len(scenes))
            return [exact(*scene) for scene in scenes]

        report = rp.check(many, cases=10, batches=True,
                          properties=["CoverageEqualsTheModel", "BatchDrawsLikeSingleCalls"])
        self.assertTrue(report, report.text)
        self.assertEqual(calls, [], "only copies of this process draw")

    def test_the_example_covers_a_shared_edge_twice(self):
        report = rp.check(textbook, "real", cases=8, options=["--no-cause"])
        self.assertEqual(report.status, 1)
        self.assertIn("SharedEdgeSamplesAreCoveredOnce", report.violated)
        with self.assertRaisesRegex(AssertionError, "observed covered 2 times, expected exactly"):
            report.require()

    def test_ids_are_answered_as_ids(self):
        def draw(triangles, size):
            ids = np.full(size[::-1], -1)
            for index, triangle in enumerate(triangles):
                ids[exact(triangle[np.newaxis], size) > 0] = index
            return ids

        report = rp.check(draw, cases=5, coverage="primitive-id", properties=[
            "PrimitiveIdFollowsTheStatedOrder", "CoverageEqualsTheModel"])  # fmt: skip
        self.assertTrue(report, report.text)

    def test_values_of_the_example_hold(self):
        import numpy_values

        report = rp.check(numpy_values.draw, numpy_values.PROFILE, cases=5, clip=True,
                          coverage="fragments", shows="values derivatives")  # fmt: skip
        self.assertTrue(report, report.text)
        with self.assertRaisesRegex(rp.BadArgument, "add a line: coverage fragments"):
            rp.check(exact, cases=1, shows=["values"])

    def test_exceptions_crashes_and_hangs_are_findings_with_their_cause(self):
        def raises(triangles, size):
            raise KeyError("not mine")

        def crashes(triangles, size):
            os.kill(os.getpid(), signal.SIGSEGV)

        def hangs(triangles, size):
            while True:
                pass

        def is_killed(triangles, size):
            os.kill(os.getpid(), signal.SIGKILL)

        def floats(triangles, size):
            counts = exact(triangles, size)
            return counts if size == (7, 5) else counts * 1.0

        def transposed(triangles, size):
            return exact(triangles, size if size == (7, 5) else size[::-1])

        def refuses(triangles, size):
            raise rp.Refused("never")

        for draw, said, status in (
            (raises, "KeyError: 'not mine' (python_test.py, line", 1),
            (crashes, "was killed by signal 11", 1),
            (is_killed, "was killed by signal 9", 1),
            (hangs, "hangs", 1),
            (floats, "float64 numbers, not integers", 1),
            (transposed, "its answer's array has shape", 1),
            (refuses, "refused", 4),
        ):
            with self.subTest(draw.__name__), contextlib.redirect_stderr(io.StringIO()):
                limit = "0.3" if draw is hangs else "100"  # in its own time
                report = rp.check(draw, cases=5, properties=["CoverageEqualsTheModel"],
                                  options=["--time-limit", limit, "--no-cause"])
                self.assertEqual(report.status, status, report.text)
                self.assertIn(said, report.text)

    def test_what_a_wrong_draw_returns_is_told_before_any_case(self):
        def drawn(made):
            return lambda triangles, size: made(exact(triangles, size))

        for said, draw, options in (
            ("it returned None", drawn(lambda counts: None), {}),
            ("it returned float64 numbers", drawn(lambda counts: counts * 1.0), {}),
            (r"shape \(7, 5\); give integers of shape \(5, 7\)", drawn(np.transpose), {}),
            (r"give integers of shape \(2, 5, 7\)", exact, {"coverage": "facing-counts"}),
            (r"give integers of shape \(5, 7, 4\)", exact, {"profile": "d3d11-canonical-4x"}),
            ("a list of one array", lambda scenes: exact(*scenes[0]), {"batches": True}),
        ):
            with self.subTest(said), self.assertRaisesRegex(rp.BadArgument, said):
                rp.check(draw, cases=1, **options)
        nested = rp.check(drawn(np.ndarray.tolist), cases=1, properties="CoverageEqualsTheModel")
        self.assertTrue(nested, nested.text)
        with self.assertRaisesRegex(rp.BadArgument, "did you mean vulkan.*\n *real, d3d11"):
            rp.check(exact, "vulcan")
        with self.assertRaisesRegex(rp.BadArgument, "name: 'a b'; give letters"):
            rp.check(exact, name="a b")

    def test_progress_is_not_in_the_text(self):
        from rasterproof import checking

        lines = "  certifying: 5 of 89 after 4 s; 1 more at work\n  scene map: after 9 s\nend\n"
        self.assertEqual(checking._PROGRESS.sub("", lines), "end\n")

    def test_a_certificate_lies_under_the_name_and_its_failures_are_data(self):
        with tempfile.TemporaryDirectory() as folder:
            scenes = pathlib.Path(folder, "scenes.json")
            ties = {"name": "ties", "kind": "hard", "path": f"{EXAMPLES}/../../scenes/ties.json"}
            scenes.write_text(json.dumps({"rasterproof_scene_set": 1, "scenes": [ties]}))
            report = rp.certify(textbook, pathlib.Path(folder, "out"), cases=2, scenes=scenes,
                                name="mine", progress=False)  # fmt: skip
            self.assertIn('testsuite name="mine.subject"',
                          pathlib.Path(folder, "out/mine.subject/junit.xml").read_text("utf-8"))
        self.assertEqual(report.status, 1, report.text)
        self.assertIn("CoverageEqualsTheModel", report.violated)
        self.assertIn("--subject mine.subject", report.failures[0]["next"])

    def test_paths_in_options_are_seen_from_where_the_caller_stands(self):
        from rasterproof import checking

        at = os.getcwd()
        self.assertEqual(
            checking._absolute(["--known", "a", "--save=b", "--profile", "gl", "--json", "-", "c"]),
            ["--known", f"{at}/a", f"--save={at}/b", "--profile", "gl", "--json", "-", "c"])
        with tempfile.NamedTemporaryFile(dir=at) as file:
            name = os.path.basename(file.name)
            self.assertEqual(checking._absolute(["--profile", name])[1], f"{at}/{name}")

    def test_what_a_draw_prints_is_no_answer(self):
        def chatty(triangles, size):
            print("drawing")
            return exact(triangles, size)

        with open(os.devnull, "w", encoding="utf-8") as nowhere:
            kept = os.dup(2)
            os.dup2(nowhere.fileno(), 2)
            report = rp.check(chatty, cases=3, properties=["CoverageEqualsTheModel"])
            os.dup2(kept, 2)
        self.assertTrue(report, report.text)

    def test_bad_input_of_the_command_is_an_error(self):
        with self.assertRaisesRegex(rp.BadArgument, "NoSuchProperty"):
            rp.check(exact, properties=["NoSuchProperty"])
        with unittest.mock.patch.dict(os.environ, RASTERPROOF_COMMAND="/nowhere/rasterproof"):
            with self.assertRaisesRegex(FileNotFoundError, "RASTERPROOF_COMMAND"):
                rp.check(exact)

    def test_as_a_program_the_module_serves_a_named_function(self):
        with tempfile.TemporaryDirectory() as folder:
            described = pathlib.Path(folder, "mine.subject")
            described.write_text(f"command {sys.executable} -m rasterproof.serve "
                                 "numpy_rasterizer:draw\nprotocol 3\n", encoding="utf-8")
            done = subprocess.run(
                [COMMAND, "check", "--subject", described, "--cases", "10", "--memory-limit", "0",
                 "--no-cause", "--property", "SharedEdgeSamplesAreCoveredOnce"], text=True,
                capture_output=True, check=False,
                env=os.environ | {"PYTHONPATH": f"{PACKAGE}:{EXAMPLES}"})  # fmt: skip
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("observed covered 2 times", done.stdout)
        self.assertNotIn("Warning", done.stderr)

    def test_the_commands_that_a_report_prints_run_as_they_stand(self):
        report = rp.check(textbook, cases=5, properties="CoverageEqualsTheModel",
                          options=["--no-cause"])  # fmt: skip
        text = report.text.split("for these commands write draw.subject, beside your module:\n")[1]
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "draw.subject").write_text(
                "".join(line[2:] + "\n" for line in text.splitlines()), encoding="utf-8")
            words = shlex.split(report.failures[0]["next"])
            done = subprocess.run(
                [COMMAND, *words[1:], "--memory-limit", "0"], text=True, capture_output=True,
                cwd=folder, env=os.environ | {"PYTHONPATH": f"{PACKAGE}:{EXAMPLES}"},
                check=False)  # fmt: skip
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("observed 1, expected 0", done.stdout)


class Strategies(unittest.TestCase):
    def setUp(self):
        try:
            import hypothesis
        except ModuleNotFoundError:
            self.skipTest("no Hypothesis; install python3-hypothesis")
        self.settings = hypothesis.settings(max_examples=300, deadline=None, database=None,
                                            suppress_health_check=[
                                                hypothesis.HealthCheck.too_slow],
                                            derandomize=True)  # fmt: skip

    def test_triangles_near_edges_find_a_wrong_tie_and_shrink_it(self):
        from hypothesis import find

        from rasterproof.strategies import triangles

        def is_wrong(triangle):
            return not rp.legal(triangle, (16, 16), textbook(triangle, (16, 16)), "gl-canonical")

        smallest = find(triangles(near_edge=True), is_wrong, settings=self.settings)
        self.assertEqual(smallest.shape, (1, 3, 2))
        self.assertLessEqual(np.abs(smallest).max(), 2, smallest)

    def test_a_falsifying_example_runs_when_it_is_pasted(self):
        import hypothesis
        from hypothesis.reporting import with_reporter

        from rasterproof.strategies import meshes, triangles

        for strategy in (triangles(bits=16), meshes(), meshes(shared_edges=False)):
            told, failed = [], []

            def fails(t):
                failed.append(np.asarray(t))  # noqa: B023
                assert len(t) == 0

            with with_reporter(told.append), self.assertRaises(AssertionError) as caught:
                self.settings(hypothesis.given(t=strategy)(fails))()
            told += getattr(caught.exception, "__notes__", [])
            pasted = re.search(r"t=(np\.array\(.*?\)),?\s", "\n".join(told) + "\n", re.DOTALL)
            self.assertTrue(pasted, told)
            np.testing.assert_array_equal(eval(pasted[1]), failed[-1])

    def test_a_mesh_covers_nothing_twice(self):
        from hypothesis import given

        from rasterproof.strategies import meshes

        seen = []

        @self.settings
        @given(meshes())
        def once(mesh):
            seen.append(len(mesh))
            assert rp.coverage(mesh, (16, 16)).max() <= 1

        once()
        self.assertGreater(max(seen), 2)

    def test_meshes_find_wrong_ties_within_a_hundred_examples(self):
        import hypothesis

        from rasterproof.strategies import meshes

        for wrong in (textbook, covers_both_sides_of_horizontal_edges):
            def once(mesh):
                assert wrong(mesh, (16, 16)).max() <= 1  # noqa: B023

            fewer = hypothesis.settings(self.settings, max_examples=100)
            with self.subTest(wrong.__name__), self.assertRaises(AssertionError):
                fewer(hypothesis.given(meshes(shared_edges=True))(once))()

    def test_plain_triangles_stay_on_their_grid(self):
        from hypothesis import given

        from rasterproof.strategies import meshes, triangles

        @self.settings
        @given(triangles(bits=4, margin=2), meshes(shared_edges=False))
        def on_grid(triangle, soup):
            assert (triangle * 16 == np.round(triangle * 16)).all()
            assert -2 <= triangle.min() and triangle.max() <= 18
            assert len(soup) >= 2

        on_grid()


class Fixture(unittest.TestCase):
    def test_what_failed_is_kept_and_asked_first(self):
        try:
            import pytest  # noqa: F401
        except ModuleNotFoundError:
            self.skipTest("no pytest; install python3-pytest")
        with tempfile.TemporaryDirectory() as folder:
            pathlib.Path(folder, "test_mine.py").write_text(
                "from numpy_rasterizer import draw\n\n\n"
                "def test_mine(rasterproof_check):\n"
                "    rasterproof_check(draw, 'real', 20,\n"
                "                      properties=['SharedEdgeSamplesAreCoveredOnce'],\n"
                "                      options=['--no-cause'])\n",
                encoding="utf-8")  # fmt: skip
            environment = os.environ | {"PYTHONPATH": f"{PACKAGE}:{EXAMPLES}"}
            for n in range(2):
                done = subprocess.run(
                    [sys.executable, "-m", "pytest", "-q", "-p", "no:cacheprovider", "-p",
                     "rasterproof.pytest_plugin", folder], text=True, capture_output=True,
                    env=environment, cwd=folder, check=False)  # fmt: skip
                self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
                self.assertIn("observed covered 2 times", done.stdout)
                kept = list(pathlib.Path(folder, ".rasterproof").rglob("*.json"))
                self.assertEqual(len(kept), 1, f"run {n}: {kept}")


if __name__ == "__main__":
    import unittest.mock

    unittest.main(argv=sys.argv[:1] + sys.argv[5:])
