#!/usr/bin/env python3
"""The playground of passport.html: corners moved by mouse, finger and keys, numbers at a pixel,
undo, links, cases.

usage: playground_test.py SOURCE_FOLDER CHROMIUM
PICTURES in the environment: a folder for pictures at three widths.
"""

import json
import os
import sys
import unittest

from page_driver import CONTROL, SHIFT, SOURCES, Page

TRIANGLE = [[1.75, 8.25], [7.25, 1.25], [12.5, 7]]
SHARED, FAN, SLIVER = 1, 2, 3
ULP = 2**-20  # of numbers in [8, 16)
FINDING = SOURCES / "docs" / "findings" / "cairo_hole_filled.json"
REPLAY = """replay: rasterproof replay --subject textbook --property ClosedMeshCancels
'{"rasterproof_scene": 1, "name": "fans", "width": 2, "height": 1, "precision": "float32",
"vertices": [["0x0p+0", "-0x0p+0"], ["0x1.8p+0", "0x1p+1"], ["0x1p+1", 0.1]],
"triangles": [[2, 0, 1]]}'"""
# A text that is no case, and what is said of it: the place and what is wrong there.
BAD = {
    "no brace": "The text has no {",
    '{"rasterproof_case": 2, "scene": {]}': "The text is no JSON: ",
    '{"rasterproof_case": 1}': "rasterproof_case is 1",
    '{"a": 1}': 'neither "rasterproof_case": 2 nor',
    '{"rasterproof_scene": 1, "width": 0, "height": 1}': "scene.width is 0",
    '{"rasterproof_scene": 1, "width": 1, "height": 1}': "scene.vertices is missing",
    '{"rasterproof_scene": 1, "width": 1, "height": 1, "vertices": [[0, 1], [2]]}':
        "scene.vertices[1] has 1 coordinates",
    '{"rasterproof_scene": 1, "width": 1, "height": 1, "vertices": [[0, "0x1.00000001p+0"]]}':
        "scene.vertices[0][1] is 0x1.00000001p+0, which float32 does not hold",
    '{"rasterproof_scene": 1, "width": 1, "height": 1, "vertices": [[0, "1,5"]]}':
        'scene.vertices[0][1] is "1,5"',
    '{"rasterproof_scene": 1, "width": 1, "height": 1, "vertices": [[0, 0], [0, 0, 0, 1]]}':
        "scene.vertices[0] has no w, but scene.vertices[1] has",
    '{"rasterproof_scene": 1, "width": 1, "height": 1, "vertices": [[0, 0]], '
    '"triangles": [[0, 0, 1]]}': "scene.triangles[0][2] is 1",
}  # fmt: skip


