"""Part recognition, calibration, and the choice of sensors."""

from __future__ import annotations

from fractions import Fraction

import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.exact.angles import FULL_TURN, Angle
from stochgeom.geometry.part import Part
from stochgeom.sensing.calibration import calibration_problem, expected_entropy
from stochgeom.sensing.planners import iterative_sensor_plan, sensor_plan
from stochgeom.sensing.recognition import RecognitionProblem
from stochgeom.sensing.sensor_design import choose_bits, compare_sensors, fuse_sensors, place_sensor
from stochgeom.sensing.sensors import Sensor
from stochgeom.transfer.squeeze import squeeze_function
from tests.strategies import PYTHAGOREAN, hulls

RECTANGLE = [(0, 0), (3, 0), (3, 2), (0, 2)]
SQUARE = [(0, 0), (2, 0), (2, 2), (0, 2)]
TRIANGLE = [(0, 0), (4, 0), (1, 3)]
FEW = settings(max_examples=min(40, settings.default.max_examples))


def symmetrised(part):
    """Return half the sum of a convex part and its mirror image in a point: the same diameters."""
    corners = part.hull.points.pairs()
    sums = {((a[0] - b[0]) / 2, (a[1] - b[1]) / 2) for a in corners for b in corners if a != b}
    from stochgeom.geometry.hull import convex_hull
    from stochgeom.geometry.points import Points

    return Part(convex_hull(Points.from_pairs(sorted(sums))).points.pairs())


class TestRecognition:
    def test_squeezes_of_all_parts_together(self):
        found = RecognitionProblem({"r": RECTANGLE, "s": SQUARE})
        assert found.problem.states[:2] == (("r", "0.0000"), ("r", "90.0000"))
        assert sum(found.problem.prior[1:], start=found.problem.prior[0]) == 1
        # Each action does to each part what its squeeze function says.
        for name, part in (("r", RECTANGLE), ("s", SQUARE)):
            squeeze = squeeze_function(part)
            for action, alpha in found.angles.items():
                for state, theta in found.orientations.items():
                    if state[0] == name:
                        row = found.problem.matrix(action)[found.problem.state_number(state)]
                        target = found.problem.states[row.index(1)]
                        assert found.orientations[target] == squeeze(theta - alpha) % FULL_TURN

    @pytest.mark.parametrize("other", [SQUARE, TRIANGLE, [(0, 0), (2, 0), (2, 1), (1, 2), (0, 1)]])
    def test_no_squeeze_is_missing(self, other):
        """Whatever the angle, what it does to all parts is what one of the actions does."""
        found = RecognitionProblem({"r": RECTANGLE, "o": other})
        squeezes = {"r": squeeze_function(RECTANGLE), "o": squeeze_function(other)}
        place = {(s[0], theta): k for k, (s, theta) in enumerate(found.orientations.items())}
        known = {
            tuple(row.index(1) for row in found.problem.matrix(action)) for action in found.angles
        }
        for degrees in range(0, 180, 2):
            alpha = Angle.from_degrees(degrees) + Angle(0, (1000, 1))
            # A turn of 180 degrees more moves all parts alike, and nothing sees it.
            seen = [
                tuple(
                    place[name, squeezes[name](theta - alpha - half) % FULL_TURN]
                    for (name, _), theta in found.orientations.items()
                )
                for half in (Angle(), Angle.from_degrees(180))
            ]
            assert known & set(seen)

    def test_a_look_names_a_part_of_another_size(self):
        found = RecognitionProblem({"r": RECTANGLE, "small": [(0, 0), (1, 0), (0, 1)]})
        plan = found.plan(1)
        assert found.recognised(plan) == 1
        assert plan.expected_cost == 0

    def test_shares(self):
        found = RecognitionProblem({"r": RECTANGLE, "s": SQUARE}, {"r": 3, "s": 1})
        assert found.plan(0, mistake_cost=8).expected_cost == 2
        assert found.recognised(found.plan(0)) == mpq(3, 4)

    def test_squeezing_to_tell(self):
        """The rectangle lies on its short side or not; a turn by 90 degrees shows the other one."""
        found = RecognitionProblem({"r": RECTANGLE, "s": SQUARE})
        assert found.recognised(found.plan(1, mistake_cost=10)) != 1
        assert found.recognised(found.plan(3, mistake_cost=10)) == 1
        assert found.indistinguishable() == ()

    def test_a_turned_part_is_the_same_part(self):
        turned = Part(RECTANGLE).multiply((3, 4)).multiply((Fraction(1, 5), 0))
        found = RecognitionProblem({"r": RECTANGLE, "t": turned, "s": SQUARE})
        assert found.indistinguishable() == (("r", "t"),)

    def test_a_part_of_the_same_diameter_function(self):
        hexagon = symmetrised(Part(TRIANGLE))
        assert len(hexagon) == 6
        found = RecognitionProblem({"triangle": TRIANGLE, "hexagon": hexagon, "r": RECTANGLE})
        assert found.indistinguishable() == (("triangle", "hexagon"),)
        assert found.recognised(found.plan(2, mistake_cost=100)) < 1

    def test_a_sensor_that_tells_too_little(self):
        parts = {"r": RECTANGLE, "wide": [(0, 0), (3, 0), (3, Fraction(21, 10)), (0, 2)]}
        assert RecognitionProblem(parts).indistinguishable() == ()
        assert RecognitionProblem(parts, bits=0).indistinguishable() == (("r", "wide"),)

    def test_a_mirror_image_can_be_told_by_the_order_of_its_grasps(self):
        part = [(52, 58), (0, 55), (8, 17), (51, 0)]
        mirrored = [(-x, y) for x, y in part]
        assert RecognitionProblem({"p": part, "m": mirrored}).indistinguishable() == ()

    def test_noise_alone_hides_nothing_for_good(self):
        found = RecognitionProblem({"r": RECTANGLE, "s": SQUARE}, bits=1, noise="1/2")
        assert found.indistinguishable() == ()

    @FEW
    @given(hulls(most=5), st.sampled_from(PYTHAGOREAN[4:]))
    def test_turning_and_symmetrising_change_nothing(self, part, turn):
        size = Fraction(1, int((turn[0] ** 2 + turn[1] ** 2) ** 0.5))
        turned = part.multiply(turn).multiply((size, 0))
        both = {"part": part, "turned": turned, "even": symmetrised(part)}
        assert RecognitionProblem(both).indistinguishable() == (("part", "turned", "even"),)

    @FEW
    @given(hulls(most=5), hulls(most=5))
    def test_other_diameters_are_seen(self, one, other):
        """Parts whose sets of diameters at stable orientations differ are told apart by a look."""
        found = RecognitionProblem({"one": one, "other": other})
        seen = {
            name: {
                reading
                for state, row in zip(found.sensor.states, found.sensor.likelihood, strict=True)
                if state[0] == name
                for reading, p in zip(found.sensor.readings, row, strict=True)
                if p
            }
            for name in ("one", "other")
        }
        if seen["one"] != seen["other"]:
            assert found.indistinguishable() == ()


