"""Values of the wrong type at the public doors: an error of the family that names the value.

Found by calling every public callable with a matrix of such values; kept are those that a user
could plausibly hand in.
"""

from __future__ import annotations

import random

import numpy as np
import pytest

import stochgeom as sg
from stochgeom.arguments import as_count, as_list, expect
from stochgeom.errors import InputError, NumberError, PriorError, SensorError, StochgeomError
from stochgeom.tilting.counts import TransitionCounts

RECTANGLE = [(0, 0), (3, 0), (3, 2), (0, 2)]
QUARTER = sg.QUARTER_TURN


@pytest.fixture(scope="module")
def part():
    return sg.Part(RECTANGLE)


@pytest.fixture(scope="module")
def problem():
    return sg.planning_problem_of(RECTANGLE).problem


@pytest.fixture(scope="module")
def model():
    return sg.TransitionModel(TransitionCounts([[[3, 1], [1, 3]]]), alpha=1)


def assert_refuses(function, *words, kind=InputError):
    """It is refused by an error of the family, on one line that names the value."""
    with pytest.raises(StochgeomError) as caught:
        function()
    assert isinstance(caught.value, kind)
    assert "accepted: " in caught.value.message
    assert "\n" not in str(caught.value)
    for word in words:
        assert word in str(caught.value)


class TestAngles:
    @pytest.mark.parametrize(
        "terms",
        [[(1, 5)], [5], 5, "ab", [(1, "5")], [(1, None)], [(1, QUARTER, 2)], None, [None], {1: 2}],
    )
    def test_terms_that_are_no_pairs(self, terms):
        assert_refuses(lambda: sg.sign_of_form(1, terms), "terms: ", kind=NumberError)
        assert_refuses(lambda: sg.AngleSum(1, terms), "terms: ", kind=NumberError)

    def test_a_float_coefficient_has_its_own_error(self):
        for function in (sg.sign_of_form, sg.AngleSum):
            with pytest.raises(sg.errors.FloatRefusedError):
                function(1, [(0.5, QUARTER)])

    @pytest.mark.parametrize("terms", [[(1, 1.5)], [(1, "3")], [5], "ab", None])
    def test_terms_of_roots_and_logarithms(self, terms):
        assert_refuses(lambda: sg.RootSum(0, terms), "terms: ", kind=NumberError)
        assert_refuses(lambda: sg.LogSum(0, terms), "terms: ", kind=NumberError)

    @pytest.mark.parametrize("width", [None, 1, "90", 1.5, sg.AngleSum(1)])
    def test_widths(self, width):
        assert_refuses(lambda: sg.ClosedArc(sg.ZERO, width), "two Angles")
        assert_refuses(lambda: sg.Interval(sg.ZERO, width, True, True), "two Angles")
        assert_refuses(lambda: sg.HalfAngle.of(width), repr(width)[:60])

    def test_sets(self):
        assert_refuses(lambda: sg.union_arcs([QUARTER]), "arc 0: ")
        assert_refuses(lambda: sg.union_arcs("ab"), "arcs: 'ab'")
        assert_refuses(lambda: sg.union_arcs([], 360), "period: 360")
        assert_refuses(lambda: sg.union_arcs([], sg.ZERO), "period", "up to 360")
        assert_refuses(lambda: sg.CellSet.at([90]), "orientation 0: 90")
        assert_refuses(lambda: sg.CellSet.of([QUARTER]), "interval 0: ")
        assert_refuses(lambda: sg.CellSet([90], [True], [False]), "critical orientation 0: 90")


