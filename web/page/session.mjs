/**
 * A run: opens a drawer, has it prove itself, and takes draws from the engine to it. It lives in
 * the worker, or in the page where a worker has no GPU, and speaks by messages.
 *
 * In: {type: "start", api, samples, cases, seed, [of: "coverage" | "values"], [properties], [infer],
 * [saved], [plant]}, "pause", "go", "stop"; for tests "lose". Out, in this order: "device" {info},
 * "proof" {record}, of values "again", then "progress" {done, of, draws, milliseconds} and "saved"
 * {bytes} in turn, "again" {isFirst} when a model is looked for by corners inside a viewport, and
 * at last "stopped" {bytes} or "done" {outcome, reason, result, models, losses, pauses, draws,
 * milliseconds, bytes, picture}. models: {side, model, text} of viewports of two sizes, in pixels.
 * The engine's result stays as it is: whoever judges it again compares all of it.
 */
import {LostError, refusalOf} from "./drawer.mjs";
import {open as openWebGl2} from "./webgl2.mjs";
import {open as openWebGpu} from "./webgpu.mjs";
import {prove} from "./self_proof.mjs";
import {Engine} from "./engine.mjs";
import {firstFailure, pictureOf} from "./picture.mjs";
import {refusalOfCorners} from "./shading.mjs";

const OPENERS = {webgl2: openWebGl2, webgpu: openWebGpu};
const OUTCOMES = {0: "holds", 1: "violated", 4: "inconclusive"};
/* Long enough for a GPU to be busy, short enough for watchdogs and for a button to be heard. */
const LEAST_MILLISECONDS = 20;
const MOST_MILLISECONDS = 50;
const MOST_DRAWS = 256;
const SAVE_MILLISECONDS = 1000;
/* Evaluations a failure: some seconds, where each waits for a GPU. */
const MOST_SHRINKING = 60;
/* Half the viewport's side in which the model is looked for again: drivers choose the grid by the
   viewport's size, some of them another one up to here. No corner comes near its sides. */
const SMALL_REACH = 1024;
const SMALL_LIMIT = 514;
const PROFILES = {webgpu: "webgpu", webgl2: "gl"};
/* What is asked of values. Corners are near enough for no viewport to clip. */
const VALUES_LIMIT = 1024;
const OF_VALUES = [
  "CentroidValuesStayWithinTheirError", "CoveredSamplesHoldNumbers",
  "DerivativesStayWithinTheirError", "EqualValuesStayEqual",
  "FlatValuesComeFromTheProvokingVertex", "QuadDifferencesEqualDifferencesOfValues",
  "ValuesAlongAnEdgeDependOnItsEnds", "ValuesAreMonotoneAlongRows", "ValuesStayInTheHull",
  "ValuesStayWithinTheirError", "VerticesKeepTheirValues",
];

/** Lets messages in. No timer: those of hidden tabs stand still. */
function turn() {
  return new Promise((resolve) => {
    const {port1, port2} = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(null);
  });
}

/** The scene of a request. All its numbers are float32 ones: the engine was told so. */
function sceneOf({width, height, samples, vertices, triangles}, reach) {
  const points = new Float32Array(vertices.length / 2);
  for (let k = 0; k < points.length; ++k) points[k] = vertices[4 * (k >> 1) + (k & 1)];
  return {
    width, height, samples, vertices: points, triangles: Uint32Array.from(triangles), reach,
  };
}

/** Likewise with all that is interpolated. */
function shadedSceneOf({width, height, samples, vertices, triangles, channels, wants}) {
  return {
    width, height, samples, channels, wants, space: "clip", vertices: Float32Array.from(vertices),
    triangles: Uint32Array.from(triangles),
  };
}

/**
 * Facing counts as the engine takes them. A picture with y upwards is taken as its mirror image
 * with y downwards, in which front is back.
 */
function facingCounts({front, back}, yAxis) {
  const [first, second] = yAxis === "down" ? [front, back] : [back, front];
  const counts = new Int32Array(2 * first.length);
  counts.set(first);
  counts.set(second, first.length);
  return counts;
}

class Session {
  #post;
  #asked;
  #drawer = null;
  #engine = null;
  #record = {losses: 0, pauses: 0, draws: 0};
  #resume = null;
  #batch = 4;
  #lost = 0;  // triangles, while the drawer proved itself
  #reach = undefined;
  #shades = false;  // draws what pixels hold, not what is covered
  isStopped = false;

  constructor(post, asked) {
    this.#post = post;
    this.#asked = asked;
  }

