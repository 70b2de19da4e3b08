"""Grippers that turn inexactly: how much error plans bear.

With every action off by up to delta either way, an image of width w is turned into the next
preimage, of width h, for sure iff w + 2 delta < h. The *slack* of an action is h - w, the width of
its range: a plan bears every delta with 2 delta below its least slack, if its angles are the
middles of its ranges. Phase I for a given delta is `stochgeom.feeding.preimages.Preimages` with a
spread of 2 delta.

The largest delta is a supremum: at itself the last comparison is a tie, and fails. It is found by
jumps. No chain for a larger delta is better in any width, and the chain at hand bears every delta
below half of its least slack; so delta jumps to that value, where a stage of it stalls, and on from
there with a chain of more slack, until there is none that does what is asked for. A trial half way
to a delta known to be too large follows each jump, so the jumps are few: about log(1 / gap) for
critical values that lie a gap apart, each the cost of a chain.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from functools import total_ordering
from itertools import pairwise
from typing import Final, TypeAlias, final

from gmpy2 import mpq

from stochgeom.errors import GripperErrorError, InputError, NumberError
from stochgeom.exact.angles import HALF_TURN, ZERO, Angle
from stochgeom.exact.balls import Ball
from stochgeom.exact.decimals import (
    Rounding,
    certified_decimal,
    rational_decimal,
    significant,
)
from stochgeom.exact.directions import nominal_angle
from stochgeom.exact.scalars import RationalLike
from stochgeom.feeding.preimages import Preimage, Preimages
from stochgeom.transfer.step_function import StepFunction

GripperError: TypeAlias = "Angle | RationalLike"
"""An exact angle, or degrees as an exact number."""

_DEGREES: Final = mpq(180)  # half a slack, counted in turns, in degrees


@final
@total_ordering
@dataclass(frozen=True, slots=True)
class ErrorBound:
    """Every gripper error delta with 2 delta < slack is borne, and no other.

    Half of a rational direction is in general no rational direction, so the bound is kept doubled.

    Attributes
    ----------
    slack : Angle
        Twice the bound, which itself is not borne.

    Examples
    --------
    >>> bound = ErrorBound(Angle.from_degrees(5))
    >>> bound.degrees(2), bound.allows(Angle.from_degrees("2.4")), bound.allows(bound.slack)
    ('2.50', True, False)
    """

    slack: Angle

    def allows(self, delta: Angle) -> bool:
        """Tell whether a gripper error is borne."""
        return 2 * delta < self.slack

    def degrees(self, digits: int = 4, rounding: Rounding = Rounding.DOWN) -> str:
        """Return the bound in degrees, rounded down unless told otherwise."""
        exact = self.slack.rational_turns
        if exact is not None:
            return rational_decimal(exact * _DEGREES, digits, rounding)
        return certified_decimal(self._ball, digits, rounding)

    def decimal(self, digits: int = 4) -> str:
        """Return the bound in degrees, rounded down, with more digits than asked for before 0.

        Examples
        --------
        >>> ErrorBound(Angle(0, (10**7, 1))).decimal(), ErrorBound(Angle(0, (10**7, 1))).degrees()
        ('0.00000286', '0.0000')
        """
        return significant(self.degrees, digits) if self.slack else self.degrees(digits)

    def _ball(self) -> Ball:
        return self.slack.ball() * int(_DEGREES)

    def __lt__(self, other: ErrorBound) -> bool:
        return self.slack < other.slack

    def __str__(self) -> str:
        return f"{self.decimal()}°"


def as_gripper_error(value: GripperError) -> Angle:
    """Return a gripper error as an angle.

    Parameters
    ----------
    value : Angle, or degrees as an exact number or text
        In [0, 180) degrees.

    Raises
    ------
    GripperErrorError
        If it is negative, 180 degrees or more, or no exact number.

    Examples
    --------
    >>> as_gripper_error("0.5")
    Angle('1/720', (1, 0))
    """
    accepted = "accepted: an exact angle, or degrees as text, from 0 to less than 180 degrees"
    if not isinstance(value, Angle):
        try:
            value = Angle.from_degrees(value)
        except NumberError as error:
            raise GripperErrorError(
                f"{error.message}; {accepted}", where="gripper error"
            ) from error
    # Whatever a gripper off by half a turn either way does, it does not turn to an angle.
    if value < ZERO or value >= HALF_TURN:
        raise GripperErrorError(f"{value}; {accepted}", where="gripper error")
    return value


def least_slack(chain: Sequence[Preimage]) -> Angle | None:
    """Return the least slack of the actions after the first, None if there are none.

    Parameters
    ----------
    chain : sequence of Preimage
        Of 1, 2, ... steps.
    """
    return min((goal.width - here.image_width for goal, here in pairwise(chain)), default=None)


def most_tolerant_chain(
    transfer: StepFunction, steps: int, final_steps: Sequence[int] | None = None
) -> tuple[Preimage, ...]:
    """Return the chain of most slack whose last preimage is as wide as any of `steps` steps.

    Phase I prefers wide arcs at every stage; narrower ones on the way may leave more slack. The
    error bound of the chain is `ErrorBound` of its least slack.

    Raises
    ------
    InputError
        If so many steps do no better than fewer.

    Examples
    --------
    >>> from stochgeom.transfer.squeeze import squeeze_function
    >>> chain = most_tolerant_chain(squeeze_function([(0, 0), (3, 0), (3, 2), (0, 2)]), 2)
    >>> least_slack(chain).degrees(2)
    '22.62'
    """
    widest = Preimages(transfer, final_steps=final_steps)
    if steps < 1 or widest.of_steps(steps).steps < steps:
        longest = max(preimage.steps for preimage in widest)
        raise InputError(f"{steps} steps; accepted: 1 to {longest}")
    width = widest.of_steps(steps).width

    def good(chain: tuple[Preimage, ...]) -> bool:
        return len(chain) == steps and chain[-1].width == width

    return _jump(transfer, final_steps, lambda chain: chain.of_steps(steps), good)[0]


def largest_gripper_error(
    transfer: StepFunction, final_steps: Sequence[int] | None = None
) -> ErrorBound | None:
    """Return the least upper bound of the errors with which some plan orients up to symmetry.

    None if one action does, whose error does not matter under a uniform prior: any error is borne.

    Examples
    --------
    >>> from stochgeom.transfer.squeeze import squeeze_function
    >>> largest_gripper_error(squeeze_function([(0, 0), (3, 0), (3, 2), (0, 2)])).degrees(2)
    '11.30'
    >>> largest_gripper_error(squeeze_function([(0, 0), (1, 0), (1, 1), (0, 1)])) is None
    True
    """

    def to_the_end(chain: Preimages) -> Preimage:
        return max(chain, key=lambda preimage: preimage.steps)

    _, slack = _jump(transfer, final_steps, to_the_end, lambda chain: chain[-1].is_period)
    return None if slack is None else ErrorBound(slack)


def _jump(
    transfer: StepFunction,
    final_steps: Sequence[int] | None,
    extend: Callable[[Preimages], Preimage],
    good: Callable[[tuple[Preimage, ...]], bool],
) -> tuple[tuple[Preimage, ...], Angle | None]:
    """Return the last good chain and its least slack, raising the spread from one to the next."""

    def found(spread: Angle) -> tuple[Preimage, ...]:
        preimages = Preimages(transfer, spread, final_steps)
        extend(preimages)
        return preimages.found()

    best: tuple[Preimage, ...] = ()
    slack: Angle | None = ZERO
    most = transfer.period  # no image is narrower than nothing: so large a spread bears no action
    while slack is not None:
        chain = found(slack)
        if not good(chain):
            break
        # Every stage has more slack than the spread it was found with, so this one grows.
        best, slack = chain, least_slack(chain)
        if slack is None or slack >= most:
            continue
        # The critical values may be many; halving what is left passes by most of them.
        middle = nominal_angle(slack, most)
        chain = found(middle)
        if good(chain):
            best, slack = chain, least_slack(chain)
        else:
            most = middle
    return best, slack
