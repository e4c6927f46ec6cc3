"""Tests of what keeps documents true: the list of decisions, the drawing of the layers, and the
commands that a document shows."""

import importlib.machinery
import importlib.util
import pathlib
import subprocess
import sys
import tempfile
import unittest

SCRIPTS = pathlib.Path(__file__).resolve().parents[2] / "scripts"


def load(name):
    """The module of a script, whose file has no suffix."""
    sys.path.insert(0, str(SCRIPTS))
    loader = importlib.machinery.SourceFileLoader(name, str(SCRIPTS / name))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(name, loader))
    loader.exec_module(module)
    return module


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


if __name__ == "__main__":
    unittest.main()
