"""Tests that the checks of scripts/ see what they are there to see, that tests are counted as they
went, and that the bugs of scripts/patches still fit the files that they are planted in."""

import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

SCRIPTS = pathlib.Path(__file__).resolve().parents[2] / "scripts"

GUARDED = """#ifndef RASTERPROOF_CORE_SCENE_H_
#define RASTERPROOF_CORE_SCENE_H_
#endif  // RASTERPROOF_CORE_SCENE_H_
"""


def run_check(name, files):
    """Returns the status and the output of a check on a tree that holds these files."""
    with tempfile.TemporaryDirectory() as root:
        for path, text in {"core/scene.h": GUARDED, **files}.items():
            file = pathlib.Path(root) / path
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text, encoding="utf-8")
        command = [sys.executable, "-B", SCRIPTS / name, root]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        return done.returncode, done.stdout + done.stderr


class IncludesTest(unittest.TestCase):
    FILES = {"exact/edge.h": "struct EdgeSign {\n};\nint SignOfEdge(int a);\n",
             "exact/all.h": '#include "exact/edge.h"\n#include <vector>\n'}  # fmt: skip

    def expect(self, text, said=None):
        status, output = run_check("check_includes", {**self.FILES, "exact/use.cc": text})
        self.assertEqual(status, 0 if said is None else 1, output)
        self.assertIn(said or "0 violations", output)

    def test_what_is_named_is_included(self):
        self.expect("int F() { return SignOfEdge(1); }\n",
                    "use.cc:1: SignOfEdge without exact/edge.h")
        self.expect("\nEdgeSign s;\n", "use.cc:2: EdgeSign without exact/edge.h")
        self.expect("std::vector<int> v;\n", "std::vector without vector")

    def test_an_include_of_an_include_counts(self):
        self.expect('#include "exact/all.h"\nEdgeSign s;\nstd::vector<int> v;\n')

    def test_what_a_file_declares_itself_it_need_not_include(self):
        self.expect("struct EdgeSign;\nEdgeSign* s;\n")

    def test_words_and_what_belongs_to_another_are_not_looked_at(self):
        self.expect('// EdgeSign\nconst char* word = "SignOfEdge";\nint n = a.SignOfEdge();\n')


