"""A feeder drawn from a plan (thesis Fig. 4.2): who stands where, and what the filter does."""

from __future__ import annotations

import math
from decimal import Decimal

import numpy as np
import pytest
from gmpy2 import mpq
from hypothesis import given, settings
from hypothesis import strategies as st

from stochgeom.decision.density_priors import WrappedNormal
from stochgeom.decision.discrete_prior import DiscretePrior
from stochgeom.decision.piecewise_prior import PiecewisePrior
from stochgeom.errors import InputError
from stochgeom.exact.angles import ZERO, Angle
from stochgeom.exact.ratios import TurnRatio
from stochgeom.exact.shadows import shadow
from stochgeom.feeding.adversarial import FAMILIES
from stochgeom.feeding.planner import plan_feeding, plan_transfer
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.geometry.part import Part
from stochgeom.plotting.feeder_scenes import (
    feeder_of,
    feeder_scene,
    random_orientations,
    stations_of,
)
from stochgeom.plotting.silhouettes import silhouette
from stochgeom.plotting.source_figures import NINE_SIDED
from stochgeom.thesis.parts import catalogue_names, catalogue_part
from tests.scene_checks import overlapping_labels
from tests.strategies import pushable_parts

QUAD = FeedingProblem(catalogue_part("4gon")).geometric_plan()
BOTH = pytest.mark.parametrize("up_to_symmetry", [False, True])


def feeder(plan, parts=3, seed=1990, *, up_to_symmetry=False):
    return feeder_of(plan, parts, seed, up_to_symmetry=up_to_symmetry)


def turns_of(scene, part) -> list[tuple[float, float, float]]:
    """Return x and y of each part drawn and by how much it is turned, read off its heading."""
    body = silhouette(part, 150)
    base = body.outline[0] - np.array(body.mass)
    found = []
    for line in scene.of_style("heading"):
        mass, first = np.array(line.points[0]), np.array(line.points[1])
        angle = math.atan2(*(first - mass)[::-1]) - math.atan2(*base[::-1])
        c, s = math.cos(angle), math.sin(angle)
        middle = mass - np.array([[c, -s], [s, c]]) @ np.array(body.mass)
        found.append((float(middle[0]), float(middle[1]), math.degrees(angle) % 360))
    return found


def same(one: float, other: float) -> bool:
    return abs((one - other + 180) % 360 - 180) < 1e-6


def degrees(*angles: Angle) -> float:
    return math.degrees(sum(map(shadow, angles)))


