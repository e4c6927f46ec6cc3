"""sweep: which builds of a rasterizer draw other samples, and by which flags, file and function.

usage: sweep_test.py PROGRAM SOURCES
"""
import functools
import json
import os
import shutil
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCES = (os.path.abspath(path) for path in sys.argv[1:3])
OWN = os.path.join(SOURCES, "tests", "tool", "sweep")
MORE = "RASTERPROOF_MORE" in os.environ  # scripts/test_more

BUILD = ("--build", "-O3")  # where it does not matter which builds there are
HARMLESS = ("-O3 -ffp-contract=off", "-O2 -march=x86-64-v3 -ffp-contract=off",
            "-O2 -ffp-contract=fast")  # fmt: skip
FUSED = "-O2 -march=x86-64-v3 -ffp-contract=fast"
CONTRACTING = (FUSED, f"clang {FUSED}", "aarch64 -O2 -ffp-contract=fast")


def sweep(*names, cases=20, **kept):
    """The ended command, and its JSON: {} where it wrote none."""
    with tempfile.TemporaryDirectory() as folder:
        file = os.path.join(folder, "sweep.json")
        environment = {**os.environ, "TMPDIR": folder, **kept.pop("env", {})}
        done = subprocess.run(
            [PROGRAM, "sweep", *(os.path.join(OWN, name) for name in names), "--json", file,
             "--cases", str(cases), *kept.pop("more", [])],
            capture_output=True, text=True, timeout=900, check=False, env=environment,
        )  # fmt: skip
        result = {}
        if os.path.exists(file):
            with open(file, encoding="utf-8") as opened:
                result = json.load(opened)
            os.remove(file)
        assert not os.listdir(folder), "its temporary folder is left"
        return done, result


@functools.cache
def robust():
    return sweep("robust.c", cases=40)


@functools.cache
def contracted_edges():
    # Every compiler and target that can contract, but not those of the usual list that can't.
    builds = (*HARMLESS, *CONTRACTING)
    return sweep("contracted.c", "edge.c",
                 more=[word for build in builds for word in ("--build", build)])  # fmt: skip


def rows_of(result):
    """Each build's words, whether it is drawn, samples and cases that it changes, and its model."""
    cells = result["subjects"][0]["cells"]
    return [{**row, "changes": row["summary"], "drawn": row["theme"] != "no group",
             "group": row["theme"], "samples": cell["base"]["wrong_samples"],
             "cases": cell["base"]["wrong"], "why": cell["base"]["why"], "model": cell["model"]}
            for row, cell in zip(result["builds"], cells)]  # fmt: skip


def groups_of(result):
    return {row["group"]: row["model"] for row in rows_of(result) if row["drawn"]}


def flags_of(result):
    return {row["flags"]: row for row in result["builds"] if "flags" in row}


