"""A Firefox on a screen that nobody sees, driven by its Marionette protocol: WebGL2 on llvmpipe."""

import json
import os
import pathlib
import shutil
import socket
import subprocess
import tempfile
import time

PREFERENCES = {
    "marionette.port": 0,  # one that is free
    "webgl.force-enabled": True,
    "browser.shell.checkDefaultBrowser": False,
    "browser.aboutwelcome.enabled": False,
    "datareporting.policy.dataSubmissionEnabled": False,
    "app.update.enabled": False,
    "network.captive-portal-service.enabled": False,
    "network.connectivity-service.enabled": False,
}
START_SECONDS = 60


class Firefox:
    """A page in its own browser. Every command waits for its answer."""

    def __init__(self, program="firefox-esr", screen="Xvfb"):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="firefox-"))
        lines = (f'user_pref("{name}", {json.dumps(value)});\n'
                 for name, value in PREFERENCES.items())  # fmt: skip
        (self.folder / "user.js").write_text("".join(lines), encoding="utf-8")
        quiet = {"stdin": subprocess.DEVNULL, "stdout": subprocess.DEVNULL,
                 "stderr": subprocess.DEVNULL}  # fmt: skip
        ours, theirs = os.pipe()
        self.screen = subprocess.Popen(
            [screen, "-displayfd", str(theirs), "-screen", "0", "1280x1024x24", "-nolisten", "tcp"],
            pass_fds=(theirs,), **quiet)  # fmt: skip
        os.close(theirs)
        with os.fdopen(ours) as number:
            display = f":{number.readline().strip()}"
        self.process = subprocess.Popen(
            [program, "--marionette", "--no-remote", "--profile", str(self.folder), "about:blank"],
            env=os.environ | {"DISPLAY": display, "HOME": str(self.folder)}, **quiet)  # fmt: skip
        self.socket = self.connected()
        self.bytes = b""
        self.sent = 0
        self.read()  # it greets
        self.call("WebDriver:NewSession")
        self.call("WebDriver:SetTimeouts", script=3_600_000, pageLoad=60_000)

    def connected(self):
        """It writes its port into the profile once it listens."""
        port = self.folder / "MarionetteActivePort"
        end = time.monotonic() + START_SECONDS
        while not (port.exists() and port.read_text(encoding="utf-8").strip()):
            if self.process.poll() is not None or time.monotonic() > end:
                raise AssertionError("Firefox does not start")
            time.sleep(0.1)
        return socket.create_connection(("127.0.0.1", int(port.read_text(encoding="utf-8"))))

    def close(self):
        self.socket.close()
        for process in (self.process, self.screen):
            process.terminate()
            process.wait()
        shutil.rmtree(self.folder, ignore_errors=True)

    def read(self):
        """A message: its length in digits, a colon, JSON."""
        while True:
            length, colon, rest = self.bytes.partition(b":")
            if colon and len(rest) >= int(length):
                self.bytes = rest[int(length):]
                return json.loads(rest[: int(length)])
            more = self.socket.recv(1 << 20)
            if not more:
                raise AssertionError("the browser has ended")
            self.bytes += more

    def call(self, method, **parameters):
        self.sent += 1
        text = json.dumps([0, self.sent, method, parameters]).encode()
        self.socket.sendall(str(len(text)).encode() + b":" + text)
        _, _, error, result = self.read()
        if error:
            raise AssertionError(f"{method}: {error['error']}: {error['message']}")
        return result

    def open(self, url):
        self.call("WebDriver:Navigate", url=url)

    def value(self, expression):
        """What the expression comes to in the page, waited for where it must be."""
        script = f"""const done = arguments[0];
            (async () => ({expression}))().then((value) => done([JSON.stringify(value) ?? "null"]),
                (error) => done([null, String(error)]));"""
        found = self.call("WebDriver:ExecuteAsyncScript", script=script, args=[], sandbox=None,
                          newSandbox=False)["value"]  # fmt: skip
        if found[0] is None:
            raise AssertionError(f"{expression}: {found[1]}")
        return json.loads(found[0])
