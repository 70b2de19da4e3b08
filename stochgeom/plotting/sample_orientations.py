"""Which initial orientations a picture of a plan shows.

Without a prior one in every step of the first action. Under a prior only what arrives: its points,
or the middles of equal shares of it. Floats choose; what is chosen is exact.
"""

from __future__ import annotations

from bisect import bisect_left
from collections.abc import Iterator
from dataclasses import dataclass
from itertools import accumulate, pairwise
from math import ceil
from typing import Final, final

from gmpy2 import mpq

from stochgeom.decision.discrete_prior import DiscretePrior
from stochgeom.decision.mixture_prior import MixturePrior
from stochgeom.decision.piecewise_prior import PiecewisePrior
from stochgeom.decision.priors import Prior, UniformPrior
from stochgeom.errors import InputError
from stochgeom.exact.angles import FULL_TURN, Angle
from stochgeom.exact.directions import nominal_angle
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.plotting.curves import in_degrees
from stochgeom.plotting.distributions import BINS, bin_masses
from stochgeom.transfer.step_function import StepFunction

_QUANTILES: Final = 5
"""So many equal shares of a prior that is no list of points are shown."""


@final
@dataclass(frozen=True, slots=True)
class Sample:
    """Initial orientations, increasing, and what they are chosen from, in words."""

    orientations: tuple[Angle, ...]
    words: str


def sample_orientations(plan: FeedingPlan, most: int) -> Sample:
    """Return at most so many initial orientations of a plan.

    Raises
    ------
    InputError
        If ``most`` is below 1.

    Examples
    --------
    >>> from stochgeom.feeding.planner import plan_feeding
    >>> prior = DiscretePrior.from_counts({"0": 5, "90": 3})
    >>> plan = plan_feeding([(0, 0), (3, 0), (3, 2), (0, 2)], prior=prior)
    >>> found = sample_orientations(plan, 8)
    >>> [theta.degrees(0) for theta in found.orientations], found.words
    (['0', '90'], 'all that arrive')
    """
    if most < 1:
        raise InputError(f"{most} traces; accepted: 1 or more")
    if plan.prior is None or isinstance(plan.prior, UniformPrior):
        return _of_steps(plan, most)
    points = sorted(_points(plan.prior), key=lambda point: point[0])
    if isinstance(plan.prior, DiscretePrior):
        if len(points) <= most:
            return Sample(tuple(theta for theta, _ in points), "all that arrive")
        return Sample(_quantiles(points, most), f"{most} of {len(points)} that arrive")
    found = _quantiles(points, min(most, _QUANTILES))
    return Sample(found, f"{len(found)} as they arrive")


def _of_steps(plan: FeedingPlan, most: int) -> Sample:
    transfer, first = plan.transfer, plan.angles[0]
    count = len(transfer) * transfer.order
    chosen = range(count) if count <= most else [count * k // most for k in range(most)]
    found = sorted((_inside(transfer, k) + first).reduced() for k in chosen)
    words = "one in each step" if count <= most else f"in {most} of {count} steps"
    return Sample(tuple(found), words)


def _inside(transfer: StepFunction, k: int) -> Angle:
    """Return an orientation in the middle of step k, or of its larger part beside its value."""
    start, end = transfer.lifted_breaks[k], transfer.lifted_breaks[k + 1]
    value = transfer.lifted_values[k]
    if not start < value < end:
        return nominal_angle(start, end)
    before = value - start > end - value
    return nominal_angle(start, value) if before else nominal_angle(value, end)


def _points(prior: Prior) -> Iterator[tuple[Angle, float]]:
    """Yield orientations that may arrive, each with the probability of what it stands for."""
    if isinstance(prior, DiscretePrior):
        yield from ((theta, float(weight)) for theta, weight in prior)
    elif isinstance(prior, MixturePrior):
        for weight, part in prior.components:
            yield from ((theta, float(weight) * mass) for theta, mass in _points(part))
    elif isinstance(prior, PiecewisePrior):
        yield from _inside_pieces(prior)
    else:
        for k, mass in enumerate(bin_masses(prior)):
            if mass > 0.0:
                yield Angle.from_turns(mpq(2 * k + 1, 2 * BINS)), mass


def _inside_pieces(prior: PiecewisePrior) -> Iterator[tuple[Angle, float]]:
    """Yield the middles of arcs of about 3 degrees inside the pieces that have a density."""
    density = prior.density
    for (low, high), value in zip(
        pairwise([*density.breaks, FULL_TURN]), density.densities, strict=True
    ):
        if not value:
            continue
        width = in_degrees(high - low)
        count = ceil(width * BINS / 360.0)
        turns = (mpq(f"{width / 360.0:.12f}") * mpq(2 * k + 1, 2 * count) for k in range(count))
        for turn in turns:
            yield low + Angle.from_turns(turn), float(value) * width / 360.0 / count


def _quantiles(points: list[tuple[Angle, float]], most: int) -> tuple[Angle, ...]:
    """Return the middles of so many equal shares, those that differ."""
    sums = list(accumulate(mass for _, mass in points))
    wanted = (sums[-1] * (2 * k + 1) / (2 * most) for k in range(most))
    numbers = {min(bisect_left(sums, share), len(points) - 1) for share in wanted}
    return tuple(points[k][0] for k in sorted(numbers))
