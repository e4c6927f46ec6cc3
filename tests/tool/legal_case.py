"""A scene and drawings of it, for tests of `legal`. Of the command line: PROGRAM SOURCES."""
import json
import os
import struct
import subprocess
import sys
import tempfile
import unittest
import zlib

PROGRAM = os.path.abspath(sys.argv[1])
SOURCES = os.path.abspath(sys.argv[2])
# A square of two triangles on whole pixels and a half: its diagonal passes through samples.
SQUARE = {"rasterproof_scene": 1, "name": "square", "width": 4, "height": 4,
          "vertices": [[0.25, 0.25], [3.25, 0.25], [3.25, 3.25], [0.25, 3.25]],
          "triangles": [[0, 1, 2], [0, 2, 3]]}


def run(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, cwd=SOURCES, timeout=900,
                          text=True)


def png(rows):
    """A grey picture as the bytes of a PNG file."""
    def chunk(kind, data):
        body = kind + data
        return struct.pack(">I", len(data)) + body + struct.pack(">I", zlib.crc32(body))
    lines = b"".join(b"\0" + bytes(row) for row in rows)
    header = struct.pack(">IIBBBBB", len(rows[0]), len(rows), 8, 0, 0, 0, 0)
    return (b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", zlib.compress(lines)) +
            chunk(b"IEND", b""))


class LegalCase(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.scene = self.write("scene.json", json.dumps(SQUARE))

    def tearDown(self):
        self.folder.cleanup()

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def write(self, name, content):
        with open(self.path(name), "wb" if isinstance(content, bytes) else "w") as file:
            file.write(content)
        return self.path(name)

    def drawn(self, profile):
        counts = run("coverage", self.scene, "--profile", profile)
        self.assertEqual(counts.returncode, 0, counts.stderr)
        return [[int(n) for n in line.split()] for line in counts.stdout.splitlines()]

    def rows(self, name, rows):
        return self.write(name, "\n".join(" ".join(map(str, row)) for row in rows))

    def as_text(self, rows):
        return self.rows("counts.txt", rows)

    def legal(self, image, profile, *more):
        return run("legal", self.scene, image, "--profile", profile, *more)

    def listed(self, *entries, options=()):
        path = self.write("list.json", json.dumps(list(entries)))
        return run("legal", "--list", path, *options)

    def refused(self, *arguments, names):
        result = run(*arguments)
        self.assertEqual(result.returncode, 2, result.stdout)
        for name in names:
            self.assertIn(name, result.stderr)
