"""A parts feeder that carries out a plan, on matplotlib `Axes`; needs the extra ``plot``."""

from __future__ import annotations

from typing import TYPE_CHECKING

from stochgeom.feeding.plans import FeedingPlan
from stochgeom.plotting.axes import draw_scene, need_matplotlib
from stochgeom.plotting.feeder_scenes import feeder_of, feeder_scene

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def draw_feeder(
    plan: FeedingPlan,
    ax: Axes | None = None,
    *,
    parts: int = 3,
    seed: int = 1990,
    up_to_symmetry: bool = False,
) -> Axes:
    """Draw a feeder that carries out a plan: belts, grippers, filter, seen from above (Fig. 4.2).

    Parts arrive on the left-hand belt in random orientations, one is at each action, drawn as that
    action leaves it, and one has come to the filter. On the belt below are the orientations that
    the filter refuses, the likeliest first, with their probabilities.

    Parameters
    ----------
    plan : FeedingPlan
        The plan of a part. Of more than eight actions the first four and the last three are drawn.
    ax : Axes, optional
        Where; default: on a new figure.
    parts : int
        On the arriving belt, from 1 to 12.
    seed : int
        Of the random orientations, from 0: uniform, or drawn from the plan's prior.
    up_to_symmetry : bool
        Whether the filter lets all equivalent final orientations through. If no other is left,
        there is no filter.

    Raises
    ------
    InputError
        If the plan is for a transfer function without a part, or a number is out of range.
    MissingExtraError
        If matplotlib is not installed.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> from stochgeom.feeding.planner import plan_feeding
    >>> plan = plan_feeding([(0, 0), (3, 0), (3, 2), (0, 2)])
    >>> ax = draw_feeder(plan, Figure().subplots())
    >>> [text.get_text() for text in ax.texts][-7:-4]
    ['sent around again: 0.500', 'in 1 orientation', '0.500']
    """
    need_matplotlib()
    feeder = feeder_of(plan, parts, seed, up_to_symmetry=up_to_symmetry)
    return draw_scene(feeder_scene(feeder), ax, inches=0.31)
