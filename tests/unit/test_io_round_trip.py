"""What is written in any of the formats is read back as it was."""

from __future__ import annotations

import json

from gmpy2 import mpq
from hypothesis import given
from hypothesis import strategies as st

from stochgeom.exact.scalars import rational_text
from stochgeom.io.outlines import Outline, parse_outline, parse_point, parse_vertices

# Few small numbers, so that repeated vertices and vertices on an axis happen; some very large.
coordinates = st.one_of(
    st.builds(mpq, st.integers(-4, 4), st.integers(1, 3)),
    st.builds(mpq, st.integers(-(10**40), 10**40), st.integers(1, 10**40)),
)
decimals = st.builds(mpq, st.integers(-(10**9), 10**9), st.sampled_from([1, 2, 5, 10, 10**6]))
points = st.tuples(coordinates, coordinates)
names = st.none() | st.text(
    st.characters(codec="utf-8", exclude_categories=("Cc", "Cs", "Zl", "Zp")), min_size=1
)


def is_open(ring):
    return len(ring) == 1 or ring[0] != ring[-1]


rings = st.lists(points, min_size=1, max_size=8).map(tuple).filter(is_open)
decimal_rings = st.lists(st.tuples(decimals, decimals), min_size=1, max_size=8)
styles = {
    "separator": st.sampled_from([" ", ",", ";", "\t", " , ", "  "]),
    "line_end": st.sampled_from(["\n", "\r\n", "\r", " # note\n", "\n\n"]),
    "closed": st.booleans(),
}


def pair_texts(ring):
    return [[rational_text(x), rational_text(y)] for x, y in ring]


def written_ring(ring, closed):
    return [*ring, ring[0]] if closed else list(ring)


@given(ring=rings, **styles)
def test_plain_lines(ring, separator, line_end, closed):
    pairs = pair_texts(written_ring(ring, closed))
    assert parse_outline(line_end.join(map(separator.join, pairs))).vertices == ring


@given(
    ring=rings, form=st.sampled_from([(",", " "), (" ", ";"), (",", "; ")]), closed=st.booleans()
)
def test_vertices_on_one_line(ring, form, closed):
    inner, outer = form
    pairs = pair_texts(written_ring(ring, closed))
    # Without a second vertex nothing shows which of the two separators is which.
    end = outer if ";" in outer else ""
    assert parse_vertices(outer.join(map(inner.join, pairs)) + end.strip()) == ring


@given(point=points, separator=styles["separator"])
def test_a_point(point, separator):
    assert parse_point(separator.join(pair_texts([point])[0])) == point


@given(ring=rings, holes=st.lists(rings, max_size=2), closed=st.booleans())
def test_wkt(ring, holes, closed):
    bodies = [
        ", ".join(map(" ".join, pair_texts(written_ring(each, closed)))) for each in (ring, *holes)
    ]
    outline = parse_outline(f"POLYGON ({', '.join(f'({body})' for body in bodies)})")
    assert (outline.vertices, outline.holes) == (ring, tuple(holes))


@given(ring=rings, holes=st.lists(rings, max_size=2), center=st.none() | points, name=names)
def test_json(ring, holes, center, name):
    outline = Outline(ring, tuple(holes), center, name)
    part = {
        "vertices": pair_texts(ring),
        "holes": [pair_texts(hole) for hole in holes],
        "center_of_mass": center and pair_texts([center])[0],
        "name": name,
    }
    assert parse_outline(json.dumps(part)) == outline
    assert parse_outline(json.dumps({"schema": "stochgeom/plan/1", "part": part})) == outline
    geometry = {"type": "Polygon", "coordinates": [part["vertices"], *part["holes"]]}
    geometry |= {"center_of_mass": part["center_of_mass"], "name": name}
    assert parse_outline(json.dumps(geometry, ensure_ascii=False)) == outline


@given(ring=decimal_rings.map(tuple).filter(is_open))
def test_json_numbers_are_decimals(ring):
    text = ", ".join(f"[{float(x):.6f}, {float(y):.6f}]" for x, y in ring)
    assert parse_outline(f"[{text}]").vertices == ring
