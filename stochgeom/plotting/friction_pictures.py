"""The bounds on the probability of a stable grasp for every friction (thesis Eq. 3.13, App. C).

Needs the extra ``plot``.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from gmpy2 import mpq
from numpy.typing import NDArray

from stochgeom.errors import FrictionError
from stochgeom.exact.scalars import RationalLike, rational, rational_text
from stochgeom.geometry.part import PartLike, as_part
from stochgeom.grasping.friction_bounds import GuaranteedBound
from stochgeom.grasping.pushing_over_friction import PushingBound
from stochgeom.plotting.arguments import as_drawn
from stochgeom.plotting.axes import axes_or_new
from stochgeom.plotting.function_pictures import LETTERS
from stochgeom.plotting.styles import INK, STYLES

if TYPE_CHECKING:
    from matplotlib.axes import Axes


_SAMPLES: Final = 120
_JUMP: Final = 1e-9
"""Where the two sides of a bound differ by less, rounding made it, and no jump is drawn."""


def draw_friction_bounds(
    part: PartLike, ax: Axes | None = None, *, largest: RationalLike = 1
) -> Axes:
    """Draw both lower bounds on the probability of a stable grasp, for every friction.

    What is sure whatever the push (Eq. 3.13), which jumps where a pair of vertices begins to wedge:
    the dot is the value there, the circle the limit from the right; and the tighter bound of the
    uniform pushing model (App. C), dashed, which is continuous.

    Parameters
    ----------
    part : Part, or its vertices
        Its centre of mass strictly inside the hull.
    ax : Axes, optional
        Where; default: on a new figure.
    largest : positive rational
        The coefficients of friction run from 0 to this one.

    Raises
    ------
    CenterOfMassError
        If the centre of mass is not strictly inside the convex hull.
    FrictionError, NumberError
        If the largest coefficient is not positive or no exact number.
    NumberLimitError
        If floats do not hold it.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    >>> ax = draw_friction_bounds(square, Figure().subplots(), largest="1/2")
    >>> bool(abs(ax.lines[1].get_ydata()[-1] - 0.4097) < 1e-4)
    True
    """
    most = rational(largest, where="largest")
    if most <= 0:
        raise FrictionError(f"{rational_text(most)}; accepted: positive numbers", where="largest")
    as_drawn(most, "largest")
    ax = axes_or_new(ax, (5.6, 3.6))
    part = as_part(part)
    look, name = STYLES["curve"], "sure, whatever the push"
    before = None
    for x, y in _guaranteed_pieces(GuaranteedBound(part), most):
        ax.plot(x, y, color=look.stroke, linewidth=look.width, label=name)
        if before is not None and abs(before - y[0]) > _JUMP:
            _mark_jump(ax, x[0], before, y[0])
        name, before = "_", y[-1]
    pushing = PushingBound(part)
    grid = [most * k / _SAMPLES for k in range(_SAMPLES + 1)]
    values = [float(pushing(mu)) for mu in grid]
    ax.plot([float(mu) for mu in grid], values, color=INK, linewidth=1.2, linestyle="--",
            label="if every length of the push is as likely")  # fmt: skip
    ax.set(xlim=(0.0, float(most)), ylim=(0.0, 1.02), xlabel="coefficient of friction μ",
           ylabel="probability of a stable grasp, at least")  # fmt: skip
    ax.legend(loc="best", fontsize=LETTERS)
    return ax


def _guaranteed_pieces(
    bound: GuaranteedBound, most: mpq
) -> Iterator[tuple[NDArray[Any], NDArray[Any]]]:
    """Yield mu and the bound from breakpoint to breakpoint: linear in the friction angle.

    The first piece is the point at mu = 0. Two exact values inside a piece give its line; pieces
    that floats cannot tell from a point are left out.
    """
    yield np.zeros(1), np.ones(1)
    starts = [
        0.0,
        *(np.pi * float(half.doubled.ball().mid()) for half in bound.breakpoints),
    ]
    last = float(np.arctan(float(most)))
    ends = [*(start for start in starts if start < last), last]
    for low, high in pairwise(ends):
        inside = [mpq(float(np.tan(low + (high - low) * share))) for share in (1 / 3, 2 / 3)]
        first, second = (float(np.arctan(float(mu))) for mu in inside)
        if not low < first < second < high:
            continue
        value, other = (float(bound(mu)) for mu in inside)
        alpha = np.linspace(low, high, max(2, round(_SAMPLES * (high - low) / last)))
        yield np.tan(alpha), value + (other - value) * (alpha - first) / (second - first)


def _mark_jump(ax: Axes, x: float, value: float, limit: float) -> None:
    jump, dot, ring = STYLES["jump"], STYLES["closed"], STYLES["hollow"]
    ax.plot([x, x], [value, limit], color=jump.stroke, linewidth=0.8, linestyle=":")
    for y, style in ((value, dot), (limit, ring)):
        ax.plot([x], [y], marker="o", markersize=4, markerfacecolor=style.fill, clip_on=False,
                markeredgecolor=style.stroke, zorder=4)  # fmt: skip