class TestWhoStandsWhere:
    @pytest.mark.parametrize("action", ["squeeze", "push-grasp"])
    @pytest.mark.parametrize("name", ["4gon", "5gon", "house", "key"])
    def test_parts_are_where_the_plan_has_brought_them(self, name, action):
        plan = FeedingProblem(catalogue_part(name), action).geometric_plan()
        made = feeder(plan)
        shown = [row for row in turns_of(feeder_scene(made), plan.part) if abs(row[1]) < 1e-6]
        shown.sort()
        # From left to right: those that wait, the last to come first; stations; filter; leaving.
        waiting, shown = shown[:3], shown[3:]
        for (_, _, turn), theta in zip(waiting, made.thetas[::-1], strict=False):
            assert same(turn, degrees(theta))
        for k, angle in enumerate(plan.cumulative_angles):
            theta = made.thetas[plan.steps - k]
            assert same(shown[k][2], degrees(plan.execute(theta)[k + 1], angle))
        leaving = shown[plan.steps :]
        if made.needs_filter:
            at_filter = plan.execute(made.thetas[0])[-1]
            assert same(leaving[0][2], degrees(at_filter, plan.cumulative_angles[-1]))
            leaving = leaving[1:]
        assert len(leaving) == 3
        for _, _, turn in leaving:
            assert same(turn, degrees(plan.final_orientation, plan.cumulative_angles[-1]))

    def test_jaws_stand_at_the_angles_of_the_plan(self):
        scene = feeder_scene(feeder(QUAD))
        jaws = [np.array(jaw.points) for jaw in scene.of_style("jaw")]
        assert len(jaws) == 2 * QUAD.steps
        for k, angle in enumerate(QUAD.cumulative_angles):
            for jaw in jaws[2 * k : 2 * k + 2]:
                x, y = jaw[1] - jaw[0]
                assert same(math.degrees(math.atan2(y, x)), degrees(angle))
            heading = f"at {angle.degrees(1)}°" if k else "at any angle"
            assert heading in scene.labels()

    def test_jaws_touch_the_part_and_do_not_cut_it(self):
        scene = feeder_scene(feeder(QUAD))
        shapes = scene.shapes
        lower = [jaw for jaw in scene.of_style("jaw") if len(jaw.points) > 4]  # it has the stub
        assert len(lower) == QUAD.steps
        for jaw in lower:
            part = next(s for s in shapes[shapes.index(jaw) :] if getattr(s, "style", "") == "part")
            (a, b), (c, d) = jaw.points[:2]  # the face of the lower jaw
            length = math.hypot(c - a, d - b)
            heights = [((c - a) * (y - b) - (d - b) * (x - a)) / length for x, y in part.points]
            assert min(heights) == pytest.approx(0, abs=1e-9)

    def test_the_pushing_jaw_is_dark(self):
        plan = FeedingProblem(catalogue_part("house"), "push-grasp").geometric_plan()
        scene = feeder_scene(feeder(plan))
        assert len(scene.of_style("pushing")) == len(scene.of_style("jaw")) == plan.steps

    def test_of_a_long_plan_the_first_and_the_last_actions(self):
        plan = FeedingProblem(FAMILIES["long plans"](12, seed=1)).geometric_plan()
        assert plan.steps == 13
        assert stations_of(plan) == [1, 2, 3, 4, 0, 11, 12, 13]
        scene = feeder_scene(feeder(plan))
        assert "6 more" in scene.labels()
        assert "squeeze 13" in scene.labels()
        assert "squeeze 5" not in scene.labels()
        assert stations_of(QUAD) == [1, 2, 3, 4]

    def test_the_same_seed_is_the_same_picture(self):
        one, two, other = (feeder_scene(feeder(QUAD, 2, seed)) for seed in (7, 7, 8))
        assert one == two
        assert one != other


