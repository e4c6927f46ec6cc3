/**
 * Stands in for the engine in tests of the page: the contract of the WebAssembly module's Engine,
 * one property, and beyond it `model`. It draws meshes with shared edges
 * and holds every count against models with 4 to 8 subpixel bits, decided in integers.
 */
import {areaOf, edgesAt, scaled} from "./exact.mjs";

const SIDE = 16;
const MODEL_CASES = 60;
const PLACES = {1: [[8, 8]], 4: [[6, 2], [14, 6], [2, 10], [10, 14]]};
const MODELS = [4, 5, 6, 7, 8].flatMap((bits) => [
  {bits, form: "float32(x - 1/2)"}, {bits, form: "x"},
]);

const METHODS = {
  "filtered-exact": null,
  "i32-snap4": null,
  "i64-snap8": null,
  "textbook": (value) => value >= 0,
  "f32-direct": (value, dx, dy) => value > 0 || (value === 0 && (dy > 0 || (dy === 0 && dx < 0))),
};

function edge32(a, b, p) {
  const f = Math.fround;
  const [dx, dy] = [f(b[0] - a[0]), f(b[1] - a[1])];
  const value = f(f(f(p[0] - a[0]) * dy) - f(f(p[1] - a[1]) * dx));
  return {value, dx, dy};
}

/** Whether a method in float32 covers the point. */
function covers32([a, b, c], point, isInside) {
  const edges = [edge32(b, c, point), edge32(c, a, point), edge32(a, b, point)];
  const area = edge32(a, b, c).value;
  return area !== 0 && edges.every(({value, dx, dy}) => {
    const sign = Math.sign(area);
    return isInside(sign * value, sign * dx, sign * dy);
  });
}

function numbers(seed) {
  let state = (seed * 2654435761 + 12345) >>> 0;
  return (n) => {
    state = (Math.imul(state, 1664525) + 1013904223) >>> 0;
    return Math.floor((state / 2 ** 32) * n);
  };
}

/** To the nearest integer, to the even one of two. */
function nearestEven(x) {
  const down = Math.floor(x);
  const rest = x - down;
  return rest > 0.5 || (rest === 0.5 && down % 2 !== 0) ? down + 1 : down;
}

/** A float32 coordinate on the model's grid, as an integer. */
function snapped(x, {bits, form}) {
  const steps = 2 ** bits;
  return form === "x" ? nearestEven(x * steps) :
                        nearestEven(Math.fround(x - 0.5) * steps) + steps / 2;
}

/**
 * 1 counter-clockwise on screen and covered, -1 clockwise and covered, else 0: top-left. Of BigInts,
 * or of numbers whose products are exact.
 */
function covers(corners, point) {
  const edges = edgesAt(corners, point);
  const area = areaOf(edges);
  const isInside = edges.every((edge) => {
    const [inward, x, y] = [edge.value, edge.dx, edge.dy].map((v) => area > 0 ? v : -v);
    // Left: the interior is to its right. Top: level, with the interior below.
    return inward > 0 || (inward >= 0 && (y > 0 || (y >= 0 && x < 0)));
  });
  if (!isInside) return 0;
  return area > 0 ? 1 : area < 0 ? -1 : 0;
}

/** n / d in lowest terms, as the engine writes it. */
function fraction(n, d) {
  let [a, b] = [n < 0n ? -n : n, d < 0n ? -d : d];
  while (b !== 0n) [a, b] = [b, a % b];
  const [top, bottom] = d < 0n ? [-n / a, -d / a] : [n / a, d / a];
  return bottom === 1n ? `${top}` : `${top}/${bottom}`;
}

/** Where a corner lies matters most at centres, and half way between two points of a grid. */
function coordinate(next, kind, near) {
  const grid = [16, 32, 64, 128, 256][next(5)];
  const away = [0, 2 ** -9, -(2 ** -9), 2 ** -14, -(2 ** -14)][next(5)];
  const x = near + [
    () => next(4096) / 2048 - 1,
    () => next(4) - 1.5,
    () => (next(2 * grid) + 0.5) / grid - 1 + away,
    () => next(2 * grid) / grid - 1,
  ][kind]();
  return Math.fround(x);
}

