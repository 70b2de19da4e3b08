"""What settles the errata on stable orientations: how many there are, and of which function."""

from __future__ import annotations

from collections.abc import Iterable

from stochgeom.exact.angles import HALF_TURN, ZERO, Angle
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.radius import RadiusFunction
from stochgeom.thesis.facts import Fact, Facts, equal
from stochgeom.thesis.parts import catalogue_names, catalogue_part
from stochgeom.transfer.push import push_function
from stochgeom.transfer.squeeze import squeeze_function
from stochgeom.transfer.step_function import StepFunction


def sign_of_the_potential() -> Facts:
    """Show that stable orientations are minima of U = +k d^2 / 2, so not of its negative."""
    below = above = 0
    for name in catalogue_names():
        d = DiameterFunction(catalogue_part(name))
        for low in d.minima:
            above_it = min((high - low) % HALF_TURN for high in d.maxima)
            below_it = min((low - high) % HALF_TURN for high in d.maxima)
            beside = (low + above_it, low - below_it)
            is_minimum = all(d.potential(low) < d.potential(high) for high in beside)
            below, above = below + is_minimum, above + (not is_minimum)
    return (
        equal("stable orientations whose d^2 / 2 is not below that of the maxima beside", above, 0),
        Fact("of all parts, those where it is", str(below), below > 0),
    )


def stable_orientations() -> Facts:
    """Show that 2 n is the most stable orientations of a turn: each edge has one at either jaw.

    With parallel edges two of them are one; half a turn apart they are one grasp, at most n.
    """
    counts = {
        name: (len(catalogue_part(name).hull), len(squeeze.values) * squeeze.order, squeeze)
        for name in catalogue_names()
        for squeeze in (squeeze_function(catalogue_part(name)),)
    }
    halved = [
        sum(value.reduced() < HALF_TURN for value in _all_values(squeeze))
        for _, _, squeeze in counts.values()
    ]
    return (
        equal("edges and stable orientations of the 4gon", counts["4gon"][:2], (4, 8)),
        equal("of the rectangle, whose edges are parallel", counts["rectangle"][:2], (4, 4)),
        Fact(
            "parts with more stable orientations than edges",
            ", ".join(name for name, (n, stable, _) in counts.items() if stable > n),
            any(stable > n for n, stable, _ in counts.values()),
        ),
        equal(
            "parts of the eight with at most 2 n, and n in half a turn",
            sum(
                stable <= 2 * n and half <= n
                for (n, stable, _), half in zip(counts.values(), halved, strict=True)
            ),
            len(counts),
        ),
    )


def _all_values(transfer: StepFunction) -> list[Angle]:
    """Return the values of a step function in a full turn."""
    return [v + transfer.period * k for v in transfer.values for k in range(transfer.order)]


def caption_of_figure_e_1() -> Facts:
    """Show that a push ends at minima of the radius, and that the diameter has others."""
    facts = []
    for name in ("4gon", "house"):
        part = catalogue_part(name, appendix="E")
        push, radius, diameter = push_function(part), RadiusFunction(part), DiameterFunction(part)
        maxima = set(radius.maxima)
        facts += [
            equal(
                f"where a push of the {name} ends, in degrees: at minima of the radius",
                _sorted_degrees(push.values),
                _sorted_degrees(radius.minima),
            ),
            equal(
                "  what it turns away from: maxima of the radius",
                _sorted_degrees(push.breaks),
                _sorted_degrees(radius.maxima),
            ),
            Fact(
                "  of which maxima of the diameter, half a turn on as well",
                str(len(maxima & _everywhere(diameter.maxima))),
                not maxima <= _everywhere(diameter.maxima),
            ),
        ]
    return tuple(facts)


def _sorted_degrees(angles: Iterable[Angle]) -> list[str]:
    """Return orientations of one turn in order, as decimals."""
    return [angle.degrees(2) for angle in sorted(angle.reduced() for angle in angles)]


def _everywhere(angles: Iterable[Angle]) -> set[Angle]:
    """Return orientations and those half a turn from them."""
    return {(theta + shift).reduced() for theta in angles for shift in (ZERO, HALF_TURN)}
