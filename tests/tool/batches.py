#!/usr/bin/env python3
"""A program that takes batches, and passes the draws on to the example, which takes none."""
import os
import subprocess
import sys

EXAMPLE = os.path.join(os.path.dirname(os.path.abspath(__file__)), "../../kit/examples/program.py")

with subprocess.Popen([EXAMPLE], stdin=subprocess.PIPE) as child:
    for line in sys.stdin.buffer:
        if line.startswith(b"batch"):
            print("it was sent a", line.decode(), end="", file=sys.stderr, flush=True)
        else:
            child.stdin.write(line)
            child.stdin.flush()
