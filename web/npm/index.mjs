// The engine of rasterproof in WebAssembly. README.md says how to use it.

const STATUS = { 0: "holds", 1: "violated", 4: "inconclusive" };
const CULLS = [null, "front", "back"];
const INTERPOLATIONS = ["flat", "linear", "perspective", "inverse-w"];
const PLACES = ["sample", "centre", "centroid"];
/** What may be wanted of fragments, with the doubles of a sample or, the last two, of a channel. */
const WANTED = { barycentrics: 3, depths: 1, centroids: 3, values: 1, derivatives: 2 };

/** What draw() throws for a scene that it does not draw. */
export class Refused extends Error {}

let compiled = null;

async function readModule() {
  const url = new URL("./rasterproof.wasm", import.meta.url);
  if (url.protocol === "file:" && globalThis.process?.versions?.node) {
    const { readFile } = await import("node:fs/promises");
    return WebAssembly.compile(await readFile(url));
  }
  return WebAssembly.compile(await (await fetch(url)).arrayBuffer());
}

/** Gives the module: its bytes or what WebAssembly.compile() made of them. Else it is fetched. */
export function useModule(bytesOrModule) {
  compiled =
    bytesOrModule instanceof WebAssembly.Module
      ? Promise.resolve(bytesOrModule)
      : WebAssembly.compile(bytesOrModule);
}

// What the module imports of WASI: a clock that stands still, no files, no environment.
function importsOf(module) {
  const wasi = {};
  for (const { module: from, name } of WebAssembly.Module.imports(module)) {
    if (from === "wasi_snapshot_preview1") wasi[name] = () => (name.startsWith("fd_") ? 8 : 0);
  }
  wasi.proc_exit = (status) => {
    throw new Error(`the engine ended with status ${status}`);
  };
  return { wasi_snapshot_preview1: wasi };
}

/** One instance of the module. It holds one check at a time. */
export class Engine {
  #exports;
  #fault = null;

  constructor(instance) {
    this.#exports = instance.exports;
    this.#exports._initialize();
  }

  static async create() {
    compiled ??= readModule();
    const module = await compiled;
    return new Engine(await WebAssembly.instantiate(module, importsOf(module)));
  }

  #call(name, input) {
    if (this.#fault) throw this.#fault;
    const exports = this.#exports;
    try {
      if (input !== undefined) {
        const bytes = typeof input === "string" ? new TextEncoder().encode(input) : input;
        const at = exports.rasterproof_room(bytes.length);
        new Uint8Array(exports.memory.buffer, at, bytes.length).set(bytes);
      }
      return exports[`rasterproof_${name}`]();
    } catch (error) {
      const message = this.#textAt(exports.rasterproof_message());
      this.#fault = new Error(message || `the engine ended: ${error.message}`);
      throw this.#fault;
    }
  }

  #textAt(at) {
    const bytes = new Uint8Array(this.#exports.memory.buffer, at);
    return new TextDecoder().decode(bytes.subarray(0, bytes.indexOf(0)));
  }

  #bytes(name, input) {
    const at = this.#call(name, input);
    const length = this.#exports.rasterproof_length();
    return new Uint8Array(this.#exports.memory.buffer, at, length).slice();
  }

