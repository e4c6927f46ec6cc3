#!/usr/bin/env python3
"""Builds passport.html: the modules of this folder as one file that asks for nothing else.

usage: build.py OUTPUT [--engine FILE.mjs [--wasm FILE.wasm]] [--plants FILE.mjs]
--engine: what exports Engine, and useModule() where it takes a module of WebAssembly.
--plants: faults for tests to plant; no page that is shipped has them.
"""
import argparse
import base64
import hashlib
import pathlib
import re

FOLDER = pathlib.Path(__file__).resolve().parent
# In order: each sees those before it.
MODULES = ("drawer", "webgpu", "webgl2", "self_proof", "engine", "plants", "session")
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
    text = base64.b64encode(wasm.read_bytes()).decode()
    return f'engine.useModule(Uint8Array.from(atob("{text}"), (byte) => byte.charCodeAt(0)));\n'


def script(engine, wasm, plants):
    paths = {name: FOLDER / f"{name}.mjs" for name in MODULES}
    paths |= {"engine": engine, "plants": plants}
    bodies = "".join(module(name, path) for name, path in paths.items() if path)
    bodies += used(wasm) if wasm else ""
    named = ", ".join(name for name, path in paths.items() if path)
    page = (FOLDER / "page.mjs").read_text(encoding="utf-8")
    # One function: the page calls it where a worker can't have a GPU, else a worker is made of it.
    return f'"use strict";\nfunction modules() {{\n{bodies}return {{{named}}};\n}}\n{page}'


def build(engine, wasm, plants):
    text = script(engine, wasm, plants)
    digest = base64.b64encode(hashlib.sha256(text.encode()).digest()).decode()
    html = (FOLDER / "page.html").read_text(encoding="utf-8")
    styles = (FOLDER.parent.parent / "report" / "page.css", FOLDER / "page.css")
    style = "".join(path.read_text(encoding="utf-8") for path in styles)
    for name, value in (("SCRIPT-HASH", digest), ("STYLE", style), ("SCRIPT", text)):
        html = html.replace("{{" + name + "}}", value)
    return html


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("output", type=pathlib.Path)
    parser.add_argument("--engine", type=pathlib.Path, default=FOLDER / "stub_engine.mjs")
    parser.add_argument("--wasm", type=pathlib.Path)
    parser.add_argument("--plants", type=pathlib.Path)
    options = parser.parse_args()
    options.output.write_text(build(options.engine, options.wasm, options.plants), encoding="utf-8")


if __name__ == "__main__":
    main()
