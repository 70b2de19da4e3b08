"""Laws of the preimages of phase I (thesis 5.3 - 5.7)."""

from __future__ import annotations

from itertools import pairwise

from hypothesis import assume, given
from hypothesis import strategies as st

from stochgeom.exact.angles import ZERO, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.feeding.execution import composite, run_angle
from stochgeom.feeding.preimages import preimages
from stochgeom.transfer.squeeze import squeeze_function
from tests.strategies import (
    circle_parts,
    directions,
    hulls,
    nearly_regular,
    necklaces,
    orientations,
    transfer_functions,
)

maps = st.one_of(
    transfer_functions(),
    necklaces(),
    st.one_of(circle_parts(), nearly_regular(most=9)).map(squeeze_function),
)
"""Squeeze functions, and others: all of phase I holds for every monotone step map (5.10)."""

SLIGHT = Angle(0, (10**9, 1))

actions = st.lists(orientations, min_size=1, max_size=5)


def maximal_arcs(s, bound):
    """Return (width, image width, start) of every arc from break to break with a small image.

    Of the arcs from one break all are listed, not only the longest; `bound` None allows images
    of a single orientation only.
    """
    breaks, values, m = s.lifted_breaks, s.lifted_values, len(s)
    found = []
    for first in range(m):
        for last in range(first, first + m):
            image = values[last] - values[first]
            if (image < bound) if bound is not None else (last == first):
                found.append((breaks[last + 1] - breaks[first], image, breaks[first]))
    return found


# --- Theorem 5.3 ---------------------------------------------------------------------------------


@given(maps)
def test_widths_increase_until_a_period_is_reached(s):
    """Theorem 5.3; refuted by a width that is not above the one before, or another last width."""
    widths = [p.width for p in preimages(s)]
    assert all(one < other for one, other in pairwise(widths))
    assert widths[0] == max(s.widths)
    assert widths[-1] == s.period
    assert s.period not in widths[:-1]


@given(maps)
def test_images_fit_strictly_inside_the_preimage_before(s):
    """Refuted by an image as wide as the preimage that is to hold it, or that is not the image."""
    chain = list(preimages(s))
    assert chain[0].image_width == ZERO
    for before, p in pairwise(chain):
        assert p.image_width < before.width
    for steps, p in enumerate(chain, 1):
        assert p.steps == steps
        assert p.image == s.image(p.arc)
        assert ZERO <= p.arc.start < s.period
        assert p.arc.start in s.breaks.angles


@given(maps)
def test_chosen_arcs_are_maximal(s):
    """Lemma 5.3 and the tie rules: widest, then narrowest image, then smallest start.

    Refuted by any arc between two breaks, with an image narrow enough, that is to be preferred.
    """
    bound = None
    for p in preimages(s):
        competitors = maximal_arcs(s, bound)
        best = min(competitors, key=lambda arc: (-arc[0], arc[1], arc[2]))
        assert (p.width, p.image_width, p.arc.start) == best
        assert p.ties == len({start for width, _, start in competitors if width == p.width})
        bound = p.width


@given(maps, st.data())
def test_no_arc_at_all_is_wider(s, data):
    """Lemma 5.3; refuted by an arc between any two orientations, wider and with a small image."""
    chain = list(preimages(s))
    assume(len(chain) > 1)
    k = data.draw(st.integers(0, len(chain) - 2))
    wider = chain[k].width + data.draw(st.sampled_from([SLIGHT, *s.widths]))
    image = s.image(Arc(data.draw(orientations), min(wider, s.period)))
    if k == 0:
        assert image.width > ZERO
    else:
        assert image.width >= chain[k - 1].width


# --- Theorem 5.1 ---------------------------------------------------------------------------------


@given(maps, actions)
def test_no_plan_collapses_a_wider_arc(s, turns):
    """Theorem 5.1: refuted by i actions, at any angles, whose composite has a wider step."""
    assert max(composite(s, turns).widths) <= preimages(s).of_steps(len(turns)).width


@given(maps, actions)
def test_no_shorter_plan_orients_up_to_symmetry(s, turns):
    """Corollary 5.1.1: refuted by fewer actions that leave no more than 2 pi / T orientations."""
    chain = list(preimages(s))
    whole = composite(s, turns)
    left = len(whole) * whole.order
    assert left >= s.order
    if len(turns) < len(chain):
        assert left > s.order


@given(maps, actions, orientations, directions)
def test_what_lies_between_two_orientations_ends_with_them(s, turns, low, gap):
    """Lemma 5.1: refuted by two orientations that end together and one between that does not."""
    high = low + Angle(0, gap)
    start, end = (run_angle(s, turns, theta)[-1] for theta in (low, high))
    assert start <= end
    if start == end and low < high:
        assert high - low < s.period
        assert composite(s, turns).image(Arc(low, high - low)).width == ZERO


@given(maps)
def test_preimages_do_not_depend_on_how_they_are_asked_for(s):
    """Refuted by a preimage that is another when it is asked for alone, or again."""
    chain = list(preimages(s))
    alone = preimages(s).of_steps(len(chain))
    assert alone == chain[-1]
    again = preimages(s)
    assert [again.of_steps(k) for k in range(1, len(chain) + 3)] == [*chain, chain[-1], chain[-1]]


@given(hulls(most=3))
def test_one_squeeze_does_for_triangles_that_are_not_acute(triangle):
    """Refuted by an acute triangle with a step of half a turn, or another one without."""
    a, b, c = triangle.hull.points.pairs()
    angles_at = [
        (q[0] - p[0]) * (r[0] - p[0]) + (q[1] - p[1]) * (r[1] - p[1])
        for p, q, r in ((a, b, c), (b, c, a), (c, a, b))
    ]
    chain = list(preimages(squeeze_function(triangle)))
    assert (len(chain) == 1) == (min(angles_at) <= 0)
