"""Laws of estimates and of tilt plans."""

from __future__ import annotations

from hypothesis import given, settings

from stochgeom.errors import NoPlanError
from stochgeom.tilting.all_plans import best_tilt_plan, error_factor, plan_levels
from stochgeom.tilting.bounded_search import bounded_tilt_search, seeing_values
from stochgeom.tilting.shortest_path import shortest_path_tilt_plan
from stochgeom.tilting.tilt_plans import evaluate_tilt_plan, hyperstates
from stochgeom.tilting.uncertain_plans import (
    _Urns,
    best_expected_tilt_plan,
    expected_probability,
)
from tests.strategies import tilt_instances, transition_models

some = settings(max_examples=150)


@given(transition_models())
@some
def test_rows_are_distributions(model):
    for action in range(1, model.counts.actions + 1):
        for row in model.matrix(action):
            assert sum(row) == 1
            assert all(entry > 0 for entry in row)


@given(tilt_instances())
@some
def test_the_heuristic_is_between_its_bound_and_the_best(instance):
    model, start, goal = instance
    best = best_tilt_plan(model, start, goal, 3)
    path = shortest_path_tilt_plan(model, start, goal, 3)
    assert path.bound <= path.probability <= best.probability
    assert path.steps <= 3


@given(tilt_instances())
@some
def test_more_tilts_are_never_worse(instance):
    model, start, goal = instance
    found = [best_tilt_plan(model, start, goal, k).probability for k in range(4)]
    assert found == sorted(found)
    bounds = [shortest_path_tilt_plan(model, start, goal, k).bound for k in range(1, 4)]
    assert bounds == sorted(bounds)


@given(tilt_instances())
@some
def test_who_sees_the_state_does_at_least_as_well(instance):
    model, start, goal = instance
    actions = range(1, model.counts.actions + 1)
    values = seeing_values(model, goal, actions, 3)
    for tilts in range(4):
        assert values[tilts][start - 1] >= best_tilt_plan(model, start, goal, tilts).probability


@given(tilt_instances())
@some
def test_a_search_cut_short_says_what_may_be_missing(instance):
    model, start, goal = instance
    best = best_tilt_plan(model, start, goal)
    for limit in (1, 2, 5):
        found = bounded_tilt_search(model, start, goal, node_limit=limit)
        assert found.plan.probability <= best.probability <= found.limit
        if found.complete:
            assert found.plan.probability == best.probability


@given(tilt_instances())
@some
def test_floats_are_within_their_bound(instance):
    model, start, goal = instance
    actions = tuple(range(1, model.counts.actions + 1))
    levels = plan_levels(model, start, actions, 3)
    word = tuple(actions[k % len(actions)] for k in (2, 0, 1))
    row = 0
    for action in word:
        row = row * len(actions) + action - 1
    exact = evaluate_tilt_plan(model, start, goal, word).probability
    near = levels[3][row, goal - 1]
    assert abs(near - exact) <= error_factor(3, len(model.counts.outcomes)) * exact


@given(tilt_instances())
@some
def test_hyperstates_stay_distributions_and_lose_nothing(instance):
    model, start, _ = instance
    passed = hyperstates(model, start, [1, model.counts.actions, 1])
    assert all(sum(state) == 1 for state in passed)
    if model.counts.has_other:
        lost = [state[-1] for state in passed]
        assert lost == sorted(lost)


@given(tilt_instances())
@some
def test_without_a_repeated_tilt_the_plug_in_is_the_expectation(instance):
    model, start, goal = instance
    word = tuple(range(1, model.counts.actions + 1))
    plug_in = evaluate_tilt_plan(model, start, goal, word).probability
    assert expected_probability(model, start, goal, word) == plug_in
    assert _Urns(model, word, goal - 1).expect(start - 1) == plug_in  # the sum over the paths


@given(tilt_instances())
@some
def test_the_expected_best_expects_at_least_what_the_plug_in_best_does(instance):
    model, start, goal = instance
    plug_in = best_tilt_plan(model, start, goal)
    expected = expected_probability(model, start, goal, plug_in.actions)
    assert best_expected_tilt_plan(model, start, goal).probability >= expected


@given(tilt_instances())
@some
def test_a_path_never_takes_a_detour(instance):
    model, start, goal = instance
    try:
        path = shortest_path_tilt_plan(model, start, goal)
    except NoPlanError:
        raise AssertionError("alpha gives every pair of states a path") from None
    assert path.steps < model.counts.states or path.steps == 0
