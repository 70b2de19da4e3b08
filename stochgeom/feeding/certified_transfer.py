"""What a certificate says of a transfer function: every break and every value, and why.

Of a squeeze function: each maximum of the diameter with the two vertices on the jaws, each minimum
with the flush edge. Of a push function: each maximum of the radius with the vertex straight below
the centre of mass, each minimum with the edge on the lower jaw. Of push-grasp, both of these, and
each step of their composite by the push break and the squeeze value that it comes from. All
vertices are numbered as in the outline; of repeated ones, the first is named.
"""

from __future__ import annotations

from typing import Any, Final

from stochgeom.errors import InputError
from stochgeom.exact.angles import Angle
from stochgeom.exact.scalars import rational_text
from stochgeom.exact.surds import scalar_text
from stochgeom.geometry.calipers import NO_EDGE
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.part import Part
from stochgeom.geometry.radius import RadiusFunction
from stochgeom.transfer.push import push_function
from stochgeom.transfer.squeeze import squeeze_function
from stochgeom.transfer.step_function import StepFunction

Json = dict[str, Any]

CERTIFIED_ACTIONS: Final = ("squeeze", "push-grasp")
"""The actions that the checker knows."""


def transfer_claims(part: Part, transfer: StepFunction, action: str) -> Json:
    """Return what a certificate says of the transfer function of one of `CERTIFIED_ACTIONS`.

    O(n) objects, after the O(n log n) of the extrema.

    Raises
    ------
    InputError
        If `transfer` is not what the named action does to the part.

    Examples
    --------
    >>> square = Part([(0, 0), (2, 0), (2, 2), (0, 2)])
    >>> transfer_claims(square, squeeze_function(square), "squeeze")["breaks"]
    [{'angle': {'turns': 0, 'direction': ['1', '1']}, 'lower': [0], 'upper': [2]}]
    """
    diameter = DiameterFunction(part)
    expected = squeeze = squeeze_function(diameter)
    claims = _squeeze_claims(diameter, squeeze)
    if action == "push-grasp":
        radius = RadiusFunction(part)
        push = push_function(radius)
        expected = squeeze.compose(push)
        claims = {
            "push": _push_claims(radius, push),
            "squeeze": claims,
            **_composite_claims(push, squeeze, expected),
        }
    if transfer != expected:
        raise InputError(
            f"the plan's transfer function is not that of {action}; accepted: plans for what "
            "this action does to this part, the lower jaw pushing"
        )
    return claims


def part_claims(part: Part, action: str) -> Json:
    """Return what a certificate holds of a part: its centre of mass only where it is pushed.

    And the field of its coordinates, unless these are rational.
    """
    center = {} if action == "squeeze" else {"center_of_mass": _point(part.center_of_mass)}
    field = {} if part.field is None else {"field": part.field.description()}
    return {"name": part.name, "vertices": [_point(v) for v in part.vertices], **field, **center}


def hull_numbers(part: Part) -> list[int]:
    """Return the hull vertices counter-clockwise, beginning with the smallest number."""
    numbers = _first_numbers(part)
    start = numbers.index(min(numbers))
    return numbers[start:] + numbers[:start]


def angle_claim(angle: Angle) -> Json:
    """Return an angle in its canonical form: over a field, its turns need not be whole."""
    turns = angle.turn_part
    return {
        "turns": int(turns) if turns.denominator == 1 else rational_text(turns),
        "direction": [scalar_text(number) for number in angle.direction],
    }


def _point(point: Any) -> list[str]:
    return [scalar_text(number) for number in point]


def _first_numbers(part: Part) -> list[int]:
    """Return for each hull vertex the first vertex of the outline at its point."""
    first: dict[object, int] = {}
    for k, vertex in enumerate(part.vertices):
        first.setdefault(vertex, k)
    return [first[part.vertices[int(k)]] for k in part.hull.indices]


# --- squeezing -----------------------------------------------------------------------------------


def _squeeze_claims(diameter: DiameterFunction, squeeze: StepFunction) -> Json:
    numbers = _first_numbers(diameter.part)
    return {
        "period": angle_claim(squeeze.period),
        "breaks": _squeeze_breaks(diameter, len(squeeze), numbers),
        "values": _squeeze_values(diameter, squeeze, numbers),
    }


