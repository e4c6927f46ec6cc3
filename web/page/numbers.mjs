/** The numbers at a pixel: edge values and barycentrics, exact and as a method computes them. */

const MOST_TRIANGLES = 4;
const LONGEST = 44;

function made(name, held, attributes = {}) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...[held].flat());
  return element;
}

/** The triangles nearest to a point: those that it is in, or outside of by least. */
export function nearest(triangles, [x, y]) {
  const insideBy = (corners) => {
    const edge = ([ax, ay], [bx, by]) => (x - ax) * (by - ay) - (y - ay) * (bx - ax);
    const [a, b, c] = corners;
    const values = [edge(b, c), edge(c, a), edge(a, b)];
    const area = values[0] + values[1] + values[2];
    const least = Math.min(...values.map((value) => value / area));
    return Number.isFinite(least) ? least : -Infinity;
  };
  return triangles.map(({corners}, k) => ({k, by: insideBy(corners)}))
      .sort((a, b) => b.by - a.by || a.k - b.k).slice(0, MOST_TRIANGLES).map(({k}) => k)
      .sort((a, b) => a - b);
}

/** Whether a fraction of so few digits that a double holds it is k / 2 ** n. */
function isDyadic(exact) {
  const bottom = Number(exact.split("/")[1]);
  return exact.length < 15 && Number.isInteger(Math.log2(bottom));
}

/** An exact number with what it is near, if that is shorter to read. */
function exactCell(exact, near) {
  const cut = `${exact.slice(0, LONGEST - 16)}… (${exact.length} digits)`;
  const text = exact.length > LONGEST ? cut : exact;
  const cell = made("td", text, {class: "number", title: exact});
  const short = Number(near.toPrecision(6));
  if (exact.includes("/")) {
    // Of a power of two the double is exact, unless it is rounded.
    const isExact = short === near && isDyadic(exact);
    cell.append(made("span", ` ${isExact ? "=" : "≈"} ${short}`, {class: "why"}));
  }
  return cell;
}

function methodCell(value, exact) {
  if (value === undefined || value === null) return made("td", "–", {class: "number none"});
  const isWrong = Math.sign(value) !== Math.sign(exact);
  return made("td", `${value}${isWrong ? " (other sign)" : ""}`,
      {class: isWrong ? "number wrong" : "number"});
}

function said(decided, isTie) {
  if (decided.facing === undefined) return "";
  const covers = decided.covers === "must" ? "covers this pixel" : "does not cover this pixel";
  return `${covers}${isTie ? "; the centre is on its boundary" : ""}`;
}

/**
 * @param {{k: number, indices: number[], decided: object, edges: number[]|null, isTie: boolean}[]}
 *     rows  decided: the engine's answer to covers().
 */
export function numbersTable(rows, method) {
  const body = rows.flatMap(({k, indices, decided, edges, isTie}) => {
    const head = made("tr", made("th", [made("b", `Triangle ${k}`), ` ${said(decided, isTie)}`],
        {colspan: 4, scope: "rowgroup"}));
    if (!decided.edges) return [head];
    return [head, ...[0, 1, 2].map((corner) => {
      const [a, b] = [indices[(corner + 1) % 3], indices[(corner + 2) % 3]];
      const weight = decided.barycentrics_exact;
      return made("tr", [
        made("th", `edge ${a} to ${b}`, {scope: "row"}),
        exactCell(decided.edges_exact[corner], decided.edges[corner]),
        methodCell(edges?.[corner], decided.edges[corner]),
        weight ? exactCell(weight[corner], decided.barycentrics[corner]) :
                 made("td", "no area", {class: "none"}),
      ]);
    })];
  });
  const head = ["Edge", "E exactly", `E by ${method}`, "Weight exactly"].map((text, k) => {
    return made("th", text, {scope: "col", ...(k > 0 && {class: "number"})});
  });
  return made("table", [made("thead", made("tr", head)), made("tbody", body)]);
}
