#!/usr/bin/env python3
"""A subject on a pipe that covers nothing, and does one thing wrong.

usage: misbehaves.py WHAT [FILE] [SECONDS]
"""
import os
import signal
import sys
import time

WHAT = sys.argv[1]
FOREVER = 10**6
CALLS = 50  # of a process: what some do, they do on each so many
kept = []


def say(text):
    sys.stdout.write(text)
    sys.stdout.flush()


def spin():
    while True:
        pass


def hang(how):
    print("it hangs", file=sys.stderr, flush=True)
    how()


def compute(seconds):
    """Seconds of a processor, however loaded it is."""
    begun = time.process_time()
    while time.process_time() - begun < seconds:
        pass


def stay_behind():
    """Two children in its group, one of which spins; both hold all that they inherited."""
    import subprocess  # pylint: disable=import-outside-toplevel  (it takes its time)

    for code in ("import time; time.sleep(10**6)", "while True: pass"):
        subprocess.Popen([sys.executable, "-I", "-S", "-c", code])


def once():
    """Whether this is the first process to come here."""
    try:
        os.close(os.open(sys.argv[2], os.O_CREAT | os.O_EXCL))
        return True
    except FileExistsError:
        return False


def do_on_a_call():
    """What only every fiftieth call of a process meets, before it is answered."""
    if WHAT == "sleeps-on-a-call":
        hang(lambda: time.sleep(FOREVER))
    if WHAT == "spins-on-a-call":
        hang(spin)
    if WHAT == "crashes-on-a-call":
        os.kill(os.getpid(), signal.SIGSEGV)
    if WHAT == "needs-on-a-call":
        compute(float(sys.argv[2]))
    if WHAT == "allocates-on-a-call":
        kept.append(bytearray(1 << 30))


def answer(number, width, height):
    row = " ".join(["0"] * width) + "\n"
    if WHAT == "warns":
        print(*["a warning\nand another"] * 3, sep="\n", file=sys.stderr, flush=True)
    rows = row * height
    if WHAT == "refuses":
        return say(f"refused {number} not today\n")
    if WHAT == "nan":
        rows = rows.replace("0", "nan", 1)
    if WHAT == "closes-output":
        os.close(1)
        hang(spin)
    if WHAT == "dies-half-way":
        say(f"counts {number}\n" + row)
        os.kill(os.getpid(), signal.SIGKILL)
    if WHAT == "floods-a-line":
        while True:
            say("0" * 65536)
    if WHAT == "floods-lines":
        while True:
            say(f"counts {number}\n" + rows)
    if WHAT == "says-more":
        rows += "0\n"
    if WHAT == "answers-ahead":
        rows += f"counts {number + 1}\n" + rows
    if WHAT == "needs":
        compute(float(sys.argv[2]))
    if WHAT == "hangs-once" and once():
        hang(lambda: time.sleep(FOREVER))
    if WHAT == "slow-once" and once():
        compute(float(sys.argv[3]))
    return say(f"counts {number}\n" + rows)


def main():
    if WHAT == "ignores-its-end":
        signal.signal(signal.SIGTERM, signal.SIG_IGN)
    if WHAT == "leaves-children":
        stay_behind()
    if WHAT == "greets":
        say("hello\0\x1b[31m\n")
    if WHAT == "closes-input":
        os.close(0)
        hang(lambda: time.sleep(FOREVER))
    if WHAT == "says-its-signals":
        blocked = signal.pthread_sigmask(signal.SIG_BLOCK, ())
        print(f"blocked: {blocked}", file=sys.stderr, flush=True)
    if WHAT == "crashes":
        os.kill(os.getpid(), signal.SIGSEGV)
    calls = 0
    left = 0  # of a batch
    while True:
        words = sys.stdin.readline().split()
        if not words:
            return
        if words[0] == "batch":
            left = int(words[1])
            continue
        if WHAT in ("spins", "ignores-its-end"):
            hang(spin)
        if WHAT == "sleeps":
            hang(lambda: time.sleep(FOREVER))
        if WHAT == "spins-with-children":
            stay_behind()
            hang(spin)
        for _ in range(int(words[6]) + int(words[7])):
            sys.stdin.readline()
        calls += 1
        if calls % CALLS == 0:
            do_on_a_call()
        if WHAT == "leaks":
            kept.append(bytearray(1 << 24))
        if WHAT == "ends-over-a-scene" and int(words[7]) > 1:
            sys.exit(0)
        answer(int(words[1]), int(words[2]), int(words[3]))
        left -= 1
        if WHAT == "restarts" and calls >= CALLS and left <= 0:
            sys.exit(0)


if __name__ == "__main__":
    main()
