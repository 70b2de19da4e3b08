"""Appendix E: push-grasps of the 4gon and the house, and what its print contradicts itself in."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise

import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from stochgeom.cli import table_command
from stochgeom.errors import UnknownPartError
from stochgeom.exact.angles import FULL_TURN, HALF_TURN, ZERO, Angle
from stochgeom.feeding.execution import composite
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.feeding.preimages import Preimage
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.geometry.part import Part
from stochgeom.thesis.appendix_e import figure_e_5, figure_e_8, push_grasp_analysis
from stochgeom.thesis.errata import APPENDIX_E
from stochgeom.thesis.evolutions import Evolution, HalfAngle, Probability
from stochgeom.thesis.parts import catalogue_entry, catalogue_names, catalogue_part
from stochgeom.thesis.tables import Cell
from stochgeom.transfer.step_function import StepFunction
from tests.commands import call
from tests.strategies import orientations, parts

E5, E8 = figure_e_5(), figure_e_8()

# --- the parts -----------------------------------------------------------------------------------


def test_only_the_house_has_another_centre_of_mass_in_appendix_e():
    differing = [
        name
        for name in catalogue_names()
        if catalogue_part(name, appendix="E") != catalogue_part(name)
    ]
    assert differing == ["house"]
    house, other = catalogue_part("house"), catalogue_part("house", appendix="E")
    assert (house.vertices, house.name) == (other.vertices, other.name)
    corners = other.vertices
    assert other.center_of_mass == tuple(sum(c) / mpq(5) for c in zip(*corners, strict=True))


@pytest.mark.parametrize("appendix", ["F", "e", "", "5"])
def test_other_appendices_have_no_parts(appendix):
    with pytest.raises(UnknownPartError, match="accepted: 'E', or none"):
        catalogue_part("house", appendix=appendix)


@pytest.mark.parametrize(
    ("height", "fits"),
    [
        ("0", False),
        ("4/15", False),
        ("0.33", False),
        ("1/3", True),
        ("2/5", True),
        ("0.42", True),
        ("0.43", False),
    ],
)
def test_which_centres_give_the_printed_distribution(height, fits):
    """Neither the point of chapter 3, nor the uniform centroid; the mean of the vertices does."""
    corners = catalogue_part("house").vertices
    problem = FeedingProblem(Part(corners, (0, height)), "push-grasp")
    shares = [Probability(width).decimal(2) for width in problem.transfer.widths]
    assert (sorted(shares) == ["0.20", "0.40", "0.40"]) is fits
    if height == "4/15":
        assert Part(corners).center_of_mass == (0, mpq(height))


# --- Figs. E.1 to E.4, E.6, E.7: numbers for what is drawn --------------------------------------


def degrees(angles):
    return [angle.degrees(2) for angle in angles]


class TestFourGon:
    found = push_grasp_analysis("4gon")

    def test_the_push_function(self):
        """Figs. E.1, E.2: four maxima of the radius, four stable edges."""
        assert degrees(self.found.radius.maxima) == ["53.13", "129.40", "222.71", "324.29"]
        assert degrees(self.found.radius.minima) == ["21.57", "78.11", "176.70", "270.99"]
        assert degrees(self.found.push.breaks) == degrees(self.found.radius.maxima)
        assert degrees(self.found.push.values) == ["78.11", "176.70", "270.99", "381.57"]

    def test_the_squeeze_leaves_the_pushed_part_alone(self):
        """Fig. E.3: all four edges are stable for both, so the push decides."""
        assert self.found.push_grasp == self.found.push
        assert self.found.squeeze.order == 2
        assert self.found.push_grasp.order == 1
        values = {v.reduced() for v in self.found.push.values}
        assert all(self.found.squeeze(v) == v for v in values)
        assert len({v % HALF_TURN for v in values}) == len(self.found.squeeze) == 4

    def test_the_preimages(self):
        """Fig. E.4."""
        chain = self.found.preimages
        assert degrees(p.width for p in chain) == ["101.58", "194.89", "271.16", "360.00"]
        assert degrees(p.arc.start for p in chain) == ["222.71", "129.40", "53.13", "324.29"]
        assert degrees(p.image_width for p in chain) == ["0.00", "94.29", "192.88", "249.42"]


class TestHouse:
    found = push_grasp_analysis("house")

    def test_the_functions(self):
        """Fig. E.6: the roof is stable for the push and not for the squeeze."""
        breaks = ["35.54", "120.96", "180.00", "239.04", "324.46"]
        assert degrees(self.found.radius.maxima) == breaks == degrees(self.found.push.breaks)
        values = ["90.00", "135.00", "225.00", "270.00", "360.00"]
        assert degrees(self.found.push.values) == values
        assert degrees(self.found.squeeze.values) == ["90.00", "180.00"]
        assert degrees(self.found.push_grasp.breaks) == ["35.54", "180.00", "324.46"]
        assert degrees(self.found.push_grasp.values) == ["90.00", "270.00", "360.00"]

    def test_the_preimages(self):
        """Fig. E.7."""
        chain = self.found.preimages
        assert degrees(p.width for p in chain) == ["144.46", "215.54", "360.00"]
        assert [p.ties for p in chain] == [2, 2, 1]


# --- Figs. E.5 and E.8 ---------------------------------------------------------------------------

PRINTED_E5 = (
    ("0.26", "0.21", "0.25", "0.28"),
    ("0.26", "0.46", "0.00", "0.28"),
    ("0.46", "0.00", "0.00", "0.54"),
    ("0.00", "0.00", "0.00", "1.0"),
)
PRINTED_E8 = (("0.20", "0.40", "0.40"), ("0.40", "0.60", "0.00"), ("0.00", "1.0", "0.00"))


def trace(evolution: Evolution, cumulative):
    """Return the distributions that gripper angles give, in the order and form of the print."""
    transfer = evolution.plan.transfer
    turns = [b - a for a, b in zip([ZERO, ZERO, *cumulative], [ZERO, *cumulative], strict=False)]
    rows = []
    for count in range(1, len(turns) + 1):
        whole = composite(transfer, turns[:count])
        shares = dict.fromkeys(evolution.orientations, ZERO)
        for value, width in zip(whole.values, whole.widths, strict=True):
            shares[value.reduced()] += width
        rows.append(
            tuple(
                "1.0" if width == FULL_TURN else Probability(width).decimal(2)
                for width in shares.values()
            )
        )
    return tuple(rows)


@pytest.mark.parametrize(("evolution", "printed"), [(E5, PRINTED_E5), (E8, PRINTED_E8)])
class TestDistributions:
    def test_every_number_is_the_printed_one(self, evolution, printed):
        assert tuple(tuple(c.printed for c in row.cells) for row in evolution.rows) == printed
        assert all(cell.agrees for row in evolution.rows for cell in row.cells)

    def test_by_composition(self, evolution, printed):
        assert trace(evolution, evolution.plan.cumulative_angles[1:]) == printed

    def test_states_are_in_the_order_of_the_source(self, evolution, printed):
        """By decreasing theta: by increasing angle of the jaws in the part's frame."""
        states = list(evolution.orientations)
        turned = [(state - states[0]).reduced() for state in states]
        assert turned[1:] == sorted(turned[1:], reverse=True)
        assert len(states) == len(printed[0])


