// Judges a rasterizer of whole numbers by vectors: 8 subpixel bits, one sample, y down.
// usage: node reader.mjs VECTORS.jsonl [inclusive]     inclusive: a wrong tie rule, is convicted
import { readFileSync } from "node:fs";

// Your rasterizer in its place. All numbers in 1/256 pixel; the rule is top-left. BigInt: products
// of the largest coordinates have 66 bits.
function covers(corners, x, y, inclusive) {
  const [a, b, c] = corners.map(([u, v]) => [BigInt(u), BigInt(v)]);
  const area = (c[0] - a[0]) * (b[1] - a[1]) - (c[1] - a[1]) * (b[0] - a[0]);
  const edges = area > 0n ? [[a, b], [b, c], [c, a]] : [[a, c], [c, b], [b, a]];
  return area !== 0n && edges.every(([p, q]) => {
    const [dx, dy] = [q[0] - p[0], q[1] - p[1]];
    const e = (BigInt(x) - p[0]) * dy - (BigInt(y) - p[1]) * dx;
    return e > 0n || (e === 0n && (inclusive || dy > 0n || (dy === 0n && dx < 0n)));
  });
}

const bit = (top, rows, x, y) => {
  const row = rows[y - top] ?? "";
  return parseInt(row[row.length - 1 - (x >> 2)] ?? "0", 16) >> (x & 3) & 1;
};

const [path, rule] = process.argv.slice(2);
const [head, ...lines] = readFileSync(path, "utf8").trim().split("\n").map((l) => JSON.parse(l));
if (head.rasterproof_vectors !== 1 || head.lattice_bits !== 8) throw new Error("other vectors");
let cases = 0;
let wrong = 0;
let drawn = [];
const say = (text) => { wrong += 1; console.log(text); };
for (const v of lines) {
  if ("joint" in v) { // of the case above it
    const count = v.triangles.filter((t) => drawn.length && drawn[t][v.row][v.column]).length;
    if (drawn.length && !v.counts.includes(count))
      say(`${v.joint} column ${v.column} row ${v.row}: ${v.says}: ${v.clauses}`);
    continue;
  }
  drawn = [];
  if (v.fixed === null) continue; // a vertex lies between points of the lattice
  cases += 1;
  for (const t of v.triangles) {
    const corners = t.vertices.map((k) => v.fixed[k]);
    const rows = Array.from({ length: v.height }, (_, y) => Array.from({ length: v.width },
      (_, x) => Number(covers(corners, 256 * x + 128, 256 * y + 128, rule === "inclusive"))));
    drawn.push(rows);
    rows.forEach((row, y) => row.forEach((covered, x) => {
      const must = bit(t.must_top, t.must, x, y);
      if (covered !== must && !bit(t.may_top, t.may, x, y))
        say(`${v.case} triangle ${drawn.length - 1} column ${x} row ${y}: ` +
            `${must ? "must" : "must not"} be covered: ${v.clauses}`);
    }));
  }
}
console.log(wrong ? `${wrong} contradictions in ${cases} cases` : `no contradiction in ${cases} cases`);
process.exit(wrong || !cases ? 1 : 0);
