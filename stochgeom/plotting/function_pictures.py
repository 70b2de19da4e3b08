"""Graphs of functions on matplotlib `Axes`; needs the extra ``plot``.

Diameter and radius functions with their extrema, step functions, preimages as bars, distributions.
Angles are in degrees. Every function takes the axes to draw on, makes a figure without them, and
returns the axes.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any, Final

import numpy as np

from stochgeom.arguments import expect
from stochgeom.decision.hyperstates import Hyperstate
from stochgeom.errors import InputError
from stochgeom.feeding.preimages import Preimage, Preimages
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.part import PartLike
from stochgeom.geometry.radius import RadiusFunction
from stochgeom.plotting.axes import axes_or_new, need_matplotlib
from stochgeom.plotting.bar_numbers import Room, bar_half, has_line, numbers_over_bars
from stochgeom.plotting.curves import (
    Bar,
    Steps,
    Wave,
    bars_of,
    steps_of,
    turns_for,
    wave_of,
)
from stochgeom.plotting.distributions import bars_of_state
from stochgeom.plotting.graph import degree_ticks, step_limits, value_ticks
from stochgeom.plotting.scene import shown_degrees
from stochgeom.plotting.styles import INK, STYLES
from stochgeom.transfer.step_function import StepFunction

if TYPE_CHECKING:
    from matplotlib.axes import Axes


_MOST_NUMBERS: Final = 30

LETTERS: Final = 8.0
"""Size of the smaller text, in points."""


def draw_diameter(
    part: PartLike | DiameterFunction, ax: Axes | None = None, *, turns: int = 1
) -> Axes:
    """Draw the diameter function: minima (stable) filled, maxima hollow (Figs. 4.3, D.1).

    Remarks say where more than 40 minima are not marked, and where the axis does not begin at 0
    because the diameter varies by less than an eighth.

    Parameters
    ----------
    part : Part, its vertices, or its DiameterFunction
        Any part.
    ax : Axes, optional
        Where; default: on a new figure.
    turns : int
        The range, in full turns.

    Raises
    ------
    NumberLimitError
        If the part is so large or small that floats do not hold it.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> ax = draw_diameter([(0, 0), (3, 0), (3, 2), (0, 2)], Figure().subplots())
    >>> [len(line.get_xdata()) for line in ax.lines][1:]
    [5, 4]
    """
    function = part if isinstance(part, DiameterFunction) else DiameterFunction(part)
    return _draw_wave(wave_of(function, turns), turns, "diameter", ax)


def draw_radius(part: PartLike | RadiusFunction, ax: Axes | None = None, *, turns: int = 1) -> Axes:
    """Draw the radius function, distance from jaw to centre of mass (Fig. E.1).

    As `draw_diameter` draws the diameter function, with the same parameters.

    Raises
    ------
    CenterOfMassError
        If the centre of mass is not strictly inside the convex hull.
    NumberLimitError
        If the part is so large or small that floats do not hold it.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> ax = draw_radius([(0, 0), (3, 0), (3, 2), (0, 2)], Figure().subplots())
    >>> ax.lines[1].get_ydata().round(6).tolist()
    [1.0, 1.5, 1.0, 1.5, 1.0]
    """
    function = part if isinstance(part, RadiusFunction) else RadiusFunction(part)
    return _draw_wave(wave_of(function, turns), turns, "radius", ax)


def _draw_wave(wave: Wave, turns: int, name: str, ax: Axes | None) -> Axes:
    ax = axes_or_new(ax, (6.4, 2.6))
    ax.plot(wave.x, wave.y, color=STYLES["curve"].stroke, linewidth=1.5)
    if wave.marked:
        ax.plot(wave.minima, wave.at_minima, label="minima: stable", **_dots(filled=True))
        ax.plot(wave.maxima, wave.at_maxima, label="maxima", **_dots(filled=False))
    ax.set_ylim(*wave.limits)
    if wave.limits[0]:  # whole numbers at the ticks, no sum of one and the rest
        ax.ticklabel_format(axis="y", useOffset=False)
    ax.set_ylabel(name)
    _remark(ax, wave.remark)
    _degrees(ax, turns)
    return ax


def _remark(ax: Axes, text: str) -> None:
    """Write above a graph on the right what its reader has to know."""
    if text:
        ax.set_title(text, loc="right", fontsize=LETTERS)


def _dots(*, filled: bool) -> dict[str, Any]:
    style = STYLES["closed" if filled else "hollow"]
    return {
        "linestyle": "none",
        "marker": "o",
        "markersize": 5,
        "markerfacecolor": style.fill,
        "markeredgecolor": style.stroke,
    }


def _degrees(ax: Axes, turns: int, *, values: Sequence[float] = ()) -> None:
    """Give an axes degrees along x, and along y if values are given."""
    end = 360.0 * turns
    ax.set_xlim(0.0, end)
    ticks = degree_ticks(end, most=max(3, min(9, int(size_in_points(ax)[0] / (4.5 * LETTERS)))))
    ax.set_xticks(ticks, [shown_degrees(f"{tick:g}") for tick in ticks])
    if values:
        ax.set_yticks(list(values), [shown_degrees(f"{tick:g}") for tick in values])
    ax.grid(color=STYLES["grid"].stroke, linewidth=0.6)
    ax.set_axisbelow(True)


def size_in_points(ax: Axes) -> tuple[float, float]:
    """Return width and height of axes, as they are now, in points."""
    box, dpi = ax.get_window_extent(), ax.get_figure(root=True).dpi  # type: ignore[union-attr]
    return float(box.width * 72.0 / dpi), float(box.height * 72.0 / dpi)


def draw_step_function(
    transfer: StepFunction, ax: Axes | None = None, *, turns: int = 1, name: str = ""
) -> Axes:
    """Draw a step function: ends that belong to a step filled (Figs. 4.4, 5.2, E.2, E.3).

    The dashed diagonal is where an action leaves the part as it is. The ends of more than 40 steps
    are not marked, and a remark says so.

    Parameters
    ----------
    transfer : StepFunction
        Lifted: its values may lie outside [0, 360) degrees.
    ax : Axes, optional
        Where; default: on a new figure.
    turns : int
        The range, in full turns.
    name : str
        Written along the y axis.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> from stochgeom.transfer.squeeze import squeeze_function
    >>> squeeze = squeeze_function([(0, 0), (3, 0), (3, 2), (0, 2)])
    >>> ax = draw_step_function(squeeze, Figure().subplots(), name="squeeze")
    >>> ax.get_ylabel(), [tick.get_text() for tick in ax.get_yticklabels()]
    ('squeeze', ['0°', '90°', '180°', '270°', '360°'])
    """
    need_matplotlib()
    steps = steps_of(transfer, turns)
    ax = axes_or_new(ax, (6.4, 4.4))
    limits = step_limits(steps)
    diagonal = STYLES["diagonal"]
    ax.plot([0, steps.end], [0, steps.end], color=diagonal.stroke, linewidth=0.8, linestyle="--")
    _draw_steps(ax, steps)
    ax.set_ylim(*limits)
    ax.set_ylabel(name or "orientation after")
    _remark(ax, steps.remark)
    _degrees(ax, turns, values=value_ticks(*limits))
    return ax


def _draw_steps(ax: Axes, steps: Steps) -> None:
    jump, step = STYLES["jump"], STYLES["step"]
    inner = steps.starts[1:]
    ax.vlines(inner, steps.values[:-1], steps.values[1:], colors=str(jump.stroke), linewidth=0.8,
              linestyles="dotted")  # fmt: skip
    ax.hlines(steps.values, steps.starts, steps.ends, colors=str(step.stroke), linewidth=2.0)
    if steps.marked:
        ax.plot(steps.ends[:-1], steps.values[:-1], **_dots(filled=False) | {"markersize": 4})
        first = 1 if steps.cut_at_start else 0
        ax.plot(
            steps.starts[first:], steps.values[first:], **_dots(filled=True) | {"markersize": 4}
        )


def draw_preimages(
    chain: StepFunction | Preimages | Iterable[Preimage], ax: Axes | None = None
) -> Axes:
    """Draw the preimages of phase I as horizontal bars, with their widths (Figs. 5.9-5.11, E.4).

    Parameters
    ----------
    chain : StepFunction, Preimages, or any preimages
        Of a step function all of them.
    ax : Axes, optional
        Where; default: on a new figure.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> from stochgeom.transfer.squeeze import squeeze_function
    >>> squeeze = squeeze_function([(0, 0), (3, 0), (3, 2), (0, 2)])
    >>> ax = draw_preimages(squeeze, Figure().subplots())
    >>> len(ax.patches), [text.get_text() for text in ax.texts]
    (2, ['112.62°', '180.00°'])
    """
    bars = bars_of(_listed(chain))
    ax = axes_or_new(ax, (6.4, min(0.9 + 0.26 * len(bars), 8.0)))
    turns = turns_for(bars)
    style = STYLES["bar"]
    rows = [bar.steps for bar in bars]
    ax.barh(
        rows,
        [bar.end - bar.start for bar in bars],
        left=[bar.start for bar in bars],
        height=0.56,
        facecolor=style.fill,
        edgecolor=style.stroke,
        linewidth=0.8,
    )
    _degrees(ax, turns)
    ax.set_ylim(len(bars) + 0.5, 0.5)
    ax.set_ylabel("actions")
    every = _label_every(ax, len(bars))
    labelled = [bar for bar in bars if (bar.steps - 1) % every == 0]
    ax.set_yticks([bar.steps for bar in labelled])
    for bar in labelled:
        write_width(ax, bar, bar.steps, 360.0 * turns)
    ax.grid(visible=False, axis="y")
    return ax


def _listed(chain: StepFunction | Preimages | Iterable[Preimage]) -> list[Preimage]:
    accepted = "a step function, or preimages such as FeedingProblem(part).preimages"
    found = Preimages(chain) if isinstance(chain, StepFunction) else chain
    preimages = list(expect(found, Iterable, accepted))
    if not preimages:
        raise InputError(f"0 preimages; accepted: {accepted}")
    return [expect(preimage, Preimage, accepted) for preimage in preimages]


def _label_every(ax: Axes, rows: int) -> int:
    """Return 1 if every row is high enough for text, else how many rows a label needs."""
    return max(1, int(np.ceil(1.25 * LETTERS * rows / size_in_points(ax)[1])))


def write_width(ax: Axes, bar: Bar, y: float, end: float) -> None:
    """Write a bar's width behind it, before it where the axes end too soon, or else in it."""
    text = f"{bar.width_text}°"
    room = (0.62 * LETTERS * len(text) + 8.0) * end / size_in_points(ax)[0]
    if bar.end + room <= end:
        place, shift, anchor = bar.end, 4, "left"
    elif bar.start - room >= 0.0:
        place, shift, anchor = bar.start, -4, "right"
    else:
        place, shift, anchor = (bar.start + bar.end) / 2, 0, "center"
    ax.annotate(
        text,
        (place, y),
        xytext=(shift, 0),
        textcoords="offset points",
        ha=anchor,
        va="center",
        fontsize=LETTERS,
        color=INK,
    )


