"""Figures 4.4 to 4.6, and what chapter 4 says about squeeze functions and their periods."""

from __future__ import annotations

from fractions import Fraction

import pytest
from gmpy2 import mpq
from hypothesis import Phase, find, given, settings
from hypothesis import strategies as st

from stochgeom.exact.angles import HALF_TURN, QUARTER_TURN, ZERO, Angle
from stochgeom.exact.ratios import TurnRatio
from stochgeom.feeding.execution import composite
from stochgeom.feeding.planner import FeedingProblem, orient_up_to_symmetry, plan_feeding
from stochgeom.geometry.part import Part
from stochgeom.plotting.source_figures import RECTANGLE_STARTS
from stochgeom.thesis.figures_4 import figure_4_5
from stochgeom.thesis.parts import catalogue_part
from stochgeom.transfer.squeeze import squeeze_function
from tests.strategies import directions, fractions, points, rational_points


def rounded_prior(transfer, angles=(ZERO,)):
    """Return the distribution over all stable orientations, by decreasing theta, 2 decimals.

    That is the order of the source: by increasing angle of the jaws in the part's frame.
    """
    found = dict.fromkeys(turned_copies(transfer, transfer.values), ZERO)
    whole = composite(transfer, angles)
    for theta, width in zip(whole.values, whole.widths, strict=True):
        for copy in turned_copies(whole, [theta]):
            found[copy] += width
    return [
        TurnRatio(mpq(1), found[theta]).decimal(2) if found[theta] else "0.00"
        for theta in sorted(found, reverse=True)
    ]


def turned_copies(transfer, orientations):
    """Return orientations in [0, 360) degrees with those that the function cannot tell apart."""
    turns = range(transfer.order)
    return [(theta + transfer.period * k).reduced() for theta in orientations for k in turns]


def rotations(row):
    return [row[k:] + row[:k] for k in range(len(row))]


class TestFigure41:
    """The rectangle (Fig. 1.1 as well): four initial orientations, one final one."""

    plan = FeedingProblem(catalogue_part("rectangle")).geometric_plan()
    starts = tuple(map(Angle.from_degrees, RECTANGLE_STARTS))

    def test_all_four_traces_end_alike(self):
        assert self.plan.steps == 2
        traces = [self.plan.execute(start) for start in self.starts]
        assert len({trace[0] for trace in traces}) == 4
        assert len({trace[1] for trace in traces}) == 2  # one squeeze is not enough
        assert {trace[-1] for trace in traces} == {HALF_TURN}

    def test_starts_elsewhere_end_half_a_turn_away(self):
        ends = {self.plan.execute(start + HALF_TURN)[-1].reduced() for start in self.starts}
        assert ends == {ZERO}


class TestFigure45:
    """The house: a random squeeze, then one at 45 degrees."""

    problem = FeedingProblem(catalogue_part("house"))

    def test_the_second_angle_is_exactly_45_degrees(self):
        second = self.problem.geometric_plan().actions[1]
        assert second.low + second.high == Angle.from_degrees(90)
        assert second.angle == Angle.from_degrees(45)
        assert (second.low, second.high) == (Angle(0, (3, 1)), Angle(0, (1, 3)))

    def test_the_distribution(self):
        transfer = self.problem.transfer
        assert ["0.40", "0.10", "0.40", "0.10"] in rotations(rounded_prior(transfer))
        after = rounded_prior(transfer, [ZERO, Angle.from_degrees(45)])
        assert sorted(after) == ["0.00", "0.00", "0.50", "0.50"]
        assert after[:2] == after[2:]

    def test_the_costs_in_the_text(self):
        """5.0 = 2 / .40 for one step, 6.0 = 3 / .50 for two; one step is optimal."""
        assert [self.problem.expected_cost(i).decimal(1) for i in (1, 2)] == ["5.0", "6.0"]
        assert self.problem.probability(1).decimal(2) == "0.40"
        assert self.problem.probability(2).rational == Fraction(1, 2)
        assert self.problem.optimal_plan().steps == 1

    def test_what_the_source_prints_is_judged_and_nothing_else(self):
        """The caption has 45; the text has .40, .50, 2.5 and 2.0 rounds, 5.0 and 6.0."""
        found = figure_4_5()
        printed = [cell.printed for cell in found.cells]
        assert printed == ["45", "0.40", "0.50", "5.0", "6.0", "2.5", "2.0"]
        assert all(cell.agrees for cell in found.cells)
        assert sum(len(row.cells) for row in found.rows) == 8  # six of them computed only

    def test_rounds_are_the_inverse_of_the_probability(self):
        rounds = [cell.computed for cell in figure_4_5().rounds]
        for steps, mean in enumerate(rounds, start=1):
            assert (steps + 1) * mean.coefficient == self.problem.expected_cost(steps).coefficient
            assert mean.angle == self.problem.preimages.of_steps(steps).width
        assert rounds[1].rational == 2


