#!/usr/bin/env python3
"""The page passport.html from end to end, with an engine that stands in for the real one.

usage: passport_test.py SOURCE_FOLDER CHROMIUM
PICTURES in the environment: a folder for the page's pictures at three widths.
"""

import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

from page_driver import SOURCES, Page

WIDTHS = (1280, 800, 390)
SECTIONS = ["device", "model", "verdicts", "failure", "unasked", "run"]
# What the engine is to find; the other plants are the self-proof's to refuse: drawers_test.
FOUND = ("half-pixel-shift", "diagonal-twice", "one-side-fused", "seven-bits",
         "every-1000th-lost")  # fmt: skip
MODEL_DRAWS = 60  # of the second viewport
NAMED = {"button", "combobox", "spinbutton", "textbox", "link", "image", "progressbar", "region",
         "form", "DisclosureTriangle", "option", "application", "graphics-document"}  # fmt: skip
RUNNING = 'Number(document.getElementById("progress").value) > 0'


class Passport(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.page = Page()

    @classmethod
    def tearDownClass(cls):
        cls.page.close()

    def setUp(self):
        self.page.open()
        self.page.value("localStorage.clear()")

    def start(self, api="webgpu", samples=1, cases=60, plant=None, **more):
        asked = {"api": api, "samples": samples, "cases": cases, "seed": 1} | more
        if plant:
            asked["plant"] = plant
        self.page.value(f"rasterproof.start({json.dumps(asked)})")

    def certificate(self):
        self.page.wait_for("done")
        return self.page.value("rasterproof.certificate()")

    def shown(self):
        """What of the run the page shows: the playground is always there."""
        sections = "section:not([hidden]):not(#playground, #compare)"
        return self.page.value(f"""Array.from(document.querySelectorAll("{sections}"),
                                   (section) => section.id)""")

    def differing(self):
        """How many samples the failure's picture marks as missing or unexpected."""
        return self.page.value("""Array.from(
            document.querySelectorAll("#pictures :is(.missing, .unexpected):not(text)"),
            (path) => path.getAttribute("d").split("M").length - 1).reduce((a, b) => a + b, 0)""")

    def test_keys_alone_run_it_and_nothing_is_fetched(self):
        self.page.value('document.querySelector("[name=seed]").focus()')
        self.page.browser.press("Tab")
        self.assertEqual(self.page.value("document.activeElement.id"), "start")
        self.page.browser.press("Enter")
        self.page.wait_for("running", "done")
        certificate = self.certificate()
        self.assertEqual((certificate["outcome"], certificate["where"]), ("holds", "worker"))
        self.assertEqual(certificate["draws"], 200 + MODEL_DRAWS)  # the form's own cases
        self.assertEqual(self.shown(), [name for name in SECTIONS if name != "failure"])
        self.assertIn("holds", self.page.text("verdict"))
        self.assertIn("swiftshader", self.page.text("device-facts"))
        self.assertEqual(self.page.browser.faults(), [])

    def test_the_model_of_swiftshader_is_found(self):
        for api, samples in (("webgpu", 1), ("webgpu", 4), ("webgl2", 1)):
            self.start(api, samples)
            certificate = self.certificate()
            self.assertEqual(certificate["outcome"], "holds", certificate)
            self.assertEqual(certificate["result"]["subjects"][0]["model"],
                             {"subpixelBits": [4], "snap": ["nearest even of float32(x - 1/2)"],
                              "ties": "top-left"})  # fmt: skip
            sizes = certificate["models"]
            self.assertEqual([one["side"] for one in sizes], [8192, 2048])
            self.assertEqual(sizes[0]["model"], sizes[1]["model"])
            self.assertEqual(self.page.text("model-sizes"), "The same at both sizes.")

    def test_planted_faults_are_found_and_pictured(self):
        for api in ("webgpu", "webgl2"):
            for plant in FOUND:
                with self.subTest(api=api, plant=plant):
                    self.start(api, cases=200, plant=plant)
                    certificate = self.certificate()
                    self.assertEqual(certificate["outcome"], "violated")
                    self.assertEqual(self.shown(), SECTIONS)
                    framed = self.differing()
                    if plant == "every-1000th-lost":  # not by the same case twice
                        self.assertIn("Drawn once more by itself, the case looks right",
                                      self.page.text("edges"))  # fmt: skip
                    else:
                        self.assertGreaterEqual(framed, 1)
                        (failure,) = certificate["result"]["subjects"][0]["failures"]
                        x, y = failure["pixel"]
                        drawn = certificate["picture"]["actual"][16 * y + x]
                        self.assertEqual(str(drawn), failure["actual"])
                    self.assertIn("violated", self.page.text("verdict"))
        text = self.page.value("rasterproof.reportText()")
        self.assertIn("```json", text)
        self.assertIn("- Failed: OneModelExplainsTheMesh\n", text)

    def test_a_drawer_that_loses_triangles_of_long_calls_does_not_hold(self):
        for api in ("webgpu", "webgl2"):
            self.start(api, cases=20, plant="every-1000th-of-a-call-lost")
            certificate = self.certificate()
            self.assertEqual(certificate["outcome"], "inconclusive")
            self.assertEqual(certificate["result"]["status"], 0)
            self.assertRegex(certificate["reason"], r"^\d+ triangles of long calls were lost")
            self.assertIn("triangles of long calls were lost", self.page.text("status"))
            self.assertIn("No property failed, and yet nothing is said to hold",
                          self.page.text("verdict"))  # fmt: skip

    def test_a_reproducer_draws_its_case_alone(self):
        for api in ("webgpu", "webgl2"):
            self.page.open()
            self.start(api, plant="half-pixel-shift")
            self.page.wait_for("done")
            framed = self.differing()
            text = self.page.value("rasterproof.reproducerPage()")
            self.assertLess(len(text), 60000)
            self.assertNotIn("half-pixel", text)
            with tempfile.TemporaryDirectory() as folder:
                page = pathlib.Path(folder, "reproducer.html")
                page.write_text(text, encoding="utf-8")
                self.page.browser.open(page.as_uri(), 800)
                self.page.wait_until('!document.getElementById("said").textContent'
                                     '.startsWith("Drawing")')  # fmt: skip
                # Without the plant hardly anything does: a corner that is rounded otherwise.
                differing = int(self.page.value("document.body.dataset.differing"))
                self.assertLess(differing, framed / 4)
                self.assertIn(f"{differing} of 256 samples differ", self.page.text("said"))
                self.assertEqual(self.page.value('document.querySelectorAll("td").length'), 512)
                page.write_text(text.replace('"expected":[', '"expected":[9,'), encoding="utf-8")
                self.page.browser.open(page.as_uri(), 800)
                self.page.wait_until(f"document.body.dataset.differing > {differing}")
                self.assertEqual(self.page.browser.faults(), [])

    def compare(self, *certificates):
        for which, certificate in zip(("first", "second"), certificates):
            text = certificate if isinstance(certificate, str) else json.dumps(certificate)
            self.page.value(f"""rasterproof.compareFile("{which}",
                new File([{json.dumps(text)}], "{which}.json"))""")
        return self.page.text("compare-said"), self.page.value(
            """Array.from(document.querySelectorAll("#compare-rows tr"),
               (row) => Array.from(row.children, (cell) => cell.textContent))""")

    def test_two_certificates_are_compared(self):
        self.start("webgpu")
        sound = self.certificate()
        self.start("webgpu")
        self.assertEqual(self.compare(sound, self.certificate())[0],
                         "Both devices answered every draw alike.")
        self.assertTrue(self.page.value('document.getElementById("compare-table").hidden'))
        self.start("webgpu", plant="seven-bits")
        said, rows = self.compare(sound, self.certificate())
        self.assertIn(["outcome", "holds", "violated", ""], rows)
        self.assertIn(["OneModelExplainsTheMesh", "holds", "violated", "broken: stub"], rows)
        self.assertTrue(said.startswith(f"They differ in {len(rows)} points. "), said)
        self.assertIn("First (google swiftshader) is legal, as far as it was asked", said)
        self.assertIn("Second (google swiftshader) is not legal: it breaks OneModel", said)
        self.start("webgl2", cases=20)
        rows = self.compare(sound, self.certificate())[1]
        self.assertIn(["asked: api", '"webgpu"', '"webgl2"'], [row[:3] for row in rows])
        for bad, what in (("{", "second.json is no JSON"), ("{}", "second.json is no certificate"),
                          ('{"rasterproof_passport": 1}', '"asked" is missing')):
            self.assertIn(what, self.compare(sound, bad)[0])

    def test_a_target_that_is_too_large_is_refused_and_the_run_goes_on(self):
        self.page.value("Worker = undefined")
        # Half of the stub's meshes on a target that no drawer draws.
        found = self.page.value("""(async () => {
          const {engine, session} = rasterproof.modules();
          const {prototype} = engine.Engine;
          const {next, answer} = prototype;
          prototype.next = function() {
            return next.call(this).map((request, k) => k % 2 ? {...request, width: 8191} : request);
          };
          const answers = [];
          prototype.answer = function(given) { answers.push(...given); };
          prototype.progress = () => ({done: 1, of: 1});
          let rounds = 0;
          const after = prototype.next;
          prototype.next = function() { return ++rounds > 1 ? [] : after.call(this); };
          let tell;
          await new Promise((resolve) => {
            session.serve((listener) => { tell = listener; },
                (message) => message.type === "done" && resolve());
            tell({type: "start", api: "webgl2", samples: 1, cases: 20, seed: 1});
          });
          return answers.map(({counts, refused}) => counts ? counts.length : refused);
        })()""")
        self.assertEqual(found[0], 2 * 16 * 16)
        self.assertIn("8191 x 16; sides are 1 to 4096", found[1])
        self.assertEqual(len(found), 10)

    def test_what_the_self_proof_refuses_is_inconclusive(self):
        for plant in ("saturating", "lying-read-back"):
            self.start(plant=plant)
            certificate = self.certificate()
            self.assertEqual(certificate["outcome"], "inconclusive")
            self.assertIsNone(certificate["result"])
            self.assertIn(certificate["reason"], self.page.text("status"))
            self.assertEqual(self.shown(), ["device", "run"])
        self.start("webgl2", samples=4)
        self.assertIn("can't read single samples", self.certificate()["reason"])

    def test_a_lost_device_is_opened_again(self):
        for api in ("webgpu", "webgl2"):
            self.start(api)
            self.page.wait_until(RUNNING)
            self.page.value('rasterproof.tell("lose")')
            certificate = self.certificate()
            self.assertEqual((certificate["outcome"], certificate["losses"]), ("holds", 1))

    def test_a_device_that_stays_lost_is_inconclusive(self):
        self.page.value("Worker = undefined")
        self.start()
        self.page.wait_until(RUNNING)
        self.page.value("navigator.gpu.requestAdapter = async () => null")
        self.page.value('rasterproof.tell("lose")')
        certificate = self.certificate()
        self.assertEqual(certificate["outcome"], "inconclusive")
        self.assertIn("no adapter", certificate["reason"])

    def test_a_page_that_is_shipped_plants_nothing_and_names_its_engine(self):
        with tempfile.TemporaryDirectory() as folder:
            page = pathlib.Path(folder, "passport.html")
            build = [sys.executable, "-B", SOURCES / "web" / "page" / "build.py", page]
            nameless = subprocess.run(build, capture_output=True, check=False)
            self.assertEqual(nameless.returncode, 2, nameless.stderr)
            self.assertFalse(page.exists())
            subprocess.run([*build, "--engine", SOURCES / "web" / "npm" / "index.mjs"], check=True)
            text = page.read_text(encoding="utf-8")
        self.assertNotIn("Stands in for", text)
        self.assertNotIn("seven-bits", text)
        self.assertNotIn("http://", text.replace("http://www.w3.org/2000/svg", ""))

    def test_a_hidden_page_waits(self):
        self.start()
        self.page.wait_until(RUNNING)
        hide = """Object.defineProperty(document, "hidden", {{configurable: true, value: {}}});
                  document.dispatchEvent(new Event("visibilitychange"))"""
        self.page.value(hide.format("true"))
        self.page.wait_for("paused")
        self.assertEqual(self.page.text("verdict"), "Asking this device …")
        self.assertEqual(self.shown(), ["device"])
        self.page.value(hide.format("false"))
        certificate = self.certificate()
        self.assertEqual((certificate["outcome"], certificate["pauses"]), ("holds", 1))

    def test_a_stopped_run_goes_on_after_the_page_was_closed(self):
        self.start(cases=400)
        self.page.wait_until(RUNNING)
        self.page.value('document.getElementById("stop").click()')
        self.page.wait_for("stopped")
        self.page.open()
        self.assertIn("Resume", self.page.text("status"))
        self.page.value('document.getElementById("resume").click()')
        certificate = self.certificate()
        self.assertEqual(certificate["outcome"], "holds")
        self.assertLess(certificate["draws"], 400 + MODEL_DRAWS)
        self.assertEqual(certificate["result"]["subjects"][0]["properties"][0]["cases"], 400)
        self.assertTrue(self.page.value('document.getElementById("resume").disabled'))

    def test_an_engine_that_ends_is_inconclusive(self):
        self.start(properties=["EndsTheEngine"])
        certificate = self.certificate()
        self.assertEqual((certificate["outcome"], certificate["reason"], certificate["saved"]),
                         ("inconclusive", "the engine ended", None))  # fmt: skip

    def test_what_a_browser_cannot_keep_is_not_resumed(self):
        self.page.value('Storage.prototype.setItem = () => { throw new Error("full"); }')
        self.start(cases=400)
        self.page.wait_until(RUNNING)
        self.page.value('document.getElementById("stop").click()')
        self.page.wait_for("stopped")
        self.assertIn("can't be resumed", self.page.text("status"))
        self.assertTrue(self.page.value('document.getElementById("resume").disabled'))

    def test_values_are_asked_of_fewer_cases(self):
        for of, samples, cases in (("values", 1, 1000), ("values", 4, 250), ("coverage", 1, 5000)):
            self.page.open()
            self.page.value(f"""for (const [name, value] of Object.entries(
                {{of: "{of}", samples: {samples}, cases: 5000}}))
              document.querySelector(`[name=${{name}}]`).value = value;
            document.getElementById("start").click();""")
            self.assertEqual(self.page.value("rasterproof.asked().cases"), cases)

    def test_a_failure_at_a_pixel_is_shown_before_one_without(self):
        for failures, first in (("[quality, list, pixel]", "pixel"), ("[quality, list]", "list"),
                                ("[quality]", "quality"), ("[]", None)):  # fmt: skip
            self.assertEqual(self.page.value(f"""(() => {{
              const quality = {{name: "quality", fails: false, pixel: [0, 0]}};
              const list = {{name: "list", fails: true}};
              const pixel = {{name: "pixel", fails: true, pixel: [1, 2]}};
              const result = {{subjects: [{{failures: {failures}}}]}};
              return rasterproof.modules().picture.firstFailure(result)?.name ?? null;
            }})()"""), first)  # fmt: skip

    def test_numbers_are_read_as_decimals_and_the_form_says_what_runs(self):
        self.assertEqual(self.page.value('readable("11/16 within 0x1.801200d80a208p-13, -0x1p+0")'),
                         "0.6875 (11/16) within 0.000183139, -1")
        self.start("webgl2", cases=20)
        self.certificate()
        self.assertEqual(self.page.value('byId("ask").elements.api.value'), "webgl2")

    def test_without_a_worker_the_page_draws_itself(self):
        self.page.value("Worker = undefined")
        for api in ("webgpu", "webgl2"):
            self.start(api, cases=20)
            certificate = self.certificate()
            self.assertEqual((certificate["outcome"], certificate["where"]), ("holds", "page"))

    def test_a_model_that_another_viewport_changes_is_told(self):
        for api in ("webgpu", "webgl2"):
            self.start(api, plant="coarse-in-small-viewports")
            certificate = self.certificate()
            self.assertEqual(certificate["outcome"], "holds")
            self.assertNotEqual(*(one["model"] for one in certificate["models"]))
            self.assertIn("The two sizes differ", self.page.text("model-sizes"))
            self.assertIn("2048 x 2048", self.page.text("model-facts"))

    def tree(self):
        """Role, name and liveness of what a screen reader meets, in its order."""
        nodes = self.page.browser.call("Accessibility.getFullAXTree")["nodes"]
        told = {node["nodeId"]: node for node in nodes}
        found = []

        def walk(node):
            if not node["ignored"]:
                live = [one["value"]["value"] for one in node.get("properties", ())
                        if one["name"] == "live"]  # fmt: skip
                found.append((node["role"]["value"], node["name"]["value"], *live))
            for child in node.get("childIds", ()):
                if child in told:
                    walk(told[child])

        walk(nodes[0])
        return found

    def unnamed(self):
        return [node[0] for node in self.tree()
                if node[0] in NAMED and not node[1].strip()]  # fmt: skip

    def tabbed(self):
        self.page.value("document.activeElement.blur(); scrollTo(0, 0)")
        met = []
        while len(met) < 60 and met[-1:] != ["play-preset"]:
            self.page.browser.press("Tab")
            met.append(self.page.value("""(({id, name, tagName, ariaLabel}) =>
                id || name || ariaLabel || tagName)(document.activeElement)"""))
        return met

    def test_a_failure_is_read_by_keys_by_ear_and_in_the_playground(self):
        self.assertEqual(self.unnamed(), [])
        self.start(plant="half-pixel-shift")
        certificate = self.certificate()
        self.assertEqual(self.tabbed(), [
            "A", "of", "api", "samples", "cases", "seed", "start", "SUMMARY", "Verdicts",
            "failure-link", "reproduce", "SUMMARY", "save", "copy", "compare-first",
            "compare-second", "play-preset"])  # fmt: skip
        self.page.value("""document.querySelectorAll("details").forEach(
                           (one) => { one.open = true; })""")
        self.assertEqual(self.unnamed(), [])
        tree = self.tree()
        self.assertGreater(sum(role in NAMED for role, *_ in tree), 30)
        self.assertIn(("status", "", "polite"), tree)
        self.assertEqual(self.page.text("status"), "Done.")
        headings = [name for role, name, *_ in tree if role == "heading"]
        self.assertEqual(headings[:6], ["Rasterizer passport", "This device",
                                        "Can its pictures be believed?", "Its model", "Verdicts",
                                        "The first failure"])  # fmt: skip
        self.page.value('document.getElementById("failure-link").click()')
        found = self.page.value(
            "rasterproof.playing.then(async (play) => { await play.settled();"
            " await play.settled(); return play.settled(); })")  # fmt: skip
        case = certificate["result"]["subjects"][0]["failures"][0]["case"]
        self.assertEqual(found["play"]["vertices"], case["scene"]["vertices"])
        self.assertEqual(found["play"]["triangles"], case["scene"]["triangles"])
        # This test sees a control that has lost its label.
        self.page.value('document.querySelector("[name=seed]").previousSibling.remove()')
        self.assertEqual(self.unnamed(), ["spinbutton"])

    def test_three_widths_in_light_and_dark(self):
        folder = os.environ.get("PICTURES")
        for plant in (None, "diagonal-twice") if folder else ("diagonal-twice",):
            self.start(cases=20, plant=plant)
            self.page.wait_for("done")
            for width in WIDTHS:
                for scheme in ("light", "dark"):
                    self.page.browser.show_on(width, dark=scheme == "dark")
                    self.page.browser.after_painting()
                    wide = self.page.value("document.documentElement.scrollWidth")
                    self.assertLessEqual(wide, width)
                    if folder:
                        self.page.picture(folder, f"{width}-{scheme}-{plant or 'sound'}.png")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
