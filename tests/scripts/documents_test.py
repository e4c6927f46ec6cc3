"""Tests of what keeps documents true: the list of decisions, the drawing of the layers, the
commands that a document shows, and the figures that it quotes."""

import importlib.machinery
import importlib.util
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


class DecisionsTest(unittest.TestCase):
    FIRST = "# 0001: Words\n\nDate: 2026-01-02. Status: {}.\n\nText.\n"
    SECOND = "# 0002: Other words\n\nDate: 2026-02-03. Status: accepted.\n\nText.\n"

    def run_check(self, files, *options):
        """Returns status and output of the check, and the list that is there afterwards."""
        with tempfile.TemporaryDirectory() as root:
            folder = pathlib.Path(root) / "docs/decisions"
            folder.mkdir(parents=True)
            for name, text in files.items():
                (folder / name).write_text(text, encoding="utf-8")
            command = [sys.executable, "-B", SCRIPTS / "check_decisions", *options, root]
            done = subprocess.run(command, capture_output=True, text=True, check=False)
            index = folder / "README.md"
            text = index.read_text(encoding="utf-8") if index.exists() else ""
            return done.returncode, done.stdout + done.stderr, text

    def expect_head(self, text, said):
        status, output, _ = self.run_check({"0001-words.md": text, "0002-other.md": self.SECOND})
        self.assertEqual(status, 1)
        self.assertIn(said, output)

    def test_the_list_is_written_and_kept(self):
        files = {"0001-words.md": self.FIRST.format("superseded in part by 0002"),
                 "0002-other.md": self.SECOND, "README.md": "# Decisions\n\nRead these.\n\n"
                 "| number | decision | date | status |\n| --- | --- | --- | --- |\n"}  # fmt: skip
        status, output, _ = self.run_check(files)
        self.assertEqual(status, 1)
        self.assertIn("the list is stale; run scripts/check_decisions --fix", output)
        status, output, index = self.run_check(files, "--fix")
        self.assertEqual(status, 0, output)
        self.assertTrue(index.startswith("# Decisions\n\nRead these.\n\n| number |"), index)
        self.assertIn("| [0001](0001-words.md) | Words | 2026-01-02 "
                      "| superseded in part by [0002](0002-other.md) |\n"
                      "| [0002](0002-other.md) | Other words |", index)  # fmt: skip
        self.assertEqual(self.run_check({**files, "README.md": index})[0], 0)

    def test_a_head_without_date_and_status_is_seen(self):
        self.expect_head("# 0001: Words\n\nText.\n", "0001-words.md:1: the head is not")
        self.expect_head(self.FIRST.format("rejected"), "0001-words.md:1: the head is not")

    def test_a_head_that_contradicts_its_file_or_the_others_is_seen(self):
        self.expect_head(self.SECOND, "the title says 0002, the file 0001")
        self.expect_head(self.FIRST.format("superseded by 0003"), "0003 is no later decision")
        self.expect_head(self.FIRST.format("superseded by 0001"), "0001 is no later decision")


