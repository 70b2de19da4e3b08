"""Pictures of parts, grippers and plans on matplotlib `Axes`; needs the extra ``plot``.

Every function takes the axes to draw on, makes a figure of its own without them, and returns the
axes. What a caption claims (stable, cancelled, a probability) is decided exactly.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from stochgeom.arguments import as_list
from stochgeom.feeding.gripper_error import GripperError
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.geometry.part import PartLike, as_part
from stochgeom.plotting.arguments import Orientation, as_angle
from stochgeom.plotting.axes import PIXEL, draw_scene, need_matplotlib
from stochgeom.plotting.funnel_scenes import funnel_scene
from stochgeom.plotting.grasp_scenes import error_scene, grasp_scene, stable_scene
from stochgeom.plotting.gripper_scenes import (
    closing_scene,
    gripper_scene,
    wedged_or_stable_scene,
)
from stochgeom.plotting.part_scenes import part_scene
from stochgeom.plotting.trace_scenes import trace_scene

if TYPE_CHECKING:
    from matplotlib.axes import Axes

    from stochgeom.decision.priors import Prior


def draw_part(part: PartLike, ax: Axes | None = None, *, hull: bool = True) -> Axes:
    """Draw a part: outline, holes, convex hull (dashed), centre of mass, a dot on vertex 0.

    Parameters
    ----------
    part : Part, or its vertices
        Any part.
    ax : Axes, optional
        Where; default: on a new figure.
    hull : bool
        Whether the hull is drawn where it differs from the outline.

    Raises
    ------
    MissingExtraError
        If matplotlib is not installed.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> ax = draw_part([(0, 0), (3, 0), (1, 1), (0, 3)], Figure().subplots())
    >>> len(ax.patches)
    4
    """
    need_matplotlib()
    return draw_scene(part_scene(as_part(part), hull=hull), ax, inches=1.2)


def draw_grasp(
    part: PartLike, theta: Orientation, ax: Axes | None = None, *, pushing: bool = False
) -> Axes:
    """Draw a part between closed jaws at an orientation, its contacts, and what holds of them.

    The caption says ``stable``, ``flush, not stable`` or ``wedged``, exactly (thesis Figs. 3.1 and
    3.4, Defs. 3.3 and 3.4).

    Parameters
    ----------
    part : Part, or its vertices
        Any part.
    theta : Angle, or degrees as an exact number or text
        The orientation relative to the gripper.
    ax : Axes, optional
        Where; default: on a new figure.
    pushing : bool
        Whether the lower jaw is drawn dark, as the one that pushes.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> ax = draw_grasp([(0, 0), (3, 0), (3, 2), (0, 2)], 90, Figure().subplots())
    >>> ax.texts[-1].get_text()
    '90.00°: stable'
    """
    need_matplotlib()
    return draw_scene(grasp_scene(as_part(part), as_angle(theta), pushing=pushing), ax, inches=1.0)


def draw_stable_grasps(part: PartLike, ax: Axes | None = None, *, most: int = 12) -> Axes:
    """Draw the stable grasps by their stability, the best in heavy letters (thesis Fig. D.2).

    Parameters
    ----------
    part : Part, or its vertices
        Any part.
    ax : Axes, optional
        Where; default: on a new figure.
    most : int
        So many are drawn at most: the most stable ones.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> ax = draw_stable_grasps([(0, 0), (3, 0), (3, 2), (0, 2)], Figure().subplots())
    >>> [text.get_text() for text in ax.texts]
    ['at 90.00°', 'Ψ = 33.69°', 'at 0.00°', 'Ψ = 56.31°']
    """
    need_matplotlib()
    return draw_scene(stable_scene(as_part(part), most), ax, inches=0.6)


def draw_uncertain_grasp(
    part: PartLike, theta: Orientation, error: GripperError, ax: Axes | None = None
) -> Axes:
    """Draw whether a squeeze cancels an error of the orientation (thesis Figs. 3.2 and 3.3).

    Parameters
    ----------
    part : Part, or its vertices
        Any part.
    theta : Angle, or degrees as an exact number or text
        The orientation relative to the gripper, as far as it is known.
    error : Angle, or degrees as text
        The true orientation is within so much of it, either way.
    ax : Axes, optional
        Where; default: on a new figure.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> rectangle = [(0, 0), (3, 0), (3, 2), (0, 2)]
    >>> ax = draw_uncertain_grasp(rectangle, 20, "15", Figure().subplots())
    >>> ax.texts[-1].get_text()
    'the error is cancelled'
    """
    need_matplotlib()
    return draw_scene(error_scene(as_part(part), as_angle(theta), error), ax, inches=0.6)


def draw_gripper(ax: Axes | None = None, *, sliding: bool = False) -> Axes:
    """Draw an empty gripper, with its sliding plate or without (thesis Figs. B.1 and B.3).

    Parameters
    ----------
    ax : Axes, optional
        Where; default: on a new figure.
    sliding : bool
        Whether the upper jaw carries a plate on rollers.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> ax = draw_gripper(Figure().subplots(), sliding=True)
    >>> [text.get_text() for text in ax.texts]
    ['parallel-jaw gripper', 'plate on rollers']
    """
    need_matplotlib()
    return draw_scene(gripper_scene(sliding=sliding), ax, inches=0.9)


def draw_closing(part: PartLike, theta: Orientation, ax: Axes | None = None) -> Axes:
    """Draw three moments of grasping a part with the sliding jaw (thesis Fig. B.4).

    Parameters
    ----------
    part : Part, or its vertices
        Any part.
    theta : Angle, or degrees as an exact number or text
        The orientation in which both jaws touch first.
    ax : Axes, optional
        Where; default: on a new figure.

    Notes
    -----
    A schematic: the part rolls on the fixed jaw without slipping and takes the plate along.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> from stochgeom.geometry.part import Part
    >>> ax = draw_closing(Part.regular(6), 15, Figure().subplots())
    >>> ax.texts[-1].get_text()
    '3: stable, 0.00°'
    """
    need_matplotlib()
    return draw_scene(closing_scene(as_part(part), as_angle(theta)), ax, inches=0.7)


def draw_sliding_jaw(part: PartLike, theta: Orientation, ax: Axes | None = None) -> Axes:
    """Draw one grasp without and with the sliding jaw: held by friction, or stable (Fig. B.2).

    The caption says which coefficient of friction holds the part, rounded up.

    Parameters
    ----------
    part : Part, or its vertices
        Any part.
    theta : Angle, or degrees as an exact number or text
        The orientation in which both jaws touch first.
    ax : Axes, optional
        Where; default: on a new figure.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> from stochgeom.geometry.part import Part
    >>> ax = draw_sliding_jaw(Part.regular(6), 20, Figure().subplots())
    >>> [text.get_text() for text in ax.texts]
    ['friction: wedged at 20.00° if μ > 0.1764', 'sliding jaw: stable at 0.00°']
    """
    need_matplotlib()
    return draw_scene(wedged_or_stable_scene(as_part(part), as_angle(theta)), ax, inches=0.8)


def draw_trace(
    plan: FeedingPlan,
    ax: Axes | None = None,
    *,
    orientations: Sequence[Orientation] | None = None,
    distribution: bool = True,
) -> Axes:
    """Draw a plan at work: part and gripper after each action (thesis Figs. 1.1, 4.5, 4.6, E.5).

    As a camera above the gripper sees it. A stub marks the jaw that is the lower one while the
    gripper stands at 0 degrees; angles under the columns are relative to the gripper.

    Parameters
    ----------
    plan : FeedingPlan
        The plan of a part.
    ax : Axes, optional
        Where; default: on a new figure.
    orientations : sequence, optional
        Angles, or degrees: the orientations before the first action, a column for each. Default:
        one in every step of the transfer function, at most eight. Under a prior only what
        arrives: its points, or the middles of five equal shares of it.
    distribution : bool
        Whether the probability of each orientation is drawn beside each action.

    Raises
    ------
    InputError
        If the plan is for a transfer function without a part.
    MissingExtraError
        If matplotlib is not installed.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> from stochgeom.feeding.planner import plan_feeding
    >>> plan = plan_feeding([(0, 0), (3, 0), (3, 2), (0, 2)])
    >>> ax = draw_trace(plan, Figure().subplots(), orientations=[10, 100])
    >>> [text.get_text() for text in ax.texts][:4]
    ['10.0°', '0.0°', '100.0°', '180.0°']
    """
    need_matplotlib()
    chosen = None
    if orientations is not None:
        listed = as_list(orientations, "a list of angles, or of degrees", "orientations")
        chosen = [as_angle(theta) for theta in listed]
    return draw_scene(trace_scene(plan, chosen, distribution=distribution), ax, inches=0.31)


def draw_funnel(plan: FeedingPlan, ax: Axes | None = None, *, prior: Prior | None = None) -> Axes:
    """Draw a plan as a funnel of preimages and images (thesis Fig. 5.7).

    Under a prior its density stands above, over arcs of 3 degrees, what the mouth catches shaded
    (Fig. F.1). Angles are those of the part as a camera sees it.

    Parameters
    ----------
    plan : FeedingPlan
        Any plan.
    ax : Axes, optional
        Where; default: on a new figure.
    prior : Prior, optional
        Default: that of the plan; without any the funnel stands alone.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> from stochgeom.feeding.planner import plan_feeding
    >>> ax = draw_funnel(plan_feeding([(0, 0), (3, 0), (3, 2), (0, 2)]), Figure().subplots())
    >>> [text.get_text() for text in ax.texts if "to go" in text.get_text()]
    ['2 actions to go', '1 action to go']
    """
    need_matplotlib()
    return draw_scene(funnel_scene(plan, prior), ax, inches=PIXEL)
