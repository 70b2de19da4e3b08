"""Sets of orientations with closed ends, open ends and single points."""

from __future__ import annotations

import pickle

import pytest

from stochgeom.errors import InvalidArcError
from stochgeom.exact.angles import FULL_TURN, HALF_TURN, QUARTER_TURN, ZERO, Angle
from stochgeom.exact.cells import CellSet, merge
from stochgeom.exact.intervals import Interval


def degrees(value):
    return Angle.from_degrees(value)


def interval(start, end, brackets="[]"):
    return Interval(
        degrees(start), degrees(end) - degrees(start), brackets[0] == "[", brackets[1] == "]"
    )


class TestInterval:
    def test_parts(self):
        item = interval(350, 370, "[)")
        assert (item.end, item.is_closed, str(item)) == (
            degrees(370),
            False,
            "[350.0000°, 370.0000°)",
        )

    def test_a_single_orientation(self):
        assert interval(20, 20).is_closed

    @pytest.mark.parametrize("brackets", ["()", "[)", "(]"])
    def test_nothing_is_no_interval(self, brackets):
        with pytest.raises(InvalidArcError, match="empty"):
            interval(20, 20, brackets)

    @pytest.mark.parametrize("end", [10, 381])
    def test_other_widths_are_refused(self, end):
        with pytest.raises(InvalidArcError, match="from 0 to 360"):
            interval(20, end)

    def test_shrunk_to_a_single_orientation_needs_both_ends(self):
        assert interval(0, 90).shrunk(degrees(45)) == interval(45, 45)
        assert interval(0, 90, "[)").shrunk(degrees(45)) is None
        assert interval(0, 90).shrunk(degrees(46)) is None


class TestCellSet:
    def test_critical_orientations_where_nothing_changes_are_dropped(self):
        cells = CellSet([ZERO, QUARTER_TURN, HALF_TURN], [True, True, False], [True, True, False])
        assert cells.angles == (ZERO, HALF_TURN)
        assert cells == CellSet([ZERO, HALF_TURN], [True, False], [True, False])

    def test_an_arc_over_zero(self):
        cells = CellSet.of([interval(350, 370, "(]")])
        assert ZERO in cells
        assert degrees(10) in cells
        assert degrees(350) not in cells
        assert cells.intervals() == (interval(350, 370, "(]"),)
        assert cells.measure.rational * 18 == 1

    def test_all_but_one_orientation(self):
        cells = ~CellSet.at([degrees(40)])
        assert cells.intervals() == (interval(40, 400, "()"),)
        assert cells.measure.rational == 1
        assert not cells.is_whole
        assert cells | CellSet.at([degrees(400)]) == CellSet.whole()

    def test_whole_and_empty(self):
        assert CellSet.whole().is_whole
        assert CellSet.whole().intervals() == (Interval(ZERO, FULL_TURN, True, True),)
        assert not CellSet.empty()
        assert CellSet.empty().intervals() == CellSet.empty().widest() == ()
        assert CellSet.of([]) == CellSet.at([]) == CellSet.empty() == ~CellSet.whole()
        assert CellSet.of(CellSet.whole()) == CellSet.whole()

    def test_intervals_that_touch_at_a_taken_end_are_one(self):
        assert CellSet.of([interval(0, 40, "[)"), interval(40, 60)]) == CellSet.of(
            [interval(0, 60)]
        )
        apart = CellSet.of([interval(0, 40, "[)"), interval(40, 60, "(]")])
        assert len(apart.intervals()) == 2
        assert degrees(40) not in apart

    def test_widest_are_compared_exactly(self):
        narrow = Interval(degrees(90), Angle(0, (10**40, 1)), True, True)
        wide = Interval(degrees(180), Angle(0, (10**40 - 1, 1)), True, True)
        assert CellSet.of([narrow, wide]).widest() == (wide,)

    def test_half_open_arcs_leave_single_orientations_out(self):
        cells = CellSet.of([interval(0, 40), interval(90, 90)])
        assert [(arc.start, arc.width) for arc in cells.half_open()] == [(ZERO, degrees(40))]

    def test_literals(self):
        cells = CellSet.of([interval(10, 20, "(]"), interval(90, 90)])
        assert eval(repr(cells)) == cells
        assert str(cells) == "{(10.0000°, 20.0000°], [90.0000°, 90.0000°]}"
        assert pickle.loads(pickle.dumps(cells)) == cells

    def test_values_do_not_change(self):
        with pytest.raises(AttributeError):
            CellSet.empty().arcs = (True,)
        with pytest.raises(AttributeError):
            del CellSet.empty().arcs

    def test_only_angles_are_members(self):
        assert 0 not in CellSet.whole()

    @pytest.mark.parametrize(
        ("angles", "points", "arcs"),
        [
            ([ZERO], [], [True]),
            ([ZERO], [True], []),
            ([], [], []),
            ([QUARTER_TURN, ZERO], [True] * 2, [True] * 2),
            ([ZERO, ZERO], [True] * 2, [True] * 2),
            ([FULL_TURN], [True], [True]),
            ([-QUARTER_TURN], [True], [True]),
        ],
    )
    def test_cells_that_are_none_are_refused(self, angles, points, arcs):
        with pytest.raises(InvalidArcError, match="accepted"):
            CellSet(angles, points, arcs)


def test_merge_keeps_order_and_joins_equals():
    first, second = [degrees(k) for k in (0, 30, 90)], [degrees(k) for k in (30, 60, 120)]
    assert merge(first, second) == [degrees(k) for k in (0, 30, 60, 90, 120)]
