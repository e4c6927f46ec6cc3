"""vectors generate and verify: the same bytes each time, and what convicts.

usage: vectors_test.py PROGRAM SOURCES [TEST ...]
"""
import json
import math
import os
import subprocess
import sys
import tempfile
import unittest
from fractions import Fraction

PROGRAM = os.path.abspath(sys.argv[1])
SOURCES = os.path.abspath(sys.argv[2])
CASES = "60"
# Of 60 cases of each profile, fewer than there are domains: a new domain is none of them. They
# change when a recipe, a clause's reading or the format does: then CHANGELOG.md says so.
BODIES = {"vulkan": "1657266f09e4990f", "d3d11-canonical": "ff22b87af3a70307"}


def run(*arguments, **options):
    return subprocess.run([PROGRAM, "vectors", *arguments], capture_output=True, cwd=SOURCES,
                          timeout=900, text=True, **options)  # fmt: skip


def samples(top, rows, row_length):
    return {(top + k) * row_length + bit for k, row in enumerate(rows)
            for bit in range(row_length) if int(row, 16) >> bit & 1}  # fmt: skip


def rows_of(covered, row_length, height):
    return [f"{sum(1 << s % row_length for s in covered if s // row_length == row):x}"
            for row in range(height)]  # fmt: skip


def interpolated(case, line, channel):
    """The value, and its derivatives by x and y, by the definition."""
    corners = case["triangles"][line["triangle"]]["vertices"]
    (x0, y0), (x1, y1), (x2, y2) = [[Fraction(c, 256) for c in case["fixed"][v]] for v in corners]
    w = [Fraction(float.fromhex(case["w"][v])) for v in corners]
    kind = channel["interpolation"]
    a = [Fraction(float.fromhex(channel["numbers"][v])) if channel["numbers"] else Fraction(1)
         for v in corners]  # fmt: skip
    x, y = (line[key] + Fraction(at, 256) for key, at in
            zip(("column", "row"), case["samples_256"][line["sample"]]))  # fmt: skip
    edges = [((y2 - y1), (x1 - x2), x2 * y1 - x1 * y2), ((y0 - y2), (x2 - x0), x0 * y2 - x2 * y0),
             ((y1 - y0), (x0 - x1), x1 * y0 - x0 * y1)]  # fmt: skip
    above, below = ([sum(e[k] * f for e, f in zip(edges, factors)) for k in range(3)]
                    for factors in ([t if kind == "linear" else t / u for t, u in zip(a, w)],
                                    [1 / u if kind == "perspective" else 1 for u in w]))
    n, d = (f[0] * x + f[1] * y + f[2] for f in (above, below))
    return n / d, *((above[k] * d - n * below[k]) / d**2 for k in (0, 1))


def as_float(number):
    """Rounded once, ties to even: within the normal floats and below."""
    exponent = max(math.frexp(float(number))[1] - 24, -149) if number else 0
    return math.ldexp(round(number / Fraction(2) ** exponent), exponent)


