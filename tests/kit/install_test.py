"""What `cmake --install` installs: moved elsewhere, a user's project builds and tests with it.

usage: install_test.py CMAKE BUILD SOURCES
"""
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

CMAKE = sys.argv[1]
BUILD, SOURCES = (os.path.realpath(path) for path in sys.argv[2:4])
CONSUMER = os.path.join(SOURCES, "tests/kit/consumer")
HEADERS = ("kit/bitmap_plugin.h", "kit/filter_plugin.h", "kit/fuzz.h", "kit/gtest.h",
           "kit/hard_scenes.h", "kit/plugin_server.h", "kit/rapidcheck.h", "library/rasterize.h",
           "kit/rasterproof_oracle.h", "kit/rasterproof_plugin.h",
           "library/rasterproof_rasterize.h")  # fmt: skip


def run(*command, **options):
    return subprocess.run(command, capture_output=True, text=True, timeout=900, check=False,
                          **options)  # fmt: skip


def outcomes(done):
    """Of a GoogleTest program: its tests by outcome."""
    found = {"OK": set(), "FAILED": set(), "SKIPPED": set()}
    line = re.compile(r"^\[ +(OK|FAILED|SKIPPED) +\] (\w+\.\w+) \(", re.M)
    for outcome, name in line.findall(done.stdout):
        found[outcome].add(name)
    return found


