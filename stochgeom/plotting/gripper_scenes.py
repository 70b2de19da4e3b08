"""Grippers with and without a sliding jaw (thesis Figs. B.1 to B.4).

A jaw that slides along itself passes on no force in that direction, so that friction cannot wedge
the part: it rolls on the fixed jaw and takes the plate of the other jaw along until an edge lies
flush. The motion drawn is that: floats, a schematic, no physics.
"""

from __future__ import annotations

from bisect import bisect_right
from dataclasses import dataclass
from itertools import pairwise
from typing import Final, final

import numpy as np

from stochgeom.exact.angles import ZERO, Angle
from stochgeom.exact.decimals import Rounding
from stochgeom.exact.shadows import shadow
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.part import Part
from stochgeom.grasping.contacts import contacts_of
from stochgeom.grasping.friction import Friction
from stochgeom.plotting.grasp_scenes import contact_word
from stochgeom.plotting.grasps import Pose, contact_shapes, part_shapes
from stochgeom.plotting.scene import (
    Disc,
    Label,
    Scene,
    Shape,
    arrow,
    moved,
    rectangle,
    shown_degrees,
)
from stochgeom.plotting.silhouettes import FEW_DRAWN, Silhouette, rotation, silhouette
from stochgeom.transfer.squeeze import squeeze_function

HALF: Final = 1.5
"""Half the length of a jaw here: longer than the part rolls."""

_PLATE: Final = 0.12
_BODY: Final = 0.2
_ROLLER: Final = 0.07
_PALM: Final = HALF + 0.55
_PITCH: Final = 5.2
_SIZE: Final = 0.22
_SAMPLES: Final = 400


def gripper_shapes(
    low: float, high: float, *, sliding: bool = False, slide: float = 0.0
) -> list[Shape]:
    """Return a gripper whose jaws are closed to ``low`` and ``high``.

    Parameters
    ----------
    low, high : float
        Where the faces of the jaws are.
    sliding : bool
        Whether the upper jaw carries a plate on rollers.
    slide : float
        How far the plate has moved along the jaw.
    """
    lower = rectangle((-HALF, low - _BODY), (_PALM, low), "jaw")
    shapes: list[Shape] = [lower]
    body = high
    if sliding:
        body = high + _PLATE + 2 * _ROLLER
        shapes += [
            Disc((x + slide / 2, high + _PLATE + _ROLLER), _ROLLER, "roller")
            for x in np.linspace(-0.7, 0.7, 6).tolist()
        ]
        shapes.append(rectangle((slide - 1.15, high), (slide + 1.15, high + _PLATE), "slide"))
    shapes.append(rectangle((-HALF, body), (_PALM, body + _BODY), "jaw"))
    shapes.append(rectangle((_PALM - 0.12, low - 0.5), (_PALM + 0.22, body + 0.5), "palm"))
    return shapes


def gripper_scene(*, sliding: bool = False, opening: float = 1.6) -> Scene:
    """Return an empty gripper, with or without its sliding plate, and the way its jaws close."""
    scene = Scene(gripper_shapes(-opening / 2, opening / 2, sliding=sliding))
    top = opening / 2 + (_PLATE + 2 * _ROLLER if sliding else 0.0) + _BODY
    scene.add(*arrow((-0.6, top + 0.55), (-0.6, top + 0.08), 0.2))
    scene.add(*arrow((-0.6, -opening / 2 - _BODY - 0.55), (-0.6, -opening / 2 - _BODY - 0.08), 0.2))
    scene.add(Label((-HALF, opening / 2 + 1.35), "parallel-jaw gripper", _SIZE, "start", bold=True))
    if sliding:
        y = opening / 2 + _PLATE / 2
        scene.add(*arrow((-1.3, y), (-1.75, y), 0.18), *arrow((1.3, y), (1.75, y), 0.18))
        scene.add(Label((0.0, opening / 2 - 0.25), "plate on rollers", _SIZE))
    return scene


@final
@dataclass(frozen=True, slots=True)
class Rolling:
    """A part that has rolled from first contact to an orientation, in floats.

    Attributes
    ----------
    theta : float
        The orientation, in radians.
    shift : float
        How far the part's middle has moved along the fixed jaw.
    slide : float
        How far the point on the sliding jaw has moved.
    """

    theta: float
    shift: float
    slide: float


