// A user's own tests, by the installed package.
import assert from "node:assert/strict";
import test from "node:test";
import { Engine, Refused, assertRasterizes, check, describe, matchers, oracle } from "rasterproof";

// Samples by edge functions in double; inside(e, dx, dy) says who owns what.
const drawnBy = (inside) => ({ width, height, vertices, triangles }) => {
  const counts = new Uint32Array(width * height);
  for (let t = 0; t < triangles.length; t += 3) {
    const v = [0, 1, 2].map((k) => vertices.subarray(4 * triangles[t + k]));
    const edge = (p, q, x, y) => (x - p[0]) * (q[1] - p[1]) - (y - p[1]) * (q[0] - p[0]);
    const side = Math.sign(edge(v[0], v[1], v[2][0], v[2][1]));
    for (let k = 0; k < counts.length; ++k) {
      const [x, y] = [(k % width) + 0.5, Math.floor(k / width) + 0.5];
      const covers = [0, 1, 2].every((i) => {
        const [p, q] = [v[i], v[(i + 1) % 3]];
        return inside(side * edge(p, q, x, y), side * (q[0] - p[0]), side * (q[1] - p[1]));
      });
      if (covers && side !== 0) ++counts[k];
    }
  }
  return counts;
};
const open = drawnBy((e) => e > 0);
const topLeft = drawnBy((e, dx, dy) => e > 0 || (e === 0 && (dy > 0 || (dy === 0 && dx < 0))));
const once = ["SharedEdgeSamplesAreCoveredOnce"];

test("a rasterizer without a tie rule is violated, with a case", async () => {
  const result = await check(open, "real", { properties: once, cases: 100 });
  assert.equal(result.outcome, "violated");
  assert.equal(result.status, 1);
  const [failure] = result.failures;
  assert.equal(failure.property, once[0]);
  assert.equal(failure.actual, "covered 0 times");
  assert.equal(failure.case.rasterproof_case, 2);
  assert.match(describe(result), /SharedEdgeSamplesAreCoveredOnce at pixel/);
});

test("the sentence about two polygons on a common edge holds of top-left edges in double", async () => {
  const result = await check(topLeft, "real", { properties: once, cases: 3 });
  assert.equal(result.outcome, "holds", describe(result));
});

test("a matcher and an assertion say what fails", async () => {
  const options = { properties: once, cases: 100 };
  assert.equal((await matchers.toRasterize(open, "real", options)).pass, false);
  await assert.rejects(assertRasterizes(open, "real", options), /drawn covered 0 times/);
});

test("draw() that throws is a finding, that refuses is not", async () => {
  const options = { properties: once, cases: 20 };
  const broken = await check(() => assert.fail("out of order"), "real", options);
  assert.equal(broken.outcome, "violated");
  assert.match(broken.failures[0].message, /out of order/);
  const refusing = () => {
    throw new Refused("too small");
  };
  assert.equal((await check(refusing, "real", options)).outcome, "inconclusive");
});

test("too few numbers are a finding", async () => {
  const result = await check(() => [1, 2, 3], "real", { properties: once, cases: 20 });
  assert.equal(result.outcome, "violated");
  assert.match(result.failures[0].message, /3 numbers/);
});

test("a rasterizer that answers differently is no result", async () => {
  let calls = 0;
  const restless = (request) => open(request).fill(++calls % 2);
  const options = { properties: once, cases: 100 };
  await assert.rejects(check(restless, "real", options), /not deterministic/);
});

test("what was answered is saved, and another instance goes on from there", async () => {
  const opened = { properties: once, cases: 30 };
  const answers = (engine) => engine.next().map((request) => ({ counts: open(request) }));
  const first = await Engine.create();
  first.open(opened);
  first.answer(answers(first));
  const second = await Engine.create();
  second.open(opened);
  second.load(first.save());
  for (const engine of [first, second]) {
    for (let given = answers(engine); given.length > 0; given = answers(engine)) engine.answer(given);
  }
  assert.deepEqual(second.result(), first.result());
  assert.ok(first.memoryBytes <= 512 * 2 ** 20);
});

test("fragments hold what is wanted, or it is said what is missing", async () => {
  const values = { flat: true, provoking: "first" };
  const subject = { coverage: "fragments", shows: ["values"] };
  const profile = { name: "flat", contract: "none", values };
  const properties = ["FlatValuesComeFromTheProvokingVertex"];
  const flat = (vertex) => (request) => {
    const ids = Array.from(open(request), (count) => (count === 1 && request.triangles.length === 3 ? 0 : -1));
    return {
      ids,
      values: ids.flatMap(() => request.channels.map((channel) => channel.values[request.triangles[vertex]])),
    };
  };
  const judged = (draw) => check(draw, profile, { properties, subject, cases: 40 });
  assert.equal((await judged(flat(0))).outcome, "holds");
  const last = await judged(flat(2));
  assert.equal(last.outcome, "violated");
  assert.match(last.failures[0].message, /provoking/);
  const missing = await judged((request) => ({ ids: flat(0)(request).ids }));
  assert.match(missing.failures[0].message, /no values, and \d+ are wanted/);
  await assert.rejects(check(flat(0), profile, { subject: { shows: ["values"] } }), /fragments/);
});

test("the oracle decides a tie by the profile's rule, and says what is open", async () => {
  const triangle = [[0, 0], [0, 4], [4, 4]];
  const at = (pixel, profile) => oracle.covers({ triangle, pixel, profile });
  assert.equal((await at([0, 2], "d3d11-canonical")).covers, "must");
  const tie = await at([1, 1], "d3d11-canonical");
  assert.equal(tie.covers, "must not");
  assert.deepEqual(tie.edges_exact, ["10", "0", "6"]);
  assert.deepEqual(tie.barycentrics_exact, ["5/8", "0", "3/8"]);
  assert.equal((await at([1, 1], "vulkan")).covers, "may");
});

test("built-in methods draw, with their edge values", async () => {
  const vertices = [[0, 0], [0, 4], [4, 4]];
  const scene = { rasterproof_scene: 1, width: 4, height: 4, vertices, triangles: [[0, 1, 2]] };
  const drawn = await oracle.draw("f32-direct-fma", scene, [1.5, 1.5]);
  assert.equal(drawn.counts[8], 1);
  assert.deepEqual(drawn.triangles[0].edges, [10, 0, 6]);
  assert.ok((await oracle.methods()).includes("i64-snap8"));
});

test("mistakes are named, and the next question is answered", async () => {
  const triangle = [[0, 0], [0, 4], [4, 4]];
  await assert.rejects(oracle.covers({ triangle, pixel: [0, 99] }), /pixel/);
  await assert.rejects(check(open, "vulcan"), /vulkan/);
  await assert.rejects(check(open, "real", { properties: ["Nonsense"] }), /Nonsense/);
  assert.equal((await oracle.covers({ triangle, pixel: [0, 2] })).covers, "must");
});