class TestTheFilter:
    @BOTH
    @pytest.mark.parametrize("action", ["squeeze", "push-grasp"])
    @pytest.mark.parametrize("name", catalogue_names())
    def test_it_passes_the_share_that_ends_where_it_accepts(self, name, action, up_to_symmetry):
        """The plan's probability, against the widths of the states of its last distribution."""
        problem = FeedingProblem(catalogue_part(name), action)
        for steps in range(1, problem.geometric_plan().steps + 1):
            plan = problem.plan_of(steps)
            made = feeder(plan, up_to_symmetry=up_to_symmetry)
            state = plan.distribution()
            pairs = zip(state.orientations, state.widths, strict=True)
            accepted = sum((width for theta, width in pairs if made.accepts(theta)), start=ZERO)
            assert str(made.accepted) == TurnRatio(mpq(1), accepted).decimal(3)
            assert made.accepted + made.refused == 1
            assert made.needs_filter == (accepted < Angle(1))

    def test_what_it_refuses_is_on_the_belt_below(self):
        scene = feeder_scene(feeder(QUAD))
        assert "passes 0.500" in scene.labels()
        assert scene.labels()[-7:-4] == ["sent around again: 0.500", "in 1 orientation", "0.500"]
        below = [row for row in turns_of(scene, QUAD.part) if row[1] < -1]
        (refused,) = below
        final = degrees(QUAD.final_orientation, QUAD.cumulative_angles[-1])
        assert same(refused[2], final + 180)

    def test_the_likeliest_come_first_and_some_are_left_out(self):
        plan = FeedingProblem(Part(NINE_SIDED)).plan_of(1)
        scene = feeder_scene(feeder(plan, 12))
        shares = [text for text in scene.labels() if text.startswith("0.")]
        assert "in 13 orientations" in scene.labels()
        assert 1 < len(set(shares)) < len(shares) < 13
        assert shares == sorted(shares, reverse=True)
        # Half a turn from the final orientation, and as likely.
        assert shares[0] == plan.probability.decimal(3)

    def test_without_one_everything_passes(self):
        sure = FeedingProblem(catalogue_part("4gon"), "push-grasp").geometric_plan()
        alike = feeder_scene(feeder(plan_feeding(catalogue_part("rectangle")), up_to_symmetry=True))
        for scene in (feeder_scene(feeder(sure)), alike):
            assert scene.of_style("palm") == []
            assert not any("filter" in text or "again" in text for text in scene.labels())
        assert "at 180.0° in the gripper, or alike" in alike.labels()
        turns = [row[2] for row in turns_of(alike, catalogue_part("rectangle"))][-3:]
        assert same(turns[1], turns[0] + 180)
        assert same(turns[2], turns[0])

    def test_next_to_nothing_is_not_nothing(self):
        prior = WrappedNormal("90", "20")
        scene = feeder_scene(feeder(plan_feeding(catalogue_part("house"), prior=prior)))
        assert "passes over 0.999" in scene.labels()
        assert "sent around again: under 0.001" in scene.labels()
        assert "<.001" in scene.labels()

    def test_what_a_prior_makes_impossible_is_not_sent_around(self):
        prior = DiscretePrior.from_counts({"0": 50, "90": 30})
        plan = plan_feeding(catalogue_part("house"), prior=prior)
        possible = plan.distribution().possible()
        refused = len(possible) - 1
        assert refused < len(plan.distribution()) - 1
        made = feeder(plan)
        below = [row for row in turns_of(feeder_scene(made), plan.part) if row[1] < -1]
        assert len(below) == refused
        assert made.needs_filter == (refused > 0) == (plan.probability < 1)
        assert not any("<" in text or "under" in text for text in feeder_scene(made).labels())

    def test_a_plan_that_bears_the_error_for_all_that_arrive_needs_no_filter(self):
        prior = DiscretePrior.from_counts({"0": 50, "90": 30})
        made = feeder(plan_feeding(catalogue_part("5gon"), prior=prior, gripper_error="2"))
        assert made.plan.probability == 1
        assert not made.needs_filter

    def test_of_a_gripper_that_errs_it_is_a_bound(self):
        problem = FeedingProblem([(0, 0), (9, 0), (10, 3), (7, 8), (2, 6)], gripper_error="3")
        scene = feeder_scene(feeder(problem.geometric_plan()))
        assert "passes ≥ 0.500" in scene.labels()
        assert "sent around again: ≤ 0.500" in scene.labels()

    def test_a_bound_is_not_rounded_up(self):
        """A nearest decimal above the share would be no bound of it."""
        plan = FeedingProblem(catalogue_part("house"), gripper_error="3").plan_of(1)
        assert plan.probability.decimal(5) == "0.39758"
        labels = feeder_scene(feeder(plan)).labels()
        assert "passes ≥ 0.397" in labels
        assert "sent around again: ≤ 0.603" in labels

    def test_what_cannot_occur_is_not_sent_around_again(self):
        prior = DiscretePrior.from_counts({"17": 1})
        plan = plan_feeding(catalogue_part("house"), prior=prior)
        assert len(plan.distribution()) > 1
        scene = feeder_scene(feeder(plan))
        assert not any("filter" in text or "again" in text for text in scene.labels())

    def test_of_two_that_arrive_one_may_be_sent_around_again(self):
        prior = DiscretePrior.from_counts({"17": 2, "197": 1})
        plan = plan_feeding(catalogue_part("house"), prior=prior)
        labels = feeder_scene(feeder(plan)).labels()
        assert "passes 0.667" in labels
        again = labels.index("sent around again: 0.333")
        assert labels[again + 1 : again + 3] == ["in 1 orientation", "0.333"]