def draw_distribution(state: Hyperstate, ax: Axes | None = None) -> Axes:
    """Draw a hyperstate: a bar for each orientation relative to the gripper, its probability above.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> from stochgeom.feeding.planner import plan_feeding
    >>> plan = plan_feeding([(0, 0), (3, 0), (3, 2), (0, 2)])
    >>> ax = draw_distribution(plan.distribution(1), Figure().subplots())
    >>> [text.get_text() for text in ax.texts]
    ['0.313', '0.187', '0.313', '0.187']
    """
    state = expect(state, Hyperstate, "a distribution, such as plan.distribution(1)")
    ax = axes_or_new(ax, (6.4, 2.4))
    places, shares = bars_of_state(state)
    style, half = STYLES["bar"], bar_half(places, 1.5, 0.2)
    if half > 0.75:
        ax.bar(places, shares, width=2 * half, facecolor=style.fill, edgecolor=style.stroke,
               linewidth=0.8)  # fmt: skip
    else:  # so close that nothing is seen between the edges of a bar
        ax.vlines(places, 0.0, shares, colors=str(STYLES["curve"].stroke), linewidth=1.0)
    ax.set_ylim(0.0, 1.2 * max(shares))
    _degrees(ax, 1)
    ax.set_xlim(-6.0, 366.0)
    ax.set_ylabel("probability")
    state = state.possible()
    if len(state) <= len(places) <= _MOST_NUMBERS:  # a bar for each orientation
        _write_over_bars(ax, places, shares, state.probabilities(3), half)
    return ax


