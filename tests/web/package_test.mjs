// The package, installed from its tarball without a network: what a user's test sees.
// usage: node package_test.mjs BUILD_WEB
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { cpSync, mkdtempSync, readdirSync, rmSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join, resolve } from "node:path";
import { fileURLToPath } from "node:url";

const buildWeb = resolve(process.argv[2]);
const tarball = readdirSync(buildWeb).find((name) => name.endsWith(".tgz"));
const folder = mkdtempSync(join(tmpdir(), "rasterproof-npm-"));
const here = (name) => fileURLToPath(new URL(name, import.meta.url));
try {
  writeFileSync(join(folder, "package.json"), '{"private": true, "type": "module"}');
  execFileSync("npm", ["install", "--offline", "--no-audit", join(buildWeb, tarball)], { cwd: folder });
  cpSync(here("users_test.mjs"), join(folder, "users_test.mjs"));
  execFileSync(process.execPath, ["--test", "users_test.mjs"], { cwd: folder, stdio: "inherit" });
} finally {
  rmSync(folder, { recursive: true });
}