class TestFeeding:
    @pytest.mark.parametrize("steps", ["2", None, 1.0, 2.5, True, [1], 0, -1])
    def test_numbers_of_steps(self, part, steps):
        problem = sg.FeedingProblem(part)
        assert_refuses(lambda: problem.plan_of(steps), repr(steps), "steps")
        assert_refuses(lambda: problem.preimages.of_steps(steps), repr(steps))
        assert problem.plan_of(np.int64(2)).steps == 2

    def test_what_is_no_step_function(self, part):
        assert_refuses(lambda: sg.Preimages(part), "transfer: Part(", "squeeze_function(part)")
        assert_refuses(lambda: sg.StepFunction("ab", "cd"), "breaks: 'ab'")
        assert_refuses(lambda: sg.StepFunction(None, None), "breaks: None")

    def test_angles_and_claims(self, part):
        report = sg.verify_plan(part, "0, -45")
        assert_refuses(lambda: sg.verify_plan(part, 45), "angles: 45")
        assert_refuses(lambda: sg.parse_angles([45]), "angles: [45]")
        assert_refuses(lambda: sg.check_claim(report, 0.5), "claim: 0.5")
        assert_refuses(lambda: sg.check_claim("0", "probability=1"), "'0'")

    def test_costs_of_grasps(self, part):
        assert_refuses(lambda: sg.plan_weighing_grasps(part, 1), "1 is of type int")

    def test_priors(self, part):
        assert_refuses(lambda: sg.planning_problem_of(part, prior="uniform"), "prior: 'uniform'")
        assert_refuses(lambda: sg.GraspReport(part, "1/4", prior="uniform"), "prior: 'uniform'")
        make = sg.PiecewisePrior
        assert_refuses(lambda: make.from_histogram(None, [1]), "edges: None", kind=PriorError)
        assert_refuses(lambda: make.from_histogram([0, 90], 1), "counts: 1", kind=PriorError)
        assert_refuses(lambda: make.from_measurements("45"), "'45'", kind=PriorError)
        assert_refuses(lambda: make.from_measurements(["45"], True), "True bins", kind=PriorError)
        assert_refuses(lambda: sg.DiscretePrior.from_measurements(45), "45", kind=PriorError)
        assert_refuses(lambda: sg.cells_between([QUARTER]), "mouth 0: ")
        assert_refuses(lambda: sg.cells_between([], 10**400), "bins", kind=PriorError)
        assert_refuses(lambda: sg.Rejections(None, []), "cells: None")
        assert_refuses(lambda: sg.Rejections([QUARTER], [1]), "observation 0: 1")

    def test_files(self):
        assert_refuses(lambda: sg.load_part(None), "source: None")
        assert_refuses(lambda: sg.load_part("house", center_of_mass=(0, 0)), "(0, 0)")
        assert_refuses(lambda: sg.parse_outline(b"0 0"), "outline: b'0 0'")
        assert_refuses(lambda: sg.catalogue_part(["house"]), "['house']")
        assert_refuses(lambda: sg.find_errata(7.5), "erratum: 7.5")
        assert_refuses(lambda: sg.save_figure(None, None), "path: None")


