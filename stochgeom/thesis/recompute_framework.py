"""What settles the errata on decisions, sensors and tilting."""

from __future__ import annotations

from fractions import Fraction
from itertools import pairwise, product
from typing import Final

from gmpy2 import mpq

from stochgeom.decision.decision_rules import DecisionProblem
from stochgeom.decision.entropy import entropy
from stochgeom.decision.exhaustive_plans import count_plans
from stochgeom.decision.goal_costs import GoalCost, GuaranteedCost
from stochgeom.decision.infinity import INFINITE, is_infinite
from stochgeom.decision.plan_search import find_plan
from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.exact.decimals import rational_decimal
from stochgeom.exact.quotients import number_decimal
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.sensing.one_step import one_step_plan
from stochgeom.sensing.sensors import Sensor
from stochgeom.thesis.chapter_6 import PRINTED_PLANS, figure_6_4_printed
from stochgeom.thesis.facts import Fact, Facts, equal, fraction
from stochgeom.thesis.parts import catalogue_names, catalogue_part
from stochgeom.tilting.beta_density import BetaDensity
from stochgeom.tilting.counts import TransitionCounts
from stochgeom.tilting.estimation import TransitionModel
from stochgeom.tilting.shortest_path import shortest_path_tilt_plan
from stochgeom.tilting.states import ACTIONS, CANONICAL, STATES
from stochgeom.tilting.tilt_plans import evaluate_tilt_plan

PRIOR: Final = tuple(Fraction(k, 10) for k in (6, 1, 1, 1, 1))
"""Of the example on Eq. 7.5."""

EXECUTIONS: Final = 200
"""Of each of the two plans of Table 6.2, if they shared its 400 trials; 400 only make it worse."""


def cost_with_a_sensor() -> Facts:
    """Show that Eq. 7.5 overstates the cost of sensing: a rejected part is sensed anew.

    The mean number of rounds is added up round by round, without a formula for it.
    """
    sensor = Sensor.from_function(range(5), lambda state: "first" if state == 0 else "other")
    plan, blind = one_step_plan(sensor, PRIOR), one_step_plan(Sensor.blind(range(5)), PRIOR)
    # Each round succeeds by m(first) 1 + m(other) 1/4.
    succeeds = PRIOR[0] + (1 - PRIOR[0]) * Fraction(1, 4)
    mean, still = Fraction(0), Fraction(1)
    for n in range(1, 121):
        mean += n * still * succeeds
        still *= 1 - succeeds
    cost = Fraction(int(plan.expected_cost.numerator), int(plan.expected_cost.denominator))
    return (
        equal("by Eq. 7.5", number_decimal(plan.printed_cost, 3), "2.200"),
        equal("without any sensor", number_decimal(blind.expected_cost, 3), "1.667"),
        Fact(
            "so a look would cost more than it brings",
            "2.200 > 1.667",
            plan.printed_cost > blind.expected_cost,
        ),
        equal("1 / sum of m(x) p(x)", number_decimal(plan.expected_cost, 3), "1.429"),
        Fact(
            "the same by adding up 120 rounds, to 50 decimals",
            rational_decimal(mpq(mean.numerator, mean.denominator), 3),
            abs(mean - cost) < Fraction(1, 10**50),
        ),
        equal("where nothing is read, Eq. 7.5 is right", blind.printed_cost, blind.expected_cost),
    )


def variance_of_a_posterior() -> Facts:
    """Show that the variance may rise with an observation; it falls in expectation."""
    before, success, failure = BetaDensity(1, 9), BetaDensity(2, 9), BetaDensity(1, 10)
    p = 1 - before.mean  # the density is that of p_2
    expected = p * success.variance + (1 - p) * failure.variance
    return (
        equal("variance of Beta(1, 9)", rational_decimal(before.variance, 4), "0.0082"),
        equal("after one success", rational_decimal(success.variance, 4), "0.0124"),
        Fact("expected after one trial", rational_decimal(expected, 4), expected < before.variance),
        equal(
            "mean for alpha = (1, 9) after 1 and 9 trials: (1 + 1) over the sum of (alpha + x)",
            1 - BetaDensity(1 + 1, 9 + 9).mean,
            mpq(1 + 1, (1 + 1) + (9 + 9)),
        ),
    )


