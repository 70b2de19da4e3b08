"""Laws of grasps with friction: preimages, bounds, symmetries, and the friction as a variable."""

from __future__ import annotations

from fractions import Fraction

from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from stochgeom.decision.priors import uniform_prior
from stochgeom.exact.angles import FULL_TURN, HALF_TURN, Angle
from stochgeom.exact.cells import CellSet
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.part import Part
from stochgeom.grasping.friction_bounds import GuaranteedBound
from stochgeom.grasping.grasp_diagram import GraspDiagram
from stochgeom.grasping.pushing_model import mass_after_push, pushing_bound, pushing_bounds
from stochgeom.grasping.pushing_over_friction import PushingBound
from stochgeom.grasping.regular import regular_bound
from stochgeom.transfer.push import push_function
from stochgeom.transfer.squeeze import squeeze_function
from tests.strategies import (
    cell_sets,
    centered_parts,
    frictions,
    nearly_regular,
    pushable_parts,
    rational_orientations,
    rotations,
    small_pushable_parts,
)

FEW = max(25, settings().max_examples // 12)
any_part = st.one_of(pushable_parts(), pushable_parts(), centered_parts())
diagrams = st.builds(GraspDiagram, any_part, frictions)


# --- preimages -----------------------------------------------------------------------------------


@given(diagrams)
@settings(max_examples=FEW)
def test_strong_preimages_are_inside_weak_ones(diagram):
    final = diagram.stable_set | diagram.wedged_set
    for target in (diagram.stable_set, diagram.wedged_set, final):
        assert diagram.strong_preimage(target) <= diagram.weak_preimage(target)
    edge = diagram.stable[0].orientation
    assert diagram.strong_preimage(edge) <= diagram.weak_preimage(edge)
    assert diagram.strong_preimage(edge) <= diagram.guaranteed
    assert diagram.weak_preimage(final).is_whole


@given(diagrams)
@settings(max_examples=FEW)
def test_what_must_end_stable_cannot_end_wedged(diagram):
    """The remark after Eq. 3.8: Pi(stable) is the complement of G^-1(wedged), and vice versa."""
    assert diagram.guaranteed == ~diagram.weak_preimage(diagram.wedged_set)
    assert diagram.guaranteed == diagram.strong_preimage(diagram.stable_set)
    assert diagram.strong_preimage(diagram.wedged_set) == ~diagram.weak_preimage(diagram.stable_set)


@given(small_pushable_parts(), frictions, cell_sets())
@settings(max_examples=FEW)
def test_preimages_of_any_set_complement_each_other(part, mu, target):
    diagram = GraspDiagram(part, mu)
    assert diagram.strong_preimage(target) == ~diagram.weak_preimage(~target)


@given(diagrams, rational_orientations)
@settings(max_examples=FEW)
def test_membership_in_a_preimage_is_read_off_the_image(diagram, theta):
    image = diagram.image(theta)
    assert image
    assert (theta in diagram.guaranteed) == (image <= diagram.stable_set)
    for edge in diagram.stable[:4]:
        here = CellSet.at([edge.orientation])
        assert (theta in diagram.weak_preimage(edge.orientation)) == bool(image & here)
        assert (theta in diagram.strong_preimage(edge.orientation)) == (image == here)


@given(diagrams)
@settings(max_examples=FEW)
def test_half_a_turn_exchanges_the_jaws(diagram):
    for cells in (diagram.guaranteed, diagram.wedged_set, diagram.stable_set):
        assert cells.rotate(HALF_TURN) == cells
    lower = diagram.lower.weak_preimage(diagram.wedged_set)
    assert lower.rotate(HALF_TURN) == diagram.upper.weak_preimage(diagram.wedged_set)


@given(any_part, rational_orientations)
@settings(max_examples=FEW)
def test_without_friction_squeezes_and_pushes_are_the_transfer_functions(part, theta):
    diagram = GraspDiagram(part, 0)
    squeeze, push = squeeze_function(part), push_function(part)
    ends = diagram.squeeze.outcomes(theta)
    assert squeeze(theta).reduced() in ends  # at a maximum the right-hand step is one of two
    assert len(ends) == 1 + (theta % squeeze.period in squeeze.breaks.angles)
    arc = diagram.lower.image(theta)
    assert push(theta).reduced() in {arc.start.reduced(), arc.end.reduced()}


# --- bounds --------------------------------------------------------------------------------------


@given(diagrams)
@settings(max_examples=FEW)
def test_bounds_are_ordered(diagram):
    pushing = pushing_bound(diagram)
    assert diagram.strict_bound.sign() >= 0
    assert diagram.strict_bound.compare(diagram.bound) <= 0
    assert float(diagram.bound) <= float(pushing) + 1e-12
    assert float(pushing) <= 1 + 1e-12
    assert diagram.bound_under(uniform_prior()).compare(diagram.bound) == 0


@given(diagrams)
@settings(max_examples=FEW)
def test_the_bounds_of_the_stable_orientations_add_up(diagram):
    total = sum(float(bound) for _, bound in pushing_bounds(diagram))
    assert abs(total - float(pushing_bound(diagram))) < 1e-12
    upper = mass_after_push(diagram.upper, ~diagram.wedged_set)
    assert abs(float(upper) - total) < 1e-12


@given(any_part)
@settings(max_examples=FEW)
def test_without_friction_everything_ends_stable(part):
    diagram = GraspDiagram(part, 0)
    assert diagram.guaranteed.is_whole
    assert diagram.guaranteed_if_strict.is_whole
    assert not diagram.wedged_set
    assert not any(edge.by_friction for edge in diagram.stable)
    assert pushing_bound(diagram).rational == 1
    assert len(diagram.stable) == 2 * len(squeeze_function(part)) * (
        squeeze_function(part).order // 2
    )


@given(any_part, frictions, frictions)
@settings(max_examples=FEW)
def test_more_friction_never_helps(part, first, second):
    less, more = sorted((first, second))
    slippery, sticky = GraspDiagram(part, less), GraspDiagram(part, more)
    assert slippery.wedged_set <= sticky.wedged_set
    assert sticky.guaranteed <= slippery.guaranteed
    assert slippery.stable_set <= sticky.stable_set


@given(any_part, frictions, rotations)
@settings(max_examples=FEW)
def test_turning_the_part_turns_the_sets(part, mu, turn):
    diagram, turned = GraspDiagram(part, mu), GraspDiagram(part.multiply(turn), mu)
    back = -Angle(0, turn)
    assert turned.guaranteed == diagram.guaranteed.rotate(back)
    assert turned.guaranteed_if_strict == diagram.guaranteed_if_strict.rotate(back)
    assert turned.stable_set == diagram.stable_set.rotate(back)


@given(any_part, frictions)
@settings(max_examples=FEW)
def test_a_mirror_image_has_mirrored_sets(part, mu):
    """Nothing here has a preferred side, as the sets have exact ends."""
    diagram, mirrored = GraspDiagram(part, mu), GraspDiagram(part.reflect(), mu)
    assert mirrored.guaranteed == diagram.guaranteed.reflect()
    assert mirrored.wedged_set == diagram.wedged_set.reflect()
    assert mirrored.squeeze.wedged_if_strict == diagram.squeeze.wedged_if_strict.reflect()


HAIR = Angle(0, (10**20, 1))
"""About 10**-20 radians."""


@given(diagrams)
@settings(max_examples=FEW)
def test_the_largest_tolerance_is_borne_and_no_larger_one(diagram):
    """Eq. 3.7 by the map itself: what the orientations at the ends, and a hair beyond, may become.

    Refuted by an end that is said to be borne and may wedge, by a larger error that may not, or by
    another interval that bears more.
    """
    found = diagram.largest_tolerances()
    assert bool(found) == bool(diagram.guaranteed)

    def ends_stable(theta):
        return diagram.image(theta) <= diagram.stable_set

    for best in found:
        low, high = best.interval.start, best.interval.end
        assert best.margin.doubled == high - low
        assert best.orientation.doubled % FULL_TURN == (low + high) % FULL_TURN
        if diagram.guaranteed.is_whole:
            assert ends_stable(low)
            continue
        assert best.attained == (ends_stable(low) and ends_stable(high))
        assert not ends_stable(low - HAIR)
        assert not ends_stable(high + HAIR)
        if high - low > HAIR + HAIR:
            assert ends_stable(low + HAIR)
            assert ends_stable(high - HAIR)
    if found and not diagram.guaranteed.is_whole:
        largest = max(item.width for item in diagram.guaranteed)
        assert found[0].margin.doubled == largest
        same = [item for item in diagram.guaranteed if item.width == largest]
        assert len(found) == len(same)


@given(diagrams)
@settings(max_examples=FEW)
def test_an_error_a_hair_larger_is_not_borne(diagram):
    """Where the margin is an exact angle; refuted by a grasp that bears more."""
    for best in diagram.largest_tolerances()[:1]:
        margin = best.margin.angle
        if margin is not None and margin < HALF_TURN:
            assert bool(diagram.grasps_bearing(margin)) == any(
                item.attained for item in diagram.largest_tolerances()
            )
            assert not diagram.grasps_bearing(margin + HAIR)


@given(any_part, frictions.filter(bool))
@settings(max_examples=FEW)
def test_with_friction_no_stable_grasp_is_guaranteed(part, mu):
    """3.12, and why: where the diameter is largest two corners face each other, and it wedges.

    Refuted by friction, however little, that leaves every grasp sure to end stable.
    """
    diagram = GraspDiagram(part, mu)
    assert not diagram.guaranteed.is_whole
    for peak in DiameterFunction(part).maxima:
        for theta in (peak, peak + HALF_TURN):
            assert theta in diagram.wedged_set
            assert theta not in diagram.guaranteed


@given(st.integers(2, 30), frictions.filter(bool), frictions.filter(bool))
@settings(max_examples=FEW)
def test_more_sides_and_more_friction_lower_the_bound(half, first, second):
    """After Eq. 3.14, for an even number of sides; refuted by a bound that does not fall.

    An odd number has the bound 0 at once: with all numbers of sides it goes up and down.
    """
    less, more = sorted((first, second))
    bounds = [regular_bound(n, less) for n in (2 * half, 2 * half + 1, 2 * half + 2)]
    assert bounds[0].compare(bounds[2]) == (1 if bounds[0].sign() else 0)
    assert bounds[1].sign() == 0
    rougher = regular_bound(2 * half, more)
    assert bounds[0].compare(rougher) == (1 if bounds[0].sign() and less < more else 0)


# --- the friction as a variable ------------------------------------------------------------------

mus = st.one_of(frictions, st.fractions(0, 4, max_denominator=30))


@given(st.one_of(any_part, nearly_regular(most=8)), mus)
@settings(max_examples=FEW)
def test_the_bound_as_a_function_is_the_bound_of_the_diagram(part, mu):
    assert GuaranteedBound(part)(mu).compare(GraspDiagram(part, mu).bound) == 0


@given(any_part, st.data())
@settings(max_examples=FEW)
def test_the_bound_at_and_about_a_breakpoint(part, data):
    """Where the breakpoint is an exact angle: its value is that of the diagram, from the left."""
    bound = GuaranteedBound(part)
    exact = [half.angle for half in bound.breakpoints if half.angle is not None]
    if exact:
        alpha = data.draw(st.sampled_from(exact))
        near = Angle(0, (10**30, 1))
        for angle in (alpha - near, alpha, alpha + near):
            assert bound(angle).compare(GraspDiagram(part, angle).bound) == 0


@given(any_part)
@settings(max_examples=FEW)
def test_the_limit_is_the_bound_for_hardly_any_friction(part):
    bound = GuaranteedBound(part)
    first = bound.breakpoints[0].nearby if bound.breakpoints else Angle(0, (1, 1))
    tiny = Angle(0, (10**20, 1))
    assert tiny < first
    gap = float(bound.limit) - float(bound(tiny))
    assert -1e-12 < gap < 1e-12
    assert bound(0).rational == 1


@given(st.one_of(any_part, nearly_regular(most=8)), mus)
@settings(max_examples=FEW)
def test_the_pushing_bound_as_a_function(part, mu):
    found, expected = PushingBound(part)(mu), pushing_bound(GraspDiagram(part, mu))
    assert found.decimal(15) == expected.decimal(15)
    assert found.rational == expected.rational


probabilities = st.fractions(0, 1, max_denominator=20)


@given(any_part, probabilities)
@settings(max_examples=FEW)
def test_the_largest_friction_is_the_largest(part, probability):
    bound = GuaranteedBound(part)
    limit = bound.largest_friction(probability)
    if limit is None:
        assert bound(10**9).compare(probability) >= 0
        return
    low = Fraction(limit.decimal(9))
    high = low + Fraction(1, 10**9)
    assert limit.compare(mpq(low)) >= 0
    assert limit.compare(mpq(high)) < 0
    assert bound(low).compare(probability) >= 0
    assert bound(high).compare(probability) < 0


@given(small_pushable_parts(), probabilities)
@settings(max_examples=FEW)
def test_the_largest_friction_under_the_pushing_model(part, probability):
    bound = PushingBound(part)
    limit = bound.largest_friction(probability)
    if limit is None:
        assert probability == 0
        return
    low = Fraction(limit.decimal(9))
    assert float(bound(low)) >= probability - 1e-12
    assert float(bound(low + Fraction(1, 10**9))) < probability + 1e-12


def test_a_square_of_the_laws():
    """A literal anchor: each edge of a square keeps 45 degrees less the friction angle."""
    diagram = GraspDiagram(Part([(0, 0), (1, 0), (1, 1), (0, 1)]), "1/4")
    assert diagram.bound.compare(GuaranteedBound(diagram.part)("1/4")) == 0
    assert diagram.bound.decimal(10) == "0.6880834785"
