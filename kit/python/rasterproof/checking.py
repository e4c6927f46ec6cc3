"""check() and certify(): the command's verdicts on a function of this process.

The command starts a relay as its program on a pipe. For each one this process forks, and the copy,
which has the function, answers on the relay's pipe. A crash, a hang or an exception is a finding,
and the next copy is a fresh one.
"""

import contextlib
import json
import os
import pathlib
import re
import selectors
import shlex
import shutil
import signal
import socket
import subprocess
import sys
import tempfile
from typing import NamedTuple

from . import _probe, _serve
from ._oracle import BadArgument, NotDecided, Profile, profile_text

_RELAY = pathlib.Path(__file__).with_name("_relay.py")


class Report(NamedTuple):
    """What the command found. It is true if every property that was asked holds."""

    status: int  # of the command: 0 holds, 1 violated, 3 a fault of its own, 4 inconclusive
    text: str  # what it printed
    failures: tuple = ()  # dicts: property, message, case, next and more; see docs/programs.md

    def __bool__(self):
        return self.status == 0

    @property
    def violated(self):
        """The names of the properties that fail the run, each once."""
        return tuple(dict.fromkeys(each["property"] for each in self.failures if each["fails"]))

    def require(self):
        """Raises AssertionError with the command's text unless every property holds."""
        assert self.status == 0, "\n" + self.text
        return self


def command():
    """The command's path: RASTERPROOF_COMMAND in the environment, or `rasterproof` in PATH."""
    found = os.environ.get("RASTERPROOF_COMMAND") or shutil.which("rasterproof")
    if not found or not os.access(found, os.X_OK):
        raise FileNotFoundError(
            f"the command {found or 'rasterproof'} was not found; install rasterproof, or name it "
            "in the environment variable RASTERPROOF_COMMAND")  # fmt: skip
    return os.path.abspath(found)


class _Copy(NamedTuple):
    pid: int
    end: int  # readable when it has ended
    connection: socket.socket  # to its relay


class _Host:
    """Forks a copy of this process for each relay that calls, until the command ends."""

    def __init__(self, folder, act):
        self.act, self.copies = act, []
        self.path = os.path.join(folder, "socket")
        self.listener = socket.socket(socket.AF_UNIX)
        self.listener.bind(self.path)
        self.listener.listen()
        self.looks = selectors.DefaultSelector()
        self.looks.register(self.listener, selectors.EVENT_READ, self.begin)

    def begin(self, _):
        connection, _ = self.listener.accept()
        told, files, _, _ = socket.recv_fds(connection, 16, 2)
        if len(files) != 2:
            connection.close()
            return
        sys.stdout.flush()
        sys.stderr.flush()
        pid = os.fork()
        if pid == 0:
            self.draw(connection, int(told), files)
        for file in files:
            os.close(file)
        copy = _Copy(pid, os.pidfd_open(pid), connection)
        self.copies.append(copy)
        self.looks.register(copy.end, selectors.EVENT_READ, lambda _: self.end(copy))
        self.looks.register(connection, selectors.EVENT_READ, lambda _: self.abandon(copy))

    def draw(self, connection, group, files):
        """In the copy. It belongs to the relay's group, whose time the command counts."""
        status = 1
        try:
            with contextlib.suppress(OSError):
                os.setpgid(0, group)
            connection.close()
            self.listener.close()
            os.dup2(2, 1)  # what a draw prints is no answer
            self.act(os.fdopen(files[0], "rb"), os.fdopen(files[1], "wb"))
            status = 0
        except (BrokenPipeError, KeyboardInterrupt):
            pass
        except BaseException as error:
            print(_serve.where(error), file=sys.stderr)
        finally:
            sys.stderr.flush()
            os._exit(status)

    def abandon(self, copy):
        """The relay is gone: the command has given this copy up."""
        if copy not in self.copies:
            return  # it ended at the same time
        self.looks.unregister(copy.connection)
        with contextlib.suppress(ProcessLookupError):
            os.kill(copy.pid, signal.SIGKILL)

    def end(self, copy):
        self.copies.remove(copy)
        _, status = os.waitpid(copy.pid, 0)
        self.looks.unregister(copy.end)
        with contextlib.suppress(KeyError):
            self.looks.unregister(copy.connection)
        os.close(copy.end)
        with copy.connection, contextlib.suppress(OSError):
            copy.connection.send(str(os.waitstatus_to_exitcode(status)).encode())

    def hear(self, process, said, shows):
        """Adds what the process writes to standard error to the file, and shows it."""
        end = process.stderr.fileno()
        os.set_blocking(end, False)
        while text := self.heard(end):
            said.write(text)
            if shows:
                sys.stderr.write(text.decode(errors="replace"))
                sys.stderr.flush()
        if text == b"":
            with contextlib.suppress(KeyError):
                self.looks.unregister(end)

    @staticmethod
    def heard(end):
        """Bytes; none at the end of the file, and None if there is nothing yet."""
        try:
            return os.read(end, 1 << 16)
        except BlockingIOError:
            return None

    def run(self, process, said, shows):
        """Serves until the process ends."""
        self.looks.register(process.stderr, selectors.EVENT_READ,
                            lambda _: self.hear(process, said, shows))  # fmt: skip
        ended = os.pidfd_open(process.pid)
        self.looks.register(ended, selectors.EVENT_READ, None)
        try:
            while True:
                for key, _ in self.looks.select():
                    if key.fd == ended:
                        self.hear(process, said, shows)
                        return process.wait()
                    if key.data:
                        key.data(key.fd)
        finally:
            if process.poll() is None:
                process.terminate()
                process.wait()
            self.close()
            process.stderr.close()
            os.close(ended)

    def close(self):
        for copy in self.copies:
            with contextlib.suppress(ProcessLookupError):
                os.kill(copy.pid, signal.SIGKILL)
            os.waitpid(copy.pid, 0)
            os.close(copy.end)
            copy.connection.close()
        self.copies = []
        self.listener.close()