def _squeeze_breaks(diameter: DiameterFunction, count: int, numbers: list[int]) -> list[Json]:
    """Return the maxima of one period with the antipodal vertices that touch the jaws."""
    calipers, maxima = diameter.calipers, diameter.unstable
    rows = []
    for k, piece in enumerate(maxima.places[:count].tolist()):
        angle = maxima.angles[k]
        jaws = [numbers[calipers.lower[piece]]], [numbers[calipers.upper[piece]]]
        # A maximum of the last piece beyond 180 degrees is listed half a turn before.
        lower, upper = jaws if angle > diameter.transitions[piece] else jaws[::-1]
        rows.append({"angle": angle_claim(angle), "lower": lower, "upper": upper})
    return rows


def _squeeze_values(
    diameter: DiameterFunction, squeeze: StepFunction, numbers: list[int]
) -> list[Json]:
    """Return the minima that follow the breaks of one period, with the flush edge."""
    stable = diameter.stable
    # Minima and maxima alternate; the first break may be followed by the second minimum.
    shift = int(stable.angles[0] < squeeze.breaks[0])
    rows = []
    for k, angle in enumerate(squeeze.values):
        lap, place = divmod(k + shift, len(stable.angles))
        lower, upper = _jaws(diameter, int(stable.places[place]), numbers)
        if lap:  # half a turn on, the jaws are exchanged, and left and right as well
            lower, upper = upper[::-1], lower[::-1]
        rows.append({"angle": angle_claim(angle), "lower": lower, "upper": upper})
    return rows


def _jaws(
    diameter: DiameterFunction, place: int, numbers: list[int]
) -> tuple[list[int], list[int]]:
    """Return the vertices on both jaws at a transition, from left to right."""
    calipers = diameter.calipers
    # An edge on the lower jaw is touched at its right end before and at its left end after.
    lower = [numbers[calipers.lower[place]], numbers[calipers.lower_before[place]]]
    upper = [numbers[calipers.upper_before[place]], numbers[calipers.upper[place]]]
    return (
        lower if calipers.lower_edge[place] != NO_EDGE else lower[:1],
        upper if calipers.upper_edge[place] != NO_EDGE else upper[:1],
    )


# --- pushing, and squeezing after it --------------------------------------------------------------


def _push_claims(radius: RadiusFunction, push: StepFunction) -> Json:
    """Return the maxima of the radius in one period, and the minima that follow them."""
    numbers = _first_numbers(radius.part)
    stable, unstable = radius.stable, radius.unstable
    shift = int(stable.angles[0] < push.breaks[0])
    breaks, values = [], []
    for k, (below, value) in enumerate(zip(push.breaks, push.values, strict=True)):
        vertex = numbers[int(unstable.places[k])]
        breaks.append({"angle": angle_claim(below), "vertex": vertex})
        # Hull edges run counter-clockwise: on the lower jaw, from left to right.
        edge = int(stable.places[(k + shift) % len(stable.places)])
        ends = [numbers[edge], numbers[(edge + 1) % len(numbers)]]
        values.append({"angle": angle_claim(value), "edge": ends})
    return {"period": angle_claim(push.period), "breaks": breaks, "values": values}


def _composite_claims(push: StepFunction, squeeze: StepFunction, both: StepFunction) -> Json:
    """Return the steps of a composite with the numbers of the lifted steps they come from.

    Push value k is the one that follows push break k. Of push breaks whose values are squeezed to
    one, only the first is a break of the composite.
    """
    from_push = [push.step_at(angle) for angle in both.breaks]
    from_squeeze = [squeeze.step_at(push.lifted_values[k]) for k in from_push]
    return {
        "period": angle_claim(both.period),
        "breaks": [
            {"angle": angle_claim(angle), "push_break": k}
            for angle, k in zip(both.breaks, from_push, strict=True)
        ],
        "values": [
            {"angle": angle_claim(angle), "squeeze_value": k}
            for angle, k in zip(both.values, from_squeeze, strict=True)
        ],
    }