class LayersTest(unittest.TestCase):
    def expect(self, path, line, said=None):
        """A file of this one line is a violation of which `said` is reported, or fine if None."""
        files = {path: line + "\n", "exact/edge.h": "", "model/snap.h": "", "reference/plan.h": "",
                 "subjects/gl/gl.h": ""}  # fmt: skip
        status, output = run_check("check_layers", files)
        if said is None:
            self.assertEqual((status, output.count("\n")), (0, 1), output)
        else:
            self.assertEqual(status, 1, output)
            self.assertIn(said, output)

    def test_a_lower_layer_may_be_included(self):
        self.expect("exact/edge.cc", '#include "core/scene.h"')

    def test_a_higher_layer_may_not(self):
        self.expect("core/scene.cc", '#include "exact/edge.h"', "core/ may not see exact/")

    def test_reference_and_oracle_never_see_each_other(self):
        self.expect("exact/edge.cc", '#include "reference/plan.h"', "may not see reference/")
        self.expect("reference/plan.cc", '#include "exact/edge.h"', "may not see exact/")

    def test_placing_is_shared_but_for_those_that_hold_it(self):
        self.expect("reference/plan.cc", '#include "model/snap.h"')
        self.expect("exact/coverage.cc", '#include "model/snap.h"')
        self.expect("core/scene.cc", '#include "model/snap.h"', "core/ may not see model/")
        self.expect("reference/integer_form.h", '#include "model/snap.h"', "not for this file")
        self.expect("subjects/mutants/m.cc", '#include "model/snap.h"', "may not see model/")

    def test_only_the_builtin_subjects_see_the_reference(self):
        self.expect("subjects/builtin/b.cc", '#include "reference/plan.h"')
        self.expect("subjects/plugin/p.cc", '#include "reference/plan.h"', "may not see reference/")

    def test_subjects_do_not_see_each_other(self):
        self.expect("subjects/gl/gl.cc", '#include "subjects/gl/gl.h"')
        self.expect("subjects/plugin/p.cc", '#include "subjects/gl/gl.h"', "may not see subjects/")

    def test_third_parties_stay_in_their_folder(self):
        self.expect("exact/backend_cgal.cc", "#include <CGAL/Epick.h>")
        self.expect("exact/coverage.cc", "#include <CGAL/Epick.h>", "cgal is not for this file")
        self.expect("tests/props/gen.cc", "#include <rapidcheck.h>")
        self.expect("props/judging/sum.cc", "#include <rapidcheck.h>", "rapidcheck is not")
        self.expect("tool/main.cc", '#include "CLI/CLI.hpp"')
        self.expect("report/page.cc", '#include "CLI/CLI.hpp"', "cli11 is not for this file")

    def test_what_is_unknown_is_a_violation(self):
        self.expect("core/scene.cc", "#include <vector>")
        self.expect("core/scene.cc", "#include <eigen3/Eigen/Core>", "nor a third party")
        self.expect("core/scene.cc", '#include "core/absent.h"', "neither a file")
        self.expect("core/scene.cc", '#include "scene.h"', "neither a file")

    def test_links_follow_the_layers(self):
        core = "rasterproof_library(core SOURCES a.cc)\n"
        files = {"core/CMakeLists.txt": core}
        good = "rasterproof_library(exact SOURCES a.cc LINK rasterproof_core PRIVATE_LINK gmp)\n"
        status, output = run_check("check_layers", {**files, "exact/CMakeLists.txt": good})
        self.assertEqual(status, 0, output)
        builtin = "rasterproof_library(subjects SOURCES builtin/b.cc LINK rasterproof_reference)\n"
        reference = "rasterproof_library(reference SOURCES a.cc LINK rasterproof_core)\n"
        files |= {"reference/CMakeLists.txt": reference, "subjects/CMakeLists.txt": builtin}
        status, output = run_check("check_layers", files)
        self.assertEqual(status, 0, output)
        for bad in (
            "rasterproof_library(core SOURCES a.cc LINK fmt::fmt)\n",
            "rasterproof_library(core SOURCES a.cc PRIVATE_LINK rasterproof_io)\n",
            core + "target_link_libraries(rasterproof_core PRIVATE rasterproof_io)\n",
            core + "target_link_libraries(rasterproof_core PUBLIC Qt5::Core)\n",
            core + "target_link_libraries(rasterproof_core fmt::fmt)\n",
        ):
            io = "rasterproof_library(io SOURCES a.cc LINK rasterproof_core)\n"
            files = {"core/CMakeLists.txt": bad, "io/CMakeLists.txt": io}
            self.assertEqual(run_check("check_layers", files)[0], 1, bad)


class TextTest(unittest.TestCase):
    def expect(self, path, text, said=None):
        status, output = run_check("check_text", {path: text})
        self.assertEqual(status, 0 if said is None else 1, output)
        self.assertIn(said or "0 violations", output)

    def test_plain_text_passes(self):
        self.expect("core/scene.cc", "int width;\n")

    def test_each_kind_of_violation_is_seen(self):
        self.expect("core/scene.cc", "int\twidth;\n", "a tab")
        self.expect("core/scene.cc", "int width; \n", "blanks at the end")
        self.expect("core/scene.cc", "int width;", "no newline")
        self.expect("core/scene.cc", "// " + "x" * 98 + "\n", "101 columns")
        self.expect("core/scene.cc", "int i;\n" * 501, "501 lines")
        self.expect("core/scene.cc", "// TO" + "DO: all of it\n", "unfinished")
        glued = "//" + "/ one value. Error: none.\n"
        self.expect("core/scene.cc", glued, "in the middle of a line")
        self.expect("docs/build.md", "cd /ho" + "me/me/rasterproof\n", "a path of one machine")
        self.expect("core/vertex.h", GUARDED, "RASTERPROOF_CORE_VERTEX_H_")
        self.expect("core/scene_utils.cc", "int width;\n", "says nothing")
        self.expect("crash-5ac7280c", "x", "crash-5ac7280c: stray at the root")
        self.expect("README.md", "A page.\n")


