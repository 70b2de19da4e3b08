"""Laws of transfer functions: monotone step maps of degree one (thesis 4.4, 5.2)."""

from __future__ import annotations

from fractions import Fraction

from hypothesis import given
from hypothesis import strategies as st

from stochgeom.exact.angles import FULL_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.transfer.step_function import StepFunction
from tests.strategies import (
    arcs,
    necklaces,
    orientations,
    squeezes,
    step_functions,
    transfer_functions,
)

grid = st.integers(-200, 200).map(lambda k: Angle.from_degrees(Fraction(5 * k, 2)))
"""Breaks, values and the middles between them of `step_functions`."""
points = st.one_of(grid, grid, orientations)
widths = st.integers(1, 144).map(lambda k: Angle.from_degrees(Fraction(5 * k, 2)))
grid_arcs = st.builds(Arc, grid, widths)
any_arc = st.one_of(grid_arcs, arcs())


def periods(s, count):
    """Return `count` periods of breaks and of values."""
    size = count * len(s)
    return [s.lifted_breaks[k] for k in range(size)], [s.lifted_values[k] for k in range(size)]


# --- what a transfer function is -----------------------------------------------------------------


@given(transfer_functions())
def test_canonical_form(s):
    """Refuted by breaks outside [0, T), or a break or a value that is not above the one before."""
    breaks, values = list(s.breaks), list(s.values)
    assert breaks[0] >= ZERO
    assert breaks[-1] < s.period
    assert breaks == sorted(set(breaks))
    assert [*values, values[0] + s.period] == sorted({*values, values[0] + s.period})
    assert s.period * s.order == FULL_TURN
    assert sum(s.widths, start=ZERO) == s.period


@given(transfer_functions(), points, points)
def test_transfer_functions_are_monotone(s, one, other):
    """Refuted by theta <= phi with s(theta) > s(phi)."""
    low, high = sorted((one, other))
    assert s(low) <= s(high)


@given(transfer_functions(), points, st.integers(-3, 3))
def test_transfer_functions_have_degree_one(s, theta, laps):
    """s(theta + T) = s(theta) + T; refuted by any other difference."""
    assert s(theta + s.period * laps) == s(theta) + s.period * laps


@given(transfer_functions(), points)
def test_steps_are_closed_on_the_left(s, theta):
    """Refuted by a theta whose step does not begin at or before it and end after it."""
    k = s.step_at(theta)
    assert s.lifted_breaks[k] <= theta < s.lifted_breaks[k + 1]
    assert s(theta) == s.lifted_values[k]
    before = s.step_before(theta)
    assert s.lifted_breaks[before] < theta <= s.lifted_breaks[before + 1]


@given(squeezes())
def test_squeezes_turn_towards_a_minimum_of_their_own_step(s):
    """b_j < v_j < b_{j+1}; refuted by a value on a break or in another step."""
    breaks = s.lifted_breaks
    for k in range(len(s)):
        assert breaks[k] < s.values[k] < breaks[k + 1]
        assert s(s.values[k]) == s.values[k]
    assert s.compose(s) == s


# --- the smallest period -------------------------------------------------------------------------


@given(st.one_of(necklaces(), transfer_functions()))
def test_no_share_of_the_period_is_a_period(s):
    """Refuted by a k > 1 such that T / k is a period."""
    m = len(s)
    for k in range(2, m + 1):
        share = Angle.from_turns(Fraction(1, s.order * k))
        breaks_repeat = {b + share for b in s.breaks} <= {s.lifted_breaks[j] for j in range(2 * m)}
        values_repeat = all(s(b + share) == s(b) + share for b in s.breaks)
        assert not (breaks_repeat and values_repeat)


@given(transfer_functions(), st.data())
def test_equal_maps_have_equal_forms(s, data):
    """Refuted by a map that, given with another period, start or needless breaks, looks other."""
    divisors = [k for k in range(1, s.order + 1) if s.order % k == 0]
    count = data.draw(st.sampled_from(divisors))
    period = s.period * count
    breaks, values = periods(s, count)
    # needless breaks inside steps
    needless = sorted({b for b in data.draw(st.lists(grid, max_size=3)) if b not in breaks})
    for b in needless:
        b = breaks[0] + (b - breaks[0]) % period
        if b not in breaks:
            place = sum(1 for other in breaks if other < b)
            breaks.insert(place, b)
            values.insert(place, s(b))
    # another start, whole periods away
    start, laps = data.draw(st.integers(0, len(breaks) - 1)), data.draw(st.integers(-3, 3))
    far = period * laps
    breaks = [b + far for b in breaks[start:]] + [b + period + far for b in breaks[:start]]
    values = [v + far for v in values[start:]] + [v + period + far for v in values[:start]]
    other = StepFunction(breaks, values, period)
    assert other == s
    assert hash(other) == hash(s)


# --- images and preimages ------------------------------------------------------------------------


