"""What tests ask of scenes: which labels overlap, and whether SVG text is a picture by itself."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from itertools import combinations

from stochgeom.plotting.scene import Label, Scene, box_of

SVG = "{http://www.w3.org/2000/svg}"


def overlapping_labels(scene: Scene, slack: float = 0.02) -> list[tuple[str, str]]:
    """Return the pairs of texts whose boxes share more than a sliver of their size."""
    labels = [shape for shape in scene.shapes if isinstance(shape, Label)]
    return [
        (one.text, other.text)
        for one, other in combinations(labels, 2)
        if _overlap(one, other, slack * max(one.size, other.size))
    ]


def _overlap(one: Label, other: Label, slack: float) -> bool:
    (a, b), (c, d) = box_of(one)
    (e, f), (g, h) = box_of(other)
    return min(c, g) - max(a, e) > slack and min(d, h) - max(b, f) > slack


def parsed(text: str) -> ET.Element:
    """Return an SVG document's root after checking that it asks for nothing from outside."""
    assert "href" not in text
    assert "url(" not in text
    assert "<script" not in text
    root = ET.fromstring(text)
    assert root.tag == f"{SVG}svg"
    assert root.find(f"{SVG}title") is not None
    return root
