"""Tests of what keeps documents true: links, the commands that a document shows, and
the figures that it quotes."""

import importlib.machinery
import importlib.util
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCRIPTS = ROOT / "scripts"


def load(name):
    """The module of a script, whose file has no suffix."""
    sys.path.insert(0, str(SCRIPTS))
    loader = importlib.machinery.SourceFileLoader(name, str(SCRIPTS / name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    loader.exec_module(module)
    return module


def read(path):
    return (ROOT / path).read_text(encoding="utf-8")


class LinksTest(unittest.TestCase):
    def run_check(self, text):
        """Returns status and output of the check, of a page with a neighbour."""
        with tempfile.TemporaryDirectory() as root:
            folder = pathlib.Path(root) / "docs"
            folder.mkdir()
            (folder / "b.md").write_text("# A, `b`\n## I have a C++ type\n", encoding="utf-8")
            (folder / "a.md").write_text(text, encoding="utf-8")
            done = subprocess.run([sys.executable, "-B", SCRIPTS / "check_links", root],
                                  capture_output=True, text=True, check=False)  # fmt: skip
            return done.returncode, done.stdout

    def expect_dead(self, text, link):
        status, output = self.run_check(text)
        self.assertEqual(status, 1, output)
        self.assertIn(f"docs/a.md:2: the link to {link} is dead\n", output)

    def test_a_link_to_a_file_that_is_not_there_is_dead(self):
        self.expect_dead("# A\n[c](c.md)\n", "c.md")

    def test_a_link_to_a_heading_that_is_not_there_is_dead(self):
        self.expect_dead("# A\n[b](b.md#a--b)\n", "b.md#a--b")
        self.expect_dead("# A\n[d](#d)\n", "#d")

    def test_a_link_that_leads_somewhere_is_let_be(self):
        good = "[a](#a) [b](b.md#a-b) [c](b.md#i-have-a-c-type) [d](../docs) [e](https://e)\n# A"
        self.assertEqual(self.run_check(good)[0], 0)


class BenchTablesTest(unittest.TestCase):
    def setUp(self):
        self.script = load("bench_tables")
        claim = {"id": "doubles", "about": "Use doubles", "a": "d avx2", "b": "e avx2",
                 "differ_in": "arithmetic", "sink": "mask", "times": "2 [1.9, 2.1]",
                 "sentence": "Use doubles: so.",
                 "a_wrong": "never", "b_wrong": "never"}  # fmt: skip
        self.result = {"load_before": 0.1, "load_after": 1.1, "claims": [claim],
                       "rows": [{"target": "avx2"}, {"target": "compiler"}],
                       "methods": [{"target": "avx512"}]}  # of a curve; fmt: skip

    def test_a_run_on_a_busy_machine_is_not_quoted(self):
        self.assertEqual(self.script.busy(self.result), "")
        for load in ({"load_before": 0.31}, {"load_after": 1.31}, {"load_after": None}):
            self.assertIn("load", self.script.busy({**self.result, **load}))
        lines = self.script.sentences(["doubles"], [{**self.result, "load_before": 0.5}])
        self.assertIn("Not to be quoted", lines[-1])

    def test_the_first_run_speaks_and_others_stand_beside_it(self):
        wide = {**self.result, "rows": [{"target": "avx512"}]}
        self.assertEqual(self.script.sentences(["doubles"], [wide, self.result]),
                         ["- Use doubles: so. By avx2: 2 [1.9, 2.1]."])  # fmt: skip
        table = self.script.claims([wide, self.result])
        self.assertIn("| avx512 | avx2 |", table[0])
        self.assertEqual(len(table), 3)
        self.assertRaises(SystemExit, self.script.sentences, ["singles"], [wide])

    def test_a_method_of_values_is_told_by_its_extremes(self):
        rows = [{"method": "m", "family": family, "target": "avx2", "ns": ns, "ulps": ulps,
                 "share_of_bound": share}
                for family, ns, ulps, share in (
                    ("a", 2, 0.5, 0.25), ("b", 1, 2e9, "nan"))]  # fmt: skip
        result = {**self.result, "date": "today", "processor": "one", "value_rows": rows,
                  "value_families": [{"name": "a", "floor_ns": 0.5}]}  # fmt: skip
        self.assertEqual(self.script.values(result)[2:], [
            "| floor |  | 0.50 (`a`) | 0.50 (`a`) |  |  |",
            "| `m` | avx2 | 1.00 (`b`) | 2.00 (`a`) | 2.0e+09 (`b`) | 0.250 |", "",
            "today, one."])  # fmt: skip
        self.assertIn("Not to be quoted", self.script.values({**result, "load_before": 1})[-1])

    def test_a_plugin_stands_beside_the_exact_kernel_of_its_own_sink(self):
        def row(method, target, sink, seconds):
            return {"family": "a", "method": method, "target": target, "sink": sink,
                    "seconds": [seconds, 2 * seconds, 3 * seconds], "boundary_pairs": 9,
                    "real": {"beside_edges": 4}}  # fmt: skip

        methods = [{"name": "y.so", "users": True, "target": "its own"},
                   {"name": "kernel-exact", "users": False, "target": "avx2"}]  # fmt: skip
        result = {**self.result, "command": "bench --json x", "date": "today", "compiler": "c",
                  "processor": "one", "methods": methods,
                  "families": [{"name": "a", "triangles": 1000, "rounds": 6}],
                  "left_out": [{"family": "b", "method": "y.so"}],
                  "rows": [row("kernel-exact", "avx2", "mask", 1e-6),
                           row("kernel-exact", "scalar", "facing", 9e-6),
                           row("kernel-exact", "avx2", "facing", 2e-6),
                           row("y.so", "its own", "facing", 8e-6)]}  # fmt: skip
        lines = self.script.others(result)
        self.assertEqual(lines[2:5], [
            "| `a` | `y` | facing | 16.0 (8.0 to 24.0) | 4.0 (2.0 to 6.0) | 4.0 | 4 of 9 |", "",
            "Left out, because a draw is too long: b: y."])  # fmt: skip

    def test_a_record_whose_load_is_that_of_another_run_is_not_quoted(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "bench.json")
            path.write_text(json.dumps({**self.result, "command": "rasterproof bench"}))
            done = subprocess.run([ROOT / "scripts/bench_tables", "--growth", path],
                                  capture_output=True, text=True)  # fmt: skip
        self.assertEqual(done.returncode, 1)
        self.assertIn("give a record of `bench --growth` alone", done.stderr)

    def test_a_claim_by_hand_is_found(self):
        check = load("check_claims")
        block = ("<!-- claims a, made by scripts/bench_tables -->\nA takes 3 times as long.\n"
                 "<!-- claims a: to here -->\n")  # fmt: skip
        self.assertEqual(list(check.claims(block)), [])
        self.assertEqual(list(check.claims(block + "It took 3.5\ntimes as long as B.\n")),
                         [(4, "3.5 times")])  # fmt: skip
        self.assertEqual(list(check.claims("half: 0.4 of its time")), [(1, "4 of its time")])


class BenchModelTest(unittest.TestCase):
    """A machine of known costs: 0.2 ns an instruction, 3 a branch miss, 0.5 a row; tiles twice
    that; while family f3 was drawn it was half as fast."""

    COSTS = {"spans": (0.2, 3.0, 0.5), "tiles": (0.4, 6.0, 1.0)}
    METHODS = (("kernel-exact", "spans"), ("kernel-scanline", "spans"), ("spans-f64", "spans"),
               ("kernel-tiles", "tiles"), ("tiles-f64", "tiles"))  # fmt: skip

    def setUp(self):
        self.script = load("bench_model")
        self.cells = []
        for f in range(6):
            for m, (name, traversal) in enumerate(self.METHODS):
                terms = (100 + 13 * f * f + 9 * m, 1 + f * (1 + m % 2), 7 * f + m * m)
                time = sum(c * t for c, t in zip(self.COSTS[traversal], terms))
                time *= 2 if f == 3 else 1
                self.cells.append({"family": f"f{f}", "method": name, "traversal": traversal,
                                   "terms": terms, "time": time})  # fmt: skip

    def cell(self, family, method):
        return next(one for one in self.cells
                    if (one["family"], one["method"]) == (family, method))  # fmt: skip

    def test_the_costs_of_a_machine_and_its_paces_are_found_again(self):
        costs, paces = self.script.costs_and_paces(self.cells)
        for traversal, known in self.COSTS.items():
            for found, cost in zip(costs[traversal], known):
                self.assertAlmostEqual(found, cost, delta=0.05 * cost)
        for family, pace in paces.items():
            self.assertAlmostEqual(pace, 2 if family == "f3" else 1, delta=0.02)
        for cell in self.script.cross_validated(self.cells):
            self.assertAlmostEqual(cell["error"], 0, delta=0.02)

    def test_a_cost_below_zero_is_left_out(self):
        for cell in self.cells:
            cell["time"] = 0.2 * cell["terms"][0] - 0.1 * cell["terms"][1]
        self.assertGreaterEqual(min(self.script.fitted(self.cells)), 0)

    def test_what_takes_longer_than_its_terms_say_is_not_told(self):
        self.cell("f2", "kernel-exact")["time"] *= 1.5
        cells = self.script.cross_validated(self.cells)
        self.assertLess(self.cell("f2", "kernel-exact")["error"], -0.15)
        lines = "\n".join(self.script.report(cells))
        self.assertEqual(lines.count(": not told |"), 1)
        self.assertIn("29 of 30 cells are within 15%", lines)
        self.assertIn("not told by what is counted", lines)

    def test_a_family_is_not_predicted_by_itself(self):
        told = [cell["error"] for cell in self.script.cross_validated(self.cells)]
        self.assertLess(max(map(abs, told)), 0.02)
        for cell in self.cells:  # more of the family alone, in one term: no pace mends that
            if cell["family"] == "f5":
                cell["time"] += 30 * cell["terms"][2]
        self.script.cross_validated(self.cells)
        own = [abs(cell["error"]) for cell in self.cells if cell["family"] == "f5"]
        self.assertGreater(max(own), 0.05)

    def test_a_method_slower_by_a_fifth_is_found_by_its_instructions(self):
        counts = {"instructions": {"spans-f64": {"px5": 120.0}}}
        self.assertEqual(load("count_instructions").worse(counts, {"spans-f64": {"px5": 100.0}}),
                         {("spans-f64", "px5")})  # fmt: skip
        self.assertFalse(load("count_instructions").worse(counts, {"spans-f64": {"px5": 119.0}}))


class LinkOrdersTest(unittest.TestCase):
    def setUp(self):
        self.script = load("link_orders")

    def test_archives_change_places_and_nothing_is_lost(self):
        words = ["g++", "main.o", "-o", "rasterproof", "a.a", "b.a", "/x.a", "c.a", "d.a"]
        orders = [self.script.relinked(words, order, "out") for order in range(3)]
        archives = [[word for word in order if word.endswith(".a") and word != "/x.a"]
                    for order in orders]  # fmt: skip
        self.assertEqual(archives, [["a.a", "b.a", "c.a", "d.a"], ["d.a", "c.a", "b.a", "a.a"],
                                    ["c.a", "d.a", "a.a", "b.a"]])  # fmt: skip
        for order in orders:
            self.assertEqual(order[:4], ["g++", "main.o", "-o", "out"])
            self.assertEqual(order[-1], "/x.a")

    def test_two_orders_that_give_one_program_are_refused(self):
        with tempfile.TemporaryDirectory() as root:
            same, again, other = (pathlib.Path(root) / name for name in "abc")
            for path, text in ((same, "x"), (again, "x"), (other, "y")):
                path.write_text(text, encoding="utf-8")
            self.script.require_different([same, other])
            self.assertRaises(SystemExit, self.script.require_different, [same, other, again])

    def test_a_cell_that_moves_is_named(self):
        still = {("f", "a", "avx2", "mask"): (10, 1), ("f", "b", "avx2", "mask"): (20, 2)}
        moved = {**still, ("f", "b", "avx2", "mask"): (24, 2.4)}
        found = self.script.spreads([still, moved, still], 0)
        self.assertEqual([cell[1] for _, cell, _ in found], ["b", "a"])
        self.assertAlmostEqual(found[0][0], 1.2)
        lines = "\n".join(self.script.told([still, moved, still]))
        self.assertIn("1.200  f b avx2 mask: 20, 24, 20", lines)


class ShownCommandsTest(unittest.TestCase):
    def setUp(self):
        self.script = load("check_readme")

    def blocks(self, text):
        return list(self.script.BLOCK.finditer(text))

    def test_a_line_is_run_with_the_status_that_it_names(self):
        self.assertEqual(self.script.call_of("build/rasterproof list  # all"),
                         ("build/rasterproof list", 0))  # fmt: skip
        self.assertEqual(self.script.call_of("cc a.c   # status 1: no"), ("cc a.c", 1))
        self.assertIsNone(self.script.call_of("./run test"))
        self.assertEqual(self.script.run_line("true", 0), "")
        self.assertIsNone(self.script.run_line("true", 1))

    def test_a_block_is_a_file_where_the_line_above_names_one(self):
        block, = self.blocks("So.\n`build/try/a.json`:\n\n```json\n{}\n```\n")
        self.assertEqual((block["file"], block["text"]), ("build/try/a.json", "{}\n"))
        block, = self.blocks("See `build/try/a.json`.\n\n```json\n{}\n```\n")
        self.assertIsNone(block["file"])

    def test_a_quotation_comes_right_below_its_command(self):
        shell = "```sh\nbuild/a\n```\n"
        self.assertEqual(self.blocks(shell + "\n```text\nb\n```\n")[0]["printed"], "b\n")
        self.assertIsNone(self.blocks(shell + "\nSo.\n\n```text\nb\n```\n")[0]["printed"])

    def test_a_quotation_must_be_printed_in_its_order(self):
        printed = "one 1\ntwo 22 2\nthree 3\n"
        self.assertIsNone(self.script.missing_line("one 1\nthree 3\n", printed))
        self.assertIsNone(self.script.missing_line("one ...\n... 2\n", printed))
        self.assertEqual(self.script.missing_line("three 3\none 1\n", printed), "one 1")
        self.assertEqual(self.script.missing_line("one\n", printed), "one")


class TablesTest(unittest.TestCase):
    def setUp(self):
        self.script = load("tables.py")

    def write(self, text, name):
        with tempfile.TemporaryDirectory() as folder:
            document = pathlib.Path(folder) / "a.md"
            document.write_text(text, encoding="utf-8")
            rows = self.script.table(["of", "n"], [["a", "1"]], numbers=1)
            self.script.write(document, {name: rows})
            return document.read_text(encoding="utf-8")

    def test_a_table_is_written_between_its_comments(self):
        block = "<!-- {0}, made by scripts/s -->\n{1}<!-- {0}: to here -->\n"
        text = "A.\n" + block.format("x", "{}") + "B.\n" + block.format("y", "old\n") + "C.\n"
        self.assertEqual(self.write(text.format("old\n"), "x"),
                         text.format("| of | n |\n| --- | ---: |\n| a | 1 |\n"))  # fmt: skip

    def test_a_document_has_one_block_of_a_name(self):
        block = "<!-- x, made by scripts/s -->\n<!-- x: to here -->\n"
        for text, count in (("A.\n", 0), (block * 2, 2)):
            with self.assertRaisesRegex(SystemExit, f"it has {count} blocks named x; write"):
                self.write(text, "x")


class FiguresTest(unittest.TestCase):
    """Numbers and names in sentences are those of what the sentences are about."""

    NUMBERS = ("zero", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine",
               "ten", "eleven", "twelve", "thirteen", "fourteen", "fifteen", "sixteen", "seventeen",
               "eighteen", "nineteen", "twenty")  # fmt: skip

    def one(self, pattern, path):
        """Returns what the pattern captures at the only place of the file that it matches."""
        found = re.findall(pattern, read(path))
        self.assertEqual(len(found), 1, f"{pattern} in {path}")
        return found[0]

    def test_findings_are_counted_right(self):
        defects, libraries = self.one(r"has (\w+) such defects in\s+(\w+) libraries", "README.md")
        rows = re.findall(r"^\| \d+ \| ([\w+]+)", read("docs/findings.md"), re.M)
        self.assertEqual((defects, libraries),
                         (self.NUMBERS[len(rows)], self.NUMBERS[len(set(rows))]))  # fmt: skip

    def test_an_example_has_as_many_lines_as_a_document_says(self):
        quoted = re.compile(r"\[[\w.]+\]\(([\w./]+)\),\s+(?:is )?(\d+)\s+lines")
        seen = set()
        for document in ("README.md", "docs/subjects.md", "docs/library.md"):
            for path, lines in quoted.findall(read(document)):
                file = (ROOT / document).parent / path
                self.assertEqual(int(lines), len(file.read_text(encoding="utf-8").splitlines()),
                                 f"{document}: {path}")  # fmt: skip
                seen.add(file.name)
        self.assertEqual(seen, {"plugin.c", "program.py", "console.c", "own_type.cc"})

    def test_the_worst_cases_known_are_quoted_beside_their_bounds(self):
        """0.9752 (f32-direct) in a header, where scenes/worst/README.md says so. The error of a
        legal variant is what it states itself."""
        quoted = r"(\d\.\d{4})\s+\(([\w-]+)\)"
        headers = re.sub(r"\n\s*/// +", " ", read("reference/bounds.h"))
        headers += re.sub(r"\n\s*/// +", " ", read("reference/barycentrics.h"))
        said = sorted(re.findall(quoted, headers))
        rows = re.findall(r"^\| `(?!legal-)([\w-]+)-[A-Z]\w+\.json` \| (\d\.\d{4}) \|",
                          read("scenes/worst/README.md"), re.M)  # fmt: skip
        self.assertEqual(said, sorted((ratio, method) for method, ratio in rows))

    def test_every_fuzz_target_is_in_the_table_and_no_other(self):
        targets = {p.name.removesuffix("_fuzzer.cc") for p in (ROOT / "fuzz").rglob("*_fuzzer.cc")}
        _, _, table = read("docs/fuzzing.md").partition("| target |")
        named = re.findall(r"`(\w+)`", "\n".join(
            row.split("|")[1] for row in table.split("\n\n")[0].splitlines()[2:]))  # fmt: skip
        self.assertEqual(sorted(named), sorted(targets))

    def test_every_test_is_run(self):
        nightly = read("scripts/test_more") + read("scripts/build_web")
        for path in sorted((ROOT / "tests").rglob("*_test.*")):
            if path.suffix not in (".cc", ".py"):
                continue
            lists = path.parent / "CMakeLists.txt"
            name = path.stem if path.parent.name == "scripts" else path.name
            said = lists.read_text(encoding="utf-8") + nightly
            globs = re.findall(r"file\(GLOB [^)]*?(\*\w*_test\.\w+)", said)
            if any(path.match(pattern) for pattern in globs):
                continue
            self.assertTrue(re.search(rf"\b{re.escape(name)}\b", said),
                            f"nothing runs {path.relative_to(ROOT)}: name it in "
                            f"{lists.relative_to(ROOT)}, in a rasterproof_test or an "
                            "add_test")  # fmt: skip

    def test_limits_are_those_of_the_code(self):
        header = read("props/judging/as_shown.h")
        triangles = re.search(r"kMostCallsByTriangle = (\d+);", header)[1]
        samples = re.search(r"kMostSamplesByTriangle = std::uint64_t\{1\} << (\d+);", header)[1]
        self.assertEqual(self.one(r"more than ([\d,]+) triangles, or of more than 2\^(\d+) "
                                  r"triangles times samples", "docs/subjects.md"),
                         (f"{int(triangles):,}", samples))  # fmt: skip
        lines = load("check_text").MAX_LINES
        function = re.search(r"function-size\.LineThreshold: (\d+)", read(".clang-tidy"))[1]
        self.assertEqual(self.one(r"has (\d+) at most\s+\(`scripts/check_text`\); a function aims "
                                  r"at 8 and has (\d+) at most", "CONTRIBUTING.md"),
                         (str(lines), function))  # fmt: skip

    def test_the_page_of_formats_has_every_key_of_the_readers(self):
        page = read("docs/scene-format.md")
        for path, name in (("scene_file", "kKeys"), ("case_file", "kCaseKeys"),
                           ("case_file", "kOptionKeys"), ("case_file", "kDrawnKeys"),
                           ("case_file", "kDrawingMembers"),
                           ("scene_set", "kSetKeys"), ("scene_set", "kEntryKeys")):  # fmt: skip
            keys = re.search(rf"{name}\{{([^}}]*)\}}", read(f"io/{path}.cc"))[1]
            for key in re.findall(r'"(\w+)"', keys):
                self.assertRegex(page, rf'[`"]{key}[`"]', f"{key} of io/{path}.cc")

    def test_how_it_works_has_the_table_of_layers_that_is_checked(self):
        checked = load("check_layers")
        folders = set(checked.LAYERS)
        text = read("docs/how-it-works.md")
        rows = re.findall(r"^\| `(\w+)/` \| (.*?) \|", text, re.M)
        self.assertEqual({row[0] for row in rows}, folders - {"tests"})
        for folder, sees in rows:
            with self.subTest(folder=folder):
                before = sees.partition(";")[0].strip()
                named = set(re.findall(r"\b\w+\b", re.sub(r"`.*?`", "", before))) & folders
                if before.startswith("all but"):
                    named = folders - named - {folder, "tests"}
                self.assertEqual(named, set(checked.LAYERS[folder]) - {folder})
        order = re.search(r"`(core < .*?)`", text)[1]
        self.assertEqual(set(re.findall(r"\w+", order)), folders - {"tests"})
        rank = {name: level for level, names in enumerate(order.split(" < "))
                for name in re.findall(r"\w+", names)}  # fmt: skip
        for folder, sees in checked.LAYERS.items():
            for other in sees if folder != "tests" else ():
                self.assertLess(rank[other], rank[folder], f"{folder} sees {other}")

    def test_the_help_names_the_suites_that_get_more_cases(self):
        help_text = read("run").partition("<<'HELP'")[2].partition("\nHELP")[0]
        suites = re.findall(r"^more_of build/\S+ '(\w+)\.\*'", read("scripts/test_more"), re.M)
        self.assertTrue(suites)
        for suite in suites:
            self.assertIn(f"({suite})", help_text)


if __name__ == "__main__":
    unittest.main()