class DrawingTest(unittest.TestCase):
    def setUp(self):
        self.script = load("draw_layers")
        self.layers = self.script.read_layers()

    def test_the_drawing_in_the_tree_is_the_one_of_the_table(self):
        there = self.script.DRAWING.read_text(encoding="utf-8")
        self.assertEqual(there, self.script.drawing(self.layers))

    def test_what_changes_in_the_table_changes_in_the_drawing(self):
        before = self.script.drawing(self.layers)
        for change in (lambda t: t.LAYERS["exact"].discard("model"),
                       lambda t: t.LAYERS["core"].add("tests"),
                       lambda t: t.ALSO.pop("subjects/builtin/")):  # fmt: skip
            table = self.script.read_layers()
            change(table)
            self.assertNotEqual(before, self.script.drawing(table))

    def test_every_text_stays_in_its_box_and_on_the_page(self):
        """By the width of DejaVu Sans' letters, half their size or more on the average."""
        letters = {15: 9.5, 13: 7.0, 12: 6.3}
        svg = self.script.drawing(self.layers)
        boxes = [tuple(map(int, box)) for box in re.findall(
            r'<rect x="(\d+)" y="(\d+)" width="(\d+)" height="(\d+)" rx', svg)]  # fmt: skip
        texts = re.findall(r'<text x="(\d+)" y="(\d+)" font-size="(15|13|12)"[^>]*>([^<]*)<', svg)
        self.assertEqual(len(boxes), len(self.layers.LAYERS))
        width, height = map(int, re.search(r'width="(\d+)" height="(\d+)"', svg).groups())
        for x, y, size, text in texts:
            x, y, end = int(x), int(y), int(x) + letters[int(size)] * len(text)
            self.assertLess(end, width, text)
            self.assertLess(y, height, text)
            for left, top, wide, high in boxes:
                if left < x < left + wide and top < y < top + high:
                    self.assertLess(end, left + wide, text)
                else:
                    self.assertFalse(top - 6 < y < top + high and x < left + wide and end > left,
                                     f"{text} runs into the box at {left}, {top}")  # fmt: skip

    def test_no_arrow_runs_behind_a_box(self):
        svg = self.script.drawing(self.layers)
        lines = re.findall(r'<line x1="([\d.]+)" y1="([\d.]+)" x2="([\d.]+)" y2="([\d.]+)"', svg)
        self.assertTrue(lines)
        for x0, y0, x1, y1 in (map(float, line) for line in lines):
            for name, (left, top, wide, _) in self.script.BOXES.items():
                for part in range(1, 100):
                    x, y = x0 + (x1 - x0) * part / 100, y0 + (y1 - y0) * part / 100
                    inside = left <= x <= left + wide and top < y < top + self.script.HEIGHT
                    self.assertFalse(inside, f"{x0, y0} to {x1, y1} runs behind {name}")

    def test_an_arrow_leaves_out_what_another_leads_to(self):
        layers = {"a": set(), "b": {"a"}, "c": {"a", "b"}, "d": {"a", "c"}}
        self.assertEqual(list(self.script.arrows(layers)), [("b", "a"), ("c", "b"), ("d", "c")])


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

    def test_a_quotation_stands_right_below_its_command(self):
        shell = "```sh\nbuild/a\n```\n"
        self.assertEqual(self.blocks(shell + "\n```text\nb\n```\n")[0]["printed"], "b\n")
        self.assertIsNone(self.blocks(shell + "\nSo.\n\n```text\nb\n```\n")[0]["printed"])

    def test_a_quotation_must_be_printed_in_its_order(self):
        printed = "one 1\ntwo 22 2\nthree 3\n"
        self.assertIsNone(self.script.missing_line("one 1\nthree 3\n", printed))
        self.assertIsNone(self.script.missing_line("one ...\n... 2\n", printed))
        self.assertEqual(self.script.missing_line("three 3\none 1\n", printed), "one 1")
        self.assertEqual(self.script.missing_line("one\n", printed), "one")

    def test_a_link_to_a_heading_that_is_not_there_is_dead(self):
        self.assertEqual(self.script.anchors("# A\n## I have a C++ type\n"),
                         {"a", "i-have-a-c-type"})  # fmt: skip
        links = "[a](run) [b](absent.md) [c](#a-b) [d](#c) [e](https://a.b/c)\n# A, b\n"
        self.assertEqual(list(self.script.dead_links("README.md", links)),
                         ["absent.md", "#a-b", "#c"])  # fmt: skip


class FiguresTest(unittest.TestCase):
    """Numbers and names in sentences are those of what the sentences are about."""

    NUMBERS = ("zero", "one", "two", "three", "four", "five", "six", "seven", "eight", "nine",
               "ten", "eleven", "twelve", "thirteen", "fourteen", "fifteen", "sixteen", "seventeen",
               "eighteen", "nineteen", "twenty")  # fmt: skip

    def one(self, pattern, path):
        """What the only place of a file that the pattern fits says."""
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

    def test_the_worst_cases_known_stand_beside_their_bounds(self):
        """0.9752 (f32-direct) in a header, where scenes/worst/README.md says so."""
        quoted = r"(\d\.\d{4})\s+\(([\w-]+)\)"
        headers = re.sub(r"\n\s*/// +", " ", read("reference/bounds.h"))
        headers += re.sub(r"\n\s*/// +", " ", read("reference/barycentrics.h"))
        said = sorted(re.findall(quoted, headers))
        rows = re.findall(r"^\| `([\w-]+)-[A-Z]\w+\.json` \| (\d\.\d{4}) \|",
                          read("scenes/worst/README.md"), re.M)  # fmt: skip
        self.assertEqual(said, sorted((ratio, method) for method, ratio in rows))

    def test_every_fuzz_target_is_in_the_table_and_no_other(self):
        targets = {p.name.removesuffix("_fuzzer.cc") for p in (ROOT / "fuzz").rglob("*_fuzzer.cc")}
        _, _, table = read("docs/fuzzing.md").partition("| target |")
        named = re.findall(r"`(\w+)`", "\n".join(
            row.split("|")[1] for row in table.split("\n\n")[0].splitlines()[2:]))  # fmt: skip
        self.assertEqual(sorted(named), sorted(targets))

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

    def test_the_decision_about_layers_has_the_table_that_is_checked(self):
        checked = load("check_layers")
        folders = set(checked.LAYERS)
        text = read("docs/decisions/0002-layers.md")
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
        suites = re.findall(r"^more_of \S+ '(\w+)\.\*'", read("scripts/test_more"), re.M)
        self.assertTrue(suites)
        for suite in suites:
            self.assertIn(f"({suite})", help_text)


if __name__ == "__main__":
    unittest.main()
