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

/** In words, what one of them says of itself where both may be right. */
function modelOf(certificate) {
  const grid = subjectOf(certificate).properties
      .find(({property}) => property === "OneGridExplainsEveryCall");
  return grid?.message || "not said";
}

/**
 * @returns {{same: boolean, said: string, rows: {what: string, first: string, second: string,
 *     why: string}[]}}  Rows of what differs; why: the clause that is broken, or what leaves it
 *     open.
 */
export function compare(first, second) {
  const rows = [];
  const add = (what, one, other, why = "") => {
    if (one !== other) rows.push({what, first: String(one), second: String(other), why});
  };
  const text = (value) => JSON.stringify(value) ?? "none";
  const notAlike = ["api", "samples", "cases", "seed"].filter(
      (key) => first.asked[key] !== second.asked[key]);
  for (const key of notAlike) {
    add(`asked: ${key}`, text(first.asked[key]), text(second.asked[key]),
        "they were not asked the same: differences below may come from that");
  }
  add("device", nameOf(first), nameOf(second));
  add("outcome", first.outcome, second.outcome, first.reason ?? second.reason ?? "");
  const open = "legal: each profile leaves the grid to the device";
  add("its grid", modelOf(first), modelOf(second), open);
  const failures = [first, second].map((one) => {
    return new Map(subjectOf(one).failures.map((failure) => [failure.property, failure]));
  });
  const outcomes = [first, second].map((one) => {
    return new Map(subjectOf(one).properties.map(({property, outcome}) => [property, outcome]));
  });
  for (const property of new Set(outcomes.flatMap((map) => [...map.keys()]))) {
    const clause = failures.map((map) => map.get(property)?.clause).find(Boolean) ?? "";
    add(property, outcomes[0].get(property) ?? "not asked",
        outcomes[1].get(property) ?? "not asked",
        clause && `broken: ${clause}`);
  }
  const isSameAnswer = first.saved && first.saved === second.saved && notAlike.length === 0;
  if (!isSameAnswer && notAlike.length === 0 && first.saved && second.saved) {
    rows.push({what: "recorded answers", first: "differ", second: "differ",
      why: "where both outcomes hold, every difference is one that the specification leaves open"});
  }
  const devices = rows.filter(({what}) => what !== "device");
  return {
    same: devices.length === 0, rows,
    said: isSameAnswer ? "Both devices answered every draw alike." :
      devices.length === 0 ? "Both were judged alike." :
        `They differ in ${devices.length} ${devices.length === 1 ? "point" : "points"}.`,
  };
}
