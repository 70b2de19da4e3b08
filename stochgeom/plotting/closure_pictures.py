"""The closure of a set that a plan collapses, on matplotlib `Axes`; needs the extra ``plot``.

Sketches for the proof of Lemma 5.1 (thesis Figs. 5.5 and 5.6), of any plan.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from stochgeom.exact.arcs import Arc
from stochgeom.feeding.closures import closure_of
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.plotting.axes import PIXEL, draw_scene, need_matplotlib
from stochgeom.plotting.closure_scenes import closure_scene
from stochgeom.plotting.monotone_scenes import monotone_step_scene

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def draw_closure(
    plan: FeedingPlan, ax: Axes | None = None, *, arcs: Sequence[Arc] | None = None
) -> Axes:
    """Draw two arcs that a plan collapses, the gap between them, and their closure (Fig. 5.5).

    Parameters
    ----------
    plan : FeedingPlan
        Any plan.
    ax : Axes, optional
        Where; default: on a new figure.
    arcs : sequence of two Arcs, optional
        Of orientations before the first action. Default: the two ends of the plan's mouth, as
        `closure_of` takes them.

    Raises
    ------
    InputError
        If the arcs touch, or the plan does not bring them to one orientation.
    MissingExtraError
        If matplotlib is not installed.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> from stochgeom.feeding.planner import plan_feeding
    >>> plan = plan_feeding([(0, 0), (3, 0), (3, 2), (0, 2)])
    >>> ax = draw_closure(plan, Figure().subplots())
    >>> [text.get_text() for text in ax.texts][-2:]
    ['2 squeezes bring Θa and Θc', 'to 180.00°, Θb as well']
    """
    need_matplotlib()
    return draw_scene(closure_scene(plan, closure_of(plan, arcs)), ax, inches=PIXEL)


def draw_monotone_step(
    plan: FeedingPlan,
    ax: Axes | None = None,
    *,
    arcs: Sequence[Arc] | None = None,
    step: int = 1,
) -> Axes:
    """Draw how one action of a plan keeps the order of two arcs and the gap between (Fig. 5.6).

    The portion of the transfer function over them, turned by the action's angle; under it the three
    before the action, on its right after it, with exact ends.

    Parameters
    ----------
    plan : FeedingPlan
        Any plan.
    ax : Axes, optional
        Where; default: on a new figure.
    arcs : sequence of two Arcs, optional
        As `draw_closure` takes them.
    step : int
        Number of the action, from 1.

    Raises
    ------
    InputError
        If the plan has no such action, or as for `draw_closure`.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> from stochgeom.feeding.planner import plan_feeding
    >>> plan = plan_feeding([(0, 0), (3, 0), (3, 2), (0, 2)])
    >>> ax = draw_monotone_step(plan, Figure().subplots())
    >>> [text.get_text() for text in ax.texts if "Θ" in text.get_text()][-3:]
    ['Θa: 90.00°', 'Θb: 180.00°', 'Θc: 180.00°']
    """
    need_matplotlib()
    scene = monotone_step_scene(plan, closure_of(plan, arcs), step)
    return draw_scene(scene, ax, inches=PIXEL)
