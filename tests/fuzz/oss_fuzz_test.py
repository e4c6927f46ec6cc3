#!/usr/bin/env python3
"""fuzz/oss-fuzz/build.sh, run unchanged under OSS-Fuzz's contract.

usage: oss_fuzz_test.py SOURCES WORK [SANITIZER ...]

Without a sanitizer named: address and undefined. Each wants a build of some minutes; WORK keeps it.
The flags are those of OSS-Fuzz's base-builder, the thresholds those of its bad_build_check. Only
the clang is Debian's: its libc++ is a shared library, and its libFuzzer wants libstdc++ beside it.
Exit status 77: a package for it is missing.
"""
import os
import re
import shutil
import subprocess
import sys
import zipfile

SOURCES, WORK = (os.path.abspath(path) for path in sys.argv[1:3])
SANITIZERS = sys.argv[3:] or ["address", "undefined"]

CLANG = "clang++-19"
COMMON = """-O1 -fno-omit-frame-pointer -gline-tables-only
 -Wno-error=incompatible-function-pointer-types
 -Wno-error=int-conversion -Wno-error=deprecated-declarations
 -Wno-error=implicit-function-declaration -Wno-error=implicit-int
 -Wno-error=unknown-warning-option -Wno-error=vla-cxx-extension
 -DFUZZING_BUILD_MODE_UNSAFE_FOR_PRODUCTION""".split()
UNRECOVERED = (
    "array-bounds,bool,builtin,enum,function,integer-divide-by-zero,null,object-size,return,"
    "returns-nonnull-attribute,shift,signed-integer-overflow,unreachable,vla-bound,vptr"
)
SANITIZER_FLAGS = {
    "address": ["-fsanitize=address", "-fsanitize-address-use-after-scope"],
    "undefined": [f"-fsanitize={UNRECOVERED},unsigned-integer-overflow",
                  f"-fno-sanitize-recover={UNRECOVERED}"],
}  # fmt: skip
OPTIONS = {
    "ASAN_OPTIONS": "alloc_dealloc_mismatch=0:allocator_may_return_null=1"
                    ":detect_stack_use_after_return=0:handle_abort=1"
                    ":max_uar_stack_size_log=16:symbolize=0",
    "UBSAN_OPTIONS": "print_stacktrace=1:silence_unsigned_overflow=1:symbolize=0",
}  # fmt: skip
# Calls of the sanitizer's own functions in a target: the least for its build, the most for another.
FEWEST_ASAN_CALLS, FEWEST_UBSAN_CALLS = 1000, 168
MOST_ASAN_CALLS_ELSEWHERE, MOST_UBSAN_CALLS_ELSEWHERE = 0, 200
FEWEST_EDGES = 100
# The libraries of the image that runs targets, and those that replace its static libc++ here.
BASE = {"linux-vdso.so.1", "libc.so.6", "libm.so.6", "libpthread.so.0", "libdl.so.2", "librt.so.1",
        "libgcc_s.so.1", "libresolv.so.2", "ld-linux-x86-64.so.2"}  # fmt: skip
STAND_INS = {"libc++.so.1", "libc++abi.so.1", "libunwind.so.1", "libstdc++.so.6"}


def build(sanitizer):
    """Runs build.sh as OSS-Fuzz does; returns the folder that it filled."""
    out, work, src = (os.path.join(WORK, sanitizer, name) for name in ("out", "work", "src"))
    shutil.rmtree(out, ignore_errors=True)
    for folder in (out, work, src):
        os.makedirs(folder, exist_ok=True)
    link = os.path.join(src, "rasterproof")
    if not os.path.islink(link):
        os.symlink(SOURCES, link)
    flags = [*COMMON, *SANITIZER_FLAGS[sanitizer], "-fsanitize=fuzzer-no-link"]
    kept = ("CCACHE_", "CMAKE_BUILD_")
    environment = {name: value for name, value in os.environ.items()
                   if name.startswith(kept) or name in ("HOME", "PATH")}  # fmt: skip
    environment |= {
        "CC": CLANG.replace("++", ""), "CXX": CLANG, "CFLAGS": " ".join(flags),
        "CXXFLAGS": " ".join([*flags, "-stdlib=libc++"]), "LIB_FUZZING_ENGINE":
        "-fsanitize=fuzzer -l:libstdc++.so.6", "OUT": out, "SRC": src, "WORK": work,
        "SANITIZER": sanitizer, "FUZZING_ENGINE": "libfuzzer", "ARCHITECTURE": "x86_64",
        "FUZZING_LANGUAGE": "c++"}  # fmt: skip
    script = os.path.join(SOURCES, "fuzz", "oss-fuzz", "build.sh")
    done = subprocess.run([script], cwd=SOURCES, env=environment, check=False)
    if done.returncode:
        sys.exit(f"build.sh failed with status {done.returncode}")
    return out


