"""Which files belong to the project, for the checks in this folder."""

import os
import pathlib

ROOT = pathlib.Path(__file__).resolve().parent.parent
_SKIPPED_PREFIXES = ("build",)
_SKIPPED = {".git", ".cache", "out", "node_modules", "__pycache__"}


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