/** Sixteen triangles that share edges: four quads by two. */
function mesh(seed, index, samples) {
  const next = numbers(seed * 100003 + index);
  const vertices = new Float64Array(4 * 15);
  for (let k = 0; k < 15; ++k) {
    const kind = next(4);
    const x = coordinate(next, kind, 2 + 3 * (k % 5));
    const y = coordinate(next, kind, 2 + 5 * Math.floor(k / 5));
    // Left of 1/2, float32(x - 1/2) loses bits that x has.
    const isFine = k === 5 && index % 2 === 1;
    vertices.set([isFine ? (next(8) + 0.5) / 16 + 2 ** -29 : x, y, 0, 1], 4 * k);
  }
  const triangles = [];
  for (const k of [0, 1, 2, 3, 5, 6, 7, 8]) {
    triangles.push(k, k + 5, k + 1, k + 6, k + 1, k + 5);
  }
  return {
    width: SIDE, height: SIDE, samples, clip: false, cull: null, scissor: null, vertices,
    triangles: Int32Array.from(triangles),
  };
}

function corner(request, index, model) {
  return [0, 1].map((axis) => snapped(request.vertices[4 * index + axis], model));
}

/** Counts of front faces and then of back faces. */
function expected(request, model) {
  const {width, height, samples, triangles} = request;
  const size = width * height * samples;
  const counts = new Int32Array(2 * size);
  const unit = 2 ** (model.bits - 4);
  for (let t = 0; t < triangles.length; t += 3) {
    const corners = [0, 1, 2].map((k) => corner(request, triangles[t + k], model));
    for (let k = 0; k < size; ++k) {
      const pixel = Math.floor(k / samples);
      const place = PLACES[samples][k % samples];
      const column = (16 * (pixel % width) + place[0]) * unit;
      const row = (16 * Math.floor(pixel / width) + place[1]) * unit;
      const sign = covers(corners, [column, row]);
      if (sign !== 0) ++counts[sign > 0 ? k : size + k];
    }
  }
  return counts;
}

/** The case as a file has it. */
function caseOf({width, height, vertices, triangles}) {
  const points = Array.from({length: vertices.length / 4}, (_, k) => {
    return [vertices[4 * k], vertices[4 * k + 1]];
  });
  const corners = Array.from({length: triangles.length / 3}, (_, k) => {
    return [...triangles.subarray(3 * k, 3 * k + 3)];
  });
  const scene = {rasterproof_scene: 1, name: "mesh", width, height, precision: "float32",
    vertices: points, triangles: corners};
  return {rasterproof_case: 2, subject: "", scene};
}

/** What a report says of the first sample that differs. */
function failureOf(request, model, drawn, index) {
  const should = expected(request, model);
  const size = should.length / 2;
  const total = (counts) => Array.from({length: size}, (_, k) => counts[k] + counts[size + k]);
  const at = should.findIndex((count, k) => count !== drawn[k]) % size;
  const {width, samples} = request;
  const pixel = Math.floor(at / samples);
  return {
    property: "OneModelExplainsTheMesh",
    outcome: "violated",
    clause: "stub",
    fails: true,
    message: `No model with 4 to 8 subpixel bits explains what was drawn of case ${index}`,
    pixel: [pixel % width, Math.floor(pixel / width)],
    sample: at % samples,
    expected: String(total(should)[at]),
    actual: String(total(drawn)[at]),
    case: caseOf(request),
  };
}

export class Engine {
  #asked = {};
  #state = {done: 0, left: MODELS, failure: null};
  #round = [];

  static async create() {
    // An empty module: the page's policy lets the real engine be compiled.
    await WebAssembly.compile(Uint8Array.of(0, 0x61, 0x73, 0x6d, 1, 0, 0, 0));
    return new Engine();
  }

  /** Without a property the model alone is looked for. */
  open({profile, cases = MODEL_CASES, seed = 1, subject, properties = []}) {
    const ends = properties.includes("EndsTheEngine");
    this.#asked = {profile, cases, seed, ends, subject: subject?.name ?? "subject"};
  }