@given(transfer_functions(), any_arc, points)
def test_image_and_preimage_are_adjoint(s, arc, theta):
    """s(theta) in A iff theta in the preimage of A, lifted; refuted by a theta in one only."""
    preimage = s.preimage(arc)
    inside = arc.start <= s(theta) < arc.end
    assert inside == (preimage is not None and preimage.start <= theta < preimage.end)


@given(transfer_functions(), any_arc)
def test_preimages_are_unions_of_steps(s, arc):
    """Refuted by a preimage that cuts a step, or misses one whose value lies in the arc."""
    preimage = s.preimage(arc)
    # Values are less than two periods away from their breaks.
    k, m = s.step_at(arc.start), len(s)
    near = range(k - 4 * m, k + (5 + s.order) * m)
    wanted = [k for k in near if arc.start <= s.lifted_values[k] < arc.end]
    if preimage is None:
        assert wanted == []
    else:
        assert preimage.start == s.lifted_breaks[wanted[0]]
        assert preimage.end == s.lifted_breaks[wanted[-1] + 1]


@given(transfer_functions(), any_arc, points)
def test_image_is_spanned_by_values_that_are_taken(s, arc, theta):
    """Refuted by an orientation of the arc whose value is outside, or an end not taken."""
    image = s.image(arc)
    last = s.lifted_breaks[s.step_before(arc.end)]
    assert (image.start, image.end) == (s(arc.start), s(max(arc.start, last)))
    theta = arc.start + (theta - arc.start).reduced()
    if theta < arc.end:
        assert image.start <= s(theta) <= image.end
    # The end is not part of the arc.
    assert s(arc.end) >= image.end


@given(transfer_functions(), any_arc)
def test_an_arc_lies_in_the_preimage_of_its_image(s, arc):
    """Refuted by an arc that loses an orientation on the way there and back."""
    image = s.image(arc)
    beyond = min(FULL_TURN, image.width + Angle(0, (10**9, 1)))
    back = s.preimage(Arc(image.start, beyond))
    assert back.start <= arc.start
    if image.width < FULL_TURN:
        assert arc.end <= back.end


# --- new functions from old ----------------------------------------------------------------------


@given(transfer_functions(), transfer_functions(), points)
def test_composites_are_pointwise(outer, inner, theta):
    """Refuted by a theta with (outer . inner)(theta) != outer(inner(theta))."""
    assert outer.compose(inner)(theta) == outer(inner(theta))


@given(step_functions(), step_functions(), step_functions())
def test_composition_is_associative(f, g, h):
    """Refuted by three maps for which the two orders differ."""
    assert f.compose(g).compose(h) == f.compose(g.compose(h))


@given(transfer_functions(), st.integers(1, 6), st.integers(1, 6), points)
def test_powers(s, m, n, theta):
    """Refuted by s^(m+n) != s^m . s^n, or a power that is not repeated application."""
    assert s.power(m + n) == s.power(m).compose(s.power(n))
    reached = theta
    for _ in range(m):
        reached = s(reached)
    assert s.power(m)(theta) == reached


@given(transfer_functions(), orientations, points)
def test_an_action_turns_and_then_squeezes(s, alpha, theta):
    """Eq. 4.1; refuted by a theta where the action at alpha is not s(theta - alpha)."""
    assert s.after_turning(alpha)(theta) == s(theta - alpha)


@given(transfer_functions(), orientations, points)
def test_rotation_moves_the_graph_along_the_diagonal(s, angle, theta):
    """Refuted by a theta where the rotated map is not s(theta - angle) + angle."""
    rotated = s.rotate(angle)
    assert rotated(theta) == s(theta - angle) + angle
    assert rotated.rotate(-angle) == s


# --- equality up to rotation ---------------------------------------------------------------------


@given(transfer_functions(), orientations)
def test_rotations_are_recovered(s, angle):
    """Refuted by a rotated copy that is not recognised, or by another angle than the turn's."""
    found = s.rotation_to(s.rotate(angle))
    assert found == angle % s.period
    assert s.equals_up_to_rotation(s.rotate(angle))


@given(st.one_of(st.tuples(necklaces(), necklaces()), st.tuples(step_functions(), necklaces())))
def test_equality_up_to_rotation_against_all_rotations(pair):
    """Refuted by two maps for which trying every pair of breaks gives another answer."""
    s, other = pair
    found = s.rotation_to(other)
    tried = [
        turn
        for b in other.breaks
        for k in range(len(s))
        if s.rotate(turn := (b - s.lifted_breaks[k]) % s.period) == other
    ]
    assert (found is None) == (not tried)
    if tried:
        assert found == min(tried)
    assert s.equals_up_to_rotation(other) == other.equals_up_to_rotation(s)


@given(transfer_functions())
def test_repr_reads_back(s):
    """Refuted by a map whose repr evaluates to another map."""
    assert eval(repr(s)) == s