class Installed(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        first = os.path.join(cls.folder.name, "first")
        cls.prefix = os.path.join(cls.folder.name, "moved/to here")
        done = run(CMAKE, "--install", BUILD, "--prefix", first)
        assert done.returncode == 0, done.stderr
        os.makedirs(os.path.dirname(cls.prefix))
        os.rename(first, cls.prefix)
        cls.command = os.path.join(cls.prefix, "bin/rasterproof")
        cls.own = os.path.join(cls.folder.name, "own")
        cls.configured = cls.configure(CONSUMER, cls.own,
                                       f"-DEXAMPLES={SOURCES}/kit/examples")  # fmt: skip
        cls.built = run(CMAKE, "--build", cls.own, "--parallel", "2")

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @classmethod
    def configure(cls, sources, build, *options):
        return run(CMAKE, "-S", sources, "-B", build, "-G", "Ninja",
                   f"-DCMAKE_PREFIX_PATH={cls.prefix}", *options)  # fmt: skip

    def suite(self, program, *options, **variables):
        return run(os.path.join(self.own, program), *options, env={**os.environ, **variables},
                   cwd=self.folder.name)  # fmt: skip

    def test_holds_no_path_of_the_tree_it_came_from(self):
        for folder, _, files in os.walk(self.prefix):
            for name in files:
                with open(os.path.join(folder, name), "rb") as file:
                    content = file.read()
                for path in (BUILD, SOURCES):
                    self.assertNotIn(path.encode(), content, os.path.join(folder, name))

    def test_finds_its_scenes_wherever_it_lies(self):
        done = run(self.command, "check", "scenes/ties.json", "--property",
                   "CoverageEqualsTheModel", cwd="/")  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stderr)
        done = run(self.command, "sweep", os.path.join(SOURCES, "kit/examples/plugin.c"), "--cases",
                   "2", "--build", "-O3", cwd=self.folder.name)  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def test_documents_link_to_what_is_installed(self):
        done = run(sys.executable, "-B", os.path.join(SOURCES, "scripts/check_links"), self.prefix)
        self.assertEqual(done.returncode, 0, done.stdout)
        documents = os.path.join(self.prefix, "share/doc/rasterproof/docs")
        for name in ("wrong-tests.md", "wrong-tests", "decisions"):
            self.assertTrue(os.path.exists(os.path.join(documents, name)), name)

    def test_headers_need_no_other_folder(self):
        for header in HEADERS:
            path = os.path.join(self.prefix, "include/rasterproof", header)
            self.assertTrue(os.path.isfile(path), path)
        text = "".join(f'#include <rasterproof/{header}>\n' for header in HEADERS)
        done = run("c++", "-std=c++20", "-Wall", "-Wextra", "-Werror", "-fsyntax-only", "-x", "c++",
                   "-I", os.path.join(self.prefix, "include"), "-", input=text)  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_of_an_older_standard_the_header_says_what_it_needs(self):
        done = run("c++", "-std=c++14", "-fsyntax-only", "-x", "c++", "-", input="#include "
                   f'"{self.prefix}/include/rasterproof/kit/gtest.h"\n')  # fmt: skip
        self.assertIn("kit/gtest.h needs C++17", done.stderr)

    def test_project_builds_and_its_tests_say_what_is_right(self):
        self.assertEqual(self.configured.returncode, 0, self.configured.stderr)
        self.assertEqual(self.built.returncode, 0, self.built.stdout)
        done = run("ctest", "--test-dir", self.own, "--output-on-failure")
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertRegex(done.stdout, r"100% tests passed.* out of 6")
        self.assertEqual(run(os.path.join(self.own, "own_fuzzer"), "-runs=1").returncode, 0)

    def test_a_right_rasterizer_passes_every_property_that_applies(self):
        found = outcomes(done := self.suite("suites_test", "--gtest_filter=Right.*"))
        self.assertEqual(found["FAILED"], set(), done.stdout)
        self.assertIn("Right.CoverageEqualsTheModel", found["OK"])
        self.assertEqual(done.returncode, 0)

    def test_a_property_that_does_not_apply_has_no_test(self):
        listed = self.suite("suites_test", "--gtest_list_tests").stdout
        self.assertIn("  CoverageEqualsTheModel", listed)
        self.assertNotIn("ScissorOnlyCutsCoverage", listed)  # the subject takes no scissor
        self.assertNotIn("DepthIsTheInterpolated", listed)
        done = self.suite("suites_test", "--gtest_filter=Right.*",
                          RASTERPROOF_CHECK_OPTIONS="--cases 3")  # fmt: skip
        # A program on a pipe is not asked for large targets, case by case.
        self.assertEqual(outcomes(done)["SKIPPED"], {"Right.LargeTargetIsCoveredLikeASmallOne"})

    def test_causes_are_told_once_a_suite_and_saved_files_have_its_name(self):
        saved = os.path.join(self.folder.name, "saved")
        done = self.suite("mine_test", "--gtest_filter=*.SharedEdgeSamplesAreCoveredOnce:"
                          "*.CoverageEqualsTheModel",
                          RASTERPROOF_CHECK_OPTIONS=f"--save {saved}")  # fmt: skip
        self.assertEqual(len(outcomes(done)["FAILED"]), 2, done.stdout)
        self.assertEqual(len(re.findall(r"^cause: ", done.stdout, re.M)), 1, done.stdout)
        self.assertEqual(done.stdout.count("causes: see the suite's first failure"), 1)
        self.assertEqual(set(os.listdir(saved)),
                         {"Textbook-CoverageEqualsTheModel.json",
                          "Textbook-SharedEdgeSamplesAreCoveredOnce.json"})  # fmt: skip
        self.assertNotRegex(done.stdout, r"front \d, back \d")

    def test_a_wrong_one_fails_with_what_the_command_prints_and_replays(self):
        done = self.suite("mine_test", "--gtest_filter=*.SharedEdgeSamplesAreCoveredOnce",
                          TEST_TMPDIR=self.folder.name)  # fmt: skip
        self.assertEqual(outcomes(done)["FAILED"], {"Textbook.SharedEdgeSamplesAreCoveredOnce"})
        self.assertIn("observed covered 2 times, expected exactly once", done.stdout)
        replay = re.search(r"^replay: rasterproof (.*)$", done.stdout, re.M).group(1)
        again = run("sh", "-c", f'"$0" {replay}', self.command)
        self.assertEqual(again.returncode, 1, again.stderr)
        self.assertIn("observed covered 2 times, expected exactly once", again.stdout)

    def test_a_known_failure_is_skipped_with_its_owner_and_day(self):
        name = "Textbook.SharedEdgeSamplesAreCoveredOnce"
        temporary = os.path.join(self.folder.name, "temporary")
        os.makedirs(temporary)
        for subject, until, outcome in (
                ("Textbook", "2999-12-31", "SKIPPED"), (None, "2999-12-31", "SKIPPED"),
                ("Other", "2999-12-31", "FAILED"), ("Textbook", "2001-12-31", "FAILED")):
            entry = {"property": name.split(".")[1], "owner": "ada@example.org", "until": until}
            if subject:
                entry["subject"] = subject
            done = self.known_suite(temporary, name, entry)
            self.assertEqual(outcomes(done)[outcome], {name}, done.stdout)
            if outcome == "SKIPPED":
                self.assertIn("ada@example.org fixes it by 2999-12-31", done.stdout)
        name = "Textbook.TriangleOrderKeepsCoverage"
        passes = {"property": name.split(".")[1], "subject": "Textbook", "owner": "ada",
                  "until": "2999-12-31"}  # fmt: skip
        done = self.known_suite(temporary, name, passes)
        self.assertEqual(outcomes(done)["OK"], {name}, done.stdout)
        self.assertRegex(done.stdout, "\npasses .*passes now; tell ada")
        self.assertEqual(os.listdir(temporary), [])
        self.assertTrue(os.path.exists(os.path.join(self.own, "mine_test.Textbook.subject")))

    def known_suite(self, temporary, name, entry):
        path = os.path.join(self.folder.name, "known.json")
        with open(path, "w", encoding="utf-8") as file:
            json.dump({"rasterproof_known_failures": 1, "failures": [entry]}, file)
        return self.suite("mine_test", "--gtest_filter=" + name, TEST_TMPDIR=temporary,
                          RASTERPROOF_CHECK_OPTIONS="--known " + path)

    def test_a_crash_a_hang_and_a_refusal_fail_their_tests_alone(self):
        done = self.suite("suites_test", "--gtest_filter=Crashing.ClosedMeshCancels:"
                          "Crashing.DegenerateTrianglesCoverNothing:"
                          "Refusing.CoverageEqualsTheModel:Hanging.ClosedMeshCancels",
                          RASTERPROOF_CHECK_OPTIONS="--time-limit 0.5")  # fmt: skip
        found = outcomes(done)
        self.assertIn("Hanging.ClosedMeshCancels", found["FAILED"])
        self.assertIn("it hangs: ", done.stdout)
        self.assertIn("Refusing.CoverageEqualsTheModel", found["FAILED"])
        self.assertIn("Crashing.ClosedMeshCancels", found["FAILED"])
        self.assertIn("Crashing.DegenerateTrianglesCoverNothing", found["OK"], done.stdout)

    def test_without_the_command_one_test_says_so(self):
        done = self.suite("mine_test", RASTERPROOF_COMMAND="/nowhere/rasterproof")
        self.assertEqual(outcomes(done)["FAILED"], {"Textbook.TheCommandRuns"})
        self.assertIn("/nowhere/rasterproof can't be run; set RASTERPROOF_COMMAND", done.stdout)

    def test_a_component_that_is_not_there_is_named(self):
        there = "There is no component oracel; there are rasterize, oracle, kit"
        for wanted, said in (("oracel", there), ("rasterize", None)):
            with tempfile.TemporaryDirectory() as folder:
                with open(os.path.join(folder, "CMakeLists.txt"), "w", encoding="utf-8") as file:
                    file.write("cmake_minimum_required(VERSION 3.25)\nproject(x LANGUAGES CXX)\n"
                               f"find_package(rasterproof 0.2 REQUIRED COMPONENTS {wanted})\n")
                done = self.configure(folder, os.path.join(folder, "build"))
            self.assertEqual(done.returncode == 0, said is None, done.stderr)
            self.assertIn(said or "", " ".join(done.stderr.split()))


