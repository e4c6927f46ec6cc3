#!/usr/bin/env python3
"""The browser's page: opened by the command, and linked to by the failures of a report.

usage: browser_verb_test.py PROGRAM SOURCES
"""
import base64
import html
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCES = (os.path.abspath(path) for path in sys.argv[1:3])
PAGE = b"<!DOCTYPE html><title>the page</title>"
LINK = re.compile(r'<a href="([^"#]*)#scene=([0-9a-f]{8})([\w-]+)">')


def fnv1a(data):
    value = 0x811C9DC5
    for byte in data:
        value = (value ^ byte) * 0x01000193 & 0xFFFFFFFF
    return f"{value:08x}"


class Browser(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory(suffix=" é")
        self.addCleanup(folder.cleanup)
        self.folder = os.path.realpath(folder.name)
        self.page = os.path.join(self.folder, "prefix/share/rasterproof/passport.html")
        self.program = os.path.join(self.folder, "prefix/bin/rasterproof")
        for path in (self.page, self.program):
            os.makedirs(os.path.dirname(path))
        try:
            os.link(PROGRAM, self.program)
        except OSError:  # on another file system
            shutil.copy(PROGRAM, self.program)

    def install(self):
        with open(self.page, "wb") as file:
            file.write(PAGE)

    def run_program(self, *arguments, **environment):
        return subprocess.run([self.program, *arguments], cwd=self.folder, capture_output=True,
                              text=True, timeout=900, check=False, env=environment)  # fmt: skip

    def address(self):
        quoted = self.page.replace(" ", "%20").replace("é", "%C3%A9")
        return f"file://{quoted}"

    def test_a_page_that_is_not_there_names_the_remedy(self):
        done = self.run_program("browser")
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("passport.html: the page is not installed; build it with ./run web",
                      done.stderr)  # fmt: skip

    def test_the_page_is_opened_where_there_is_a_desktop(self):
        self.install()
        pipe = os.path.join(self.folder, "asked")
        os.mkfifo(pipe)
        opener = os.path.join(self.folder, "xdg-open")
        with open(opener, "w", encoding="utf-8") as file:
            file.write(f'#!/bin/sh\necho noise\necho "$1" > "{pipe}"\n')
        os.chmod(opener, 0o755)
        done = self.run_program("browser", DISPLAY=":1", PATH=f"{self.folder}:/bin")
        with open(pipe, encoding="utf-8") as file:
            self.assertEqual(file.read(), self.address() + "\n")
        self.assertEqual((done.returncode, done.stdout, done.stderr),
                         (0, self.address() + "\n", ""))  # fmt: skip

    def test_without_a_desktop_its_address_is_printed(self):
        self.install()
        for environment in ({"PATH": self.folder, "DISPLAY": ":1"}, {"PATH": "/bin"}):
            done = self.run_program("browser", **environment)
            self.assertEqual((done.returncode, done.stdout), (0, self.address() + "\n"))
            self.assertEqual(
                done.stderr, "there is no desktop with xdg-open: open the address in a browser\n")

    def certify(self, *arguments, subject="textbook"):
        scenes = os.path.join(self.folder, "set.json")
        with open(scenes, "w", encoding="utf-8") as file:
            json.dump({"rasterproof_scene_set": 1, "scenes": [
                {"name": "ties", "path": f"{SOURCES}/scenes/ties.json"}]}, file)  # fmt: skip
        self.run_program("certify", "--subject", subject, "--cases", "20", "--scenes", scenes,
                         *arguments)  # fmt: skip

    def read(self, *path):
        with open(os.path.join(self.folder, "out", *path), encoding="utf-8") as file:
            return file.read()

    def links(self, *path):
        """Of a page: where its links lead, and the cases that they hold."""
        found = []
        for place, check, text in LINK.findall(self.read(*path)):
            data = base64.urlsafe_b64decode(text + "=" * (-len(text) % 4))
            self.assertEqual(fnv1a(data), check)
            found.append((html.unescape(place), json.loads(data)))
        return found

    def test_failures_of_a_report_open_in_the_page_beside_it(self):
        self.install()
        self.certify()
        self.assertEqual(self.read("passport.html").encode(), PAGE)
        front, own = self.links("report.html"), self.links("textbook", "report.html")
        self.assertEqual({place for place, _ in front}, {"passport.html"})
        self.assertEqual({place for place, _ in own}, {"../passport.html"})
        certificate = json.loads(self.read("textbook", "certificate.json"))
        failed = [test for test in certificate["tested"] if test["outcome"] == "violated"]
        # The wrong scene besides.
        self.assertEqual(len(own), len(failed) + 1)
        linked = [case["scene"] for _, case in own]
        for test in failed:
            case = json.loads(self.read("textbook", test["property"] + ".json"))
            self.assertIn(case.get("drawn", case)["scene"], linked)
        self.assertEqual({case["subject"] for _, case in own}, {"textbook"})

    def test_without_the_page_nothing_leads_to_it(self):
        self.certify()
        for path in (("report.html",), ("textbook", "report.html")):
            self.assertNotIn("playground", self.read(*path))
        self.assertNotIn("passport.html", os.listdir(os.path.join(self.folder, "out")))

    def test_nothing_is_copied_where_nothing_failed(self):
        self.install()
        self.certify(subject="spans-exact")
        self.assertNotIn("passport.html", os.listdir(os.path.join(self.folder, "out")))

    def test_the_page_may_lie_elsewhere(self):
        self.install()
        address = "https://example.org/a?b=1&c=2"
        self.certify("--browser", address)
        for path in (("report.html",), ("textbook", "report.html")):
            self.assertEqual({place for place, _ in self.links(*path)}, {address})
        self.assertNotIn("passport.html", os.listdir(os.path.join(self.folder, "out")))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1] + sys.argv[3:])
