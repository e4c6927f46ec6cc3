#!/usr/bin/env python3
"""The page with its real engine, in Chromium on SwiftShader and, where there is one, in Firefox on
llvmpipe: what it saves is judged alike by the command, and the two certificates are compared.

usage: certified_test.py SOURCE_FOLDER CHROMIUM COMMAND
RASTERPROOF_WASM in the environment: the engine. RECORD: a folder for the certificates.
Firefox needs a screen: packages firefox-esr and xvfb.
"""

import gzip
import json
import os
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

from firefox import Firefox
from page_driver import Page

COMMAND = os.path.abspath(sys.argv[3])
OUTCOMES = {"holds": 0, "violated": 1, "inconclusive": 4}
ONCE = "EmbeddedMeshSamplesAreCoveredOnce"
ASKED = ["SharedEdgeSamplesAreCoveredOnce", "OneLegalModelExplainsTheMesh", ONCE]
# Its calls take turns by 64 bits of the case, of which the module kept 32: certify refused it.
GRID = ["OneGridExplainsEveryCall"]
# Of the plants: what 40 cases of each property come to. 7 bits are legal, and 40 cases seldom have
# the triangle that is lost; WebGPU leaves edges and the grid open, so most plants are legal there.
PLANTED = {
    ("webgl2", 1): {"half-pixel-shift": "violated", "diagonal-twice": "violated",
                    "one-side-fused": "violated", "seven-bits": "holds",
                    "saturating": "inconclusive", "lying-read-back": "inconclusive",
                    "every-1000th-of-a-call-lost": "inconclusive"},
    ("webgpu", 1): {"half-pixel-shift": "violated", "diagonal-twice": "holds",
                    "every-1000th-of-a-call-lost": "inconclusive"},
    ("webgpu", 4): {"second-sample-misplaced": "inconclusive"},
}  # fmt: skip
VALUES, SLOPES = "ValuesStayWithinTheirError", "DerivativesStayWithinTheirError"
CENTROIDS, FLAT = "CentroidValuesStayWithinTheirError", "FlatValuesComeFromTheProvokingVertex"
# What 20 cases come to. With four samples SwiftShader evaluates "center" inputs at the sample, and
# divides by the centre's 1/w.
HELD = [
    ("webgl2", 1, None, set()), ("webgpu", 1, None, set()),
    ("webgpu", 4, None, {VALUES, SLOPES}),
    ("webgl2", 1, "affine", {VALUES, SLOPES, CENTROIDS}),
    ("webgpu", 1, "affine", {VALUES, SLOPES, CENTROIDS}),
    ("webgl2", 1, "slopes-exchanged", {SLOPES}),
    ("webgpu", 1, "slopes-exchanged", {SLOPES, "QuadDifferencesEqualDifferencesOfValues"}),
]  # fmt: skip
FIREFOX, SCREEN = shutil.which("firefox-esr"), shutil.which("Xvfb")
DONE = """new Promise((resolve) => {
  const look = () => document.body.dataset.state === "done" && resolve(rasterproof.certificate());
  new MutationObserver(look).observe(document.body, {attributes: true});
  look();
})"""


def asked(api, samples=1, cases=100, seed=1, **more):
    return {"api": api, "samples": samples, "cases": cases, "seed": seed,
            "properties": ASKED} | more  # fmt: skip


class Certified(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.page = Page()
        cls.addClassCleanup(cls.page.close)

    def certificate(self, question, browser=None):
        browser = browser or self.page.browser
        browser.value(f"rasterproof.start({json.dumps(question)})")
        return browser.value(DONE)

    def judged(self, certificate):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder, "passport.json")
            path.write_text(json.dumps(certificate), encoding="utf-8")
            done = subprocess.run([COMMAND, "certify", path], capture_output=True, text=True,
                                  check=False)  # fmt: skip
        self.assertEqual(done.returncode, OUTCOMES[certificate["outcome"]],
                         done.stdout + done.stderr)  # fmt: skip
        return done.stdout

    def keep(self, name, certificate):
        folder = os.environ.get("RECORD")
        if folder:
            text = json.dumps(certificate, indent=1).encode()
            pathlib.Path(folder, name).write_bytes(gzip.compress(text, mtime=0))

    def test_swiftshader_holds_by_both(self):
        for api, samples in (("webgpu", 1), ("webgpu", 4), ("webgl2", 1)):
            with self.subTest(api=api, samples=samples):
                certificate = self.certificate(asked(api, samples, cases=20))
                self.assertEqual(certificate["outcome"], "holds", certificate["result"])
                self.assertIn("holds under", self.judged(certificate))
                for one in certificate["models"]:
                    self.assertEqual(one["model"]["subpixelBits"], [4])
                    self.assertEqual(one["model"]["ties"], "top-left")

    def test_what_is_saved_of_planted_faults_is_judged_alike_by_the_command(self):
        for (api, samples), plants in PLANTED.items():
            for name, outcome in plants.items():
                with self.subTest(api=api, plant=name):
                    certificate = self.certificate(
                        asked(api, samples, cases=40, infer=False, plant=name))  # fmt: skip
                    self.assertEqual(certificate["outcome"], outcome)
                    self.judged(certificate)
                    if outcome == "violated":
                        (failure, *_) = certificate["result"]["subjects"][0]["failures"]
                        self.assertTrue(failure["clauses"])
                        self.assertTrue(certificate["picture"])

    def test_what_pixels_hold_is_judged_alike_by_the_command(self):
        for api, samples, plant, failing in HELD:
            with self.subTest(api=api, samples=samples, plant=plant):
                more = {"plant": plant} if plant else {}
                certificate = self.certificate(
                    {"of": "values", "api": api, "samples": samples, "cases": 20, "seed": 1} | more)
                subject = certificate["result"]["subjects"][0]
                self.assertEqual({one["property"] for one in subject["failures"]}, failing)
                self.assertEqual(certificate["outcome"], "violated" if failing else "holds")
                self.judged(certificate)
                exercised = {one["property"] for one in subject["properties"] if one["exercised"]}
                self.assertLess({VALUES, SLOPES, CENTROIDS, FLAT}, exercised)

    def test_forms_of_calls_are_those_of_the_command(self):
        certificate = self.certificate(
            asked("webgl2", cases=40, infer=False, plant="half-pixel-shift")
            | {"properties": GRID})  # fmt: skip
        self.assertEqual(certificate["outcome"], "violated")
        self.assertIn(GRID[0], self.judged(certificate))

    @unittest.skipUnless(FIREFOX and SCREEN, "there is no firefox-esr with Xvfb here: one "
                         "rasterizer alone was asked")  # fmt: skip
    def test_firefox_on_llvmpipe_differs_and_loses_triangles(self):
        firefox = Firefox(FIREFOX, SCREEN)
        self.addCleanup(firefox.close)
        firefox.open(self.page.url)
        question = asked("webgl2", properties=[ONCE])
        lossy = self.certificate(question, firefox)
        self.assertIn("llvmpipe", lossy["info"]["adapter"]["renderer"])
        self.keep("llvmpipe.json.gz", lossy)
        self.assertEqual(lossy["outcome"], "violated")
        self.assertIn(ONCE, self.judged(lossy))
        for one in lossy["models"]:
            self.assertEqual(one["model"]["subpixelBits"], [8])
        sound = self.certificate(question)
        self.keep("swiftshader.json.gz", sound)
        self.assertIn("holds under", self.judged(sound))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
