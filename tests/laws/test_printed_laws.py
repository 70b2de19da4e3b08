"""What is printed as a bound of something that works does work, typed in as it stands."""

from __future__ import annotations

from fractions import Fraction

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from stochgeom.decision.density_priors import WrappedNormal
from stochgeom.decision.discrete_prior import DiscretePrior
from stochgeom.decision.mixture_prior import MixturePrior
from stochgeom.exact.angles import Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.cells import CellSet
from stochgeom.exact.intervals import Interval
from stochgeom.feeding.actions import printed_margin
from stochgeom.feeding.adversarial import FAMILIES
from stochgeom.feeding.planner import plan_feeding
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.feeding.verification import verify_plan
from stochgeom.geometry.part import Part
from stochgeom.grasping.grasp_diagram import GraspDiagram
from stochgeom.thesis.parts import catalogue_part
from stochgeom.transfer.squeeze import squeeze_function
from tests.commands import call
from tests.strategies import arcs, circle_points, hulls, small_pushable_parts

FEW = max(20, settings().max_examples // 10)
WEDGE = [("0", "0"), ("2.5", "0"), ("2.5", "1"), ("0.3", "1.7")]
L = [(0, 0), ("7/2", 0), ("7/2", "3/4"), ("5/6", "3/4"), ("5/6", "13/3"), (0, "13/3")]


def typed(text: str) -> Angle:
    """Read degrees as somebody would who types in what was printed."""
    return Angle.from_degrees(text.rstrip("°"))


@given(arcs(), st.integers(0, 5))
def test_the_decimals_of_an_interval_lie_inside(arc, digits):
    low, high = map(typed, Interval(arc.start, arc.width, False, False).decimals(digits))
    assert arc.start <= low < high <= arc.end
    assert low - arc.start < Angle.from_degrees(Fraction(1, 10**digits))


@given(small_pushable_parts(), st.sampled_from(["0", "1/10", "1/4", "1"]), st.integers(0, 4))
@settings(max_examples=FEW)
def test_a_printed_tolerance_is_borne_at_the_printed_angle(part, mu, digits):
    diagram = GraspDiagram(part, mu)
    for best in diagram.largest_tolerances():
        angle, margin = map(typed, best.decimals(digits))
        if diagram.guaranteed.is_whole or not best.interval.width:
            continue
        closed = best.attained
        known = Interval(-angle - margin, margin + margin, closed, closed)
        assert CellSet.of([known]) <= diagram.guaranteed


@given(hulls(most=7), circle_points())
@settings(max_examples=FEW)
def test_a_printed_first_angle_catches_as_much(part, points):
    prior = DiscretePrior(points)
    plan = plan_feeding(part, prior=prior)
    angle, low, high = map(typed, plan.mouth_decimals())
    moved = plan.mouth.rotate(angle - plan.angles[0])
    turn = (low - moved.start) - (low - moved.start).reduced()  # low is just above the start
    assert moved.start <= low - turn < high - turn <= moved.end
    assert prior.mass(moved) == plan.probability


class TestLiterally:
    def test_a_measured_orientation_at_the_end_of_the_mouth_is_not_lost(self):
        plan = plan_feeding(L, prior=DiscretePrior.from_counts({"0": 50, "90": 30}))
        assert plan.angles[0].degrees() == "-10.8855"  # to the nearest, and that is too much
        nearest = plan.mouth.rotate(typed("-10.8855") - plan.angles[0])
        assert plan.prior.mass(nearest).rational == Fraction(3, 8)
        assert plan.mouth_decimals() == ("-10.8856", "0.0000", "130.1868")

    @pytest.mark.parametrize("angles", ["0, -50.5484, 26.5651", "0, -36.8699, 52.3057"])
    def test_the_ends_that_a_plan_prints_work(self, angles):
        second, third = plan_feeding(WEDGE).actions[1:]
        assert (second.decimals()[1], third.decimals()[2]) == ("-50.5484", "52.3057")
        assert verify_plan(WEDGE, angles).orients_up_to_symmetry

    def test_the_ends_that_a_report_on_a_plan_prints_work(self):
        part = catalogue_part("4gon")
        report = verify_plan(part, "0, 71, 35, 8", cumulative=True)
        assert report.margins[1].decimals() == ("71.0000", "64.4103", "77.1235")
        assert verify_plan(part, "0, 77.1235, -36, -27").orients_up_to_symmetry
        assert not verify_plan(part, "0, 77.1236, -36, -27").orients_up_to_symmetry

    def test_sets_say_what_the_command_says(self, capsys):
        diagram = GraspDiagram(catalogue_part("house"), "0.25")
        said = call(capsys, "grasp", "house", "--mu", "0.25").out
        for item in diagram.guaranteed:
            assert str(item).replace("°", "") in said
        assert "[59.0363, 120.9637]" in said
        assert diagram.largest_tolerances()[0].decimals() == ("90.0000", "30.9637")

    def test_a_small_error_that_is_borne_is_not_printed_as_zero(self, capsys, tmp_path):
        part = FAMILIES["long plans"](25, seed=1)
        plan = plan_feeding(part)
        assert str(plan.error_bound) == "0.00000503°"
        assert plan.error_bound.degrees() == "0.0000"
        borne = printed_margin(plan.actions)
        assert borne == "0.00000300"
        for action in plan.actions[1:]:
            angle, low, high = map(typed, action.decimals())
            assert low <= angle - typed(borne)
            assert angle + typed(borne) <= high
        path = tmp_path / "long.txt"
        path.write_text("\n".join(f"{x} {y}" for x, y in part.vertices))
        assert "below 0.00000300 degrees, and 0.00000503 at" in call(capsys, "plan", str(path)).out

    def test_the_command_names_the_mouth_of_the_printed_angle(self, capsys, tmp_path):
        prior = tmp_path / "prior.txt"
        prior.write_text("0\n" * 5 + "90\n" * 3)
        part = " ".join(f"{x},{y}" for x, y in Part(L).vertices)
        said = call(capsys, "plan", "--vertices", part, "--prior", str(prior)).out
        assert "-10.8856" in said
        assert "catches what arrives from 0.0000 to 130.1868 degrees" in said
        rows = [line.split() for line in said.splitlines() if "-10.8856" in line]
        assert rows[0][-2:] == ["2", "0.6250"]  # of six orientations, four never occur


def test_a_mouth_printed_coarsely_still_holds_its_point():
    part = [(0, 0), (3, 0), (3, 2), (0, 2)]
    plan = plan_feeding(part, prior=DiscretePrior({"10": 1}))
    _, low, high = map(typed, plan.mouth_decimals(0))
    assert Arc(low, high - low).contains(typed("10"))


def test_a_mouth_that_runs_over_0_begins_below():
    plan = plan_feeding(catalogue_part("house"), prior=WrappedNormal("30", "12"))
    assert plan.mouth.start.degrees() == "318.4349"
    assert plan.mouth_decimals() == ("300.0000", "-41.5650", "101.5650")


def test_a_measured_orientation_just_below_the_end_of_the_mouth_is_not_lost():
    rectangle = [(0, 0), (3, 0), (3, 2), (0, 2)]
    width = max(squeeze_function(rectangle).widths)
    first = Angle.from_degrees(10)
    last = first + width - Angle.from_degrees("0.00001")
    plan = plan_feeding(rectangle, prior=DiscretePrior([(first, "1/2"), (last, "1/2")]))
    assert plan.steps == 1
    angle, low, high = map(typed, plan.mouth_decimals())
    assert plan.prior.mass(plan.mouth.rotate(angle - plan.angles[0])).rational == 1
    assert low <= first < last < high


@pytest.mark.parametrize(("place", "digits"), [("100", 2), ("100", 4), ("-30", 4)])
def test_a_point_of_a_mixture_at_an_end_of_the_mouth_is_not_lost(place, digits):
    normal, point = WrappedNormal("30", "12"), DiscretePrior({place: 1})
    prior = MixturePrior([("1/2", normal), ("1/2", point)])
    plan = FeedingProblem(L, prior=prior).plan_of(1)
    angle, low, high = map(typed, plan.mouth_decimals(digits))
    moved = plan.mouth.rotate(angle - plan.angles[0])
    assert moved.contains(typed(place))
    assert prior.mass(moved).decimal() == plan.probability.decimal()
    assert Arc(moved.start, moved.width).contains(low)
    assert high - low < moved.width