class TestDecision:
    @pytest.mark.parametrize("given", [None, "coin.json", RECTANGLE, sg.ZERO])
    def test_what_is_no_problem(self, given):
        for function in (
            lambda: sg.find_plan(given, 2),
            lambda: sg.best_action(given),
            lambda: sg.random_plan(given, 2, seed=1),
            lambda: sg.observed_policy(given, 2),
            lambda: sg.write_pomdp(given),
            lambda: sg.problem_document(given),
            lambda: next(iter(sg.every_plan(given, 2))),
            lambda: sg.two_argmins(given, max),
            lambda: sg.sensor_plan(given, [], 1),
            lambda: sg.iterative_sensor_plan(given, [], 1),
            lambda: sg.plan_for_cost(given, [], 1),
            lambda: sg.calibration_problem(given, {}),
            lambda: sg.place_sensor(given, max, {}, 1),
            lambda: sg.randomised_minimax(given),
        ):
            assert_refuses(function, repr(given)[:20])

    @pytest.mark.parametrize("horizon", ["2", None, 1.5, True, -1])
    def test_horizons(self, problem, horizon):
        assert_refuses(lambda: next(sg.every_plan(problem, horizon)), f"horizon: {horizon!r}")
        assert_refuses(lambda: sg.random_plan(problem, horizon, seed=1), f"horizon: {horizon!r}")

    def test_probabilities(self):
        assert_refuses(lambda: sg.entropy(None), "distribution: None")
        assert_refuses(lambda: sg.entropy("1/2"), "distribution: '1/2'")
        assert_refuses(lambda: sg.cyclic_difference(1, 2), "1; accepted")
        assert_refuses(lambda: sg.circular_variance([90], [1]), "orientation 0: 90")
        assert_refuses(lambda: sg.circular_variance([QUARTER], []), "0 probabilities")
        for shares in (["1/2", "3/2"], ["-1", "2"]):
            assert_refuses(lambda p=shares: sg.circular_variance([QUARTER] * 2, p), "probabilities")
        assert_refuses(lambda: sg.PlanningProblem.from_matrices(1, []), "prior: 1")
        assert_refuses(lambda: sg.PlanningProblem.from_matrices([1], 1), "matrices: 1")
        assert_refuses(lambda: sg.Rounds("one"), "'one'")
        assert sg.Rounds("1/6").mean == 6

    def test_costs_and_losses(self, problem):
        assert_refuses(lambda: sg.distance_cost(None, QUARTER), "orientations: None")
        assert_refuses(lambda: sg.distance_cost({"a": QUARTER}, 90), "goal: 90")
        assert_refuses(lambda: sg.two_argmins(problem, 1), "loss: 1")
        assert_refuses(lambda: sg.simulated_difference(1, 5, seed=0), "y: 1")
        assert_refuses(
            lambda: sg.simulated_difference(np.random.Generator.uniform, "5", seed=0), "'5' draws"
        )

    def test_sensors(self, part, problem):
        blind = sg.Sensor.blind(problem.states)
        assert_refuses(lambda: sg.fuse_sensors(blind, None), "None is of type NoneType")
        assert_refuses(lambda: sg.one_step_plan(None, [1]), "None is of type NoneType")
        assert_refuses(lambda: sg.one_step_plan(blind, 1), "hyperstate: 1", kind=SensorError)
        assert_refuses(lambda: sg.Sensor.noisy(3, "1/10"), "states: 3")
        assert_refuses(lambda: sg.compare_sensors(problem, [blind], 1), "sensors: ")
        assert_refuses(lambda: sg.place_sensor(problem, 1, {1: 0}, 1), "see: 1")
        assert_refuses(lambda: sg.choose_bits(part, "2"), "most: '2' bits")
        assert_refuses(lambda: sg.sensor_from_counts("xy", {"a": {}}), "readings: 'xy'")
        assert_refuses(lambda: sg.sensor_from_counts(["x"], {"a": 1}), "counts of state 'a': 1")
        assert_refuses(lambda: sg.sampled_sensor(blind, 2.5), "times: 2.5", kind=SensorError)
        assert_refuses(lambda: sg.sampled_sensor(None, 2), "None is of type NoneType")
        assert_refuses(lambda: sg.diameter_sensor(part, 1, orientations=[QUARTER]), "orientations")
        assert_refuses(lambda: sg.SensingProblem(part, between=5), "range of the sensor: 5")
        assert_refuses(lambda: sg.SensingProblem(part, between=(1, 2, 3)), "(1, 2, 3)")
        assert_refuses(lambda: sg.SensingProblem(part, accepted=1.5), "accepted: 1.5")
        assert_refuses(lambda: sg.iterative_sensor_plan(problem, 1, 1), "sensors: 1")
        assert_refuses(lambda: sg.iterative_sensor_plan(problem, blind, stages="act"), "'act'")
        for horizon in ("2", None, 1.5, -1, 301, 10**9, 10**400):
            assert_refuses(lambda h=horizon: sg.iterative_sensor_plan(problem, blind, h), "horizon")
        for limit in ("5", 0, 1.5):
            assert_refuses(
                lambda n=limit: sg.iterative_sensor_plan(problem, blind, 1, node_limit=n),
                "node limit",
            )
        assert_refuses(lambda: sg.all_sensor_plans(3, blind, 1), "3 is of type int")
        assert_refuses(lambda: sg.expected_entropy(None), "None is of type NoneType")


