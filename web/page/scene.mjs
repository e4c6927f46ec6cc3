/**
 * Scenes of the playground: read from case files, from the JSON of a `replay:` line and from links.
 *
 * @typedef {object} Play
 * @property {string} name
 * @property {number} width
 * @property {number} height
 * @property {"float32"|"float64"} precision
 * @property {number[][]} vertices  [x, y], [x, y, z] or, all of them, [x, y, z, w].
 * @property {[number, number, number][]} triangles
 * @property {string} [subject]  Of the case.
 */

const MOST_SIDE = 65536;
const MOST_SAMPLES = 1 << 22;
export const MOST_TRIANGLES = 256;
const LINK = "#scene=";
const NAMED = {inf: Infinity, "-inf": -Infinity, nan: NaN};
const HEX = /^([+-]?)0x([0-9a-f]*)\.?([0-9a-f]*)p([+-]?\d+)$/i;

/** What is wrong with a text, and where. */
export class BadScene extends Error {
  constructor(place, what) {
    super(`${place} ${what}`);
    this.name = "BadScene";
  }
}

function hexNumber(text) {
  const found = HEX.exec(text);
  if (!found || found[2] + found[3] === "") return null;
  const [, sign, whole, part, exponent] = found;
  // More digits than a double holds are refused below: the integer would be rounded.
  const digits = BigInt(`0x${whole}${part}`);
  if (BigInt(Number(digits)) !== digits) return null;
  // In two steps: 2 ** exponent alone may not be a number.
  const power = Number(exponent) - 4 * part.length;
  const half = Math.trunc(power / 2);
  const size = Number(digits) * 2 ** half * 2 ** (power - half);
  return sign === "-" ? -size : size;
}

/** A coordinate as case files write it: a number, a hex float, inf, -inf or nan. */
export function coordinate(value, precision, place) {
  const number = typeof value === "number" ? value :
      typeof value === "string" ? NAMED[value.toLowerCase()] ?? hexNumber(value) : null;
  if (number === null) {
    throw new BadScene(place, `is ${JSON.stringify(value)}; write a number or "0x1.8p+1"`);
  }
  if (precision === "float64") return number;
  const rounded = Math.fround(number);
  if (typeof value === "string" && !Object.is(rounded, number)) {
    throw new BadScene(place, `is ${value}, which float32 does not hold`);
  }
  return rounded;
}

function list(value, place) {
  if (Array.isArray(value)) return value;
  throw new BadScene(place, value === undefined ? "is missing" : "is no list");
}

function side(value, place) {
  if (Number.isInteger(value) && value >= 1 && value <= MOST_SIDE) return value;
  throw new BadScene(place, `is ${JSON.stringify(value)}; write a whole number from 1 to ${
    MOST_SIDE}`);
}

function readVertices(scene, precision) {
  const vertices = list(scene.vertices, "scene.vertices").map((vertex, k) => {
    const place = `scene.vertices[${k}]`;
    const numbers = list(vertex, place);
    if (numbers.length < 2 || numbers.length > 4) {
      throw new BadScene(place, `has ${numbers.length} coordinates; write 2, 3 or 4`);
    }
    return numbers.map((x, axis) => coordinate(x, precision, `${place}[${axis}]`));
  });
  const clip = vertices.findIndex((vertex) => vertex.length === 4);
  const window = vertices.findIndex((vertex) => vertex.length < 4);
  if (clip >= 0 && window >= 0) {
    throw new BadScene(`scene.vertices[${window}]`, `has no w, but scene.vertices[${clip}] has`);
  }
  return vertices;
}

function readTriangles(scene, count) {
  const triangles = list(scene.triangles, "scene.triangles");
  if (triangles.length > MOST_TRIANGLES) {
    throw new BadScene("scene.triangles", `has ${triangles.length}; the playground takes ${
      MOST_TRIANGLES} at most`);
  }
  return triangles.map((triangle, k) => {
    const place = `scene.triangles[${k}]`;
    const corners = list(triangle, place);
    if (corners.length !== 3) {
      throw new BadScene(place, `has ${corners.length} corners; write three`);
    }
    corners.forEach((corner, which) => {
      if (Number.isInteger(corner) && corner >= 0 && corner < count) return;
      throw new BadScene(`${place}[${which}]`, `is ${JSON.stringify(corner)}; the vertices are ` +
          `numbered from 0 to ${count - 1}`);
    });
    return [...corners];
  });
}

