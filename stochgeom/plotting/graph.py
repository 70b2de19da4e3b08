"""Graphs as shapes: a panel with axes in degrees, for SVG without matplotlib."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Final, final

import numpy as np

from stochgeom.plotting.curves import Bar, Steps, Wave
from stochgeom.plotting.scene import (
    MINUS,
    XY,
    Disc,
    Label,
    Line,
    Scene,
    points_of,
    rectangle,
    shown_degrees,
)
from stochgeom.plotting.silhouettes import FloatArray

TEXT: Final = 11.0
"""Size of the letters, in pixels like everything here."""


@final
@dataclass(frozen=True, slots=True)
class Panel:
    """A rectangle of the picture, in pixels with y upwards, that shows a range of data."""

    left: float
    bottom: float
    width: float
    height: float
    x: tuple[float, float]
    y: tuple[float, float]

    def at(self, x: float, y: float) -> XY:
        """Return where data is drawn."""
        (x0, x1), (y0, y1) = self.x, self.y
        return (
            self.left + self.width * (x - x0) / (x1 - x0),
            self.bottom + self.height * (y - y0) / (y1 - y0),
        )

    def frame(
        self,
        scene: Scene,
        *,
        title: str = "",
        x_ticks: Sequence[float] = (),
        y_ticks: Sequence[float] = (),
        y_unit: str = "",
        remark: str = "",
    ) -> None:
        """Draw the frame, grid lines, ticks with labels; above a title, on the right a remark."""
        (x0, x1), (y0, y1) = self.x, self.y
        for x in x_ticks:
            scene.add(Line((self.at(x, y0), self.at(x, y1)), "grid"))
            px, py = self.at(x, y0)
            scene.add(Label((px, py - 1.15 * TEXT), shown_degrees(f"{x:g}"), TEXT))
        for y in y_ticks:
            scene.add(Line((self.at(x0, y), self.at(x1, y)), "grid"))
            px, py = self.at(x0, y)
            text = f"{y:.10g}".replace("-", MINUS) + y_unit
            scene.add(Label((px - 7, py), text, TEXT, "end"))
        low, high = self.at(x0, y0), self.at(x1, y1)
        scene.add(rectangle(low, high, "frame"))
        if title:
            scene.add(Label((low[0], high[1] + 0.8 * TEXT), title, TEXT, "start", bold=True))
        if remark:
            scene.add(Label((high[0], high[1] + 0.8 * TEXT), remark, 0.9 * TEXT, "end"))


def degree_ticks(end: float, most: int = 9) -> list[float]:
    """Return round places on an axis from 0 to ``end`` degrees, at most so many.

    Examples
    --------
    >>> degree_ticks(360), degree_ticks(720, 5)
    ([0.0, 45.0, ..., 360.0], [0.0, 180.0, 360.0, 540.0, 720.0])
    """
    step = next((s for s in (15.0, 30.0, 45.0, 90.0, 180.0, 360.0) if end / s < most), 720.0)
    return [step * k for k in range(round(end // step) + 1)]


def value_ticks(low: float, high: float, most: int = 6) -> list[float]:
    """Return multiples of 90 degrees, or of more, from low to high.

    Examples
    --------
    >>> value_ticks(-100, 400)
    [-90.0, 0.0, 90.0, 180.0, 270.0, 360.0]
    """
    step = next((s for s in (45.0, 90.0, 180.0, 360.0, 720.0) if (high - low) / s <= most), 3600.0)
    first, last = int(np.ceil(low / step)), int(np.floor(high / step))
    return [step * k for k in range(first, last + 1)]


def round_ticks(low: float, high: float, most: int = 5) -> list[float]:
    """Return multiples of 1, 2 or 5 times a power of ten from low to high.

    Examples
    --------
    >>> round_ticks(0, 4.2)
    [0.0, 1.0, 2.0, 3.0, 4.0]
    """
    base = 10.0 ** np.floor(np.log10((high - low) / most))
    step = next(base * m for m in (1, 2, 5, 10, 20) if (high - low) / (base * m) <= most)
    first, last = int(np.ceil(low / step)), int(np.floor(high / step))
    return [float(f"{step * k:.12g}") for k in range(first, last + 1)]


def step_limits(steps: Steps) -> tuple[float, float]:
    """Return a range that shows all values, and the whole diagonal."""
    low = min(0.0, float(steps.values.min()))
    high = max(steps.end, float(steps.values.max()))
    pad = 0.04 * (high - low)
    return low - pad, high + pad


# --- what stands in a panel ----------------------------------------------------------------------


def add_wave(scene: Scene, panel: Panel, wave: Wave) -> None:
    """Draw a diameter or radius function, its minima filled, its maxima hollow, if they are few."""
    scene.add(Line(tuple(panel.at(x, y) for x, y in points_of(_thin(wave))), "curve"))
    if wave.marked:
        for xs, ys, style in (
            (wave.minima, wave.at_minima, "closed"),
            (wave.maxima, wave.at_maxima, "hollow"),
        ):
            scene.add(*(Disc(panel.at(x, y), 3.2, style) for x, y in points_of(_pairs(xs, ys))))


def _thin(wave: Wave) -> list[list[float]]:
    """Return every sample that is an end, an extremum's neighbour or a degree from the last."""
    kept = [0]
    for k in range(1, len(wave.x)):
        if wave.x[k] - wave.x[kept[-1]] >= 0.99 or k == len(wave.x) - 1:
            kept.append(k)
    return [[float(wave.x[k]), float(wave.y[k])] for k in kept]


