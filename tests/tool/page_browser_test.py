#!/usr/bin/env python3
"""The page on error against run time in a real browser: what its script draws, and that no text
covers another. The bench is made up; nothing here depends on time.

usage: page_browser_test.py SAMPLE_PAGE CHROMIUM
"""
import os
import subprocess
import sys
import tempfile
import unittest

from browser import Browser

SAMPLE_PAGE, CHROMIUM = sys.argv[1:3]

# The panel that is shown, and its points.
PLOT = 'document.querySelector("#bench-plot > div:not(.off) svg")'
POINTS = PLOT + '.querySelectorAll(".point:not(.off)")'
# Boxes of text that cover each other: of every text node's lines, cut to what its scroll box shows.
COVERED = r"""(() => {
  const boxes = [];
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    const text = walker.currentNode, parent = text.parentElement;
    const isShown = !["style", "script", "option", "title"].includes(parent.localName);
    if (!text.data.trim() || !isShown || parent.closest(".off") || !parent.checkVisibility())
      continue;
    const range = document.createRange();
    range.selectNodeContents(text);
    const clip = parent.closest(".scroll")?.getBoundingClientRect();
    for (const rect of range.getClientRects()) {
      const box = {text: text.data.trim(), left: rect.left, top: rect.top, right: rect.right,
        bottom: rect.bottom};
      if (clip) {
        box.left = Math.max(box.left, clip.left);
        box.right = Math.min(box.right, clip.right);
        box.top = Math.max(box.top, clip.top);
        box.bottom = Math.min(box.bottom, clip.bottom);
      }
      if (box.right - box.left > 1 && box.bottom - box.top > 1) boxes.push(box);
    }
  }
  boxes.sort((a, b) => a.top - b.top);
  const found = [];
  boxes.forEach((a, k) => {
    for (let j = k + 1; j < boxes.length && boxes[j].top < a.bottom - 1.5; ++j) {
      const b = boxes[j];
      if (b.left < a.right - 1.5 && a.left < b.right - 1.5) found.push(`${a.text} | ${b.text}`);
    }
  });
  return {count: boxes.length, found};
})()"""
# Text that a plot cuts off at its border.
CUT = r"""Array.from(document.querySelectorAll("svg text")).filter((text) => {
  const box = text.getBoundingClientRect(), all = text.closest("svg").getBoundingClientRect();
  return box.width && (box.left < all.left - 1 || box.right > all.right + 1 ||
    box.bottom > all.bottom + 1 || box.top < all.top - 1);
}).map((text) => text.textContent)"""


