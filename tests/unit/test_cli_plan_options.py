"""``stochgeom plan`` with another action, a prior, a goal, a gripper that errs."""

from __future__ import annotations

import re
from fractions import Fraction

import pytest

from stochgeom.exact.angles import Angle
from tests.commands import call

HOUSE = ["house", "--center-of-mass", "0,2/5"]

PUSHED_HOUSE = """\
house: 5 vertices, 5 on the convex hull
push-grasp function: 3 steps in a period of 360.0000 degrees, 3 final orientations in a full turn

Stochastically optimal plan, also the shortest that orients the part uniquely
  step  rotate gripper by             works for  states left  probability
     1             random             any angle            3       0.4013
     2            71.5651    (54.4624, 90.0000]            2       0.5987
     3           206.5651  (180.0000, 234.4623]            1       1.0000

Angles are degrees counter-clockwise, each relative to the gripper's last pose; ranges
are rounded inwards, so they work as printed.

Every action may be off by 2.0000 degrees either way.
The 3-step plan bears every gripper error below 17.1027 degrees, and 17.7688 at the middles of its \
ranges.
Plans that orient it uniquely exist for every error below 17.7688 degrees.

Best plan of each length (a filter pass costs 1 push-grasp time)
  steps  collapsed arc  probability  expected cost
      1       144.4623       0.4013  4.9840
      2       215.5377       0.5987  5.0107
      3       360.0000       1.0000  4.0000 <- least

3 push-grasps orient this part uniquely; expected cost 4.00 push-grasp times: 3 push-grasps and \
1 filter pass.
"""


def report(capsys, *arguments):
    result = call(capsys, "plan", *arguments)
    assert (result.code, result.err) == (0, "")
    return result.out


def document(capsys, *arguments):
    result = call(capsys, "plan", *arguments, "--json")
    assert (result.code, result.err) == (0, "")
    return result.document


def refusal(capsys, *arguments, code=2):
    result = call(capsys, "plan", *arguments)
    assert (result.code, result.out) == (code, "")
    assert result.err.count("\n") == 1
    assert "accepted" in result.err
    return result.err


def angle(value):
    return Angle(value["turns"], tuple(int(text) for text in value["direction"]))


class TestPushGrasp:
    def test_the_house_literally(self, capsys):
        options = ["--action", "push-grasp", "--gripper-error", "2"]
        assert report(capsys, *HOUSE, *options) == PUSHED_HOUSE

    def test_the_document(self, capsys):
        found = document(capsys, *HOUSE, "--action", "push-grasp")
        assert found["transfer"]["action"] == "push-grasp"
        assert found["transfer"]["period"]["turns"] == 1
        assert found["plan"]["probability"] == "1.0000"
        assert found["plan"]["margin"]["degrees"] == "17.1027"

    @pytest.mark.parametrize("center", ["100,0", "-1,-1", "0,-1"])
    def test_a_center_of_mass_not_inside(self, capsys, center):
        error = refusal(capsys, "house", "--center-of-mass", center, "--action", "push-grasp")
        assert "center of mass" in error

    def test_an_unknown_action(self, capsys):
        assert call(capsys, "plan", "house", "--action", "shake").code == 2


class TestPrior:
    def test_normal(self, capsys):
        text = report(capsys, "4gon", "--prior", "normal:10,20")
        assert "prior: normal, mean 10.0000°, standard deviation 20.0000°" in text
        assert "the prior" in text
        assert "has one turn, and an error of it moves the mouth" in text

    def test_the_document(self, capsys, tmp_path):
        path = tmp_path / "seen.txt"
        path.write_text("90 3\n180 1\n", encoding="utf-8")
        found = document(capsys, "rectangle", "--prior", str(path))
        assert found["prior"] == "discrete, 2 orientations"
        plan = found["plan"]
        assert (plan["steps"], plan["probability"]) == (1, "1.0000")
        start, width = angle(plan["mouth"]["start"]), angle(plan["mouth"]["width"])
        assert start <= Angle.from_degrees(90)
        assert Angle.from_degrees(180) < start + width
        assert plan["actions"][0]["low"] is None
        assert angle(plan["actions"][0]["angle"]) != Angle()

    def test_where_the_mouth_stands(self, capsys):
        square = ["--vertices", "0,0 1,0 1,1 0,1", "--prior", "normal:20,10"]
        text = report(capsys, *square)
        assert "  catches what arrives from -25.0000 to 65.0000 degrees\n" in text
        text = report(capsys, *square, "--gripper-error", "20")
        assert "  catches for sure what arrives from -5.0000 to 45.0000 degrees\n" in text
        text = report(capsys, *HOUSE, "--action", "push-grasp", "--prior", "normal:20,90")
        assert "  catches every orientation\n" in text

    def test_an_error_of_the_first_turn(self, capsys):
        options = ["rectangle", "--prior", "normal:20,60", "--cost-ratio", "9"]
        moves = "below 11.3099 degrees; one of the first turn moves the mouth."
        assert moves in report(capsys, *options)
        assert moves not in report(capsys, *options, "--gripper-error", "1")

    def test_uniform_is_the_default(self, capsys):
        assert report(capsys, "house", "--prior", "uniform") == report(capsys, "house")

    def test_unknown(self, capsys):
        assert "normal:MEAN,SD" in refusal(capsys, "house", "--prior", "gauss")


