"""Diagrams of pushing and squeezing on matplotlib `Axes`; needs the extra ``plot``.

Stability and squeeze-grasp diagrams (thesis Figs. 3.5 to 3.7), the density after a push (Fig. C.1),
and the bounds on the probability of a stable grasp for every friction (Eq. 3.13, App. C).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import pairwise
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from gmpy2 import mpq
from numpy.typing import NDArray

from stochgeom.errors import FrictionError
from stochgeom.exact.scalars import RationalLike, rational
from stochgeom.geometry.part import Part, as_part
from stochgeom.geometry.points import PointLike
from stochgeom.grasping.friction import FrictionLike
from stochgeom.grasping.friction_bounds import GuaranteedBound
from stochgeom.grasping.grasp_diagram import GraspDiagram
from stochgeom.grasping.push_stability import Jaw, PushStability
from stochgeom.grasping.pushing_over_friction import PushingBound
from stochgeom.grasping.squeeze_stability import SqueezeStability
from stochgeom.plotting.arguments import expect
from stochgeom.plotting.axes import axes_or_new, draw_scene, need_matplotlib
from stochgeom.plotting.curves import in_degrees
from stochgeom.plotting.function_pictures import LETTERS
from stochgeom.plotting.graph import degree_ticks
from stochgeom.plotting.scene import shown_degrees
from stochgeom.plotting.stability_scenes import grasp_diagram_scene, push_scene, squeeze_scene
from stochgeom.plotting.styles import INK, STYLES

if TYPE_CHECKING:
    from matplotlib.axes import Axes

PartLike = Part | Iterable[PointLike] | NDArray[Any]

_INCHES: Final = 1 / 80
_SAMPLES: Final = 120
_HIGHEST: Final = 4.0
"""The density after a push is infinite at a stable orientation; it is drawn up to here."""

_JUMP: Final = 1e-9
"""Where the two sides of a bound differ by less, rounding made it, and no jump is drawn."""


def draw_push_stability(
    part: PartLike | PushStability, ax: Axes | None = None, *, jaw: Jaw = Jaw.LOWER
) -> Axes:
    """Draw the push-stability diagram: how a part turns while one jaw pushes it (Fig. 3.5).

    Parameters
    ----------
    part : Part, its vertices, or its PushStability
        Its centre of mass strictly inside the hull.
    ax : Axes, optional
        Where; default: on a new figure.
    jaw : Jaw
        The jaw that pushes, unless a PushStability says it.

    Raises
    ------
    CenterOfMassError
        If the centre of mass is not strictly inside the convex hull.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> ax = draw_push_stability([(0, 0), (1, 0), (1, 1), (0, 1)], Figure().subplots())
    >>> [text.get_text() for text in ax.texts][-3:]
    ['pushed by the lower jaw', 'stable', 'unstable']
    """
    need_matplotlib()
    found = part if isinstance(part, PushStability) else PushStability(part, expect_jaw(jaw))
    return draw_scene(push_scene(found), ax, inches=_INCHES)


def expect_jaw(jaw: Jaw) -> Jaw:
    """Return a jaw as it is; anything else is refused."""
    return expect(jaw, Jaw, "Jaw.LOWER or Jaw.UPPER")


def draw_squeeze_stability(
    part: PartLike | SqueezeStability, mu: FrictionLike = 0, ax: Axes | None = None
) -> Axes:
    """Draw the squeeze-stability diagram: how a part turns between two closing jaws (Fig. 3.6).

    Parameters
    ----------
    part : Part, its vertices, or its SqueezeStability
        Any part.
    mu : rational, Angle or Friction
        The coefficient of friction or the friction angle, unless a SqueezeStability says it.
    ax : Axes, optional
        Where; default: on a new figure.

    Raises
    ------
    FrictionError, NumberError
        If mu is negative or no exact number.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    >>> ax = draw_squeeze_stability(square, "0.25", Figure().subplots())
    >>> [text.get_text() for text in ax.texts][-3:]
    ['squeezed, friction angle 14.04°', 'stable', 'wedged']
    """
    need_matplotlib()
    found = part if isinstance(part, SqueezeStability) else SqueezeStability(part, mu)
    return draw_scene(squeeze_scene(found), ax, inches=_INCHES)


def draw_grasp_diagram(
    part: PartLike | GraspDiagram, mu: FrictionLike = 0, ax: Axes | None = None
) -> Axes:
    """Draw the squeeze-grasp diagram: pushes, squeeze, and strong preimages as bars (Fig. 3.7).

    Dots at the ends of a bar belong to it, circles do not. The share of orientations that are sure
    to end stable is a certified decimal.

    Parameters
    ----------
    part : Part, its vertices, or its GraspDiagram
        Its centre of mass strictly inside the hull.
    mu : rational, Angle or Friction
        The coefficient of friction or the friction angle, unless a GraspDiagram says it.
    ax : Axes, optional
        Where; default: on a new figure.

    Raises
    ------
    CenterOfMassError
        If the centre of mass is not strictly inside the convex hull.
    FrictionError, NumberError
        If mu is negative or no exact number.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> square = [(0, 0), (1, 0), (1, 1), (0, 1)]
    >>> ax = draw_grasp_diagram(square, "0.25", Figure().subplots())
    >>> [text.get_text() for text in ax.texts if "sure" in text.get_text()]
    ['sure to end stable: 0.6881 of all initial orientations', 'sure to end at']
    """
    need_matplotlib()
    found = part if isinstance(part, GraspDiagram) else GraspDiagram(part, mu)
    return draw_scene(grasp_diagram_scene(found), ax, inches=_INCHES)


# --- the density after a push --------------------------------------------------------------------


def draw_push_density(
    part: PartLike | PushStability, ax: Axes | None = None, *, jaw: Jaw = Jaw.LOWER
) -> Axes:
    """Draw the density of the orientation at which the second jaw touches (Fig. C.1, Eq. C.4).

    Of a random initial orientation, pushed by one jaw for a uniform share of its way: ln(L / x) for
    each full turn, x from the stable orientation and L from there to the unstable one. Dashed is
    the density before the push.

    Parameters
    ----------
    part : Part, its vertices, or its PushStability
        Its centre of mass strictly inside the hull.
    ax : Axes, optional
        Where; default: on a new figure.
    jaw : Jaw
        The jaw that pushes, unless a PushStability says it.

    Raises
    ------
    CenterOfMassError
        If the centre of mass is not strictly inside the convex hull.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> ax = draw_push_density([(0, 0), (1, 0), (1, 1), (0, 1)], Figure().subplots())
    >>> [line.get_label() for line in ax.lines if line.get_label()[0] != "_"]
    ['after the push', 'before', 'stable', 'unstable']
    """
    push = part if isinstance(part, PushStability) else PushStability(part, expect_jaw(jaw))
    ax = axes_or_new(ax, (6.4, 3.2))
    look, name = STYLES["curve"], "after the push"
    for x, y in _density_curves(push):
        ax.plot(x, y, color=look.stroke, linewidth=look.width, label=name)
        name = "_"
    ax.axhline(1.0, color=STYLES["ghost"].stroke, linewidth=0.9, linestyle="--", label="before")
    for marker, word, angles in (("x", "stable", push.stable), ("D", "unstable", push.unstable)):
        places = [in_degrees(theta) for theta in angles]
        places += [360.0] if 0.0 in places else []
        ax.plot(places, [0.0] * len(places), linestyle="none", marker=marker, label=word,
                color=INK, markerfacecolor=STYLES["mass"].fill, markersize=6, clip_on=False,
                zorder=5)  # fmt: skip
    ticks = degree_ticks(360.0)
    ax.set_xticks(ticks, [shown_degrees(f"{tick:g}") for tick in ticks])
    ax.set(xlim=(0.0, 360.0), ylim=(0.0, _HIGHEST), ylabel="density for each full turn")
    ax.legend(loc="upper center", bbox_to_anchor=(0.5, 1.14), ncols=4, fontsize=LETTERS,
              frameon=False)  # fmt: skip
    return ax


def _density_curves(push: PushStability) -> Iterator[tuple[NDArray[Any], NDArray[Any]]]:
    """Yield ln(L / x) on both sides of each valley, where it is below the top; cut at 0 and 360."""
    shares = np.exp(-np.linspace(0.0, 1.2 * _HIGHEST, _SAMPLES))
    for stable, unstable, step in push.sides:
        start, end = in_degrees(stable), in_degrees(unstable)
        way = (end - start) * step % 360.0 or 360.0
        x = start + step * way * shares
        for turn in (-360.0, 0.0, 360.0):
            if x.min() + turn < 360.0 and x.max() + turn > 0.0:
                yield x + turn, -np.log(shares)


# --- bounds over the friction --------------------------------------------------------------------


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
        raise FrictionError(f"{most}; accepted: positive numbers", where="largest")
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
