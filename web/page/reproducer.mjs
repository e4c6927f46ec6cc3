/**
 * A page of its own that draws one case with a drawer of this one and shows the counts beside the
 * expected ones: to attach to a bug report. `drawers` is the function of the page that has the
 * drawers' modules; its text goes along.
 */
import {requestOf} from "./picture.mjs";
import {playOf} from "./scene.mjs";

/* The text of what runs in the reproducer, which has neither this module nor the engine. */
async function main({drawers, api, request, part, expected}) {
  const said = document.getElementById("said");
  const cell = (text, name) => {
    const element = document.createElement("td");
    element.textContent = text;
    if (name) element.className = name;
    return element;
  };
  const table = (id, counts, others) => {
    const rows = Array.from({length: part.height}, (_, y) => {
      const row = document.createElement("tr");
      for (let x = 0; x < part.width; ++x) {
        const from = (y * part.width + x) * request.samples;
        const of = (list) => list.slice(from, from + request.samples).join(" ");
        row.append(cell(of(counts), of(counts) === of(others) ? "" : "differs"));
      }
      return row;
    });
    document.getElementById(id).replaceChildren(...rows);
  };
  try {
    const drawer = await drawers()[api].open();
    const {front, back} = await drawer.draw({
      ...request, vertices: Float32Array.from(request.vertices),
      triangles: Uint32Array.from(request.triangles),
    });
    const drawn = [];
    for (let y = part.y; y < part.y + part.height; ++y) {
      const from = (y * request.width + part.x) * request.samples;
      const to = from + part.width * request.samples;
      for (let k = from; k < to; ++k) drawn.push(front[k] + back[k]);
    }
    const differing = drawn.filter((n, k) => n !== expected[k]).length;
    table("expected", expected, drawn);
    table("drawn", drawn, expected);
    said.textContent = `${differing} of ${expected.length} samples differ, on ${
      JSON.stringify(drawer.info.adapter)}.`;
    document.body.dataset.differing = differing;
  } catch (error) {
    said.textContent = `Not drawn: ${error.message}`;
  }
}

const safe = (text) => text.replaceAll("&", "&amp;").replaceAll("<", "&lt;");

/**
 * @param {object} failure
 * @param {?import("./picture.mjs").Picture} picture
 * @param {{api: string, samples: number}} asked
 * @param {() => object} drawers
 * @returns {?string} The page; null if there is no picture.
 */
export function reproducer(failure, picture, {api, samples}, drawers) {
  if (!picture) return null;
  const request = requestOf(playOf(failure.case), samples);
  const points = Array.from(request.vertices).filter((_, k) => k % 4 < 2);
  const given = {api, request: {...request, vertices: points}, part: picture,
    expected: picture.expected};
  // A text in a script ends at its first end tag.
  const script = `(${main})({drawers: ${drawers}, ...${JSON.stringify(given)}});`
      .replaceAll("</", "<\\/");
  return `<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>${safe(failure.property)}</title>
<style>
body { font: 16px system-ui, sans-serif; margin: 2rem; color-scheme: light dark; }
table { border-collapse: collapse; margin: 0.3rem 0 1rem; }
td { border: 1px solid #888; min-width: 1.5rem; height: 1.5rem; text-align: center; }
td.differs { background: #b94a00; color: #fff; font-weight: bold; }
figure { display: inline-block; margin: 0 2rem 0 0; vertical-align: top; }
pre { white-space: pre-wrap; overflow-wrap: anywhere; }
</style></head><body>
<h1>${safe(failure.property)}</h1>
<p>${safe(failure.message)}</p><p>${safe(failure.clause)}</p>
<p id="said">Drawing with ${safe(api)} …</p>
<p>How many triangles cover each sample, from pixel (${picture.x}, ${picture.y}) on. The expected
counts are those of ${safe(picture.model)}, the nearest of three models. Other roundings of corners
are legal, too: a sample beside an edge may differ on a sound device.</p>
<figure><figcaption>Expected</figcaption><table id="expected"></table></figure>
<figure><figcaption>Drawn here</figcaption><table id="drawn"></table></figure>
<p>The case, for rasterproof:</p><pre>${safe(JSON.stringify(failure.case))}</pre>
<script>${script}</script></body></html>
`;
}