def test_the_catalogue_says_the_same_of_its_cells():
    fourgon, house = catalogue_entry("4gon"), catalogue_entry("house")
    for k, cell in enumerate(E5.rows[0].cells, start=1):
        name = f"E.5 prior[{k}]"
        assert (fourgon.printed[name], fourgon.reproduced[name]) == (cell.printed, cell.agrees)
    for k, cell in enumerate(E8.rows[0].cells, start=1):
        name = f"E.8 prior[{k}] (com (0.0, 0.4))"
        assert Fraction(house.printed[name]) == Fraction(cell.printed)
        assert house.reproduced[name] is cell.agrees
    for evolution, entry in ((E5, fourgon), (E8, house)):
        for k, row in enumerate(evolution.rows[1:], start=1):
            (name,) = (
                c for c in entry.printed if c.startswith(f"{evolution.figure} plan angle {k}")
            )
            assert (entry.printed[name], entry.reproduced[name]) == (
                row.angle.printed,
                row.angle.agrees,
            )


def test_only_what_the_errata_explain_differs():
    assert all(cell.agrees and cell.erratum is None for cell in E8.cells)
    differing = [cell for cell in E5.cells if not cell.agrees]
    assert [cell.printed for cell in differing] == ["25", "79", "-23", "3.7"]
    assert [cell.erratum for cell in differing] == [APPENDIX_E["angles"]] * 3 + [APPENDIX_E["cost"]]