class TestGraspingAndTilting:
    def test_diagrams(self, part):
        assert_refuses(lambda: sg.pushing_bound(part), "GraspDiagram(part, '1/4')")
        assert_refuses(lambda: sg.pushing_bounds(part), "GraspDiagram(part, '1/4')")
        assert_refuses(lambda: sg.density_after_push(part, QUARTER), "PushStability(part)")
        assert_refuses(lambda: sg.density_after_push(sg.PushStability(part), 90), "theta: 90")
        assert_refuses(lambda: sg.SqueezeStability(part, "1/4", contacts=1), "contacts: 1")
        assert_refuses(lambda: sg.convex_hull(RECTANGLE), "points: [(0, 0)", "Part(vertices).hull")
        assert_refuses(lambda: sg.antipodal_pairs(RECTANGLE), "Part(vertices).hull")

    @pytest.mark.parametrize("n", ["4", None, 4.0, True])
    def test_sides(self, n):
        assert_refuses(lambda: sg.regular_bound(n, "1/4"), f"{n!r} sides")

    @pytest.mark.parametrize("angle", [None, 1, "1/4"])
    def test_friction(self, angle):
        assert_refuses(lambda: sg.Friction(angle), "Friction.of(coefficient)")

    @pytest.mark.parametrize("given", [None, 1, [[[1]]]])
    def test_models(self, given):
        for function in (
            lambda: sg.TransitionModel(given),
            lambda: sg.evaluate_tilt_plan(given, 1, 2, [1]),
            lambda: sg.best_tilt_plan(given, 1, 2, 2),
            lambda: sg.best_tilt_plans(given, 2),
            lambda: sg.bounded_tilt_search(given, 1, 2, 2),
            lambda: sg.best_expected_tilt_plan(given, 1, 2, 2),
            lambda: sg.shortest_path_tilt_plan(given, 1, 2),
            lambda: sg.likeliest_tilts(given, [1]),
            lambda: sg.expected_probability(given, 1, 2, [1]),
            lambda: sg.posterior_median(given, 1, 1, 1),
            lambda: sg.credible_interval(given, 1, 1, 1),
            lambda: sg.sample_matrices(given, 2),
        ):
            assert_refuses(function, repr(given))

    def test_states_may_be_text_as_in_a_file(self, model):
        plans = [
            search(model, "1", "2", 2)
            for search in (
                sg.best_tilt_plan,
                sg.best_expected_tilt_plan,
                sg.shortest_path_tilt_plan,
                lambda *given: sg.bounded_tilt_search(*given).plan,
            )
        ]
        assert [(plan.start, plan.goal) for plan in plans] == [(1, 2)] * 4

    def test_numbers(self, model):
        assert_refuses(lambda: sg.sample_matrices(model, "5"), "'5' draws")
        assert_refuses(lambda: sg.sample_matrices(model, 5, seed=-1), "-1 as a seed")
        assert_refuses(lambda: sg.credible_interval(model, 1, 1, 1, "0.9"), "'0.9'")
        assert_refuses(lambda: sg.wilson_interval("3", 5), "'3' successes")
        assert_refuses(lambda: sg.wilson_interval(3, None), "None trials")
        assert_refuses(lambda: sg.wilson_interval(3, 5, float("nan")), "a level of nan")
        assert_refuses(lambda: sg.likeliest_tilts(model, []), "no tilts")
        assert_refuses(lambda: sg.evaluate_tilt_plan(model, 1, 2, None), "actions: None")
        matrices = sg.sample_matrices(model, 2)
        assert_refuses(lambda: sg.sampled_probabilities(matrices, 0, 1, [1]), "state '0'")
        assert_refuses(lambda: sg.sampled_probabilities(matrices, 1, 1, [-1]), "action '-1'")
        assert_refuses(lambda: sg.sampled_probabilities(model, 1, 1, [1]), "sample_matrices")
        assert_refuses(lambda: sg.predictive_check(model, None), "None is of type")
        assert_refuses(lambda: TransitionCounts.from_trials(None), "trials: None")
        assert_refuses(lambda: TransitionCounts.from_trials([5]), "trial 0: 5")
        assert_refuses(lambda: TransitionCounts.from_trials([], "12"), "'12' states")

    def test_the_simulator(self):
        setup = sg.TraySetup()
        assert_refuses(lambda: sg.SimulatedRobot("here"), "setup: 'here'")
        assert_refuses(lambda: sg.SimulatedGripper(friction="1/4"), "friction: '1/4'")
        assert_refuses(lambda: sg.SimulatedGripper(iterations=2.5), "2.5 iterations")
        assert_refuses(lambda: sg.slide_tile(setup, (0, 0, 0), None), "pose: (0, 0, 0)")
        assert_refuses(lambda: sg.tile_state(setup, (0, 0, 0)), "pose: (0, 0, 0)")
        source = np.random.default_rng(0)
        assert_refuses(lambda: sg.random_tile_pose(setup, 0, source), "0 as a state")
        assert_refuses(lambda: sg.random_tile_pose(setup, 1, random), "default_rng(seed)")
        assert_refuses(lambda: sg.measure_tilt_plans(None, []), "None is of type")
        assert_refuses(lambda: sg.measure_tilt_plans(sg.SimulatedRobot(), [1]), "plan 0: 1")
        assert sg.measure_tilt_plans(sg.SimulatedRobot(), []) == ()
        # Told before the trials are run:
        assert_refuses(lambda: sg.trials_study(sg.SimulatedRobot(), [9], 0), "0 executions")