class TestFigure46:
    """The 4gon: squeezes at random, 71, 35 and 8 degrees (cumulative)."""

    rows = (
        ["0.12", "0.14", "0.11", "0.13"] * 2,
        ["0.00", "0.25", "0.00", "0.25"] * 2,
        ["0.00", "0.25", "0.25", "0.00"] * 2,
        ["0.00", "0.50", "0.00", "0.00"] * 2,
    )
    problem = FeedingProblem(catalogue_part("4gon"))

    def test_the_distribution_after_the_random_squeeze(self):
        found = rounded_prior(self.problem.transfer)
        assert self.rows[0] in rotations(found) + rotations(found[::-1])

    def test_the_trace_of_the_printed_plan(self):
        """The printed angles, as they stand, give the printed distributions in the same states."""
        turns = [0, 71, 35 - 71, 8 - 35]
        angles = [Angle.from_degrees(turn) for turn in turns]
        transfer = self.problem.transfer
        found = [rounded_prior(transfer, angles[: k + 1]) for k in range(4)]
        shift = rotations(found[0]).index(self.rows[0])
        assert [row[shift:] + row[:shift] for row in found] == list(self.rows)

    def test_the_printed_plan_is_one_of_two_equally_wide_ones(self):
        """The printed plan starts from the other of two arcs that are a period wide.

        Ours has the narrower image. The angles are the middles of the ranges, summed up.
        """
        chain = list(self.problem.preimages)
        assert [preimage.ties for preimage in chain] == [1, 1, 1, 2]
        cumulative = self.middles_summed(self.other_image(chain[-1]), chain[2::-1])
        for twice, printed in zip(cumulative, (71, 35, 8), strict=True):
            assert Angle.from_degrees(2 * printed - 1) < twice < Angle.from_degrees(2 * printed + 1)
        ours = self.middles_summed(chain[-1].image, chain[2::-1])
        assert ours != cumulative
        assert chain[-1].image_width < self.width(self.other_image(chain[-1]))

    def other_image(self, preimage):
        """Return the first and last orientation of the image of the other arc."""
        transfer = self.problem.transfer
        values, size = transfer.lifted_values, len(transfer)
        limit = self.problem.preimages.of_steps(3).width
        images = [(values[j], values[j + size - 1]) for j in range(size)]
        fitting = [image for image in images if self.width(image) < limit]
        assert len(fitting) == preimage.ties == 2
        (other,) = (image for image in fitting if image[0] != preimage.image.start)
        return other

    @staticmethod
    def width(image):
        return image[1] - image[0]

    @staticmethod
    def middles_summed(image, goals):
        """Return the running sums of twice the middles of the ranges."""
        start, end = image if isinstance(image, tuple) else (image.start, image.end)
        total, sums = ZERO, []
        for goal in goals:
            total += (end - goal.arc.end) + (start - goal.arc.start)
            sums.append(total)
            start, end = goal.image.start, goal.image.end
        return sums

    def test_the_four_step_plan_is_optimal(self):
        plan = self.problem.optimal_plan()
        assert plan.steps == 4
        assert plan.orients_up_to_symmetry
        assert plan.expected_cost.rational == 10


def least_dot_product(corners):
    """Return a number positive, zero or negative as a triangle is acute, right or obtuse."""
    return min(
        sum(
            (corners[k - 1][i] - corners[k][i]) * (corners[k - 2][i] - corners[k][i])
            for i in (0, 1)
        )
        for k in range(3)
    )


def is_triangle(corners):
    (ax, ay), (bx, by), (cx, cy) = corners
    return (bx - ax) * (cy - ay) != (by - ay) * (cx - ax)


ONE_STEP = squeeze_function([(0, 0), (5, 0), (-1, 1)])
"""The squeeze function of an obtuse triangle: one step in half a turn, its value in the middle."""

triangles = st.one_of(
    st.lists(points, min_size=3, max_size=3), st.lists(rational_points, min_size=3, max_size=3)
).filter(is_triangle)