class Sweep(unittest.TestCase):
    def test_contraction_is_found_with_its_flags_file_and_function(self):
        done, result = contracted_edges()
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        rows = {row["changes"]: row for row in rows_of(result)}
        self.assertEqual(rows[""]["samples"], 0)
        self.assertIn("; flags: -march=x86-64-v3 -ffp-contract=fast; file: ", done.stdout)
        for harmless in HARMLESS:
            self.assertEqual(rows[harmless]["samples"], 0, rows[harmless])
        contracted = rows[FUSED]
        if contracted["drawn"]:
            self.assertGreater(contracted["samples"], 0)
            self.assertGreater(contracted["cases"], 0)
            self.assertRegex(
                contracted["first"],
                r"^[a-z0-9-]+:\d+@1, pixel \(\d+, \d+\): covered \d+ times in place of \d+$",
            )
            blamed = flags_of(result)["-march=x86-64-v3 -ffp-contract=fast"]
            self.assertTrue(blamed["file"].endswith("edge.c"), blamed)
            self.assertEqual((blamed["function"], blamed.get("remark")), ("cross", None))
        for flags, blamed in flags_of(result).items():
            self.assertIn("-ffp-contract", flags)
            self.assertTrue(blamed["file"].endswith("edge.c"), blamed)
            self.assertEqual((blamed["function"], blamed.get("remark")), ("cross", None), flags)
        for row in rows_of(result):
            if row["changes"] == "target aarch64 -O2 -ffp-contract=fast" and row["drawn"]:
                self.assertTrue(row["note"].startswith("emulated"), row)
                self.assertGreater(row["samples"], 0, "aarch64 has fused multiply-add")

    def test_regrouped_sums_are_found_with_the_least_flags(self):
        done, result = sweep("regrouped.c", cases=20, more=[
            "--build", "-ffast-math", "--build", "i386 -O2 -ffp-contract=off -mfpmath=387",
            "--build", "-fassociative-math"])  # fmt: skip
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        least = [set(flags.split()) for flags in flags_of(result)]
        companions = {"-fassociative-math", "-fno-signed-zeros", "-fno-trapping-math"}
        self.assertIn(companions, least)
        for flags in least:
            self.assertFalse(flags > companions, f"{flags} are not the least")
        wide = flags_of(result).get("-mfpmath=387")
        if any(row["drawn"] and "387" in row["changes"] for row in rows_of(result)):
            self.assertIsNotNone(wide, least)
            self.assertTrue(wide["file"].endswith("regrouped.c"), wide)

    def test_integers_after_the_snap_agree_in_all_builds(self):
        done, result = robust()
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        drawn = [row for row in rows_of(result) if row["drawn"]]
        self.assertGreater(len(drawn), 8, done.stdout)
        self.assertEqual({row["group"] for row in drawn}, {"group A"})
        self.assertEqual(flags_of(result), {})
        self.assertIn("\ngroup A: ", done.stdout)
        self.assertNotIn("group B", done.stdout)

    def test_what_the_target_alone_changes_is_not_told_apart(self):
        _, result = sweep("signed_char.c", cases=20, more=[
            "--build", "aarch64 -O2 -ffp-contract=off"])  # fmt: skip
        (_, other) = rows_of(result)
        if other["drawn"]:
            (blamed,) = flags_of(result).values()
            self.assertFalse({"file", "function"} & blamed.keys(), blamed)
            self.assertIn("objects of two processors can't be linked", blamed["remark"])

    def test_our_own_methods_are_swept_as_the_page_of_stiff_cases_says(self):
        sources = ("methods.cc", *(f"../../../reference/{name}.cc" for name in ("box", "bands")))
        for method, fused in (("F32Direct", True), ("I64Snap8", False))[:None if MORE else 1]:
            done, result = sweep(*sources, cases=20, more=[
                "--cflags", f"-std=c++20 -I{SOURCES} -DMETHOD={method}", "--build", FUSED])
            (base, contracted) = rows_of(result)
            self.assertTrue(base["drawn"], done.stdout + done.stderr)
            if contracted["drawn"]:
                self.assertEqual(contracted["samples"] > 0, fused, done.stdout)
                self.assertEqual(done.returncode, 1 if fused else 0)

    def test_groups_say_how_far_they_are_from_the_model(self):
        done, result = robust()
        (group,) = groups_of(result).values()
        self.assertEqual((group["wrong_samples"], group["wrong"]), (0, 0), group)
        self.assertGreater(group["samples"], 100000)
        self.assertEqual(group["cases"] + group["excused"], 40)
        drawn = sum(row["drawn"] for row in rows_of(result))
        self.assertIn(f"; model: {drawn} builds stand, 0 fail, ", done.stdout)

    def test_no_group_of_a_source_that_draws_nothing_is_right(self):
        done, result = sweep("nothing.c", cases=40, more=BUILD)
        self.assertEqual(done.returncode, 0, "all builds agree")
        self.assertEqual({row["group"] for row in rows_of(result) if row["drawn"]}, {"group A"})
        (group,) = groups_of(result).values()
        self.assertGreater(group["wrong_samples"], 10000)
        self.assertGreater(group["wrong"], 20)

    def test_groups_of_a_fragile_source_are_apart_by_what_they_change(self):
        _, result = contracted_edges()
        groups = groups_of(result)
        self.assertGreater(len(groups), 1)
        self.assertEqual(len({g["samples"] for g in groups.values()}), 1)
        changed = {row["group"]: row["samples"] for row in rows_of(result) if row["drawn"]}
        for name, group in groups.items():
            self.assertGreater(group["wrong_samples"], 0, "samples on edges are covered twice")
            apart = abs(group["wrong_samples"] - groups["group A"]["wrong_samples"])
            self.assertLessEqual(apart, changed[name], name)

    def test_what_the_profile_leaves_free_is_not_away(self):
        _, result = sweep("robust.c", cases=10, more=["--profile", "vulkan", *BUILD])
        self.assertEqual(groups_of(result)["group A"]["wrong_samples"], 0, result)
        _, result = sweep("nothing.c", cases=10, more=["--profile", "vulkan", *BUILD])
        self.assertGreater(groups_of(result)["group A"]["wrong_samples"], 100)

    def test_a_profile_that_states_no_coverage_is_not_compared(self):
        with tempfile.TemporaryDirectory() as folder:
            profile = os.path.join(folder, "none.json")
            with open(profile, "w", encoding="utf-8") as file:
                json.dump({"name": "none", "contract": "none"}, file)
            done, result = sweep("nothing.c", cases=3, more=["--profile", profile, *BUILD])
        group = groups_of(result)["group A"]
        self.assertIn("the profile's contract states nothing about coverage", group["why"])
        self.assertEqual(group["cases"], 0)
        self.assertIn("excused", done.stdout)

    def test_a_processor_without_an_instruction_set_is_a_row(self):
        _, result = robust()
        rows = {row["changes"]: row for row in rows_of(result)}
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            has_avx512 = "avx512vl" in file.read()
        row = rows["-march=x86-64-v4"]
        self.assertEqual(row["drawn"], has_avx512)
        if not has_avx512:
            self.assertEqual(row["note"], "this processor lacks x86-64-v4 (AVX-512)")

    def test_a_build_that_hangs_is_stopped_and_its_row_says_so(self):
        done, result = sweep("hangs.c", cases=3, more=[
            "--time-limit", "1", "--build", "-ffast-math", "--build", "-O3"])  # fmt: skip
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        for row in rows_of(result):
            if "-ffast-math" in row["changes"]:
                self.assertFalse(row["drawn"])
                self.assertRegex(row["why"], r"^stopped on [a-z-]+:\d+@1: "
                                              r"(no answer within|its cases took more than) ")
            else:
                self.assertNotIn("stopped", row["why"])
            if row["drawn"]:
                self.assertEqual(row["samples"], 0, row)

    def test_a_missing_tool_is_a_row_that_names_its_package(self):
        with tempfile.TemporaryDirectory() as tools:
            for name in ("gcc", "g++", "as", "ld", "sh", "objcopy"):
                if shutil.which(name):
                    os.symlink(shutil.which(name), os.path.join(tools, name))
            done, result = sweep("robust.c", cases=3, env={"PATH": tools})
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        notes = {row["changes"]: row["why"] for row in rows_of(result)}
        self.assertIn("there is no clang-19; package clang-19", notes["compiler clang-19"])
        self.assertIn("package gcc-aarch64-linux-gnu has it", notes["target aarch64"])

    def test_what_is_no_source_is_refused(self):
        for name, says in (("absent.c", "there is no such file"),
                           ("../sweep_test.py", "is not named as a C or C++ source")):  # fmt: skip
            done, _ = sweep(name)
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(says, done.stderr)

    def test_a_result_that_could_not_be_written_is_refused_before_any_build(self):
        done = subprocess.run([PROGRAM, "sweep", os.path.join(OWN, "edge.c"), "--json",
                               "no-such-folder/sweep.json"],
                              capture_output=True, text=True, timeout=900, check=False)  # fmt: skip
        self.assertEqual(done.returncode, 2, "the sources, which don't build, were not looked at")
        self.assertIn("no-such-folder/sweep.json: can't be written", done.stderr)

    def test_a_base_that_is_not_built_shows_the_first_error(self):
        done, _ = sweep("edge.c")
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("undefined reference to `rasterproof_plugin_describe'", done.stderr)
        with tempfile.TemporaryDirectory() as folder:
            broken = os.path.join(folder, "broken.c")
            with open(broken, "w", encoding="utf-8") as file:
                file.write("int ok;\nint wrong(void) { return absent; }\n")
            done, _ = sweep("robust.c", broken)
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertRegex(done.stderr, r"broken\.c:2:\d+: error: .absent. undeclared")

    def test_flags_for_every_build_are_words_of_a_shell(self):
        done, _ = sweep("robust.c", cases=1, more=["--cflags", "-D'unused macro' -D", *BUILD])
        self.assertEqual(done.returncode, 3, "the last -D lacks its name")
        done, _ = sweep("robust.c", cases=1, more=["--cflags", "'-DA=(1 + 1)' -Wall", *BUILD])
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_builds_in_the_users_words_take_the_place_of_the_list(self):
        done, result = sweep("robust.c", cases=2, more=[
            "--build", "clang -O3", "--build", "-O0 -ffast-math", "--build", "gcc"])  # fmt: skip
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        names = [row["name"] for row in rows_of(result)]
        self.assertCountEqual(names, ["gcc -march=x86-64 -O2 -ffp-contract=off",
                                 "clang -march=x86-64 -O3 -ffp-contract=on",
                                 "gcc -march=x86-64 -O0 -ffast-math -ffp-contract=fast",
                                 "gcc -march=x86-64 -O0 -ffp-contract=fast"])  # fmt: skip

    def test_a_build_of_the_user_contracts_as_its_compiler_does(self):
        with open("/proc/cpuinfo", encoding="utf-8") as file:
            if "fma" not in file.read().split():
                self.skipTest("this processor has no fused multiply-add")
        done, result = sweep("contracted.c", "edge.c",
                             more=["--build", "g++ -O3 -march=x86-64-v3"])  # fmt: skip
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        (flags,) = flags_of(result)
        self.assertEqual(flags, "-march=x86-64-v3 -ffp-contract=fast")

    def test_a_word_of_a_build_that_is_none_is_refused(self):
        done, _ = sweep("robust.c", more=["--build", "msvc -O3"])
        self.assertEqual((done.returncode, done.stdout), (2, ""))
        self.assertIn("--build: 'msvc': is not a flag, compiler or target", done.stderr)

    def test_doctor_lists_the_tools(self):
        done = subprocess.run([PROGRAM, "doctor"], capture_output=True, text=True, check=False)
        self.assertRegex(done.stdout, r"sweep: gcc +(/|missing; package gcc has it)")
        self.assertRegex(done.stdout, r"sweep: qemu-aarch64 +(/|missing; package qemu-user has it)")


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1])
