"""Worked cases of arcs: half open, closed, and their unions."""

from __future__ import annotations

import dataclasses
import pickle

import pytest

from stochgeom.errors import InvalidArcError
from stochgeom.exact.angles import FULL_TURN, HALF_TURN, QUARTER_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc, ClosedArc, union_arcs, union_measure
from tests.strategies import TINY


def deg(value):
    return Angle.from_degrees(value)


def arc(start, width):
    return Arc(deg(start), deg(width))


def spans(arcs):
    return [(a.start, a.width) for a in arcs]


def pairs(*bounds):
    return [(deg(start), deg(width)) for start, width in bounds]


# --- half open -----------------------------------------------------------------------------------


@pytest.mark.parametrize("width", [ZERO, -TINY, deg(-10), FULL_TURN + TINY, deg(720)])
def test_widths_are_positive_and_at_most_one_turn(width):
    with pytest.raises(InvalidArcError, match="accepted: more than 0, at most 360°"):
        Arc(ZERO, width)


@pytest.mark.parametrize(("start", "width"), [(0, deg(9)), ("0", deg(9)), (ZERO, 9), (ZERO, 0.5)])
def test_ends_are_angles(start, width):
    with pytest.raises(InvalidArcError, match="wide; accepted: two Angles"):
        Arc(start, width)


def test_an_arc_is_a_value():
    a = arc(350, 20)
    assert a == arc(350, 20)
    assert hash(a) == hash(arc(350, 20))
    assert a != arc(-10, 20)  # lifted
    assert pickle.loads(pickle.dumps(a)) == a
    assert eval(repr(a)) == a
    with pytest.raises(dataclasses.FrozenInstanceError):
        a.start = ZERO


def test_the_start_belongs_to_an_arc_and_the_end_does_not():
    a = arc(350, 20)
    assert a.end == deg(370)
    assert [a.contains(deg(d)) for d in (349, 350, 355, 360, 0, 9, 10, 11, 180)] == [
        *[False, True, True, True, True, True, False, False, False]
    ]
    assert a.contains(a.end - TINY)
    assert not a.contains(a.end)
    assert not a.contains(a.start - TINY)
    assert a.contains(a.start + 7 * FULL_TURN)


def test_a_full_turn_contains_everything():
    for start in (ZERO, deg(71), Angle(-3, (3, 2))):
        full = Arc(start, FULL_TURN)
        assert full.contains(start)
        assert full.contains(start - TINY)
        assert full.contains(deg(123))
        assert full.intersects(Arc(deg(200), TINY))
        assert Arc(deg(200), TINY).intersects(full)
    assert not Arc(ZERO, FULL_TURN - TINY).contains(-TINY)


def test_arcs_that_touch_do_not_intersect():
    a = arc(350, 20)
    assert not a.intersects(arc(10, 5))
    assert not a.intersects(arc(340, 10))
    assert a.intersects(Arc(deg(10) - TINY, TINY))
    assert not a.intersects(Arc(deg(350) - TINY, TINY))
    assert a.intersects(Arc(deg(350) - TINY, 2 * TINY))
    assert a.intersects(arc(355, 1))
    assert arc(0, 180).intersects(arc(90, 300))
    assert not arc(0, 180).intersects(arc(180, 180))


def test_rotation_keeps_the_width():
    assert arc(350, 20).rotate(deg(-360)) == arc(-10, 20)
    assert arc(350, 20).rotate(TINY) == Arc(deg(350) + TINY, deg(20))


def test_split_at_the_period():
    assert spans(arc(350, 20).split()) == pairs((0, 10), (350, 10))
    assert spans(arc(350, 10).split()) == pairs((350, 10))  # ends at the period
    assert spans(arc(720, 10).split()) == pairs((0, 10))
    assert spans(arc(-10, 5).split()) == pairs((350, 5))
    assert spans(arc(170, 20).split(HALF_TURN)) == pairs((0, 10), (170, 10))
    assert spans(arc(400, 30).split(QUARTER_TURN)) == pairs((40, 30))
    assert spans(arc(85, 100).split(QUARTER_TURN)) == pairs((0, 90))
    assert spans(arc(85, 90).split(QUARTER_TURN)) == pairs((0, 90))
    assert spans(arc(77, 360).split()) == pairs((0, 360))
    assert spans(arc(350, 20).split(2 * FULL_TURN)) == pairs((350, 20))


# --- unions --------------------------------------------------------------------------------------


def test_union_by_hand():
    arcs = [arc(350, 20), arc(5, 10), arc(100, 10), arc(110, 5), arc(101, 2)]
    assert spans(union_arcs(arcs)) == pairs((0, 15), (100, 15), (350, 10))
    assert union_measure(arcs) == deg(40)
    assert union_arcs([]) == ()
    assert union_measure([]) == ZERO
    assert spans(union_arcs([arc(90, 270), arc(0, 90)])) == pairs((0, 360))
    assert union_measure([arc(10, 360), arc(20, 5)]) == FULL_TURN


def test_a_gap_of_almost_nothing_is_a_gap():
    arcs = [arc(0, 10), Arc(deg(10) + TINY, deg(10))]
    assert len(union_arcs(arcs)) == 2
    assert union_measure(arcs) == deg(20)
    assert union_measure([*arcs, Arc(deg(5), deg(5) + TINY)]) == deg(20) + TINY


def test_union_on_a_smaller_circle():
    arcs = [arc(80, 20), arc(170, 20), arc(200, 10)]
    assert spans(union_arcs(arcs, QUARTER_TURN)) == pairs((0, 10), (20, 10), (80, 10))
    assert union_measure([arc(0, 95)], QUARTER_TURN) == QUARTER_TURN


# --- closed --------------------------------------------------------------------------------------


def test_closed_arcs():
    image = ClosedArc(deg(10), ZERO)
    assert image.end == image.start
    assert ClosedArc(deg(10), deg(500)).end == deg(510)
    assert image.rotate(deg(5)) == ClosedArc(deg(15), ZERO)
    assert image == ClosedArc(deg(10), ZERO)
    assert hash(image) == hash(ClosedArc(deg(10), ZERO))
    assert image != Arc(deg(10), TINY)
    with pytest.raises(InvalidArcError, match="accepted: 0 or more"):
        ClosedArc(deg(10), -TINY)