right_triangles = st.builds(
    lambda origin, leg, ratio: [
        origin,
        (origin[0] + leg[0], origin[1] + leg[1]),
        (origin[0] - ratio * leg[1], origin[1] + ratio * leg[0]),
    ],
    points,
    directions,
    fractions.filter(bool),
)


class TestSharedSqueezeFunctions:
    """4.4.2: all obtuse triangles share one squeeze function (and right ones share it, too)."""

    def test_it_has_one_step(self):
        assert len(ONE_STEP) == 1
        assert ONE_STEP.period == HALF_TURN
        assert ONE_STEP.values[0] - ONE_STEP.breaks[0] == QUARTER_TURN

    @given(triangles)
    def test_triangles_share_it_unless_they_are_acute(self, corners):
        transfer = squeeze_function(corners)
        is_acute = least_dot_product(corners) > 0
        assert transfer.equals_up_to_rotation(ONE_STEP) is not is_acute
        assert len(transfer) == (3 if is_acute else 1)

    @given(right_triangles)
    def test_right_triangles_share_it(self, corners):
        assert least_dot_product(corners) == 0
        assert squeeze_function(corners).equals_up_to_rotation(ONE_STEP)

    @pytest.mark.parametrize("sign", [-1, 1], ids=["obtuse", "acute"])
    def test_the_triangles_tried_are_of_all_kinds(self, sign):
        quickly = settings(max_examples=500, phases=[Phase.generate], database=None)
        find(triangles, lambda corners: sign * least_dot_product(corners) > 0, settings=quickly)

    def test_equal_periods_do_not_make_functions_equal(self):
        square, cut = [(0, 0), (2, 0), (2, 2), (0, 2)], [(0, 0), (2, 0), (2, 1), (1, 2), (0, 1)]
        assert not squeeze_function(square).equals_up_to_rotation(squeeze_function(cut))


class TestOneSqueezeIsEnough:
    """Fig. 5.1 tests h_i = T from the second stage on; here it holds at the first."""

    @pytest.mark.parametrize(
        ("corners", "period"),
        [
            ([(0, 0), (1, 0), (1, 1), (0, 1)], 90),
            ([(0, 0), (2, 1), (1, 3), (-1, 2)], 90),
            ([(0, 0), (1, 0), (0, 1)], 180),
            ([(0, 0), (4, 0), (0, 3)], 180),
            ([(0, 0), (5, 0), (-1, 1)], 180),
        ],
        ids=["square", "tilted square", "half a square", "3-4-5", "obtuse"],
    )
    def test_squares_right_and_obtuse_triangles(self, corners, period):
        plan = orient_up_to_symmetry(corners)
        assert plan.steps == 1
        assert plan.transfer.period == Angle.from_degrees(period)
        assert plan.orients_up_to_symmetry
        assert plan.verify()
        optimal = plan_feeding(corners)
        assert optimal.steps == 1
        assert optimal.expected_cost.rational == 2 * 360 / Fraction(period)
        assert optimal.expected_cost_up_to_symmetry.rational == 2


class TestPeriodAndSymmetry:
    """T_r is a period; the smallest divides it (errata)."""

    corners = ((0, 0), (2, 0), (2, 1), (1, 2), (0, 1))

    def test_a_part_without_rotational_symmetry_and_a_period_of_90_degrees(self):
        assert self.rotational_symmetry() == 1
        transfer = squeeze_function(self.corners)
        assert transfer.period == QUARTER_TURN
        assert transfer.order == 4

    def rotational_symmetry(self):
        """Count the quarter turns about the centroid that carry the corners to themselves."""
        part = Part(self.corners)
        cx, cy = part.center_of_mass
        centred = {(x - cx, y - cy) for x, y in part.vertices}
        turned, count = centred, 0
        for _ in range(4):
            turned = {(-y, x) for x, y in turned}
            count += turned == centred
        return count

    @pytest.mark.parametrize(
        ("corners", "order"),
        [
            ([(0, 0), (1, 0), (1, 1), (0, 1)], 4),
            ([(0, 0), (3, 0), (3, 2), (0, 2)], 2),
            ([(0, 0), (3, 0), (4, 2), (1, 2)], 2),
            ([(2, 1), (1, 2), (-1, 2), (-2, 1), (-2, -1), (-1, -2), (1, -2), (2, -1)], 4),
        ],
        ids=["square", "rectangle", "parallelogram", "octagon"],
    )
    def test_symmetric_parts(self, corners, order):
        assert squeeze_function(corners).order == order
