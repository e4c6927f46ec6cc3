// What a page saves, judged again by the command: it says the same, and refuses what doesn't follow.
// usage: node certificate_test.mjs COMMAND BUILD_WEB
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import test, { after } from "node:test";
import { Engine, useModule } from "../../web/npm/index.mjs";
import { rasterizers } from "./rasterizers.mjs";

const [command, buildWeb] = process.argv.slice(2).map((path) => resolve(path));
const folder = mkdtempSync(join(tmpdir(), "rasterproof-certificate-"));
useModule(readFileSync(join(buildWeb, "rasterproof.wasm")));
after(() => rmSync(folder, { recursive: true }));

const ONCE = "SharedEdgeSamplesAreCoveredOnce";
const OUTCOMES = { 0: "holds", 1: "violated", 4: "inconclusive" };

async function certificateOf(name, more = {}) {
  const { profile, takes, make } = rasterizers[name];
  const asked = { cases: 40, seed: 3 };
  const engine = await Engine.create();
  const draw = await make();
  engine.open({ subject: { name, takes }, profile, properties: [ONCE], ...asked, ...more });
  for (let round = engine.next(); round.length > 0; round = engine.next()) {
    engine.answer(await Promise.all(round.map(async (request) => ({ counts: await draw(request) }))));
  }
  const result = engine.result();
  const saved = Buffer.from(engine.save()).toString("base64");
  return { rasterproof_passport: 1, asked, outcome: OUTCOMES[result.status], reason: null, result, saved };
}

function judged(certificate) {
  const file = join(folder, "passport.json");
  const text = typeof certificate === "string" ? certificate : JSON.stringify(certificate, null, 1);
  writeFileSync(file, text);
  return spawnSync(command, ["certify", file], { encoding: "utf8" });
}

const wrong = await certificateOf("open");
const right = await certificateOf("right", { infer: true });

test("the command derives the same verdict", () => {
  const bad = judged(wrong);
  assert.equal(bad.status, 1, bad.stderr);
  assert.match(bad.stdout, new RegExp(`${ONCE}: .*=> observed covered 0 times`));
  assert.match(bad.stdout, /open: violated under .* taken on trust/);
  const good = judged(right);
  assert.equal(good.status, 0, good.stderr);
  assert.match(good.stdout, /right: holds under/);
});

// Each takes a copy of the certificate that is violated, and of the one that holds.
const lies = {
  "does not follow": {
    "a status": (c) => (c.result.status = 0),
    "an outcome": (c) => (c.outcome = "holds"),
    "no failure": (c) => (c.result.subjects[0].failures = []),
    "a property": (c) => (c.result.subjects[0].properties[0].outcome = "holds"),
    "a picture": (c) => (c.result.subjects[0].failures[0].picture.actual[0] += 1),
  },
  "does not answer": {
    "another seed": (c) => (c.asked.seed = c.result.opened.seed = 4),
    "more cases": (c, held) => {
      Object.assign(c, held);
      c.asked.cases = c.result.opened.cases = 41;
    },
    "answers of another": (c) => (c.saved = right.saved),
    "no answers": (c) => (c.saved = Buffer.from("rasterproof answers 1\n").toString("base64")),
  },
  "is not that of the cases": { "a seed that is said": (c) => (c.asked.seed = 4) },
  "0.0.9": { "another version": (c) => (c.result.version = "0.0.9") },
  "these are none": { "answers cut off": (c) => (c.saved = c.saved.slice(0, -40)) },
  "is no base64": { "other digits": (c) => (c.saved = "*") },
};
for (const [why, ways] of Object.entries(lies)) {
  for (const [what, lie] of Object.entries(ways)) {
    test(`refused: ${what}`, () => {
      const certificate = structuredClone(wrong);
      lie(certificate, structuredClone(right));
      const { status, stderr } = judged(certificate);
      assert.equal(status, 2, stderr);
      assert.ok(stderr.includes(why), stderr);
    });
  }
}

test("refused: a file that ends early, and one of something else", () => {
  const text = JSON.stringify(wrong);
  for (const other of [text.slice(0, text.length / 2), "{}", ""]) assert.equal(judged(other).status, 2);
});

test("a page that did not judge says why", () => {
  const { status, stdout } = judged({ ...wrong, result: null, saved: null, reason: "no WebGL2" });
  assert.equal(status, 4);
  assert.match(stdout, /no WebGL2/);
});

test("the model is what the rasterizer does", () => {
  const { model, model_text: text } = right.result.subjects[0];
  assert.deepEqual(model.subpixelBits, [8]);
  assert.deepEqual(model.snap, ["nearest-even of x", "nearest-even of x - 0x1p-1"]);
  assert.equal(model.ties, "top-left");
  assert.match(text, /^8 subpixel bits, nearest-even of x; top-left; samples \[128\/256, 128\/256\]/);
});

test("a failure shows its counts, its edge values, its clauses and its command", () => {
  const [{ picture, pixel, sample, clauses, next }] = wrong.result.subjects[0].failures;
  const { width, height, samples, expected, actual } = picture;
  assert.equal(expected.length, width * height * samples);
  const at = ((pixel[1] - picture.y) * width + pixel[0] - picture.x) * samples + sample;
  assert.deepEqual([expected[at], actual[at]], [1, 0]);
  // A sample on an edge: both triangles that share it have an E of zero.
  assert.equal(picture.edges.filter(({ values }) => values.includes("0")).length, 2);
  assert.ok(Array.isArray(clauses));
  assert.match(next, /^rasterproof replay '\{.*\}' --subject rounds:FOLDER$/);
});