def _write_over_bars(
    ax: Axes, places: Sequence[float], shares: Sequence[float], texts: Sequence[str], half: float
) -> None:
    """Write the bars' numbers above them and make room for these; they are placed in points."""
    width, height = size_in_points(ax)
    across = width / 372.0
    line = 1.35 * LETTERS
    lines = 4 if len(places) > 1 and height > 10 * line else 1
    up = (height - lines * line) / max(shares)
    room = Room(-5.0 * across, 365.0 * across, height, half * across, line, 0.2 * LETTERS)
    centers, tops = [x * across for x in places], [share * up for share in shares]
    widths = [0.62 * LETTERS * (len(text) + 0.7) for text in texts]
    found = numbers_over_bars(centers, tops, widths, room)
    top = max(y for _, y in found.values()) + 1.1 * line if found else 0.0
    # Less room than was reckoned with only moves the numbers apart.
    ax.set_ylim(0.0, max(1.05 * max(shares), top / up))
    for k, (x, y) in found.items():
        if has_line(centers[k], tops[k], (x, y), room):
            ax.vlines(places[k], shares[k], (y + 0.15 * line) / up, colors=INK, linewidth=0.5)
        ax.text(x / across, (y + 0.5 * line) / up, texts[k], ha="center", va="center",
                fontsize=LETTERS, color=INK)  # fmt: skip
