/** Where corners and samples of the playground lie. */
import {isTie, scaled} from "./exact.mjs";
import {MOST_SHOWN} from "./board.mjs";

/** The float32 number `count` steps from x. */
function ulps(x, count) {
  const view = new DataView(new ArrayBuffer(4));
  view.setFloat32(0, x);
  const bits = view.getInt32(0);
  // Numbers in order have places in order; both zeros have the place 0.
  const place = (bits < 0 ? -(bits & 0x7fffffff) : bits) + count;
  view.setInt32(0, place < 0 ? -place : place);
  const moved = view.getFloat32(0);
  if (!Number.isFinite(moved)) return x;
  return place < 0 ? -moved : moved;
}

/** A coordinate moved by steps to the next multiples of 1 / size, or by ulps. */
export function stepped(x, count, step) {
  if (count === 0) return x;
  if (step === "ulp") return ulps(x, count);
  const on = x * Number(step);
  return ((count > 0 ? Math.floor(on) : Math.ceil(on)) + count) / Number(step);
}

/** A coordinate rounded to what steps reach. */
export function snapped(x, step) {
  return step === "ulp" ? Math.fround(x) : Math.round(x * Number(step)) / Number(step);
}

/** Where a vertex lies in the window; null if nowhere. */
export function windowPoint([x, y, , w = 1]) {
  const point = [x / w, y / w];
  return w > 0 && point.every(Number.isFinite) ? point : null;
}

/** The vertex with its window point there. */
export function movedTo(vertex, [x, y], precision) {
  const w = vertex.length === 4 ? vertex[3] : 1;
  const round = precision === "float32" ? Math.fround : (number) => number;
  return [round(x * w), round(y * w), ...vertex.slice(2)];
}

/** Whether a point is on no edge, by far more than doubles round. */
function isFar(corners, [x, y]) {
  return corners.every(([ax, ay], k) => {
    const [bx, by] = corners[(k + 1) % 3];
    const [left, right] = [(x - ax) * (by - ay), (y - ay) * (bx - ax)];
    return Math.abs(left - right) > 1e-12 * (Math.abs(left) + Math.abs(right));
  });
}

/** The pixels of the view whose centre is on a triangle's boundary. */
export function tiesOf(triangles, view) {
  const found = new Map();
  for (const {corners} of triangles) {
    if (!corners.flat().every(Number.isFinite)) continue;
    // Centres are on the same scale: halves.
    const {points, exponent} = scaled([...corners, [0.5, 0.5]]);
    const one = 1n << BigInt(-exponent);
    const reach = (axis) => {
      const of = corners.map((corner) => corner[axis]);
      const [from, size] = axis === 0 ? [view.x, view.width] : [view.y, view.height];
      return [Math.max(from, Math.floor(Math.min(...of) - 1)),
        Math.min(from + size - 1, Math.ceil(Math.max(...of)))];
    };
    const [left, right] = reach(0);
    const [top, bottom] = reach(1);
    for (let y = top; y <= bottom; ++y) {
      for (let x = left; x <= right; ++x) {
        if (isFar(corners, [x + 0.5, y + 0.5])) continue;
        const centre = [points[3][0] + BigInt(x) * one, points[3][1] + BigInt(y) * one];
        if (isTie(points.slice(0, 3), centre)) found.set(`${x},${y}`, [x, y]);
      }
    }
  }
  return [...found.values()];
}

/** The pixel to look at first: where the pictures differ, else in the middle of what is drawn. */
export function firstLook({width, height}, exact, drawn) {
  const differing = exact.counts.findIndex((n, k) => drawn && n !== drawn.counts[k]);
  if (differing >= 0) return [differing % width, Math.floor(differing / width)];
  const covered = exact.counts.flatMap((n, k) => n > 0 ? [k] : []);
  const k = covered[covered.length >> 1] ?? (height >> 1) * width + (width >> 1);
  return [k % width, Math.floor(k / width)];
}

/** What is shown of a large target: so much of the last view as has the cursor in it. */
export function viewOf(view, {width, height}, cursor) {
  const sizes = [width, height].map((side) => Math.min(side, MOST_SHOWN));
  const [x, y] = [view?.x ?? 0, view?.y ?? 0].map((start, axis) => {
    const last = [width, height][axis] - sizes[axis];
    return Math.min(Math.max(Math.min(start, cursor[axis]), cursor[axis] - sizes[axis] + 1), last);
  });
  return {x, y, width: sizes[0], height: sizes[1]};
}
