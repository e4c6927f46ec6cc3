// The module finds what the command finds: of each rasterizer the same verdicts, witnesses and
// shrunk cases. On a quiet machine: where a program is slow the command puts small cases first.
// usage: node verdicts_test.mjs COMMAND BUILD_WEB [--cases N] [--subject NAME] [--property NAME]
import { execFile } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { parseArgs, promisify } from "node:util";
import assert from "node:assert/strict";
import { check, useModule } from "../../web/npm/index.mjs";
import { rasterizers } from "./rasterizers.mjs";

const { values, positionals } = parseArgs({
  allowPositionals: true,
  options: {
    cases: { type: "string", default: "20" },
    subject: { type: "string" },
    property: { type: "string", multiple: true },
  },
});
const [command, buildWeb] = positionals.map((path) => resolve(path));
const wasm = join(buildWeb, "rasterproof.wasm");
const folder = mkdtempSync(join(tmpdir(), "rasterproof-web-"));
useModule(readFileSync(wasm));

async function byCommand(name, rasterizer) {
  const file = join(folder, `${name}.subject`);
  const program = resolve(import.meta.dirname ?? new URL(".", import.meta.url).pathname, "on_pipe.mjs");
  writeFileSync(
    file,
    `command ${process.execPath} ${program} ${name} ${wasm}\n` +
      `takes ${rasterizer.takes.join(" ")}\n` +
      (rasterizer.coverage ? `coverage ${rasterizer.coverage}\nshows ${rasterizer.shows.join(" ")}\n` : "") +
      `profile ${typeof rasterizer.profile === "string" ? rasterizer.profile : JSON.stringify(rasterizer.profile)}\n`,
  );
  const options = ["check", "--subject", file, "--cases", values.cases, ...(rasterizer.causes ? ["--cause-seconds", "1000"] : ["--no-cause"]), "--memory-limit", "0", "--json", "-"];
  for (const property of values.property ?? []) options.push("--property", property);
  const found = await promisify(execFile)(command, options, { maxBuffer: 1 << 30 }).catch((error) => {
    if (error.code === 1 || error.code === 4) return error;
    throw error;
  });
  const result = JSON.parse(found.stdout);
  return { ...result.subjects[0], status: result.status };
}

function byModule(rasterizer, draw) {
  const { profile, coverage, shows } = rasterizer;
  const takes = rasterizer.takes.filter((word) => word !== "wants");
  const options = { cases: +values.cases, subject: { takes, coverage, shows }, causes: rasterizer.causes ?? false };
  if (values.property) options.properties = values.property;
  return check(draw, profile, options);
}

// What both say, but of some properties; names of subjects and commands are each its own.
function compared({ status, failures, causes, properties, unasked }, apart, hasAll) {
  const of = (list) => list.filter(({ property }) => !apart.includes(property));
  const plain = of(failures).map(({ next, picture, clauses, ...failure }) => {
    const { subject, ...file } = failure.case;
    return { ...failure, case: file };
  });
  // What is left out there adds draws to the search for causes here.
  const found = hasAll ? causes : causes.map(({ cause }) => cause);
  return { status, failures: plain, causes: found, properties: of(properties), unasked };
}

// The answers of a module's rounds have no order: it leaves out what needs one.
const needOrder = ({ properties }) =>
  properties.filter(({ message }) => message.includes("answers have no order")).map((p) => p.property);

try {
  for (const [name, rasterizer] of Object.entries(rasterizers)) {
    if (values.subject && values.subject !== name) continue;
    const draw = await rasterizer.make();
    const begun = performance.now();
    const inModule = await byModule(rasterizer, draw);
    const between = performance.now();
    const inCommand = await byCommand(name, rasterizer);
    const [module, native] = [between - begun, performance.now() - between].map((ms) => ms / 1000);
    const apart = needOrder(inModule);
    const hasAll = !inCommand.failures.some(({ property }) => apart.includes(property));
    const text = (found) =>
      JSON.stringify(compared(found, apart, hasAll), null, 1).replaceAll(`${join(folder, name)}.subject`, "subject");
    assert.equal(text(inModule), text(inCommand), name);
    const cases = inModule.properties.reduce((sum, property) => sum + property.cases, 0);
    const judged = inModule.properties.filter((property) => property.cases > 0).length;
    console.log(
      `${name}: ${inModule.outcome}, ${inModule.failures.length} failures of ${judged} properties, ` +
        `${cases} cases, ${apart.length} left out, causes: ${inModule.causes.map(({ cause }) => cause).join(", ") || "none"}; module ${module.toFixed(1)} s, command ${native.toFixed(1)} s`,
    );
  }
} finally {
  rmSync(folder, { recursive: true });
}
