/* The page's side of a run: what it shows, and where the worker comes from. */
const parts = modules();
const {svg} = parts.board;
const {firstFailure, isAlike} = parts.picture;
const byId = (id) => document.getElementById(id);
const KEPT = "rasterproof-run";
const PROOF_NAMES = {
  readBack: "Read-back",
  counting: "Counting",
  vertices: "Vertices",
  addressing: "Samples, one by one",
  numbers: "Numbers of pixels",
  places: "Places of the samples",
};

const NAMES = {webgpu: "WebGPU", webgl2: "WebGL2"};

/* With one sample a pixel. Their answers have to fit into the engine's memory. */
const MOST_CASES_OF_VALUES = 1000;

let run = null;  // what was asked, and what came of it
let port = null;  // where messages go

/** An element with a text, or with what it holds. */
function made(name, held, attributes = {}) {
  const element = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...[held].flat());
  return element;
}

function show(section, lists) {
  byId(section).hidden = false;
  for (const [id, children] of Object.entries(lists)) byId(id).replaceChildren(...children);
}

/** Numbers of a sentence as people read them; fractions, which are exact, stand behind. */
function readable(text) {
  const decimal = (number) => String(Number(number.toPrecision(6)));
  const hexadecimal = /(-?)0x([0-9a-f]+)(?:\.([0-9a-f]+))?p([+-]?\d+)/g;
  const plain = String(text).replace(hexadecimal, (_, sign, whole, rest = "", exponent) => {
    const digits = parseInt(whole + rest, 16) * 2 ** (Number(exponent) - 4 * rest.length);
    return decimal(sign ? -digits : digits);
  });
  return plain.replace(/(-?\d+)\/([1-9]\d*)/g, (all, n, d) => `${decimal(n / d)} (${all})`);
}

const counted = (count, one, more) => `${count} ${count === 1 ? one : more}`;
const facts = (pairs) => pairs.flatMap(([name, text]) => [made("dt", name), made("dd", text)]);
const chip = (outcome) => made("span", outcome, {class: `chip ${chipClass(outcome)}`});

function chipClass(outcome) {
  return ["holds", "violated"].includes(outcome) ? outcome : "idle";
}

function setState(state, status) {
  document.body.dataset.state = state;
  byId("status").textContent = status;
  const isRunning = state === "running" || state === "paused";
  byId("start").disabled = isRunning;
  byId("stop").disabled = !isRunning;
  byId("resume").disabled = isRunning || !kept();
}

/** A run that was left, if the browser lets pages of this address keep anything. */
function kept() {
  try {
    return JSON.parse(localStorage.getItem(KEPT));
  } catch {
    return null;
  }
}

/* Browsers keep 5 million characters of an address: what was kept before stays. */
const MOST_KEPT = 3 << 20;

function keep(bytes) {
  try {
    if (!bytes) return localStorage.removeItem(KEPT);
    if (bytes.length > MOST_KEPT) return;
    localStorage.setItem(KEPT, JSON.stringify({asked: run.asked, saved: base64(bytes)}));
  } catch {
    // Then this run can't be resumed.
  }
}

function base64(bytes) {
  let text = "";
  for (let at = 0; at < bytes.length; at += 8192) {
    text += String.fromCharCode(...bytes.subarray(at, at + 8192));
  }
  return btoa(text);
}
const bytesOf = (text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));

function showDevice({info}) {
  const adapter = Object.values(info.adapter).filter((name) => typeof name === "string");
  const {kind, reach, error} = info.viewport;
  const viewport = kind === "centred" ?
      `centred, within ${reach} pixels: corners arrive exactly` :
      `ordinary: a corner may arrive ${error} pixels off, in 256 x 256`;
  show("device", {"proof": [], "device-facts": facts([
    ["Adapter", adapter.join(" · ") || "not said"],
    ...(/swiftshader|llvmpipe|\bwarp\b|basic render/i.test(adapter.join(" ")) ? [["Which is",
      "a program on the processor, not your graphics card: to judge the card, turn on hardware " +
      "acceleration in the browser's settings"]] : []),
    ["Subpixel bits, as the driver says", info.subpixelBits ?? "not said"],
    ["Counts triangles on a sample, exactly to", info.ceiling],
    ["Viewport", viewport],
    ["Limits", Object.entries(info.limits).map(([name, n]) => `${name} ${n}`).join(", ")],
    ["The browser hides", info.hidden.join(", ") || "nothing"],
  ])});
}

