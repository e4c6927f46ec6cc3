"""A function that draws, as a program on rasterproof's pipe (arrays in NPY).

    rasterproof check --subject mine.subject
with the lines
    command python3 -m rasterproof.serve mine:draw
    takes window same npy

`draw(triangles, size)` gets float64 (n, 3, 2), pixels, and (width, height), and returns how many
triangles cover each sample: integers (height, width), or (height, width, samples). After --clip it
gets (n, 3, 4), after --batches a list of such pairs: as check() with `clip` and `batches`. After
--coverage primitive-id it returns ids, after --coverage fragments Fragments of a Scene.
"""

import argparse
import importlib
import os
import sys

from ._serve import Refused, serve

__all__ = ["Refused", "serve"]


def main():
    parser = argparse.ArgumentParser(prog="python3 -m rasterproof.serve")
    parser.add_argument("--clip", action="store_true")
    parser.add_argument("--batches", action="store_true")
    parser.add_argument("--coverage", default="counts")
    parser.add_argument("function", metavar="MODULE:FUNCTION")
    asked = parser.parse_args()
    module, _, name = asked.function.partition(":")
    if not name:
        parser.error(f"{asked.function}: give MODULE:FUNCTION")
    sys.path.insert(0, "")
    replies = os.fdopen(os.dup(1), "wb")
    os.dup2(2, 1)  # what it prints is no answer
    draw = getattr(importlib.import_module(module), name)
    serve(draw, sys.stdin.buffer, replies, clip=asked.clip, batches=asked.batches,
          coverage=asked.coverage)  # fmt: skip


if __name__ == "__main__":
    main()