  pause() {
    if (this.#resume) return;
    ++this.#record.pauses;
    let go;
    const waiting = new Promise((resolve) => { go = resolve; });
    this.#resume = {go, waiting};
  }

  go() {
    this.#resume?.go();
    this.#resume = null;
  }

  stop() {
    this.isStopped = true;
    this.go();
  }

  lose() {
    this.#drawer?.lose();
  }

  /** Opens the drawer and has it prove itself; the reason if it does not. */
  async #begin() {
    const {api, samples, plant} = this.#asked;
    this.#drawer = await OPENERS[api]({plant});
    this.#post({type: "device", info: this.#drawer.info});
    const {info} = this.#drawer;
    if (samples > 1 && !info.perSample) return "WebGL2 can't read single samples";
    if (!info.samples.includes(samples)) return `this device does not draw ${samples} samples`;
    if (this.#isOfValues && !info.values) {
      return "this device lacks float targets or a centred viewport, and no values are drawn";
    }
    const record = await prove(this.#drawer, samples, this.#isOfValues);
    this.#post({type: "proof", record});
    this.#lost = record.checks.reduce((sum, {lost = 0}) => sum + lost, 0);
    return record.reason;
  }

  get #isOfValues() {
    return this.#asked.of === "values";
  }

  async #drawOne(request, reach) {
    const {info} = this.#drawer;
    if (!this.#shades) {
      const refused = refusalOf(request, info);
      if (refused) return {refused};
      const counts = await this.#drawer.draw(sceneOf(request, reach));
      return {counts: facingCounts(counts, info.yAxis)};
    }
    const refused = refusalOf(request, info) ?? refusalOfCorners(request, info);
    if (refused) return {refused};
    const {ids, ...shown} = await this.#drawer.shade(shadedSceneOf(request));
    const wanted = request.wants.map((name) => [name, shown[name]]);
    return {fragments: {ids, ...Object.fromEntries(wanted)}};
  }

  /** Draws in batches that a GPU has in hand at once; null if stopped. */
  async #drawAll(requests) {
    const reach = this.#reach;
    const answers = [];
    while (answers.length < requests.length) {
      const since = performance.now();
      const batch = requests.slice(answers.length, answers.length + this.#batch);
      answers.push(...await Promise.all(batch.map((one) => this.#drawOne(one, reach))));
      this.#record.draws += batch.length;
      const spent = performance.now() - since;
      if (spent < LEAST_MILLISECONDS) this.#batch = Math.min(2 * this.#batch, MOST_DRAWS);
      if (spent > MOST_MILLISECONDS) this.#batch = Math.ceil(this.#batch / 2);
      await turn();
      await this.#resume?.waiting;
      if (this.isStopped) return null;
    }
    return answers;
  }

  /** A round's answers, from a new device if this one is lost; null if stopped. */
  async #answers(requests) {
    for (let attempt = 0; ; ++attempt) {
      try {
        return await this.#drawAll(requests);
      } catch (error) {
        if (!(error instanceof LostError) || attempt === 2) throw error;
        ++this.#record.losses;
        const reason = await this.#begin();
        if (reason) throw new Error(`after a loss of the device: ${reason}`);
      }
    }
  }

  #openEngine(model) {
    const {api, samples, cases, seed, properties, infer = true, saved} = this.#asked;
    const common = {cases, seed, shrink: MOST_SHRINKING, causes: true};
    if (this.#isOfValues) {
      this.#engine.open({
        subject: {
          name: `${api}-values`, input: "float32", coverage: "fragments",
          shows: ["values", "derivatives"], takes: ["window", "clip"],
        },
        profile: this.#profileOfValues(model), properties: properties ?? OF_VALUES, ...common,
      });
    } else {
      const profile = this.#set();
      this.#engine.open(
          {subject: this.#subject(), profile, infer, ...common, ...(properties && {properties})});
    }
    if (saved) this.#engine.load(saved);
  }

  /**
   * What all specifications say of values, of corners on the grid that was found. None states an
   * error: the engine's is that of usual forms, where they neither overflow nor lose all digits.
   */
  #profileOfValues(model) {
    const {api, samples} = this.#asked;
    const bits = model?.subpixelBits ?? [];
    return {
      name: `${api}-values`, contract: "none", coordinate_limit: VALUES_LIMIT,
      sample_locations: `standard-${samples}`, centroid: "inside",
      ...(bits.length === 1 && bits[0] !== "none" && {subpixel_bits: bits[0]}),
      values: {
        weights: "perspective", flat: true, centres: true, centroids: true, flushes: true,
        inverse_w: samples === 1, ...this.#drawer.info.values,
      },
    };
  }

  #set() {
    const {api, samples} = this.#asked;
    return PROFILES[api] + (samples > 1 ? `-${samples}x` : "");
  }

  #subject() {
    return {
      name: this.#asked.api, input: "float32", coverage: "facing-counts", takes: ["window"],
    };
  }

  /** The model in viewports of two sizes; null if stopped. */
  async #models({subjects: [{model, model_text: text}]}) {
    const {infer = true} = this.#asked;
    if (!infer) return [];
    const {kind, reach} = this.#drawer.info.viewport;
    let large = {side: 2 * reach, model, text};
    // What leaves the viewport is clipped, and a model says nothing of that: then only what stays.
    if (!model && kind === "centred") large = await this.#modelWithin(reach, reach);
    const isOther = kind === "centred" ? reach > SMALL_REACH : reach < SMALL_REACH;
    const hasRoom = this.#drawer.info.largestTarget >= 2 * SMALL_REACH;
    if (!large || !isOther || !hasRoom) return large && [large];
    const small = await this.#modelWithin(SMALL_REACH, SMALL_LIMIT);
    return small && [large, small];
  }

  /** The model in a centred viewport, by corners up to `limit`; null if stopped. */
  async #modelWithin(reach, limit) {
    const {api, samples, seed} = this.#asked;
    this.#post({type: "again", isFirst: this.#isOfValues});
    const engine = await Engine.create();
    const profile = {
      specification: PROFILES[api], name: "within", coordinate_limit: limit,
      sample_locations: `standard-${samples}`,
    };
    engine.open({subject: this.#subject(), profile, seed, properties: [], infer: true});
    this.#reach = reach;
    try {
      for (let round = engine.next(); round.length > 0; round = engine.next()) {
        const answers = await this.#answers(round);
        if (!answers) return null;
        engine.answer(answers);
      }
    } finally {
      this.#reach = undefined;
    }
    const [{model, model_text: text}] = engine.result().subjects;
    return {side: 2 * reach, model, text};
  }

  /** Of what fails first; null if there is none. Whatever goes wrong with it, the verdict stays. */
  async #picture(result) {
    const {samples} = this.#asked;
    const failure = firstFailure(result);
    if (!failure || this.#isOfValues) return null;
    const draw = async (request) => {
      const [{counts}] = await this.#answers([request]) ?? [{}];
      if (!counts) throw new Error("no counts");
      const half = counts.length / 2;
      return {front: counts.subarray(0, half), back: counts.subarray(half)};
    };
    try {
      return await pictureOf(failure, samples, draw, await Engine.create());
    } catch {
      return null;
    }
  }

  async run() {
    const begun = performance.now();
    const milliseconds = () => Math.round(performance.now() - begun);
    // An engine that ended has nothing to save.
    const saved = () => {
      try {
        return this.#engine?.save() ?? null;
      } catch {
        return null;
      }
    };
    const finish = (outcome, reason, found = {}) => this.#post({
      type: "done", outcome, reason, result: null, models: [], picture: null, ...found,
      ...this.#record, milliseconds: milliseconds(), bytes: saved(),
    });
    try {
      const reason = await this.#begin();
      if (reason) return finish("inconclusive", reason);
      const {reach} = this.#drawer.info.viewport;
      const found = this.#isOfValues ? [await this.#modelWithin(reach, VALUES_LIMIT)] : [];
      if (found.includes(null)) return this.#post({type: "stopped", bytes: null});
      this.#shades = this.#isOfValues;
      this.#engine = await Engine.create();
      this.#openEngine(found[0]?.model);
      let savedAt = 0;
      for (let round = this.#engine.next(); round.length > 0; round = this.#engine.next()) {
        const answers = await this.#answers(round);
        if (!answers) return this.#post({type: "stopped", bytes: this.#engine.save()});
        this.#engine.answer(answers);
        const {draws} = this.#record;
        const spent = milliseconds();
        this.#post({
          type: "progress", ...this.#engine.progress(), draws, milliseconds: spent,
        });
        if (spent - savedAt < SAVE_MILLISECONDS) continue;
        savedAt = spent;
        this.#post({type: "saved", bytes: this.#engine.save()});
      }
      const result = this.#engine.result();
      const models = this.#isOfValues ? found : await this.#models(result);
      if (!models) return this.#post({type: "stopped", bytes: this.#engine.save()});
      const picture = await this.#picture(result);
      const outcome = OUTCOMES[result.status] ?? "inconclusive";
      const missed = outcome === "holds" && this.#lost > 0 ?
          `${this.#lost} triangles of long calls were lost while the drawer proved itself, and no ` +
              "property that was asked has seen it" : null;
      finish(missed ? "inconclusive" : outcome, missed, {result, models, picture});
    } catch (error) {
      finish("inconclusive", error.message);
    } finally {
      this.#drawer?.close();
    }
  }
}

/**
 * @param {(listener: (message: object) => void) => void} listen
 * @param {(message: object) => void} post
 * @param {(name: string, api: string) => import("./drawer.mjs").Plant} plantOf
 */
export function serve(listen, post, plantOf = () => undefined) {
  let session = null;
  listen((message) => {
    if (message.type === "start") {
      const plant = message.plant ? plantOf(message.plant, message.api) : undefined;
      session = new Session(post, {...message, plant});
      session.run();
    } else {
      session?.[message.type]();
    }
  });
}
