/**
 * What pixels hold: the parts of it that the drawers have in common. Channels are drawn in passes
 * of two, each a draw of the same corners; the triangle drawn last is visible.
 *
 * @typedef {object} ShadedScene  A Scene in clip space, with:
 * @property {{interpolation: string, at: string, values: ?Float64Array}[]} channels
 * @property {string[]} wants  Those of the engine's requests. Barycentrics are interpolated like
 *     channels; depth is the device's, of vertices that all lie at the same one.
 *
 * @typedef {object} Fragments  [height][width][samples], row 0 that of y in [0, 1).
 * @property {Int32Array} ids  -1: none.
 * @property {Float64Array} values  Of each channel, in their order.
 * @property {Float64Array} derivatives  Of each channel by x and by y.
 * @property {Float64Array} barycentrics  Three; zeros unless wanted.
 * @property {Float64Array} depths
 */

const OF_A_PASS = 2;
const INTERPOLATIONS = ["flat", "linear", "perspective", "inverse-w"];
const PLACES = ["sample", "centre", "centroid"];
/* Of a corner: clip coordinates and a number of each channel. */
export const CORNER_FLOATS = 4 + OF_A_PASS;
/* Of a sample: the triangle, from 1; of each channel its value; the depth; changes by x; by y. */
export const SAMPLE_FLOATS = 2 + 3 * OF_A_PASS;
const DEPTH = 1 + OF_A_PASS;

/** Why values of a scene are not drawn: null if they are. */
export function refusalOfCorners({vertices}, {viewport: {reach}}) {
  for (let k = 0; k < vertices.length; k += 4) {
    const most = reach * vertices[k + 3];
    // A NaN is the device's to treat.
    if (Math.abs(vertices[k]) > most || Math.abs(vertices[k + 1]) > most) {
      return "a corner outside the viewport, by which the device would clip";
    }
  }
  return null;
}

/** What each pass draws: `kinds` are numbers of the shader's ways to interpolate. */
export function passesOf({channels, wants}) {
  const passes = [];
  const unit = (corner) => ({interpolation: "perspective", at: "sample", corner});
  const all = [...channels, ...(wants.includes("barycentrics") ? [0, 1, 2].map(unit) : [])];
  for (let first = 0; first === 0 || first < all.length; first += OF_A_PASS) {
    const some = all.slice(first, first + OF_A_PASS);
    const kinds = some.map(({interpolation, at}) => {
      return INTERPOLATIONS.indexOf(interpolation) + INTERPOLATIONS.length * PLACES.indexOf(at);
    });
    passes.push({first, channels: some, kinds: [...kinds, 0, 0].slice(0, OF_A_PASS)});
  }
  return passes;
}

/**
 * The corners of all triangles, none shared. `placed`: clip coordinates of the vertices. Depth is
 * `depth` everywhere, so that nothing is clipped by it.
 */
export function cornersOf({triangles}, placed, depth, channels) {
  const corners = new Float32Array(CORNER_FLOATS * triangles.length);
  triangles.forEach((vertex, k) => {
    const [x, y, , w] = placed.subarray(4 * vertex, 4 * vertex + 4);
    const numbers = channels.map(({values, corner}) => {
      return values ? values[vertex] : corner === k % 3 ? 1 : 0;
    });
    corners.set([x, y, depth * w, w, ...numbers], CORNER_FLOATS * k);
  });
  return corners;
}

/** Puts passes together. */
export class Shown {
  #channels;
  fragments;

  constructor({width, height, samples = 1, channels}) {
    const size = width * height * samples;
    this.#channels = channels.length;
    this.fragments = {
      ids: new Int32Array(size).fill(-1),
      values: new Float64Array(size * channels.length),
      derivatives: new Float64Array(2 * size * channels.length),
      barycentrics: new Float64Array(3 * size),
      depths: new Float64Array(size),
    };
  }

  /**
   * @param {(sample: number, n: number) => number} read  Of SAMPLE_FLOATS.
   * @throws Error if another triangle is visible than in the pass before.
   */
  take({first, channels}, read) {
    const {ids, values, derivatives, barycentrics, depths} = this.fragments;
    for (let k = 0; k < ids.length; ++k) {
      const id = read(k, 0) - 1;
      if (first === 0) ids[k] = id;
      if (ids[k] !== id) {
        throw new Error(`drawn once more, triangle ${id} is visible at sample ${k}, not ${ids[k]}`);
      }
      if (id < 0) continue;
      if (first === 0) depths[k] = read(k, DEPTH);
      channels.forEach(({corner}, c) => {
        if (corner !== undefined) {
          barycentrics[3 * k + corner] = read(k, 1 + c);
          return;
        }
        const at = k * this.#channels + first + c;
        values[at] = read(k, 1 + c);
        derivatives[2 * at] = read(k, DEPTH + 1 + c);
        derivatives[2 * at + 1] = read(k, DEPTH + 1 + OF_A_PASS + c);
      });
    }
  }
}
