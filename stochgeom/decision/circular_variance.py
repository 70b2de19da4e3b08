"""The variance of a distribution of orientations on the circle (thesis 7.3).

A mean angle and squared differences from it depend on where the circle is cut open, so the source's
formula does not apply as it stands. The measure here is the variance of the unit vector u that
points in the direction of the orientation:

    V = E |u - E u|^2 = 1 - R^2,    R = |E u|, the length of the mean vector

V is 0 if the orientation is certain and 1 if it is, say, uniform on the circle or in one of two
opposite orientations; for small spreads it is the ordinary variance in radians squared. It orders
hyperstates as the circular variance 1 - R of the statisticians does, and, unlike that, it is a sum
of square roots with rational coefficients if the probabilities are rational and the orientations
differ by rational directions: two of them are compared for certain. Written over pairs of states,

    V = sum over i < j of 2 lambda_i lambda_j (1 - cos(theta_i - theta_j)),

so it does not change under rotation and reflection.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from itertools import combinations
from typing import TYPE_CHECKING, Any, Final, final

import numpy as np
from gmpy2 import is_square, isqrt, mpq, mpz
from numpy.typing import NDArray

from stochgeom.arguments import as_list, expect
from stochgeom.decision.angle_products import Cosine, product
from stochgeom.decision.distributions import distribution
from stochgeom.decision.number_kinds import NumberKind
from stochgeom.decision.plan_costs import CostModel, PlanCost, Prices
from stochgeom.decision.probabilities import Enclosed
from stochgeom.errors import CostError, ShapeMismatchError
from stochgeom.exact.angle_base import AngleBase
from stochgeom.exact.angles import FULL_TURN, HALF_TURN, QUARTER_TURN, Angle
from stochgeom.exact.independent_sums import RootSum
from stochgeom.exact.sums import AngleSum

if TYPE_CHECKING:
    from stochgeom.decision.planning_problem import PlanningProblem, Vector


@final
@dataclass(frozen=True)
class VarianceCost(PlanCost):
    """What the actions cost plus the variance of the final orientation on the circle.

    Parameters
    ----------
    orientations : mapping from states to Angle
        Where each state is; every state has one.
    actions : number >= 0, or mapping, default 0
        What an action costs, in the unit of the variance.

    Examples
    --------
    >>> from stochgeom.decision.planning_problem import PlanningProblem
    >>> problem = PlanningProblem.from_matrices(["1/2", "1/2"], [[[1, 0], [0, 1]]])
    >>> ends = {"0": Angle(), "1": Angle.from_degrees(90)}
    >>> VarianceCost(ends).on(problem).of_plan([]).rational
    mpq(1,2)
    """

    orientations: Mapping[Any, Angle]
    actions: Prices = 0

    def on(self, problem: PlanningProblem) -> VarianceModel:
        """Return the cost of the plans of a problem."""
        for state in self.orientations:
            problem.state_number(state, where="orientations")
        for state in problem.states:
            if not isinstance(self.orientations.get(state), Angle):
                raise CostError(
                    f"{self.orientations.get(state)!r:.60} is no orientation; accepted: an Angle",
                    where=f"orientation of state {state!r:.40}",
                )
        return VarianceModel(
            problem, self.actions, [self.orientations[state] for state in problem.states]
        )

    def describe(self) -> str:
        """Return one line for people."""
        return "cost of the actions plus variance of the final orientation on the circle"


@final
class VarianceModel(CostModel):
    """A variance cost on a problem.

    The bound is what is spent: no variance is below 0.
    """

    def __init__(
        self, problem: PlanningProblem, actions: Prices, orientations: list[Angle]
    ) -> None:
        super().__init__(problem, actions)
        self._orientations = orientations
        angle_sums = problem.numbers is NumberKind.ANGLE_SUMS
        rational = problem.numbers is NumberKind.RATIONAL
        self._enclosed = angle_sums or (rational and _cosines(orientations) is None)
        radians = np.array([angle.reduced().to_float() for angle in orientations])
        self._vectors = np.column_stack([np.cos(radians), np.sin(radians)])

    def value(self, spent: Any, hyperstate: Vector) -> Any:
        """Return spent + V."""
        if self.problem.numbers is NumberKind.FLOAT:
            mean = np.asarray(hyperstate) @ self._vectors
            return float(spent + 1.0 - mean @ mean)
        return _variance(self._orientations, list(hyperstate)) + self.floor(spent)

    def floor(self, spent: Any) -> Any:
        """Return what is spent."""
        # Enclosed numbers are added to and compared with their own kind.
        return Enclosed([], AngleSum(spent)) if self._enclosed else spent

    def bound(self, spent: Any, hyperstate: Vector, left: int | None) -> Any:
        """Return what is spent, or the cost of stopping here if nothing may follow."""
        return self.value(spent, hyperstate) if left == 0 else self.floor(spent)

    def as_cost(self, value: Any) -> Any:
        """Return a number in the form of this model's costs."""
        return self.floor(super().as_cost(value))

    def values(
        self, spent: NDArray[np.float64], hyperstates: NDArray[np.float64]
    ) -> NDArray[np.float64]:
        """Return the values of many plans at once."""
        means = hyperstates @ self._vectors
        found: NDArray[np.float64] = spent + 1.0 - (means * means).sum(axis=1)
        return found


