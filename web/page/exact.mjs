/** Exact arithmetic on coordinates, which are integers times a power of two: as BigInts. */

const FRACTION_BITS = 52;

/** A finite number as an integer and an exponent of two. */
function dyadic(x) {
  const view = new DataView(new ArrayBuffer(8));
  view.setFloat64(0, x);
  const bits = view.getBigUint64(0);
  const biased = Number((bits >> 52n) & 0x7ffn);
  const fraction = bits & ((1n << 52n) - 1n);
  const size = biased === 0 ? fraction : fraction | (1n << 52n);
  if (size === 0n) return [0n, 0];
  return [x < 0 ? -size : size, Math.max(biased, 1) - 1023 - FRACTION_BITS];
}

/** Points as integers on one scale: each is its integer times 2 ** exponent. */
export function scaled(points) {
  const parts = points.map((point) => point.map(dyadic));
  const exponent = Math.min(...parts.flat().map(([, e]) => e));
  const shifted = parts.map((point) => point.map(([n, e]) => n << BigInt(e - exponent)));
  return {points: shifted, exponent};
}

/** Edges' values at a point, each opposite its corner, in integers. */
export function edgesAt(corners, point) {
  return [0, 1, 2].map((k) => {
    const [a, b] = [corners[(k + 1) % 3], corners[(k + 2) % 3]];
    const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
    return {value: (point[0] - a[0]) * dy - (point[1] - a[1]) * dx, dx, dy};
  });
}

export const areaOf = (edges) => edges[0].value + edges[1].value + edges[2].value;

/** Whether the point lies on the boundary of a triangle that has an area. */
export function isTie(corners, point) {
  const edges = edgesAt(corners, point);
  const area = areaOf(edges);
  if (area === 0n) return false;
  const inward = edges.map(({value}) => area > 0n ? value : -value);
  return inward.every((value) => value >= 0n) && inward.some((value) => value === 0n);
}
