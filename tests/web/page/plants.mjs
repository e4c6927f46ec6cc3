/**
 * Faults of rasterizers for tests to plant into a drawer; `language` is "wgsl" or "glsl". Pictures
 * without a fault come out as they are.
 */

const everyOther = (rest) => (triangle) => triangle % 2 === rest;

/** Changes of a clip-space position `p`; `unit` is a pixel. */
const moved = (x, y) => `p.x += float(${x}) * unit * p.w; p.y += float(${y}) * unit * p.w;`;
const SEVEN_BITS = "p.x = round(p.x / unit * 128.0) / 128.0 * unit;";
/* One rounding instead of two on one side of an edge, made large enough to be seen at 4 bits. */
const FUSED = "p.x = (p.x / unit + 0.0001) * unit;";

/* A pixel of a viewport up to 2048 is larger than this in clip space. */
const SMALL_ONES = "if (unit > 0.0009) { p.x = round(p.x / unit * 8.0) / 8.0 * unit; }";

/** @returns {Object<string, import("../../../web/page/drawer.mjs").Plant>} */
export function plants(language) {
  const text = (glsl) => language === "wgsl" ? glsl.replaceAll("float(", "f32(") : glsl;
  let drawn = 0;
  return {
    "half-pixel-shift": {passes: () => [{position: text(moved("0.5", "0.0"))}]},
    "diagonal-twice": {
      passes: () => [
        {select: everyOther(0)},
        {select: everyOther(1), position: text(moved("-0.0625", "0.0"))},
      ],
    },
    "one-side-fused": {
      passes: () => [{select: everyOther(0)}, {select: everyOther(1), position: FUSED}],
    },
    // Legal: drivers do so.
    "coarse-in-small-viewports": {passes: () => [{position: SMALL_ONES}]},
    "seven-bits": {passes: () => [{position: SEVEN_BITS}]},
    "second-sample-misplaced": {
      passes: (_, {samples = 1}) => samples === 1 ? [{}] : [
        {mask: 0b1101},
        {mask: 0b0010, position: text(moved("0.25", "0.0"))},
      ],
    },
    "every-1000th-lost": {passes: () => [{select: () => ++drawn % 1000 !== 0}]},
    // Alike each time: only calls so long show it.
    "every-1000th-of-a-call-lost": {
      passes: () => [{select: (triangle) => triangle % 1000 !== 999}],
    },
    "saturating": {blend: "max"},
    // Of what pixels hold: on the screen instead of in perspective, another number, x for y.
    "affine": {
      shade: (code) => code.replaceAll("@interpolate(perspective", "@interpolate(linear")
          .replace("perspective = provoking = numbers", "perspective = (provoking = numbers) * clip.w")
          .replaceAll("perspective, perspective,", "perspective * gl_FragCoord.w, perspective * gl_FragCoord.w,"),
    },
    "one-more": {
      shade: (code) => code.replaceAll("passed.provoking, ", "passed.provoking + 1.0, ")
          .replace("vec2[4](provoking,", "vec2[4](provoking + 1.0,"),
    },
    "slopes-exchanged": {
      shade: (code) => code.replace("x.x, x.y, y.x, y.y", "y.x, y.y, x.x, x.y")
          .replace("dFdx(value), dFdy(value)", "dFdy(value), dFdx(value)"),
    },
    "lying-read-back": {
      read: (values) => {
        for (let k = 37; k < values.length; k += 101) values[k] = Math.max(0, values[k] ^ 1);
      },
    },
  };
}