def circular_variance(orientations: Iterable[Angle], probabilities: Iterable[Any]) -> Any:
    """Return V = 1 - R^2 of a distribution on the circle.

    Parameters
    ----------
    orientations : iterable of Angle
    probabilities : iterable of mpq or of AngleSum
        Of sum 1.

    Returns
    -------
    RootSum or Enclosed
        Exact where the probabilities are rational and the orientations differ by rational
        directions; otherwise enclosed, and equal to another if equal term by term.

    Raises
    ------
    NotStochasticError
        If a probability is negative, or their sum is not 1.
    ShapeMismatchError
        If there are not as many of them as orientations.

    Examples
    --------
    >>> opposite = [Angle(), Angle.from_degrees(180)]
    >>> circular_variance(opposite, [mpq(1, 2), mpq(1, 2)]).rational
    mpq(1,1)
    >>> circular_variance([Angle(), Angle(0, (2, 1))], [mpq(1, 2), mpq(1, 2)]).decimal(6)
    '0.052786'
    """
    angles = as_list(orientations, "a list of angles", "orientations")
    for k, angle in enumerate(angles):
        expect(angle, Angle, "an Angle", f"orientation {k}")
    return _variance(angles, _shares(probabilities, len(angles)))


def _variance(angles: list[Angle], shares: list[Any]) -> Any:
    """Return V of a distribution that is one."""
    cosines = None if any(isinstance(p, AngleSum) for p in shares) else _cosines(angles)
    if cosines is None:
        return _enclosed([(a, p) for a, p in zip(angles, shares, strict=True) if p])
    constant, terms = mpq(0), []
    for i, j in combinations(range(len(shares)), 2):
        weight = 2 * shares[i] * shares[j]
        if weight:
            coefficient, radicand = cosines[i, j]
            constant += weight
            terms.append((-weight * coefficient, radicand))
    return RootSum(constant, terms)


def _shares(probabilities: Iterable[Any], count: int) -> list[Any]:
    shares = as_list(probabilities, "a list of probabilities", "probabilities")
    if len(shares) != count:
        raise ShapeMismatchError(
            f"{len(shares)} probabilities; accepted: {count}, one for each orientation"
        )
    sums = any(isinstance(p, AngleSum) for p in shares)
    kind = NumberKind.ANGLE_SUMS if sums else NumberKind.RATIONAL
    return distribution(shares, kind, "probabilities")


def _cosines(angles: list[Angle]) -> dict[tuple[int, int], tuple[mpq, Any]] | None:
    """Return cos(theta_i - theta_j) = q root(n) for i < j, None if one is no such number."""
    found = {}
    for i, j in combinations(range(len(angles)), 2):
        cosine = _cosine(angles[i] - angles[j])
        if cosine is None:
            return None
        found[i, j] = cosine
    return found


def _cosine(angle: Angle) -> tuple[mpq, Any] | None:
    """Return q and n with cos = q root(n): of rational directions, and of multiples of 30 degrees.

    Among all angles of rational turns no others have a rational cosine (I. Niven, 1956).
    """
    x, y = angle.direction
    if angle.turn_part.denominator == 1:
        squared = x * x + y * y
        return mpq(x, squared), squared
    turns = angle.rational_turns
    if turns is None or (12 * turns).denominator != 1:
        return None
    return _OF_TWELFTHS[int(12 * turns) % 12]


_OF_TWELFTHS: Final = {
    k: (mpq(sign, 2), n)
    for n, sign, places in ((1, 1, (2, 10)), (1, -1, (4, 8)), (3, 1, (1, 11)), (3, -1, (5, 7)))
    for k in places
}


def _enclosed(possible: list[tuple[Angle, Any]]) -> Enclosed:
    """Write V over products of the angles in the probabilities and of cosines."""
    base = AngleBase([AngleSum.of(p) for _, p in possible])
    possible = [(angle, base.write(AngleSum.of(p))) for angle, p in possible]
    total = Enclosed([])
    for (theta, p), (phi, q) in combinations(possible, 2):
        apart = (theta - phi) % FULL_TURN
        apart = min(apart, FULL_TURN - apart)
        coefficient, radicand = _cosine(apart) or (mpq(0), mpz(2))
        weight = product(p, q).scaled(2)
        if is_square(radicand):
            total += weight.scaled(1 - coefficient * isqrt(radicand))
        else:
            # cos(180 - x) = -cos x: opposite orientations cancel term by term.
            obtuse = apart > QUARTER_TURN
            cosine = Cosine(HALF_TURN - apart if obtuse else apart)
            total += weight
            total += product(p, q, cosine).scaled(2 if obtuse else -2)
    return total