PIN = PlanningProblem(["in", "out"], [0, 1], ["push"], [[[1, 0], [1, 0]]])
SENSORS = {
    "sound": Sensor.noisy(PIN.states, "1/10"),
    "broken": Sensor.noisy(PIN.states, "1/2"),
}


class TestCalibration:
    def test_three_readings(self):
        """Of 0 to 3 wrong ones; sound .729 .243 .027 .001, broken .125 .375 .375 .125."""
        found = calibration_problem(PIN, SENSORS)
        plan = found.plan(3)
        assert plan.expected_cost == (mpq("0.125") + mpq("0.243") + mpq("0.028")) / 2
        # Not all readings are made: where no further one can change the name, the plan ends.
        assert found.expected_entropy(plan).decimal(4) == "0.6928"

    def test_weights_and_losses(self):
        found = calibration_problem(PIN, SENSORS, {"sound": "0.9", "broken": "0.1"})
        assert found.plan(0).expected_cost == mpq("0.1")
        losses = {"sound": {"broken": 20}, "broken": {"sound": 1}}
        assert found.plan(0, losses).expected_cost == mpq("0.9")
        assert found.plan(0, losses).tree.text() == "broken (0.9000)"

    def test_readings_have_a_price(self):
        dear = {value: sensor.with_cost("1/4") for value, sensor in SENSORS.items()}
        assert calibration_problem(PIN, dear).plan(2).tree.depth == 0

    def test_actions_help_to_calibrate(self):
        """A sensor whose fault shows in one state only: bring the pin there first."""
        stuck = Sensor.from_function(PIN.states, lambda _: "out")
        stuck = Sensor(["in", "out"], [[0, 1], [0, 1]], states=PIN.states)
        found = calibration_problem(PIN, {"good": Sensor.perfect(PIN.states), "stuck": stuck})
        assert found.plan(1).expected_cost == mpq(1, 2)
        plan = found.plan(2, action_costs="1/10")
        assert plan.expected_cost == mpq(1, 10)
        assert found.expected_entropy(plan).rational == 0

    def test_floats(self):
        found = calibration_problem(PIN.to_float(), {v: s.to_float() for v, s in SENSORS.items()})
        assert found.plan(3).expected_cost == pytest.approx(0.198)
        assert found.expected_entropy(found.plan(3)) == pytest.approx(0.693, abs=1e-3)

    def test_entropy_of_all_of_the_state(self):
        coin = PlanningProblem.from_matrices(["1/2", "1/2"], [[[1, 0], [0, 1]]])
        plan = iterative_sensor_plan(coin, Sensor.perfect(coin.states), 1)
        assert expected_entropy(plan.tree).rational == 0
        assert expected_entropy(iterative_sensor_plan(coin, [], 1).tree).rational == 1