def random_tilts() -> Facts:
    """Show that there are twelve tilts; zero to twelve would be thirteen numbers."""
    return (
        equal("tilts", ACTIONS, 12),
        equal("whole numbers from zero to twelve", len(range(13)), ACTIONS + 1),
        Fact(
            "tilts in the printed plans",
            ", ".join(map(str, sorted({tilt for plan in PRINTED_PLANS for tilt in plan.actions}))),
            all(1 <= tilt <= 12 for plan in PRINTED_PLANS for tilt in plan.actions),
        ),
    )


def success_of_the_second_plan() -> Facts:
    """Show that .67 to .85 is no small difference: five standard errors even at 200 trials."""
    plan = next(plan for plan in PRINTED_PLANS if plan.measured == ".85")
    p, found = fraction(plan.estimated), fraction(plan.measured or "")
    variance = p * (1 - p) / EXECUTIONS
    squared = (found - p) ** 2 / variance
    return (
        equal("estimated and measured", (plan.estimated, plan.measured), (".67", ".85")),
        Fact(
            f"squared standard errors at {EXECUTIONS} trials, 25 are five",
            rational_decimal(mpq(squared.numerator, squared.denominator), 1),
            squared > 25,
        ),
    )


def shortest_paths() -> Facts:
    """Show that the heuristic maximises its bound; all plans are exponential in their length."""
    one, two = [[0, 9, 0], [0, 9, 0], [0, 0, 9]], [[9, 0, 0], [0, 0, 9], [9, 0, 0]]
    model = TransitionModel(TransitionCounts([one, two]))
    plan = shortest_path_tilt_plan(model, 1, 3)
    assert plan.bound is not None
    pairs = product((1, 2), repeat=plan.steps)
    worst = min(evaluate_tilt_plan(model, 1, 3, tilts).probability for tilts in pairs)
    return (
        Fact(
            "bound of the best path",
            rational_decimal(plan.bound, 4),
            plan.bound <= plan.probability,
        ),
        Fact(
            "the least probability of a plan as long",
            rational_decimal(worst, 4),
            worst < plan.bound,
        ),
        equal("plans of 3 tilts among 12", count_plans(12, 3, 3), 12**3),
        equal(
            "among 24: 2^3 times as many, a power of the actions",
            count_plans(24, 3, 3),
            2**3 * 12**3,
        ),
        equal("of 6 tilts among 12: the square", count_plans(12, 6, 6), 12**6),
    )


def information_of_a_sensor() -> Facts:
    """Show that no sensor raises the expected entropy, as entropy is concave; a reading may."""
    prior = [mpq(8, 10), mpq(1, 10), mpq(1, 10)]
    sensor = Sensor.from_function(range(3), lambda state: "first" if state == 0 else "other")
    noisy = Sensor.noisy(range(3), "1/2")
    facts = []
    before = entropy(prior)
    for name, look in (("exact", sensor), ("noisy", noisy)):
        after = [(m, entropy(look.posterior(prior, x))) for x, m in look.marginal(prior).items()]
        mean = sum((h.scaled(m) for m, h in after[1:]), start=after[0][1].scaled(after[0][0]))
        facts.append(
            Fact(
                f"expected entropy in bits after an {name} look"
                if name == "exact"
                else f"after a {name} one",
                mean.decimal(),
                mean.compare(before) < 0,
            )
        )
        if name == "exact":
            most = after[1][1]
            facts.append(
                Fact("entropy after the reading other", most.decimal(), most.compare(before) > 0)
            )
    return (equal("entropy of the hyperstate (.8, .1, .1)", before.decimal(), "0.9219"), *facts)


