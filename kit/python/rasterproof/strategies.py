"""Hypothesis strategies for triangles on a grid, which shrink to small whole numbers.

    @given(triangles(near_edge=True))
    def test_mine(t):
        assert rasterproof.legal(t, (16, 16), draw(t, (16, 16)), "vulkan")
"""

import numpy as np
from hypothesis import strategies as st

__all__ = ["meshes", "triangles"]


def _scale(bits):
    if not 0 <= bits <= 16:
        raise ValueError(f"bits: {bits}; give 0 to 16 subpixel bits")
    return 1 << bits


def _points(size, one, margin):
    return st.tuples(*(st.integers(-margin * one, (side + margin) * one) for side in size))


def triangles(near_edge=False, *, size=(16, 16), bits=8, margin=4):
    """One triangle, float64 (1, 3, 2), on the grid of 2^-bits pixels, up to `margin` outside.

    With near_edge one of its edges goes through a pixel's centre, or past it by one step of the
    grid, and another corner may be a centre too: where rasterizers differ.
    """
    one = _scale(bits)

    @st.composite
    def near(draw):
        column, row = (draw(st.integers(0, side - 1)) for side in size)
        centre = np.array([column * one + one // 2, row * one + one // 2])
        along = np.array(draw(st.tuples(st.integers(-one, one), st.integers(-one, one))))
        before, after = (draw(st.integers(0, margin)) for _ in range(2))
        off = np.array(draw(st.tuples(st.integers(-1, 1), st.integers(-1, 1))))
        corners = [centre - before * along + off, centre + after * along + off,
                   np.array(draw(_points(size, one, margin)))]  # fmt: skip
        turn = draw(st.integers(0, 2))
        return np.array([corners[turn:] + corners[:turn]]) / one

    def plain():
        point = _points(size, one, margin)
        return st.tuples(point, point, point).map(lambda t: np.array([t]) / one)

    return near() if near_edge else plain()


def meshes(shared_edges=True, *, size=(16, 16), bits=8, most=6):
    """Triangles, float64 (n, 3, 2), n from 2 to `most`. With shared_edges they form a fan of a
    convex polygon, wound alike: each inner edge belongs to two, and nothing is covered twice."""
    one = _scale(bits)

    @st.composite
    def fan(draw):
        # Corners of a convex polygon: sums of edge vectors in the order of their directions.
        edges = draw(st.lists(st.tuples(st.integers(-4 * one, 4 * one), st.integers(1, 4 * one)),
                              min_size=3, max_size=most + 1, unique_by=lambda e: e[0] / e[1]))
        edges.sort(key=lambda e: -e[0] / e[1])
        corners = np.cumsum([(0, 0), *edges], axis=0)
        corners += np.array(draw(_points(size, one, 1)))
        fans = [[corners[0], corners[k], corners[k + 1]] for k in range(1, len(corners) - 1)]
        if draw(st.booleans()):
            fans = [triangle[::-1] for triangle in fans]
        return np.array(fans) / one

    if shared_edges:
        return fan()
    return st.lists(triangles(size=size, bits=bits), min_size=2, max_size=most).map(np.concatenate)
