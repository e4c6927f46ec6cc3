/**
 * The picture of a failure: its case drawn once more, beside the nearest model's counts.
 *
 * @typedef {object} Picture
 * @property {number} x  Of the part that is shown, in pixels of the target.
 * @property {number} y
 * @property {number} width
 * @property {number} height
 * @property {number} samples
 * @property {number[]} expected  [height][width][samples], of the part.
 * @property {number[]} actual
 * @property {string} model  Which built-in method expected is of.
 * @property {{triangle: number, values: string[]}[]} edges  Exactly, at the failing sample's place.
 */
import {nearest} from "./numbers.mjs";
import {windowPoint} from "./geometry.mjs";
import {playOf, sceneOf} from "./scene.mjs";

/* The nearest of them to what was drawn is what the device is held against in the picture. */
const MODELS = ["filtered-exact", "i32-snap4", "i64-snap8"];
const MOST_SIDE = 32;
const MOST_SAMPLES = 1 << 18;
const CENTRE = [[8, 8]];
/* In sixteenths: the standard places of D3D, Vulkan, Metal and WebGPU. */
const PLACES = {1: CENTRE, 4: [[6, 2], [14, 6], [2, 10], [10, 14]]};

/**
 * What fails the run goes first, and of that what is a pixel of one case; a lack of quality alone
 * is shown, too.
 */
export function firstFailure(result) {
  const failures = result?.subjects[0].failures ?? [];
  return failures.find(({fails, pixel}) => fails && pixel) ??
      failures.find(({fails}) => fails) ?? failures[0];
}

/** Whether the case, drawn by itself, is what it should be. */
export function isAlike({expected, actual}) {
  return actual.every((count, k) => count === expected[k]);
}

/** What the drawers take of a case. */
export function requestOf(play, samples) {
  const points = play.vertices.map(([x, y, z = 0, w = 1]) => [x, y, z, w]);
  return {
    width: play.width, height: play.height, samples,
    vertices: Float64Array.from(points.flat()), triangles: play.triangles.flat(),
  };
}

/** A method's counts of all samples: built-in methods have one a pixel, so corners move instead. */
function modelCounts(engine, method, play, samples) {
  const counts = new Array(play.width * play.height * samples);
  PLACES[samples].forEach(([x, y], sample) => {
    const [dx, dy] = [(8 - x) / 16, (8 - y) / 16];
    const vertices = play.vertices.map((vertex) => [vertex[0] + dx, vertex[1] + dy]);
    const scene = sceneOf({...play, precision: "float64", vertices});
    engine.draw(method, scene).counts.forEach((n, k) => { counts[k * samples + sample] = n; });
  });
  return counts;
}

function differing(a, b) {
  return a.filter((n, k) => n !== b[k]).length;
}

function partOf([column, row], {width, height}) {
  const sizes = [width, height].map((side) => Math.min(side, MOST_SIDE));
  const [x, y] = [column, row].map((at, axis) => {
    const last = [width, height][axis] - sizes[axis];
    return Math.min(Math.max(at - (sizes[axis] >> 1), 0), last);
  });
  return {x, y, width: sizes[0], height: sizes[1]};
}

function cut(counts, part, play, samples) {
  const rows = Array.from({length: part.height}, (_, row) => {
    const from = ((part.y + row) * play.width + part.x) * samples;
    return counts.slice(from, from + part.width * samples);
  });
  return rows.flat();
}

function edgesOf(engine, play, pixel) {
  const triangles = play.triangles.map((indices) => ({
    corners: indices.map((k) => windowPoint(play.vertices[k]) ?? [NaN, NaN]),
  }));
  return nearest(triangles, pixel.map((n) => n + 0.5)).slice(0, 2).map((triangle) => ({
    triangle,
    values: engine.covers({triangle: triangles[triangle].corners, pixel, width: play.width,
      height: play.height}).edges_exact,
  }));
}

/**
 * @param {object} failure  Of the engine's result.
 * @param {(request: object) => Promise<{front: Uint32Array, back: Uint32Array}>} draw
 * @returns {Promise<Picture|null>}  null: the case is too large, or in clip space.
 */
export async function pictureOf(failure, samples, draw, engine) {
  const play = playOf(failure.case);
  const isShown = play.vertices.flat().every(Number.isFinite) && play.vertices[0]?.length !== 4 &&
      play.width * play.height * samples <= MOST_SAMPLES;
  if (!isShown) return null;
  const {front, back} = await draw(requestOf(play, samples));
  const actual = Array.from(front, (n, k) => n + back[k]);
  const ofModels = MODELS.map((model) => {
    const counts = modelCounts(engine, model, play, samples);
    return {model, counts, differing: differing(counts, actual)};
  });
  const [best] = ofModels.sort((a, b) => a.differing - b.differing);
  const first = best.counts.findIndex((n, k) => n !== actual[k]);
  const at = Math.floor(Math.max(first, 0) / samples);
  const pixel = failure.pixel ?? [at % play.width, Math.floor(at / play.width)];
  const part = partOf(pixel, play);
  return {
    ...part, samples, model: best.model,
    expected: cut(best.counts, part, play, samples), actual: cut(actual, part, play, samples),
    edges: samples === 1 ? edgesOf(engine, play, pixel) : [],
  };
}
