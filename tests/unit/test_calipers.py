"""`stochgeom.geometry.calipers`: transitions, contacts and antipodal pairs of small parts."""

from __future__ import annotations

import pytest

from stochgeom.geometry.calipers import NO_EDGE, antipodal_pairs, rotate_calipers
from stochgeom.geometry.part import Part

RECTANGLE = [(0, 0), (3, 0), (3, 2), (0, 2)]
TRIANGLE = [(0, 0), (4, 0), (1, 2)]
HOUSE = [(-1, -1), (1, -1), (1, 1), (0, 2), (-1, 1)]
OCTAGON = [(2, 1), (1, 2), (-1, 2), (-2, 1), (-2, -1), (-1, -2), (1, -2), (2, -1)]


def calipers(vertices):
    return rotate_calipers(Part(vertices).hull)


def columns(found):
    names = ("x", "y", "lower", "upper", "lower_edge", "upper_edge")
    return {name: getattr(found, name).tolist() for name in names}


def test_rectangle():
    """Parallel edges are flush together: two transitions in half a turn."""
    assert columns(calipers(RECTANGLE)) == {
        "x": [3, 0],
        "y": [0, 2],
        # turned a little counter-clockwise it stands on vertex 0
        "lower": [0, 3],
        "upper": [2, 1],
        "lower_edge": [0, 3],
        "upper_edge": [2, 1],
    }


def test_triangle():
    """Edge (0, 0)-(4, 0) lies flush at 0; edges 1 and 2 on the upper jaw and the lower one."""
    found = calipers(TRIANGLE)
    assert len(found) == 3
    # Edge 1 is (-3, 2): flush on the upper jaw at -arg(3, -2). Edge 2 is (-1, -2): flush on
    # the lower jaw at -arg(-1, -2) = 116.57 degrees.
    assert columns(found) == {
        "x": [4, 3, -1],
        "y": [0, 2, 2],
        "lower": [0, 0, 2],
        "upper": [2, 1, 1],
        "lower_edge": [0, NO_EDGE, 2],
        "upper_edge": [NO_EDGE, 1, NO_EDGE],
    }


def test_contacts_before_a_transition():
    found = calipers(TRIANGLE)
    # The piece before transition 0 is the last one with its contacts exchanged.
    assert found.lower_before.tolist() == [1, 0, 0]
    assert found.upper_before.tolist() == [2, 2, 1]


def test_an_edge_leaves_the_jaw_by_its_end():
    """Just before an edge is flush its end touches, just after it its start does."""
    for vertices in (RECTANGLE, TRIANGLE, HOUSE):
        found, n = calipers(vertices), len(vertices)
        for t in range(len(found)):
            for edge, after, before in (
                (found.lower_edge[t], found.lower[t], found.lower_before[t]),
                (found.upper_edge[t], found.upper[t], found.upper_before[t]),
            ):
                if edge == NO_EDGE:
                    assert after == before
                else:
                    assert (before, after) == ((edge + 1) % n, edge)


@pytest.mark.parametrize(
    ("vertices", "pairs"),
    [
        (TRIANGLE, [(0, 1), (0, 2), (1, 2)]),
        # n even and all edges parallel in pairs: the bound 3 n / 2 is met
        (RECTANGLE, [(0, 1), (0, 2), (0, 3), (1, 2), (1, 3), (2, 3)]),
        (OCTAGON, [(i, j) for i in range(5) for j in range(i + 3, min(i + 6, 8))]),
        (HOUSE, [(0, 1), (0, 2), (0, 3), (1, 3), (1, 4), (2, 4)]),
    ],
)
def test_antipodal_pairs(vertices, pairs):
    found = antipodal_pairs(Part(vertices).hull)
    assert found == pairs
    assert 2 * len(found) <= 3 * len(vertices)
