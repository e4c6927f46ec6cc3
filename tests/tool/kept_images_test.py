"""Plugins that keep images: found where they look them up by too little, and only there.

usage: kept_images_test.py PROGRAM PLUGINS
"""
import os
import subprocess
import sys
import unittest

PROGRAM, PLUGINS = (os.path.abspath(path) for path in sys.argv[1:3])
PROPERTY = "NewVerticesGiveNewCoverage"
BY_A_COPY = "EarlierScenesLeaveNoTrace"
HOLDS, VIOLATED = 0, 1


def check(key, seed, *more):
    plugin = f"{PLUGINS}/shown_KEEPS_BY_{key}.so"
    return subprocess.run(
        [PROGRAM, "check", "--plugin", plugin, *(more or ("--property", PROPERTY)),
         "--seed", str(seed)],
        capture_output=True, text=True, timeout=900, check=False)  # fmt: skip


class KeptImages(unittest.TestCase):
    def test_those_found_by_too_little_are_found(self):
        for key in ("FLOOR", "SIXTEENTHS", "INDICES", "ADDRESSES"):
            for seed in (1, 2, 3):
                with self.subTest(key=key, seed=seed):
                    done = check(key, seed)
                    self.assertEqual(done.returncode, VIOLATED, done.stdout + done.stderr)

    def test_one_found_by_every_bit_holds(self):
        for seed in (1, 2, 3):
            with self.subTest(seed=seed):
                done = check("ALL", seed)
                self.assertEqual(done.returncode, HOLDS, done.stdout + done.stderr)

    def test_under_a_set_a_copy_of_the_plugin_finds_them(self):
        for key, expected in (("SIXTEENTHS", VIOLATED), ("ALL", HOLDS)):
            for profile, seed in (("vulkan", 1), ("gl", 2), ("vulkan", 3)):
                with self.subTest(key=key, profile=profile, seed=seed):
                    done = check(key, seed, "--property", BY_A_COPY, "--profile", profile)
                    self.assertEqual(done.returncode, expected, done.stdout + done.stderr)

    def test_where_equal_calls_need_not_be_equal_it_is_a_lack_of_quality(self):
        done = check("SIXTEENTHS", 1, "--property", BY_A_COPY, "--profile", "webgpu")
        self.assertEqual(done.returncode, HOLDS, done.stdout + done.stderr)
        self.assertIn("quality", done.stdout)


if __name__ == "__main__":
    unittest.main(argv=sys.argv[:1], verbosity=0)