def require(truth, *said):
    if not truth:
        sys.exit("oss_fuzz_test: " + " ".join(str(word) for word in said))


def run(target, *arguments):
    done = subprocess.run([target, *arguments], capture_output=True, text=True, errors="replace",
                          env={"PATH": os.environ["PATH"], **OPTIONS}, cwd=os.path.dirname(target),
                          timeout=900, check=False)  # fmt: skip
    require(done.returncode == 0, target, *arguments, "ended with status", done.returncode, "\n",
            done.stderr[-3000:])  # fmt: skip
    return done.stderr


def check_target(target, sanitizer):
    code = subprocess.run(["objdump", "-d", "--no-show-raw-insn", target], capture_output=True,
                          text=True, check=True).stdout  # fmt: skip
    asan, ubsan = (
        len(re.findall(rf"callq? +[0-9a-f]+ <__{name}", code)) for name in ("asan", "ubsan")
    )
    if sanitizer == "address":
        require(asan >= FEWEST_ASAN_CALLS, target, "calls AddressSanitizer", asan, "times")
        require(ubsan <= MOST_UBSAN_CALLS_ELSEWHERE, target, "calls UBSan", ubsan, "times")
    else:
        require(ubsan >= FEWEST_UBSAN_CALLS, target, "calls UBSan", ubsan, "times")
        require(asan <= MOST_ASAN_CALLS_ELSEWHERE, target, "calls AddressSanitizer", asan, "times")
    needed = subprocess.run(["objdump", "-p", target], capture_output=True, text=True,
                            check=True).stdout  # fmt: skip
    libraries = set(re.findall(r"NEEDED +(\S+)", needed))
    require(libraries <= BASE | STAND_INS, target, "needs", sorted(libraries - BASE - STAND_INS))

    seeds = os.path.join(WORK, sanitizer, "seeds", os.path.basename(target))
    shutil.rmtree(seeds, ignore_errors=True)
    with zipfile.ZipFile(target + "_seed_corpus.zip") as archive:
        archive.extractall(seeds)
    require(os.listdir(seeds), target, "has an empty seed corpus")
    said = run(target, "-seed=1337", "-runs=4", seeds)
    require("no interesting inputs" not in said, target, "is not instrumented")
    edges = int(re.search(r"Loaded \d+ modules? +\((\d+) inline 8-bit counters\)", said)[1])
    require(edges >= FEWEST_EDGES, target, "shows", edges, "edges")
    print(f"{sanitizer:9} {os.path.basename(target):26} asan {asan:6} ubsan {ubsan:6}"
          f" edges {edges:6} seeds {len(os.listdir(seeds)):4}", flush=True)  # fmt: skip


def check_output(out, sanitizer):
    with open(os.path.join(SOURCES, "fuzz", "CMakeLists.txt"), encoding="utf-8") as file:
        listed = re.search(r"set\(FUZZ_TARGETS([^)]*)\)", file.read())[1].split()
    files = sorted(os.listdir(out))
    targets = [name for name in files if os.access(os.path.join(out, name), os.X_OK)]
    require(targets == sorted(f"{name}_fuzzer" for name in listed), "targets are", targets)
    for name in files:
        require(re.fullmatch(r"[A-Za-z0-9_-]+(_seed_corpus\.zip|\.options|\.dict)?", name),
                "OSS-Fuzz takes no file named", name)  # fmt: skip
    for name in targets:
        check_target(os.path.join(out, name), sanitizer)


if shutil.which(CLANG) is None or not os.path.exists("/usr/lib/llvm-19/lib/libc++.so"):
    print("not run: install clang-19, libc++-19-dev and libc++abi-19-dev")
    sys.exit(77)
for one in SANITIZERS:
    check_output(build(one), one)
