"""Diagrams of pushing and squeezing on matplotlib `Axes`; needs the extra ``plot``.

Stability and squeeze-grasp diagrams (thesis Figs. 3.5 to 3.7), the density after a push (Fig. C.1).
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from numpy.typing import NDArray

from stochgeom.arguments import expect
from stochgeom.geometry.part import PartLike
from stochgeom.grasping.friction import FrictionLike
from stochgeom.grasping.grasp_diagram import GraspDiagram
from stochgeom.grasping.push_stability import Jaw, PushStability
from stochgeom.grasping.squeeze_stability import SqueezeStability
from stochgeom.plotting.axes import PIXEL, axes_or_new, draw_scene, need_matplotlib
from stochgeom.plotting.curves import in_degrees
from stochgeom.plotting.function_pictures import LETTERS
from stochgeom.plotting.graph import degree_ticks
from stochgeom.plotting.scene import shown_degrees
from stochgeom.plotting.stability_scenes import grasp_diagram_scene, push_scene, squeeze_scene
from stochgeom.plotting.styles import INK, STYLES

if TYPE_CHECKING:
    from matplotlib.axes import Axes


_SAMPLES: Final = 120
_HIGHEST: Final = 4.0
"""The density after a push is infinite at a stable orientation; it is drawn up to here."""


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
    return draw_scene(push_scene(found), ax, inches=PIXEL)


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
    return draw_scene(squeeze_scene(found), ax, inches=PIXEL)


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
    return draw_scene(grasp_diagram_scene(found), ax, inches=PIXEL)


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
