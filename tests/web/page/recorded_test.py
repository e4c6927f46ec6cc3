#!/usr/bin/env python3
"""Certificates of two rasterizers, recorded from the page in Firefox on llvmpipe and in Chromium on
SwiftShader: the command judges them again, and the page compares them.

usage: recorded_test.py SOURCE_FOLDER CHROMIUM COMMAND
"""

import gzip
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from page_driver import SOURCES, Page

COMMAND = os.path.abspath(sys.argv[3])
ONCE = "EmbeddedMeshSamplesAreCoveredOnce"
AGAIN = ("\nWhere the cases of a seed have changed: RECORD=tests/web/data scripts/build_web, with "
         "firefox-esr and xvfb, records them again.")  # fmt: skip


def recorded(name):
    path = SOURCES / "tests" / "web" / "data" / f"{name}.json.gz"
    return gzip.decompress(path.read_bytes()).decode()


class Recorded(unittest.TestCase):
    def judged(self, text):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "passport.json")
            path.write_text(text, encoding="utf-8")
            return subprocess.run([COMMAND, "certify", path], capture_output=True, text=True,
                                  check=False)  # fmt: skip

    def test_the_command_derives_both_verdicts(self):
        for name, status in (("llvmpipe", 1), ("swiftshader", 0)):
            done = self.judged(recorded(name))
            self.assertEqual(done.returncode, status, done.stdout + done.stderr + AGAIN)
        lost = json.loads(recorded("llvmpipe"))
        lost["outcome"] = "holds"
        self.assertEqual(self.judged(json.dumps(lost)).returncode, 2)

    def test_a_drawer_that_lost_triangles_while_it_proved_itself_does_not_hold(self):
        lossy = json.loads(recorded("swiftshader"))
        counting = next(one for one in lossy["proof"]["checks"] if one["name"] == "counting")
        counting["lost"] = 4
        self.assertEqual(self.judged(json.dumps(lossy)).returncode, 2)  # it says that it holds
        lossy["outcome"] = "inconclusive"
        done = self.judged(json.dumps(lossy))
        self.assertEqual(done.returncode, 4, done.stderr)
        self.assertIn("4 triangles were lost", done.stdout)
        counting["lost"] = "four"
        self.assertEqual(self.judged(json.dumps(lossy)).returncode, 2)

    def test_the_triangle_that_is_lost_is_that_with_far_negative_corners(self):
        (failure,) = json.loads(recorded("llvmpipe"))["result"]["subjects"][0]["failures"]
        self.assertEqual((failure["property"], failure["actual"]), (ONCE, "covered 0 times"))
        corners = [[float.fromhex(x) for x in v] for v in failure["case"]["scene"]["vertices"]]
        self.assertLessEqual(min(min(corner) for corner in corners), -2048)
        self.assertEqual([id["id"] for id in failure["clauses"]],
                         ["gl.common-edge", "gl.point-sampling"])  # fmt: skip

    def test_the_page_says_where_they_differ_and_what_leaves_it_open(self):
        page = Page()
        self.addCleanup(page.close)
        for which, name in (("first", "swiftshader"), ("second", "llvmpipe")):
            page.value(f"""rasterproof.compareFile("{which}",
                new File([{json.dumps(recorded(name))}], "{name}.json"))""")
        rows = page.value("""Object.fromEntries(Array.from(
            document.querySelectorAll("#compare-rows tr"),
            (row) => Array.from(row.children, (cell) => cell.textContent))
            .map(([what, ...more]) => [what, more]))""")
        bits = rows["subpixel bits, viewport 2048"]
        self.assertEqual(bits[:2], ["4", "8"])
        self.assertIn("left open by gl.subpixel-bits, table 23.53", bits[2])
        self.assertEqual(rows[ONCE][:2], ["holds", "violated"])
        self.assertIn("broken: gl.common-edge, 14.6.1: Of two polygons", rows[ONCE][2])
        self.assertEqual(rows["draws that both were asked"][:2],
                         ["1792 draws", "274 come out otherwise"])  # fmt: skip
        said = page.text("compare-said")
        self.assertRegex(said, "First .*SwiftShader.* is legal, as far as it was asked")
        self.assertRegex(said, f"Second .*llvmpipe.* is not legal: it breaks {ONCE}")
        lossy = json.loads(recorded("swiftshader"))
        lossy |= {"outcome": "inconclusive", "reason": "4 triangles were lost"}
        page.value(f"""rasterproof.compareFile("first",
            new File([{json.dumps(json.dumps(lossy))}], "lossy.json"))""")
        self.assertIn("breaks nothing that it was asked, and yet: 4 triangles were lost.",
                      page.text("compare-said"))  # fmt: skip


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