class TestGoal:
    def test_by_angle(self, capsys):
        text = report(capsys, "rectangle", "--goal", "90")
        assert "goal: 90, the final orientation at 90.0000 degrees; it bears a disturbance" in text
        assert " below 33.6900 degrees\n" in text
        found = document(capsys, "rectangle", "--goal", "90.3")
        assert [goal["degrees"] for goal in found["goal"]] == ["90.0000"]

    def test_most_stable(self, capsys):
        found = document(capsys, "rectangle", "--goal", "most stable")
        assert [goal["degrees"] for goal in found["goal"]] == ["0.0000"]

    def test_every_equal_one(self, capsys):
        found = document(capsys, "--vertices", "0,0 4,0 3,5 1,5", "--goal", "most stable")
        assert len(found["goal"]) >= 1

    @pytest.mark.parametrize("goal", ["45", "x", "nan", "least stable"])
    def test_no_final_orientation(self, capsys, goal):
        assert "goal: " in refusal(capsys, "rectangle", "--goal", goal)


class TestGripperError:
    def test_what_is_borne(self, capsys):
        found = document(capsys, "4gon", "--gripper-error", "5")
        assert found["gripper_error"]["degrees"] == "5.0000"
        assert found["largest_gripper_error"]["degrees"] == "10.3616"
        assert Fraction(found["plan"]["margin"]["degrees"]) > 5

    @pytest.mark.parametrize("error", ["0.05", "6.28", "8.659", "8.6594"])
    @pytest.mark.parametrize("digits", ["0", "1", "4"])
    def test_printed_angles_leave_room_for_the_error(self, capsys, error, digits):
        vertices = "0,0 7,0 9,3 4,8 1,6"
        text = report(capsys, "--vertices", vertices, "--gripper-error", error, "--digits", digits)
        rows = re.findall(r" (\S+)  +\((\S+), (\S+)\]", text)
        assert len(rows) >= 3
        assert all(
            Fraction(low) < Fraction(angle) - Fraction(error)
            and Fraction(angle) + Fraction(error) <= Fraction(high)
            for angle, low, high in rows
        )
        borne = r"The (\d)-step plan bears .* error below (\S+) degrees(?:, and (\S+))?"
        for steps, least, middles in re.findall(borne, text):
            distances = [
                d
                for angle, low, high in rows[: int(steps) - 1]
                for d in (Fraction(angle) - Fraction(low), Fraction(high) - Fraction(angle))
            ]
            assert 0 <= min(distances) - Fraction(least) < Fraction(1, 10 ** int(digits))
            assert not middles or Fraction(middles) > Fraction(least)

    def test_more_digits_than_number_text_may_have(self, capsys):
        assert "45." + 20_001 * "0" in report(capsys, "house", "--digits", "20001")

    def test_a_given_error_is_not_rounded(self, capsys):
        for given, shown in (("8.65948", "8.65948"), ("1/3", "0.3")):
            text = report(capsys, "house", "--gripper-error", given, "--digits", "1")
            assert f"Every action may be off by {shown} degrees either way." in text

    def test_no_plan_up_to_symmetry(self, capsys):
        text = report(capsys, "4gon", "--gripper-error", "11")
        assert "No plan orients the part up to symmetry with this error." in text
        assert "exist for every error below 10.3616 degrees" in text
        found = document(capsys, "4gon", "--gripper-error", "11")
        assert found["geometric_plan"] is None
        assert found["plan"]["steps"] == 2

    def test_one_action_that_needs_no_aim(self, capsys):
        text = report(capsys, "--vertices", "0,0 1,0 1,1 0,1", "--gripper-error", "80")
        assert "One action orients the part up to symmetry, whatever its error." in text

    def test_nothing_is_caught_for_sure(self, capsys):
        options = ["--prior", "normal:0,5", "--gripper-error", "85"]
        assert "no plan is sure to catch anything" in refusal(capsys, "4gon", *options, code=1)

    @pytest.mark.parametrize("error", ["-1", "180", "1e3", "nan", "x", "1e999999999"])
    def test_no_gripper_error(self, capsys, error):
        assert "gripper error" in refusal(capsys, "4gon", "--gripper-error", error)
