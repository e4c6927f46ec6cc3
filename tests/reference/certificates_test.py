"""Coq accepts the certificate of a script that is right, and refuses one that was tampered with.

usage: certificates_test.py CHECK_CERTIFICATES FOLDER
Status 77, skipped, where there is no Coq.
"""

import importlib.machinery
import importlib.util
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

CHECK, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2])
# Gappa takes a rewriting at its word: with a false one it proves what is false.
WITH_REWRITING = "{{ x in [0, 1] -> x - x * x in [0, 1] }}\nx - x * x -> {};\n"


def load():
    sys.path.insert(0, str(pathlib.Path(CHECK).parent))
    loader = importlib.machinery.SourceFileLoader("check_certificates", CHECK)
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader(loader.name, loader))
    loader.exec_module(module)
    return module


class Certificates(unittest.TestCase):
    def setUp(self):
        self.folder = pathlib.Path(self.enterContext(tempfile.TemporaryDirectory()))
        self.module = load()
        self.text = self.module.write_certificate(FOLDER / "index.g")

    def refusal(self, text):
        """Why the certificate is refused."""
        with self.assertRaises(self.module.Refused) as refused:
            self.module.check_certificate(self.folder, "tampered", text)
        return str(refused.exception)

    def status(self, script):
        """The command's status and output for a folder with one script."""
        (self.folder / "one.g").write_text(script, encoding="utf-8")
        done = subprocess.run([CHECK, "--quick", self.folder],
                              capture_output=True, text=True, check=False)  # fmt: skip
        return done.returncode, done.stdout

    def test_a_certificate_assumes_no_more_than_the_reals(self):
        assumed = self.module.check_certificate(self.folder, "index", self.text)
        self.assertEqual(assumed, self.module.REALS)

    def test_a_smaller_bound_is_refused_where_it_is_used(self):
        tampered = list(self.module.stronger(self.text))
        self.assertEqual(len(tampered), 4)
        for text in tampered:
            self.assertNotEqual(text, self.text)
            self.assertRegex(self.refusal(text), r"line \d+.*\n.*Error")

    def test_what_assumes_is_refused(self):
        last = self.text.rindex("Lemma l1 : s1 -> False.")
        self.assertIn("Axiom", self.refusal("Axiom nothing : False.\n" + self.text))
        self.assertIn("Hypothesis", self.refusal(
            self.text[:last] + "Hypothesis nothing : False.\n" + self.text[last:]))  # fmt: skip
        unproved = "Lemma l1 : s1 -> False.\nAdmitted.\nEnd Generated_by_Gappa.\n"
        self.assertIn("Admitted", self.refusal(self.text[:last] + unproved))

    def test_a_variable_that_is_a_proposition_is_refused(self):
        """Such a variable becomes a premise of the last lemma."""
        last = self.text.rindex("Lemma l1 : s1 -> False.")
        self.assertIn("something else", self.refusal(
            self.text[:last] + "Variable nothing : False.\n"
            "Lemma l1 : s1 -> False.\nProof.\n exact (fun _ => nothing).\nQed.\n"
            "End Generated_by_Gappa.\n"))  # fmt: skip

    def test_a_false_rewriting_is_refused_by_name(self):
        status, output = self.status(WITH_REWRITING.format("x * (1 - x)"))
        self.assertEqual(status, 0, output)
        status, output = self.status(WITH_REWRITING.format("x / 2"))
        self.assertEqual(status, 1, output)
        self.assertIn("one.g: no certificate: Coq says", output)

    def test_a_script_that_gappa_refuses_is_named(self):
        status, output = self.status("{ x in [0, 1] -> x in [0, 1b-1] }\n")
        self.assertEqual(status, 1, output)
        self.assertIn("one.g: no certificate: Gappa does not prove it", output)


if __name__ == "__main__":
    if shutil.which("coqc") is None:
        sys.exit(77)
    unittest.main(argv=sys.argv[:1])
