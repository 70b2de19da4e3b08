"""Monotone step maps of degree one: the transfer functions of actions.

A step function s has a period T = 2 pi / q, breaks b_0 < ... < b_{m-1} in [0, T) and values v_j
on [b_j, b_{j+1}): closed on the left. It is lifted, monotone and of degree one,
s(theta + T) = s(theta) + T. The canonical form holds one *smallest* period and no two adjacent
equal values, so equal functions have equal parts.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import cached_property
from math import gcd
from typing import final

from gmpy2 import mpq

from stochgeom.arguments import as_list
from stochgeom.display import Displayed
from stochgeom.errors import InputError, InvalidStepFunctionError
from stochgeom.exact.angles import FULL_TURN, Angle
from stochgeom.exact.arcs import Arc, ClosedArc
from stochgeom.exact.lifted import LiftedAngles
from stochgeom.exact.vectors import AngleVector
from stochgeom.transfer.canonical import canonical_steps, find_rotation, full_turn_share
from stochgeom.transfer.composition import composed_steps


@final
class StepFunction(Displayed):
    """A monotone step map of the lifted circle.

    Parameters
    ----------
    breaks : sequence of Angle
        Strictly increasing, less than one period from first to last.
    values : sequence of Angle
        values[j] is taken on [breaks[j], breaks[j + 1]); non-decreasing, rising by at most one
        period.
    period : Angle, default 360 degrees
        A period 2 pi / q; the smallest one is found.

    Attributes
    ----------
    breaks, values : AngleVector
        One smallest period, breaks in [0, period).
    period : Angle
        The smallest period T.
    lifted_breaks, lifted_values : LiftedAngles
        The breaks b_k and the values v_k for every whole k.
    order : int
        q = 2 pi / T, the symmetry order: how many orientations the map cannot tell apart.

    Raises
    ------
    InvalidStepFunctionError
        If a sequence decreases, lengths differ, an entry is no `Angle`, or the period is no whole
        share of a turn.

    Examples
    --------
    >>> half = Angle.from_degrees(180)
    >>> s = StepFunction([Angle.from_degrees(10)], [Angle.from_degrees(90)], half)
    >>> s(Angle.from_degrees(9)).degrees(0), s(Angle.from_degrees(10)).degrees(0)
    ('-90', '90')
    """

    def __init__(
        self,
        breaks: Iterable[Angle] | AngleVector,
        values: Iterable[Angle] | AngleVector,
        period: Angle = FULL_TURN,
    ) -> None:
        if not isinstance(period, Angle):
            raise _no_angle(period, "period")
        full_turn_share(period)
        self.breaks, self.values, self.period = canonical_steps(
            _as_vector(breaks, "break"), _as_vector(values, "value"), period
        )
        self.lifted_breaks = LiftedAngles(self.breaks, self.period)
        self.lifted_values = LiftedAngles(self.values, self.period)

    @property
    def order(self) -> int:
        """The symmetry order q = 2 pi / T."""
        return full_turn_share(self.period)

    def __len__(self) -> int:
        """Return m, the number of steps in one period."""
        return len(self.breaks)

    @cached_property
    def widths(self) -> tuple[Angle, ...]:
        """The widths b_{j+1} - b_j of the steps of one period."""
        breaks = self.lifted_breaks
        return tuple(breaks[j + 1] - breaks[j] for j in range(len(self)))

    # --- applying --------------------------------------------------------------------------------

    def __call__(self, theta: Angle) -> Angle:
        """Return s(theta), lifted.  O(log m)."""
        return self.lifted_values[self.step_at(theta)]

    def step_at(self, theta: Angle) -> int:
        """Return k with b_k <= theta < b_{k+1}, for the breaks lifted to all whole k."""
        return self.lifted_breaks.position(theta)

    def image(self, arc: Arc) -> ClosedArc:
        """Return the closed arc that the image of a half-open arc spans; both ends are taken.

        Examples
        --------
        >>> s = StepFunction([Angle()], [Angle()], Angle.from_degrees(90))
        >>> image = s.image(Arc(Angle.from_degrees(45), Angle.from_degrees(90)))
        >>> image.start.degrees(0), image.end.degrees(0)
        ('0', '90')
        """
        first = self.lifted_values[self.step_at(arc.start)]
        return ClosedArc(first, self.lifted_values[self.step_before(arc.end)] - first)

    def step_before(self, theta: Angle) -> int:
        """Return the last k with b_k < theta: the step in force just before theta."""
        k = self.step_at(theta)
        return k - 1 if self.lifted_breaks[k] == theta else k

    def preimage(self, arc: Arc) -> Arc | None:
        """Return the orientations that s maps into a half-open lifted arc, None if there are none.

        The lifted arc counts, not its shadow on the circle.

        Examples
        --------
        >>> s = StepFunction([Angle()], [Angle.from_degrees(45)], Angle.from_degrees(90))
        >>> arc = s.preimage(Arc(Angle.from_degrees(40), Angle.from_degrees(10)))
        >>> arc.start.degrees(0), arc.width.degrees(0)
        ('0', '90')
        """
        first, after = self._first_value_from(arc.start), self._first_value_from(arc.end)
        if first == after:
            return None
        breaks = self.lifted_breaks
        return Arc(breaks[first], breaks[after] - breaks[first])

    def _first_value_from(self, theta: Angle) -> int:
        """Return the smallest k with v_k >= theta."""
        periods, rest = divmod(theta - self.values[0], self.period)
        target = self.values[0] + rest
        low, high = 0, len(self)
        while low < high:
            middle = (low + high) // 2
            if self.values[middle] < target:
                low = middle + 1
            else:
                high = middle
        return periods * len(self) + low

    # --- new functions from old ------------------------------------------------------------------

    def compose(self, inner: StepFunction) -> StepFunction:
        """Return the map theta -> self(inner(theta)).  O(m log m').

        Its period is at most the smallest that both maps share, its steps begin at breaks of
        `inner`. A value of `inner` that is a break of this map goes to the step on its right.

        Examples
        --------
        >>> s = StepFunction([Angle()], [Angle.from_degrees(45)], Angle.from_degrees(90))
        >>> s.compose(s) == s
        True
        """
        order = gcd(self.order, inner.order)
        breaks, values = composed_steps(
            (self.lifted_breaks, self.lifted_values),
            (inner.lifted_breaks, inner.lifted_values),
            copies=inner.order // order,
            rise=len(self) * (self.order // order),
        )
        return StepFunction(breaks, values, Angle.from_turns(mpq(1, order)))

    def power(self, exponent: int) -> StepFunction:
        """Return the map applied `exponent` >= 1 times.

        Raises
        ------
        InputError
            If `exponent` is below 1: the identity is no step function.
        """
        if exponent < 1:
            raise InputError(f"exponent {exponent}; accepted: whole numbers from 1 on")
        result = self
        for _ in range(exponent - 1):
            result = self.compose(result)
        return result

    def after_turning(self, alpha: Angle) -> StepFunction:
        """Return the map of an action at angle alpha, theta -> s(theta - alpha) (Eq. 4.1)."""
        return StepFunction(self.breaks.rotate(alpha), self.values, self.period)

    def rotate(self, angle: Angle) -> StepFunction:
        """Return the transfer function of the part turned by -angle in its own frame.

        That is theta -> s(theta - angle) + angle: the graph moved along the diagonal.
        """
        return StepFunction(self.breaks.rotate(angle), self.values.rotate(angle), self.period)

    # --- comparison ------------------------------------------------------------------------------

    def rotation_to(self, other: StepFunction) -> Angle | None:
        """Return the smallest angle >= 0 with ``self.rotate(angle) == other``, or None.  O(m)."""
        if self.period != other.period or len(self) != len(other):
            return None
        shift = find_rotation(self._gaps(), other._gaps())
        if shift is None:
            return None
        return (other.breaks[0] - self.lifted_breaks[shift]) % self.period

    def equals_up_to_rotation(self, other: StepFunction) -> bool:
        """Tell whether a rotation carries one function to the other."""
        return self.rotation_to(other) is not None

    def _gaps(self) -> list[tuple[Angle, Angle]]:
        """Return the cyclic word that rotations leave alone: widths, and values from breaks."""
        offsets = (v - b for v, b in zip(self.values, self.breaks, strict=True))
        return list(zip(self.widths, offsets, strict=True))

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, StepFunction):
            return NotImplemented
        return (
            self.period == other.period
            and self.breaks.angles == other.breaks.angles
            and self.values.angles == other.values.angles
        )

    def __hash__(self) -> int:
        return hash((self.period, self.breaks.angles, self.values.angles))

    def __repr__(self) -> str:
        if len(self) > 100:
            return f"<StepFunction of {len(self)} steps in a period of {self.period}>"
        return f"StepFunction({list(self.breaks)!r}, {list(self.values)!r}, {self.period!r})"


def _as_vector(angles: Iterable[Angle] | AngleVector, what: str) -> AngleVector:
    if isinstance(angles, AngleVector):
        return angles
    listed = as_list(angles, "a list of angles", f"{what}s", InvalidStepFunctionError)
    for k, angle in enumerate(listed):
        if not isinstance(angle, Angle):
            raise _no_angle(angle, f"{what} {k}")
    return AngleVector.from_angles(listed)


def _no_angle(value: object, where: str) -> InvalidStepFunctionError:
    return InvalidStepFunctionError(
        f"{value!r:.60} is no Angle; accepted: exact angles, such as Angle.from_degrees('71')",
        where=where,
    )
