#!/usr/bin/env python3
"""The drawers of the page prove themselves in headless Chromium, on SwiftShader, and refuse what
they can't be believed in; all other planted faults reach the engine.

usage: drawers_test.py SOURCE_FOLDER CHROMIUM
"""

import sys
import unittest

from page_driver import Page

APIS = ("webgpu", "webgl2")
REFUSED = {
    "saturating": "miscounted",
    "lying-read-back": "read back is not what the target was cleared to",
}
# Drawers that lie, as changes of a sound one's answers; the check that says so, or nothing.
LIARS = {
    "a bit of a vertex": ("echo: async (v) => (await d.echo(v)).map((b, k) => k === 5 ? b ^ 1 : b)",
                          "vertices"),
    "flushes subnormals": ("echo: async (v) => (await d.echo(v)).map("
                           "(b) => (b & 0x7f800000) === 0 ? b & 0x80000000 : b)", ""),
    "ignores masks": ("draw: (s) => d.draw({...s, mask: undefined})", "addressing"),
    "front for back": ("draw: async (s) => { const c = await d.draw(s);"
                       "return s.triangles.length ? {...c, front: c.back, back: c.front} : c; }",
                       "counting"),
    "eight short of its ceiling": ("draw: async (s) => { const c = await d.draw(s);"
                                   "return s.triangles.length ? {...c,"
                                   "front: c.front.map((n) => Math.min(n, 2040))} : c; }",
                                   "counting"),
}  # fmt: skip
# WebGL2 has no standard places of samples: there they are recorded.
REFUSED_OF_4_IN_WEBGPU = {"second-sample-misplaced": "do not lie at the standard places"}

# Changed in how values are passed on, which counting does not do.
OF_VALUES = ("affine", "one-more", "slopes-exchanged")
# What becomes of these depends on how many samples a pixel has.
OF_4_SAMPLES = ("saturating", "second-sample-misplaced", "every-1000th-lost",
                "every-1000th-of-a-call-lost")  # fmt: skip