  #json(name, input) {
    return JSON.parse(new TextDecoder().decode(this.#bytes(name, input)));
  }

  get memoryBytes() {
    return this.#exports.memory.buffer.byteLength;
  }
  open(options) {
    this.#call("open", JSON.stringify(options));
  }
  /** The draws of the next round; none: the result is there. */
  next() {
    return unpackRequests(this.#bytes("next"));
  }
  /** Takes answers to the first of these draws: { counts }, { refused } or { fault }. */
  answer(answers) {
    if (this.#call("answer", packAnswers(answers))) return;
    throw new Error("a draw was answered in two ways: the rasterizer is not deterministic");
  }
  progress() {
    return this.#json("progress");
  }
  save() {
    return this.#bytes("save");
  }
  load(saved) {
    this.#call("load", saved);
  }
  result() {
    return this.#json("result");
  }
  covers(question) {
    return this.#json("covers", JSON.stringify(question, numberText));
  }
  draw(method, scene, at) {
    return this.#json("draw", JSON.stringify({ method, scene, at }, numberText));
  }
  methods() {
    return this.#json("methods");
  }
}

// JSON has no infinities and loses the sign of -0; the engine reads them as texts.
function numberText(key, value) {
  if (Object.is(value, -0)) return "-0x0p+0";
  if (typeof value !== "number" || Number.isFinite(value)) return value;
  return Number.isNaN(value) ? "nan" : value > 0 ? "inf" : "-inf";
}

function unpackRequests({ buffer }) {
  const requests = [];
  let at = 8;
  const integers = (count) => new Int32Array(buffer, (at += 4 * count) - 4 * count, count);
  const doubles = (count) => new Float64Array(buffer, (at += 8 * count) - 8 * count, count);
  for (let left = new Int32Array(buffer, 0, 1)[0]; left > 0; --left) {
    const [width, height, samples, clip, cull, scissor, x0, y0, x1, y1, wanted, ...sizes] = integers(14);
    const [channelCount, corners, triangles] = sizes;
    const vertices = doubles(4 * corners);
    const channels = Array.from({ length: channelCount }, () => {
      const [kind, place] = integers(2);
      const interpolation = INTERPOLATIONS[kind];
      const values = interpolation === "inverse-w" ? null : doubles(corners);
      return { interpolation, at: PLACES[place], values };
    });
    const indices = integers(3 * triangles);
    requests.push({
      width,
      height,
      samples,
      clip: clip === 1,
      cull: CULLS[cull],
      scissor: scissor ? [x0, y0, x1, y1] : null,
      vertices,
      triangles: indices,
      wants: Object.keys(WANTED).filter((_, k) => (wanted >> k) & 1),
      channels,
    });
    at = (at + 7) & ~7;
  }
  return requests;
}

// The ids, and doubles behind them.
function packFragments({ ids, ...shown }) {
  const lists = Object.keys(WANTED).map((name) => shown[name] ?? []);
  const doubles = new Float64Array(lists.reduce((sum, { length }) => sum + length, 0));
  let at = 0;
  for (const list of lists) {
    doubles.set(list, at);
    at += list.length;
  }
  const words = new Int32Array(ids.length + 2 * doubles.length);
  words.set(ids);
  new Uint8Array(words.buffer, 4 * ids.length).set(new Uint8Array(doubles.buffer));
  return words;
}

function packAnswers(answers) {
  const parts = answers.map((answer) => {
    if (answer.counts) return { how: 0, words: answer.counts };
    if (answer.fragments) return { how: 0, words: packFragments(answer.fragments) };
    const how = answer.refused !== undefined ? 1 : 2;
    const text = new TextEncoder().encode(answer.refused ?? answer.fault ?? "no answer");
    const words = new Int32Array(Math.ceil(text.length / 4));
    new Uint8Array(words.buffer).set(text);
    return { how, words, length: text.length };
  });
  const packed = new Int32Array(parts.reduce((sum, part) => sum + 2 + part.words.length, 0));
  let at = 0;
  for (const { how, words, length } of parts) {
    packed.set([how, length ?? words.length], at);
    packed.set(words, at + 2);
    at += 2 + words.length;
  }
  return new Uint8Array(packed.buffer);
}

// Of what a draw returns, what is wanted.
function fragmentsOf(shown, size, { wants, channels }) {
  const fragments = { ids: shown.ids };
  const lengths = { ids: size };
  for (const name of wants) {
    const ofChannels = name === "values" || name === "derivatives";
    lengths[name] = size * WANTED[name] * (ofChannels ? channels.length : 1);
    fragments[name] = shown[name];
  }
  for (const [name, length] of Object.entries(lengths)) {
    const given = fragments[name]?.length;
    if (given !== length) return { fault: `draw() gave ${given ?? "no"} ${name}, and ${length} are wanted` };
  }
  return { fragments };
}

async function answerTo(draw, request) {
  try {
    const counts = await draw(request);
    const size = request.width * request.height * request.samples;
    if (counts?.ids) return fragmentsOf(counts, size, request);
    if (counts?.length === size || counts?.length === 2 * size) return { counts };
    return { fault: `draw() gave ${counts?.length} numbers for ${size} samples` };
  } catch (error) {
    if (error instanceof Refused) return { refused: error.message };
    return { fault: String(error?.message ?? error) };
  }
}

/** Judges a rasterizer. */
export async function check(draw, profile = "real", options = {}) {
  const { onProgress, ...asked } = options;
  const engine = await Engine.create();
  engine.open({ causes: true, ...asked, profile });
  for (let requests = engine.next(); requests.length > 0; requests = engine.next()) {
    const answers = [];
    for (const request of requests) answers.push(await answerTo(draw, request));
    engine.answer(answers);
    onProgress?.(engine.progress());
  }
  const found = engine.result();
  const subject = found.subjects[0];
  return { ...found, outcome: STATUS[found.status], ...subject, version: found.version };
}

let shared = null;

// Of questions that are answered at once. An instance that ended is replaced.
async function ask(question) {
  shared ??= Engine.create();
  try {
    return question(await shared);
  } catch (error) {
    shared = null;
    throw error;
  }
}

/** The exact oracle, and what built-in methods draw. */
export const oracle = {
  covers: (question) => ask((engine) => engine.covers(question)),
  draw: (method, scene, at) => ask((engine) => engine.draw(method, scene, at)),
  methods: () => ask((engine) => engine.methods()),
};

/** A result in a few lines: what fails, with its case. */
export function describe(result) {
  const lines = [`${result.subject} is ${result.outcome} under ${result.profile}`];
  for (const failure of result.failures.slice(0, 3)) {
    const at = failure.pixel ? ` at pixel (${failure.pixel})` : "";
    lines.push(`${failure.property}${at}: ${failure.message}`);
    lines.push(`  expected ${failure.expected}, drawn ${failure.actual}`);
    lines.push(`  case ${JSON.stringify(failure.case)}`);
  }
  for (const { text } of result.causes) lines.push(`cause: ${text}`);
  if (result.outcome === "inconclusive") {
    const open = result.properties.filter((property) => property.outcome === "inconclusive");
    for (const property of open) lines.push(`${property.property}: ${property.message}`);
  }
  return lines.join("\n");
}

/** For node's runner: rejects unless the rasterizer holds. */
export async function assertRasterizes(draw, profile, options) {
  const result = await check(draw, profile, options);
  if (result.outcome !== "holds") throw new Error(describe(result));
  return result;
}

/** For vitest and jest: expect.extend(matchers); await expect(draw).toRasterize("d3d11"). */
export const matchers = {
  async toRasterize(draw, profile, options) {
    const result = await check(draw, profile, options);
    return { pass: result.outcome === "holds", message: () => describe(result) };
  },
};
