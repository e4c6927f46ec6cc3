"""Which files belong to the project, what of them is code, and how a check ends: for the checks in
this folder."""

import os
import pathlib
import re

ROOT = pathlib.Path(__file__).resolve().parent.parent
_SKIPPED_PREFIXES = ("build",)
_SKIPPED = {".git", ".cache", "out", "node_modules", "__pycache__"}
_NOT_CODE = re.compile(
    r"""//[^\n]*|/\*.*?\*/|R"(\w*)\(.*?\)\1"|"(?:\\.|[^"\\\n])*"|'(?:\\.|[^'\\\n])'""", re.S
)
_DIRECTIVE = re.compile(r"^[ \t]*#(?:[^\n]*\\\n)*[^\n]*", re.M)


def root(arguments):
    """Returns the folder that the arguments of a check name, or the project's."""
    return pathlib.Path(arguments[0]).resolve() if arguments else ROOT


def files(root=ROOT, suffixes=None):
    """Returns the project's files below root, sorted, as paths relative to it.

    suffixes: only names that end with one of them; None for all.
    """
    found = []
    for folder, subfolders, names in os.walk(root):
        top = pathlib.Path(folder) == root
        subfolders[:] = [
            name
            for name in subfolders
            if name not in _SKIPPED and not (top and name.startswith(_SKIPPED_PREFIXES))
        ]
        found += [
            (pathlib.Path(folder) / name).relative_to(root)
            for name in names
            if suffixes is None or name.endswith(tuple(suffixes))
        ]
    return sorted(found)


def blank(match):
    """Returns blanks for what matched, its lines where they were."""
    return re.sub(r"[^\n]", " ", match[0])


def code(text):
    """Returns C++ with its comments, literals and directives blanked."""
    return _DIRECTIVE.sub(blank, _NOT_CODE.sub(blank, text))


def kept(matches, text):
    """Returns the text with everything blanked but what matched."""
    blanked = list(re.sub(r"[^\n]", " ", text))
    for match in matches:
        blanked[match.start() : match.end()] = match[0]
    return "".join(blanked)


def comments(text):
    """Returns C++ with everything blanked but its comments."""
    return kept((match for match in _NOT_CODE.finditer(text) if match[0].startswith("/")), text)


def report(name, counted, errors):
    """Prints what a check found, and returns its exit status: 1 also if it had nothing to look at.

    counted: of what it looked at, how many of which, the first of which must not be none.
    """
    counts = ", ".join(f"{count} {kind}" for kind, count in counted.items())
    print("\n".join([*errors, f"{name}: {counts}, {len(errors)} violations"]))
    return 1 if errors or not next(iter(counted.values())) else 0
