"""``stochgeom tilt estimate`` and ``stochgeom tilt plan``."""

from __future__ import annotations

import argparse
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from gmpy2 import mpq

from stochgeom.cli.layout import count, table
from stochgeom.cli.options import read_count, read_digits
from stochgeom.cli.output import write, write_json
from stochgeom.cli.progress import Progress
from stochgeom.errors import InputError
from stochgeom.exact.decimals import rational_decimal
from stochgeom.exact.scalars import parse_rational, rational_text

if TYPE_CHECKING:  # loaded when the command runs: other commands start without them
    from stochgeom.tilting.estimation import TransitionModel
    from stochgeom.tilting.tilt_plans import TiltPlan

THESIS_MODEL = "figure-6.4"

MOST_EXPECTED = 4
"""Longest plan with a repeated tilt whose expected probability is shown: a sum over all paths."""

Planner = Callable[["TransitionModel", int, int, int, bool], "TiltPlan"]


def _all_plans(model: TransitionModel, i: int, j: int, most: int, observed: bool) -> TiltPlan:
    from stochgeom.tilting.all_plans import best_tilt_plan

    return best_tilt_plan(model, i, j, most, observed_only=observed)


def _bounded(model: TransitionModel, i: int, j: int, most: int, observed: bool) -> TiltPlan:
    from stochgeom.tilting.bounded_search import bounded_tilt_search

    found = bounded_tilt_search(model, i, j, most, observed_only=observed)
    if not found.complete:
        raise InputError(
            f"{found.nodes} nodes were not enough; accepted: fewer tilts", where="--max-tilts"
        )
    return found.plan


def _shortest_path(model: TransitionModel, i: int, j: int, most: int, observed: bool) -> TiltPlan:
    from stochgeom.tilting.shortest_path import shortest_path_tilt_plan

    return shortest_path_tilt_plan(model, i, j, most, observed_only=observed)


def _expected(model: TransitionModel, i: int, j: int, most: int, observed: bool) -> TiltPlan:
    from stochgeom.tilting.uncertain_plans import best_expected_tilt_plan

    return best_expected_tilt_plan(model, i, j, most, observed_only=observed)


METHODS: dict[str, Planner] = {
    "all-plans": _all_plans,
    "branch-and-bound": _bounded,
    "shortest-path": _shortest_path,
    "expected": _expected,
}


# --- estimate ------------------------------------------------------------------------------------


def run_estimate(arguments: argparse.Namespace) -> int:
    """Print the matrix of a tilt; return the exit code."""
    digits, model = read_digits(arguments.digits), read_model(arguments)
    tilt = read_count(arguments.tilt, "--tilt")
    matrix = model.matrix(tilt)  # refuses a tilt that does not exist
    seen = [model.counts.row(tilt, state) for state in range(1, model.counts.states + 1)]
    if arguments.json:
        write_json(
            {
                "schema": "stochgeom/tilt-estimate/1",
                "tilt": tilt,
                "outcomes": list(model.counts.outcomes),
                "counts": [list(row) for row in seen],
                "matrix": [[rational_text(entry) for entry in row] for row in matrix],
            },
            indent=None,
        )
        return 0
    header = ["from", *map(str, model.counts.outcomes), "trials"]
    rows = [
        [str(i), *(rational_decimal(entry, digits) for entry in row), str(sum(counts))]
        for i, (row, counts) in enumerate(zip(matrix, seen, strict=True), start=1)
    ]
    total = sum(map(sum, seen))
    write(
        f"Tilt {tilt}: {count(total, 'trial')}; probability of each outcome, by the state before"
        "\n\n" + table(header, rows) + "".join(f"\n\n{note}" for note in notes_on(model))
    )
    return 0


def read_model(arguments: argparse.Namespace) -> TransitionModel:
    """Return the model that the source and --alpha name."""
    from stochgeom.io.recordings import load_recording
    from stochgeom.thesis.chapter_6 import figure_6_4_model

    alpha = None
    if arguments.alpha is not None:
        alpha = parse_rational(arguments.alpha, where="--alpha")
    if arguments.source == THESIS_MODEL:
        model = figure_6_4_model()
        return model if alpha is None else model.with_alpha(alpha)
    sizes = [
        None if text is None else read_count(text, option)
        for text, option in ((arguments.states, "--states"), (arguments.actions, "--actions"))
    ]
    return load_recording(arguments.source, *sizes).model(alpha)


def notes_on(model: TransitionModel, *, left_out: bool | None = None) -> list[str]:
    """Return what has to be said of tilts and pairs that were never observed.

    `left_out` tells whether plans leave such tilts out; None where there is no plan.
    """
    found = []
    if model.unobserved_actions:
        named = ", ".join(map(str, model.unobserved_actions))
        treated = {
            None: "all that the model says of such a tilt is its prior",
            True: "plans leave such a tilt out",
            False: "plans may use such a tilt, by its prior alone; --observed-only leaves it out",
        }[left_out]
        found.append(f"Never observed: tilt {named}; {treated}.")
    unseen = len(model.undefined_rows) - len(model.unobserved_actions) * model.counts.states
    if unseen:
        found.append(
            f"{unseen} other pairs of state and tilt were never observed; the prior speaks for "
            "them, all outcomes alike."
        )
    return found


# --- plan ----------------------------------------------------------------------------------------


