"""A part between the jaws, as shapes: the piece that most pictures are made of.

Everything is drawn in the gripper's frame (jaws level, closing along y) and then turned by the
gripper's angle about (0, 0), the middle of the part's bounding box. The part has radius 1.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, final

import numpy as np

from stochgeom.plotting.scene import XY, Disc, Line, Polygon, Scene, Shape, points_of, rectangle
from stochgeom.plotting.silhouettes import FloatArray, Silhouette, rotation

JAW_HALF: Final = 1.05
"""Half the length of a jaw."""

JAW_THICKNESS: Final = 0.16

OPEN_GAP: Final = 1.12
"""How far an open jaw is from the middle."""

REACH: Final = float(np.hypot(JAW_HALF, OPEN_GAP + JAW_THICKNESS))
"""Radius of the disc that a part and its jaws stay in, open or closed, at any angle."""

STUB: Final = 0.1
"""Height of the stub on the outside of the lower jaw, and about half its width."""

CONTACT_SIZE: Final = 0.06
_FLUSH: Final = 1e-7
"""Vertices nearer to a jaw than that are drawn as touching it; nothing is decided by it."""


@final
@dataclass(frozen=True, slots=True)
class Pose:
    """A part and a gripper, to be drawn.

    Attributes
    ----------
    body : Silhouette
        The part, not turned.
    theta : float
        Its orientation relative to the gripper, in radians.
    gripper : float
        The gripper's own angle, in radians.
    closed : bool
        Whether the jaws touch the part; else they stand open.
    pushing : bool
        Whether the lower jaw is marked as the one that pushes.
    """

    body: Silhouette
    theta: float
    gripper: float = 0.0
    closed: bool = True
    pushing: bool = False

    @property
    def turned(self) -> Silhouette:
        """The part in the gripper's frame."""
        return self.body.turned(self.theta)

    @property
    def gap(self) -> tuple[float, float]:
        """Where the lower and the upper jaw are, in the gripper's frame."""
        part = self.turned
        return (part.bottom, part.top) if self.closed else (-OPEN_GAP, OPEN_GAP)


def part_shapes(body: Silhouette, *, heading: bool = True, style: str = "part") -> list[Shape]:
    """Return the outline, the holes and the centre of mass of a part as it stands.

    A line from the centre of mass to vertex 0 tells orientations apart that look alike.
    """
    shapes: list[Shape] = [Polygon(points_of(body.outline.tolist()), style)]
    shapes += [Polygon(points_of(hole.tolist()), "hole") for hole in body.holes]
    if heading:
        first: XY = (float(body.outline[0, 0]), float(body.outline[0, 1]))
        shapes += [
            Line((body.mass, first), "heading"),
            Disc(first, 0.045, "vertex"),
            Disc(body.mass, 0.06, "mass"),
        ]
    return shapes


def hull_shape(body: Silhouette) -> Polygon:
    """Return the convex hull as it stands."""
    return Polygon(points_of(body.hull.tolist()), "hull")


def jaw_shapes(pose: Pose) -> list[Shape]:
    """Return the two jaws, lower first, in the gripper's frame.

    A stub on the lower one tells the gripper from itself half a turn later.
    """
    low, high = pose.gap
    idle = "jaw" if pose.closed else "open"
    outside, stub = low - JAW_THICKNESS, low - JAW_THICKNESS - STUB
    lower = ((-JAW_HALF, low), (JAW_HALF, low), (JAW_HALF, outside), (1.2 * STUB, outside),
             (0.8 * STUB, stub), (-0.8 * STUB, stub), (-1.2 * STUB, outside),
             (-JAW_HALF, outside))  # fmt: skip
    return [
        Polygon(lower, "pushing" if pose.pushing else idle),
        rectangle((-JAW_HALF, high), (JAW_HALF, high + JAW_THICKNESS), idle),
    ]


def contact_shapes(pose: Pose) -> list[Shape]:
    """Return the points where closed jaws touch: a vertex, or both ends of a flush edge."""
    part = pose.turned
    touching: list[Shape] = []
    for level in (part.bottom, part.top):
        touching += [
            Disc((float(x), float(y)), CONTACT_SIZE, "contact")
            for x, y in part.hull
            if abs(float(y) - level) < _FLUSH
        ]
    return touching


def pose_shapes(pose: Pose, *, heading: bool = True, contacts: bool = False) -> list[Shape]:
    """Return part and jaws, turned by the gripper's angle."""
    shapes = jaw_shapes(pose) + part_shapes(pose.turned, heading=heading)
    if contacts:
        shapes += contact_shapes(pose)
    return turn_shapes(shapes, pose.gripper)


def turn_shapes(shapes: list[Shape], angle: float) -> list[Shape]:
    """Return shapes without text turned counter-clockwise about (0, 0) by radians."""
    if not angle:
        return shapes
    turn = rotation(angle)
    scene = Scene()
    for shape in shapes:
        if isinstance(shape, Disc):
            scene.add(Disc(_turned([shape.center], turn)[0], shape.radius, shape.style))
        elif isinstance(shape, Polygon):
            scene.add(Polygon(_turned(shape.points, turn), shape.style))
        elif isinstance(shape, Line):
            scene.add(Line(_turned(shape.points, turn), shape.style))
    return scene.shapes


def _turned(points: list[XY] | tuple[XY, ...], turn: FloatArray) -> tuple[XY, ...]:
    return points_of((np.array(points) @ turn.T).tolist())
