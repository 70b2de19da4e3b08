"""The bounds as functions of the friction: breakpoints, jumps, largest friction, regular parts."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise

import pytest

from stochgeom.errors import CenterOfMassError, FrictionError, PriorError, TooFewVerticesError
from stochgeom.exact.angles import HALF_TURN, ZERO, Angle
from stochgeom.exact.sums import AngleSum
from stochgeom.geometry.part import Part
from stochgeom.grasping.friction_bounds import GuaranteedBound
from stochgeom.grasping.moving_ends import Gap, Piece, common_pieces, gap_between, lesser
from stochgeom.grasping.pushing_over_friction import PushingBound
from stochgeom.grasping.regular import regular_bound
from stochgeom.thesis.parts import catalogue_part

SQUARE = Part([(0, 0), (1, 0), (1, 1), (0, 1)])
TINY = Angle(0, (10**30, 1))


def degrees(value):
    return Angle.from_degrees(value)


class TestMovingEnds:
    FALLING = (Piece(ZERO, degrees(90), -1),)
    STILL = (Piece(ZERO, degrees(60), 0),)
    RISING = (Piece(ZERO, degrees(10), 1),)

    def test_the_lesser_of_two_changes_where_they_meet(self):
        """90 - alpha falls to 60 at alpha = 30: delta = 60."""
        assert lesser(self.FALLING, self.STILL) == [
            Piece(ZERO, degrees(60), 0),
            Piece(degrees(60), degrees(90), -1),
        ]
        assert lesser(self.FALLING, self.STILL, -1) == [
            Piece(ZERO, degrees(90), -1),
            Piece(degrees(60), degrees(60), 0),
        ]

    def test_equal_ends_are_one(self):
        assert lesser(self.STILL, self.STILL) == list(self.STILL)

    def test_a_gap_closes_at_half_an_angle(self):
        """90 - alpha and 10 + alpha meet at 40 degrees: delta = 80."""
        assert gap_between(self.RISING, self.FALLING) == [
            Gap(ZERO, (degrees(10), degrees(90)), -2),
            Gap(degrees(80), None, 0),
        ]

    def test_a_gap_that_never_was(self):
        assert gap_between(self.STILL, self.RISING) == [Gap(ZERO, None, 0)]

    def test_common_pieces(self):
        two = (Piece(ZERO, ZERO, 0), Piece(degrees(40), ZERO, 1))
        assert list(common_pieces(two, self.STILL)) == [
            (ZERO, degrees(40), 0, 0),
            (degrees(40), HALF_TURN, 1, 0),
        ]


class TestGuaranteedBound:
    def test_the_square(self):
        bound = GuaranteedBound(SQUARE)
        (last,) = bound.breakpoints
        assert last.angle == degrees(45)
        assert bound.limit.rational == 1
        assert bound(1).rational == bound(5).rational == 0
        assert bound(Angle.from_degrees(30)).rational * 3 == 1

    def test_breakpoints_are_where_the_form_changes(self):
        """Each is needed: about it the bound bends or jumps."""
        bound = GuaranteedBound(catalogue_part("5gon"))
        assert len(bound.breakpoints) == 8
        for half in bound.breakpoints:
            alpha, step = half.nearby, Angle(0, (10**4, 1))
            values = [bound(alpha + step * k) for k in (-2, -1, 1, 2)]
            before, across, after = (b - a for a, b in pairwise(values))
            assert before.compare(after) != 0 or float(across) < -1e-3

    def test_a_jump_belongs_to_the_left(self):
        """At the breakpoint nothing more wedges yet: wedging is strict."""
        jumps = 0
        for name in ("house", "5gon", "wrench", "tuning-fork"):
            bound = GuaranteedBound(catalogue_part(name))
            for half in bound.breakpoints:
                alpha = half.angle
                if alpha is None:
                    continue
                here, after = bound(alpha), bound(alpha + TINY)
                assert abs(float(bound(alpha - TINY)) - float(here)) < 1e-12
                jumps += float(here) - float(after) > 1e-6
        assert jumps

    def test_largest_friction(self):
        bound = GuaranteedBound(SQUARE)
        half = bound.largest_friction("1/2")
        assert half.degrees(4) == "22.5000"
        assert half.compare("0.4142135") == 1
        assert half.compare("0.4142136") == -1
        assert bound.largest_friction(0) is None
        assert bound.largest_friction(1).compare(0) == 0

    def test_largest_friction_at_a_jump_is_exact(self):
        """For every probability that a jump leaps over, it is the breakpoint itself."""
        bound = GuaranteedBound(catalogue_part("5gon"))
        found = 0
        for half in bound.breakpoints:
            here, after = bound(half.nearby - TINY), bound(half.nearby + TINY)
            if float(here) - float(after) > 1e-3:
                between = Fraction(str(round((float(here) + float(after)) / 2, 6)))
                alpha = AngleSum.of(bound.largest_friction(between).turns)
                assert alpha.compare(AngleSum(0, [("1/2", half.doubled)])) == 0
                found += 1
        assert found

    def test_more_than_the_limit_needs_no_friction_at_all(self):
        assert GuaranteedBound(catalogue_part("triangle")).largest_friction("1/10").decimal() == (
            "0.0000"
        )
        assert GuaranteedBound(catalogue_part("triangle")).largest_friction(0) is None

    @pytest.mark.parametrize("make", [GuaranteedBound, PushingBound])
    def test_bad_input(self, make):
        with pytest.raises(CenterOfMassError):
            make(Part([(0, 0), (1, 0), (0, 1)], (2, 2)))
        with pytest.raises(FrictionError):
            make(SQUARE)("-0.1")
        with pytest.raises(PriorError):
            make(SQUARE).largest_friction("1.5")


class TestPushingBound:
    def test_exact_where_no_logarithm_is_left(self):
        bound = PushingBound(SQUARE)
        assert bound(0).rational == 1
        assert bound(1).rational == bound(7).rational == 0
        assert bound("1/2").rational is None

    def test_breakpoints_of_the_square(self):
        assert PushingBound(SQUARE).breakpoints == (degrees(45),)

    def test_largest_friction(self):
        bound = PushingBound(SQUARE)
        limit = bound.largest_friction("0.9")
        low = Fraction(limit.decimal(20))
        assert bound(low).compare("0.9") >= 0
        assert bound(low + Fraction(1, 10**20)).compare("0.9") < 0
        assert bound.largest_friction(0) is None
        assert bound.largest_friction(1).decimal(3) == "0.000"

    def test_largest_friction_at_a_breakpoint(self):
        """An exact value is recognised, though no enclosure would find it."""
        bound = PushingBound(SQUARE)
        assert bound.largest_friction("1e-30").degrees(8) == "45.00000000"


class TestRegular:
    def test_odd_ones_guarantee_nothing(self):
        assert regular_bound(3, "1e-9").rational == 0
        assert regular_bound(3, 0).rational == 1

    def test_even_ones(self):
        assert regular_bound(6, Angle.from_degrees(10)).rational * 3 == 2
        assert regular_bound(6, Angle.from_degrees(30)).rational == 0
        assert regular_bound(100, "1/100").decimal(6) == AngleSum(
            1, [(-200, Angle(0, (100, 1)))]
        ).decimal(6)

    @pytest.mark.parametrize("n", [2, 0, -4])
    def test_too_few_sides(self, n):
        with pytest.raises(TooFewVerticesError, match="from 3 on"):
            regular_bound(n, "1/4")

    def test_bad_friction(self):
        with pytest.raises(FrictionError):
            regular_bound(4, -1)
