"use strict";
// Of every page, which says all that it says without it.

// The headings of a `table.sorts` sort it. A first click on numbers brings the largest up, on words
// the first of the alphabet; a second one turns the order. Cells without a number stay below.
function keyOf(row, column, isNumber) {
  const text = row.cells[column].textContent;
  return isNumber ? parseFloat(text.replace(/\s/g, "")) : text;
}
function sortBy(table, head, column) {
  const isNumber = head.classList.contains("number");
  const first = isNumber ? "descending" : "ascending";
  const other = isNumber ? "ascending" : "descending";
  const order = head.getAttribute("aria-sort") === first ? other : first;
  for (const cell of head.parentNode.cells) cell.removeAttribute("aria-sort");
  head.setAttribute("aria-sort", order);
  const sign = order === "ascending" ? 1 : -1;
  const rows = Array.from(table.tBodies[0].rows);
  rows.sort((a, b) => {
    const x = keyOf(a, column, isNumber), y = keyOf(b, column, isNumber);
    if (!isNumber) return sign * x.localeCompare(y);
    return isNaN(x) - isNaN(y) || (isNaN(x) ? 0 : sign * (x - y));
  });
  table.tBodies[0].append(...rows);
}
for (const table of document.querySelectorAll("table.sorts")) {
  Array.from(table.tHead.rows[0].cells).forEach((head, column) => {
    const button = document.createElement("button");
    button.append(...head.childNodes);
    button.addEventListener("click", () => sortBy(table, head, column));
    head.append(button);
  });
}

