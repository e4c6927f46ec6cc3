/** What a run found, in Markdown: to paste into an issue. */
import {modelWords} from "./compare.mjs";
import {firstFailure, isAlike} from "./picture.mjs";

/** The counts around the failure, as text: expected beside drawn. */
function pictureText({x, y, width, height, samples, expected, actual}, pixel) {
  const [from, to] = [Math.max(0, pixel[1] - y - 6), Math.min(height, pixel[1] - y + 7)];
  const row = (counts, j) => Array.from({length: width}, (_, i) => {
    return counts.slice((j * width + i) * samples, (j * width + i + 1) * samples).join("");
  }).join(samples === 1 ? "" : " ");
  const rows = Array.from({length: to - from}, (_, k) => {
    return `${row(expected, from + k)}   ${row(actual, from + k)}`;
  });
  return ["```text", `triangles over each sample, from pixel (${x}, ${y + from}): expected, drawn`,
    ...rows, "```"];
}

/** What a cause's text is of. */
export function causeWords(cause) {
  return cause === "none" ? "Not explained:" : `Likely cause, ${cause}:`;
}

/** @param {{asked: object, info: ?object, done: object, browser: string}} run */
export function issueText({asked, info, done, browser}) {
  const failure = firstFailure(done.result);
  const adapter = Object.values(info?.adapter ?? {}).filter((name) => typeof name === "string");
  const lines = [
    `## ${asked.of === "values" ? "Values of pixels" : "Triangle coverage"}: ${done.outcome}${done.reason ? ` (${done.reason})` : ""}`, "",
    `- Device: ${adapter.join(", ") || "not said"}`,
    `- Browser: ${browser}`,
    ...(info ? [`- Subpixel bits, as the driver says: ${info.subpixelBits ?? "not said"}; viewport ${
      info.viewport.kind}`] : []),
    `- Asked: ${{webgpu: "WebGPU", webgl2: "WebGL2"}[asked.api]}, samples a pixel: ${asked.samples}, ${asked.cases} cases of ` +
        `each property, seed ${asked.seed}, rasterproof ${done.result?.version ?? "unknown"}`,
    ...done.models.filter(({model}) => model).map(({side, model}) => {
      return `- In a viewport of ${side} x ${side}: ${modelWords(model)}`;
    }),
  ];
  const {causes = [], properties} = done.result?.subjects[0] ?? {properties: []};
  const failing = properties.filter(({fails}) => fails).map(({property}) => property);
  lines.push(...(failing.length > 0 ? [`- Failed: ${failing.join(", ")}`] : []),
      ...causes.map(({cause, text}) => `- ${causeWords(cause)} ${text}`), "");
  if (!failure) return lines.join("\n");
  const picture = done.picture && !isAlike(done.picture) ? done.picture : null;
  const place = failure.pixel ? ` at pixel (${failure.pixel.join(", ")}), sample ${
    failure.sample ?? 0}` : "";
  lines.push(`### ${failure.property}`, "", `${failure.message}.`, "",
      `- Expected${place}: ${failure.expected}`, `- Drawn: ${failure.actual}`,
      `- Clause: ${failure.clause}`,
      ...(asked.of === "values" ? ["- No specification states an error: what usual forms do " +
          "not exceed is allowed (docs/browser.md)"] : []), "",
      ...(picture ? [...pictureText(picture, failure.pixel ?? [picture.x, picture.y]), ""] : []),
      "<details><summary>The case, for <code>rasterproof replay</code></summary>", "",
      "```json", JSON.stringify(failure.case), "```", "", "</details>", "");
  return lines.join("\n");
}
