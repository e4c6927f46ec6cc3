"""The page of web/page in a headless Chromium on SwiftShader, with faults to plant."""

import pathlib
import subprocess
import sys
import tempfile

SOURCES, CHROMIUM = pathlib.Path(sys.argv[1]), sys.argv[2]
sys.path.insert(0, str(SOURCES / "tests" / "tool"))
from browser import SWIFTSHADER, Browser  # noqa: E402


class Page:
    def __init__(self):
        self.folder = tempfile.TemporaryDirectory()
        page = pathlib.Path(self.folder.name) / "passport.html"
        plants = SOURCES / "tests" / "web" / "page" / "plants.mjs"
        subprocess.run([sys.executable, "-B", SOURCES / "web" / "page" / "build.py", page,
                        "--plants", plants], check=True)  # fmt: skip
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

    def wait_for(self, *states):
        self.wait_until(f"{list(states)}.includes(document.body.dataset.state)")
