"""The experiment's bookkeeping, and the posterior's errors."""

from __future__ import annotations

import sys

import pytest
from gmpy2 import mpq

from stochgeom.errors import InputError, MissingExtraError, NoPlanError, RecordingError
from stochgeom.tilting.all_plans import best_tilt_plan, best_tilt_plans, first_best
from stochgeom.tilting.bounded_search import bounded_tilt_search
from stochgeom.tilting.counts import OTHER, TransitionCounts
from stochgeom.tilting.estimation import TransitionModel
from stochgeom.tilting.experiment import (
    Calibration,
    MeasuredPlan,
    measure_tilt_plans,
    trials_study,
)
from stochgeom.tilting.intervals import wilson_interval
from stochgeom.tilting.posterior import (
    credible_interval,
    posterior_median,
    predictive_check,
    sample_matrices,
)
from stochgeom.tilting.robot import SimulatedRobot
from stochgeom.tilting.shortest_path import shortest_path_tilt_plan
from stochgeom.tilting.tilt_plans import TiltPlan, evaluate_tilt_plan
from stochgeom.tilting.tray import TraySetup
from stochgeom.tilting.uncertain_plans import best_expected_tilt_plan

MODEL = TransitionModel(TransitionCounts([[[3, 1, 0], [0, 0, 0]], [[0] * 3] * 2]), 1)
COARSE = TraySetup().with_solver(time_step=0.004, iterations=5, support_points=1)


def plan(probability, steps=1, actions=None):
    tilts = tuple(actions or [1] * steps)
    return TiltPlan(1, 2, tilts, mpq(probability), "given")


ROWS = (
    MeasuredPlan(plan("1/2"), 100, 50, 3),
    MeasuredPlan(plan("9/10", 2), 100, 60, 0),
    MeasuredPlan(plan("1", 3), 100, 100, 0),
)


class TestCalibration:
    found = Calibration(MODEL, ROWS)

    def test_means(self):
        assert self.found.estimated == pytest.approx(0.8)
        assert self.found.measured == pytest.approx(0.7)
        assert (self.found.mean_tilts, self.found.sd_tilts) == (2, 1)

    def test_an_interval_holds_the_estimate_or_not(self):
        assert [row.is_covered for row in ROWS] == [True, False, True]
        assert self.found.covered == pytest.approx(2 / 3)

    def test_bins_hold_every_plan_once(self):
        assert self.found.bins([0, 0.5, 0.9, 1.0]) == [(0.5, 0.5, 1), (0.95, 0.8, 2)]
        assert sum(size for *_, size in self.found.bins([0.0, 0.25, 1.0])) == 3


def test_plans_are_measured_on_the_robot():
    """The executions are those of the robot, whatever the model believed."""
    robot = SimulatedRobot(COARSE, seed=2)
    (row,) = measure_tilt_plans(robot, [TiltPlan(1, 3, (4,), mpq(1, 7), "given")], 40)
    ends = robot.execute(1, (4,), 40)
    assert (row.successes, row.others) == (ends[3], ends[OTHER])
    assert row.estimated == pytest.approx(1 / 7)


def test_each_recording_continues_the_one_before():
    told = []
    study = trials_study(SimulatedRobot(COARSE, seed=2), (30, 60), 1, tell=told.append)
    small, large = (study[size].model.counts for size in (30, 60))
    assert (small.total, large.total) == (30, 60)
    assert (large.table >= small.table).all()
    assert len(study[30].rows) == 132
    assert told == sorted(told)
    assert told[-1] == 1.0
    with pytest.raises(InputError, match="no numbers of trials"):
        trials_study(SimulatedRobot(COARSE), ())


