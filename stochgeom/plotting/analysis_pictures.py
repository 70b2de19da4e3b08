"""Several graphs of one part above each other, and how phase I chooses a preimage.

Needs the extra ``plot``.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from stochgeom.arguments import expect
from stochgeom.errors import InputError
from stochgeom.feeding.preimages import Preimage, preimages
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.geometry.part import PartLike, as_part
from stochgeom.plotting.axes import axes_or_new, draw_scene, need_matplotlib
from stochgeom.plotting.curves import bars_of, in_degrees, turns_for
from stochgeom.plotting.function_pictures import (
    draw_diameter,
    draw_preimages,
    draw_radius,
    draw_step_function,
    write_width,
)
from stochgeom.plotting.part_scenes import part_scene
from stochgeom.plotting.styles import INK, STYLES
from stochgeom.transfer.push import push_function
from stochgeom.transfer.squeeze import squeeze_function
from stochgeom.transfer.step_function import StepFunction

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def draw_analysis(problem: FeedingProblem, axes: Sequence[Axes] | None = None) -> tuple[Axes, ...]:
    """Draw the diameter function, the transfer function under it, and the preimages as bars.

    Thesis Figs. 5.9 to 5.11; for push-grasps the radius function stands on top (Fig. E.4), for a
    transfer function without a part nothing.

    Parameters
    ----------
    problem : FeedingProblem
        A part and an action.
    axes : sequence of Axes, optional
        Three, or two without a part, from top to bottom; default: those of a new figure.

    Returns
    -------
    tuple of Axes

    Raises
    ------
    InputError
        If there are too few or too many axes.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> problem = FeedingProblem([(0, 0), (3, 0), (3, 2), (0, 2)])
    >>> wave, steps, bars = draw_analysis(problem, Figure().subplots(3))
    >>> len(bars.patches)
    2
    """
    need_matplotlib()
    problem = expect(problem, FeedingProblem, "a problem, such as FeedingProblem(part)")
    chain = list(problem.preimages)
    bars = bars_of(chain)
    turns, count = turns_for(bars), 2 if problem.part is None else 3
    chosen = _stacked(count, len(bars)) if axes is None else tuple(axes)
    if len(chosen) != count:
        raise InputError(f"{len(chosen)} axes; accepted: {count}, from top to bottom")
    if problem.part is not None:
        draw = draw_radius if problem.action == "push-grasp" else draw_diameter
        draw(problem.part, chosen[0], turns=turns)
    draw_step_function(problem.transfer, chosen[-2], turns=turns, name=problem.action)
    draw_preimages(chain, chosen[-1])
    return chosen


def _stacked(count: int, bars: int) -> tuple[Axes, ...]:
    import matplotlib.pyplot as plt

    heights = [2.0, 3.6, min(0.7 + 0.24 * bars, 5.0)][3 - count :]
    figure, axes = plt.subplots(
        count,
        figsize=(6.4, sum(heights) + 0.4),
        layout="constrained",
        gridspec_kw={"height_ratios": heights},
    )
    figure.align_ylabels(axes)
    return tuple(axes)


def draw_push_grasp_analysis(
    part: PartLike, axes: Sequence[Axes] | None = None
) -> tuple[Axes, ...]:
    """Draw what a push-grasp is made of (thesis Figs. E.3 and E.6).

    Parameters
    ----------
    part : Part, or its vertices
        Its centre of mass strictly inside the hull.
    axes : sequence of six Axes, optional
        For the radius function, the push function, the diameter function, the squeeze function,
        the part, and the push-grasp function; default: those of a new figure.

    Raises
    ------
    InputError
        If there are not six axes.
    CenterOfMassError
        If the centre of mass is not strictly inside the convex hull.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> axes = Figure().subplots(2, 3).ravel().tolist()
    >>> [ax.get_ylabel() for ax in draw_push_grasp_analysis([(0, 0), (4, 0), (0, 3)], axes)]
    ['radius', 'push', 'diameter', 'squeeze', '', 'push-grasp']
    """
    need_matplotlib()
    part = as_part(part)
    problem = FeedingProblem(part, "push-grasp")
    names = ("radius", "push", "diameter", "squeeze", "part", "push-grasp")
    if axes is None:
        import matplotlib.pyplot as plt

        figure = plt.figure(figsize=(9.6, 8.0), layout="constrained")
        found = figure.subplot_mosaic(
            "RPD;rPd;GGG", width_ratios=[4, 2, 4], height_ratios=[2, 3, 3.4]
        )
        axes = [found[place] for place in "RrDdPG"]
    if len(axes) != len(names):
        raise InputError(f"{len(axes)} axes; accepted: 6, for {', '.join(names)}")
    radius, push, diameter, squeeze, picture, whole = axes
    draw_radius(part, radius)
    draw_step_function(push_function(part), push, name="push")
    draw_diameter(part, diameter)
    draw_step_function(squeeze_function(part), squeeze, name="squeeze")
    draw_scene(part_scene(part), picture)
    draw_step_function(problem.transfer, whole, turns=2, name="push-grasp")
    return tuple(axes)


def draw_phase_one(transfer: StepFunction, steps: int, ax: Axes | None = None) -> Axes:
    """Draw how phase I chooses the preimage of some steps (thesis Figs. 5.3 and 5.4).

    A square as high as the last preimage is wide is put with its lower left corner at the start of
    every step. Where the function leaves it on the right, the image is narrower than the last
    preimage; the square of the widest arc is drawn heavily, and the arc as a bar at the bottom. At
    the first stage there is no square: the widest step is drawn, with a dot at its value.

    Parameters
    ----------
    transfer : StepFunction
        Any monotone step map.
    steps : int
        i, from 1 to the number of preimages.
    ax : Axes, optional
        Where; default: on a new figure.

    Raises
    ------
    InputError
        If there is no preimage of so many steps.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> transfer = squeeze_function([(0, 0), (3, 0), (3, 2), (0, 2)])
    >>> ax = draw_phase_one(transfer, 2, Figure().subplots())
    >>> [text.get_text() for text in ax.texts]
    ['180.00°']
    """
    chain = preimages(transfer)
    chosen = chain.of_steps(steps)
    if chosen.steps < steps:
        raise InputError(f"{steps} steps; accepted: 1 to {chosen.steps}")
    bars = bars_of([chosen])
    ax = axes_or_new(ax, (6.4, 5.2))
    draw_step_function(transfer, ax, turns=turns_for(bars))
    bottom, top = ax.get_ylim()
    room = 0.08 * (top - bottom)
    ax.set_ylim(bottom - room, top)
    look = STYLES["bar"]
    ax.barh([bottom - room / 2], [bars[0].end - bars[0].start], left=[bars[0].start],
            height=0.5 * room, facecolor=look.fill, edgecolor=look.stroke)  # fmt: skip
    write_width(ax, bars[0], bottom - room / 2, 360.0 * turns_for(bars))
    if steps == 1:
        value = in_degrees(chosen.image.start)
        ax.hlines([value], [bars[0].start], [bars[0].end], colors=INK, linewidth=4.0)
        ax.plot([0.0], [value], marker="o", color=INK, markersize=7, clip_on=False)
    else:
        _squares(ax, chosen, chain.of_steps(steps - 1))
    return ax


def _squares(ax: Axes, chosen: Preimage, before: Preimage) -> None:
    from matplotlib.patches import Rectangle

    side = in_degrees(before.width)
    transfer = chosen.transfer
    for k in range(len(transfer) * transfer.order):
        corner = (
            in_degrees(transfer.lifted_breaks[k]),
            in_degrees(transfer.lifted_values[k]),
        )
        heavy = k == chosen.first
        ax.add_patch(
            Rectangle(
                corner,
                side,
                side,
                fill=False,
                edgecolor=INK if heavy else STYLES["ghost"].stroke,
                linewidth=1.8 if heavy else 0.7,
                linestyle="-" if heavy else "--",
                zorder=4 if heavy else 1.5,
            )
        )
