#!/usr/bin/env python3
"""`bench --kernels`: every kernel once, wrong samples, a plugin beside them; no times."""

import json
import os
import subprocess
import sys
import tempfile
import unittest

PROGRAM, SOURCES = (os.path.abspath(path) for path in sys.argv[1:3])
KERNELS = {"incremental", "tiles", "fixed-tiles", "scanline", "exact", "exact-unsafe"}


def bench(*arguments):
    return subprocess.run([PROGRAM, "bench", "--kernels", "--repetitions", "1", *arguments],
                          cwd=SOURCES, capture_output=True, timeout=300)  # fmt: skip


class BenchKernels(unittest.TestCase):
    def measured(self, *arguments):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "kernels.json")
            done = bench(*arguments, "--json", path)
            self.assertEqual(done.returncode, 0, done.stderr)
            with open(path, encoding="utf-8") as file:
                result = json.load(file)
        return {(row["sink"], row["method"]): row["wrong"] for row in result["rows"]}

    def test_every_kernel_is_there_and_the_exact_one_is_never_wrong(self):
        rows = self.measured("--scene", "scenes/drtk9.json")
        for sink in ("count8", "facing", "mask", "id", "depth"):
            here = {method for of, method in rows if of == sink}
            more = {"facing": {"rows"}, "mask": {"mask-rows"}}.get(sink, set())
            self.assertEqual(here, KERNELS | more, sink)
            self.assertEqual(rows[sink, "exact"], 0, sink)
        self.assertEqual(rows["facing", "rows"], 0)
        self.assertGreater(rows["facing", "fixed-tiles"], 0, "it snaps")

    def test_a_plugin_is_timed_beside_them_and_its_wrong_samples_counted(self):
        with tempfile.TemporaryDirectory() as folder:
            plugin = os.path.join(folder, "plugin.so")
            subprocess.run(
                ["cc", "-std=c11", "-O2", "-ffp-contract=off", "-shared", "-fPIC", "-I.",
                 "kit/examples/plugin.c", "-o", plugin, "-lm"],
                cwd=SOURCES, check=True)  # fmt: skip
            rows = self.measured("--scene", "scenes/ties.json", "--sink", "facing",
                                 "--method", "exact", "--plugin", plugin)  # fmt: skip
        self.assertEqual(set(rows), {("facing", "exact"), ("facing", "plugin")})
        self.assertEqual(rows["facing", "plugin"], 0)

    def test_what_is_not_there_is_said(self):
        for option, name in (("--method", "exactly"), ("--sink", "bits"), ("--target", "mmx")):
            done = bench("--scene", "scenes/ties.json", option, name)
            self.assertEqual(done.returncode, 2)
            self.assertIn(f"{option} {name}", done.stderr.decode())
            self.assertIn("choose of", done.stderr.decode())
        done = bench("--scene", "scenes/ties.json", "--plugin", "scenes/ties.json")
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("ties.json", done.stderr.decode())


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=2)