def _pairs(xs: FloatArray, ys: FloatArray) -> list[list[float]]:
    return [[float(x), float(y)] for x, y in zip(xs, ys, strict=True)]


def add_steps(scene: Scene, panel: Panel, steps: Steps) -> None:
    """Draw a step function: ends that belong to a step filled, others hollow.

    Many steps are drawn as one line, those that have pixels of their own.
    """
    end = steps.end
    scene.add(Line((panel.at(0, 0), panel.at(end, end)), "diagonal"))
    if not steps.marked:
        scene.add(Line(tuple(panel.at(x, y) for x, y in _stairs(steps, int(panel.width))), "step"))
        return
    rows = list(zip(steps.starts, steps.ends, steps.values, strict=True))
    add_marked_steps(scene, panel, rows, cut_at_start=steps.cut_at_start)


def add_marked_steps(
    scene: Scene, panel: Panel, rows: Sequence[tuple[float, float, float]], *, cut_at_start: bool
) -> None:
    """Draw steps of (start, end, value), their ends marked but for those that the range cuts off.

    Parameters
    ----------
    cut_at_start : bool
        Whether the first step begins before the range; the last one ends where the range does.
    """
    for (_, x, y), (_, _, z) in pairwise(rows):
        scene.add(Line((panel.at(x, y), panel.at(x, z)), "jump"))
    scene.add(*(Line((panel.at(a, y), panel.at(b, y)), "step") for a, b, y in rows))
    scene.add(*(Disc(panel.at(b, y), 2.6, "hollow") for _, b, y in rows[:-1]))
    kept = rows[1:] if cut_at_start else rows
    scene.add(*(Disc(panel.at(a, y), 2.6, "closed") for a, _, y in kept))


def _stairs(steps: Steps, most: int) -> Iterator[XY]:
    """Yield both ends of the steps, of about ``most`` of them."""
    every = max(1, len(steps.values) // most)
    columns = (column[::every].tolist() for column in (steps.starts, steps.ends, steps.values))
    for start, end, value in zip(*columns, strict=True):
        yield from ((start, value), (end, value))


def add_bars(scene: Scene, panel: Panel, bars: Sequence[Bar]) -> None:
    """Draw preimages as horizontal bars, one row each from the top, with their widths.

    The panel's y runs from 0 to the number of rows. Where rows are too narrow for text, some have
    no label.
    """
    row = panel.height / max(len(bars), 1)
    size = min(TEXT, 0.8 * row) if row >= 9 else 9.0
    every = max(1, int(np.ceil(11.0 / row)))
    for k, bar in enumerate(bars):
        y = len(bars) - k - 0.5
        scene.add(rectangle(panel.at(bar.start, y - 0.28), panel.at(bar.end, y + 0.28), "bar"))
        if k % every == 0 or k == len(bars) - 1 >= every * (len(bars) // every):
            scene.add(_width_label(panel, bar, y, size))
            px, py = panel.at(panel.x[0], y)
            scene.add(Label((px - 5, py), f"{bar.steps}", size, "end"))


def _width_label(panel: Panel, bar: Bar, y: float, size: float) -> Label:
    """Return a bar's width: behind it, before it where the frame ends too soon, or else in it."""
    (start, py), (end, _) = panel.at(bar.start, y), panel.at(bar.end, y)
    label = Label((end + 5, py), f"{bar.width_text}°", size, "start")
    if end + 8 + label.width <= panel.left + panel.width:
        return label
    if start - 8 - label.width >= panel.left:
        return Label((start - 5, py), label.text, size, "end")
    return Label(((start + end) / 2, py), label.text, size)
