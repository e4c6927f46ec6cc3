// Draws a Vega-Lite specification as SVG. Called by scripts/plot.
import { readFileSync, renameSync, writeFileSync } from "node:fs";

import * as vegaLite from "vega-lite";
import * as vega from "vega";

const [specPath, plotPath] = process.argv.slice(2);

// All data is inline: a specification that names a file or an address is refused, not followed.
const loader = vega.loader();
loader.load = (uri) => Promise.reject(new Error(`the data must be inline, but it names ${uri}`));

const logger = vega.logger(vega.Error);
logger.error = (...reason) => {
  throw new Error(reason.join(" "));
};

try {
  const { spec } = vegaLite.compile(JSON.parse(readFileSync(specPath, "utf8")), { logger });
  const view = new vega.View(vega.parse(spec), { renderer: "none", loader, logger });
  const svg = await view.toSVG();
  // Whole or as it was.
  writeFileSync(`${plotPath}.part`, svg + "\n");
  renameSync(`${plotPath}.part`, plotPath);
} catch (error) {
  console.error(`${specPath}: ${error.message}`);
  process.exitCode = 1;
}