class DefinitionsTest(unittest.TestCase):
    def expect(self, files, said=None):
        status, output = run_check("check_definitions", files)
        self.assertEqual(status, 0 if said is None else 1, output)
        self.assertIn(said or "0 violations", output)

    def in_two_files(self, first, second):
        wrapped = "namespace rasterproof::props {{\n{}\n}}  // namespace rasterproof::props\n"
        return {"props/a.h": wrapped.format(first), "props/b.cc": wrapped.format(second)}

    def test_a_type_that_two_files_define_is_seen(self):
        both = "rasterproof::props::Tally is defined in props/a.h:2 as well"
        self.expect(self.in_two_files("class Tally {};", "struct Tally final : Other { int n; };"),
                    both)  # fmt: skip
        self.expect(self.in_two_files("enum class Tally : int { kOne };", "struct Tally {};"), both)
        self.expect(self.in_two_files("struct A { struct B {}; };", "struct A::B {};"), "A::B")

    def test_types_that_are_not_one_are_let_be(self):
        self.expect(self.in_two_files("class Tally {};", "namespace {\nclass Tally {};\n}"))
        self.expect(self.in_two_files("class Tally {};", "void F() { struct Tally {}; }"))
        self.expect(self.in_two_files("class Tally {};", "class Tally;  // class Tally {};"))
        self.expect(self.in_two_files("struct A { struct B {}; };", "struct C { struct B {}; };"))
        self.expect(self.in_two_files("template <class T> struct A {};",
                                      "template <> struct A<int> {};"))  # fmt: skip

    def test_a_default_in_a_switch_over_an_enumeration_is_seen(self):
        switch = "int F(E e) {{ switch (e) {{ case E::kOne: {} {} }} return 0; }}"
        default = "default: return 2;"
        said = "a default in a switch over an enumeration"
        self.expect({"props/a.cc": switch.format("return 1;", default)}, said)
        self.expect({"props/a.cc": switch.format("return 1;", "case E::kTwo: return 2;")})
        inner = "switch (n) { case 0: return 1; " + default + " }"
        self.expect({"props/a.cc": switch.format(inner, "")})
        self.expect({"props/a.cc": switch.format(inner, default)}, said)
        self.expect({"props/a.cc": "int F(int n) { " + inner + " }"})

    def test_a_function_whose_last_bits_are_the_librarys_is_seen(self):
        said = "the last bits of {} are the library's"
        for call in ("hypot", "atan2", "exp2", "log", "powf"):
            body = f"double x = std::{call}(y, 1);\n"
            self.expect({"props/a.cc": body}, said.format(call))
            self.expect({"subjects/mutants/a.cc": body.replace("std::", "")}, said.format(call))
            self.expect({"report/a.cc": body})
        self.expect({"core/a.cc": "double F(double x) { return std::sqrt(x) + Hypot(x, 1); }"})


class PathsTest(unittest.TestCase):
    def expect(self, path, text, said=None):
        files = {"docs/decisions/why.md": "A page.\n", "props/run/tally.h": "", path: text}
        status, output = run_check("check_paths", files)
        self.assertEqual(status, 0 if said is None else 1, output)
        self.assertIn(f"{said} is neither" if said else "0 violations", output)

    def test_a_path_that_no_file_has_is_seen(self):
        self.expect("core/a.h", "// see core/scene.cc.\n", "core/scene.cc")
        self.expect("core/a.h", "int n;  /* see plugin/host.h */\n", "plugin/host.h")
        self.expect("core/a.h", "// As tally.cc does.\n", "tally.cc")
        self.expect("docs/a.md", "| `core/absent/` | [page](decisions/b.md) |\n",
                    "core/absent")  # fmt: skip
        self.expect("docs/a.md", "docs/decisions/no.md says why\n", "docs/decisions/no.md")
        self.expect("scripts/a", "#!/bin/sh\nrun  " + "# as in core/gone.h\n", "core/gone.h")
        self.expect("tests/a.py", 'def f():\n    """Of core/gone.h."""\n', "core/gone.h")

    def test_a_path_that_is_there_is_let_be(self):
        self.expect("core/a.h", "// core/scene.h, scene.h, run/tally.h, docs/decisions/why.md.\n")
        self.expect("docs/a.md", "[page](decisions/why.md), core/NAME.h, build/core/x.h\n")
        self.expect("docs/a.md", "https://example.org/core/absent.h and scene_main.cc\n")
        self.expect("docs/a.md", "`a62ee8b:core/absent.h` of a commit\n")
        self.expect("core/a.cc", 'Read("core/absent.h");\n')


