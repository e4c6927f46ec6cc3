/**
 * What the drawers of WebGL2 and WebGPU have in common: their contract, and the arithmetic that
 * places vertices, done here and not in a shader.
 *
 * @typedef {object} Scene
 * @property {number} width  In pixels, at most info.largestTarget.
 * @property {number} height
 * @property {1|4} [samples]  A pixel; 1 if absent.
 * @property {Float32Array} vertices  x, y of each vertex in window space, or x, y, z, w with x / w
 *     and y / w in window space.
 * @property {"window"|"clip"} [space]
 * @property {Uint32Array} triangles  Three indices each.
 * @property {boolean} [facing]  false: all fragments count as front.
 * @property {number} [reach]  Half the side of the viewport, a power of two: of a centred one at
 *     most info.viewport.reach, of an ordinary one at most half of info.largestTarget.
 * @property {number} [mask]  Of samples, one bit each; all if absent.
 * @property {[number, number]} [start]  What front and back count before the first triangle.
 *
 * @typedef {object} Counts
 * @property {Uint32Array} front  [height][width][samples]: how often front-facing triangles
 *     (counter-clockwise on screen) covered the sample. Row 0 is that of y in [0, 1).
 * @property {Uint32Array} back
 * @property {boolean} resolved  true: [height][width], the sum over a pixel's samples.
 *
 * @typedef {object} Info
 * @property {"webgl2"|"webgpu"} api
 * @property {object} adapter  Names as the browser gives them.
 * @property {object} limits
 * @property {string[]} hidden  What the browser does not say.
 * @property {number[]} samples  Counts of samples that can be drawn.
 * @property {number|null} subpixelBits  As the device says, null if nobody does.
 * @property {number} largestTarget
 * @property {number} ceiling  What one sample counts to exactly: see ceilingOf.
 * @property {"down"|"up"} yAxis
 * @property {?object} values  Keys of a profile's `values` beside those that every device has; null
 *     where values can't be drawn.
 * @property {boolean} perSample  false: only sums over a pixel's samples can be read.
 * @property {{kind: "centred"|"ordinary", reach: number, error: number}} viewport  error: largest
 *     distance in pixels, for vertices in a target of 256 x 256, between a vertex and what reaches
 *     the viewport; larger targets in proportion.
 *
 * @typedef {object} Drawer
 * @property {Info} info
 * @property {(scene: Scene) => Promise<Counts>} draw  Rejects with LostError after a loss.
 * @property {(scene: import("./shading.mjs").ShadedScene) =>
 *     Promise<import("./shading.mjs").Fragments>} shade  Where info.values says that it can.
 * @property {(vertices: Float32Array) => Promise<Uint32Array>} echo  The bits of x, y, z, w of each
 *     vertex after they passed a vertex shader.
 * @property {Promise<string>} lost  Resolves with the reason when the device or context is lost.
 * @property {() => void} lose  For tests: loses it.
 * @property {() => void} close
 *
 * A plant is a fault of a rasterizer that only tests hand to `open`:
 * @typedef {object} Plant
 * @property {(count: number, scene: Scene) => {select?: (triangle: number) => boolean,
 *     mask?: number, position?: string}[]} [passes]  The draws that make one drawing. position:
 *     shader text that changes `p`, a clip-space position; `unit` is a pixel there.
 * @property {"max"} [blend]
 * @property {(code: string) => string} [shade]  Changes the shader of values.
 * @property {(values: Float32Array) => void} [read]  Changes what is read back.
 */

export const LEAST_SIDE = 256;
/* Sides that drawers offer where the device has them, and samples: 8 bytes each are as many as
   every device of WebGPU binds. */
export const MOST_SIDE = 4096;
const MOST_SAMPLES = 2 ** 24;

/** The device or context is gone; what was asked has no answer. */
export class LostError extends Error {
  constructor(reason) {
    super(`the graphics device was lost: ${reason}`);
    this.name = "LostError";
  }
}

/** The largest power of two <= n. */
export function powerBelow(n) {
  return 2 ** Math.floor(Math.log2(n));
}

const padded = (n) => 2 ** Math.ceil(Math.log2(Math.max(n, LEAST_SIDE)));

/** An ordinary viewport's side: a power of two, so that scaling is exact. It holds the scene. */
export function paddedSide({width, height, reach = 0}) {
  return padded(Math.max(width, height, 2 * reach));
}

/** Width and height of the target: an ordinary viewport has to lie in it. */
export function targetSides(scene, viewport) {
  const side = paddedSide(scene);
  return viewport.kind === "centred" ? [padded(scene.width), padded(scene.height)] : [side, side];
}

