"""The page of web/page in a headless Chromium on SwiftShader, with faults to plant."""

import base64
import os
import pathlib
import subprocess
import sys
import tempfile

SOURCES, CHROMIUM = pathlib.Path(sys.argv[1]), sys.argv[2]
# The engine's module; without it an engine that stands in.
WASM = os.environ.get("RASTERPROOF_WASM")
ENGINE = (("--engine", SOURCES / "web" / "npm" / "index.mjs", "--wasm", WASM) if WASM else
          ("--engine", SOURCES / "tests" / "web" / "page" / "stub_engine.mjs"))  # fmt: skip
KEYS = {"ArrowLeft": 37, "ArrowUp": 38, "ArrowRight": 39, "ArrowDown": 40, "z": 90}
CONTROL, SHIFT = 2, 8
sys.path.insert(0, str(SOURCES / "tests" / "tool"))
from browser import SWIFTSHADER, Browser  # noqa: E402


class Page:
    def __init__(self):
        self.folder = tempfile.TemporaryDirectory()
        page = pathlib.Path(self.folder.name) / "passport.html"
        plants = SOURCES / "tests" / "web" / "page" / "plants.mjs"
        subprocess.run([sys.executable, "-B", SOURCES / "web" / "page" / "build.py", page,
                        "--plants", plants, *ENGINE], check=True)  # fmt: skip
        self.url = page.as_uri()
        self.browser = Browser(CHROMIUM, SWIFTSHADER)
        self.open()

    def close(self):
        self.browser.close()
        self.folder.cleanup()

    def open(self, width=1280, **how):
        self.browser.open(self.url, width, **how)

    def value(self, expression):
        return self.browser.value(expression)

    def text(self, name):
        return self.value(f'document.getElementById("{name}").textContent')

    def wait_until(self, condition):
        """Until a change of the document makes the condition true."""
        self.value(f"""new Promise((resolve) => {{
          const watcher = new MutationObserver(() => look());
          const look = () => {{
            if (!({condition})) return;
            watcher.disconnect();
            resolve(true);
          }};
          watcher.observe(document.body,
              {{attributes: true, subtree: true, childList: true, characterData: true}});
          look();
        }})""")

    def press(self, key, modifiers=0):
        for kind in ("rawKeyDown", "keyUp"):
            self.browser.call("Input.dispatchKeyEvent", type=kind, key=key, code=key,
                              windowsVirtualKeyCode=KEYS[key], modifiers=modifiers)  # fmt: skip

    def mouse(self, kind, x, y):
        self.browser.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, button="left",
                          buttons=1, clickCount=1)  # fmt: skip

    def touch(self, kind, *points):
        self.browser.call("Input.dispatchTouchEvent", type=kind,
                          touchPoints=[{"x": x, "y": y} for x, y in points])  # fmt: skip

    def picture(self, folder, name):
        picture = self.browser.call("Page.captureScreenshot", captureBeyondViewport=True)
        pathlib.Path(folder, name).write_bytes(base64.b64decode(picture["data"]))

    def wait_for(self, *states):
        self.wait_until(f"{list(states)}.includes(document.body.dataset.state)")
