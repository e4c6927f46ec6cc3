#!/usr/bin/env python3
"""The kernels on 64-bit Arm, under emulation: the same bits as on this machine.

usage: neon_test.py KERNEL_DIGESTS SOURCES WORK
Builds tests/library/kernel_digests.cc and what it draws by with Debian's cross compiler and
compares what it prints with KERNEL_DIGESTS, the same program of this machine. Exit status 77: a
package for it is missing.
"""

import os
import pathlib
import shutil
import subprocess
import sys

COMPILER, EMULATOR = "aarch64-linux-gnu-g++", "qemu-aarch64"
FLAGS = "-std=c++20 -O2 -Wall -Wextra -Wconversion -Werror -ffp-contract=off -static".split()
NEON = ["-march=armv8-a+crypto"]
ALONE = ["library/kernels/kernels_neon.cc"]
TOGETHER = """tests/library/kernel_digests.cc library/kernels/kernel.cc
  library/kernels/kernels_scalar.cc library/kernels/clip_fallback.cc
  library/kernels/exact_fallback.cc
  library/row_crossing.cc library/exact_sign.cc library/exact_sum.cc""".split()
FEWEST_LINES = 200


def lines(*command):
    done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=900)
    if done.returncode:
        sys.exit(f"{' '.join(command)} ended with status {done.returncode}\n{done.stderr}")
    return done.stdout.splitlines(), done.stderr


def main(native, sources, work):
    missing = [name for name in (COMPILER, EMULATOR) if shutil.which(name) is None]
    if missing:
        print(f"not run: {', '.join(missing)} missing; install g++-aarch64-linux-gnu, qemu-user")
        return 77
    work.mkdir(parents=True, exist_ok=True)
    highway = work / "include"  # the machine's other headers are not for Arm
    highway.mkdir(exist_ok=True)
    link = highway / "hwy"
    if not link.is_symlink():
        link.symlink_to("/usr/include/hwy")
    flags = [*FLAGS, f"-I{sources}", "-isystem", str(highway)]
    objects = []
    for path in ALONE:
        objects.append(str(work / (pathlib.Path(path).stem + ".o")))
        lines(COMPILER, *flags, *NEON, "-c", os.path.join(sources, path), "-o", objects[-1])
    program = str(work / "kernel_digests")
    lines(COMPILER, *flags, *(os.path.join(sources, path) for path in TOGETHER), *objects,
          "-o", program)  # fmt: skip
    ours, _ = lines(native)
    theirs, said = lines(EMULATOR, program)
    print(said, end="")
    assert "target neon" in said, "the program has no kernels for NEON"
    assert len(ours) >= FEWEST_LINES, f"{len(ours)} digests"
    different = [a for a, b in zip(ours, theirs) if a != b]
    assert ours == theirs, "other bits on Arm:\n" + "\n".join(different[:20])
    print(f"{len(ours)} digests alike")
    return 0


sys.exit(main(sys.argv[1], os.path.abspath(sys.argv[2]), pathlib.Path(sys.argv[3])))