class Drawers(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.page = Page()

    @classmethod
    def tearDownClass(cls):
        cls.page.close()

    def value(self, body):
        """What the body of a function returns whose names are the page's modules."""
        return self.page.value(f"""(async () => {{
          const {{drawer, webgpu, webgl2, self_proof, plants}} = rasterproof.modules();
          {body}
        }})()""")

    def proof(self, api, samples, plant=None, options="{}", of_values="false"):
        language = "wgsl" if api == "webgpu" else "glsl"
        given = f'plants.plants("{language}")["{plant}"]' if plant else "{}"
        return self.value(f"""
          const opened = await {api}.open({{...{options}, plant: {given}}});
          const record = await self_proof.prove(opened, {samples}, {of_values});
          opened.close();
          return {{...record, info: opened.info}};""")

    def test_swiftshader_proves_itself(self):
        for api in APIS:
            for samples in (1, 4):
                record = self.proof(api, samples)
                self.assertTrue(record["passed"], record)
                checks = {check["name"]: check for check in record["checks"]}
                self.assertEqual(record["info"]["viewport"],
                                 {"kind": "centred", "reach": 4096, "error": 0})  # fmt: skip
                self.assertTrue(checks["places"]["standard"], checks)
                self.assertEqual((checks["vertices"]["subnormals"], checks["vertices"]["nan"]),
                                 ("kept", "kept"))  # fmt: skip
                ceiling = 512 if (api, samples) == ("webgl2", 4) else 2048
                self.assertIn(f"up to {ceiling}", checks["counting"]["said"])
        self.assertEqual(self.proof("webgl2", 1)["info"]["subpixelBits"], 4)

    def test_other_formats_and_viewports_prove_themselves(self):
        for form, ceiling in (("rgba8", 255), ("r32f", 2**24)):
            record = self.proof("webgl2", 1, options=f'{{format: "{form}"}}')
            self.assertTrue(record["passed"], record)
            self.assertIn(f"up to {ceiling}", record["checks"][1]["said"])
        for api in APIS:
            record = self.proof(api, 1, options='{viewport: "ordinary"}')
            self.assertTrue(record["passed"], record)
            self.assertGreater(record["info"]["viewport"]["error"], 0)

    def test_what_cannot_be_believed_is_refused_and_the_rest_reaches_the_engine(self):
        names = self.value('return Object.keys(plants.plants("wgsl"))')
        self.assertEqual(len(names), 13)  # nine faults, a change that is none, three of values
        names = [name for name in names if name not in OF_VALUES]
        for api, samples in [(api, samples) for api in APIS for samples in (1, 4)]:
            refused = REFUSED | (REFUSED_OF_4_IN_WEBGPU if (api, samples) == ("webgpu", 4) else {})
            for name in OF_4_SAMPLES if samples == 4 else names:
                with self.subTest(api=api, samples=samples, plant=name):
                    record = self.proof(api, samples, name)
                    self.assertEqual(record["passed"], name not in refused, record)
                    self.assertIn(refused.get(name, ""), record["reason"] or "")
                    # WebGL2 counts 4 samples up to 512: none of its calls has a thousand.
                    is_seen = name == "every-1000th-lost" or (api, samples) != ("webgl2", 4)
                    if "1000th" in name and is_seen:
                        self.assertGreater(record["checks"][1]["lost"], 0)
                    if (samples, name) == (4, "second-sample-misplaced"):
                        self.assertFalse(record["checks"][-1]["standard"])

    def test_numbers_of_pixels_are_proved_where_values_are_asked(self):
        for api, samples in (("webgpu", 1), ("webgpu", 4), ("webgl2", 1)):
            with self.subTest(api=api, samples=samples):
                sound = self.proof(api, samples, of_values="true")
                self.assertTrue(sound["passed"], sound)
                self.assertIn("192 numbers come back", sound["checks"][-1]["said"])
                lying = self.proof(api, samples, "one-more", of_values="true")
                self.assertEqual(lying["checks"][-1]["name"], "numbers")
                self.assertIn("is read back as", lying["reason"])
        for api in APIS:
            ordinary = self.value(f"""
              const opened = await {api}.open({{viewport: "ordinary"}});
              opened.close();
              return opened.info;""")
            self.assertIsNone(ordinary["values"])

    def test_a_drawer_that_lies_is_refused_by_the_check_that_asks_it(self):
        for name, (change, refused_by) in LIARS.items():
            record = self.value(f"""
              const d = await webgpu.open();
              const record = await self_proof.prove({{
                info: d.info, draw: (s) => d.draw(s), echo: (v) => d.echo(v), {change}}},
                {4 if refused_by == "addressing" else 1});
              d.close();
              return record;""")
            with self.subTest(name):
                self.assertEqual(record["passed"], not refused_by, record)
                last = record["checks"][-1]["name"]
                self.assertEqual(last, refused_by or "places")
                if name == "flushes subnormals":
                    self.assertEqual(record["checks"][2]["subnormals"], "flushed")

    def drawn(self, api, body, samples=1):
        """What `body` returns, for scenes on one drawer: `one(scene)` draws a mesh of two."""
        return self.value(f"""
          const opened = await {api}.open();
          const vertices = Float32Array.of(0.25, 0.5, 18.5, 2.75, 19.0625, 30.5, 1.5, 27.25);
          const mesh = {{width: 20, height: 32, samples: {samples}, vertices,
            triangles: Uint32Array.of(0, 1, 2, 0, 2, 3)}};
          const one = async (changes) => {{
            const {{front, back}} = await opened.draw({{...mesh, ...changes}});
            return JSON.stringify([...front, ...back]);
          }};
          const failure = (changes) => one(changes).then(() => "drawn", (error) => error.name);
          const found = await (async () => {{ {body} }})();
          opened.close();
          return found;""")

    def test_a_scene_is_drawn_alike_by_other_ways(self):
        for api in APIS:
            for samples in (1, 4):
                alike = self.drawn(api, """
                  const clip = new Float32Array(16);
                  for (let k = 0; k < 4; ++k) {
                    const w = 2 ** k;
                    clip.set([w * vertices[2 * k], w * vertices[2 * k + 1], 0, w], 4 * k);
                  }
                  const base = await one({});
                  const others = [{reach: 256}, {vertices: clip, space: "clip"}];
                  const count = base.match(/[1-9]/g).length;
                  return [count, ...await Promise.all(others.map(one))].map(
                      (other) => typeof other === "number" ? other : other === base);
                """, samples)  # fmt: skip
                self.assertEqual(alike[1:], [True, True])
                self.assertGreater(alike[0], 300)

    def test_more_triangles_than_a_target_counts_are_drawn_in_parts(self):
        for api in APIS:
            top = self.drawn(api, """
              const triangles = new Uint32Array(3 * 5000);
              for (let k = 0; k < triangles.length; ++k) triangles[k] = k % 3;
              return Math.max(...JSON.parse(await one({triangles})));
            """)
            self.assertEqual(top, 5000)

    def test_what_cannot_be_drawn_is_said(self):
        for api in APIS:
            self.assertEqual(self.drawn(api, """
              const after = async () => {
                opened.lose();
                await opened.lost;
                return failure({});
              };
              const most = opened.info.largestTarget;
              await one({width: most, height: 3});
              return [await failure({width: most + 1}), await failure({samples: 3}),
                await failure({triangles: Uint32Array.of(0, 1, 4)}), await after()];
            """), ["RangeError", "RangeError", "RangeError", "LostError"])  # fmt: skip


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
