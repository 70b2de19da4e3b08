"""Laws of grasps with friction: preimages, bounds, symmetries, and the friction as a variable."""

from __future__ import annotations

from fractions import Fraction

from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from stochgeom.decision.priors import uniform_prior
from stochgeom.exact.angles import HALF_TURN, Angle
from stochgeom.exact.cells import CellSet
from stochgeom.geometry.part import Part
from stochgeom.grasping.friction_bounds import GuaranteedBound
from stochgeom.grasping.grasp_diagram import GraspDiagram
from stochgeom.grasping.pushing_model import mass_after_push, pushing_bound, pushing_bounds
from stochgeom.grasping.pushing_over_friction import PushingBound
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


@given(diagrams)
@settings(max_examples=FEW)
def test_the_largest_tolerance_is_borne_and_no_larger_one(diagram):
    found = diagram.largest_tolerances()
    assert bool(found) == bool(diagram.guaranteed)
    widths = [item.width for item in diagram.guaranteed]
    for best in found:
        assert best.margin.doubled == max(widths)
        assert best.attained == best.interval.is_closed
    if found and not diagram.guaranteed.is_whole:
        third = Angle(0, (3, 1))
        wider = diagram.guaranteed.shrunk(found[0].margin.nearby + third)
        assert not wider


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