class TestFigureE8:
    def test_the_angles_are_middles_of_ranges(self):
        """72.2 and exactly 135."""
        first, second = (row.angle.computed for row in E8.rows[1:])
        assert first.decimal(4) == "72.2312"
        assert second.doubled == Angle.from_degrees(270)
        assert degrees(E8.plan.cumulative_angles) == ["0.00", "71.57", "135.00"]

    def test_the_printed_angles_give_the_printed_trace(self):
        assert trace(E8, [Angle.from_degrees(a) for a in (72, 135)]) == PRINTED_E8

    def test_our_plan_without_a_goal_is_the_mirror_image(self):
        """Equal widths, ranges and costs; ties go to the smaller start."""
        ours = FeedingProblem(catalogue_part("house", appendix="E"), "push-grasp").geometric_plan()
        theirs = E8.plan
        assert degrees([ours.final_orientation, theirs.final_orientation]) == ["90.00", "270.00"]
        assert [p.width for p in ours.preimages] == [p.width for p in theirs.preimages]
        assert [a.tolerance for a in ours.actions] == [a.tolerance for a in theirs.actions]
        assert ours.expected_cost == theirs.expected_cost
        assert ours.preimages[0].arc.start < theirs.preimages[0].arc.start
        # The first ranges are the same, the second differ by the turn between the two steps.
        assert ours.actions[:2] == theirs.actions[:2]
        assert ours.actions[2].low - theirs.actions[2].low == (
            theirs.preimages[0].arc.end - ours.preimages[0].arc.end
        )

    def test_three_steps_are_the_cheapest_at_4(self):
        problem = FeedingProblem(catalogue_part("house", appendix="E"), "push-grasp")
        assert problem.optimal_plan().steps == 3
        assert problem.expected_cost(3).rational == 4
        assert [cost.decimal(2) for cost in E8.costs[:2]] == ["4.98", "5.01"]


class TestFigureE5:
    """The printed angles cannot belong to the printed distributions; proofs from the print alone.

    The trace tells, for states 1 to 4 in the printed order with y_k the distance from state k to
    the end of its step in the direction of the turn: the second action takes state 3 to 2 and
    leaves the others, so its turn is at least y_3 and less than y_4; the third takes 2 to 1 and 1
    to 4, the fourth 1 to 4, and both leave 4.
    """

    half_unit = Fraction(1, 2)
    increments = (25, 79 - 25, -23 - 79)

    def test_no_sense_of_turning_fits_all_three(self):
        """All turns are the same way and less than y_4, so than the step of state 4."""
        widest = (Fraction("0.28") + Fraction(1, 200)) * 360
        assert widest == Fraction("102.6")
        for sense in (1, -1):
            turns = [sense * turn % 360 for turn in self.increments]
            assert any(turn - 2 * self.half_unit > widest for turn in turns)

    def test_the_first_two_exclude_each_other_as_middles(self):
        """The middles are (y_3 + y_4) / 2 and (y_2 + y_4) / 2, with y_2 < y_4 and y_3 > 0."""
        first_at_most = 25 + self.half_unit
        second_at_least = (79 - self.half_unit) - (25 + self.half_unit)
        # second < y_4 < y_3 + y_4 = 2 first
        assert second_at_least > 2 * first_at_most

    def test_the_rebuilt_part_keeps_the_inequality(self):
        low = [(-a.low) % FULL_TURN for a in E5.plan.actions[1:]]
        high = [(-a.high) % FULL_TURN for a in E5.plan.actions[1:]]
        first, second, _ = (a + b for a, b in zip(low, high, strict=True))
        assert second < 2 * first
        assert len(set(low)) == 1  # all ranges end at y_4

    def test_the_printed_angles_give_another_trace(self):
        for sense in (1, -1):
            found = trace(E5, [Angle.from_degrees(sense * a) for a in (25, 79, -23)])
            assert found != PRINTED_E5

    def test_angles_literally(self):
        middles = [row.angle.computed.decimal(2) for row in E5.rows[1:]]
        assert middles == ["-42.43", "-94.73", "-144.39"]

    def test_the_text_on_the_cost(self):
        assert Fraction(2) / (Fraction("0.28") + Fraction(1, 200)) > 7
        assert abs(Fraction(2) / Fraction("0.54") - Fraction("3.7")) < Fraction(1, 20)
        costs = [getattr(cost, "computed", cost).decimal(1) for cost in E5.costs]
        assert costs == ["7.1", "5.5", "5.3", "5.0"]
        problem = FeedingProblem(catalogue_part("4gon"), "push-grasp")
        assert problem.optimal_plan().steps == 4
        # No share of the costs of filter and action makes one step the cheapest at 3.7, either.
        assert all(problem.optimal_plan(c).steps > 1 for c in (1, 2, 10))


@st.composite
def four_stable_edges(draw):
    """Step maps of a full turn with four steps, each with its value inside."""
    marks = sorted(draw(st.sets(st.integers(0, 71), min_size=8, max_size=8)))
    grid = [Angle.from_degrees(5 * k) for k in marks]
    return StepFunction(grid[::2], grid[1::2])