def length_of_cheap_plans() -> Facts:
    """Show that the best plan may have any length if an action costs nothing.

    The action moves the one state to the goal with 1/2, so that each more of it halves what is
    left. Where every action costs something, finitely many of them cost no less than some e > 0,
    and C / e actions cost more than C, the loss of doing nothing.
    """
    lengths, priced = [], []
    problem = PlanningProblem(["away", "goal"], [1, 0], ["try"], [[["1/2", "1/2"], [0, 1]]])
    horizons = (1, 2, 5, 20)
    for horizon in horizons:
        free = find_plan(problem, horizon, GoalCost("goal", 0))
        lengths.append((len(free.plan), free.cost))
        priced.append(len(find_plan(problem, horizon, GoalCost("goal", "1/1000")).plan))
    return (
        equal(
            "actions of the best plan of a free action, horizons 1, 2, 5, 20",
            tuple(length for length, _ in lengths),
            horizons,
        ),
        equal("its cost", [cost for _, cost in lengths], [mpq(1, 2**k) for k in horizons]),
        equal("if an action costs 1/1000", priced, [1, 2, 5, 9]),
        equal(
            "longest that is best there, of up to 30",
            len(find_plan(problem, 30, GoalCost("goal", "1/1000")).plan),
            9,
        ),
    )


def states_of_the_tray() -> Facts:
    """Show that corners and sides, horizontal or vertical, are sixteen, and the states twelve."""
    places = [place for place in product((-1, 0, 1), repeat=2) if any(place)]
    described = {(*place, lies) for place in places for lies in (True, False)}
    named = {(state.right, state.up, state.horizontal) for state in CANONICAL}
    left_out = described - named
    return (
        equal("four corners and four sides, each in two ways", len(described), 16),
        equal(
            "states, by the matrix of Fig. 6.4 and the goals of Table 6.1",
            len(figure_6_4_printed()),
            STATES,
        ),
        equal("of the twelve, in corners", sum(state.is_corner for state in CANONICAL), 8),
        equal(
            "left out: at a side, with the short edge against the wall",
            sorted(left_out),
            sorted((x, y, x != 0) for x, y in places if x * y == 0),
        ),
    )


def words_on_decisions() -> Facts:
    """Show that a Bayes rule minimises, and that a loss is that of a rule's answer."""
    test = DecisionProblem(
        ["good", "bad"],
        ["pass", "fail"],
        ["keep", "throw"],
        [["9/10", "1/10"], ["1/10", "9/10"]],
        [[0, 1], [5, 0]],
    )
    prior = [mpq(9, 10), mpq(1, 10)]
    risks = {rule: test.bayes_risk(prior, rule) for rule in test.rules()}
    best = test.bayes_rules(prior)
    chains = [list(FeedingProblem(catalogue_part(name)).preimages) for name in catalogue_names()]
    inside = [
        after.image_width < before.width for chain in chains for before, after in pairwise(chain)
    ]
    return (
        equal(
            "least expected loss of the four rules of an example",
            min(risks.values()),
            risks[best[0]],
        ),
        Fact(
            "greatest, which a maximum would choose",
            str(max(risks.values())),
            max(risks.values()) > min(risks.values()),
        ),
        equal(
            "the loss is that of what the rule answers to the reading",
            test.risk(test.rule({"pass": "keep", "fail": "throw"})),
            (mpq(1, 10), mpq(1, 2)),
        ),
        equal(
            "phase I compares the image of a preimage with the last preimage, all parts",
            all(inside),
            True,
        ),
    )


def infinite_costs() -> Facts:
    """Show that a guaranteed plan has a finite expected cost only if 0 x infinity is 0."""
    problem = PlanningProblem(
        ["a", "b"], [1, 0], ["go", "stay"], [[[0, 1], [0, 1]], [[1, 0], [0, 1]]]
    )
    sure = find_plan(problem, 1, GuaranteedCost("b", 1))
    return (
        equal("0 x infinity, as the costs of states are added up", mpq(0) * INFINITE, 0),
        equal("cost of a plan that cannot fail", sure.cost, 1),
        equal(
            "with any positive probability of failure it is infinite",
            is_infinite(mpq(1, 10**9) * INFINITE),
            True,
        ),
    )