def run(arguments: argparse.Namespace) -> int:
    """Plan, print, return the exit code."""
    digits, most = read_digits(arguments.digits), read_count(arguments.max_tilts, "--max-tilts", 0)
    model = read_model(arguments)
    plans = _plans(arguments, model, most)
    if arguments.json:
        documents = [plan_document(plan, digits) for plan in plans]
        found: dict[str, Any] = {"schema": "stochgeom/tilt-plan/1", "method": arguments.method}
        write_json({**found, **({"plans": documents} if arguments.all else documents[0])})
    else:
        body = _table_of(plans, digits) if arguments.all else _text_of(model, plans[0], digits)
        write("\n\n".join([body, *notes_on(model, left_out=arguments.observed_only)]))
    return 0


def _plans(arguments: argparse.Namespace, model: TransitionModel, most: int) -> list[TiltPlan]:
    planner, observed = METHODS[arguments.method], arguments.observed_only
    if not arguments.all:
        start = _state(arguments.start, "--from", model)
        return [planner(model, start, _state(arguments.goal, "--to", model), most, observed)]
    if arguments.start is not None or arguments.goal is not None:
        raise InputError("--all plans every pair; accepted: --from and --to, or --all")
    if arguments.method == "all-plans":
        return _every_pair(model, most, observed)
    states = range(1, model.counts.states + 1)
    pairs = [(i, j) for i in states for j in states if i != j]
    found = []
    with Progress("plans") as progress:
        for done, (i, j) in enumerate(pairs):
            progress.show(done / len(pairs))
            found.append(planner(model, i, j, most, observed))
    return found


def _every_pair(model: TransitionModel, most: int, observed: bool) -> list[TiltPlan]:
    """Return the best plans of all pairs, for all goals of a start at once."""
    from stochgeom.tilting.all_plans import best_tilt_plans

    with Progress("starts") as progress:
        found = best_tilt_plans(model, most, observed_only=observed, tell=progress.show)
    return list(found.values())


def _state(text: str | None, option: str, model: TransitionModel) -> int:
    if text is None:
        raise InputError(f"missing; accepted: a state, 1 to {model.counts.states}", where=option)
    state = read_count(text, option)
    if state > model.counts.states:
        raise InputError(f"{state}; accepted: a state, 1 to {model.counts.states}", where=option)
    return state


def plan_document(plan: TiltPlan, digits: int) -> dict[str, Any]:
    """Return a plan for machines."""
    return {
        "from": plan.start,
        "to": plan.goal,
        "tilts": list(plan.actions),
        "probability": rational_decimal(plan.probability, digits),
        "exact_probability": rational_text(plan.probability),
        "bound": None if plan.bound is None else rational_decimal(plan.bound, digits),
        "unobserved": [list(pair) for pair in plan.unobserved],
    }


def _tilts(plan: TiltPlan) -> str:
    return " ".join(map(str, plan.actions)) or "none"


def _table_of(plans: list[TiltPlan], digits: int) -> str:
    rows = [
        [str(p.start), str(p.goal), _tilts(p), rational_decimal(p.probability, digits)]
        for p in plans
    ]
    lengths = [plan.steps for plan in plans]
    mean = sum(lengths) / len(lengths) if lengths else 0.0
    return (
        table(["from", "to", "tilts", "probability"], rows, left=[2])
        + f"\n\n{count(len(plans), 'plan')} of {mean:.2f} tilts on average"
    )


def _text_of(model: TransitionModel, plan: TiltPlan, digits: int) -> str:
    from stochgeom.tilting.tilt_plans import hyperstates
    from stochgeom.tilting.uncertain_plans import expected_probability

    probability = rational_decimal(plan.probability, digits)
    lines = [f"From {plan.start} to {plan.goal}: tilts {_tilts(plan)}; probability {probability}"]
    if plan.bound is not None:
        lines.append(
            f"along its path alone {rational_decimal(plan.bound, digits)}: a heuristic, not proven "
            "best"
        )
    if plan.steps <= MOST_EXPECTED or len(set(plan.actions)) == plan.steps:
        expected = expected_probability(model, plan.start, plan.goal, plan.actions)
        lines.append(f"expected under the posterior: {rational_decimal(expected, digits)}")
    rows = [
        [str(step), "start" if step == 0 else str(plan.actions[step - 1]), _likely(state, model)]
        for step, state in enumerate(hyperstates(model, plan.start, plan.actions))
    ]
    lines += ["", table(["step", "tilt", "states after it, the likely ones"], rows, left=[2])]
    if plan.unobserved:
        lines += ["", _untried(model, plan)]
    return "\n".join(lines)


def _untried(model: TransitionModel, plan: TiltPlan, most: int = 6) -> str:
    """Say which pairs of tilt and state the plan meets that nobody has tried, the likely first."""
    from stochgeom.tilting.tilt_plans import hyperstates

    met = dict.fromkeys(plan.unobserved, mpq(0))
    passed = hyperstates(model, plan.start, plan.actions)
    for action, before in zip(plan.actions, passed, strict=False):
        for state in range(1, model.counts.states + 1):
            if (action, state) in met:
                met[action, state] += before[state - 1]
    order = sorted(met, key=lambda pair: (-met[pair], pair))
    pairs = ", ".join(f"{action} in state {state}" for action, state in order[:most])
    more = f", and {len(order) - most} more" if len(order) > most else ""
    total = rational_decimal(min(sum(met.values()), mpq(1)), 3)
    return f"Never tried, but met with probability {total} at most: tilt {pairs}{more}."


def _likely(state: tuple[Any, ...], model: TransitionModel, most: int = 4) -> str:
    order = sorted(range(len(state)), key=lambda k: -state[k])
    shown = [k for k in order[:most] if state[k] * 100 >= 1]
    return ", ".join(f"{model.counts.outcomes[k]}: {rational_decimal(state[k], 3)}" for k in shown)
