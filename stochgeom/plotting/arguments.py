"""What drawing functions accept, with the errors of what they do not."""

from __future__ import annotations

from typing import Final, TypeAlias

from stochgeom.exact.angles import Angle
from stochgeom.exact.scalars import RationalLike, rational

MOST_TURNS: Final = 10

Orientation: TypeAlias = "Angle | RationalLike"
"""An angle, or degrees as an exact number or text."""


def as_angle(theta: Orientation) -> Angle:
    """Return an angle as it is, or of degrees.

    Examples
    --------
    >>> as_angle("22.5").degrees(1)
    '22.5'
    """
    if isinstance(theta, Angle):
        return theta
    return Angle.from_turns(rational(theta, where="degrees") / 360)