class TestTheDoor:
    @pytest.mark.parametrize("value", [True, False, 1.0, "1", None, [1], int, np.array([1, 2])])
    def test_what_is_no_count(self, value):
        assert_refuses(lambda: as_count(value, "turns"), "turns; accepted: whole numbers from 1 on")

    def test_limits_of_counts(self):
        assert as_count(np.int8(3), "turns", most=3) == 3
        assert_refuses(lambda: as_count(4, "turns", most=3), "4 turns", "from 1 to 3")
        assert_refuses(lambda: as_count(-1, "turns", least=0), "-1 turns", "from 0 on")
        assert_refuses(lambda: as_count(10**5000, "turns", most=3), "turns")

    def test_numbers_of_numpy_are_computed_with_as_int(self, part, problem, model):
        """What is refused or accepted is also what is used: int8 would overflow."""
        small = np.int8
        assert sg.wilson_interval(small(100), small(120)) == sg.wilson_interval(100, 120)
        assert sg.regular_bound(small(5), "1/4") == sg.regular_bound(5, "1/4")
        assert len(sg.cells_between([], np.int64(4))) == 4
        assert sg.FeedingProblem(part).plan_of(np.int64(1)).steps == 1
        goal = sg.GoalCost(problem.states[0])
        found = sg.random_plan(problem, small(100), goal, tries=small(100), seed=small(1))
        assert found.nodes <= 10_000
        assert sg.best_tilt_plan(model, 1, 2, small(1)) == sg.best_tilt_plan(model, 1, 2, 1)
        assert_refuses(lambda: sg.FeedingProblem(part).plan_of(int), "<class 'int'> steps")

    def test_a_list_with_a_number_that_cannot_be_written(self):
        assert_refuses(lambda: as_count([10**5000], "turns"), "a list with an int of too many")

    def test_sources_of_priors(self):
        assert_refuses(lambda: sg.load_prior(3), "source: 3 is of type int, not str")

    def test_an_array_of_no_dimension_is_no_trial(self):
        trials = np.array([[1, 1, 2]])
        assert list(TransitionCounts.from_trials(trials, 2, 2).trials()) == [(1, 1, 2, 1)]
        for trial in (np.array(5), trials):
            assert_refuses(lambda t=trial: TransitionCounts.from_trials([t], 2, 2), "trial 0")

    def test_errors_of_an_iterator_are_its_own(self):
        def broken():
            yield 1
            raise TypeError("mine")

        with pytest.raises(TypeError, match="mine"):
            as_list(broken(), "a list")

    def test_unions(self):
        assert expect(1, int | str, "a number") == 1
        assert_refuses(lambda: expect(1.5, int | str, "a number", "here"), "here: 1.5", "int | str")