function showProof({record}) {
  byId("proof").replaceChildren(...record.checks.map((check) => {
    const more = ["subnormals", "nan"].filter((key) => check[key])
        .map((key) => `; ${key === "nan" ? "NaN" : key} ${check[key]}`).join("");
    const outcome = check.passed ? "holds" : "inconclusive";
    const said = `${PROOF_NAMES[check.name]}: ${check.said ?? check.reason}${more}`;
    return made("li", [chip(outcome), said]);
  }));
}

/** Counts as squares, one a sample; those that differ from the others' are framed. */
function figure(title, counts, others, {x: left, y: top, width, height, samples}, at) {
  const across = samples === 1 ? 1 : 2;
  const cells = [];
  counts.forEach((count, k) => {
    const [pixel, s] = [Math.floor(k / samples), k % samples];
    const x = across * (pixel % width) + (s % across);
    const y = across * Math.floor(pixel / width) + Math.floor(s / across);
    const place = {x, y, width: 1, height: 1};
    cells.push(svg("rect", {...place, class: count > 1 ? "more" : `n${count}`}));
    if (count === others[k]) return;
    cells.push(svg("rect", {...place, class: k === at ? "differs first" : "differs"}));
  });
  // Frames last: the next square would cover half of them.
  cells.sort((a, b) => a.getAttribute("class").startsWith("differs") -
                       b.getAttribute("class").startsWith("differs"));
  const differing = counts.filter((count, k) => count !== others[k]).length;
  const picture = svg("svg", {
    style: `max-width: ${3 * across * width}rem`,
    viewBox: `0 0 ${across * width} ${across * height}`, role: "img",
    "aria-label": `${title}: ${width} x ${height} pixels from (${left}, ${top}), ${
      differing} samples differ`,
  }, cells);
  return made("figure", [made("figcaption", title), picture]);
}

/** Of one sample a pixel: with the triangles, and a sign for each kind of difference. */
function boardOf(title, counts, {x, y, width, height, expected}, play, pixel) {
  const board = new parts.board.Board(title);
  const corners = play.vertices.map((vertex) => {
    const point = parts.geometry.windowPoint(vertex);
    return point && [point[0] - x, point[1] - y];
  });
  const lines = play.triangles.flatMap(([a, b, c]) => [[a, b], [b, c], [c, a]])
      .map((line) => line.map((k) => corners[k])).filter((line) => line.every(Boolean));
  board.show({view: {x: 0, y: 0, width, height}, width, counts, exact: expected, lines, ties: [],
    cursor: [pixel[0] - x, pixel[1] - y]});
  board.title = title;
  board.svg.setAttribute("role", "img");
  board.svg.style.maxWidth = `${3 * (width + 2)}rem`;
  return board.figure;
}

/** The failure's counts beside the model's. */
function showPicture(picture, play, pixel, sample) {
  const titles = [`Expected: a legal drawing, ${MODEL_WORDS[picture.model]}`,
    "Drawn by this device"];
  const {expected, actual} = picture;
  if (picture.samples === 1) {
    byId("pictures").append(boardOf(titles[0], expected, picture, play, pixel),
        boardOf(titles[1], actual, picture, play, pixel));
    return "Grey: covered once, or as often as it says. −: missing. +: unexpected. Framed: the " +
        "first sample that fails.";
  }
  const at = ((pixel[1] - picture.y) * picture.width + pixel[0] - picture.x) *
      picture.samples + sample;
  byId("pictures").append(figure(titles[0], expected, actual, picture, at),
      figure(titles[1], actual, expected, picture, at));
  return "Dark: covered once. Light: not covered. Blue: more than once. Framed: differs.";
}

const MODEL_WORDS = {
  "filtered-exact": "corners as given",
  "i32-snap4": "corners rounded to 1/16 pixel",
  "i64-snap8": "corners rounded to 1/256 pixel",
};

