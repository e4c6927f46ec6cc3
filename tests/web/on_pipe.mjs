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

const [name, wasm] = process.argv.slice(2);
useModule(readFileSync(wasm));
const draw = await rasterizers[name].make();
for (let head = line(); head !== null; head = line()) {
  const [, id, width, height, samples, space, vertices, triangles] = head.split(" ");
  const rows = (count) => Array.from({ length: count }, () => line().split(" ").map(number));
  const request = {
    width: +width,
    height: +height,
    samples: +samples,
    clip: space === "clip",
    vertices: Float64Array.from(rows(+vertices).flat()),
    triangles: Int32Array.from(rows(+triangles).flat()),
  };
  try {
    const counts = await draw(request);
    const columns = request.width * request.samples;
    let answer = `counts ${id}\n`;
    for (let j = 0; j < request.height; ++j)
      answer += counts.subarray(j * columns, (j + 1) * columns).join(" ") + "\n";
    say(answer);
  } catch (error) {
    say(`fault ${id} ${error.message}\n`);
  }
}
