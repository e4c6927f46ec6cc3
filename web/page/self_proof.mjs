/**
 * A drawer proves itself before anything it draws is believed: read-back, counting, facing,
 * vertices, samples. What fails here is no finding about a rasterizer but *inconclusive*.
 */
import {ceilingOf} from "./drawer.mjs";

/** Places of samples in sixteenths of a pixel, as Direct3D, Vulkan and WebGPU state them. */
export const STANDARD_PLACES = {1: [[8, 8]], 4: [[6, 2], [14, 6], [2, 10], [10, 14]]};

/**
 * Triangles with an upright edge each at x = sides[k], or a level one at y where `axis` is 1. Over
 * the first pixels of the other axis they reach `width` pixels, to the left if it is negative.
 * Separate triangles: who owns the diagonal of a quad is for the engine to ask.
 */
function wedges(sides, width, {axis = 0, isFront = true, yAxis = "down"} = {}) {
  const vertices = new Float32Array(6 * sides.length);
  const triangles = new Uint32Array(3 * sides.length);
  // Counter-clockwise on screen or not: the far corner, then along the edge.
  const isTurned = (width > 0) !== (axis === 1) !== (yAxis === "down") === isFront;
  sides.forEach((side, k) => {
    const corners = [[side + width, 1], [side, -300], [side, 302]];
    vertices.set(corners.flatMap(([x, y]) => axis === 0 ? [x, y] : [y, x]), 6 * k);
    triangles.set((isTurned ? [0, 2, 1] : [0, 1, 2]).map((corner) => 3 * k + corner), 3 * k);
  });
  return {vertices, triangles};
}

/** The first count that is not what it should be, in words; null if all are or may be anything. */
function difference(counts, expected, samples) {
  for (const side of ["front", "back"]) {
    const wrong = counts[side].findIndex((count, k) => (expected(side, k) ?? count) !== count);
    if (wrong >= 0) {
      return `${side} counts ${counts[side][wrong]}, not ${expected(side, wrong)}, at sample ` +
          `${wrong % samples} of pixel ${Math.floor(wrong / samples)}`;
    }
  }
  return null;
}

/** How a drawer's samples lie in its answers: `each` a pixel, each worth `worth` fragments. */
function layout(drawer, samples) {
  return drawer.info.perSample ? {each: samples, worth: 1} : {each: 1, worth: samples};
}

/* Nothing is drawn: the target is cleared to what is known and read. */
async function readBack(drawer, samples) {
  const {each, worth} = layout(drawer, samples);
  const empty = {
    width: 61, height: 37, samples, vertices: new Float32Array(0), triangles: new Uint32Array(0),
  };
  const ceiling = ceilingOf(drawer.info, samples);
  for (const start of [[0, 0], [1, 2], [ceiling >> 1, 3], [ceiling - 1, 5], [7, ceiling]]) {
    const counts = await drawer.draw({...empty, start});
    const wrong = difference(
        counts, (side) => worth * start[side === "front" ? 0 : 1], each);
    if (!wrong) continue;
    return {
      reason: `what is read back is not what the target was cleared to: ${wrong}; protection ` +
          "against fingerprinting does that, and can be turned off for this page",
    };
  }
  return {said: "5 targets cleared to known counts are read back unchanged"};
}

/** Draws up to three times, so that a rasterizer that loses a few triangles reaches the engine. */
async function oneOfThree(attempt) {
  let wrong = null;
  for (let tries = 0; tries < 3; ++tries) {
    wrong = await attempt();
    if (!wrong) return null;
  }
  return wrong;
}

/**
 * One side counts from base to base + steps over 256 columns: what is wrong, and how many are
 * lost. Edges are in the middle of every second pixel and the others are looked at, so that neither
 * places of samples nor a picture that is displaced matter.
 */
async function stair(drawer, samples, base, steps, isFront) {
  const {each, worth} = layout(drawer, samples);
  const sides = Array.from({length: steps}, (_, k) => 511.5 - 2 * Math.floor(k * 256 / steps));
  const drawn = wedges(sides, -2000, {isFront, yAxis: drawer.info.yAxis});
  const start = isFront ? [base, 0] : [0, base];
  const counts = await drawer.draw({width: 512, height: 2, samples, start, ...drawn});
  const heights = Array.from({length: 256}, (_, c) => sides.filter((side) => side > 2 * c).length);
  const seen = counts[isFront ? "front" : "back"];
  const wrong = difference(counts, (side, k) => {
    const x = Math.floor(k / each) % 512;
    if (x % 2 === 1) return null;
    return (side === "front") === isFront ? worth * (base + heights[x / 2]) : 0;
  }, each);
  // At most one in a hundred, and as many or fewer where there are fewer: no fault of counting.
  const losses = heights.map((height, c) => height - (seen[2 * c * each] / worth - base));
  const isLoss = losses.every((n) => n >= 0 && n <= losses[0]) && losses[0] <= steps / 100;
  return {wrong, lost: isLoss ? losses[0] : 0};
}

