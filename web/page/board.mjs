/**
 * A picture of a scene's samples: squares for pixels, dots for their centres, triangles over them.
 * It shows at most MOST_SHOWN pixels a side, and a margin in which corners can lie.
 *
 * @typedef {object} View  In pixels of the target.
 * @property {number} x
 * @property {number} y
 * @property {number} width
 * @property {number} height
 */

export const MOST_SHOWN = 64;
const MARGIN = 1;
const SQUARES = ["once", "more", "missing", "unexpected"];

export function svg(name, attributes, children = []) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...children);
  return element;
}

/** What of a line lies in the box, or null (Liang and Barsky). */
function clipped([ax, ay], [bx, by], {left, top, right, bottom}) {
  let [from, to] = [0, 1];
  const [dx, dy] = [bx - ax, by - ay];
  for (const [p, q] of [[-dx, ax - left], [dx, right - ax], [-dy, ay - top], [dy, bottom - ay]]) {
    if (p === 0 && q < 0) return null;
    if (p < 0) from = Math.max(from, q / p);
    if (p > 0) to = Math.min(to, q / p);
  }
  if (!(from <= to)) return null;
  return [ax + from * dx, ay + from * dy, ax + to * dx, ay + to * dy];
}

/** @param {View} view */
function boxOf({x, y, width, height}) {
  const [left, top] = [x - MARGIN, y - MARGIN];
  return {left, top, right: x + width + MARGIN, bottom: y + height + MARGIN};
}

/** What the pixel is, against the exact count: differences have shapes of their own. */
function kindOf(count, exact) {
  if (count < exact) return "missing";
  if (count > exact) return "unexpected";
  return count === 0 ? null : count === 1 ? "once" : "more";
}

export class Board {
  #parts;
  #title;
  #view = {x: 0, y: 0, width: 1, height: 1};

  /** @param {string} label  What a screen reader says of it. */
  constructor(label) {
    this.#parts = Object.fromEntries([
      ...SQUARES.map((name) => [name, svg("path", {class: `square ${name}`})]),
      ["grid", svg("path", {class: "grid"})],
      ["centres", svg("path", {class: "centres"})],
      ["signs", svg("path", {class: "signs"})],
      ["texts", svg("g", {class: "texts"})],
      ["edges", svg("path", {class: "edges"})],
      ["ties", svg("path", {class: "ties"})],
      ["cursor", svg("rect", {class: "cursor", width: 1, height: 1})],
    ]);
    this.corners = svg("g", {});
    this.svg = svg("svg", {class: "board", "aria-label": label},
        [...Object.values(this.#parts), this.corners]);
    this.#title = document.createElement("figcaption");
    this.figure = document.createElement("figure");
    this.figure.append(this.#title, this.svg);
  }

  get title() {
    return this.#title.textContent;
  }
  set title(text) {
    this.#title.textContent = text;
  }

  /** Where the pointer is, in pixels of the target. */
  at(event) {
    const point = new DOMPoint(event.clientX, event.clientY)
        .matrixTransform(this.svg.getScreenCTM().inverse());
    return [point.x, point.y];
  }

  /** A corner's place on the board: those that lie elsewhere are at its border. */
  place([x, y]) {
    const {left, top, right, bottom} = boxOf(this.#view);
    const inset = 0.3;
    return [Math.min(Math.max(x, left + inset), right - inset),
      Math.min(Math.max(y, top + inset), bottom - inset)];
  }

  /**
   * @param {{view: View, width: number, counts: number[]|null, exact: number[],
   *     lines: [number[], number[]][], ties: [number, number][], cursor: [number, number]}} what
   */
  show({view, width, counts, exact, lines, ties, cursor}) {
    this.#view = view;
    const box = boxOf(view);
    const sides = [box.left, box.top, box.right - box.left, box.bottom - box.top];
    this.svg.setAttribute("viewBox", sides.join(" "));
    const squares = Object.fromEntries(SQUARES.map((name) => [name, ""]));
    let [centres, signs] = ["", ""];
    const texts = [];
    for (let y = view.y; y < view.y + view.height; ++y) {
      for (let x = view.x; x < view.x + view.width; ++x) {
        centres += `M${x + 0.5} ${y + 0.5}h0`;
        if (!counts) continue;
        const count = counts[y * width + x];
        const kind = kindOf(count, exact[y * width + x]);
        if (kind) squares[kind] += `M${x} ${y}h1v1h-1z`;
        if (kind === "missing" || kind === "unexpected") signs += `M${x + 0.1} ${y + 0.25}h.3`;
        if (kind === "unexpected") signs += `M${x + 0.25} ${y + 0.1}v.3`;
        if (count < 2) continue;
        const place = {x: x + 0.95, y: y + 0.95};
        texts.push(svg("text", {...place, class: kind}, [String(count)]));
      }
    }
    const set = (name, d) => this.#parts[name].setAttribute("d", d);
    for (const [name, d] of Object.entries(squares)) set(name, d);
    set("centres", centres);
    set("signs", signs);
    this.#parts.texts.replaceChildren(...texts);
    set("grid", gridOf(view));
    set("edges", lines.map(([a, b]) => clipped(a, b, box)).filter(Boolean)
        .map(([ax, ay, bx, by]) => `M${ax} ${ay}L${bx} ${by}`).join(""));
    set("ties", ties.map(([x, y]) => `M${x + 0.5} ${y + 0.28}l.22 .22l-.22 .22l-.22 -.22z`)
        .join(""));
    const [x, y] = cursor;
    for (const [key, value] of Object.entries({x, y})) {
      this.#parts.cursor.setAttribute(key, value);
    }
  }
}

function gridOf({x, y, width, height}) {
  let d = "";
  for (let k = 0; k <= width; ++k) d += `M${x + k} ${y}v${height}`;
  for (let k = 0; k <= height; ++k) d += `M${x} ${y + k}h${width}`;
  return d;
}