@given(four_stable_edges())
def test_the_inequality_of_the_middles_holds_for_every_such_map(s):
    """For every plan that takes in one state after the other, as Fig. E.5 does."""
    count = len(s)
    reach = [s.lifted_breaks[k + 1] - s.lifted_values[k] for k in range(count)]
    k = reach.index(max(reach)) + count
    chain = [Preimage(s, steps, k - steps + 1, k, 1) for steps in range(1, count + 1)]
    slacks = [goal.width - here.image_width for goal, here in pairwise(chain)]
    if count < 4 or min(slacks) <= ZERO:
        return  # symmetric, or equal reaches
    plan = FeedingPlan(s, chain, mpq(1))
    assert plan.execute_arc()[-1].width == ZERO
    ranges = [(-a.high, -a.low) for a in plan.actions[1:]]
    assert ranges == [(reach[(k - j) % 4], reach[k % 4]) for j in (3, 2, 1)]
    (low, high), (bottom, top), _ = ranges
    assert bottom + top < 2 * (low + high)


# --- orienting uniquely --------------------------------------------------------------------------


@pytest.mark.parametrize("evolution", [E5, E8])
def test_the_parts_are_oriented_uniquely(evolution):
    plan = evolution.plan
    assert plan.transfer.period == FULL_TURN
    assert plan.orients_up_to_symmetry
    assert plan.probability.rational == 1
    assert plan.distribution().orientations == (plan.final_orientation.reduced(),)


@settings(max_examples=settings().max_examples // 2)
@given(parts(), st.lists(orientations, min_size=3, max_size=3))
def test_a_part_is_oriented_uniquely_where_the_period_is_a_full_turn(part, starts):
    """App. E.2; with symmetry q, into exactly q equally likely orientations."""
    plan = FeedingProblem(part, "push-grasp").geometric_plan()
    order = plan.transfer.order
    final = plan.distribution()
    assert len(final) == order
    assert {w * order for w in final.widths} == {FULL_TURN}
    for theta in starts:
        assert plan.execute(theta)[-1].reduced() in final.orientations
    if order == 1:
        assert plan.probability.rational == 1
        assert len({plan.execute(theta)[-1].reduced() for theta in starts}) == 1


# --- small things --------------------------------------------------------------------------------


def test_half_angles_and_shares():
    assert HalfAngle(Angle(0, (3, 1))).decimal(4) == "9.2175"
    assert HalfAngle(-Angle.from_degrees(45)).decimal(1) == "-22.5"
    assert [Probability(a).decimal(2) for a in (ZERO, HALF_TURN)] == ["0.00", "0.50"]


# --- the command ---------------------------------------------------------------------------------


@pytest.mark.parametrize(("number", "evolution"), [("E.5", E5), ("E.8", E8)])
class TestTheCommand:
    def test_text(self, capsys, number, evolution):
        result = call(capsys, "table", number, "--digits", "2")
        assert (result.code, result.err) == (0, "")
        assert result.out.startswith(f"Fig. {number}: push-grasps of the ")
        for cell in evolution.cells:
            assert f"{cell.computed.decimal(2)} [{cell.printed}]" in result.out
        noted = {cell.erratum.where for cell in evolution.cells if not cell.agrees}
        assert all(where in result.out for where in noted)
        assert ("(1)" in result.out) is bool(noted)

    def test_document(self, capsys, number, evolution):
        document = call(capsys, "table", number, "--json").document
        assert document["schema"] == "stochgeom/evolution/1"
        assert (document["figure"], document["part"]) == (number, evolution.plan.part.name)
        assert len(document["orientations"]) == len(document["rows"][0]["cells"])
        assert document["rows"][0]["angle"] is None
        assert len(document["costs"]) == evolution.plan.steps
        agree = [cell["agrees"] for row in document["rows"] for cell in row["cells"]]
        assert all(agree)

    def test_what_nothing_explains_is_a_failed_check(self, capsys, monkeypatch, number, evolution):
        wrong = Evolution(
            evolution.figure,
            evolution.plan,
            evolution.orientations,
            evolution.rows,
            (Cell(HalfAngle(HALF_TURN), "1.0", None),),
        )
        monkeypatch.setitem(table_command._FIGURES, number, lambda: wrong)
        result = call(capsys, "table", number)
        assert result.code == 1
        assert "differs, and no erratum explains it" in result.out
        assert call(capsys, "table", number, "--json").code == 1
