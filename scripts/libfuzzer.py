"""Programs linked with libFuzzer, and what they print."""

import re
import subprocess

FOUND = ("crash", "timeout", "oom", "leak")  # names of inputs that libFuzzer saves begin so


def targets(build):
    """The names of the fuzz targets that are built in a build folder, sorted."""
    return sorted(path.name.removesuffix("_fuzzer")
                  for path in (build / "fuzz").glob("*_fuzzer") if path.is_file())  # fmt: skip


def program(build, target):
    return build / "fuzz" / f"{target}_fuzzer"


def seeds(build, target):
    return build / "fuzz" / "seeds" / target


def is_linked_with(path):
    """Whether the program is libFuzzer's, and not the one that only replays inputs."""
    done = subprocess.run([path, "-help=1"], capture_output=True, text=True, check=False)
    return "libFuzzer" in done.stderr


def exact_signs(said):
    """How many signs the oracle decided; None where the target asks for none."""
    return _last(r"(\d+) exact signs", said)


def read(said):
    """Reads what a campaign printed: executions, seconds (None if it did not end by itself), signs,
    and the edges covered at its start and at its end.
    """
    started = re.search(r"INITED cov: (\d+)", said)
    return {
        "executions": _last(r"stat::number_of_executed_units: (\d+)", said) or 0,
        "seconds": _last(r"Done \d+ runs in (\d+) second", said),
        "signs": exact_signs(said),
        "edges_at_start": int(started[1]) if started else 0,
        "edges": _last(r"cov: (\d+)", said) or 0,
    }


def _last(pattern, said):
    found = re.findall(pattern, said)
    return int(found[-1]) if found else None
