// Rasterizers in JavaScript, right and wrong ones, and two methods of the module.
// Each: { profile, takes, coverage, shows, causes, make }, where make() gives draw(request).

import { Engine } from "../../web/npm/index.mjs";

const corners = ({ vertices, triangles }, t) =>
  [0, 1, 2].map((k) => vertices.subarray(4 * triangles[t + k], 4 * triangles[t + k] + 4));

// Counts samples by decide(corners, x, y), and a triangle's samples by the box of its corners.
function byPixels(decide, place = (v) => [v[0], v[1]]) {
  return (request) => {
    const { width, height, triangles } = request;
    const counts = new Uint32Array(width * height);
    for (let t = 0; t < triangles.length; t += 3) {
      const v = corners(request, t).map(place);
      if (!v.flat().every(Number.isFinite)) continue;
      const [xs, ys] = [0, 1].map((axis) => v.map((p) => p[axis]));
      const [x0, x1] = [Math.min(...xs), Math.max(...xs)].map((x) => Math.floor(x));
      const [y0, y1] = [Math.min(...ys), Math.max(...ys)].map((y) => Math.floor(y));
      for (let j = Math.max(0, y0 - 1); j <= Math.min(height - 1, y1 + 1); ++j) {
        for (let i = Math.max(0, x0 - 1); i <= Math.min(width - 1, x1 + 1); ++i) {
          if (decide(v, i + 0.5, j + 0.5)) ++counts[j * width + i];
        }
      }
    }
    return counts;
  };
}

const edge = (p, q, x, y) => (x - p[0]) * (q[1] - p[1]) - (y - p[1]) * (q[0] - p[0]);

// Five operations, nothing said of ties: samples on edges are in neither triangle.
function open(v, x, y) {
  const side = Math.sign(edge(v[0], v[1], v[2][0], v[2][1]));
  return [0, 1, 2].every((k) => side * edge(v[k], v[(k + 1) % 3], x, y) > 0);
}

// In units of 1/256 pixel, exactly.
function snapped(bits, onTie) {
  const scale = 2 ** bits;
  const nearest = (x) => {
    const low = Math.floor(x * scale);
    const rest = x * scale - low;
    return (rest > 0.5 || (rest === 0.5 && low % 2 !== 0) ? low + 1 : low) / scale;
  };
  const big = (x) => BigInt(x * 2 ** 8);
  const e = (p, q, x, y) => (x - p[0]) * (q[1] - p[1]) - (y - p[1]) * (q[0] - p[0]);
  return byPixels(
    (corner, i, j) => {
      const v = corner.map((p) => p.map(big));
      const area = e(v[0], v[1], v[2][0], v[2][1]);
      if (area === 0n) return false;
      const [x, y] = [big(i), big(j)];
      return [0, 1, 2].every((k) => {
        const [p, q] = [v[k], v[(k + 1) % 3]];
        const value = area > 0n ? e(p, q, x, y) : -e(p, q, x, y);
        if (value !== 0n) return value > 0n;
        const [dx, dy] = area > 0n ? [q[0] - p[0], q[1] - p[1]] : [p[0] - q[0], p[1] - q[1]];
        return onTie(dx, dy);
      });
    },
    (v) => [nearest(v[0]), nearest(v[1])],
  );
}
const topLeft = (dx, dy) => dy > 0n || (dy === 0n && dx < 0n);

// A method of the module draws.
async function byMethod(method) {
  const engine = await Engine.create();
  return ({ width, height, samples, clip, vertices, triangles }) => {
    // Of a scene without vertices nobody can tell which space it is in.
    if (triangles.length === 0) return new Uint32Array(width * height * samples);
    const size = clip ? 4 : 2;
    const scene = { rasterproof_scene: 1, width, height, vertices: [], triangles: [] };
    for (let v = 0; v < vertices.length; v += 4)
      scene.vertices.push(Array.from(vertices.subarray(v, v + size)));
    for (let t = 0; t < triangles.length; t += 3)
      scene.triangles.push(Array.from(triangles.subarray(t, t + 3)));
    return Uint32Array.from(engine.draw(method, scene).counts);
  };
}

const cross = (a, b) => a[0] * b[1] - b[0] * a[1];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

// Fragments with the values of channels and their derivatives, in double. weigh(e, w): of the edge
// values and the corners' w what adds up to a value in perspective.
const shaded = (weigh) => (request) => {
  const { width, height, triangles, channels } = request;
  const size = width * height;
  const shown = {
    ids: new Int32Array(size).fill(-1),
    barycentrics: new Float64Array(3 * size),
    depths: new Float64Array(size),
    values: new Float64Array(size * channels.length),
    derivatives: new Float64Array(2 * size * channels.length),
  };
  for (let t = 0; t < triangles.length; t += 3) {
    const v = corners(request, t);
    const w = v.map((corner) => corner[3]);
    for (let k = 0; k < size; ++k) {
      const [x, y] = [(k % width) + 0.5, Math.floor(k / width) + 0.5];
      const d = v.map((corner) => [corner[0] - x * corner[3], corner[1] - y * corner[3]]);
      const e = [0, 1, 2].map((i) => cross(d[(i + 1) % 3], d[(i + 2) % 3]));
      const area = dot(e, w);
      if (area === 0 || e.some((one) => Math.sign(area) * one < 0)) continue;
      const weights = weigh(e, w);
      const sum = weights[0] + weights[1] + weights[2];
      const [along, down] = [1, 0].map((axis) =>
        [0, 1, 2].map((i) => {
          const [b, c] = [(i + 1) % 3, (i + 2) % 3];
          return (axis === 1 ? 1 : -1) * (w[c] * d[b][axis] - w[b] * d[c][axis]);
        }),
      );
      shown.ids[k] = t / 3;
      shown.barycentrics.set(weights.map((one) => one / sum), 3 * k);
      shown.depths[k] = dot(e, v.map((corner) => corner[2])) / area;
      channels.forEach(({ values }, c) => {
        const a = [0, 1, 2].map((i) => values[triangles[t + i]]);
        const value = dot(weights, a) / sum;
        const apart = a.map((one) => one - value);
        shown.values[k * channels.length + c] = value;
        shown.derivatives.set([dot(along, apart) / sum, dot(down, apart) / sum], 2 * (k * channels.length + c));
      });
    }
  }
  return shown;
};
const VALUES = {
  name: "javascript",
  contract: "none",
  values: { weights: "perspective", derivatives: "analytic", error: { ulps: 1 }, derivative_error: { ulps: 1, conditions: 1 } },
};
const showsValues = {
  profile: VALUES,
  takes: ["window", "clip", "wants"],
  coverage: "fragments",
  shows: ["values", "derivatives"],
};

export const rasterizers = {
  right: { profile: "d3d11-canonical", takes: ["window"], make: () => snapped(8, topLeft) },
  "bottom-right": { profile: "vulkan", takes: ["window"], make: () => snapped(8, (x, y) => !topLeft(x, y)) },
  // The search for causes draws much: of one.
  "half-bits": { profile: "d3d11", takes: ["window"], causes: true, make: () => snapped(4, topLeft) },
  open: { profile: "real", takes: ["window"], make: () => byPixels(open) },
  stepped: { profile: "real", takes: ["window"], make: () => byMethod("f32-incremental") },
  perspective: { ...showsValues, make: () => shaded((e) => e) },
  affine: { ...showsValues, make: () => shaded((e, w) => e.map((one, i) => one * w[i])) },
  homogeneous: { profile: "real", takes: ["clip"], causes: true, make: () => byMethod("hom-scaled-f32") },
};
