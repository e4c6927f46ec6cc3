"""scenes/bugs: each real bug is seen on its case, and the oracle is not accused on it.

usage: bugs_test.py PROGRAM SOURCES
"""
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCES = (os.path.abspath(path) for path in sys.argv[1:3])
CASES = sorted(pathlib.Path(SOURCES, "scenes/bugs").glob("*.json"))
HOLDS, VIOLATED, INCONCLUSIVE = 0, 1, 4


def run(*arguments):
    return subprocess.run([PROGRAM, *arguments], capture_output=True, text=True, timeout=900,
                          check=False)  # fmt: skip


class Bugs(unittest.TestCase):
    def test_each_is_seen(self):
        self.assertGreater(len(CASES), 20)
        for path in CASES:
            with self.subTest(path=path.name):
                done = run("replay", path)
                self.assertEqual(done.returncode, VIOLATED, done.stdout + done.stderr)

    def test_the_oracle_is_not_accused(self):
        held = 0
        for path in CASES:
            profile = json.loads(path.read_text())["profile"]
            with self.subTest(path=path.name), tempfile.TemporaryDirectory() as folder:
                if not isinstance(profile, str):
                    if profile.get("transform"):
                        continue  # the oracle computes no transform of others
                    file = pathlib.Path(folder, "profile.json")
                    file.write_text(json.dumps(profile))
                    profile = str(file)
                done = run("replay", path, "--subject", "exact", "--profile", profile)
                self.assertIn(done.returncode, (HOLDS, INCONCLUSIVE), done.stdout + done.stderr)
                held += done.returncode == HOLDS
        self.assertGreater(held, 20)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=0)
