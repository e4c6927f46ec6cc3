"""`legal` and `legal --decided` on tiny scenes, against a search through all legal models.

usage: tiny_scenes_test.py PROGRAM WRITER [NUMBER]
"""
import json
import os
import subprocess
import sys
import tempfile

PROGRAM, WRITER = (os.path.abspath(path) for path in sys.argv[1:3])
MORE = os.environ.get("RASTERPROOF_MORE", "") not in ("", "0")
NUMBER = int(sys.argv[3]) if len(sys.argv) > 3 else 10000 if MORE else 200


def write(folder, name, text):
    path = os.path.join(folder, name)
    with open(path, "w") as file:
        file.write(text)
    return path


def verdict(status, output):
    """0: a model explains it; 1: none does."""
    if status not in (0, 1):
        sys.exit(f"'legal' ended with status {status}: {output}")
    return status == 0


def main():
    told = subprocess.run([WRITER, str(NUMBER)], capture_output=True, check=True, text=True).stdout
    lines = [json.loads(line) for line in told.splitlines()]
    assert len(lines) == NUMBER, len(lines)
    legal = wide = 0
    with tempfile.TemporaryDirectory() as folder:
        for n, line in enumerate(lines):
            width = line["scene"]["width"]
            scene = write(folder, "scene.json", json.dumps(line["scene"]))
            profile = write(folder, "profile.json", line["profile"])
            rows = [line["counts"][k:k + width] for k in range(0, len(line["counts"]), width)]
            counts = write(folder, "counts.txt",
                           "\n".join(" ".join(map(str, row)) for row in rows))
            judged = subprocess.run([PROGRAM, "legal", scene, counts, "--profile", profile],
                                    capture_output=True, text=True)
            is_legal = verdict(judged.returncode, judged.stdout + judged.stderr)
            assert is_legal == line["legal"], f"scene {n}: {json.dumps(line)}\n{judged.stdout}"
            decided = subprocess.run([PROGRAM, "legal", scene, "--decided", "--profile", profile,
                                      "--json", "-"], capture_output=True, text=True)
            said = json.loads(decided.stdout)
            for key in ("least", "most"):
                assert said[key] == line[key], f"scene {n}: {key} {said[key]}: {json.dumps(line)}"
            legal += is_legal
            wide += any(a != b for a, b in zip(line["least"], line["most"]))
    assert NUMBER / 8 < legal < 7 * NUMBER / 8, legal
    assert wide > NUMBER / 8, wide
    print(f"{NUMBER} scenes, {legal} of them legal, {wide} with open samples: as by search")


if __name__ == "__main__":
    main()
