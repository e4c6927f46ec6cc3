"""A proof that is broken fails: each conclusion of each script, made half as large, is not proved.

usage: proofs_test.py PROVE GAPPA FOLDER
So no script proves its numbers from a contradiction, or proves nothing. Where the conclusion is
that a rounding is exact, a larger box is tried in its place. Of each script one change in three is
tried, the first among them; every one with RASTERPROOF_MORE in the environment (scripts/test_more).
"""

import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

PROVE, GAPPA, FOLDER = sys.argv[1:4]
EVERY = 1 if "RASTERPROOF_MORE" in os.environ else 3
SCRIPTS = sorted(pathlib.Path(FOLDER).glob("*.g"))


def without_comments(text):
    return re.sub(r"#.*", "", text)


def weaker(match):
    """The number of a conclusion, halved where it is an upper bound and doubled otherwise."""
    number = int(match[2])
    return match[1] + (str(number // 2) if match[1].startswith("<") else str(number * 2))


def broken(text):
    """Yields each (what was changed, script with the one change)."""
    before, _, after = without_comments(text).partition("->\n")
    for bound in re.finditer(r"([<>]= )(\d+)", after):
        changed = after[: bound.start()] + weaker(bound) + after[bound.end() :]
        yield f"{bound[0]} of the conclusion", before + "->\n" + changed
    if "in [0, 0]" in after:
        for limit in re.finditer(r"<= (\d+)(?=b|\b)", before):
            larger = before[: limit.start()] + f"<= {2 * int(limit[1])}" + before[limit.end() :]
            yield f"{limit[0]} of the premise", larger + "->\n" + after


class Proofs(unittest.TestCase):
    def prove(self, text):
        with tempfile.TemporaryDirectory() as folder:
            script, record = pathlib.Path(folder) / "p.g", pathlib.Path(folder) / "p.json"
            script.write_text(text, encoding="utf-8")
            done = subprocess.run([PROVE, GAPPA, script, record], capture_output=True, check=False)
            self.assertEqual(record.exists(), done.returncode == 0)
            return done.returncode == 0

    def test_a_stronger_claim_is_not_proved(self):
        self.assertGreater(len(SCRIPTS), 10)
        for path in SCRIPTS:
            text = path.read_text(encoding="utf-8")
            variants = list(broken(text))
            self.assertTrue(variants, f"{path.name}: nothing in it can be broken")
            self.assertTrue(self.prove(without_comments(text)), path.name)
            for what, variant in variants[::EVERY]:
                with self.subTest(script=path.name, change=what):
                    self.assertFalse(self.prove(variant))

    def test_a_script_that_is_no_gappa_is_not_proved(self):
        self.assertFalse(self.prove("{ |x| <= 1 -> |x| <= }\n"))


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