/* Every height to the ceiling; with formats that count further, from 0 and to their ceiling. */
async function counting(drawer, samples) {
  const ceiling = ceilingOf(drawer.info, samples);
  const most = Math.min(ceiling, 2048);
  let allLost = 0;
  for (const base of new Set([0, ceiling - most])) {
    for (const isFront of [true, false]) {
      const {wrong, lost} = await stair(drawer, samples, base, most, isFront);
      allLost += lost;
      if (wrong && lost === 0) return {reason: `${most} triangles are miscounted: ${wrong}`};
    }
  }
  // With triangles lost on the way up, the last steps of the stair are asked for alone.
  const wrong = allLost > 0 && await oneOfThree(async () => {
    return (await stair(drawer, samples, ceiling - 16, 16, true)).wrong;
  });
  if (wrong) return {reason: `triangles are miscounted just below ${ceiling}: ${wrong}`};
  const said = `${most} triangles count ${most}, at every height up to ${ceiling}`;
  return allLost > 0 ? {said: `${said}, but ${allLost} are lost`, lost: allLost} : {said};
}

const bitsOf = (values) => new Uint32Array(Float32Array.from(values).buffer);

/** Bits of finite float32 numbers over all exponents: from a fixed seed, without subnormals. */
function normalBits(count) {
  const bits = new Uint32Array(count);
  let state = 0x9e3779b9;
  for (let k = 0; k < count; ++k) {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    const exponent = 1 + ((state >>> 8) % 254);
    bits[k] = ((state & 0x80000000) | (exponent << 23) | ((state * 2654435761) & 0x7fffff)) >>> 0;
  }
  bits.set(bitsOf([0, -0, 1, -1, 2 ** -126, -(2 ** -126), 3.4028234663852886e38, 1 / 3]));
  return bits;
}

async function vertices(drawer) {
  const sent = normalBits(4096);
  const got = await drawer.echo(new Float32Array(sent.buffer));
  const wrong = sent.findIndex((bits, k) => bits !== got[k]);
  if (wrong >= 0) {
    const [was, is] = [sent, got].map((bits) => bits[wrong].toString(16));
    return {reason: `a coordinate with the bits ${was} reaches the shader's end as ${is}`};
  }
  const kept = async (bits) => {
    const back = await drawer.echo(new Float32Array(Uint32Array.from(bits).buffer));
    return bits.every((one, k) => one === back[k]);
  };
  return {
    said: `${sent.length} coordinates come back bit for bit`,
    subnormals: await kept([1, 0x80000001, 0x007fffff, 0x00400000]) ? "kept" : "flushed",
    nan: await kept([0x7fc00000, 0x7fc00001, 0xffc00000, 0x7f800000]) ? "kept" : "altered",
  };
}

/* Upright edges, eight pixels apart, each of a triangle of its own numbers that nothing turns. */
async function numbers(drawer, samples) {
  const sides = Array.from({length: 64}, (_, k) => 8 * k + 2);
  const {vertices: points, triangles} = wedges(sides, 2000, {yAxis: drawer.info.yAxis});
  const vertices = new Float32Array(2 * points.length);
  for (let k = 0; k < points.length; k += 2) vertices.set([points[k], points[k + 1], 0, 1], 2 * k);
  const channels = Array.from({length: 3}, (_, c) => {
    const sent = new Float32Array(normalBits(3 * sides.length).buffer, 4 * c * sides.length);
    const values = Float64Array.from({length: 3 * sides.length}, (_v, k) => sent[Math.floor(k / 3)]);
    return {interpolation: "flat", at: "sample", values};
  });
  const {ids, values} = await drawer.shade({
    width: 512, height: 1, samples, space: "clip", vertices, triangles, channels, wants: ["values"],
  });
  for (let k = 0; k < sides.length; ++k) {
    for (let at = (8 * k + 6) * samples; at < (8 * k + 7) * samples; ++at) {
      if (ids[at] !== k) return {reason: `triangle ${ids[at]} is visible where ${k} was drawn last`};
      const wrong = channels.findIndex(({values: of}, c) => of[3 * k] !== values[3 * at + c]);
      if (wrong < 0) continue;
      const [was, is] = [channels[wrong].values[3 * k], values[3 * at + wrong]];
      return {reason: `the number ${was} of all corners is read back as ${is}`};
    }
  }
  return {said: `${3 * sides.length} numbers come back bit for bit, of the triangles drawn last`};
}

