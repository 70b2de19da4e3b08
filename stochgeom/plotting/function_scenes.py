"""Scenes of functions: a step function, what it comes from, and its preimages under it."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from stochgeom.feeding.preimages import Preimage
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.part import Part
from stochgeom.geometry.radius import RadiusFunction
from stochgeom.plotting.curves import Bar, bars_of, steps_of, turns_for, wave_of
from stochgeom.plotting.graph import (
    TEXT,
    Panel,
    add_bars,
    add_steps,
    add_wave,
    degree_ticks,
    round_ticks,
    step_limits,
    value_ticks,
)
from stochgeom.plotting.scene import Scene
from stochgeom.plotting.silhouettes import size_is_drawn
from stochgeom.transfer.step_function import StepFunction

_GAP = 3.7 * TEXT
"""Between two panels: the tick labels of one and the title of the next."""


def step_scene(
    transfer: StepFunction, *, width: float = 420.0, height: float = 250.0, turns: int = 1
) -> Scene:
    """Return the graph of a step function over whole turns."""
    scene = Scene()
    _step_panel(scene, transfer, 0.0, (width, height), turns, "transfer function")
    return scene


def wave_scene(
    function: DiameterFunction | RadiusFunction, *, width: float = 420.0, height: float = 150.0
) -> Scene:
    """Return the graph of a diameter or radius function over a full turn."""
    scene = Scene()
    _wave_panel(scene, function, 0.0, (width, height), 1)
    return scene


def bars_scene(chain: Iterable[Preimage], *, width: float = 420.0) -> Scene:
    """Return preimages as horizontal bars."""
    scene, bars = Scene(), bars_of(chain)
    _bar_panel(scene, bars, width, turns_for(bars))
    return scene


def analysis_scene(
    transfer: StepFunction,
    chain: Iterable[Preimage] = (),
    wave: DiameterFunction | RadiusFunction | None = None,
    *,
    name: str = "transfer function",
    width: float = 560.0,
) -> Scene:
    """Return a diameter or radius function, the step function under it, and preimages as bars."""
    scene, bars = Scene(), bars_of(chain)
    turns, bottom = turns_for(bars), 0.0
    if bars:
        bottom = _bar_panel(scene, bars, width, turns) + _GAP
    bottom += _step_panel(scene, transfer, bottom, (width, 230.0), turns, name) + _GAP
    if wave is not None:
        _wave_panel(scene, wave, bottom, (width, 130.0), turns)
    return scene


def function_behind(part: Part | None, action: str) -> DiameterFunction | RadiusFunction | None:
    """Return the function of a part that an action follows; None if there is none to draw.

    Examples
    --------
    >>> triangle = Part([(0, 0), (4, 0), (0, 3)])
    >>> type(function_behind(triangle, "push-grasp")).__name__
    'RadiusFunction'
    """
    if part is None or not size_is_drawn(part):
        return None
    if action == "squeeze":
        return DiameterFunction(part)
    return RadiusFunction(part) if action == "push-grasp" else None


def _step_panel(
    scene: Scene,
    transfer: StepFunction,
    bottom: float,
    size: tuple[float, float],
    turns: int,
    name: str,
) -> float:
    steps = steps_of(transfer, turns)
    panel = Panel(0.0, bottom, *size, (0.0, steps.end), step_limits(steps))
    panel.frame(
        scene,
        title=name,
        x_ticks=degree_ticks(steps.end),
        y_ticks=value_ticks(*panel.y),
        y_unit="°",
        remark=steps.remark,
    )
    add_steps(scene, panel, steps)
    return size[1]


def _wave_panel(
    scene: Scene,
    function: DiameterFunction | RadiusFunction,
    bottom: float,
    size: tuple[float, float],
    turns: int,
) -> None:
    wave = wave_of(function, turns)
    panel = Panel(0.0, bottom, *size, (0.0, 360.0 * turns), wave.limits)
    name = "diameter function" if isinstance(function, DiameterFunction) else "radius function"
    panel.frame(
        scene,
        title=name,
        x_ticks=degree_ticks(panel.x[1]),
        y_ticks=round_ticks(*panel.y),
        remark=wave.remark,
    )
    add_wave(scene, panel, wave)


def _bar_panel(scene: Scene, bars: Sequence[Bar], width: float, turns: int) -> float:
    height = min(20.0 * len(bars), 260.0)
    panel = Panel(0.0, 0.0, width, height, (0.0, 360.0 * turns), (0.0, float(len(bars))))
    title = "preimages: number of actions, arc, width"
    panel.frame(scene, title=title, x_ticks=degree_ticks(panel.x[1]))
    add_bars(scene, panel, bars)
    return height