/**
 * @param {object} file  A case or a scene, parsed.
 * @returns {Play}
 */
export function playOf(file) {
  if (typeof file !== "object" || file === null || Array.isArray(file)) {
    throw new BadScene("The text", "is no case: it begins with {\"rasterproof_case\": 2");
  }
  const isCase = "rasterproof_case" in file;
  if (isCase && file.rasterproof_case !== 2) {
    throw new BadScene("rasterproof_case", `is ${file.rasterproof_case}; this page reads 2`);
  }
  const scene = isCase ? file.scene : file;
  if (scene?.rasterproof_scene !== 1) {
    throw new BadScene(isCase ? "scene.rasterproof_scene" : "The text",
        isCase ? "is not 1" : "has neither \"rasterproof_case\": 2 nor \"rasterproof_scene\": 1");
  }
  const {precision = "float32", name = "scene"} = scene;
  if (!["float32", "float64"].includes(precision)) {
    throw new BadScene("scene.precision", "is neither \"float32\" nor \"float64\"");
  }
  const width = side(scene.width, "scene.width");
  const height = side(scene.height, "scene.height");
  if (width * height > MOST_SAMPLES) {
    throw new BadScene("scene", `has ${width * height} pixels; the playground takes ${
      MOST_SAMPLES} at most`);
  }
  const vertices = readVertices(scene, precision);
  const triangles = readTriangles(scene, vertices.length);
  return {
    name: String(name), width, height, precision, vertices, triangles,
    ...(typeof file.subject === "string" && {subject: file.subject}),
  };
}

/** Reads a case file, a scene file, or a line with the JSON of one in it. */
export function readCase(text) {
  const [first, last] = [text.indexOf("{"), text.lastIndexOf("}")];
  if (first < 0) throw new BadScene("The text", "has no {: give a case, as JSON");
  let file;
  try {
    // What is before it stays, as blanks: places in messages are places in the text.
    const before = text.slice(0, first).replace(/[^\n]/g, " ");
    file = JSON.parse(before + text.slice(first, last > first ? last + 1 : undefined));
  } catch (error) {
    throw new BadScene("The text", `is no JSON: ${error.message}`);
  }
  return playOf(file);
}

const numberText = (x) => Number.isFinite(x) ? Object.is(x, -0) ? "-0x0p+0" : x :
                          Number.isNaN(x) ? "nan" : x > 0 ? "inf" : "-inf";

/** The scene as the engine and scene files have it. */
export function sceneOf({name, width, height, precision, vertices, triangles}) {
  return {
    rasterproof_scene: 1, name, width, height, precision,
    vertices: vertices.map((vertex) => vertex.map(numberText)), triangles,
  };
}

export function caseOf(play) {
  return {rasterproof_case: 2, subject: play.subject ?? "", scene: sceneOf(play)};
}

/** FNV-1a, 32 bits. */
function checkSum(bytes) {
  const sum = bytes.reduce((hash, byte) => Math.imul(hash ^ byte, 0x01000193), 0x811c9dc5);
  return (sum >>> 0).toString(16).padStart(8, "0");
}

/** The fragment of a link that holds the scene. */
export function linkOf(play) {
  const bytes = new TextEncoder().encode(JSON.stringify(caseOf(play)));
  const text = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
  const safe = text.replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "");
  return `${LINK}${checkSum(bytes)}${safe}`;
}

/** The scene of a fragment; null if it is not meant to hold one. */
export function playOfLink(fragment) {
  if (!fragment.startsWith(LINK)) return null;
  const text = fragment.slice(LINK.length + 8).replaceAll("-", "+").replaceAll("_", "/");
  let bytes;
  try {
    bytes = Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0));
  } catch {
    throw new BadScene("The link", "is damaged: it has letters that no link has");
  }
  if (checkSum(bytes) !== fragment.slice(LINK.length, LINK.length + 8)) {
    throw new BadScene("The link", "is damaged: a part of it is missing or changed");
  }
  return playOf(JSON.parse(new TextDecoder().decode(bytes)));
}