class TestDesign:
    THREE = PlanningProblem(range(3), ["1/3"] * 3, ["wait"], [[[1, 0, 0], [0, 1, 0], [0, 0, 1]]])

    def test_which_of_two_depends_on_the_price(self):
        narrow = Sensor.from_function(range(3), lambda state: state == 0)
        for cost, best in (("1/4", "rough"), ("1/2", "narrow")):
            rough = Sensor.noisy(range(3), "1/10", cost=cost)
            found = compare_sensors(self.THREE, {"rough": rough, "narrow": narrow}, 1)
            assert found[0].label == best
            assert found[0].plan.expected_cost <= found[1].plan.expected_cost

    def test_equal_sensors_stay_in_order(self):
        blind = Sensor.blind(range(3))
        found = compare_sensors(self.THREE, {"b": blind, "a": blind}, 1)
        assert [each.label for each in found] == ["b", "a"]

    def test_additive_costs(self):
        from stochgeom.sensing.decisions import lose_by_table

        losses = lose_by_table(
            self.THREE, {k: {j: 1 for j in range(3) if j != k} for k in range(3)}
        )
        found = compare_sensors(
            self.THREE,
            {"narrow": Sensor.from_function(range(3), lambda state: state == 0)},
            1,
            planner=sensor_plan,
            decisions=losses,
        )
        assert found[0].plan.expected_cost == mpq(1, 3)

    def test_places_with_noise_and_prices(self):
        def see(place, state):
            if state == place:
                return {"yes": "9/10", "no": "1/10"}
            return "no"

        found = place_sensor(self.THREE, see, {0: "1/2", 1: 0, 2: "1/8"}, 1)
        assert [each.label for each in found] == [1, 2, 0]
        assert found[0].plan.success == mpq(3, 10) + mpq(1, 3)

    def test_a_sensor_that_moves(self):
        """Each place is a sensor of its own; the plan says where to look, and where then."""
        sensors = {k: Sensor.from_function(range(3), lambda s, k=k: s == k) for k in range(3)}
        plan = iterative_sensor_plan(self.THREE, sensors, 2)
        assert plan.expected_cost == 1
        assert plan.tree.text().splitlines()[0] == "read 0"

    def test_bits(self):
        found = choose_bits([(52, 58), (0, 55), (8, 17), (51, 0)], 4)
        assert found[0].label == 4
        assert found[0].plan.expected_cost == 4
        assert {each.label for each in found} == {0, 1, 2, 3, 4}

    def test_fused_sensors_are_one_look(self):
        low, high = (Sensor.from_function(range(3), lambda s, k=k: s > k) for k in (0, 1))
        plan = iterative_sensor_plan(self.THREE, fuse_sensors(low, high), 1)
        assert plan.expected_cost == 1
        assert iterative_sensor_plan(self.THREE, {"low": low, "high": high}, 1).expected_cost > 1


def test_angles_of_recognition_are_of_half_a_turn():
    found = RecognitionProblem({"r": RECTANGLE, "s": SQUARE})
    angles = sorted(found.angles.values())
    assert angles[-1] - angles[0] < Angle.from_degrees(180)