function showFailure({message, clause, pixel, sample, expected, actual, ...failure}, picture) {
  const where = pixel ? ` First at pixel (${pixel.join(", ")}), sample ${sample ?? 0}: ` +
      `expected ${readable(expected)}; drawn: ${readable(actual)}.` : "";
  show("failure", {"pictures": [], "edges": [], "failure-said": [
    `${message[0].toUpperCase()}${message.slice(1)}.${where}`],
    "failure-clause": [clause]});
  const play = parts.scene.playOf(failure.case);
  byId("failure-link").href = parts.scene.linkOf(play);
  const shown = picture && !isAlike(picture);
  byId("reproduce").hidden = !shown;
  if (!shown) {
    const why = isOfValues() ? "What is wrong is a number: there is no picture." : picture ?
      "Drawn once more by itself, the case looks right here: it fails beside other drawings, or not " +
      "each time, so no picture shows it. The text for a bug report holds the case." :
      "There is no picture of this case: it is too large, or in clip space.";
    byId("edges").append(made("p", why, {class: "why"}));
    return;
  }
  const key = showPicture(picture, play, pixel ?? [picture.x, picture.y], sample ?? 0);
  byId("edges").append(made("p",
      `${key} Of legal drawings one of the nearest is shown; the verdict is of all.`, {class: "why"}));
  if (picture.edges.length === 0) return;
  byId("edges").append(made("p", "At the framed sample, on which side of each edge it lies (E, see " +
      "the playground):", {class: "why"}), ...picture.edges.map(({triangle, values}) => {
    return made("p", made("code", `triangle ${triangle}: E = ${values.join(", ")}`));
  }));
}

/** The model in a viewport of each size, and whether the size matters. */
function showModels(models) {
  if (models.length === 0) return;
  const words = models.map(({model, text}) => {
    return model ? parts.compare.modelWords(model) : text ?? "no model explains what was drawn";
  });
  const rows = models.map(({side}, k) => [`Viewport of ${side} x ${side} pixels`, words[k]]);
  const said = models.length === 1 ? "This device was asked in a viewport of one size alone." :
    words[0] === words[1] ? "The same at both sizes." :
      "The two sizes differ: this driver chooses its grid by the viewport's size. No specification " +
      "asked here forbids that.";
  show("model", {"model-facts": facts(rows), "model-sizes": [said]});
}

function showResult({result, models, picture}) {
  const {causes = [], failures, properties, unasked} = result.subjects[0];
  showModels(models);
  const clauses = new Map(failures.map(({property, clause}) => [property, clause]));
  const place = (one) => (ORDER.indexOf(outcomeOf(one)) + ORDER.length) % ORDER.length;
  const asked = properties.filter(wasAsked);
  show("verdicts", {"verdict-rows": asked.sort((a, b) => place(a) - place(b)).map((one) => {
    return made("tr", [
      made("th", made("span", one.property, {class: "name"}), {scope: "row"}),
      made("td", chip(outcomeOf(one))),
      made("td", one.cases, {class: "number", "data-unit": one.cases === 1 ? " case" : " cases"}),
      made("td", `${outcomeOf(one) === "quality" ? "No sentence asks for it: " : ""}${
        clauses.get(one.property) ?? one.message}`),
    ]);
  })});
  const first = firstFailure(result);
  if (first) showFailure(first, picture);
  byId("causes").replaceChildren(...causes.map(({cause, text}) => {
    return made("p", [made("strong", `${parts.issue_text.causeWords(cause)} `), text]);
  }));
  const notAsked = properties.filter(({outcome}) => outcome === "not applicable")
      .map(({property, message}) => ({statement: property, by: message}));
  const rows = [...unasked, ...notAsked].map(({statement, by}) => {
    return made("li", by ? `${statement}: ${by}` : statement);
  });
  show("unasked", {"unasked-rows": rows.length > 0 ? rows : [made("li", "nothing")]});
  byId("unasked-count").textContent = counted(rows.length, "matter", "matters");
}

/* What comes first in the table; what is not named here goes before the last. */
const ORDER = ["violated", "inconclusive", "quality", "refused", "holds", "not exercised"];

/* What no sentence forbids is a matter of quality. */
const outcomeOf = ({outcome, fails}) => outcome === "violated" && !fails ? "quality" : outcome;
/* Whether what fails is by how far numbers are off, alone. */
const isOfError = (properties) => properties.every(({property, fails}) => {
  return !fails || property.endsWith("WithinTheirError");
});
/* Not applicable is also what was given cases of which none applied. */
const wasAsked = ({outcome}) => outcome !== "not applicable";
const isOfValues = () => run.asked.of === "values";

