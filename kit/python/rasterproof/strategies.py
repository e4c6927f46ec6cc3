"""Hypothesis strategies for triangles on a grid, which shrink to small whole numbers.

    @settings(deadline=None)
    @given(triangles(near_edge=True))
    def test_mine(t):
        assert rasterproof.legal(t, (16, 16), draw(t, (16, 16)), "vulkan")
"""

import numpy as np
from hypothesis import strategies as st

__all__ = ["meshes", "triangles"]

# The directions of spokes, an eighth of a turn each.
_COMPASS = np.array([(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)])


class _Pasted(np.ndarray):
    """Shown as what makes it again, with all its digits: so a falsifying example can be pasted."""

    def __repr__(self):
        return f"np.array({self.tolist()})"


def _over(points, one):
    return (np.array(points) / one).view(_Pasted)


def _scale(bits):
    if not 0 <= bits <= 16:
        raise ValueError(f"bits: {bits}; give 0 to 16 subpixel bits")
    return 1 << bits


def _points(size, one, margin):
    return st.tuples(*(st.integers(-margin * one, (side + margin) * one) for side in size))


def _centres(size, one):
    return st.tuples(*(st.integers(0, side - 1).map(lambda k: k * one + one // 2) for side in size))


def triangles(near_edge=False, *, size=(16, 16), bits=8, margin=4):
    """One triangle, float64 (1, 3, 2), on the grid of 2^-bits pixels, up to `margin` outside.

    With near_edge one of its edges goes through a pixel's centre, or past it by one step of the
    grid, and another corner may be a centre too: where rasterizers differ.
    """
    one = _scale(bits)

    @st.composite
    def near(draw):
        centre = np.array(draw(_centres(size, one)))
        along = np.array(draw(st.tuples(st.integers(-one, one), st.integers(-one, one))))
        before, after = (draw(st.integers(0, margin)) for _ in range(2))
        off = np.array(draw(st.tuples(st.integers(-1, 1), st.integers(-1, 1))))
        corners = [centre - before * along + off, centre + after * along + off,
                   np.array(draw(_points(size, one, margin)))]  # fmt: skip
        turn = draw(st.integers(0, 2))
        return _over([corners[turn:] + corners[:turn]], one)

    @st.composite
    def plain(draw):
        return _over([[draw(_points(size, one, margin)) for _ in range(3)]], one)

    return near() if near_edge else plain()


def meshes(shared_edges=True, *, size=(16, 16), bits=8, most=6):
    """Triangles, float64 (n, 3, 2), n from 2 to `most`, on the grid of 2^-bits pixels.

    With shared_edges they form a fan, wound alike: each inner edge belongs to two, and nothing is
    covered twice. Most have an inner edge through pixels' centres (with bits=0 on diagonals alone),
    horizontal, vertical, diagonal or steep: where a wrong tie rule shows. The others fill a convex
    polygon, whose edges lie anywhere.
    """
    one = _scale(bits)
    if most < 2:
        raise ValueError(f"most: {most}; give 2 or more triangles")

    @st.composite
    def spokes(draw):
        """Round a centre, with whole pixels along directions of the compass."""
        hub = np.array(draw(_centres(size, one)))
        turns = [draw(st.integers(0, 7))]
        gaps = draw(st.lists(st.integers(1, 3), min_size=2, max_size=min(most, 8)))
        for gap in gaps:
            if turns[-1] + gap <= turns[0] + 8:
                turns.append(turns[-1] + gap)
        rim = [hub + _COMPASS[turn % 8] * draw(st.integers(1, 4)) * one for turn in turns]
        if turns[-1] == turns[0] + 8:
            rim[-1] = rim[0]
        return [[hub, a, b] for a, b in zip(rim, rim[1:])]

    @st.composite
    def pair(draw):
        """On both sides of an edge that goes through a centre, whole pixels to its ends."""
        centre = np.array(draw(_centres(size, one)))
        along = np.array(draw(st.tuples(st.integers(-3, 3), st.integers(-3, 3))))
        if not along.any():
            along = np.array((1, 0))
        a = centre - along * draw(st.integers(0, 3)) * one
        b = centre + along * draw(st.integers(1, 3)) * one
        across = np.array([-along[1], along[0]])

        def apex(side):
            beside = draw(st.integers(-2 * one, 2 * one)) * along
            return centre + beside + side * draw(st.integers(1, 2 * one)) * across

        return [[a, b, apex(1)], [b, a, apex(-1)]]

    @st.composite
    def polygon(draw):
        # Corners of a convex polygon: sums of edge vectors in the order of their directions.
        edges = draw(st.lists(st.tuples(st.integers(-4 * one, 4 * one), st.integers(1, 4 * one)),
                              min_size=3, max_size=most + 1, unique_by=lambda e: e[0] / e[1]))
        edges.sort(key=lambda e: -e[0] / e[1])
        corners = np.cumsum([(0, 0), *edges], axis=0)
        corners += np.array(draw(_points(size, one, 1)))
        return [[corners[0], corners[k], corners[k + 1]] for k in range(1, len(corners) - 1)]

    # What .map() returns is printed as the call that made it: what is printed is to run.
    @st.composite
    def turned(draw):
        fan = draw(st.one_of(spokes(), pair(), polygon()))
        back = draw(st.booleans())
        return _over([t[::-1] if back else t for t in fan], one)

    @st.composite
    def soup(draw):
        some = draw(st.lists(triangles(size=size, bits=bits), min_size=2, max_size=most))
        return _over(np.concatenate(some), 1)

    return turned() if shared_edges else soup()
