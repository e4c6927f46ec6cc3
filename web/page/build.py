#!/usr/bin/env python3
"""Builds passport.html: the modules of this folder as one file that asks for nothing else.

usage: build.py OUTPUT --engine FILE.mjs [--wasm FILE.wasm] [--plants FILE.mjs]
--engine: what exports Engine, and useModule() where it takes a module of WebAssembly.
--plants: faults for tests to plant; no page that is shipped has them.
"""
import argparse
import base64
import gzip
import hashlib
import json
import pathlib
import re

FOLDER = pathlib.Path(__file__).resolve().parent
SOURCES = FOLDER.parent.parent
# In order: each sees those before it.
MODULES = ("drawer", "shading", "webgpu", "webgl2", "self_proof", "exact", "engine", "plants",
           "scene", "board", "geometry", "corners", "methods", "numbers", "picture", "session",
           "reproducer", "compare", "issue_text", "playground")  # fmt: skip
# In a function of their own, whose text goes into reproducers.
DRAWERS = MODULES[:4]
# The playground's cases: what each group is.
SAVED = (
    ("Saved findings", "docs/findings/*.json",
     "A case that a shipped rasterizer draws wrongly (the name says which): here is what it should "
     "draw, and what a built-in method does."),
    ("Worst cases", "scenes/worst/*-EdgeErrorStaysWithinItsBound.json",
     "The largest rounding error known of this method's edge values: look at E."),
)  # fmt: skip
KEPT = ("rasterproof_case", "subject", "scene")
IMPORT = re.compile(r'^import \{([^}]*)\} from "\./(\w+)\.mjs";\n', re.M)
RENAMED = re.compile(r"(\w+) as (\w+)")
EXPORT = re.compile(r"^export (?=(?:async )?(?:function|class|const) (\w+))", re.M)


def imported(found):
    names = RENAMED.sub(r"\1: \2", found[1])
    return f"const {{{names}}} = {found[2]};\n"


def module(name, path):
    """A module as an expression in a function: what it exports is its object's."""
    text = path.read_text(encoding="utf-8")
    text = IMPORT.sub(imported, text).replace("import.meta.url", '""')  # a script has none
    names = ", ".join(EXPORT.findall(text))
    text = EXPORT.sub("", text)
    return f"const {name} = (() => {{\n{text}\nreturn {{{names}}};\n}})();\n"


def used(wasm):
    """Has Engine.create() unpack the module first, once."""
    text = base64.b64encode(gzip.compress(wasm.read_bytes(), mtime=0)).decode()
    return f"""const unpacked = engine.Engine;
let used = null;
async function unpack() {{
  const bytes = Uint8Array.from(atob("{text}"), (byte) => byte.charCodeAt(0));
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream("gzip"));
  engine.useModule(await new Response(stream).arrayBuffer());
}}
engine.Engine = {{create: async () => {{
  await (used ??= unpack());
  return unpacked.create();
}}}};
"""


def presets():
    """What the playground starts from: figures, saved findings, worst cases of edges."""
    found = []
    for figure in json.loads((FOLDER / "presets.json").read_text(encoding="utf-8")):
        scene = {key: figure[key] for key in ("width", "height", "vertices", "triangles")}
        scene |= {"rasterproof_scene": 1, "name": figure["title"], "precision": "float32"}
        case = {"rasterproof_case": 2, "subject": figure["subject"], "scene": scene}
        found.append({"group": "Figures", "title": figure["title"], "say": figure["say"],
                      "case": case})  # fmt: skip
    for group, pattern, say in SAVED:
        for path in sorted(SOURCES.glob(pattern)):
            case = json.loads(path.read_text(encoding="utf-8"))
            if "rasterproof_case" not in case:
                continue
            title = path.stem.replace("_", " ")
            found.append({"group": group, "title": title, "say": say,
                          "case": {key: case[key] for key in KEPT}})  # fmt: skip
    return json.dumps(found, separators=(",", ":"))


def clauses():
    """Where a specification says what, by the clause's id."""
    found = {}
    for api in ("gl", "webgpu"):
        text = (SOURCES / "core" / "clauses" / f"{api}.txt").read_text(encoding="utf-8")
        for entry in text.split("\n\n"):
            keys = dict(line.split(": ", 1) for line in entry.splitlines() if ": " in line)
            if "id" in keys:
                found[keys["id"]] = f"{keys['id']}, {keys['place']}: {keys['sentence']}"
    return json.dumps(found, separators=(",", ":"))


def script(engine, wasm, plants):
    paths = {name: FOLDER / f"{name}.mjs" for name in MODULES}
    paths |= {"engine": engine, "plants": plants}
    drawers = ", ".join(DRAWERS)
    bodies = "function drawers() {\n"
    for name, path in paths.items():
        bodies += module(name, path) if path else ""
        bodies += used(wasm) if wasm and name == "engine" else ""
        if name == DRAWERS[-1]:
            bodies += f"return {{{drawers}}};\n}}\nconst {{{drawers}}} = drawers();\n"
    named = ", ".join(["drawers", *(name for name, path in paths.items() if path)])
    page = (FOLDER / "page.mjs").read_text(encoding="utf-8")
    # One function: the page calls it where a worker can't have a GPU, else a worker is made of it.
    return (f'"use strict";\nconst PRESETS = {presets()};\nconst CLAUSES = {clauses()};\n'
            f"function modules() {{\n{bodies}return {{{named}}};\n}}\n{page}")  # fmt: skip


def build(engine, wasm, plants):
    # A text within the script would end it.
    text = script(engine, wasm, plants).replace("</script", "<\\/script")
    digest = base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()
    html = (FOLDER / "page.html").read_text(encoding="utf-8")
    styles = (SOURCES / "report" / "page.css", FOLDER / "page.css", FOLDER / "playground.css")
    style = "".join(path.read_text(encoding="utf-8") for path in styles)
    for name, value in (("SCRIPT-HASH", digest), ("STYLE", style), ("SCRIPT", text)):
        html = html.replace("{{" + name + "}}", value)
    return html


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("output", type=pathlib.Path)
    parser.add_argument("--engine", type=pathlib.Path, required=True)
    parser.add_argument("--wasm", type=pathlib.Path)
    parser.add_argument("--plants", type=pathlib.Path)
    options = parser.parse_args()
    options.output.write_text(build(options.engine, options.wasm, options.plants), encoding="utf-8")


if __name__ == "__main__":
    main()
