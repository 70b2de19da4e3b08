"""The uniform pushing model: every length of the push is equally likely (thesis App. C).

Let s be the stable orientation ahead of an initial orientation theta_1, and u the unstable one
behind it. The model takes the orientation theta_2 at which the second jaw touches as uniform
between theta_1 and s. For a random theta_1, and with x the way from s to theta_2 and L that from s
to u, the density of theta_2 is

    f(theta_2) = ln(L / x)   for each full turn                             (Eq. C.4)

and its integral from x = a to x = b is F(b) - F(a), in full turns, with

    F(x) = x + x ln(L / x),   F(0) = 0,   F(L) = L.                         (Eq. C.7)

Integrated over the orientations that a squeeze brings to a stable one, this bounds P(stable) more
tightly than Eq. 3.13. Each jaw is the first one with probability 1/2. All numbers are rational
combinations of angles and of such logarithms: exact where no logarithm is left, and otherwise
enclosed by balls as tightly as asked.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from typing import final

from gmpy2 import mpq

from stochgeom.arguments import expect
from stochgeom.decision.probabilities import Atom, Enclosed
from stochgeom.errors import InputError
from stochgeom.exact.angles import FULL_TURN, ZERO, Angle
from stochgeom.exact.balls import Ball
from stochgeom.exact.cells import CellSet, merge
from stochgeom.exact.sums import AngleSum, Probability
from stochgeom.grasping.grasp_diagram import GraspDiagram
from stochgeom.grasping.push_stability import PushStability
from stochgeom.grasping.squeeze_stability import WEDGED, SqueezeStability, StableEdge


@final
@dataclass(frozen=True, slots=True)
class Logarithm:
    """The number x ln(L / x), in full turns, for 0 < x < L."""

    x: Angle
    length: Angle

    def ball(self) -> Ball:
        """Return an Arb ball around the number, at the working precision."""
        x = self.x.ball()
        return x * (self.length.ball() / x).log()


def density_after_push(push: PushStability, theta: Angle) -> Probability:
    """Return the density of the orientation at which the second jaw touches (Eq. C.4).

    For a random initial orientation and one known jaw that touches first, for each full turn: a
    uniform one is 1. At an unstable equilibrium it is 0.

    Raises
    ------
    InputError
        At a stable orientation, where the density is infinite.

    Examples
    --------
    >>> square = PushStability([(0, 0), (1, 0), (1, 1), (0, 1)])
    >>> density_after_push(square, Angle.from_degrees("22.5")).decimal(6)
    '0.693147'
    """
    expect(push, PushStability, "a PushStability, such as PushStability(part)")
    expect(theta, Angle, "an Angle", "theta")
    valley = push.valley_of(theta)
    end = valley.high if theta > valley.stable else valley.low
    if theta == valley.stable:
        raise InputError(f"the density at the stable orientation {theta.reduced()} is infinite")
    if theta == valley.low:
        return AngleSum(0)
    x, length = theta - valley.stable, end - valley.stable
    return Enclosed.of(lambda: (length.ball() / x.ball()).log(), key=("ln", x, length))


def mass_after_push(push: PushStability, target: CellSet) -> Probability:
    """Return the probability that the second jaw touches in a set, if this jaw touches first.

    The integral of Eq. C.4 over the set, by Eq. C.7.  O(k).

    Examples
    --------
    >>> square = PushStability([(0, 0), (1, 0), (1, 1), (0, 1)])
    >>> mass_after_push(square, CellSet.whole()).rational
    mpq(1,1)
    """
    angles = merge(push.critical, target.angles)
    _, arcs = target.on(angles)
    place = {angle: k for k, angle in enumerate(angles)}
    ends: list[tuple[int, Angle, Angle]] = []
    for stable, unstable, step in push.sides:
        length = _way(stable, unstable, step)
        for k, sign in _ends_of_runs(arcs, place[stable], place[unstable], step):
            ends.append((sign, _way(stable, angles[k], step), length))
    return sum_of_integrals(0, ends)


def sum_of_integrals(
    constant: int, ends: Iterable[tuple[int, Angle, Angle]]
) -> AngleSum | Enclosed:
    """Return a constant plus the sum of weight * F(x), exact if no logarithm is left.

    Parameters
    ----------
    constant : int
        What is added.
    ends : iterable of (int, Angle, Angle)
        Weights, ways x in [0, L], and L.

    Examples
    --------
    >>> right = Angle.from_degrees(90)
    >>> sum_of_integrals(1, [(-1, right, right), (2, Angle(), right)]).rational
    mpq(3,4)
    """
    terms: list[tuple[int, Angle]] = []
    atoms: list[tuple[int, Atom]] = []
    for weight, x, length in ends:
        terms.append((weight, x))
        if x and x != length:
            number = Logarithm(x, length)
            atoms.append((weight, Atom(number, number.ball)))
    return Enclosed(atoms, AngleSum(constant, terms)).simplified()


def _way(start: Angle, end: Angle, step: int) -> Angle:
    """Return the way up or down from one orientation in [0, 360) degrees to another."""
    way = end - start if step > 0 else start - end
    return way + FULL_TURN if way < ZERO else way


def _ends_of_runs(
    arcs: Sequence[bool], first: int, last: int, step: int
) -> Iterator[tuple[int, int]]:
    """Yield where a run of arcs of a set begins (-1) or ends (1), on the way between two places."""
    m, k, inside = len(arcs), first, False
    while True:
        arc = arcs[k if step > 0 else k - 1]
        if arc != inside:
            yield k, -1 if arc else 1
            inside = arc
        k = (k + step) % m
        if k == last:
            break
    if inside:
        yield last, 1


def pushing_bound(diagram: GraspDiagram) -> Probability:
    """Return the lower bound on P(stable) of a random grasp under the uniform pushing model.

    Thesis App. C. The preimage is that under the squeeze alone: a part that is not wedged when the
    second jaw touches ends stable. Half a turn on the jaws are exchanged, so both have the same
    probability, and one of them is computed.  O(n).

    Examples
    --------
    >>> pushing_bound(GraspDiagram([(0, 0), (3, 0), (3, 2), (0, 2)], "0.25")).decimal(6)
    '0.940441'
    """
    expect(diagram, GraspDiagram, "a GraspDiagram, such as GraspDiagram(part, '1/4')")
    return mass_after_push(diagram.lower, ~diagram.wedged_set)


def pushing_bounds(diagram: GraspDiagram) -> tuple[tuple[StableEdge, Probability], ...]:
    """Return the bound for each stable orientation; together they make `pushing_bound`.

    O(n) together. The two jaws are averaged.

    Examples
    --------
    >>> square = GraspDiagram([(0, 0), (1, 0), (1, 1), (0, 1)], "0.25")
    >>> [bound.decimal() for _, bound in pushing_bounds(square)]
    ['0.2363', '0.2363', '0.2363', '0.2363']
    """
    expect(diagram, GraspDiagram, "a GraspDiagram, such as GraspDiagram(part, '1/4')")
    by_outcome: dict[int, list[tuple[int, Angle, Angle]]] = {}
    for push in diagram.jaws:
        for outcome, end in _ends_by_outcome(push, diagram.squeeze):
            by_outcome.setdefault(outcome, []).append(end)
    starts = diagram.squeeze.contacts.starts
    both = {starts[k]: ends for k, ends in by_outcome.items() if k != WEDGED}
    half = mpq(1, 2)
    return tuple(
        (edge, sum_of_integrals(0, both.get(edge.orientation, ())).scaled(half))
        for edge in diagram.stable
    )


def _ends_by_outcome(
    push: PushStability, squeeze: SqueezeStability
) -> Iterator[tuple[int, tuple[int, Angle, Angle]]]:
    """Yield (outcome, (weight, x, L)) for both ends of every run of arcs with one outcome."""
    angles = merge(push.critical, squeeze.angles)
    outcomes = squeeze.outcome_numbers(angles)
    place = {angle: k for k, angle in enumerate(angles)}
    m = len(angles)
    for stable, unstable, step in push.sides:
        length, k, last, start = _way(stable, unstable, step), place[stable], place[unstable], ZERO
        while k != last:
            (outcome,) = outcomes[k if step > 0 else k - 1]  # open arcs have one outcome
            k = (k + step) % m
            if k == last or outcomes[k if step > 0 else k - 1] != (outcome,):
                end = _way(stable, angles[k], step)
                yield outcome, (-1, start, length)
                yield outcome, (1, end, length)
                start = end


def average(numbers: Sequence[Probability]) -> Probability:
    """Return the mean of some probabilities, exact if all of them are."""
    total = AngleSum()
    for number in numbers:
        total = total + number
    return total.scaled(mpq(1, len(numbers)))
