"""What a plan does not depend on: where a part lies, how large it is, which side is up.

Widths, image widths, costs and step counts are invariant. Starts may differ among ties, and a
reflection swaps the closed side of a break, so s'(theta) = -s(-theta) holds off the breaks.
"""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from stochgeom.exact.angles import Angle
from stochgeom.feeding.planner import FeedingProblem
from stochgeom.geometry.part import Part
from stochgeom.transfer.squeeze import squeeze_function
from stochgeom.transfer.step_function import StepFunction
from tests.strategies import (
    circle_parts,
    directions,
    large_directions,
    nearly_regular,
    orientations,
    parts,
    ratios,
    rotations,
    shifts,
    transfer_functions,
)

any_part = st.one_of(parts(), parts(), circle_parts(), nearly_regular(most=7))
positive = ratios.filter(lambda factor: factor > 0)
COST_RATIOS = (0, "1/3", 1, 20)


def profile(part):
    """Return everything about the plans of a part that is invariant."""
    problem = FeedingProblem(part)
    chain = list(problem.preimages)
    return {
        "period": problem.transfer.period,
        "steps of the map": len(problem.transfer),
        "preimages": [(p.steps, p.width, p.image_width) for p in chain],
        "costs": [problem.expected_cost(p.steps, c) for c in COST_RATIOS for p in chain],
        "optimal": [problem.optimal_plan(c).steps for c in COST_RATIOS],
        "geometric": problem.geometric_plan().steps,
        "tolerances": [a.tolerance for a in problem.geometric_plan().actions],
    }


def turned(part, angle):
    """Return the transfer function that a part must have after a turn by `angle`."""
    return squeeze_function(part).rotate(-angle)


# --- moving --------------------------------------------------------------------------------------


@given(any_part, shifts)
def test_translation(part, shift):
    """Refuted by a moved part with another transfer function or another plan."""
    moved = part.translate(*shift)
    assert squeeze_function(moved) == squeeze_function(part)
    assert profile(moved) == profile(part)


@given(any_part, positive)
def test_scaling(part, factor):
    """Refuted by a scaled part with another transfer function or another plan."""
    scaled = part.scale(factor)
    assert squeeze_function(scaled) == squeeze_function(part)
    assert profile(scaled) == profile(part)


@given(any_part, rotations)
def test_rotation_by_pythagorean_directions(part, direction):
    """Refuted by a turned part whose map is not s(theta + beta) - beta, or with other plans."""
    other = part.rotate(direction)
    assert squeeze_function(other) == turned(part, Angle(0, direction))
    assert profile(other) == profile(part)
    assert other.area == part.area


@given(any_part, st.one_of(directions, large_directions))
def test_multiplication_by_any_direction(part, direction):
    """Refuted by a part turned and scaled whose map is not s(theta + beta) - beta."""
    other = part.multiply(direction)
    assert squeeze_function(other) == turned(part, Angle(0, direction))
    assert profile(other) == profile(part)


@given(any_part, st.integers(0, 20), st.booleans())
def test_vertex_order_and_start(part, start, backwards):
    """Refuted by the same outline, listed otherwise, with another transfer function or plan."""
    n = len(part)
    vertices = [part.vertices[(k + start) % n] for k in range(n)]
    other = Part(vertices[::-1] if backwards else vertices)
    assert squeeze_function(other) == squeeze_function(part)
    assert profile(other) == profile(part)
    mine, theirs = FeedingProblem(part).geometric_plan(), FeedingProblem(other).geometric_plan()
    assert mine.actions == theirs.actions
    assert mine.mouth == theirs.mouth


# --- reflecting ----------------------------------------------------------------------------------


def mirrored(s):
    """Return the map theta -> -s(-theta), made closed on the left."""
    values = [-s.lifted_values[k - 1] for k in range(len(s))]
    return StepFunction([-b for b in s.breaks][::-1], values[::-1], s.period)


@given(transfer_functions(), orientations)
def test_the_mirrored_map(s, theta):
    """s' differs from -s(-theta) on breaks only; refuted by another theta, or a break that fits."""
    other = mirrored(s)
    if s.lifted_breaks[s.step_at(-theta)] != -theta:
        assert other(theta) == -s(-theta)
    for k in range(len(s)):
        theta = -s.lifted_breaks[k]
        assert other(theta) == -s.lifted_values[k - 1] != -s(-theta)


@given(any_part, orientations)
def test_reflection(part, theta):
    """Refuted by a mirrored part whose map or plans are not the mirrored ones."""
    s, other = squeeze_function(part), squeeze_function(part.reflect())
    assert other == mirrored(s)
    if s.lifted_breaks[s.step_at(-theta)] != -theta:
        assert other(theta) == -s(-theta)
    assert profile(part.reflect()) == profile(part)


@given(any_part)
def test_reflection_twice_is_none(part):
    """Refuted by a part that its mirror image's mirror image is not equal to."""
    assert part.reflect().reflect() == part
    s = squeeze_function(part)
    assert mirrored(mirrored(s)) == s
