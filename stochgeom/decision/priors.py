"""Priors: what is known of a part's orientation before the first action (thesis App. F).

A plan of phase I is a funnel with a mouth of width h. With F the distribution of the initial
orientation and f its density, the plan succeeds with probability

    p(theta) = F(theta + h) - F(theta)                                      (Eq. F.2)

when its mouth is [theta, theta + h). The largest is p*, attained at theta* (Eq. F.3). Where f is
continuous, dp/dtheta = f(theta + h) - f(theta) (Eq. F.4 has the opposite sign), so that both ends
of the best mouth have the same density (Eq. F.5). On a circle that has never one solution only:
the worst mouth solves it too.

A `Prior` answers two questions: `mass(arc)`, and `best_window(width)`. Angles are counted in full
turns here: densities are per turn, and the uniform one is 1.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, final

from gmpy2 import mpq, mpz

from stochgeom.arguments import as_list
from stochgeom.errors import InvalidArcError, NumberError, PriorError
from stochgeom.exact.angles import FULL_TURN, ZERO, Angle, make_angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.cells import CellSet
from stochgeom.exact.scalars import RationalLike, rational
from stochgeom.exact.sums import AngleSum, Probability


@final
@dataclass(frozen=True)
class Window:
    """Where a mouth stands, and what it catches.

    Attributes
    ----------
    start : Angle
        In [0, 360) degrees.
    mass : Probability
        The probability of [start, start + width), placed exactly there.
    exact : bool
        Whether no other start catches more: proven.
    at_most : Probability or None
        If not, a bound on what any start catches, where one is known.
    """

    start: Angle
    mass: Probability
    exact: bool
    at_most: Probability | None = None


class Prior(ABC):
    """A probability distribution of the initial orientation, on the circle.

    Examples
    --------
    >>> prior = uniform_prior()
    >>> window = prior.best_window(Angle.from_degrees(90))
    >>> window.start.degrees(0), window.mass.rational
    ('0', mpq(1,4))
    """

    @property
    @abstractmethod
    def kind(self) -> str:
        """The name of the family: ``"uniform"``, ``"discrete"`` and so on."""

    @abstractmethod
    def describe(self) -> str:
        """Return one line for people."""

    @abstractmethod
    def mass(self, arc: Arc) -> Probability:
        """Return the probability of a half-open arc of the circle."""

    @abstractmethod
    def best_window(self, width: Angle) -> Window:
        """Return the start whose window of that width has the largest mass.

        Parameters
        ----------
        width : Angle
            More than 0 and at most 360 degrees.

        Returns
        -------
        Window
            Among equals the one of the smallest start, of those that were compared; 0 always is.

        Raises
        ------
        InvalidArcError
            For any other width.
        """

    def mass_at(self, theta: Angle) -> mpq:  # noqa: ARG002 - most priors have no points
        """Return the probability of a single orientation: 0, but for priors with points."""
        return mpq(0)

    def mass_of(self, cells: CellSet) -> Probability:
        """Return the probability of a set of orientations, its ends and points counted exactly.

        Examples
        --------
        >>> from stochgeom.exact.intervals import Interval
        >>> half = CellSet.of([Interval(ZERO, Angle.from_degrees(180), False, True)])
        >>> uniform_prior().mass_of(half).rational
        mpq(1,2)
        """
        total: Any = AngleSum()
        for item in cells.intervals():
            if item.width == FULL_TURN and item.is_closed:
                return AngleSum(1)
            extra = self.mass_at(item.end) if item.includes_end else mpq(0)
            if item.width:  # an arc holds its start and not its end
                total = total + self.mass(Arc(item.start, item.width))
                extra -= 0 if item.includes_start else self.mass_at(item.start)
            total = total + AngleSum(extra)
        result: Probability = total
        return result


@final
class UniformPrior(Prior):
    """Every orientation is equally likely: what a random turn of the gripper makes true."""

    kind = "uniform"

    def describe(self) -> str:
        """Return one line for people."""
        return "uniform"

    def mass(self, arc: Arc) -> AngleSum:
        """Return width / 360 degrees."""
        return AngleSum(0, [(1, arc.width)])

    def best_window(self, width: Angle) -> Window:
        """Return the window that starts at 0: all are equally good."""
        return Window(ZERO, self.mass(Arc(ZERO, width)), exact=True)

    def __repr__(self) -> str:
        return "uniform_prior()"

    def __eq__(self, other: object) -> bool:
        return True if isinstance(other, UniformPrior) else NotImplemented

    def __hash__(self) -> int:
        return hash(UniformPrior)


def uniform_prior() -> UniformPrior:
    """Return the prior under which every orientation is equally likely (thesis 4.9.1).

    Examples
    --------
    >>> uniform_prior().mass(Arc(ZERO, Angle(0, (3, 2)))).decimal()
    '0.0936'
    """
    return UniformPrior()


# --- what all makers share -----------------------------------------------------------------------


def as_orientation(value: Angle | RationalLike, *, where: str) -> Angle:
    """Return an angle, given as such or in degrees, modulo a full turn.

    Examples
    --------
    >>> as_orientation("-90", where="mean").degrees(0)
    '270'
    """
    if isinstance(value, Angle):
        turns = value.rational_turns
        if turns is None:
            return value.reduced()
    else:
        turns = rational(value, where=where) / 360
    # Rational turns are reduced as rational numbers: ten times faster.
    return make_angle(turns - turns.numerator // turns.denominator, mpz(1), mpz(0))


def check_width(width: Angle) -> Angle:
    """Return a window's width if it is one: more than 0 and at most 360 degrees."""
    if not ZERO < width <= FULL_TURN:
        raise InvalidArcError(f"window width {width}; accepted: more than 0, at most 360°")
    return width