class TestPlanners:
    def test_ties_go_to_fewer_tilts_then_to_the_first(self):
        plans = [plan("1/2", 2), plan("1/2", actions=[2]), plan("1/2", actions=[1]), plan("1/3")]
        assert first_best(plans).actions == (1,)
        assert first_best([plan("1/2", actions=[1, 1]), plan("1/2", actions=[2])]).actions == (2,)

    def test_a_start_at_the_goal_needs_no_tilt(self):
        for planner in (best_tilt_plan, shortest_path_tilt_plan, best_expected_tilt_plan):
            assert planner(MODEL, 2, 2, 3).actions == ()
        assert bounded_tilt_search(MODEL, 2, 2).plan.actions == ()

    def test_what_was_never_tried_is_told_or_left_out(self):
        untried = evaluate_tilt_plan(MODEL, 1, 2, (2, 1))
        assert untried.unobserved == ((2, 1), (1, 2))
        # One in three by the prior is more than the two in seven of the tilt observed.
        assert best_tilt_plan(MODEL, 1, 2, 1).actions == (2,)
        assert best_tilt_plan(MODEL, 1, 2, 1, observed_only=True).actions == (1,)
        observed = best_tilt_plans(MODEL, observed_only=True)
        assert all(2 not in found.actions for found in observed.values())

    def test_nothing_observed_at_all(self):
        empty = TransitionModel(TransitionCounts([[[0, 0], [0, 0]]]))
        assert best_tilt_plan(empty, 1, 2).probability == mpq(1, 2)
        with pytest.raises(RecordingError, match="no action was ever observed"):
            best_tilt_plan(empty, 1, 2, observed_only=True)

    def test_a_path_may_need_more_tilts_than_allowed(self):
        with pytest.raises(NoPlanError, match="at most 0 tilts leads from 1 to 2"):
            shortest_path_tilt_plan(MODEL, 1, 2, 0)

    @pytest.mark.parametrize(
        "ask",
        [
            lambda: best_tilt_plan(MODEL, 3, 1),
            lambda: best_tilt_plan(MODEL, 1, 0),
            lambda: shortest_path_tilt_plan(MODEL, 1, OTHER),
            lambda: evaluate_tilt_plan(MODEL, 1, 2, (3,)),
        ],
    )
    def test_states_and_tilts_have_to_exist(self, ask):
        with pytest.raises(RecordingError, match="accepted: 1 to 2"):
            ask()

    @pytest.mark.parametrize(
        "ask",
        [
            lambda: best_tilt_plan(MODEL, 1, 2, -1),
            lambda: best_tilt_plan(MODEL, 1, 2, 1.5),
            lambda: best_tilt_plan(MODEL, 1, 2, 40),
            lambda: best_expected_tilt_plan(MODEL, 1, 2, 17),
            lambda: bounded_tilt_search(MODEL, 1, 2, node_limit=0),
        ],
    )
    def test_horizons_are_checked(self, ask):
        with pytest.raises(InputError, match="accepted: "):
            ask()

    def test_branch_and_bound_goes_where_lists_do_not(self):
        """Twelve tilts of two actions, with a proof."""
        found = bounded_tilt_search(MODEL, 1, 2, 12)
        assert found.complete
        assert found.nodes < found.of == 2**13 - 1
        assert found.plan.probability >= best_tilt_plan(MODEL, 1, 2, 6).probability


class TestErrors:
    @pytest.mark.parametrize("level", [0, 1, -0.5, float("nan")])
    def test_levels_are_between_0_and_1(self, level):
        with pytest.raises(InputError, match="accepted: above 0, below 1"):
            credible_interval(MODEL, 1, 1, 1, level)
        with pytest.raises(InputError, match=r"a level of .*; accepted: above 0, below 1"):
            wilson_interval(1, 2, level)

    @pytest.mark.parametrize(("k", "n"), [(-1, 2), (3, 2), (0, 0)])
    def test_shares_are_of_something(self, k, n):
        with pytest.raises(InputError, match="accepted: whole numbers from"):
            wilson_interval(k, n)

    def test_draws_are_positive(self):
        with pytest.raises(InputError, match="0 draws"):
            sample_matrices(MODEL, 0)
        with pytest.raises(InputError, match="0 draws"):
            predictive_check(MODEL, MODEL.counts, draws=0)
        with pytest.raises(RecordingError, match="counts of shape"):
            predictive_check(MODEL, TransitionCounts([[[1]]]))

    def test_quantiles_name_their_extra(self, monkeypatch):
        monkeypatch.setitem(sys.modules, "scipy.stats", None)
        with pytest.raises(MissingExtraError, match=r"stochgeom\[numeric\]"):
            posterior_median(MODEL, 1, 1, 1)