class InAnotherTree(unittest.TestCase):
    def test_as_a_part_of_another_project_it_adds_targets_and_no_flags(self):
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "CMakeLists.txt"), "w", encoding="utf-8") as file:
                file.write("cmake_minimum_required(VERSION 3.25)\nproject(x LANGUAGES C CXX)\n"
                           "include(FetchContent)\n"
                           f'FetchContent_Declare(rasterproof SOURCE_DIR "{SOURCES}")\n'
                           "set(RASTERPROOF_LIBRARY_ONLY ON)\n"
                           "FetchContent_MakeAvailable(rasterproof)\n"
                           "file(WRITE x.cc [[#include <rasterproof/library/rasterize.h>\n"
                           "int main() {}]])\n"
                           "add_executable(x x.cc)\n"
                           "target_compile_features(x PRIVATE cxx_std_20)\n"
                           "target_link_libraries(x PRIVATE rasterproof::rasterize)\n"
                           'message(STATUS "flags [${CMAKE_CXX_FLAGS_RELEASE}]"\n'
                           '  " [${CMAKE_CXX_STANDARD}]")\n'
                           "install(FILES x.cc DESTINATION share)\n")  # fmt: skip
            build = os.path.join(folder, "build")
            done = run(CMAKE, "-S", folder, "-B", build, "-G", "Ninja",
                       "-DCMAKE_CXX_FLAGS=-ffast-math")  # fmt: skip
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("flags [-O3 -DNDEBUG] []", done.stdout)
            done = run(CMAKE, "--build", build, "--target", "CMakeFiles/x.dir/x.cc.o",
                       "_deps/rasterproof-build/library/CMakeFiles/rasterproof_rasterize.dir/"
                       "row_crossing.cc.o")  # fmt: skip
            self.assertEqual(done.returncode, 0, done.stdout)
            with open(os.path.join(build, "build.ninja"), encoding="utf-8") as file:
                self.assertNotIn("-Werror", file.read())

    def test_the_whole_tree_in_another_project_has_the_targets_of_tests_and_of_own_commands(self):
        with tempfile.TemporaryDirectory() as folder:
            with open(os.path.join(folder, "CMakeLists.txt"), "w", encoding="utf-8") as file:
                file.write("cmake_minimum_required(VERSION 3.25)\nproject(x LANGUAGES C CXX)\n"
                           "include(FetchContent)\n"
                           f'FetchContent_Declare(rasterproof SOURCE_DIR "{SOURCES}")\n'
                           "FetchContent_MakeAvailable(rasterproof)\n"
                           "find_package(GTest REQUIRED)\n"
                           f'add_executable(t "{SOURCES}/kit/examples/gtest/mine_test.cc")\n'
                           "target_compile_features(t PRIVATE cxx_std_17)\n"
                           "target_link_libraries(t PRIVATE rasterproof::gtest "
                           "GTest::gtest_main)\n"
                           f'add_executable(own "{SOURCES}/kit/examples/own_type.cc")\n'
                           "target_compile_features(own PRIVATE cxx_std_20)\n"
                           "target_link_libraries(own PRIVATE rasterproof::command)\n")  # fmt: skip
            build = os.path.join(folder, "build")
            done = run(CMAKE, "-S", folder, "-B", build, "-G", "Ninja")
            self.assertEqual(done.returncode, 0, done.stderr)
            # The whole command takes minutes to build: the test's own object does not.
            asked = run("ninja", "-C", build, "-t", "commands", "CMakeFiles/t.dir"
                        f"{SOURCES}/kit/examples/gtest/mine_test.cc.o")  # fmt: skip
            done = run("sh", "-c", asked.stdout.splitlines()[-1], cwd=build)
            self.assertEqual(done.returncode, 0, done.stderr)
            asked = run("ninja", "-C", build, "-t", "query", "t")
            self.assertRegex(asked.stdout, r"_deps/rasterproof-build/rasterproof\n")
            with open(os.path.join(build, "build.ninja"), encoding="utf-8") as file:
                told = file.read()
            self.assertIn(f'RASTERPROOF_COMMAND=\\"{build}/_deps/rasterproof-build/rasterproof\\"',
                          told)  # fmt: skip
            self.assertNotIn("-Werror", told)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
