"""Problems with sensors: their documents, and ``stochgeom decide`` on them."""

from __future__ import annotations

import copy
import json

import pytest
from gmpy2 import mpq

from stochgeom.decision.goal_costs import GoalCost
from stochgeom.decision.iterative_costs import IterativeCost
from stochgeom.errors import SensorError
from stochgeom.io.problem_json import problem_document
from stochgeom.io.sensors_json import parse_sensed_problem, sensors_document
from stochgeom.sensing.planners import iterative_sensor_plan, plan_for_cost
from stochgeom.sensing.sensors import Sensor
from tests.commands import call

LATCH = {
    "name": "latch",
    "states": ["open", "shut", "jammed"],
    "prior": ["1/2", "1/4", "1/4"],
    "actions": ["push", "shake"],
    "transitions": {
        "push": [[1, 0, 0], ["9/10", "1/10", 0], [0, 0, 1]],
        "shake": [["1/2", "1/2", 0], [0, 1, 0], [0, "1/2", "1/2"]],
    },
    "sensors": {
        "eye": {
            "readings": ["light", "dark"],
            "likelihood": {
                "open": [1, 0],
                "shut": ["0.2", "0.8"],
                "jammed": {"light": 0, "dark": 1},
            },
            "cost": "1/10",
        }
    },
    "cost": {"kind": "iterative", "goal": ["open"], "actions": "1/4", "test": 1},
}

PRINTED = """\
latch: 3 states, 2 actions, 1 sensor, exact numbers
cost: expected cost of rounds until the plan ends in the goal

Optimal plan of at most 3 moves, looks included
  read eye
    light (0.5500): accept goal (0.9091)
    dark (0.4500)
      do shake
      do push
      accept goal (0.6500)

cost 1.6719
a round costs 1.3250 and succeeds with probability 0.7925
"""


@pytest.fixture
def file(tmp_path):
    def write(**changes):
        document = copy.deepcopy(LATCH)
        for key, value in changes.items():
            if value is None:
                del document[key]
            else:
                document[key] = value
        path = tmp_path / "latch.json"
        path.write_text(json.dumps(document))
        return str(path)

    return write


class TestDocuments:
    def test_reading(self):
        problem, sensors = parse_sensed_problem(json.dumps(LATCH))
        assert problem.name == "latch"
        assert sensors["eye"].likelihood[1] == (mpq(1, 5), mpq(4, 5))
        assert sensors["eye"].cost == mpq(1, 10)

    def test_writing_and_reading_again(self):
        problem, sensors = parse_sensed_problem(json.dumps(LATCH))
        document = problem_document(problem) | {"sensors": sensors_document(sensors)}
        assert parse_sensed_problem(json.dumps(document)) == (problem, sensors)

    def test_floats(self):
        document = LATCH | {"numbers": "float"}
        problem, sensors = parse_sensed_problem(json.dumps(document))
        assert sensors["eye"].likelihood[1] == (0.2, 0.8)
        again = problem_document(problem) | {"sensors": sensors_document(sensors)}
        assert parse_sensed_problem(json.dumps(again))[1] == sensors

    def test_no_sensors(self):
        document = {key: value for key, value in LATCH.items() if key != "sensors"}
        assert parse_sensed_problem(json.dumps(document))[1] == {}

    def test_labels_that_are_no_text_are_not_written(self):
        with pytest.raises(SensorError.__mro__[1], match="the label 0 is no text"):
            sensors_document({"x": Sensor.perfect([0, 1])})


class TestCosts:
    """The kind of cost says which planner it is."""

    PROBLEM, SENSORS = parse_sensed_problem(json.dumps(LATCH))

    def test_iterative(self):
        plan = plan_for_cost(self.PROBLEM, self.SENSORS, 2)
        other = iterative_sensor_plan(
            self.PROBLEM, self.SENSORS, 2, accepted=["open"], action_costs="1/4"
        )
        assert plan.expected_cost == other.expected_cost
        assert plan.round_cost == 1

    def test_any_goal(self):
        problem = self.PROBLEM.with_cost(IterativeCost(actions=0, test=2))
        assert plan_for_cost(problem, [], 0).expected_cost == 4

    def test_goal(self):
        problem = self.PROBLEM.with_cost(GoalCost("open", actions="1/100"))
        assert plan_for_cost(problem, [], 0).expected_cost == mpq(1, 2)
        # Pushing once brings nine of ten shut ones to open, at a cent.
        assert plan_for_cost(problem, [], 1).expected_cost == 1 - mpq("0.725") + mpq("0.01")
        # After light it pays as well: a cent against nine tenths of an eleventh. So looking first
        # saves nothing, unless a push costs more.
        free = self.SENSORS["eye"].with_cost(0)
        stages = ["sense", "act"]
        with_eye = plan_for_cost(problem, free, stages=stages)
        assert with_eye.expected_cost == 1 - mpq("0.725") + mpq("0.01")
        dear = self.PROBLEM.with_cost(GoalCost("open", actions="1/10"))
        saved = mpq("0.55") * mpq("0.1") - mpq("0.05") * mpq("0.9")
        assert plan_for_cost(dear, free, stages=stages).expected_cost == (
            1 - mpq("0.725") + mpq("0.1") - saved
        )
        assert with_eye.round_cost is None

    def test_other_kinds_are_refused(self):
        from stochgeom.decision.entropy import EntropyCost

        with pytest.raises(SensorError, match="no additive cost"):
            plan_for_cost(self.PROBLEM.with_cost(EntropyCost()), self.SENSORS, 1)