def rolling(body: Silhouette, start: float, end: float) -> Rolling:
    """Roll a part on the lower jaw, without slipping, from one orientation to another.

    Examples
    --------
    >>> square = silhouette([(0, 0), (2, 0), (2, 2), (0, 2)])
    >>> found = rolling(square, 0.5, 0.0)
    >>> round(found.slide, 3), round(found.slide - 2 * found.shift, 3)
    (0.851, 0.0)
    """
    shift = slide = 0.0
    turns = np.linspace(start, end, _SAMPLES + 1)
    for a, b in pairwise(turns.tolist()):
        middle = body.hull @ rotation((a + b) / 2).T
        # The contacts stay the same in so small a turn; the lower one does not move.
        moves = body.hull @ (rotation(b) - rotation(a)).T
        lower, upper = int(middle[:, 1].argmin()), int(middle[:, 1].argmax())
        step = -float(moves[lower, 0])
        shift += step
        slide += float(moves[upper, 0]) + step
    return Rolling(end, shift, slide)


def _centred(state: Rolling, last: Rolling) -> Rolling:
    """Return a state of a motion whose middle is in the middle of the jaws."""
    return Rolling(state.theta, state.shift - last.shift / 2, state.slide - last.slide / 2)


def _held(body: Silhouette, state: Rolling, *, sliding: bool) -> list[Shape]:
    pose = Pose(body, state.theta)
    low, high = pose.gap
    inside = [*part_shapes(pose.turned), *contact_shapes(pose)]
    gripper = gripper_shapes(low, high, sliding=sliding, slide=state.slide)
    return [*gripper, *(moved(shape, state.shift, 0.0) for shape in inside)]


def closing_scene(part: Part, theta: Angle) -> Scene:
    """Return three moments of closing the gripper with the sliding jaw (thesis Fig. B.4).

    First contact at ``theta``; half way; the stable orientation that a squeeze leads to.
    """
    body, start = silhouette(part, FEW_DRAWN), shadow(theta)
    final = squeeze_function(part)(theta)
    end, scene = shadow(final), Scene()
    words = (
        f"1: first contact, {shown_degrees(theta.degrees(2))}",
        "2: the plate slides, the part rolls" if final != theta else "2: nothing moves",
        f"3: stable, {shown_degrees(final.degrees(2))}",
    )
    last = rolling(body, start, end)
    states = (Rolling(start, 0.0, 0.0), rolling(body, start, (start + end) / 2), last)
    for k, (state, word) in enumerate(zip(states, words, strict=True)):
        x = _PITCH * k
        scene.place(_held(body, _centred(state, last), sliding=True), x)
        scene.add(Label((x, -1.85), word, _SIZE))
    return scene


def least_friction(part: Part, theta: Angle) -> Friction:
    """Return the friction that only more friction than that holds a part in an orientation.

    Between two vertices, or with an edge flush that is not stable by itself; none where it is.

    Examples
    --------
    >>> square = Part([(0, 0), (1, 0), (1, 1), (0, 1)])
    >>> str(least_friction(square, Angle(0, (3, 1)))), str(least_friction(square, Angle()))
    ('1/2', '0')
    """
    found, place = contacts_of(DiameterFunction(part)), theta.reduced()
    p = bisect_right(found.starts, place) - 1
    if p >= 0 and found.starts[p] == place:
        return Friction(max(found.before[p], -found.after[p], ZERO))
    rho = found.normal(p) - place
    return Friction(max(rho, -rho))


def wedged_or_stable_scene(part: Part, theta: Angle) -> Scene:
    """Return the same grasp without and with the sliding jaw (thesis Figs. B.2 and 3.4).

    Without it friction may hold the part where the jaws first touched it: the caption says how much
    friction that takes, rounded up. With it the part turns on to a stable orientation.
    """
    body, start = silhouette(part, FEW_DRAWN), shadow(theta)
    final = squeeze_function(part)(theta)
    scene = Scene()
    scene.place(_held(body, Rolling(start, 0.0, 0.0), sliding=False))
    last = rolling(body, start, shadow(final))
    scene.place(_held(body, _centred(last, last), sliding=True), _PITCH)
    word = contact_word(part, theta)
    place = f"{word} at {shown_degrees(theta.degrees(2))}"
    if word != "stable":
        least = least_friction(part, theta)
        held = "" if word == "wedged" else ", held"
        place += held + (
            f" if μ > {least.decimal(4, Rounding.UP)}" if least.angle else " by any friction"
        )
    scene.add(Label((0.0, -1.85), f"friction: {place}", _SIZE))
    with_plate = f"sliding jaw: stable at {shown_degrees(final.degrees(2))}"
    scene.add(Label((_PITCH, -1.85), with_plate, _SIZE))
    return scene