class TestRandomOrientations:
    def test_uniform(self):
        found = random_orientations(None, 2000, np.random.default_rng(0))
        tenths = [theta.rational_turns * 3600 for theta in found]
        assert all(tenth.denominator == 1 for tenth in tenths)
        assert 0 <= min(tenths) < 20
        assert 3580 < max(tenths) < 3600

    def test_of_a_discrete_prior_only_its_orientations(self):
        third, flat = Angle(0, (2, 1)), Angle.from_degrees(71)
        prior = DiscretePrior([(third, "1/3"), (flat, "2/3")])
        found = random_orientations(prior, 600, np.random.default_rng(0))
        assert set(found) == {third, flat}
        assert 150 < found.count(third) < 250

    def test_of_a_density_none_where_there_is_none(self):
        prior = PiecewisePrior.from_histogram(["0", "30", "90", "360"], [1, 3, 0])
        found = random_orientations(prior, 800, np.random.default_rng(0))
        shown = [float(theta.rational_turns * 360) for theta in found]
        assert max(shown) < 90
        assert 150 < sum(theta < 30 for theta in shown) < 250

    def test_the_prior_is_described(self):
        prior = WrappedNormal("90", "20")
        scene = feeder_scene(feeder(plan_feeding(catalogue_part("house"), prior=prior)))
        assert "as the prior says" in scene.labels()
        assert any(text.startswith("prior: normal, mean 90") for text in scene.labels())


@given(
    pushable_parts(),
    st.sampled_from(["squeeze", "push-grasp"]),
    st.integers(1, 4),
    st.booleans(),
)
@settings(max_examples=50)
def test_labels_stand_apart(part, action, parts, up_to_symmetry):
    problem = FeedingProblem(part, action)
    for plan in (problem.geometric_plan(), problem.plan_of(1)):
        made = feeder(plan, parts, parts, up_to_symmetry=up_to_symmetry)
        scene = feeder_scene(made)
        assert overlapping_labels(scene) == []
        again = [text for text in scene.labels() if text.startswith("sent around again")]
        assert len(again) == made.needs_filter
        assert 0 <= made.refused <= Decimal(1)


def test_labels_stand_apart_where_the_filter_refuses_next_to_nothing():
    """Found with a sliver: "passes over 0.999" ran into what is written beside it."""
    plan = FeedingProblem(FAMILIES["slivers"](9, seed=1)).plan_of(1)
    scene = feeder_scene(feeder(plan, up_to_symmetry=True))
    assert "passes over 0.999" in scene.labels()
    assert overlapping_labels(scene) == []


class TestBadInput:
    @pytest.mark.parametrize(
        ("call", "message"),
        [
            (lambda: feeder("house"), "not FeedingPlan; accepted: a plan"),
            (lambda: feeder(plan_transfer(QUAD.transfer)), "no part to draw; accepted: a part's"),
            (lambda: feeder(QUAD, 0), "0 parts on the belt; accepted: whole numbers from 1 to 12"),
            (lambda: feeder(QUAD, 13), "13 parts on the belt"),
            (lambda: feeder(QUAD, 2.5), "2.5 parts on the belt"),
            (lambda: feeder(QUAD, 3, None), "None as the seed; accepted: whole numbers from 0 on"),
            (lambda: feeder(QUAD, 3, -1), "-1 as the seed"),
            (lambda: feeder(QUAD, 3, "1"), "'1' as the seed"),
            (lambda: feeder(QUAD, 3, 0.5), "0.5 as the seed"),
        ],
    )
    def test_it_is_refused(self, call, message):
        with pytest.raises(InputError, match=message):
            call()


def test_a_part_over_a_field():
    made = feeder(plan_feeding(Part.regular(5)))
    assert overlapping_labels(feeder_scene(made)) == []
