"""The tray from above: its twelve states and tilts, and what tilts do (thesis Figs. 6.2 and 6.3).

The units are those of a tray of side 10, whatever its millimetres.
"""

from __future__ import annotations

import math
from collections.abc import Iterable, Sequence
from typing import Final

from gmpy2 import mpq

from stochgeom.arguments import expect
from stochgeom.errors import InputError
from stochgeom.exact.decimals import rational_decimal
from stochgeom.plotting.scene import XY, Label, Polygon, Scene, arrow, rectangle
from stochgeom.tilting.estimation import TransitionModel
from stochgeom.tilting.states import ACTIONS, CANONICAL, STATES, CanonicalState, azimuth, half_sizes
from stochgeom.tilting.tilt_plans import hyperstates
from stochgeom.tilting.tray import TraySetup

_SIDE: Final = 10.0
_SIZE: Final = 0.62
_COLUMN: Final = 16.0
_LEAST: Final = mpq(1, 50)
"""States of a smaller probability are left out of the picture of a plan, and said to be."""


def tray_scene(setup: TraySetup) -> Scene:
    """Return the tray with the tile in all twelve states, and the twelve tilts around it.

    Of a tile so large that the states hide each other, each state has a tray of its own.
    """
    setup = expect(setup, TraySetup, "a TraySetup")
    scene = Scene()
    if _free_of_corner(setup) >= 2 * _SIZE:
        for state in CANONICAL:
            scene.add(rectangle(*_corners(setup, state), "tile"))
        for state in CANONICAL:
            scene.add(Label(_label_place(setup, state), str(state.number), _SIZE))
        lines = ("inside: states", "outside: tilts")
    else:
        for state in CANONICAL:
            row, column = divmod(state.number - 1, 4)
            x, y = (column - 1.5) * 1.25 * _SIDE, (-2.2 - 1.4 * row) * _SIDE
            tile = rectangle(*_corners(setup, state), "likely")
            number = Label((0.0, 0.57 * _SIDE), f"state {state.number}", _SIZE)
            scene.place([tile, _frame(), number], x, y)
        lines = ("the tray", "and its tilts")
    scene.add(_frame())
    for action in range(1, ACTIONS + 1):
        _add_tilt(scene, (0.0, 0.0), action, (0.79 * _SIDE, 0.9 * _SIDE))
        scene.add(Label(_polar((0.0, 0.0), 0.97 * _SIDE, action), str(action), _SIZE, bold=True))
    for y, line in zip((0.45, -0.45), lines, strict=True):
        scene.add(Label((0.0, y), line, _SIZE))
    return scene


def tilt_plan_scene(
    model: TransitionModel, start: int, actions: Sequence[int], setup: TraySetup
) -> Scene:
    """Return the tray before the first and after every tilt, with the states the tile may be in.

    By the means of the model, exactly. The likeliest state is filled, those below 1/50 are left out
    and their sum is told.
    """
    model = expect(model, TransitionModel, "a TransitionModel, such as figure_6_4_model()")
    setup = expect(setup, TraySetup, "a TraySetup")
    if model.counts.states != STATES:
        raise InputError(f"a model of {model.counts.states} states; accepted: the {STATES} states")
    expect(actions, Sequence, "a list of tilts, such as plan.actions")
    scene = Scene()
    passed = hyperstates(model, start, actions)
    for k, shares in enumerate(passed):
        _add_tray(scene, k * _COLUMN, setup, shares)
        caption = "before" if k == 0 else f"after tilt {actions[k - 1]}"
        scene.add(Label((k * _COLUMN, 0.5 * _SIDE + 0.9), caption, 1.2 * _SIZE, bold=True))
        if k:
            middle = ((k - 0.5) * _COLUMN, 0.0)
            _add_tilt(scene, middle, int(actions[k - 1]), (-1.5, 1.5))
    return scene


def _frame() -> Polygon:
    half = _SIDE / 2
    return rectangle((-half, -half), (half, half), "tray")


def _corners(setup: TraySetup, state: CanonicalState) -> tuple[XY, XY]:
    """Return two opposite corners of the tile in the middle of a state."""
    unit = _SIDE / setup.side
    halves = [h * unit for h in half_sizes(setup, horizontal=state.horizontal)]
    x, y = ((_SIDE / 2 - h) * at for h, at in zip(halves, (state.right, state.up), strict=True))
    return (x - halves[0], y - halves[1]), (x + halves[0], y + halves[1])


def _free_of_corner(setup: TraySetup) -> float:
    """Return how much of a tile in a corner neither the turned one there nor the next hides."""
    unit = _SIDE / setup.side
    length, width = setup.tile_length * unit, setup.tile_width * unit
    return min(length, (_SIDE - length) / 2) - width


def _label_place(setup: TraySetup, state: CanonicalState) -> XY:
    """Return where a state's number stands: in a corner, on what no other tile hides."""
    low, high = _corners(setup, state)
    x, y = (low[0] + high[0]) / 2, (low[1] + high[1]) / 2
    free = _free_of_corner(setup)
    if not state.is_corner or free <= 0:
        return x, y
    reach = _SIDE / 2 - setup.tile_width * _SIDE / setup.side - free / 2
    if state.horizontal:
        return math.copysign(reach, state.right), y
    return x, math.copysign(reach, state.up)


def _polar(center: XY, radius: float, action: int) -> XY:
    angle = math.radians(azimuth(action))
    return center[0] + radius * math.cos(angle), center[1] + radius * math.sin(angle)


def _add_tilt(scene: Scene, center: XY, action: int, radii: tuple[float, float]) -> None:
    start, end = (_polar(center, radius, action) for radius in radii)
    scene.add(*arrow(start, end, 0.5))


def _add_tray(scene: Scene, x: float, setup: TraySetup, shares: Sequence[mpq]) -> None:
    likely = [k for k in range(STATES) if shares[k] >= _LEAST]
    most = max(shares[:STATES])
    heavy = [k for k in likely if shares[k] == most]
    light = [k for k in likely if shares[k] != most]
    tiles = [rectangle(*_corners(setup, CANONICAL[k]), "likely") for k in heavy]
    tiles += [rectangle(*_corners(setup, CANONICAL[k]), "unlikely") for k in light]
    labels = [Label(_label_place(setup, CANONICAL[k]), str(k + 1), _SIZE) for k in likely]
    if _free_of_corner(setup) < 2 * _SIZE:  # then the numbers would hide each other
        labels = labels[:1] if len(likely) == 1 else []
    scene.place([*tiles, _frame(), *labels], x)
    rest = sum((shares[k] for k in range(len(shares)) if k not in likely), start=mpq(0))
    lines = [f"state {k + 1}: {rational_decimal(shares[k], 3)}" for k in _ranked(likely, shares)]
    if rest:
        lines.append(f"others: {rational_decimal(rest, 3)}")
    for row, line in enumerate(lines):
        scene.add(Label((x, -0.5 * _SIDE - 0.9 - 1.5 * _SIZE * row), line, _SIZE))


def _ranked(states: Iterable[int], shares: Sequence[mpq]) -> list[int]:
    return sorted(states, key=lambda k: (-shares[k], k))
