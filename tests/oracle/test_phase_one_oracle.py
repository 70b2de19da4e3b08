"""Phase I by a direct double loop on exact angles, by forced exact decisions, and by search."""

from __future__ import annotations

from fractions import Fraction

from hypothesis import given, settings
from hypothesis import strategies as st

from stochgeom.exact.angles import ZERO, Angle
from stochgeom.exact.lifted import LiftedAngles
from stochgeom.feeding.planner import FeedingProblem
from stochgeom.feeding.preimages import preimages
from stochgeom.feeding.propagation import outcomes
from stochgeom.transfer.squeeze import squeeze_function
from stochgeom.transfer.step_function import StepFunction
from tests.strategies import (
    circle_parts,
    hulls,
    nearly_regular,
    necklaces,
    parts,
    ratios,
    step_functions,
    transfer_functions,
)

FEW = settings().max_examples // 5
"""Searches take long."""

maps = st.one_of(
    transfer_functions(),
    necklaces(),
    st.one_of(circle_parts(), nearly_regular(most=9)).map(squeeze_function),
)


# --- a double loop -------------------------------------------------------------------------------


def slow_chain(s):
    """Return (start, width, image start, image width) of phase I, all arcs tried at all stages."""
    m, period = len(s), s.period
    breaks, values = list(s.breaks), list(s.values)
    # Three periods, lifted by plain addition: more than any arc from the first one needs.
    breaks += [b + period for b in breaks] + [b + period + period for b in breaks]
    values += [v + period for v in values] + [v + period + period for v in values]
    chain, bound = [], None
    while bound is None or bound < period:
        best = None
        for i in range(m):
            for j in range(i, i + m):
                width, image = breaks[j + 1] - breaks[i], values[j] - values[i]
                if not (image < bound if bound is not None else image == ZERO):
                    continue
                if (
                    best is None
                    or best[1] < width
                    or (best[1] == width and image < best[3])
                    or (best[1] == width and image == best[3] and breaks[i] < best[0])
                ):
                    best = (breaks[i], width, values[i], image)
        chain.append(best)
        bound = best[1]
    return chain


def fast_chain(s):
    return [(p.arc.start, p.width, p.image.start, p.image_width) for p in preimages(s)]


@given(maps)
def test_all_arcs_at_all_stages(s):
    assert fast_chain(s) == slow_chain(s)


# --- both roads of the float filter --------------------------------------------------------------


def forced(s):
    """Return the same map with shadows that decide nothing, all comparisons being exact."""
    again = StepFunction(s.breaks, s.values, s.period)
    again.lifted_breaks = LiftedAngles(again.breaks, again.period, error=1e9)
    again.lifted_values = LiftedAngles(again.values, again.period, error=1e9)
    return again


def by_arrays(s):
    """Return the same map, searched by array calls however few its steps are."""
    again = StepFunction(s.breaks, s.values, s.period)
    again.lifted_breaks._few = again.lifted_values._few = None
    return again


@given(maps)
def test_array_calls_lead_to_the_same_preimages(s):
    assert fast_chain(by_arrays(s)) == fast_chain(s)


def decisions(s):
    return s.lifted_breaks.exact_decisions, s.lifted_values.exact_decisions


@given(maps)
def test_the_exact_road_leads_to_the_same_preimages(s):
    exact = forced(s)
    chain = fast_chain(s)
    assert fast_chain(exact) == chain == slow_chain(s)
    if len(s) > 1:  # one step needs no decision
        assert decisions(exact) == (len(s) * len(chain), len(s) * (len(chain) - 1))
    assert all(one <= other for one, other in zip(decisions(s), decisions(exact), strict=True))


@given(maps, st.lists(st.integers(-72, 72), max_size=4))
def test_the_exact_road_leads_to_the_same_distributions(s, turns):
    angles = [ZERO, *(Angle.from_degrees(5 * turn) for turn in turns)]
    for usual, exact in zip(outcomes(s, angles), outcomes(forced(s), angles), strict=True):
        assert usual.states.tolist() == exact.states.tolist()
        assert usual.starts.tolist() == exact.starts.tolist()


def test_both_roads_are_taken():
    """No exact comparison where all widths are clearly different, some where two are equal."""
    clear = squeeze_function([(0, 0), (20, 1), (23, 9), (6, 14)])
    tied = squeeze_function([(-1, -1), (-1, -3), (1, -2)])
    fast_chain(clear)
    fast_chain(tied)
    assert decisions(clear)[1] == 0
    assert min(decisions(tied)) > 0


# --- search --------------------------------------------------------------------------------------


def widest_by_search(s, steps):
    """Return the widest step of any composite of so many actions.

    An action at alpha acts alike for all alpha of an interval (low, high], whose closed end is a
    value less a break. So one angle for each pair of them is enough.
    """
    angles = {(v - b) % s.period for v in s.values for b in s.breaks}
    turned = [s.after_turning(alpha) for alpha in angles]
    reached = {s}
    for _ in range(steps - 1):
        reached = {action.compose(whole) for whole in reached for action in turned}
    return max(max(whole.widths) for whole in reached)


@settings(max_examples=FEW)
@given(st.one_of(hulls(most=6), nearly_regular(most=5)))
def test_no_search_finds_a_wider_preimage(part):
    """Thesis 5.9: phase I finds what an exhaustive search over all actions finds."""
    problem = FeedingProblem(part)
    for steps in (1, 2, 3):
        if len(problem.transfer) ** (2 * steps) > 1000:
            break
        assert problem.preimages.of_steps(steps).width == widest_by_search(problem.transfer, steps)


@settings(max_examples=FEW)
@given(step_functions())
def test_no_search_finds_a_wider_preimage_for_other_maps(s):
    for steps in (1, 2):
        if len(s) ** (2 * steps) < 1000:
            assert preimages(s).of_steps(steps).width == widest_by_search(s, steps)


# --- phase II ------------------------------------------------------------------------------------


def slow_costs(problem, c, count):
    """Return (i + c) 2 pi / h_i to 60 digits of the widths."""
    return [
        (i + c) / Fraction(problem.preimages.of_steps(i).width.turns(60))
        for i in range(1, count + 1)
    ]


@given(st.one_of(parts(), circle_parts(), nearly_regular(most=7)), ratios.map(abs))
def test_optimal_plans_by_decimals_of_the_costs(part, c):
    """Costs that agree to 40 digits are taken as equal here; the fewest steps win."""
    problem = FeedingProblem(part)
    costs = slow_costs(problem, c, 2 * len(part.hull) + 1)
    least = min(costs)
    expected = next(i for i, cost in enumerate(costs, 1) if cost - least < Fraction(1, 10**40))
    assert problem.optimal_plan(c).steps == expected
