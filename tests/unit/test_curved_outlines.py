"""What docs/howto/outlines.md says of arcs: none is read, and which chords do no harm.

Thesis, Def. 4.1 and app. D.1, where curved parts are left for later.
"""

from __future__ import annotations

import math

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

import stochgeom as sg
from stochgeom.errors import FormatError, StochgeomError
from tests.repo.sources import ROOT

PAGE = (ROOT / "docs" / "howto" / "outlines.md").read_text(encoding="utf-8")

DXF = "  0\nSECTION\n  2\nENTITIES\n  0\nARC\n 10\n0.0\n 20\n0.0\n 40\n1.0\n 50\n0\n 51\n90\n"
SVG = '<?xml version="1.0"?>\n<svg><path d="M 0 0 A 1 1 0 0 1 1 1 Z"/></svg>'


class TestRefused:
    @pytest.mark.parametrize(
        "word",
        ["CIRCULARSTRING", "COMPOUNDCURVE", "CURVE", "CURVEPOLYGON", "MULTICURVE", "MULTISURFACE"],
    )
    def test_curves_as_well_known_text(self, word):
        """A reader that skipped the word would take the points of the arc for corners."""
        with pytest.raises(FormatError, match=f"'{word}' is not read; accepted: one POLYGON"):
            sg.parse_outline(f"{word} ((0 0, 4 0, 4 4, 0 4, 0 0))")

    @pytest.mark.parametrize("key", ["bulge", "bulges", "Bulges", "arcs", "curve", "curves"])
    @pytest.mark.parametrize(
        "outline",
        [
            '"vertices": [[0, 0], [4, 0], [4, 4]]',
            '"type": "Polygon", "coordinates": [[[0, 0], [4, 0], [4, 4], [0, 0]]]',
        ],
    )
    def test_curved_edges_in_json(self, outline, key):
        assert len(sg.parse_outline(f"{{{outline}}}").vertices) == 3
        with pytest.raises(FormatError, match=f"key '{key}': curved edges are not read; accepted"):
            sg.parse_outline(f'{{{outline}, "{key}": [0, 0.5, 0]}}')

    @pytest.mark.parametrize(
        "text", [DXF, DXF.strip(), SVG, "M 0 0 A 1 1 0 0 1 1 1 Z", "G02 X1 Y1 I1 J0\nG01 X0 Y0"]
    )
    def test_files_of_other_kinds(self, text):
        with pytest.raises(StochgeomError, match=r"line 1.*accepted"):
            sg.parse_outline(text)

    def test_the_page_shows_the_messages(self):
        for text in (
            "CURVEPOLYGON (CIRCULARSTRING (0 0, 4 0, 4 4, 0 4, 0 0))",
            '{"vertices": [[0, 0], [4, 0], [4, 4]], "bulges": [0, "1/2", 0]}',
        ):
            with pytest.raises(FormatError) as caught:
                sg.parse_outline(text)
            assert text in PAGE
            assert str(caught.value) in PAGE


class TestChords:
    @given(st.lists(st.tuples(st.integers(3, 13), st.integers(3, 8)), min_size=1, max_size=4))
    @settings(max_examples=60)
    def test_inside_the_hull_they_do_no_harm(self, notch):
        """Whatever stands in the place of a notch, jaws never touch it."""
        # From left to right, each once: the notch then does not cross itself.
        inner = [(x, min(y for at, y in notch if at == x)) for x in sorted({x for x, _ in notch})]
        top = [(16, 10), *reversed(inner), (0, 9)]
        part = sg.Part([(0, 0), (16, 0), *top])
        whole = sg.Part([(0, 0), (16, 0), (16, 10), (0, 9)])
        assert sg.squeeze_function(part) == sg.squeeze_function(whole)

    @pytest.mark.parametrize("sides", [4, 6, 8, 12, 16])
    def test_on_the_hull_they_are_another_part(self, sides):
        """Chords of a disc can be oriented, are as near as the page says, and no proof covers it.

        The disc is nearer to the polygon than the error of the vertices that the plan is proven to
        survive; but no squeeze turns a disc.
        """
        polygon = sg.Part.regular(sides)
        plan = sg.orient_up_to_symmetry(polygon)
        assert plan.orients_up_to_symmetry
        (ax, ay), (bx, by) = polygon.vertices[:2]
        middle = (ax + bx) ** 2 / 4 + (ay + by) ** 2 / 4
        # r (1 - cos(a/2)) for a = 2 pi / sides: the cosine is the distance of the middle.
        assert float(middle) ** 0.5 == pytest.approx(math.cos(math.pi / sides))
        assert middle > (1 - sg.tolerance_of(plan)) ** 2