/* One triangle over everything, masked to one sample at a time. */
async function addressing(drawer, samples) {
  const {each} = layout(drawer, samples);
  const one = wedges([30], -2000, {yAxis: drawer.info.yAxis});
  for (let s = 0; s < samples; ++s) {
    const wrong = await oneOfThree(async () => {
      const counts = await drawer.draw({width: 16, height: 2, samples, mask: 1 << s, ...one});
      return difference(counts, (side, k) => {
        return side === "front" && (each === 1 || k % each === s) ? 1 : 0;
      }, each);
    });
    if (wrong) return {reason: `a triangle masked to sample ${s} covers others, too: ${wrong}`};
  }
  return {
    said: each === 1 ? `of ${samples} samples a mask of one lets one be covered` :
                       `each of ${samples} samples is reached by its bit of the mask alone`,
  };
}

/** Per sample, how many of the half planes that begin at sixteenths of its pixel cover it. */
async function thresholds(drawer, samples, axis) {
  // From a pixel before it to a pixel after it: the picture may be displaced.
  const sides = Array.from({length: 49}, (_, k) => 8 * k + 2 + (k - 16) / 16);
  const size = axis === 0 ? {width: 392, height: 1} : {width: 1, height: 392};
  const {front} = await drawer.draw({...size, samples, facing: false, ...wedges(sides, 4, {axis})});
  const {each} = layout(drawer, samples);
  return Array.from({length: samples}, (_, s) => sides.filter((_, k) => {
    const pixel = 8 * k + 2;
    return each === 1 ? front[pixel] > s : front[pixel * each + s] > 0;
  }).length - 16);
}

/**
 * Where the samples lie, in sixteenths, from half planes: at n means between n - 1 and n.
 * Without single samples x and y are two sorted lists, largest first.
 */
async function places(drawer, samples) {
  const found = [await thresholds(drawer, samples, 0), await thresholds(drawer, samples, 1)];
  const {perSample} = drawer.info;
  const standard = [0, 1].map((axis) => {
    const list = STANDARD_PLACES[samples].map((place) => place[axis]);
    return perSample ? list : list.sort((a, b) => b - a);
  });
  // A whole picture that is displaced is the engine's to find; here samples are held to each other.
  const isStandard = [0, 1].every((axis) => {
    const apart = found[axis].map((n, s) => n - standard[axis][s]);
    return Math.max(...apart) - Math.min(...apart) <= 1;
  });
  const record = {x: found[0], y: found[1], standard: isStandard};
  if (!isStandard && drawer.info.api === "webgpu") {
    const words = found[0].map((x, s) => `${x}/16, ${found[1][s]}/16`).join("; ");
    return {reason: `the samples do not lie at the standard places but near ${words}`, ...record};
  }
  const said = isStandard ? "the samples lie at the standard places, to 1/16" :
                            "the samples lie at places of this device's own";
  return {said, ...record};
}

/**
 * @param {import("./drawer.mjs").Drawer} drawer
 * @param {1|4} samples
 * @param {boolean} [ofValues]
 * @returns {Promise<{passed: boolean, reason: string|null, api: string, samples: number,
 *     checks: {name: string, passed: boolean, said?: string, reason?: string}[]}>}
 *     A JSON value. The first check that fails ends it: those after it build on it.
 */
export async function prove(drawer, samples = 1, ofValues = false) {
  const all = {
    readBack, counting, vertices, ...(samples > 1 && {addressing}), places,
    ...(ofValues && {numbers}),
  };
  const record = {passed: true, reason: null, api: drawer.info.api, samples, checks: []};
  for (const [name, check] of Object.entries(all)) {
    let found;
    try {
      found = await check(drawer, samples);
    } catch (error) {
      if (error.name === "LostError") throw error;
      found = {reason: error.message};
    }
    record.checks.push({name, passed: !found.reason, ...found});
    if (found.reason) return {...record, passed: false, reason: found.reason};
  }
  return record;
}