class TestDecide:
    def test_the_text(self, capsys, file):
        result = call(capsys, "decide", file(), "--horizon", "3")
        assert (result.code, result.out, result.err) == (0, PRINTED, "")

    def test_the_document(self, capsys, file):
        document = call(capsys, "decide", file(), "--horizon", "3", "--json").document
        assert document["schema"] == "stochgeom/decision-tree/1"
        assert document["plan"]["expected_cost"] == "1.6719"
        assert document["plan"]["tree"]["branches"][1]["then"]["act"] == "shake"
        assert document["sensors"]["eye"]["likelihood"]["shut"] == ["1/5", "4/5"]

    def test_out_of_time(self, capsys, file):
        out = call(capsys, "decide", file(), "--horizon", "3", "--time-limit", "0").out
        assert "NOT proven optimal: time was over; no plan costs less than 1.0000." in out

    def test_losses(self, capsys, file):
        """Shake: 1/8 stays jammed at 5; 1/4 + 1/4 + 1/8 are shut at 1."""
        path = file(cost={"kind": "additive", "states": {"jammed": 5, "shut": 1}, "actions": 0})
        out = call(capsys, "decide", path, "--horizon", "1").out
        assert "\n  do shake\n  end (1.2500)\n\ncost 1.2500\n" in out
        assert "a round costs" not in out


EYE = LATCH["sensors"]["eye"]
BAD = [
    ({}, [], "--horizon: missing; a problem with sensors needs one"),
    ({}, ["--horizon", "2", "--all"], "--all: not for problems with sensors"),
    ({}, ["--horizon", "2", "--threshold", "1"], "--threshold: not for problems with sensors"),
    ({}, ["--horizon", "20"], "readings make a tree of"),
    ({"sensors": [1]}, ["--horizon", "1"], "sensors: a list of 1; accepted: an object of sensors"),
    (
        {"sensors": {"eye": 1}},
        ["--horizon", "1"],
        "sensors, 'eye': the number 1; accepted: an object",
    ),
    ({"sensors": {"eye": EYE | {"x": 1}}}, ["--horizon", "1"], "sensors, 'eye', key 'x': accepted"),
    ({"sensors": {"eye": {"readings": ["a"]}}}, ["--horizon", "1"], "key likelihood: missing"),
    (
        {"sensors": {"eye": EYE | {"readings": [[1]]}}},
        ["--horizon", "1"],
        "readings: a list of 1; accepted: a list of text",
    ),
    ({"sensors": {"eye": EYE | {"likelihood": "x"}}}, ["--horizon", "1"], "an object of rows"),
    (
        {"sensors": {"eye": EYE | {"likelihood": {"open": [1, 0]}}}},
        ["--horizon", "1"],
        "sensors, 'eye': state 'shut' has no likelihood",
    ),
    (
        {"sensors": {"eye": EYE | {"likelihood": [[1, 0], [1, 0], ["0.5", "0.6"]]}}},
        ["--horizon", "1"],
        "sensors, 'eye', likelihood of state 'jammed': the sum is 11/10",
    ),
    (
        {"sensors": {"eye": EYE | {"likelihood": [[1, 0], [1, 0], [1]]}}},
        ["--horizon", "1"],
        "likelihood of state 'jammed': 1 likelihoods; accepted: 2",
    ),
    ({"sensors": {"eye": EYE | {"cost": -1}}}, ["--horizon", "1"], "cost of a sensor"),
    ({"cost": {"kind": "entropy"}}, ["--horizon", "1"], "no additive cost; accepted"),
    ({"cost": None}, ["--horizon", "1"], "key cost: missing"),
]


@pytest.mark.parametrize(("changes", "arguments", "message"), BAD, ids=[m for _, _, m in BAD])
def test_bad_input_is_one_line_and_code_2(capsys, file, changes, arguments, message):
    result = call(capsys, "decide", file(**changes), *arguments)
    assert (result.code, result.out) == (2, "")
    assert message in result.err
    assert result.err.count("\n") == 1