def _name_of(draw, name):
    if name is not None and not re.fullmatch(r"[A-Za-z0-9_][A-Za-z0-9._-]*", name):
        raise BadArgument(f"name: {name!r}; give letters, digits, '_', '-' and '.'")
    name = name or getattr(draw, "__name__", type(draw).__name__)
    return (name if name.isascii() and "<" not in name else "draw") + ".subject"


def _served(draw):
    """The function as rasterproof.serve names it; a guess for what no module has by its name."""
    module, name = getattr(draw, "__module__", None), getattr(draw, "__qualname__", "")
    if module == "__main__":
        file = getattr(sys.modules[module], "__file__", None)
        module = pathlib.Path(file).stem if file else None
    return f"{module or 'mine'}:{name if name.isidentifier() else 'draw'}"


def _description(profile, *, format, coverage, shows, clip, batches, relay):  # noqa: A002
    if format not in ("float32", "float64") and not format.startswith("fixed "):
        raise BadArgument(f"format: {format!r}; give float32, float64 or fixed N.M signed")
    spaces = "window clip" if coverage == "fragments" else "clip"  # a Scene has w in both
    takes = (spaces if clip else "window") + (" batches" if batches else "") + " same npy"
    takes += " wants" if shows else ""
    text = profile_text(profile)
    if text.lstrip().startswith("{"):
        text = json.dumps(json.loads(text))  # on one line
    lines = [f"command {relay}", f"input {format}", f"coverage {coverage}",
             f"takes {takes}", f"profile {text}"]  # fmt: skip
    lines += [f"shows {' '.join(shows)}"] if shows else []
    return "\n".join(lines) + "\n"


_PATHS = {"--bench", "--cases-json", "--json", "--known", "--out", "-o", "--profile", "--save",
          "--scene", "--scenes"}  # fmt: skip
_PROGRESS = re.compile(r"^  .* after \d+ s(; \d+ more at work)?\n", re.MULTILINE)


def _absolute(words):
    """The command runs in another folder: paths after the options that take one, made absolute."""
    def moved(option, path):
        is_name = path == "-" or (option == "--profile" and not os.path.exists(path))
        return path if is_name else os.path.abspath(path)

    made = []
    for word in map(str, words):
        option, equals, path = word.partition("=")
        if made and made[-1] in _PATHS:
            word = moved(made[-1], word)
        elif equals and option in _PATHS:
            word = f"{option}={moved(option, path)}"
        made.append(word)
    return made


def _run(verb, draw, profile, options, found, *, progress, name, format, coverage,  # noqa: A002
         shows, clip, batches):  # fmt: skip
    """The report; `found(folder)` reads the failures from what the command wrote."""
    if not callable(draw):
        raise BadArgument(f"draw: a {type(draw).__name__}; give a function of (triangles, size)")
    program = command()
    name = _name_of(draw, name)
    served = [sys.executable or "python3", "-m", "rasterproof.serve", *["--clip"] * clip,
              *["--batches"] * batches,
              *["--coverage", coverage] * (coverage in _serve.ANSWERS), _served(draw)]  # fmt: skip
    shows = shows.split() if isinstance(shows, str) else shows
    stated = {"profile": profile, "format": format, "coverage": coverage, "shows": shows,
              "clip": clip, "batches": batches}  # fmt: skip
    own = _description(**stated, relay=shlex.join(served))
    samples = 0
    with contextlib.suppress(NotDecided):
        samples = Profile(profile).samples
    if said := _probe.wrong_answer(draw, samples, coverage, clip=clip, batches=batches):
        raise BadArgument(said)

    def act(requests, replies):
        _serve.serve(draw, requests, replies, clip=clip, batches=batches, coverage=coverage)

    with tempfile.TemporaryDirectory(prefix="rasterproof-") as folder:
        host = _Host(folder, act)
        relay = shlex.join([sys.executable, "-S", "-E", str(_RELAY), host.path])
        pathlib.Path(folder, name).write_text(_description(**stated, relay=relay),
                                              encoding="utf-8")  # fmt: skip
        words = [program, verb, "--subject", name, *_absolute(options)]
        if verb == "check":
            words += ["--json", os.path.join(folder, "found.json")]
        path = pathlib.Path(folder, "said")
        # Both append to it: the lines keep their order.
        with open(path, "ab") as out, open(path, "ab", buffering=0) as said:
            process = subprocess.Popen(words, cwd=folder, stdin=subprocess.DEVNULL, stdout=out,
                                       stderr=subprocess.PIPE)  # fmt: skip
            status = host.run(process, said, progress)
        text = _PROGRESS.sub("", path.read_text(encoding="utf-8", errors="replace"))
        if status == 2:
            raise BadArgument(text.strip())
        if f"--subject {name}" in text:
            text += f"for these commands write {name}, beside your module:\n" + "".join(
                f"  {line}\n" for line in own.splitlines())  # fmt: skip
        return Report(status, text, found(folder))