class Playground(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.page = Page()

    @classmethod
    def tearDownClass(cls):
        cls.page.close()

    def setUp(self):
        self.page.value('location.hash = ""')
        self.page.open()
        self.page.value("rasterproof.playing.then(() => true)")
        self.page.value('document.getElementById("playground").scrollIntoView()')

    def found(self):
        return self.page.value("rasterproof.playing.then((play) => play.settled())")

    def choose(self, name, value):
        self.page.value(f"""{{
          const select = document.getElementById("play-{name}");
          select.value = "{value}";
          select.dispatchEvent(new Event("change"));
        }}""")

    def click(self, name):
        self.page.value(f'document.getElementById("play-{name}").click()')

    def vertices(self):
        return self.found()["play"]["vertices"]

    def on_screen(self, x, y):
        """Where a point of the target is on the screen, in the picture on the left."""
        self.found()
        return self.page.value(f"""(() => {{
          const board = document.querySelector("#play-boards svg");
          const point = new DOMPoint({x}, {y}).matrixTransform(board.getScreenCTM());
          return [point.x, point.y];
        }})()""")

    def look_at(self, x, y):
        self.page.mouse("mouseMoved", *self.on_screen(x + 0.5, y + 0.5))
        return self.found()

    def drag(self, start, *ends):
        self.page.mouse("mousePressed", *self.on_screen(*start))
        for end in ends:
            self.page.mouse("mouseMoved", *self.on_screen(*end))
        self.page.mouse("mouseReleased", *self.on_screen(*ends[-1]))

    def focus(self, vertex):
        self.found()
        corner = f'[data-vertex="{vertex}"]'
        self.page.value(f"document.querySelector('#play-boards {corner}').focus()")

    def text(self, name):
        return self.page.text("play-" + name)

    def test_the_numbers_at_a_pixel_are_exact(self):
        found = self.look_at(7, 5)
        self.assertEqual(found["cursor"], [7, 5])
        (row,) = found["rows"]
        self.assertEqual(row["edges_exact"], ["-167/8", "-179/8", "-201/8"])
        self.assertEqual(row["barycentrics_exact"], ["167/547", "179/547", "201/547"])
        self.assertEqual(row["drawn"], [-20.875, -22.375, -25.125])
        for text in ("Triangle 0", "edge 1 to 2", "-167/8 = -20.875", "201/547 ≈ 0.367459"):
            self.assertIn(text, self.text("numbers"))
        self.assertEqual(self.text("said"),
                         "Pixel (7, 5), centre (7.5, 5.5): drawn once, by triangle 0.")
        self.look_at(0, 0)
        self.assertEqual(self.text("said"), "Pixel (0, 0), centre (0.5, 0.5): not drawn.")
        self.choose("preset", SLIVER)
        (row,) = self.look_at(3, 3)["rows"]
        self.assertEqual(row["edges_exact"], ["-5/1048576", "-3145729/8796093022208", "-5/8388608"])
        self.assertEqual(row["drawn"][1:], [0, 0])
        self.assertEqual(self.text("numbers").count("(other sign)"), 2)

    def test_ties_are_marked_and_each_is_drawn_once(self):
        self.choose("preset", SHARED)
        found = self.found()
        # 9 x 9 centres: a border of 32 and, of the diagonal, seven more.
        self.assertEqual(len(found["ties"]), 39)
        exact, drawn = found["exact"], found["drawn"]
        self.assertEqual([exact[12 * k + k] for k in range(1, 9)], [1] * 8)
        self.assertEqual([drawn[12 * k + k] for k in range(1, 10)], [2] * 9)
        self.look_at(4, 4)
        self.assertIn("Its centre lies on an edge: a tie. By textbook: drawn 2 times, unexpected.",
                      self.text("said"))
        self.assertEqual(self.page.value('document.querySelector("figure + figure").textContent')
                         .split(":")[1].split("2")[0].strip(), "0 missing,")  # fmt: skip
        self.choose("preset", FAN)
        found = self.found()
        self.assertEqual((found["exact"][5 * 13 + 6], found["drawn"][5 * 13 + 6]), (1, 8))

    def test_a_corner_is_dragged_and_undone(self):
        self.drag((7.25, 1.25), (5, 3), (9.126, 0.877))
        grid = [[1.75, 8.25], [2336 / 256, 225 / 256], [12.5, 7]]
        self.assertEqual(len(self.vertices()), 3)
        for axis in (0, 1):  # a pixel of the screen is some steps
            self.assertAlmostEqual(self.vertices()[1][axis], grid[1][axis], delta=0.03)
            self.assertEqual(self.vertices()[1][axis] * 256 % 1, 0)
        moved = self.vertices()
        self.page.press("z", CONTROL)
        self.assertEqual(self.vertices(), TRIANGLE)  # the whole drag at once
        self.page.press("z", CONTROL | SHIFT)
        self.assertEqual(self.vertices(), moved)
        self.click("undo")
        self.assertEqual(self.vertices(), TRIANGLE)
        disabled = 'document.getElementById("play-{}").disabled'
        self.assertTrue(self.page.value(disabled.format("undo")))
        self.assertFalse(self.page.value(disabled.format("redo")))
        self.choose("step", "ulp")
        self.drag((7.25, 1.25), (9.126, 0.877))
        self.assertNotEqual(self.vertices()[1][0] * 256 % 1, 0)

    def test_a_finger_drags(self):
        self.page.touch("touchStart", self.on_screen(12.5, 7))
        self.page.touch("touchMove", self.on_screen(11, 6))
        self.page.touch("touchMove", self.on_screen(10, 4))
        self.page.touch("touchEnd")
        x, y = self.vertices()[2]
        self.assertAlmostEqual(x, 10, delta=0.05)
        self.assertAlmostEqual(y, 4, delta=0.05)

    def test_keys_alone(self):
        self.page.value('document.getElementById("play-save").focus()')
        self.page.browser.press("Tab")
        active = "document.activeElement"
        self.assertEqual(self.page.value(active + '.getAttribute("role")'), "application")
        before = self.found()["cursor"]
        self.page.press("ArrowLeft")
        self.page.press("ArrowUp", SHIFT)
        self.assertEqual(self.found()["cursor"], [before[0] - 1, 0])
        self.page.browser.press("Tab")
        self.assertEqual(self.page.value(active + '.getAttribute("aria-label")'),
                         "Corner 0 at 1.75, 8.25")
        self.page.press("ArrowRight")
        self.page.press("ArrowUp", SHIFT)
        self.assertEqual(self.vertices()[0], [1.75 + 1 / 256, 8.25 - 1 / 16])
        self.assertEqual(self.text("moved"), "Corner 0 at 1.75390625, 8.1875")
        self.choose("step", "ulp")
        self.page.press("ArrowDown")
        self.page.press("ArrowDown", SHIFT)
        self.assertEqual(self.vertices()[0][1], 8.1875 + 17 * ULP)
        self.assertEqual(self.page.browser.faults(), [])

    def test_an_ulp_passes_zero(self):
        scene = {"rasterproof_scene": 1, "width": 4, "height": 4, "precision": "float32",
                 "vertices": [[0, "-0x0p+0"], [3, 0], [0, 3]],
                 "triangles": [[0, 1, 2]]}  # fmt: skip
        self.open(json.dumps(scene))
        self.choose("step", "ulp")
        self.focus(0)
        self.page.press("ArrowLeft")
        self.page.press("ArrowDown")
        self.page.press("ArrowDown")
        self.assertEqual(self.vertices()[0], [-(2**-149), 2**-148])

    def open(self, text):
        self.page.value(f'document.getElementById("play-text").value = {json.dumps(text)}')
        self.click("open")

    def test_cases_and_replay_lines_open(self):
        self.open(FINDING.read_text(encoding="utf-8"))
        play = self.found()["play"]
        self.assertEqual((play["name"], play["width"]), ("cairo hole filled", 16))
        self.assertEqual(play["vertices"][0], [3, -4])
        self.assertIn("no built-in method", self.text("about"))
        self.open(REPLAY)
        play = self.found()["play"]
        self.assertEqual(play["vertices"], [[0, 0], [1.5, 2], [2, 0.10000000149011612]])
        self.assertEqual(self.text("fault"), "")

    def test_what_is_no_case_is_said_with_its_place(self):
        for text, said in BAD.items():
            with self.subTest(text):
                self.open(text)
                self.assertIn(said, self.text("fault"))
                self.assertEqual(self.vertices(), TRIANGLE)
        self.open(FINDING.read_text(encoding="utf-8"))
        self.found()
        self.assertEqual(self.text("fault"), "")

    def test_corners_are_typed(self):
        script = """{{
          const input = document.querySelector("#play-corners input");
          input.value = "{}";
          input.dispatchEvent(new Event("change"));
        }}"""
        self.page.value(script.format("0x1.8p+1"))
        self.assertEqual(self.vertices()[0], [3, 8.25])
        self.page.value(script.format("three"))
        self.assertIn('Corner 0, x, is "three"', self.text("fault"))
        self.assertEqual(self.vertices()[0], [3, 8.25])

    def test_a_link_holds_the_scene_and_a_damaged_one_says_so(self):
        self.choose("preset", FAN)
        self.focus(3)
        self.page.press("ArrowRight")
        before = self.found()["play"]
        self.click("link")
        link = self.page.value("location.hash")
        for again in ("open", "hash"):
            self.choose("preset", SLIVER)
            if again == "open":
                self.page.browser.open("about:blank", 1280)
                self.page.browser.open(self.page.url + link, 1280)
                self.page.value("rasterproof.playing.then(() => true)")
            else:
                self.page.value(f"""new Promise((resolve) => {{
                  addEventListener("hashchange", resolve, {{once: true}});
                  location.hash = "";
                }}).then(() => true)""")
                self.follow(link)
            self.assertEqual(self.found()["play"], before)
        letter = "B" if link[40] != "B" else "C"
        for damaged in (link[:-2], link[:40] + letter + link[41:], "#scene=", link + "*"):
            self.follow(damaged)
            self.assertIn("The link is damaged", self.text("fault"))
            self.assertEqual(self.found()["play"], before)

    def follow(self, link):
        self.page.value(f"""new Promise((resolve) => {{
          addEventListener("hashchange", resolve, {{once: true}});
          location.hash = "{link}";
        }}).then(() => true)""")

    def test_without_the_engine_there_is_a_message_and_no_button(self):
        said = self.page.value("""(async () => {
          document.getElementById("play-all").hidden = true;
          const {playground} = rasterproof.modules();
          const none = {create: async () => { throw new Error("no WebAssembly"); }};
          const made = await playground.playground(none, []);
          return [made, document.getElementById("play-missing").textContent];
        })()""")
        self.assertIsNone(said[0])
        self.assertIn("no WebAssembly", said[1])
        self.assertEqual(self.page.value("""Array.from(
            document.querySelectorAll("#playground button"), (one) => one.checkVisibility())
            .includes(true)"""), False)  # fmt: skip

    def test_every_preset_is_drawn(self):
        count = self.page.value("PRESETS.length")
        self.assertGreater(count, 25)
        for k in range(count):
            self.choose("preset", k)
            found = self.found()
            self.assertEqual(self.text("fault"), "")
            play = found["play"]
            self.assertEqual(len(found["exact"]), play["width"] * play["height"])
        self.assertEqual(self.page.browser.faults(), [])

    def test_parts_have_names_and_fit_three_widths(self):
        folder = os.environ.get("PICTURES")
        for width in (1280, 800, 390):
            for dark in (False, True):
                self.page.open(width, dark=dark)
                self.page.value("rasterproof.playing.then(() => true)")
                self.choose("preset", FAN if dark else SHARED)
                self.found()
                self.assertLessEqual(
                    self.page.value("document.documentElement.scrollWidth"), width)  # fmt: skip
                if folder:
                    self.page.picture(folder, f"play-{width}-{'dark' if dark else 'light'}.png")
        self.page.value("""document.querySelectorAll("#playground details").forEach(
            (details) => { details.open = true; })""")
        nodes = self.page.browser.call("Accessibility.getFullAXTree")["nodes"]
        roles = {"button", "combobox", "textbox", "img", "image", "application", "region"}
        names = [(node["role"]["value"], node["name"]["value"]) for node in nodes
                 if not node["ignored"] and node["role"]["value"] in roles]  # fmt: skip
        self.assertEqual([name for name in names if not name[1]], [])
        for name in ("Corner 8 at 10.5, 2.5", "Corner 8, y"):
            self.assertIn(name, [name for _, name in names])


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
