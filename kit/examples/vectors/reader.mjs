// Judges a rasterizer of whole numbers by vectors: 8 subpixel bits, one sample, y down.
// usage: node reader.mjs VECTORS.jsonl [inclusive]     inclusive: a wrong tie rule, is convicted
import { readFileSync } from "node:fs";

// The reader: load, compare, say what contradicts. A sample is covered if its bit of a row is 1.
const bit = (top, rows, x, y) => Number(BigInt(`0x${rows[y - top] ?? "0"}`) >> BigInt(x) & 1n);

function* contradictions(line, drawn) {
  if ("joint" in line) { // of the case above it
    const count = line.triangles.filter((t) => drawn[t](line.column, line.row)).length;
    if (!line.counts.includes(count))
      yield `${line.joint} column ${line.column} row ${line.row}: ${line.says}: ${line.clauses}`;
    return;
  }
  for (const [n, t] of line.triangles.entries()) for (let y = 0; y < line.height; ++y)
    for (let x = 0; x < line.width; ++x) {
      const must = bit(t.must_top, t.must, x, y);
      if (drawn[n](x, y) !== must && !bit(t.may_top, t.may, x, y))
        yield `${line.case} triangle ${n} column ${x} row ${y}: ` +
            `must${must ? "" : " not"} be covered: ${line.clauses}`;
    }
}

function judge([head, ...lines], draw) {
  if (head.rasterproof_vectors !== 1 || head.lattice_bits !== 8) throw new Error("other vectors");
  let cases = 0, wrong = 0, drawn = null;
  for (const line of lines) {
    if ("case" in line) // without `fixed` a vertex lies between points of the lattice
      drawn = line.fixed && line.triangles.map((t) => draw(line, t.vertices));
    if ("case" in line && drawn) cases += 1;
    for (const text of drawn ? contradictions(line, drawn) : []) { wrong += 1; console.log(text); }
  }
  console.log(`${wrong ? `${wrong} contradictions` : "no contradiction"} in ${cases} cases`);
  return wrong || !cases ? 1 : 0;
}

// Your rasterizer in place of this one. All numbers in 1/256 pixel; the rule is top-left. BigInt:
// products of the largest coordinates have 66 bits.
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

const [path, rule] = process.argv.slice(2);
const drawTriangle = (line, vertices) => { // 1 at the samples that it covers
  const corners = vertices.map((k) => line.fixed[k]);
  return (x, y) => Number(covers(corners, 256 * x + 128, 256 * y + 128, rule === "inclusive"));
};
const text = readFileSync(path, "utf8").trim();
process.exit(judge(text.split("\n").map((l) => JSON.parse(l)), drawTriangle));
