// The playground reads the links of a report's failures; of a damaged one it says so.
// usage: node links_test.mjs COMMAND
import { execFileSync } from "node:child_process";
import { mkdtempSync, readFileSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import assert from "node:assert/strict";
import { BadScene, linkOf, playOf, playOfLink } from "../../web/page/scene.mjs";

const folder = mkdtempSync(join(tmpdir(), "rasterproof-links-"));
try {
  const options = ["--subject", "textbook", "--subject", "hom-f32", "--cases", "20"];
  const place = ["--browser", "https://example.org/passport.html", "--out", folder];
  assert.throws(() => execFileSync(process.argv[2], ["certify", ...options, ...place]), { status: 1 });
  let count = 0;
  for (const page of ["report.html", "textbook/report.html", "hom-f32/report.html"]) {
    for (const [, fragment] of readFileSync(join(folder, page), "utf8").matchAll(/href="[^"#]*(#scene=[^"]*)"/g)) {
      const play = playOfLink(fragment);
      assert.deepEqual(playOfLink(linkOf(play)), play);
      const damaged = fragment.slice(0, -2) + (fragment.at(-2) === "A" ? "B" : "A") + fragment.at(-1);
      for (const wrong of [damaged, fragment.slice(0, -1), `${fragment}!`, fragment.slice(0, 12)])
        assert.throws(() => playOfLink(wrong), BadScene, wrong);
      ++count;
    }
  }
  const saved = JSON.parse(readFileSync(join(folder, "textbook/SharedEdgeSamplesAreCoveredOnce.json"), "utf8"));
  const text = readFileSync(join(folder, "textbook/report.html"), "utf8");
  const linked = [...text.matchAll(/(#scene=[^"]*)"/g)].map(([, fragment]) => playOfLink(fragment));
  const drawn = playOf({ ...saved, scene: saved.drawn?.scene ?? saved.scene });
  assert.ok(linked.some((play) => JSON.stringify(play) === JSON.stringify(drawn)));
  console.log(`${count} links of a report are read`);
} finally {
  rmSync(folder, { recursive: true });
}