def as_pairs(items: object, *, what: str, accepted: str) -> list[tuple[Any, Any]]:
    """Return the pairs of a mapping, or of an iterable of pairs.

    Parameters
    ----------
    what : str
        What a pair is called, such as ``"point"``.
    accepted : str
        What the two are, for messages.

    Raises
    ------
    PriorError
        If it is no such thing, or an entry is no pair.

    Examples
    --------
    >>> as_pairs({"10": 1}, what="point", accepted="an orientation and a weight")
    [('10', 1)]
    """
    entries = items.items() if isinstance(items, Mapping) else items
    if isinstance(entries, str) or not isinstance(entries, Iterable):
        raise PriorError(f"{items!r:.60}; accepted: pairs, each {accepted}", where=f"{what}s")
    pairs: list[tuple[Any, Any]] = []
    for k, entry in enumerate(entries):
        pair = () if isinstance(entry, str) or not isinstance(entry, Iterable) else tuple(entry)
        if len(pair) != 2:
            raise PriorError(f"{entry!r:.60}; accepted: {accepted}", where=f"{what} {k}")
        pairs.append(pair)
    return pairs


def as_share(value: RationalLike, *, where: str, what: str = "weight") -> mpq:
    """Return a weight or a density: a rational number, not negative."""
    try:
        number = rational(value, where=where)
    except NumberError as error:
        raise type(error)(f"{error.message}; a {what} is 0 or more", where=where) from error
    if number < 0:
        raise PriorError(f"{what} {number} is negative; accepted: 0 or more", where=where)
    return number


def normalise(counts: Sequence[RationalLike], *, what: str = "count") -> list[mpq]:
    """Return counts divided by their sum.

    Raises
    ------
    PriorError
        If there are none, or one is negative, or all are 0.

    Examples
    --------
    >>> normalise([1, 3])
    [mpq(1,4), mpq(3,4)]
    """
    listed = as_list(counts, f"a list of {what}s", f"{what}s", PriorError)
    numbers = [as_share(n, where=f"{what} {k}", what=what) for k, n in enumerate(listed)]
    total = sum(numbers, start=mpq(0))
    if total == 0:
        raise PriorError(f"{len(numbers)} {what}s with sum 0; accepted: a positive sum")
    return [number / total for number in numbers]