class PageInABrowser(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        path = os.path.join(cls.folder.name, "report.html")
        subprocess.run([SAMPLE_PAGE, path], check=True)
        cls.url = "file://" + path
        cls.browser = Browser(CHROMIUM)

    @classmethod
    def tearDownClass(cls):
        cls.browser.close()
        cls.folder.cleanup()

    def open(self, width=1280, **how):
        self.browser.open(self.url, width, **how)

    def value(self, expression):
        return self.browser.value(expression)

    def choose(self, name, value):
        self.value(f"""(() => {{
          const field = document.getElementById("bench-pick").elements["{name}"];
          if (field.type === "checkbox") field.checked = {str(bool(value)).lower()};
          else field.value = "{value}";
          field.dispatchEvent(new Event("change", {{bubbles: true}}));
        }})()""")

    def names_in_plot(self):
        return self.value(f"""Array.from({PLOT}.querySelectorAll(".named:not(.pointed)"))
          .filter((text) => !text.closest(".off")).map((text) => text.textContent)""")

    def column(self, k):
        return self.value(f"""Array.from(
          document.querySelectorAll("#bench-rows tbody tr:not(.off)"),
          (row) => row.cells[{k}].textContent)""")

    def test_the_plot_is_drawn_and_nothing_is_complained_of_or_fetched(self):
        self.open()
        points = self.value(POINTS + ".length")
        self.assertEqual(points, 17)  # 18 methods less the baseline measured again
        self.assertIn("kernel-exact avx2", self.names_in_plot())
        self.assertIn("mine.so (yours)", self.names_in_plot())
        self.assertEqual(self.browser.faults(), [])

    def test_every_point_is_named_where_the_pointer_is(self):
        self.open()
        self.value('document.getElementById("bench-plot").scrollIntoView()')
        for k in (0, 5, 16):
            name = self.value(f'{POINTS}[{k}].getAttribute("aria-label")')
            x, y = self.value(f"""(() => {{
              const box = {POINTS}[{k}].querySelector(".mark").getBoundingClientRect();
              return [box.left + box.width / 2, box.top + box.height / 2];
            }})()""")
            self.browser.point_at(x, y)
            said = self.value('document.getElementById("bench-said").textContent')
            self.assertTrue(said.startswith(name + ": "), said)
            self.assertEqual(self.value('document.querySelector(".pointed").textContent'), name)

    def test_keys_alone_reach_every_point_and_sort_the_table(self):
        self.open()
        self.value("""document.querySelector('#bench-pick [name="exact"]').focus()""")
        self.browser.press("Tab")
        names = []
        for _ in range(17):
            names.append(self.value('document.activeElement.getAttribute("aria-label")'))
            said = self.value('document.getElementById("bench-said").textContent')
            self.assertTrue(said.startswith(names[-1] + ": "), said)
            self.browser.press("ArrowRight")
        self.assertEqual(len(set(names)), 17)
        self.browser.press("ArrowLeft")
        self.assertEqual(self.value('document.activeElement.getAttribute("aria-label")'), names[-2])
        self.value('document.querySelector("#bench-rows thead button").focus()')
        self.browser.press("Enter")
        self.assertEqual(self.column(0), sorted(self.column(0)))

    def test_another_family_or_error_is_drawn_again(self):
        self.open()
        first = self.value('document.getElementById("bench-plot").innerHTML')
        self.choose("family", 1)
        second = self.value('document.getElementById("bench-plot").innerHTML')
        self.assertNotEqual(first, second)
        caption = self.value('document.getElementById("bench-caption").textContent')
        self.assertTrue(caption.startswith("large: "), caption)
        self.assertEqual(len(self.column(0)), 5)
        self.choose("error", 2)
        self.assertNotEqual(second, self.value('document.getElementById("bench-plot").innerHTML'))
        shown = self.value(f"""Array.from({PLOT}.querySelectorAll("text"))
          .filter((text) => !text.closest(".off")).map((text) => text.textContent)""")
        self.assertTrue(any(text.endswith(" px") for text in shown), shown)
        self.choose("error", 4)
        self.choose("bytes", 8)
        self.choose("exact", True)
        self.assertEqual(self.browser.faults(), [])

    def test_the_table_sorts_and_filters(self):
        self.open()
        self.assertEqual(len(self.column(0)), 17)
        self.choose("exact", True)
        self.assertEqual(sorted(self.column(0)), ["i64-snap8", "kernel-exact"])
        self.choose("target", "avx2")
        self.assertEqual(self.column(0), ["kernel-exact"])
        self.choose("target", "")
        self.choose("exact", False)
        self.value('document.querySelectorAll("#bench-rows thead button")[3].click()')
        nanoseconds = [float(cell) for cell in self.column(3)]
        self.assertEqual(nanoseconds, sorted(nanoseconds, reverse=True))
        self.value('document.querySelectorAll("#bench-rows thead button")[3].click()')
        self.assertEqual([float(cell) for cell in self.column(3)], sorted(nanoseconds))
        self.choose("bytes", 8)
        self.assertEqual(len(self.column(0)), 17)

    def test_what_is_shown_is_saved(self):
        self.open()
        files = dict(self.value("""(async () => {
          const blobs = new Map(), saved = [];
          const create = URL.createObjectURL;
          URL.createObjectURL = (blob) => {
            const url = create(blob);
            blobs.set(url, blob);
            return url;
          };
          HTMLAnchorElement.prototype.click = function () {
            saved.push([this.download, blobs.get(this.href)]);
          };
          for (const button of document.querySelectorAll("#bench-save button")) button.click();
          for (let frames = 0; saved.length < 3 && frames < 500; ++frames) {
            await document.body.animate([], 10).finished;
          }
          for (const file of saved) file[1] = await file[1].text();
          return saved;
        })()"""))
        self.assertEqual(set(files), {"bench-small.svg", "bench-small.png", "bench-small.csv"})
        self.assertIn("<svg", files["bench-small.svg"])
        self.assertIn("kernel-exact avx2", files["bench-small.svg"])
        self.assertNotIn(" off", files["bench-small.svg"])
        self.assertIn("PNG", files["bench-small.png"])
        lines = files["bench-small.csv"].splitlines()
        self.assertEqual(len(lines), 18)
        self.assertTrue(lines[0].startswith('"method","by","into"'), lines[0])
        self.assertEqual(self.browser.faults(), [])

    def shown_case(self):
        return self.value('document.getElementById("cliff-shown").innerText')

    def test_the_matrix_shows_what_a_cell_says_and_its_commands(self):
        self.open()
        self.assertTrue(self.shown_case().startswith("Choose a cell"))
        self.assertTrue(self.value('document.getElementById("cliff-cases").hidden'))
        rows = self.value("""Array.from(document.querySelectorAll("#cliffs tbody th"),
                             (head) => head.textContent)""")
        alike = ", ".join(f"crowd-{k}" for k in range(1, 10))
        # The first of the crowd has a separate cell: nothing is known of its steps.
        self.assertEqual(rows, ["f32-direct", "kernel-exact avx2", "crowd-0", alike, "crowd-11"])
        cell = 'document.querySelectorAll("#cliffs tbody tr")[3].cells[2]'
        self.assertEqual(self.value(cell + ".innerText.split(/\\s*\\n/)"),
                         ["≤ 94906265", "✗ 94906266"])  # fmt: skip
        self.value(cell + '.scrollIntoView({block: "center"})')
        x, y = self.value(f"""(() => {{
          const box = {cell}.getBoundingClientRect();
          return [box.left + box.width / 2, box.top + box.height / 2];
        }})()""")
        self.browser.click(x, y)
        text = " ".join(self.shown_case().split())
        self.assertIn(alike + " over w: proved to 94906265, first seen failing at 94906266.", text)
        for k in range(1, 10):
            self.assertIn(f"explain out/bench/cliff-w-crowd-{k}.json --subject crowd-{k}", text)
        self.assertEqual(self.browser.faults(), [])

    def test_keys_alone_reach_every_cell_of_the_matrix(self):
        self.open()
        self.value("""document.querySelector("#limits h2").tabIndex = 0""")
        self.value("""document.querySelector("#limits h2").focus()""")
        self.browser.press("Tab")  # the box that scrolls
        if not self.value('document.activeElement.localName === "td"'):
            self.browser.press("Tab")
        self.assertIn("f32-direct over steps: proved to 64", self.shown_case())
        self.browser.press("ArrowDown")  # over the empty cell of kernel-exact
        self.assertIn("crowd-0 over steps: nothing proved", self.shown_case())
        self.assertNotIn("rasterproof explain", self.shown_case())
        self.browser.press("ArrowRight")
        self.assertIn("crowd-0 over w", self.shown_case())
        self.assertIn("rasterproof explain", self.shown_case())
        stops = self.value("""document.querySelectorAll("#cliffs [tabindex='0']").length""")
        self.assertEqual(stops, 1)

    def test_curves_that_coincide_are_one_line(self):
        self.open()
        names = self.value("""Array.from(document.querySelectorAll("#curve-steps .curve"),
          (figure) => Array.from(figure.querySelectorAll("ol > li"),
            (line) => line.innerText.trim()))""")
        self.assertEqual(names[0], ["f32-direct and 5 more", "crowd-0 and 4 more", "crowd-10",
                                    "crowd-11"])  # fmt: skip
        figure = 'document.querySelector("#curve-steps .curve")'
        self.assertEqual(self.value(figure + '.querySelectorAll("svg .line").length'), 4)
        self.assertEqual(self.value(figure + '.querySelectorAll("svg .place").length'), 4)
        self.assertEqual(self.value(figure + '.querySelectorAll("svg .cliff").length'), 1)
        title = self.value(figure + '.querySelector("svg .line title").textContent')
        self.assertEqual(title, "f32-direct, crowd-1, crowd-3, crowd-5, crowd-7, crowd-9")
        self.assertIn("float32 ends", self.value(figure + '.querySelector("svg").textContent'))

    def test_no_text_covers_another(self):
        for width in (1280, 800):
            self.open(width, dark=width == 800)
            self.value('for (const one of document.querySelectorAll("details")) one.open = true')
            for family in (0, 1):
                for error in range(5):
                    self.choose("family", family)
                    self.choose("error", error)
                    self.browser.after_painting()
                    covered = self.value(COVERED)
                    self.assertGreater(covered["count"], 600)
                    self.assertEqual(covered["found"], [], (width, family, error))
                    self.assertEqual(self.value(CUT), [], (width, family, error))

    def test_nothing_is_wider_than_the_window(self):
        for width in (1280, 800):
            self.open(width)
            self.assertLessEqual(self.value("document.documentElement.scrollWidth"), width)

    def test_without_script_the_first_family_is_there(self):
        self.open(script=False)
        self.browser.call("Emulation.setScriptExecutionDisabled", value=False)
        shown = 'document.querySelectorAll("#bench-plot > div:not(.off) svg").length'
        self.assertEqual(self.value(shown), 1)
        self.assertEqual(len(self.column(0)), 17)
        self.assertTrue(self.value('document.getElementById("bench-pick").hidden'))
        self.assertFalse(self.value('document.getElementById("cliff-cases").hidden'))
        commands = self.value("""Array.from(document.querySelectorAll("#cliff-cases pre"),
                                 (line) => line.textContent.trim())""")
        self.assertIn("rasterproof explain out/bench/cliff-w-crowd-3.json --subject crowd-3 "
                      "--pixel 3 2", commands)  # fmt: skip


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