function sentence(outcome, reason, result) {
  const {properties = []} = result?.subjects[0] ?? {};
  const asked = properties.filter((one) => wasAsked(one) && one.cases > 0).length;
  const failing = properties.filter(({fails}) => fails).length;
  const of = `${failing} of ${counted(asked, "property", "properties")}`;
  const lacks = properties.filter((one) => outcomeOf(one) === "quality").length;
  const less = lacks > 0 ? ` ${lacks} found less than usual quality, which no sentence forbids.` : "";
  return {
    holds: "No sentence of the specification that was asked of this device is broken: " +
        `${counted(asked, "property", "properties")}, no failure.${less}`,
    violated: `${isOfError(properties) ?
      `Pixels hold numbers that are further off than its specification's formulas in usual forms: ${
        of} failed. No specification says how far is too far.` :
      `This device breaks what its specification says: ${of} failed. Whether it is the graphics ` +
      "chip, its driver or the browser, this page can't tell."}${less} The first is shown below.`,
    inconclusive: result && reason ?
        `No property failed, and yet nothing is said to hold: ${reason}.` :
        "This device was not judged.",
  }[outcome];
}

function showDone(message) {
  const {outcome, reason, result, losses, pauses, draws, milliseconds} = message;
  run.done = message;
  keep(null);
  byId("verdict").replaceChildren(chip(outcome), ` ${sentence(outcome, reason, result)}`);
  byId("meanings").open = false;
  if (result) showResult(message);
  show("run", {"run-facts": facts([
    ["Asked", isOfValues() ? "what pixels hold" : "which samples are covered"],
    ["Cases", `${run.asked.cases}, of each property`],
    ["Drawn with", `${NAMES[run.asked.api]}, samples a pixel: ${run.asked.samples}`],
    ["Seed", run.asked.seed],
    ["Draws", draws],
    ["Time", `${(milliseconds / 1000).toFixed(1)} s`],
    ["Interrupted", `device lost ${counted(losses, "time", "times")}, page hidden ${
      counted(pauses, "time", "times")}`],
  ])});
  if (result) byId("progress").value = byId("progress").max;
  setState("done", reason ? `Inconclusive: ${reason}.` : "Done.");
}

const RECEIVE = {
  device(message) {
    run.info = message.info;
    showDevice(message);
  },
  proof(message) {
    run.proof = message.record;
    showProof(message);
  },
  progress({done, of, draws}) {
    byId("progress").max = of;
    byId("progress").value = done;
    if (document.body.dataset.state === "running") {
      byId("status").textContent = `${done} of ${of} cases judged, ${draws} draws.`;
    }
  },
  again({isFirst}) {
    if (document.body.dataset.state !== "running") return;
    byId("status").textContent = isFirst ?
      "Its model is looked for first: values depend on where it puts corners." :
      "All cases are judged. Its model is looked for once more, by corners inside a viewport.";
  },
  saved: ({bytes}) => keep(bytes),
  stopped({bytes}) {
    keep(bytes);
    setState("stopped", kept() ? "Stopped. Resume goes on from what the browser kept last." :
      "Stopped. It can't be resumed: the browser keeps nothing of it.");
  },
  done: showDone,
};

/** Where a run goes: a worker with a GPU, else this page. */
async function connect(api) {
  const probe = api === "webgpu" ? "!!(self.navigator && navigator.gpu)" :
      "!!(self.OffscreenCanvas && new OffscreenCanvas(1, 1).getContext('webgl2'))";
  const text = `postMessage(${probe}); const {session, plants} = (${modules})();` +
      "session.serve((listener) => { onmessage = ({data}) => listener(data); }," +
      `(message) => postMessage(message), (${planted})(plants));`;
  try {
    const url = URL.createObjectURL(new Blob([text], {type: "text/javascript"}));
    const worker = new Worker(url);
    const hasGpu = await new Promise((resolve) => {
      worker.onmessage = ({data}) => resolve(data);
      worker.onerror = () => resolve(false);
    });
    URL.revokeObjectURL(url);
    if (hasGpu) {
      worker.onmessage = ({data}) => RECEIVE[data.type](data);
      worker.onerror = ({message}) => setState("done", `Inconclusive: ${message}.`);
      return {where: "worker", post: (message) => worker.postMessage(message),
        end: () => worker.terminate()};
    }
    worker.terminate();
  } catch {
    // Workers of blobs may be forbidden.
  }
  let tell;
  const here = modules();
  here.session.serve((listener) => { tell = listener; },
      (message) => RECEIVE[message.type](message), planted(here.plants));
  return {where: "page", post: (message) => tell(message), end() {}};
}

/* Only a page that is built for tests has plants. */
const planted = (plants) => (name, api) => {
  return plants?.plants(api === "webgpu" ? "wgsl" : "glsl")[name];
};

