/** Two certificates of this page: where do they differ, and which clause leaves it open? */

const VERSION = 1;
/** What is no certificate, and why. */
export class BadCertificate extends Error {}

/** @param {string} text @param {string} name  Of the file. */
export function readCertificate(text, name) {
  let certificate;
  try {
    certificate = JSON.parse(text);
  } catch (error) {
    throw new BadCertificate(`${name} is no JSON: ${error.message}`);
  }
  if (certificate?.rasterproof_passport !== VERSION) {
    throw new BadCertificate(`${name} is no certificate: "rasterproof_passport": ${VERSION} is ` +
        "missing");
  }
  for (const key of ["asked", "outcome"]) {
    if (!(key in certificate)) throw new BadCertificate(`${name}: "${key}" is missing`);
  }
  return certificate;
}

const nameOf = ({info}) => {
  return Object.values(info?.adapter ?? {}).filter((text) => typeof text === "string")
      .join(" ") || "a device without a name";
};

const subjectOf = ({result}) => result?.subjects[0] ?? {failures: [], properties: []};

/* Of a model: its name, its words, and the clause that leaves it to the device. */
const MODEL_PARTS = [
  ["subpixel bits", ({subpixelBits}) => subpixelBits.join(" or "),
    {webgl2: "gl.subpixel-bits", webgpu: "webgpu.precision"}],
  ["rounding of corners", ({snap}) => snap.join(" or "),
    {webgl2: "gl.rounding", webgpu: "webgpu.rounding"}],
  ["samples on edges", ({ties}) => ties,
    {webgl2: "gl.owner-not-named", webgpu: "webgpu.edge"}],
];

/** A model in one line. */
export function modelWords(model) {
  return MODEL_PARTS.map(([name, words]) => `${name}: ${words(model)}`).join("; ");
}

/** The models of both, viewport by viewport, part by part; a clause stands beside what is open. */
function modelRows(first, second, clauses) {
  const rows = [];
  const ofOther = new Map((second.models ?? []).map((one) => [one.side, one]));
  for (const {side, ...one} of first.models ?? []) {
    const other = ofOther.get(side);
    if (!other) continue;
    const place = `, viewport ${side}`;
    if (!one.model || !other.model) {
      const [of, others] = [one, other].map(({model, text}) => model ? modelWords(model) : text);
      rows.push([`model${place}`, of, others, "a device whose model is not found is not legal by " +
          "it, and not illegal: the properties say which"]);
      continue;
    }
    for (const [name, words, open] of MODEL_PARTS) {
      const ids = new Set([first, second].map(({asked}) => open[asked.api]));
      rows.push([name + place, words(one.model), words(other.model),
        `left open by ${[...ids].map((id) => clauses[id] ?? id).join(" · ")}`]);
    }
  }
  return rows;
}

const HEAD = "rasterproof answers 1\n";

/** Recorded answers by the draw that they answer: 16 bytes name it, then times, size, answer. */
export function answersOf({saved}) {
  const bytes = saved ? atob(saved) : "";
  if (!bytes.startsWith(HEAD)) return new Map();
  const number = (at) => {
    let n = 0;
    for (let k = 7; k >= 0; --k) n = 256 * n + bytes.charCodeAt(at + k);
    return n;
  };
  const found = new Map();
  for (let at = HEAD.length; at + 32 <= bytes.length;) {
    const size = number(at + 24);
    found.set(bytes.slice(at, at + 16), bytes.slice(at + 32, at + 32 + size));
    at += 32 + size;
  }
  return found;
}

/** Of draws that both were asked: how many, and how many came out otherwise. */
function commonAnswers(first, second) {
  const [of, others] = [first, second].map(answersOf);
  const common = [...of.keys()].filter((key) => others.has(key));
  return {draws: common.length,
    differing: common.filter((key) => of.get(key) !== others.get(key)).length};
}

/** In one sentence, whether a device is legal, and what it breaks. */
function standing(which, certificate) {
  const {outcome, reason, asked} = certificate;
  const name = `${which} (${nameOf(certificate)})`;
  if (outcome === "holds") return `${name} is legal, as far as it was asked.`;
  if (outcome !== "violated") {
    const what = certificate.result && reason ? "breaks nothing that it was asked, and yet" :
                                                "was not judged";
    return `${name} ${what}${reason ? `: ${reason}` : ""}.`;
  }
  const broken = subjectOf(certificate).failures.filter(({fails}) => fails)
      .map(({property}) => property);
  const said = asked.of === "values" ? "fails" : "is not legal: it breaks";
  return `${name} ${said} ${broken.join(", ")}.`;
}

/** What a property's outcome rests on, where one of the two fails. */
function clauseOf(failure, clauses) {
  if (!failure) return "";
  const ids = (failure.clauses ?? []).map(({id}) => clauses[id] ?? id);
  const said = ids.length > 0 ? ids.join(" · ") : failure.clause;
  return failure.fails ? `broken: ${said}` : `quality, no clause asks it: ${said}`;
}

/**
 * @param {Object<string, string>} clauses  Id, place and sentence of each, by its id.
 * @returns {{same: boolean, said: string, rows: {what: string, first: string, second: string,
 *     why: string}[]}}  Rows of what differs; why: the clause that is broken, or the one that
 *     leaves it open.
 */
export function compare(first, second, clauses) {
  const rows = [];
  const add = (what, one, other, why = "") => {
    if (one !== other) rows.push({what, first: String(one), second: String(other), why});
  };
  const text = (value) => JSON.stringify(value) ?? "none";
  const [askedOf, askedOther] = [first, second].map(({asked: one}) => ({of: "coverage", ...one}));
  const asked = ["of", "api", "samples", "cases", "seed", "properties"].filter(
      (key) => text(askedOf[key]) !== text(askedOther[key]));
  for (const key of asked) {
    add(`asked: ${key}`, text(askedOf[key]), text(askedOther[key]),
        "they were not asked the same: differences below may come from that");
  }
  add("device", nameOf(first), nameOf(second));
  add("outcome", first.outcome, second.outcome, first.reason ?? second.reason ?? "");
  for (const row of modelRows(first, second, clauses)) add(...row);
  const failures = [first, second].map((one) => {
    return new Map(subjectOf(one).failures.map((failure) => [failure.property, failure]));
  });
  const outcomes = [first, second].map((one) => {
    return new Map(subjectOf(one).properties.map(({property, outcome}) => [property, outcome]));
  });
  for (const property of new Set(outcomes.flatMap((map) => [...map.keys()]))) {
    const failure = failures.map((map) => map.get(property)).find(Boolean);
    add(property, outcomes[0].get(property) ?? "not asked",
        outcomes[1].get(property) ?? "not asked", clauseOf(failure, clauses));
  }
  const {draws, differing} = commonAnswers(first, second);
  if (differing > 0) {
    rows.push({what: "draws that both were asked", first: `${draws} draws`,
      second: `${differing} come out otherwise`,
      why: "only what a property finds is broken; every other difference is left open"});
  }
  const isSame = rows.every(({what}) => what === "device");
  const isSameAnswer = first.saved && first.saved === second.saved && asked.length === 0;
  const points = `${rows.length} ${rows.length === 1 ? "point" : "points"}`;
  return {
    same: isSame, rows,
    said: isSameAnswer ? "Both devices answered every draw alike." :
      isSame ? "Both were judged alike." :
        `They differ in ${points}. ${standing("First", first)} ${standing("Second", second)}`,
  };
}
