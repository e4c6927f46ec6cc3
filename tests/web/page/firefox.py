"""A Firefox on a screen that nobody sees, driven by its Marionette protocol: WebGL2 on llvmpipe."""

import json
import os
import pathlib
import re
import shutil
import socket
import subprocess
import tempfile
import threading

PREFERENCES = {
    "marionette.port": 0,  # one that is free
    "remote.log.level": "Info",  # which it is
    "webgl.force-enabled": True,
    "browser.shell.checkDefaultBrowser": False,
    "browser.aboutwelcome.enabled": False,
    "datareporting.policy.dataSubmissionEnabled": False,
    "app.update.enabled": False,
    "network.captive-portal-service.enabled": False,
    "network.connectivity-service.enabled": False,
}


class Firefox:
    """A page in its own browser. Every command waits for its answer."""

    def __init__(self, program="firefox-esr", screen="Xvfb"):
        self.folder = pathlib.Path(tempfile.mkdtemp(prefix="firefox-"))
        lines = (f'user_pref("{name}", {json.dumps(value)});\n'
                 for name, value in PREFERENCES.items())  # fmt: skip
        (self.folder / "user.js").write_text("".join(lines), encoding="utf-8")
        ours, theirs = os.pipe()
        self.screen = subprocess.Popen(
            [screen, "-displayfd", str(theirs), "-screen", "0", "1280x1024x24", "-nolisten", "tcp"],
            pass_fds=(theirs,), stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL)  # fmt: skip
        os.close(theirs)
        with os.fdopen(ours) as number:
            display = f":{number.readline().strip()}"
        self.process = subprocess.Popen(
            [program, "--marionette", "--no-remote", "--profile", str(self.folder), "about:blank"],
            env=os.environ | {"DISPLAY": display, "HOME": str(self.folder)}, text=True,
            stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT)  # fmt: skip
        self.socket = self.connected()
        self.bytes = b""
        self.sent = 0
        self.read()  # it greets
        self.call("WebDriver:NewSession")
        self.call("WebDriver:SetTimeouts", script=3_600_000, pageLoad=60_000)

    def connected(self):
        """It says its port once it listens; what it says later is of no use."""
        for line in self.process.stdout:
            if found := re.search(r"Marionette\s.*Listening on port (\d+)", line):
                threading.Thread(target=self.process.stdout.read, daemon=True).start()
                return socket.create_connection(("127.0.0.1", int(found[1])))
        raise AssertionError("Firefox has ended before it listens")

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
