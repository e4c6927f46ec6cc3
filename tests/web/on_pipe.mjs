// One of rasterizers.mjs as a program on a pipe: node on_pipe.mjs NAME MODULE
import { readSync, readFileSync, writeSync } from "node:fs";
import { useModule } from "../../web/npm/index.mjs";
import { rasterizers } from "./rasterizers.mjs";

let text = "";
function line() {
  const chunk = Buffer.alloc(1 << 16);
  for (;;) {
    const end = text.indexOf("\n");
    if (end >= 0) {
      const first = text.slice(0, end);
      text = text.slice(end + 1);
      return first;
    }
    const read = readSync(0, chunk);
    if (read === 0) return null;
    text += chunk.toString("latin1", 0, read);
  }
}
function say(answer) {
  for (let at = 0; at < answer.length; ) {
    try {
      at += writeSync(1, answer.slice(at));
    } catch (error) {
      if (error.code !== "EAGAIN") throw error;
    }
  }
}
const WORDS = { inf: Infinity, "-inf": -Infinity, nan: NaN };
const number = (word) => WORDS[word] ?? Number(word);

let channels = [];
function channelsOf(count = "0") {
  if (count === "same") return channels;
  channels = Array.from({ length: +count }, () => {
    const [, interpolation, at, ...values] = line().split(" ");
    return { interpolation, at, values: interpolation === "inverse-w" ? null : values.map(number) };
  });
  return channels;
}

// What is wanted of fragments: the module's words, in the order of a pipe.
function fragments(id, shown, { width, samples, wants = ["primitive-ids", "barycentrics", "depths"], channels }) {
  const kind = wants[0] === "coverage" ? "counts" : wants.length === 1 ? "primitive-ids" : "fragments";
  const has = (name) => wants.includes(name);
  const columns = width * samples;
  let answer = `${kind} ${id}`;
  shown.ids.forEach((triangle, k) => {
    const numbers = [kind === "counts" ? (triangle < 0 ? 0 : 1) : triangle];
    if (triangle >= 0 && kind === "fragments") {
      if (has("barycentrics")) numbers.push(...shown.barycentrics.subarray(3 * k, 3 * k + 3));
      if (has("depths")) numbers.push(shown.depths[k]);
      for (let c = k * channels.length; has("values") && c < (k + 1) * channels.length; ++c) {
        numbers.push(shown.values[c]);
        if (has("derivatives")) numbers.push(shown.derivatives[2 * c], shown.derivatives[2 * c + 1]);
      }
    }
    answer += (k % columns === 0 ? "\n" : " ") + numbers.map(spelled).join(" ");
  });
  return `${answer}\n`;
}
const spelled = (number) =>
  Object.is(number, -0) ? "-0" : String(number).replace("Infinity", "inf").replace("NaN", "nan");

const [name, wasm] = process.argv.slice(2);
useModule(readFileSync(wasm));
const draw = await rasterizers[name].make();
for (let head = line(); head !== null; head = line()) {
  const [, id, width, height, samples, space, vertices, triangles, ...more] = head.split(" ");
  const option = (key) => more.find((word) => word.startsWith(`${key}=`))?.slice(key.length + 1);
  const rows = (count) => Array.from({ length: count }, () => line().split(" ").map(number));
  const request = {
    width: +width,
    height: +height,
    samples: +samples,
    clip: space === "clip",
    wants: option("wants")?.split(","),
    vertices: Float64Array.from(rows(+vertices).flat()),
    channels: channelsOf(option("channels")),
    triangles: Int32Array.from(rows(+triangles).flat()),
  };
  try {
    const counts = await draw(request);
    const columns = request.width * request.samples;
    if (counts.ids) {
      say(fragments(id, counts, request));
      continue;
    }
    let answer = `counts ${id}\n`;
    for (let j = 0; j < request.height; ++j)
      answer += counts.subarray(j * columns, (j + 1) * columns).join(" ") + "\n";
    say(answer);
  } catch (error) {
    say(`fault ${id} ${error.message}\n`);
  }
}
