"""Scenes of one part: by itself, and between the jaws."""

from __future__ import annotations

from stochgeom.geometry.part import Part
from stochgeom.plotting.grasps import hull_shape, part_shapes
from stochgeom.plotting.scene import Scene
from stochgeom.plotting.silhouettes import silhouette


def part_scene(part: Part, *, hull: bool = True, most: int = 600) -> Scene:
    """Return the outline, the hull where it differs, the centre of mass and vertex 0."""
    body = silhouette(part, most)
    scene = Scene(part_shapes(body))
    if hull and len(part.hull) < len(part):
        scene.add(hull_shape(body))
    return scene
