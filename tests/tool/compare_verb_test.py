"""compare: a table of families, saved cases that fail again, its exit status.

usage: compare_verb_test.py PROGRAM SOURCES
"""
import glob
import html
import json
import os
import re
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCES = (os.path.abspath(path) for path in sys.argv[1:3])


FEW = ("--families", "needles,near-edge,grids,snap-ties,degenerate,mixed-w")


def run(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, cwd=SOURCES,
                          timeout=900, check=False)  # fmt: skip


def compare(*arguments):
    return run("compare", "--cases", "20", *FEW, *arguments)


class Compare(unittest.TestCase):
    def test_an_exact_subject_fails_no_family_of_its_model(self):
        done = compare("--subject", "i64-snap8")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        last = done.stdout.splitlines()[-1]
        self.assertRegex(last, r"^i64-snap8: own model: \d+ families stand, 0 fail, ")
        self.assertNotRegex(last, r"real geometry: \d+ families stand, 0 fail")

    def test_what_fails_is_saved_and_fails_again(self):
        with tempfile.TemporaryDirectory() as folder:
            done = compare("--subject", "textbook", "--save", folder)
            self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
            self.assertRegex(done.stdout, r"\n  needles +fails \d+ of 20, ")
            saved = sorted(glob.glob(os.path.join(folder, "*.json")))
            self.assertGreater(len(saved), 3)
            for path in saved[:6]:
                again = run("replay", path)
                self.assertEqual(again.returncode, 1, path + again.stdout + again.stderr)

    def test_what_it_cannot_be_combined_with_is_refused(self):
        done = compare("--mode", "ftz")
        self.assertEqual(done.returncode, 2)
        self.assertIn("Cases by yardsticks] excludes --mode", done.stderr)

    def test_scenes_stand_beside_families(self):
        done = compare("scenes/ties.json", "--subject", "spans-exact")
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertRegex(done.stdout, r"\n  needles .*\n(.*\n)*  scenes/ties.json +")

    def test_check_says_where_its_options_are(self):
        for word, now in (("--catalogue", "compare"), ("--fp-env=ftz", "compare --mode ftz"),
                          ("--family", "compare --families NAME")):  # fmt: skip
            done = run("check", word)
            self.assertEqual(done.returncode, 2, word)
            self.assertIn(f"write rasterproof {now}\n", done.stderr)

    def test_another_subject_is_a_yardstick_and_a_scene_a_row(self):
        same = run("compare", "scenes/ties.json", "--subject", "textbook", "--by", "textbook")
        self.assertEqual(same.returncode, 0, same.stdout + same.stderr)
        self.assertIn("1 scenes stand, 0 fail", same.stdout)
        other = run("compare", "scenes/ties.json", "--subject", "textbook",
                    "--by", "spans-exact,own", "--json", "-")  # fmt: skip
        self.assertEqual(other.returncode, 1, other.stdout + other.stderr)
        read = json.loads(other.stdout)
        self.assertEqual([row["name"] for row in read["scenes"]], ["scenes/ties.json"])
        (cell,) = read["subjects"][0]["cells"]
        self.assertEqual(cell["scene"], "scenes/ties.json")
        for yardstick in ("spans-exact", "own_model"):
            self.assertEqual((cell[yardstick]["state"], cell[yardstick]["cases"]), ("fails", 1))

    def test_a_family_that_is_none_is_refused_with_the_one_that_may_be_meant(self):
        done = compare("--families", "neddles")
        self.assertEqual(done.returncode, 2)
        self.assertIn("did you mean needles?", done.stderr)

    def test_a_subject_of_squares_is_refused_with_the_reason(self):
        done = compare("--subject", "spans-exact", "--profile", "vulkan-overestimate")
        self.assertEqual(done.returncode, 2)
        self.assertIn("whole pixels", done.stderr)

    def test_certify_writes_the_matrix_and_a_page_a_family(self):
        with tempfile.TemporaryDirectory() as folder:
            done = subprocess.run(
                [PROGRAM, "certify", "--catalogue", "--subject", "spans-exact", "--subject",
                 "f32-direct", "--subject", "i64-snap8", "--cases", "10",
                 "--scenes", "scenes/quick.json", "--out", folder],
                capture_output=True, text=True, cwd=SOURCES, timeout=900, check=False)  # fmt: skip
            self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
            with open(os.path.join(folder, "catalogue.json")) as file:
                catalogue = json.load(file)
            of = {column["subject"]: {cell["family"]: cell for cell in column["cells"]}
                  for column in catalogue["subjects"]}  # fmt: skip
            self.assertEqual(of["spans-exact"]["needles"]["own_model"]["state"], "proved")
            self.assertEqual(of["f32-direct"]["long-targets"]["own_model"]["state"], "exhausted")
            self.assertEqual(of["f32-direct"]["mixed-w"]["own_model"]["state"], "excused")
            needles = of["f32-direct"]["needles"]["real_geometry"]
            self.assertEqual((needles["state"], needles["cases"]), ("fails", 10))
            # Proofs are of a subject's own model; one without any is never more than tested.
            snapped = of["i64-snap8"]["grids"]
            self.assertEqual(snapped["own_model"]["state"], "proved")
            self.assertEqual(snapped["real_geometry"]["state"], "tested")
            for cells in of["f32-direct"].values():
                for yardstick in ("own_model", "real_geometry"):
                    self.assertNotEqual(cells[yardstick]["state"], "proved")
            # No family of an exact subject fails, and what isn't measured says why.
            for cells in of["spans-exact"].values():
                self.assertNotEqual(cells["own_model"]["state"], "fails")
                self.assertTrue(cells["own_model"]["cases"] or cells["own_model"]["why"])
            pages = os.listdir(os.path.join(folder, "families"))
            self.assertEqual({page for page in pages if page.endswith(".html")},
                             {f"{family['name']}.html" for family in catalogue["families"]})
            with open(os.path.join(folder, "families", "needles.html")) as file:
                page = file.read()
            self.assertIn('src="../families/needles.svg"', page)
            self.assertIn("needles.svg", pages)
            # The command beside the subject saves the case that the cell speaks of.
            command = re.search(r"<code>(.*--subject</span> <span>f32-direct.*)</code>", page)[1]
            words = html.unescape(re.sub("<[^>]*>", "", command)).split()[1:]
            saved = subprocess.run([PROGRAM, *words], capture_output=True, text=True, cwd=folder,
                                   timeout=900, check=False)  # fmt: skip
            self.assertEqual(saved.returncode, 1, saved.stdout + saved.stderr)
            with open(os.path.join(folder, "worst", "f32-direct-needles-real.json")) as file:
                self.assertIn(needles["worst_case"], file.read())
            with open(os.path.join(folder, "report.html")) as file:
                self.assertIn('href="families/needles.html"', file.read())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