  next() {
    const {cases, seed, profile} = this.#asked;
    const samples = /-4x?$/.test(profile.sample_locations ?? profile) ? 4 : 1;
    const {done, failure} = this.#state;
    const count = failure ? 0 : Math.min(10, cases - done);
    this.#round = Array.from({length: count}, (_, k) => mesh(seed, done + k, samples));
    return this.#round;
  }

  answer(answers) {
    this.#requireGoing();
    answers.forEach(({counts}, k) => {
      const {done, left, failure} = this.#state;
      if (failure) return;
      const request = this.#round[k];
      const isExplainedBy = (model) => {
        return expected(request, model).every((count, at) => count === counts[at]);
      };
      const still = left.filter(isExplainedBy);
      this.#state = {
        done: done + 1,
        left: still.length > 0 ? still : left,
        failure: still.length > 0 ? null : failureOf(request, left[0], counts, done),
      };
    });
  }

  progress() {
    return {done: this.#state.done, of: this.#asked.cases};
  }

  /* One that ended answers nothing any more. */
  #requireGoing() {
    if (this.#asked.ends) throw new Error("the engine ended");
  }

  save() {
    this.#requireGoing();
    return new TextEncoder().encode(JSON.stringify(this.#state));
  }

  load(saved) {
    this.#state = JSON.parse(new TextDecoder().decode(saved));
  }

  result() {
    const {failure, done, left} = this.#state;
    const status = failure ? 1 : 0;
    const outcome = failure ? "violated" : "holds";
    const property = {
      property: "OneModelExplainsTheMesh", outcome, fails: status === 1, cases: done,
      exercised: done, refused: 0, message: failure?.message ?? "",
    };
    const model = failure ? null : {
      subpixelBits: left.map(({bits}) => bits).filter((bits, k, all) => all.indexOf(bits) === k),
      snap: left.map(({form}) => `nearest even of ${form}`)
          .filter((form, k, all) => all.indexOf(form) === k),
      ties: "top-left",
    };
    const {subject, profile} = this.#asked;
    return {
      version: "stub", status,
      subjects: [{
        subject, profile, status, failures: failure ? [failure] : [], properties: [property],
        unasked: [{statement: "depth and values", by: "the drawers show coverage alone"}], model,
      }],
    };
  }

  methods() {
    return Object.keys(METHODS);
  }

  covers({triangle, pixel}) {
    const at = [pixel[0] + 0.5, pixel[1] + 0.5];
    const {points, exponent} = scaled([...triangle, at]);
    const facing = covers(points, points[3]);
    const values = edgesAt(points, points[3]).map(({value}) => value);
    const area = values[0] + values[1] + values[2];
    const unit = 1n << BigInt(-2 * exponent);
    const decided = {covers: facing === 0 ? "must not" : "must", facing, at,
      edges: values.map((value) => Number(value) / Number(unit)),
      edges_exact: values.map((value) => fraction(value, unit))};
    if (area === 0n) return decided;
    return {...decided, barycentrics: values.map((value) => Number(value) / Number(area)),
      barycentrics_exact: values.map((value) => fraction(value, area))};
  }

  draw(method, {width, height, vertices, triangles}, at) {
    if (!(method in METHODS)) throw new Error(`draw: method: there is no method "${method}"`);
    const bits = {"i32-snap4": 4, "i64-snap8": 8}[method];
    const snap = (x) => bits ? nearestEven(x * 2 ** bits) / 2 ** bits : x;
    const corners = triangles.map((triangle) => triangle.map((k) => vertices[k].map(snap)));
    const counts = Array.from({length: width * height}, (_, k) => {
      const point = [(k % width) + 0.5, Math.floor(k / width) + 0.5];
      return corners.filter((triangle) => {
        if (METHODS[method]) return covers32(triangle, point, METHODS[method]);
        const {points} = scaled([...triangle, point]);
        return covers(points, points[3]) !== 0;
      }).length;
    });
    const shown = at && corners.map(([a, b, c]) => ({
      edges: [edge32(b, c, at), edge32(c, a, at), edge32(a, b, at)].map(({value}) => value),
      barycentrics: null,
    }));
    const profile = {subpixel_bits: bits ?? null};
    return {width, height, profile, counts, ...(shown && {triangles: shown})};
  }
}