class ReportTest(unittest.TestCase):
    def test_a_check_that_finds_nothing_to_look_at_fails(self):
        self.assertEqual(run_check("check_claims", {}), (1, "claims: 0 documents, 0 violations\n"))
        self.assertEqual(run_check("check_links", {}), (1, "links: 0 documents, 0 violations\n"))


class CountTest(unittest.TestCase):
    def count(self, status, **reports):
        with tempfile.TemporaryDirectory() as root:
            stage = pathlib.Path(root) / "release"
            stage.mkdir()
            for name, cases in reports.items():
                ending = "junit" if name == "ctest" else "xml"
                text = f"<testsuites><testsuite>{cases}</testsuite></testsuites>"
                (stage / f"{name}.{ending}").write_text(text, encoding="utf-8")
            command = [sys.executable, "-B", SCRIPTS / "count_tests", root, str(status)]
            return subprocess.check_output(command, text=True)

    def test_what_was_skipped_did_not_pass(self):
        own = ('<testcase name="a" status="run" result="completed"/>'
               '<testcase name="b" status="run" result="skipped"><skipped message="no"/></testcase>'
               '<testcase name="c" status="notrun" result="suppressed"/>')  # fmt: skip
        ctest = ('<testcase name="props_test" status="run"/>'
                 '<testcase name="tool_test" status="notrun"><skipped message="no"/></testcase>'
                 '<testcase name="old_test" status="disabled"/>')  # fmt: skip
        self.assertEqual(self.count(0, ctest=ctest, props_test=own),
                         "1 passed, 0 failed, 2 skipped\n")  # fmt: skip

    def test_failures_are_counted_wherever_they_come_from(self):
        failed = '<testcase name="a" status="run"><failure message="no"/></testcase>'
        held = '<testcase name="a" status="run" result="completed"/>'
        program = '<testcase name="props_test" status="fail"><failure message="1"/></testcase>'
        self.assertEqual(self.count(1, ctest=program, props_test=failed + held),
                         "1 passed, 1 failed\n")  # fmt: skip
        self.assertEqual(self.count(1, ctest=program, props_test=held), "1 passed, 1 failed\n")
        self.assertEqual(self.count(1, ctest=program), "0 passed, 1 failed\n")
        self.assertEqual(self.count(3, ctest='<testcase name="b" status="run"/>'),
                         "1 passed, 1 failed\n")  # fmt: skip


class PlantsTest(unittest.TestCase):
    def test_every_hunk_finds_its_place(self):
        patches = sorted((SCRIPTS / "patches").glob("*.patch"))
        self.assertGreater(len(patches), 18)
        for patch in patches:
            for part in patch.read_text(encoding="utf-8").split("\n--- a/")[1:]:
                path, *hunks = re.split(r"^@@.*$\n", part, flags=re.M)
                file = SCRIPTS.parent / path.splitlines()[0]
                text = file.read_text(encoding="utf-8")
                for hunk in hunks:
                    before = [line[1:] for line in hunk.splitlines() if line[:1] in (" ", "-")]
                    self.assertIn("\n".join(before), text, patch.name)

    def test_what_catches_one_stands_where_its_labels_say(self):
        tests = SCRIPTS.parent / "tests"
        texts = {path: path.read_text(encoding="utf-8") for path in tests.rglob("*.cc")}
        found = 0
        for patch in sorted((SCRIPTS / "patches").glob("*.patch")):
            fields = dict(re.findall(r"^# ([a-z ]+): *(.*)$", patch.read_text("utf-8"), re.M))
            for case in fields.get("caught by", "").split():
                suite, _, name = case.partition(".")
                macro = re.compile(rf"^TEST(_F)?\({suite},\s*{name}\)", re.M)
                rooms = {path.relative_to(tests).parts[0] for path, text in texts.items()
                         if macro.search(text)}  # fmt: skip
                found += len(rooms)
                # Of a parameter's tests the name is made elsewhere.
                if "/" not in case:
                    self.assertTrue(rooms & set(fields["labels"].split()), (patch.name, case))
        self.assertGreater(found, 40)


if __name__ == "__main__":
    unittest.main()
