"""The tray and tilts on matplotlib `Axes` (thesis Figs. 6.1 to 6.3); needs the extra ``plot``."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from stochgeom.plotting.axes import draw_scene, need_matplotlib
from stochgeom.plotting.tilting_scenes import tilting_scene
from stochgeom.plotting.tray_scenes import tilt_plan_scene, tray_scene
from stochgeom.tilting.estimation import TransitionModel
from stochgeom.tilting.tray import TraySetup

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_INCHES = 0.25


def draw_tray(setup: TraySetup | None = None, ax: Axes | None = None) -> Axes:
    """Draw the tray with the tile in its twelve states, and the twelve tilts (Fig. 6.2).

    Parameters
    ----------
    setup : TraySetup, optional
        Sizes of tray and tile; default: those of ``TraySetup()``.
    ax : Axes, optional
        Where; default: on a new figure.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> ax = draw_tray(ax=Figure().subplots())
    >>> [text.get_text() for text in ax.texts][:12]
    ['1', '2', '3', '4', '5', '6', '7', '8', '9', '10', '11', '12']
    """
    need_matplotlib()
    return draw_scene(tray_scene(TraySetup() if setup is None else setup), ax, inches=_INCHES)


def draw_tilts(
    model: TransitionModel,
    start: int,
    actions: Sequence[int],
    ax: Axes | None = None,
    *,
    setup: TraySetup | None = None,
) -> Axes:
    """Draw the tray before and after each of some tilts, and where the tile may be (Fig. 6.3).

    Probabilities are those of the model's means, exact before they are rounded. The likeliest
    states are filled, others dashed; those below 1/50 are told as one number.

    Parameters
    ----------
    model : TransitionModel
        Of the twelve states.
    start : int
        The state before, from 1.
    actions : sequence of int
        The tilts, from 1, such as ``plan.actions``.
    ax : Axes, optional
        Where; default: on a new figure.
    setup : TraySetup, optional
        Sizes of tray and tile.

    Raises
    ------
    RecordingError
        If a state or a tilt does not exist.
    InputError
        If the model is of other states.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> from stochgeom.thesis.chapter_6 import figure_6_4_model
    >>> ax = draw_tilts(figure_6_4_model(), 7, [1], Figure().subplots())
    >>> [text.get_text() for text in ax.texts][-5:-1]
    ['state 1: 0.740', 'state 3: 0.124', 'state 12: 0.124', 'others: 0.011']
    """
    need_matplotlib()
    sizes = TraySetup() if setup is None else setup
    return draw_scene(tilt_plan_scene(model, start, actions, sizes), ax, inches=_INCHES)


def draw_tilting(setup: TraySetup | None = None, ax: Axes | None = None) -> Axes:
    """Draw three side views of the tray: level, tilted, level again (thesis Fig. 6.1).

    The tray is tilted by ``setup.tilt``; the tile slides down to the low wall, or stays where it is
    if the slope is not above ``setup.support_friction``. Arm, walls and thickness are a schematic.

    Parameters
    ----------
    setup : TraySetup, optional
        Sizes of tray and tile in millimetres, the tilt in degrees; default: ``TraySetup()``.
    ax : Axes, optional
        Where; default: on a new figure.

    Raises
    ------
    MissingExtraError
        If matplotlib is not installed.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> ax = draw_tilting(ax=Figure().subplots())
    >>> [text.get_text() for text in ax.texts][:3]
    ['before', 'tilted by 25°', 'after']
    """
    need_matplotlib()
    return draw_scene(tilting_scene(TraySetup() if setup is None else setup), ax, inches=_INCHES)