// Sections on error against run time: reads what the page holds as data; draws the plot again for
// each choice, with names beside the points of the frontier where they cover nothing, and fills the
// table. Files are made of what is shown.
(() => {
// The cell chosen of the matrix of cliffs: what it says, and the commands that show it.
const cliffs = document.getElementById("cliffs");
function chooseCell(cell) {
  const before = cliffs.querySelector("td[tabindex='0']");
  before.tabIndex = -1;
  before.removeAttribute("aria-selected");
  cell.tabIndex = 0;
  cell.setAttribute("aria-selected", "true");
  const text = document.createElement("p");
  text.textContent = `${cell.parentNode.cells[0].textContent} over ${cell.dataset.said}.`;
  const commands = document.getElementById(cell.dataset.case);
  document.getElementById("cliff-shown").replaceChildren(text,
    ...(commands ? commands.cloneNode(true).querySelectorAll("pre") : []));
}
function cellBeside(cell, key) {
  const steps = {ArrowRight: [1, 0], ArrowLeft: [-1, 0], ArrowDown: [0, 1], ArrowUp: [0, -1]};
  if (!steps[key]) return null;
  const [across, down] = steps[key];
  let next = cell;
  do {
    next = cliffs.rows[next.parentNode.rowIndex + down]?.cells[next.cellIndex + across];
  } while (next && next.localName === "td" && !next.dataset.said);
  return next?.localName === "td" ? next : null;
}
if (cliffs) {
  cliffs.setAttribute("role", "grid");
  const cells = cliffs.querySelectorAll("td[title]");
  for (const cell of cells) {
    cell.dataset.said = cell.title;
    cell.tabIndex = -1;
    cell.addEventListener("focus", () => chooseCell(cell));
    cell.addEventListener("keydown", (event) => {
      const next = cellBeside(cell, event.key);
      if (!next) return;
      event.preventDefault();
      next.focus();
    });
  }
  cells[0].tabIndex = 0;
  document.getElementById("cliff-shown").textContent =
    "Choose a cell, or tab to one and go on with the arrows: its failing case is shown here.";
  const list = document.getElementById("cliff-cases");
  if (list) list.hidden = true;
}

const data = document.getElementById("bench-data");
if (!data) return;
const bench = JSON.parse(data.textContent);
const pick = document.getElementById("bench-pick");
const holder = document.getElementById("bench-plot");
const said = document.getElementById("bench-said");
const PROVED = 0, NONE = 1, RATE = 2, LOST = 3, NOT_JUDGED = 4;
const COLOURS = {"float32": ["f32", "#0072b2"], "float64": ["f64", "#56b4e9"],
  "fixed point": ["fixed", "#e69f00"], "exact": ["exact", "#009e73"],
  "yours": ["yours", "#d55e00"]};
const KINDS = Object.keys(COLOURS);

function grouped(count) { return String(count).replace(/\B(?=(\d{3})+$)/g, "\u202f"); }
function number(value) {
  if (value === null) return "–";
  if (value >= 999.5) return grouped(Math.round(value));
  return value >= 1e-4 || value === 0 ? String(+value.toPrecision(3)) : value.toExponential(1);
}
function methodOf(row) { return bench.methods[row.m]; }
function familyOf(row) { return bench.families[row.f]; }
function kindOf(row) {
  const method = methodOf(row);
  return method.yours ? "yours" : KINDS.includes(method.kind) ? method.kind : "float32";
}
function nameOf(row) { return methodOf(row).full + (methodOf(row).yours ? " (yours)" : ""); }
function wrongText(row) {
  if (!row.judged) return "–";
  if (row.e[0][0] === PROVED) return "0, proved";
  return `${grouped(row.wrong)} of ${grouped(row.pairs)}`;
}
function remark(row) {
  const notes = [];
  const method = methodOf(row), family = familyOf(row);
  if (method.yours) notes.push("yours");
  if (method.limit < family.reach) notes.push(`states nothing beyond ${number(method.limit)} px`);
  else if (row.judged && !row.rival && row.wrong) notes.push("1 % wrong or more");
  if (row.lost) notes.push("whole triangles lost");
  if (row.store) notes.push("bound by storing");
  return notes.join("; ");
}
// In the order of the table's columns.
function cellsOf(row) {
  const method = methodOf(row), judged = row.judged;
  return [method.name, method.target, method.sink, number(row.ns),
    `${number(row.ratio[1])} [${number(row.ratio[0])}, ${number(row.ratio[2])}]`, wrongText(row),
    judged ? number(row.e[2][1]) : "–", judged ? grouped(row.own) : "–",
    judged ? grouped(row.leaks) : "–", number(row.e[4][0] === NOT_JUDGED ? null : row.e[4][1]),
    String(method.bytes), remark(row)];
}

// What the pickers choose.
function choice() {
  const of = (name) => pick.elements[name];
  return {family: +of("family").value, error: +of("error").value, sink: of("sink").value,
    target: of("target").value, bytes: +(of("bytes").value || Infinity),
    tight: of("tight").checked, exact: of("exact").checked};
}
function chosen(what) {
  return bench.rows.filter((row) => {
    const method = methodOf(row);
    return row.f === what.family && method.sink === what.sink && method.bytes <= what.bytes &&
      (!what.target || method.target === what.target) &&
      (!what.tight || (row.judged && row.leaks === 0)) &&
      (!what.exact || (row.judged && row.own === 0));
  });
}

function node(parent, name, attributes, text) {
  const made = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const key in attributes) made.setAttribute(key, attributes[key]);
  if (text !== undefined) made.textContent = text;
  parent.append(made);
  return made;
}
// On the page the colours turn with the paper; a file by itself shows the ones after the commas.
const STYLE = ".big text{font:12px system-ui,'Noto Sans','DejaVu Sans',sans-serif;" +
  "fill:var(--ink,#23262d)}.big .soft{fill:var(--soft,#626975)}.big .named{font-weight:600;" +
  "paint-order:stroke;stroke:var(--card,#fff);stroke-width:3}" +
  ".big .grid{stroke:var(--line,#e3e5e9)}.big .lane{stroke:var(--soft,#626975);" +
  "stroke-dasharray:3 3}.big .whisker{stroke:var(--ink,#23262d)}.big .lead{stroke:" +
  "var(--soft,#626975);stroke-width:.7}.big .front{fill:none;stroke:var(--exact,#009e73);" +
  "stroke-width:1.6;opacity:.7}.big g[tabindex]:focus{outline:none}.big .ring{fill:none;" +
  "stroke:var(--ink,#23262d);stroke-width:1.5;opacity:0}.big g:hover>.ring,.big g:focus>.ring" +
  "{opacity:1}" + KINDS.map((kind) => {
    const [name, colour] = COLOURS[kind];
    return `.big .${name}{stroke:var(--${name},${colour});fill:var(--${name},${colour});` +
      "stroke-width:1.5}";
  }).join("") + ".big .hollow{fill:none}.big .pointed{stroke-width:6}";
const SHAPES = {
  "float32": "M-5 0a5 5 0 1 0 10 0a5 5 0 1 0 -10 0z", "float64": "M0 5.5l5.5 -10h-11z",
  "fixed point": "M-4.5 -4.5h9v9h-9z", "exact": "M0 -5.5l5.5 10h-11z",
  "yours": "M0 -8l8 8l-8 8l-8 -8z"};
function mark(parent, kind, x, y, isHollow) {
  node(parent, "path", {d: SHAPES[kind], transform: `translate(${x.toFixed(1)} ${y.toFixed(1)})`,
    class: COLOURS[kind][0] + (isHollow ? " hollow" : "")});
}

const PAD = {left: 92, right: 24, top: 18, rates: 250, lane: 62, foot: 64};
function scaleOf(low, high, from, to) {
  const span = Math.log(high / low);
  return (value) => from + (to - from) * Math.log(value / low) / span;
}
// 1, 5 and 2 times powers of ten, as far as there is room of `least` between them.
function ticks(low, high, place, least) {
  const all = [];
  for (const digit of [1, 5, 2]) {
    for (let k = Math.floor(Math.log10(low)); k <= Math.log10(high); ++k) {
      const value = digit * Math.pow(10, k);
      const at = place(value);
      if (value < low || value > high) continue;
      if (all.every((other) => Math.abs(other.at - at) >= least)) all.push({value, at});
    }
  }
  return all;
}
function rateText(value, unit) {
  const short = (number) => +number.toPrecision(3);
  if (unit === "px") return value >= 1e-3 ? `${short(value)} px` : `${value.toExponential(0)} px`;
  return value >= 1e-3 ? `${short(100 * value)} %` : `${short(1e6 * value)} in 10⁶`;
}
// In a lane points of equal error lie beside each other, not upon each other.
function spread(points, top, height) {
  const ends = [];
  for (const point of points.sort((a, b) => a.x - b.x)) {
    let k = ends.findIndex((end) => point.x - end >= 13);
    if (k < 0) k = ends.push(-Infinity) - 1;
    ends[k] = point.x;
    point.level = k;
  }
  const step = Math.min(13, (height - 14) / Math.max(1, ends.length - 1));
  for (const point of points) {
    point.y = top + height / 2 + (point.level - (ends.length - 1) / 2) * step;
  }
}
function boxesMeet(a, b) {
  return a.x < b.x + b.w && b.x < a.x + a.w && a.y < b.y + b.h && b.y < a.y + a.h;
}
function isWithin(box, limits) {
  return box.x >= limits.x && box.x + box.w <= limits.x + limits.w &&
    box.y >= limits.y && box.y + box.h <= limits.y + limits.h;
}
// Writes the name where it covers no point and no name; farther off, with a line that leads there.
function writeName(parent, point, name, taken, limits) {
  const text = node(parent, "text", {class: "named"}, name);
  const w = text.getComputedTextLength() + 6, h = 16;
  for (let off = 0; off < 14; ++off) {
    for (const [across, down] of [[1, 0], [-1, 0], [0, -1], [0, 1], [1, -1], [1, 1], [-1, 1],
                                  [-1, -1]]) {
      const dx = across * (w / 2 + 9 + 10 * off), dy = down * (h / 2 + 9 + 9 * off);
      const box = {x: point.x + dx - w / 2, y: point.y + dy - h / 2, w, h};
      if (!isWithin(box, limits) || taken.some((other) => boxesMeet(box, other))) continue;
      taken.push(box);
      text.setAttribute("x", box.x + 3);
      text.setAttribute("y", box.y + 12);
      if (off === 0) return;
      const x = Math.max(box.x, Math.min(point.x, box.x + w));
      const y = Math.max(box.y, Math.min(point.y, box.y + h));
      node(parent, "path", {class: "lead", d: `M${point.x} ${point.y}L${x} ${y}`});
      return;
    }
  }
  text.remove();
}

// Names the point where it lies, and says below what is known of it.
function say({row, x, y}, plot, label) {
  label.textContent = nameOf(row);
  const isRight = x + 14 + label.getComputedTextLength() > plot.width;
  label.setAttribute("text-anchor", isRight ? "end" : "start");
  label.setAttribute("x", isRight ? x - 12 : x + 12);
  label.setAttribute("y", y - 8);
  const names = Array.from(document.querySelectorAll("#bench-rows thead th"),
    (head) => head.textContent);
  const facts = cellsOf(row).map((cell, k) => cell && `${names[k]} ${cell}`).slice(2);
  said.textContent = `${nameOf(row)}: ${methodOf(row).summary}. ` +
    `${facts.filter(Boolean).join(", ")}; ${number(row.ms)} ms a frame at 1080p.`;
}

function axes(svg, plot) {
  const {width, bottom, xOf, yOf, error} = plot;
  const right = width - PAD.right;
  for (const {value, at} of ticks(plot.least, plot.most, xOf, 46)) {
    node(svg, "path", {class: "grid", d: `M${at} ${PAD.top}V${bottom}`});
    node(svg, "text", {class: "soft", x: at, y: bottom + 17, "text-anchor": "middle"},
      String(+value.toPrecision(2)));
  }
  const left = (y, text) => node(svg, "text", {class: "soft", x: PAD.left - 8, y: y + 4,
    "text-anchor": "end"}, text);
  for (const {value, at} of plot.hasRates ? ticks(plot.low, plot.high, yOf, 26) : []) {
    node(svg, "path", {class: "grid", d: `M${PAD.left} ${at}H${right}`});
    left(at, rateText(value, error.unit));
  }
  for (const {name, top, height} of plot.lanes) {
    node(svg, "path", {class: "lane", d: `M${PAD.left} ${top}H${right}`});
    left(top + height / 2, name);
  }
  node(svg, "text", {class: "soft", x: PAD.left, y: bottom + 36},
    `time over that of ${plot.family.baseline}, less is faster; bars: 95 % intervals`);
}
function legend(svg, y, rows, width) {
  let x = PAD.left;
  for (const kind of KINDS.filter((one) => rows.some((row) => kindOf(row) === one))) {
    mark(svg, kind, x + 6, y - 4, false);
    x += 30 + node(svg, "text", {x: x + 16, y}, kind).getComputedTextLength();
  }
  if (x > width - 280) return;
  mark(svg, "float32", x + 6, y - 4, true);
  node(svg, "text", {x: x + 16, y}, "hollow: 1 % wrong or past its limit");
}

// Where everything lies: from the top "lost", rates, "on the edge", "0 of N", "proved 0".
function layout(rows, what, width) {
  const errorOf = (row) => row.e[what.error];
  const shown = rows.filter((row) => errorOf(row)[0] !== NOT_JUDGED);
  const isRate = (row) => errorOf(row)[0] === RATE && errorOf(row)[1] > 0;
  const rates = shown.filter(isRate).map((row) => errorOf(row)[1]);
  const plot = {shown, width, error: bench.errors[what.error],
    family: bench.families[what.family], lanes: [], hasRates: rates.length > 0};
  plot.least = Math.min(...shown.map((row) => row.ratio[0])) / 1.12;
  plot.most = Math.max(...shown.map((row) => row.ratio[2])) * 1.12;
  plot.xOf = scaleOf(plot.least, plot.most, PAD.left, width - PAD.right);
  let top = PAD.top;
  const lane = (of, name) => {
    plot.lanes.push({of, name, top, height: PAD.lane});
    top += PAD.lane;
  };
  if (shown.some((row) => errorOf(row)[0] === LOST)) lane(LOST, "lost");
  plot.low = Math.min(...rates) / 2;
  plot.high = Math.max(...rates) * 2;
  plot.yOf = scaleOf(plot.low, plot.high, top + PAD.rates, top);
  if (plot.hasRates) top += PAD.rates;
  if (shown.some((row) => errorOf(row)[0] === RATE && !isRate(row))) lane(RATE, "on the edge");
  lane(NONE, "0 of N");
  lane(PROVED, "proved 0");
  plot.bottom = top;
  plot.points = shown.map((row) => ({row, x: plot.xOf(row.ratio[1]),
    y: isRate(row) ? plot.yOf(errorOf(row)[1]) : 0, front: errorOf(row)[2] === 1}));
  for (const {of, top: from, height} of plot.lanes) {
    spread(plot.points.filter(({row}) => errorOf(row)[0] === of && !isRate(row)), from, height);
  }
  plot.points.sort((a, b) => a.x - b.x);
  return plot;
}

function drawPoints(svg, plot) {
  const front = plot.points.filter((point) => point.front);
  if (front.length > 1) {
    node(svg, "path", {class: "front",
      d: "M" + front.map(({x, y}) => `${x.toFixed(1)} ${y.toFixed(1)}`).join("L")});
  }
  const label = document.createElementNS(svg.namespaceURI, "text");
  label.setAttribute("class", "named pointed");
  plot.points.forEach((point, k) => {
    const {row, x, y} = point;
    const group = node(svg, "g", {tabindex: k === 0 ? 0 : -1, role: "img",
      "aria-label": `${nameOf(row)}, time ${number(row.ratio[1])}, wrong ${wrongText(row)}`});
    node(group, "path", {class: "whisker",
      d: `M${plot.xOf(row.ratio[0]).toFixed(1)} ${y}H${plot.xOf(row.ratio[2]).toFixed(1)}`});
    mark(group, kindOf(row), x, y, !row.rival);
    node(group, "circle", {class: "ring", cx: x, cy: y, r: 9});
    node(group, "circle", {cx: x, cy: y, r: 9, "fill-opacity": 0});
    group.addEventListener("pointerenter", () => say(point, plot, label));
    group.addEventListener("focus", () => say(point, plot, label));
    group.addEventListener("keydown", (event) => {
      const step = {ArrowRight: 1, ArrowLeft: -1}[event.key];
      const next = step && svg.querySelectorAll("g[tabindex]")[k + step];
      if (!next) return;
      event.preventDefault();
      group.setAttribute("tabindex", -1);
      next.setAttribute("tabindex", 0);
      next.focus();
    });
  });
  svg.append(label);
}
function drawNames(svg, plot) {
  const limits = {x: PAD.left + 2, y: PAD.top, w: plot.width - PAD.left - 4,
    h: plot.bottom - PAD.top};
  const taken = plot.points.map(({x, y}) => ({x: x - 6, y: y - 6, w: 12, h: 12}));
  const named = plot.points.filter((point) => point.front || methodOf(point.row).yours);
  for (const point of named) writeName(svg, point, nameOf(point.row), taken, limits);
}

function caption({family, error}) {
  const pairs = error.name.startsWith("leaks") ? family.shared : family.boundary;
  const of = error.unit === "px" ? "" :
    `, of ${grouped(pairs)} pairs${family.constructed ? ", constructed: no rate" : ""}`;
  // The rule of three: N independent draws show an event of a rate above 3 / N with 95 %
  // probability.
  const bound = family.random && of ?
    ` 0 of N bounds the rate by ${(3 / pairs).toPrecision(1)}.` : "";
  return `${family.name}: ${family.summary}. Up: ${error.name}${of}.${bound} ${bench.processor}.`;
}
function drawPlot() {
  const what = choice();
  const width = Math.max(320, holder.clientWidth - 18);
  const plot = layout(chosen(what), what, width);
  holder.textContent = "";
  said.textContent = "Point at a method, or tab to one and go on with the arrows.";
  document.getElementById("bench-caption").textContent = caption(plot);
  if (!plot.shown.length) {
    holder.textContent = "No method here shows this error: choose another, or fewer conditions.";
    return;
  }
  const height = plot.bottom + PAD.foot;
  const svg = node(holder, "svg", {class: "big", width, height, viewBox: `0 0 ${width} ${height}`,
    role: "group", "aria-label": caption(plot)});
  node(svg, "style", {}, STYLE);
  axes(svg, plot);
  drawNames(svg, plot);
  drawPoints(svg, plot);
  legend(svg, plot.bottom + 56, plot.shown, width);
}

const table = document.querySelector("#bench-rows table");
function fillTable() {
  const heads = Array.from(table.tHead.rows[0].cells);
  const rows = chosen(choice()).sort((a, b) => a.ns - b.ns).map((row) => {
    const line = document.createElement("tr");
    cellsOf(row).forEach((text, k) => {
      const cell = document.createElement(k === 0 ? "th" : "td");
      if (k === 0) cell.scope = "row";
      cell.className = k === 0 ? "name" : heads[k].className;
      cell.textContent = text;
      line.append(cell);
    });
    return line;
  });
  table.tBodies[0].replaceChildren(...rows);
  for (const head of heads) head.removeAttribute("aria-sort");
}

function save(name, type, content) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([content], {type}));
  link.download = name;
  link.click();
}
function svgText() { return new XMLSerializer().serializeToString(holder.querySelector("svg")); }
function savePng(name) {
  const svg = holder.querySelector("svg");
  const image = new Image();
  image.addEventListener("load", () => {
    const canvas = document.createElement("canvas");
    canvas.width = 2 * svg.clientWidth;
    canvas.height = 2 * svg.clientHeight;
    const pen = canvas.getContext("2d");
    pen.fillStyle = "#ffffff";
    pen.fillRect(0, 0, canvas.width, canvas.height);
    pen.drawImage(image, 0, 0, canvas.width, canvas.height);
    canvas.toBlob((blob) => save(name, "image/png", blob));
  });
  image.src = "data:image/svg+xml;charset=utf-8," + encodeURIComponent(svgText());
}
function csvText() {
  const quoted = (text) => `"${text.replace(/\u202f/g, "").replace(/"/g, '""')}"`;
  return Array.from(table.rows, (row) => Array.from(row.cells,
    (cell) => quoted(cell.textContent)).join(",")).join("\n") + "\n";
}
document.getElementById("bench-save").addEventListener("click", (event) => {
  const as = event.target.dataset.as;
  const stem = `bench-${bench.families[choice().family].name}`;
  if (as === "csv") save(stem + ".csv", "text/csv", csvText());
  if (!holder.querySelector("svg")) return;
  if (as === "svg") save(stem + ".svg", "image/svg+xml", svgText());
  if (as === "png") savePng(stem + ".png");
});

pick.hidden = document.getElementById("bench-save").hidden = false;
pick.addEventListener("change", () => { drawPlot(); fillTable(); });
pick.addEventListener("submit", (event) => event.preventDefault());
let drawn = 0;
new ResizeObserver(() => {
  if (holder.clientWidth === drawn) return;
  drawn = holder.clientWidth;
  drawPlot();
}).observe(holder);
fillTable();
})();