/** Why a drawer does not draw a target of this size; null if it does. */
export function refusalOf({width, height, samples = 1}, {largestTarget}) {
  if (Math.max(width, height) > largestTarget) {
    return `a target of ${width} x ${height}; sides are 1 to ${largestTarget}`;
  }
  if (width * height * samples <= MOST_SAMPLES) return null;
  return `a target of ${width} x ${height} x ${samples} samples; ${MOST_SAMPLES} are the most`;
}

export function checkScene(scene, info) {
  const {width, height, samples = 1, triangles, vertices} = scene;
  const sides = [width, height];
  if (!sides.every((n) => Number.isInteger(n) && n > 0)) {
    throw new RangeError(`a target of ${width} x ${height}`);
  }
  const refusal = refusalOf(scene, info);
  if (refusal) throw new RangeError(refusal);
  if (!info.samples.includes(samples)) {
    throw new RangeError(`${samples} samples a pixel; the device has ${info.samples.join(", ")}`);
  }
  const count = vertices.length / (scene.space === "clip" ? 4 : 2);
  if (triangles.length % 3 !== 0 || triangles.some((index) => index >= count)) {
    throw new RangeError("a triangle whose corner is no vertex");
  }
}

/**
 * Clip-space positions of a scene's vertices. With a centred viewport every number is scaled by a
 * power of two alone: exact down to float32's smallest normal number times the reach. With an
 * ordinary one, of the size of the target, each is rounded once.
 * @param {1|-1} up  -1: rows are counted downwards.
 * @param {number} depth  z / w of every vertex of window space.
 */
export function clipVertices(scene, viewport, up, depth) {
  const isClip = scene.space === "clip";
  const stride = isClip ? 4 : 2;
  const isCentred = viewport.kind === "centred";
  const reach = isCentred ? scene.reach ?? viewport.reach : paddedSide(scene) / 2;
  const count = scene.vertices.length / stride;
  const out = new Float32Array(4 * count);
  for (let k = 0; k < count; ++k) {
    const [x, y] = scene.vertices.subarray(stride * k, stride * k + 2);
    const w = isClip ? scene.vertices[4 * k + 3] : 1;
    const away = isCentred ? 0 : w;
    out[4 * k] = x / reach - away;
    out[4 * k + 1] = up * (y / reach - away);
    out[4 * k + 2] = isClip ? scene.vertices[4 * k + 2] : depth;
    out[4 * k + 3] = w;
  }
  return out;
}

/** The viewport's rectangle: x, y, width, height. */
export function viewportOf(scene, viewport) {
  const side = paddedSide(scene);
  const reach = scene.reach ?? viewport.reach;
  return viewport.kind === "centred" ? [-reach, -reach, 2 * reach, 2 * reach] : [0, 0, side, side];
}

/** Counts up to this one are exact: an average over a pixel needs bits for its fractions. */
export function ceilingOf(info, samples) {
  return info.perSample ? info.ceiling : info.ceiling / samples;
}

function indicesOf(triangles, first, last, select) {
  if (!select) return triangles.slice(3 * first, 3 * last);
  const kept = [];
  for (let t = first; t < last; ++t) {
    if (select(t)) kept.push(...triangles.subarray(3 * t, 3 * t + 3));
  }
  return Uint32Array.from(kept);
}

/**
 * What is drawn in one go: of at most as many triangles as a target counts. A plant may make
 * several passes of it.
 * @returns {{start: [number, number], passes: {indices: Uint32Array, mask: number,
 *     position: string}[]}[]}
 */
export function parts(scene, info, plant = {}) {
  const start = scene.start ?? [0, 0];
  const most = Math.max(1, ceilingOf(info, scene.samples ?? 1) - Math.max(...start));
  const all = 2 ** (scene.samples ?? 1) - 1;
  const count = scene.triangles.length / 3;
  const passes = plant.passes?.(count, scene) ?? [{}];
  const found = [];
  for (let first = 0; first === 0 || first < count; first += most) {
    const last = Math.min(first + most, count);
    found.push({
      start: first === 0 ? start : [0, 0],
      passes: passes.map(({select, mask = all, position = ""}) => ({
        indices: indicesOf(scene.triangles, first, last, select),
        mask: mask & (scene.mask ?? all),
        position,
      })),
    });
  }
  return found;
}

/**
 * Adds values read back, front and back in turn, to counts.
 * @throws Error if one is no whole number of fragments.
 */
export function addCounts(counts, values) {
  for (let k = 0; k < counts.front.length; ++k) {
    const front = values[2 * k];
    const back = values[2 * k + 1];
    if (!(Number.isInteger(front) && Number.isInteger(back) && front >= 0 && back >= 0)) {
      throw new Error(`read-back of ${front} and ${back} where counts are whole`);
    }
    counts.front[k] += front;
    counts.back[k] += back;
  }
}
