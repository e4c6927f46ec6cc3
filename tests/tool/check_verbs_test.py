"""scripts/check_verbs finds verbs and options that the program does not have.

usage: check_verbs_test.py PROGRAM SOURCES
"""
import importlib.machinery
import importlib.util
import os
import sys
import unittest

PROGRAM, SOURCES = (os.path.abspath(path) for path in sys.argv[1:3])
SCRIPTS = os.path.join(SOURCES, "scripts")


def load():
    sys.path.insert(0, SCRIPTS)
    loader = importlib.machinery.SourceFileLoader("check_verbs",
                                                  os.path.join(SCRIPTS, "check_verbs"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("check_verbs", loader))
    loader.exec_module(module)
    return module


CHECK = load()


class Names(unittest.TestCase):
    def wrong(self, text):
        return list(CHECK.wrong_names(text, CHECK.known(PROGRAM)))

    def test_what_the_program_does_not_know_is_named_with_its_line(self):
        for text, what in (("`rasterproof shrink x --out y`", "there is no verb shrink"),
                           ("build/rasterproof check --caes 3", "check has no option --caes"),
                           ("`legal --decidd`", "legal has no option --decidd"),
                           ("    rasterproof bench --svgg x", "bench has no option --svgg")):
            self.assertEqual(self.wrong("fine\n" + text), [(2, what)], text)

    def test_what_it_knows_is_let_pass(self):
        for text in ("build/rasterproof check --cases 3 | head --lines 3",
                     "`pipe answer --describe`", "the command rasterproof certifies",
                     "`cmake --preset release`",
                     "`rasterproof check --plugin ./mine.so -- --other`"):
            self.assertEqual(self.wrong(text), [], text)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