async function start(asked, saved) {
  port?.end();
  run = {asked};
  // What runs is what the form says, resumed or not, where it can say it.
  for (const name of ["of", "api", "samples", "cases", "seed"]) {
    const field = byId("ask").elements[name];
    const has = !field.options || [...field.options].some(({value}) => value === String(asked[name]));
    if (has && asked[name] !== undefined) field.value = asked[name];
  }
  for (const id of ["device", "model", "verdicts", "failure", "unasked", "run"]) {
    byId(id).hidden = true;
  }
  byId("verdict").textContent = "Asking this device …";
  byId("progress").value = 0;
  setState("running", "The drawer proves itself first.");
  port = await connect(asked.api);
  run.where = port.where;
  port.post({type: "start", ...asked, ...(saved && {saved})});
  if (document.hidden) hide();
}

function hide() {
  if (document.body.dataset.state === "running" && document.hidden) {
    port?.post({type: "pause"});
    setState("paused", "Paused while the page is hidden.");
  } else if (document.body.dataset.state === "paused" && !document.hidden) {
    port.post({type: "go"});
    setState("running", "Going on.");
  }
}

/** All that a reader needs to derive the verdict again. */
function certificate() {
  const {asked, info, proof, where, done} = run;
  const {bytes, ...rest} = done;
  const saved = bytes && base64(bytes);
  const browser = navigator.userAgent;
  return {rasterproof_passport: 1, asked, where, browser, info, proof, ...rest, saved};
}

const reportText = () => parts.issue_text.issueText({...run, browser: navigator.userAgent});

function saveAs(download, text, type) {
  const link = made("a", "", {download, href: URL.createObjectURL(new Blob([text], {type}))});
  link.click();
  URL.revokeObjectURL(link.href);
}

function save() {
  saveAs("passport.json", JSON.stringify(certificate(), null, 1), "application/json");
}

const reproducerPage = () => {
  const {result, picture} = run.done;
  return parts.reproducer.reproducer(firstFailure(result), picture, run.asked, parts.drawers);
};

/* The texts of two files, as they come. */
const compared = {first: null, second: null};

async function compareFile(which, file) {
  const {compare, readCertificate} = parts.compare;
  byId("compare-table").hidden = true;
  try {
    compared[which] = file && readCertificate(await file.text(), file.name);
  } catch (error) {
    compared[which] = null;
    byId("compare-said").textContent = `${error.message}.`;
    return;
  }
  const {first, second} = compared;
  byId("compare-said").textContent = "";
  if (!first || !second) return;
  const {said, rows} = compare(first, second, CLAUSES);
  byId("compare-said").textContent = said;
  byId("compare-table").hidden = rows.length === 0;
  byId("compare-rows").replaceChildren(...rows.map((row) => made("tr", [
    made("th", row.what, {scope: "row"}), made("td", row.first), made("td", row.second),
    made("td", row.why),
  ])));
}

async function copy() {
  try {
    await navigator.clipboard.writeText(reportText());
    byId("status").textContent = "Copied.";
  } catch {
    const text = made("textarea", reportText(), {rows: 8, "aria-label": "Text for a bug report"});
    byId("copy").replaceWith(text);
    text.select();
  }
}

byId("ask").addEventListener("submit", (event) => {
  event.preventDefault();
  const {of, api, samples, cases, seed} = Object.fromEntries(new FormData(event.target));
  start({
    of, api, samples: Number(samples), seed: Number(seed),
    cases: Math.min(cases, of === "values" ? MOST_CASES_OF_VALUES / samples : Infinity),
  });
});
byId("stop").addEventListener("click", () => port?.post({type: "stop"}));
byId("resume").addEventListener("click", () => {
  const left = kept();
  if (left) start(left.asked, bytesOf(left.saved));
});
byId("save").addEventListener("click", save);
byId("copy").addEventListener("click", copy);
byId("reproduce").addEventListener("click", () => {
  saveAs("reproducer.html", reproducerPage(), "text/html");
});
for (const which of ["first", "second"]) {
  byId(`compare-${which}`).addEventListener("change", ({target}) => {
    compareFile(which, target.files[0]);
  });
}
document.addEventListener("visibilitychange", hide);
if (!navigator.gpu) byId("ask").elements.api.value = "webgl2";
if (kept()) setState("idle", "A run was left before its end: Resume goes on where it was.");
const playing = parts.playground.playground(parts.engine.Engine, PRESETS);
// For tests, and for whoever wants to look from the console.
globalThis.rasterproof = {
  modules, start, certificate, asked: () => run.asked, reportText, tell: (type) => port.post({type}), playing,
  reproducerPage, compareFile,
};
