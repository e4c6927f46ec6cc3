"""The oracle and the properties of rasterproof for rasterizers in Python.

    import rasterproof

    rasterproof.coverage(triangles, (16, 16))             # what an exact rasterizer counts
    rasterproof.decided(triangles, (16, 16), "vulkan")    # what legal ones must and may cover
    rasterproof.check(draw, "vulkan").require()           # all properties, on generated cases

Coordinates are pixels, x to the right, y as the profile says, downwards unless it says otherwise;
`size` is (width, height). Triangles are an array of shape (n, 3, 2) with x and y, (n, 3, 3) with z,
or (n, 3, 4) with w; or a pair of vertices (v, 2 to 4) and indices (n, 3). A profile is a preset's
name, a dict with the keys of docs/subjects.md, the text of one as JSON, or a path.
"""

from ._oracle import (MAY, MUST, MUST_NOT, BadArgument, NotDecided, Profile, Verdict, barycentrics,
                      bounds, coverage, decided, edge_sign, legal, place, value)
from ._serve import Channel, Fragments, Refused, Scene
from .checking import Report, certify, check

__all__ = [
    "MAY", "MUST", "MUST_NOT", "BadArgument", "Channel", "Fragments", "NotDecided", "Profile",
    "Refused", "Report", "Scene", "Verdict", "barycentrics", "bounds", "certify", "check",
    "coverage", "decided", "edge_sign", "legal", "place", "value",
]  # fmt: skip