def _failures_of_check(folder):
    path = pathlib.Path(folder, "found.json")
    if not path.exists():
        return ()
    subjects = json.loads(path.read_text(encoding="utf-8"))["subjects"]
    return tuple(each for subject in subjects for each in subject["failures"])


def _failures_of_certificate(path):
    """Properties of a certificate that are violated, with the keys of check()'s that it has."""
    if not path.exists():
        return ()
    document = json.loads(path.read_text(encoding="utf-8"))
    return tuple(
        {"property": each["property"], "clause": each["clause"], "message": each["message"],
         "outcome": "violated", "fails": document["verdict"] == "violated",
         "case": each.get("counterexample", {}).get("case"),
         "next": each.get("counterexample", {}).get("replay")}
        for each in [*document["exhausted"], *document["tested"]]
        if each.get("outcome") == "violated")  # fmt: skip


def check(draw, profile="real", cases=100, *, properties=(), scenes=(), seed=None, save=None,
          format="float32", coverage="counts", shows=(), clip=False, batches=False,  # noqa: A002
          name=None, options=(), progress=False):  # fmt: skip
    """Puts all properties (or `properties`) to the test on a function that draws.

    draw        draw(triangles, size): float64 (n, 3, 2) in pixels (with `clip` (n, 3, 4)) and
                (width, height); returns how many triangles cover each sample, integers
                (height, width) or (height, width, samples). With `batches` draw(scenes): a list of
                such pairs, and a list of arrays comes back. Raise Refused for what it can't take.
    profile     what it states; what legal rasterizers may differ in is not held against it.
    cases       for each property. `scenes` are files: drawn as well.
    properties  a name, or several.
    format      the numbers that it takes: float32, float64 or "fixed 12.4 signed".
    coverage    what it returns: counts, facing-counts (2, height, width), mask, primitive-id (-1
                where there is none); or fragments: then it gets a Scene and returns Fragments.
    shows       what its Fragments show besides: values of the scene's channels, derivatives.
    save        a folder: shrunk failures are kept there and asked first the next time.
    options     more words for `rasterproof check`.

    Returns a Report. Raises BadArgument for what the command says is bad input, and at once where
    what a plain triangle's draw returns has a wrong type or shape.
    """
    properties = [properties] if isinstance(properties, str) else properties
    scenes = [scenes] if isinstance(scenes, (str, os.PathLike)) else scenes
    words = ["--cases", str(cases), "--memory-limit", "0"]
    words += [word for each in properties for word in ("--property", each)]
    words += [word for each in scenes for word in ("--scene", str(each))]
    words += ["--seed", str(seed)] if seed is not None else []
    words += ["--save", str(save)] if save else []
    return _run("check", draw, profile, [*words, *options], _failures_of_check, progress=progress,
                name=name, format=format, coverage=coverage, shows=shows, clip=clip,
                batches=batches)  # fmt: skip


def certify(draw, out, profile="real", cases=None, *, scenes=None, seed=None,
            format="float32", coverage="counts", shows=(), clip=False,  # noqa: A002
            batches=False, name=None, options=(), progress=True):  # fmt: skip
    """The whole catalogue and the bundled scenes: a certificate and a report page in `out`.

    out         a folder; certificate.json and junit.xml lie in its folder NAME.subject, where NAME
                is `name` or the function's.
    cases       for each property; left out: 100.
    scenes      a scene set in place of scenes/certify.json. The largest there has 69,666 triangles
                on 1024 x 1024: a draw can't have an array of triangles x pixels.

    All else is as for check(). A failure in the report has the keys property, clause, outcome,
    fails, message, case and next; samples of scenes that are wrong are in the certificate alone.
    """
    words = ["--out", str(out)]
    words += ["--cases", str(cases)] if cases is not None else []
    words += ["--scenes", str(scenes)] if scenes else []
    words += ["--seed", str(seed)] if seed is not None else []
    certificate = pathlib.Path(out, _name_of(draw, name), "certificate.json").absolute()
    return _run("certify", draw, profile, [*words, *options],
                lambda _: _failures_of_certificate(certificate), progress=progress, name=name,
                format=format, coverage=coverage, shows=shows, clip=clip,
                batches=batches)  # fmt: skip
