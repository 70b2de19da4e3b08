"""What ``stochgeom decide`` prints: for people, and for machines."""

from __future__ import annotations

from typing import Any

from stochgeom.cli.layout import count, table
from stochgeom.decision.infinity import is_infinite
from stochgeom.decision.iterative_costs import IterativeModel
from stochgeom.decision.plan_results import PlanResult
from stochgeom.exact.decimals import rational_decimal
from stochgeom.exact.scalars import from_float_exact
from stochgeom.exact.sums import AngleSum
from stochgeom.io.problem_json import number_json

SCHEMA = "stochgeom/decision/1"

_MOST_PLANS = 20
_QUANTILES = ("1/2", "9/10", "99/100")


def result_text(found: PlanResult, horizon: int | None, digits: int) -> str:
    """Return the result for people."""
    problem = found.problem
    name = "" if problem.name is None else f"{problem.name}: "
    size = f"{count(len(problem.states), 'state')}, {count(len(problem.actions), 'action')}"
    lines = [
        f"{name}{size}, {'exact' if problem.exact else 'float'} numbers",
        f"cost: {_describe(found)}",
        "",
    ]
    if not found.feasible:
        lines.append(_hopeless(found, horizon))
        return "\n".join(lines)
    lines += [_title(found, horizon), _steps(found, digits)]
    if len(found.optimal) > 1:
        lines += ["", f"{len(found.optimal)} plans are optimal and as short:"]
        lines += [f"  {_words(plan)}" for plan in found.optimal[:_MOST_PLANS]]
        if len(found.optimal) > _MOST_PLANS:
            lines.append(f"  and {len(found.optimal) - _MOST_PLANS} more; --json prints all")
    lines += ["", f"cost {decimal(found.cost, digits)}{_exactly(found.cost)}"]
    if isinstance(found.model, IterativeModel):
        lines.append(_rounds(found, digits))
    lines.append(_proof(found, digits))
    return "\n".join(lines)


def _title(found: PlanResult, horizon: int | None) -> str:
    what = "Optimal plan" if found.proven else "Best plan found"
    reach = "of any length" if horizon is None else f"of at most {count(horizon, 'action')}"
    return f"{what} {reach}"


def _steps(found: PlanResult, digits: int) -> str:
    """Return a line for each action: what is likely after it."""
    problem, hyperstate = found.problem, found.problem.prior
    rows = [["0", "(prior)", *_likely(found, hyperstate, digits)]]
    for number, action in enumerate(found.plan, start=1):
        hyperstate = problem.after(hyperstate, action)
        rows.append([str(number), str(action), *_likely(found, hyperstate, digits)])
    header = ["step", "action", "possible states", "most likely", "probability"]
    return table(header, rows, left=[1, 3])


def _likely(found: PlanResult, hyperstate: Any, digits: int) -> list[str]:
    best, possible = 0, 0
    for k, share in enumerate(hyperstate):
        possible += bool(share)
        best = k if hyperstate[best] < share else best
    state = str(found.problem.states[best])
    return [str(possible), state, decimal(hyperstate[best], digits)]


def _proof(found: PlanResult, digits: int) -> str:
    size = f"{count(found.nodes, 'node')}, {found.distinct} of them different"
    if found.proven:
        how = "proven" if found.problem.exact else "up to the rounding of floats"
        return f"No plan that was asked for costs less ({how}; {size})."
    return (
        f"NOT proven optimal: ended by the {found.reason} ({size}); "
        f"no plan costs less than {decimal(found.lower_bound, digits)}."
    )


def _rounds(found: PlanResult, digits: int) -> str:
    assert isinstance(found.model, IterativeModel)
    rounds = found.model.rounds(found.hyperstate)
    enough = ", ".join(
        f"{count(rounds.quantile(share), 'round')} ({rational_percent(share)})"
        for share in _QUANTILES
    )
    return (
        f"a round succeeds with probability {decimal(rounds.probability, digits)}, "
        f"{decimal(rounds.mean, digits)} rounds on average\n"
        f"rounds that are enough, with which probability: {enough}"
    )


def rational_percent(share: str) -> str:
    """Return a share as a whole percentage.

    Examples
    --------
    >>> rational_percent("9/10")
    '90 %'
    """
    top, bottom = share.split("/")
    return f"{100 * int(top) // int(bottom)} %"


def _hopeless(found: PlanResult, horizon: int | None) -> str:
    reach = "" if horizon is None else f" of at most {count(horizon, 'action')}"
    if found.proven:
        return f"No plan{reach} has a finite cost."
    return f"No plan of finite cost was found{reach}: ended by the {found.reason}."


def _describe(found: PlanResult) -> str:
    cost = found.problem.cost
    return "" if cost is None else cost.describe()


def _words(plan: tuple[Any, ...]) -> str:
    return ", ".join(map(str, plan)) or "(do nothing)"


def decimal(value: Any, digits: int) -> str:
    """Return a number of any kind as a decimal; of a float, its binary value rounded.

    Examples
    --------
    >>> from gmpy2 import mpq
    >>> decimal(mpq(2, 3), 2), decimal(0.5, 1)
    ('0.67', '0.5')
    """
    if is_infinite(value):
        return "infinite"
    if isinstance(value, float):
        return rational_decimal(from_float_exact(value), digits)
    text: str = (
        value.decimal(digits) if hasattr(value, "decimal") else rational_decimal(value, digits)
    )
    return text


def _exactly(value: Any) -> str:
    exact = _exact(value)
    if exact is None or isinstance(exact, float) or exact.denominator == 1:
        return ""
    text = str(exact)
    return f" = {text}" if len(text) <= 40 else ""


def _exact(value: Any) -> Any:
    """Return a rational number, or a float, or None for what is neither."""
    return value.rational if hasattr(value, "rational") else value


# --- JSON ----------------------------------------------------------------------------------------


def result_document(found: PlanResult, horizon: int | None, digits: int) -> dict[str, Any]:
    """Return the result for machines."""
    problem = found.problem
    document = {
        "schema": SCHEMA,
        "problem": {
            "name": problem.name,
            "states": [str(state) for state in problem.states],
            "actions": [str(action) for action in problem.actions],
            "numbers": problem.numbers.value,
        },
        "horizon": horizon,
        "plan": [str(action) for action in found.plan],
        "cost": _number(found.cost, digits),
        "hyperstate": [_number(share, digits) for share in found.hyperstate],
        "proven": found.proven,
        "lower_bound": _number(found.lower_bound, digits),
        "ended_by": found.reason,
        "optimal_plans": [[str(action) for action in plan] for plan in found.optimal],
        "nodes": found.nodes,
        "distinct": found.distinct,
    }
    if isinstance(found.model, IterativeModel) and found.feasible:
        rounds = found.model.rounds(found.hyperstate)
        document["rounds"] = {
            "probability": _number(rounds.probability, digits),
            "mean": _number(rounds.mean, digits),
            "quantiles": {share: rounds.quantile(share) for share in _QUANTILES},
        }
    return document


def _number(value: Any, digits: int) -> dict[str, Any]:
    """Return a number as its exact form, null where it has no short one, beside a decimal."""
    exact = _exact(value)
    if exact is None and isinstance(value, AngleSum):
        exact = value
    if is_infinite(value) or exact is None:
        return {"exact": None, "decimal": decimal(value, digits)}
    return {"exact": number_json(exact), "decimal": decimal(value, digits)}