class VectorsTest(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.vectors = {}
        for profile in BODIES:
            path = os.path.join(cls.folder.name, f"{profile}.jsonl")
            done = run("generate", "--profile", profile, "--cases", CASES, "--out", path)
            assert done.returncode == 0, done.stderr
            with open(path, encoding="utf-8") as file:
                cls.vectors[profile] = (path, [json.loads(line) for line in file])

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    def write(self, name, text):
        path = os.path.join(self.folder.name, name)
        with open(path, "w", encoding="utf-8") as file:
            file.write(text)
        return path

    def answers(self, profile, choose, leave_out=None):
        """What `choose` covers of each triangle: of its must and its may."""
        lines = []
        for v in self.vectors[profile][1][1:]:
            if "case" not in v or v["case"] == leave_out:
                continue
            length = v["width"] * len(v["samples_256"])
            for k, t in enumerate(v["triangles"]):
                covered = choose(v, k, samples(t["must_top"], t["must"], length),
                                 samples(t["may_top"], t["may"], length))  # fmt: skip
                rows = rows_of(covered, length, v["height"])
                lines.append(json.dumps({"case": v["case"], "triangle": k, "rows": rows}))
        return "".join(line + "\n" for line in lines)

    def verify(self, profile, text, *more):
        answers = self.write("answers.jsonl", text)
        return run("verify", self.vectors[profile][0], answers, *more)

    def refused(self, done, *words):
        self.assertEqual(done.returncode, 2, done.stdout + done.stderr)
        self.assertEqual(done.stdout, "")
        for word in words:
            self.assertIn(word, done.stderr)

    def test_the_same_options_give_the_same_bytes(self):
        for profile, (path, lines) in self.vectors.items():
            again = run("generate", "--profile", profile, "--cases", CASES)
            with open(path, encoding="utf-8") as file:
                self.assertEqual(again.stdout, file.read())
            self.assertEqual(lines[0]["body_fnv1a64"], BODIES[profile], profile)
            cases = [v for v in lines if "case" in v]
            self.assertEqual(lines[0]["cases"], len(cases))
            self.assertEqual(lines[0]["triangles"], sum(len(v["triangles"]) for v in cases))
            self.assertEqual(lines[0]["joints"], sum("joint" in v for v in lines))
            self.assertEqual(lines[0]["profile"]["name"], profile)
        other = run("generate", "--profile", "vulkan", "--cases", CASES, "--seed", "2")
        self.assertNotEqual(json.loads(other.stdout.split("\n", 1)[0])["body_fnv1a64"],
                            BODIES["vulkan"])  # fmt: skip

    def test_values_are_those_of_the_definition(self):
        """By fractions, from the places of the lattice."""
        analytic = {"derivatives": "analytic", "linear": True, "inverse_w": True}
        profile = self.write("analytic.json", json.dumps(
            {"name": "mine", "subpixel_bits": 8, "coordinate_limit": 4096,
             "values": {"error": {"ulps": 2, "conditions": 3}, "derivative_error": {"ulps": 4},
                        **analytic}}))  # fmt: skip
        done = run("generate", "--profile", profile, "--cases", "24", "--values")
        self.assertEqual(done.returncode, 0, done.stderr)
        header, *lines = map(json.loads, done.stdout.splitlines())
        self.assertEqual(header["values"], sum("value" in line for line in lines))
        kinds = set()
        for line in lines:
            if "case" in line:
                case = line
            elif "value" in line:
                self.assertEqual(case["case"], line["value"])
                channel, = (c for c in case["channels"] if c["name"] == line["channel"])
                kinds.add(channel["interpolation"])
                exact = interpolated(case, line, channel)
                for shown, number in zip((line, line["dx"], line["dy"]), exact):
                    self.assertEqual(Fraction(shown["exact"]), number, line)
                    low, nearest, high = (float.fromhex(shown[key])
                                          for key in ("low", "nearest", "high"))  # fmt: skip
                    self.assertEqual(as_float(number), nearest)
                    self.assertLess(low, high)
                    self.assertTrue(low <= nearest <= high)
        self.assertEqual(kinds, {"perspective", "linear", "inverse-w"})
        self.assertGreater(header["values"], 200)

    def test_flat_values_are_the_provoking_vertex_s(self):
        for provoking, corner in (("first", 0), ("last", 2)):
            profile = self.write("flat.json", json.dumps(
                {"name": "mine", "subpixel_bits": 8, "coordinate_limit": 4096,
                 "values": {"flat": True, "provoking": provoking}}))  # fmt: skip
            done = run("generate", "--profile", profile, "--cases", "12", "--values")
            self.assertEqual(done.returncode, 0, done.stderr)
            asked = 0
            case = {}
            for line in map(json.loads, done.stdout.splitlines()):
                if "case" in line:
                    case = line
                if line.get("channel") != "flat":
                    continue
                channel, = (c for c in case["channels"] if c["name"] == "flat")
                indices = case["triangles"][line["triangle"]]["vertices"]
                number = float.fromhex(channel["numbers"][indices[corner]])
                asked += 1
                for key in ("low", "nearest", "high"):
                    self.assertEqual(float.fromhex(line[key]), number)
                self.assertNotIn("dx", line)
            self.assertGreater(asked, 20)

    def test_values_change_nothing_else(self):
        _, lines = self.vectors["d3d11-canonical"]
        done = run("generate", "--profile", "d3d11-canonical", "--cases", CASES, "--values")
        others = [json.loads(line) for line in done.stdout.splitlines()[1:]]
        cases = [{key: v for key, v in line.items() if key not in ("w", "channels")}
                 for line in others if "value" not in line]  # fmt: skip
        self.assertEqual(cases, lines[1:])
        path = self.write("values.jsonl", done.stdout)
        done = run("verify", path, "--subject", "i64-snap8")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.refused(run("generate", "--profile", "vulkan", "--values"),
                     "leaves open where vertices lie")  # fmt: skip

    def test_the_hash_is_that_of_the_lines_after_the_first(self):
        path, lines = self.vectors["vulkan"]
        with open(path, "rb") as file:
            body = file.read().split(b"\n", 1)[1]
        value = 0xCBF29CE484222325
        for byte in body:
            value = (value ^ byte) * 0x100000001B3 & 0xFFFFFFFFFFFFFFFF
        self.assertEqual(lines[0]["body_fnv1a64"], f"{value:016x}")

    def test_legal_rasterizers_contradict_nothing(self):
        for profile, subjects in (("d3d11-canonical", ("i64-snap8", "legal:tile-3")),
                                  ("vulkan", ("i64-snap8", "legal:vulkan-owner-by-sample"))):
            for subject in subjects:
                done = run("verify", self.vectors[profile][0], "--subject", subject)
                self.assertEqual(done.returncode, 0, subject + done.stdout + done.stderr)
                self.assertRegex(done.stdout, rf"\Ano contradiction in {CASES} cases, \d+ joint "
                                 r"constraints among them\n\Z")  # fmt: skip
                self.assertNotIn("pass", done.stdout)

    # Legal, and wherever each triangle alone is compared with its neighbour it looks as if not.
    def test_joint_constraints_are_about_one_call(self):
        path = os.path.join(self.folder.name, "d3d11.jsonl")
        done = run("generate", "--profile", "d3d11", "--out", path)
        self.assertEqual(done.returncode, 0, done.stderr)
        done = run("verify", path, "--subject", "legal:d3d11-snap-by-call")
        self.assertRegex(done.stdout, r"\Ano contradiction in 500 cases, [1-9]\d* joint")
        # So of answers from calls of their own no joint constraint is judged.
        owed = self.answers("vulkan", lambda v, k, must, may: must)
        self.assertEqual(self.verify("vulkan", owed).returncode, 1)
        alone = self.verify("vulkan", owed, "--alone")
        self.assertEqual(alone.returncode, 0)
        self.assertIn(f"{CASES} cases, 0 joint constraints", alone.stdout)

    def test_other_samples_and_the_other_axis(self):
        profile = {"subpixel_bits": 8, "coordinate_limit": "0x1p+15"}
        for name, keys in (("y-up", {"y_axis": "up"}),
                           ("samples-four", {"sample_locations": "standard-4"})):  # fmt: skip
            path = self.write("mine.json", json.dumps({"name": name, **profile, **keys}))
            out = os.path.join(self.folder.name, "mine.jsonl")
            done = run("generate", "--profile", path, "--cases", "120", "--out", out)
            self.assertEqual(done.returncode, 0, done.stderr)
            done = run("verify", out, "--subject", f"legal:{name}")
            self.assertEqual(done.returncode, 0, name + done.stdout + done.stderr)
            self.refused(run("verify", out, "--subject", "i64-snap8"), "sample locations")

    def test_worlds(self):
        out = os.path.join(self.folder.name, "world.jsonl")
        made = run("generate", "--profile", "d3d11-canonical", "--world", "1.1", "--out", out)
        self.assertEqual(made.returncode, 0, made.stderr)
        self.assertRegex(made.stderr, r"\Aworld u1\.1: 4096 triangles, about \d+ s and \d+ MB")
        done = run("verify", out, "--subject", "i64-snap8")
        self.assertEqual(done.stdout, "no contradiction in 4096 cases, 0 joint constraints among "
                         "them\n", done.stderr)  # fmt: skip
        done = run("verify", out, "--subject", "textbook", "--show", "1")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, r"\Au1\.1:\d+@0 triangle 0, column \d row \d: covered")
        none = os.path.join(self.folder.name, "none.jsonl")
        for world, word in (("2.2", "--yes"), ("3.2", "more than 16 GB"), ("9.9", "as 3.2")):
            done = run("generate", "--profile", "d3d11-canonical", "--world", world, "--out", none)
            self.refused(done, "--world", world, word)
            self.assertFalse(os.path.exists(none))

    def test_a_wrong_tie_rule_is_convicted(self):
        done = run("verify", self.vectors["d3d11-canonical"][0], "--subject", "textbook")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertRegex(done.stdout, r"\A\S+:\d+@1 triangle \d+, column \d+ row \d+: ")
        self.assertIn("covered, and must not be: the stated model\n", done.stdout)
        self.assertRegex(done.stdout, r"\n\d+ contradictions in \d+ cases, of \d+ with answers\n\Z")

    def test_open_samples_may_be_answered_either_way_but_neighbours_must_agree(self):
        for choose in (lambda v, k, must, may: must, lambda v, k, must, may: must | may):
            done = self.verify("vulkan", self.answers("vulkan", choose))
            self.assertEqual(done.returncode, 1)
            self.assertNotIn("must be", done.stdout)
            self.assertIn("exactly one of triangles", done.stdout)
            self.assertIn("vulkan.common-edge", done.stdout)
        # One owner of each, whichever it is.
        owners = {(v["joint"], v["row"], v["column"]): v for v in self.vectors["vulkan"][1]
                  if "joint" in v}  # fmt: skip

        def agreed(v, k, must, may):
            def is_mine(sample):
                joint = owners.get((v["case"], sample // v["width"], sample % v["width"]))
                return joint is not None and k in joint["triangles"][: joint["counts"][-1]]
            return must | {sample for sample in may if is_mine(sample)}
        done = self.verify("vulkan", self.answers("vulkan", agreed))
        self.assertEqual(done.returncode, 0, done.stdout)

    def test_one_sample_too_few_or_too_many_is_named(self):
        changed = []

        def change(v, k, must, may):
            outside = set(range(v["width"] * v["height"])) - must - may
            if len(changed) == 0 and must:
                changed.append((v, k, min(must), "not covered, and must be"))
                return must - {min(must)}
            if len(changed) == 1 and outside and v is not changed[0][0]:
                changed.append((v, k, max(outside), "covered, and must not be"))
                return must | {max(outside)}
            return must
        done = self.verify("d3d11-canonical", self.answers("d3d11-canonical", change))
        self.assertEqual(done.returncode, 1)
        lines = [f"{v['case']} triangle {k}, column {s % v['width']} row {s // v['width']}: "
                 f"{what}: the stated model\n" for v, k, s, what in changed]  # fmt: skip
        self.assertEqual(done.stdout, "".join(lines) + "2 contradictions in 2 cases, of "
                         f"{CASES} with answers\n")  # fmt: skip

    def test_missing_answers_are_told(self):
        lines = self.vectors["d3d11-canonical"][1]
        of_must = lambda v, k, must, may: must
        first = lines[1]
        done = self.verify("d3d11-canonical",
                           self.answers("d3d11-canonical", of_must, first["case"]))  # fmt: skip
        self.assertEqual(done.returncode, 0)
        self.assertRegex(done.stdout,
                         rf"\Ano answer for {len(first['triangles'])} triangles?, 0 cases answered "
                         rf"in part\nno contradiction in {int(CASES) - 1} cases")  # fmt: skip
        nothing = self.verify("d3d11-canonical", "")
        self.assertEqual(nothing.returncode, 4)
        self.assertIn("no contradiction in 0 cases", nothing.stdout)

    def test_bad_files(self):
        path = self.vectors["vulkan"][0]
        with open(path, encoding="utf-8") as file:
            text = file.read()
        good = self.write("good.jsonl", "")
        for name, damaged, words in (
            ("hash", text[:-20] + text[-18:], ("line 1: body_fnv1a64", "generate the file again")),
            ("cut", text[: len(text) // 2], ("body_fnv1a64",)),
            ("cases", text.replace('"cases":', '"cases":1', 1), ("line 1: header_fnv1a64",)),
            ("triangles", text.replace('"triangles":', '"triangles":1', 1),
             ("line 1: header_fnv1a64", "was changed")),
            ("name", text.replace('"profile_name":"vulkan"', '"profile_name":"gl"'),
             ("line 1: header_fnv1a64",)),
            ("version", text.replace('"rasterproof_vectors":1', '"rasterproof_vectors":2'),
             ("version 2 is unknown", "reads version 1")),
            ("empty", "", ("line 1",)),
            ("other", '{"rasterproof_scene": 1}\n', ("rasterproof_vectors",))):  # fmt: skip
            with self.subTest(name):
                self.refused(run("verify", self.write("bad.jsonl", damaged), good), *words)
        case = next(v for v in self.vectors["vulkan"][1] if "case" in v
                    and len(v["triangles"]) > 1)  # fmt: skip
        answer = {"case": case["case"], "triangle": 0, "rows": []}
        for changed, words in (
            ({"case": "near-edge:99999@7"}, ("line 2: case", "near-edge:99999@7")),
            ({"triangle": 99}, ("line 2: triangle",)),
            ({}, ("line 2: triangle", "answered twice")),
            ({"triangle": 1, "rows": ["0"] * 65}, ("below the target",)),
            ({"triangle": 1, "rows": ["f" * 40]}, ("beyond the target's last column",)),
            ({"triangle": 1, "rows": [3]}, ("rows[0]",)),
            ({"tirangle": 1}, ("tirangle",))):  # fmt: skip
            lines = [json.dumps(answer), json.dumps({**answer, **changed})]
            with self.subTest(str(changed)):
                self.refused(self.verify("vulkan", "\n".join(lines)), *words)
        self.refused(run("verify", path), "give a file of answers, or a subject")
        out = os.path.join(self.folder.name, "table")
        for form, tables in (("c", (out + ".h",)), ("readmemh", (out, out + "/vectors.svh"))):
            made = run("generate", "--profile", "d3d11-canonical", "--cases", "3", "--format", form,
                       "--out", tables[0])  # fmt: skip
            self.assertEqual(made.returncode, 0, made.stderr)
            for table in tables:
                with self.subTest(table):
                    self.refused(run("verify", table, good), "not in the", "--format jsonl")
        self.refused(run("verify", path, "--subject", "spans-exact-4x"), "subject")

    def test_profiles_without_single_samples_are_refused_before_anything_is_written(self):
        out = os.path.join(self.folder.name, "none.jsonl")
        for profile in ("vulkan-4x", "d3d12-conservative-3", "no-such"):
            self.refused(run("generate", "--profile", profile, "--out", out), profile)
        folder = run("generate", "--profile", "vulkan", "--format", "readmemh")
        self.refused(folder, "name a folder")
        self.refused(run("generate", "--profile", "vulkan", "--out", "/proc/x/y"), "/proc/x")
        self.assertFalse(os.path.exists(out))

    def test_samples_of_another_pattern_are_no_answers(self):
        path = os.path.join(self.folder.name, "4x.jsonl")
        done = run("generate", "--profile", "d3d11-4x", "--cases", "30", "--out", path)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.refused(run("verify", path, "--subject", "i64-snap8"), "sample locations")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
