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

// Sections on error against run time: shows of the panels and of the table what is chosen, by the
// record that the page holds. Files are made of what is shown.
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
const table = document.querySelector("#bench-rows table");
const methods = bench.rows.map((row) => bench.methods.find(({name, target, sink}) =>
  name === row.method && target === row.target && sink === row.sink));
function grouped(count) { return String(count).replace(/\B(?=(\d{3})+$)/g, "\u202f"); }
// What the pickers choose.
function choice() {
  const of = (name) => pick.elements[name];
  return {family: +of("family").value, error: +of("error").value, sink: of("sink").value,
    target: of("target").value, bytes: +(of("bytes").value || Infinity),
    tight: of("tight").checked, exact: of("exact").checked};
}
function isChosen(row, method, what) {
  const isJudged = "real" in row, own = row.own ?? row.real;
  return row.family === bench.families[what.family].name && method.sink === what.sink &&
    method.vertex_bytes <= what.bytes && (!what.target || method.target === what.target) &&
    (!what.tight || (isJudged && row.gaps + row.overlaps === 0)) &&
    (!what.exact || (isJudged && own.missing + own.unexpected === 0));
}

function panelOf({family}) { return holder.children[family].firstElementChild; }
function shownPoints(panel) { return panel.querySelectorAll(".point:not(.off)"); }

// Names the point where it lies, and says below what is known of it.
function say(point) {
  const panel = point.ownerSVGElement, {e: x, f: y} = point.transform.baseVal[0].matrix;
  panel.querySelector(".pointed")?.remove();
  const label = document.createElementNS(panel.namespaceURI, "text");
  label.setAttribute("class", "named pointed");
  label.textContent = point.getAttribute("aria-label");
  panel.append(label);
  const isRight = x + 14 + label.getComputedTextLength() > panel.viewBox.baseVal.width;
  label.setAttribute("text-anchor", isRight ? "end" : "start");
  label.setAttribute("x", isRight ? x - 12 : x + 12);
  label.setAttribute("y", y - 8);
  const line = table.querySelector(`tr[data-row="${point.dataset.row}"]`);
  const heads = table.tHead.rows[0].cells;
  const facts = Array.from(line.cells, (cell, k) => k > 5 && cell.textContent &&
    `${heads[k].textContent} ${cell.textContent}`).filter(Boolean);
  said.textContent = `${point.querySelector("title").textContent}. ` +
    `${methods[point.dataset.row].summary}; ${facts.join(", ")}.`;
}
function stepFrom(point, key) {
  const points = Array.from(shownPoints(point.ownerSVGElement));
  return points[points.indexOf(point) + {ArrowRight: 1, ArrowLeft: -1}[key]];
}
for (const point of holder.querySelectorAll(".point")) {
  point.addEventListener("pointerenter", () => say(point));
  point.addEventListener("focus", () => say(point));
  point.addEventListener("keydown", (event) => {
    const next = stepFrom(point, event.key);
    if (!next) return;
    event.preventDefault();
    point.setAttribute("tabindex", -1);
    next.setAttribute("tabindex", 0);
    next.focus();
  });
}

function caption({family: at, error}) {
  const family = bench.families[at], {text, dataset} = pick.elements.error.options[error];
  const pairs = text.startsWith("leaks") ? family.shared_pairs : family.boundary_pairs;
  const of = dataset.unit === "px" ? "" :
    `, of ${grouped(pairs)} pairs${family.constructed ? ", constructed: no rate" : ""}`;
  // The rule of three: N independent draws show an event of a rate above 3 / N with 95 %
  // probability.
  const bound = family.random && of ?
    ` 0 of N bounds the rate by ${(3 / pairs).toPrecision(1)}.` : "";
  return `${family.name}: ${family.summary}. Up: ${text}${of}.${bound} ${bench.processor}.`;
}
function show(element, isShown) { element.classList.toggle("off", !isShown); }
function showChoice() {
  const what = choice(), panel = panelOf(what);
  const isShown = bench.rows.map((row, k) => isChosen(row, methods[k], what));
  Array.from(holder.children).forEach((child, k) => show(child, k === what.family));
  panel.querySelector(".pointed")?.remove();
  for (const part of panel.querySelectorAll("[data-error]")) {
    show(part, +part.dataset.error === what.error &&
      (part.dataset.sink ?? what.sink) === what.sink);
  }
  for (const name of panel.querySelectorAll("[data-error] [data-row]")) {
    show(name, isShown[name.dataset.row]);
  }
  for (const point of panel.querySelectorAll(".point")) {
    const y = point.dataset.y.split(",")[what.error];
    show(point, y && isShown[point.dataset.row]);
    point.setAttribute("tabindex", -1);
    if (y) point.transform.baseVal[0].setTranslate(point.transform.baseVal[0].matrix.e, y);
  }
  const first = shownPoints(panel)[0];
  first?.setAttribute("tabindex", 0);
  said.textContent = first ? "Point at a method, or tab to one and go on with the arrows." :
    "No method here shows this error: choose another, or fewer conditions.";
  document.getElementById("bench-caption").textContent = caption(what);
  for (const line of table.tBodies[0].rows) show(line, isShown[line.dataset.row]);
}

function save(name, type, content) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([content], {type}));
  link.download = name;
  link.click();
}
// What is shown of the panel, in the size in which it is seen.
function svgText() {
  const seen = panelOf(choice()), svg = seen.cloneNode(true);
  for (const part of svg.querySelectorAll(".off")) part.remove();
  svg.prepend(document.getElementById("bench-style").cloneNode(true));
  svg.setAttribute("width", seen.clientWidth);
  svg.setAttribute("height", seen.clientHeight);
  return new XMLSerializer().serializeToString(svg);
}
function savePng(name) {
  const svg = panelOf(choice());
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
  const shown = Array.from(table.rows).filter((row) => !row.classList.contains("off"));
  return shown.map((row) => Array.from(row.cells,
    (cell) => quoted(cell.textContent)).join(",")).join("\n") + "\n";
}
document.getElementById("bench-save").addEventListener("click", (event) => {
  const as = event.target.dataset.as;
  const stem = `bench-${bench.families[choice().family].name}`;
  if (as === "csv") save(stem + ".csv", "text/csv", csvText());
  if (as === "svg") save(stem + ".svg", "image/svg+xml", svgText());
  if (as === "png") savePng(stem + ".png");
});

pick.hidden = document.getElementById("bench-save").hidden = false;
pick.addEventListener("change", showChoice);
pick.addEventListener("submit", (event) => event.preventDefault());
showChoice();
})();
