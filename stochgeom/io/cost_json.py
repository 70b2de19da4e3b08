"""Costs of planning problems as JSON objects.

- ``{"kind": "additive", "actions": A, "states": S}``: A is a number for every action or an object
  with numbers for some, S likewise for the states; numbers may be ``"infinite"`` in S;
- ``{"kind": "minimax", "actions": A, "states": S}``: the worst final state counts;
- ``{"kind": "goal", "goal": [STATE, ...], "actions": A}``: 1 minus the probability of the goal;
- ``{"kind": "guaranteed", "goal": [STATE, ...], "actions": A}``: infinite unless the goal is sure;
- ``{"kind": "iterative", "goal": [STATE, ...], "actions": A, "test": T}``: rounds until success;
  without a goal the most likely state is one;
- ``{"kind": "entropy", "actions": A}``;
- ``{"kind": "variance", "orientations": {STATE: DEGREES, ...}, "actions": A}``;
- ``{"kind": "distance", "orientations": {STATE: DEGREES, ...}, "goal": DEGREES, "actions": A}``.

What is left out has its default: actions cost 0 (of iterative and guaranteed plans 1), states 0,
a test 1. Angles are degrees, exact, or ``{"turns": T, "direction": [X, Y]}``.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, Final

from stochgeom.decision.additive_costs import AdditiveCost, distance_cost
from stochgeom.decision.circular_variance import VarianceCost
from stochgeom.decision.entropy import EntropyCost
from stochgeom.decision.goal_costs import GoalCost, GuaranteedCost
from stochgeom.decision.infinity import INFINITE, is_infinite
from stochgeom.decision.iterative_costs import IterativeCost
from stochgeom.decision.plan_costs import PlanCost
from stochgeom.decision.worst_case_costs import MinimaxCost
from stochgeom.errors import FormatError, ProblemError
from stochgeom.exact.angles import Angle
from stochgeom.exact.scalars import parse_rational, rational_text
from stochgeom.io.exact_json import kind_of
from stochgeom.io.rings import shown

Number = Callable[[Any, str], Any]
"""Reads a number; the second argument is its place."""


def cost_from_json(document: Any, number: Number) -> PlanCost:
    """Return the cost that an object describes.

    Parameters
    ----------
    document : object
        As `stochgeom.io.exact_json.load_json` reads it.
    number : callable
        Reads a number of the problem's kind.

    Raises
    ------
    FormatError
        If it is of no known kind, or a key is missing or unknown.

    Examples
    --------
    >>> cost_from_json({"kind": "iterative", "goal": ["3"], "test": "0"}, lambda n, _: int(n))
    IterativeCost(goal=['3'], actions=1, test=0)
    """
    kinds = ", ".join(_READERS)
    if not isinstance(document, dict):
        raise FormatError(f'{kind_of(document)}; accepted: an object with a "kind"', where="cost")
    kind = document.get("kind")
    if not isinstance(kind, str) or kind not in _READERS:
        raise FormatError(f"{kind_of(kind)}; accepted: {kinds}", where="cost, kind")
    needed, optional, read = _READERS[kind]
    for key in document:
        if key not in ("kind", *needed, *optional):
            raise FormatError(
                f"accepted keys: {', '.join(('kind', *needed, *optional))}",
                where=f"cost, key {shown(key)}",
            )
    for key in needed:
        if key not in document:
            raise FormatError(f"missing; a cost of kind {kind} needs it", where=f"cost, key {key}")
    return read(_Fields(document, number))


class _Fields:
    """The entries of a cost's object."""

    def __init__(self, document: dict[str, Any], number: Number) -> None:
        self._document, self._number = document, number

    def amounts(self, key: str, default: Any) -> Any:
        """Return a number, or numbers by label."""
        value = self._document.get(key)
        if value is None:
            return default
        if isinstance(value, dict) and not {"constant", "angles"} & set(value):
            return {
                label: self._amount(each, f"cost, {key}, {shown(label)}")
                for label, each in value.items()
            }
        return self._amount(value, f"cost, {key}")

    def _amount(self, value: Any, place: str) -> Any:
        return INFINITE if value in ("infinite", "infinity") else self._number(value, place)

    def goal(self) -> Any:
        """Return a list of states, None if there is none."""
        value = self._document.get("goal")
        if value is None:
            return None
        states = value if isinstance(value, list) else [value]
        if not all(isinstance(state, str) for state in states):
            raise FormatError(
                f"{kind_of(value)}; accepted: a state, or a list of states", where="cost, goal"
            )
        return [str(state) for state in states]

    def angle(self, key: str) -> Angle:
        """Return an angle."""
        return _angle(self._document[key], f"cost, {key}")

    def angles(self, key: str) -> dict[str, Angle]:
        """Return angles by label."""
        value = self._document[key]
        if not isinstance(value, dict):
            raise FormatError(f"{kind_of(value)}; accepted: an object", where=f"cost, {key}")
        return {label: _angle(v, f"cost, {key}, {shown(label)}") for label, v in value.items()}


def _angle(value: Any, place: str) -> Angle:
    if isinstance(value, str):
        return Angle.from_degrees(parse_rational(value, where=place))
    if isinstance(value, dict) and set(value) <= {"turns", "direction"}:
        direction = value.get("direction")
        numbers = [*direction, value.get("turns", "0")] if isinstance(direction, list) else []
        if len(numbers) == 3 and all(isinstance(n, str) for n in numbers):
            x, y, turns = (parse_rational(n, where=place) for n in numbers)
            return Angle(turns, (x, y))
    raise FormatError(
        f'{kind_of(value)}; accepted: degrees, or {{"turns": T, "direction": [X, Y]}}', where=place
    )


_Reader = Callable[[_Fields], PlanCost]

_READERS: Final[dict[str, tuple[tuple[str, ...], tuple[str, ...], _Reader]]] = {
    "additive": (
        (),
        ("actions", "states"),
        lambda f: AdditiveCost(f.amounts("actions", 0), f.amounts("states", 0)),
    ),
    "minimax": (
        (),
        ("actions", "states"),
        lambda f: MinimaxCost(f.amounts("actions", 0), f.amounts("states", 0)),
    ),
    "goal": (("goal",), ("actions",), lambda f: GoalCost(f.goal(), f.amounts("actions", 0))),
    "guaranteed": (
        ("goal",),
        ("actions",),
        lambda f: GuaranteedCost(f.goal(), f.amounts("actions", 1)),
    ),
    "iterative": (
        (),
        ("goal", "actions", "test"),
        lambda f: IterativeCost(f.goal(), f.amounts("actions", 1), f.amounts("test", 1)),
    ),
    "entropy": ((), ("actions",), lambda f: EntropyCost(f.amounts("actions", 0))),
    "variance": (
        ("orientations",),
        ("actions",),
        lambda f: VarianceCost(f.angles("orientations"), f.amounts("actions", 0)),
    ),
    "distance": (
        ("orientations", "goal"),
        ("actions",),
        lambda f: distance_cost(f.angles("orientations"), f.angle("goal"), f.amounts("actions", 0)),
    ),
}


# --- writing -------------------------------------------------------------------------------------


def cost_to_json(cost: Any, number: Callable[[Any], Any]) -> dict[str, Any]:
    """Return the object of a cost; reading it gives an equal cost.

    Raises
    ------
    ProblemError
        If the cost is of a kind that has no object.

    Examples
    --------
    >>> cost_to_json(AdditiveCost(1, {"a": INFINITE}), str)
    {'kind': 'additive', 'actions': '1', 'states': {'a': 'infinite'}}
    """

    def amounts(value: Any) -> Any:
        if isinstance(value, Mapping):
            return {label: amounts(each) for label, each in value.items()}
        return "infinite" if is_infinite(value) or value == "infinite" else number(value)

    if isinstance(cost, AdditiveCost | MinimaxCost):
        kind = "additive" if isinstance(cost, AdditiveCost) else "minimax"
        return {"kind": kind, "actions": amounts(cost.actions), "states": amounts(cost.states)}
    if isinstance(cost, GoalCost | GuaranteedCost):
        kind = "goal" if isinstance(cost, GoalCost) else "guaranteed"
        return {"kind": kind, "goal": _states(cost.goal), "actions": amounts(cost.actions)}
    if isinstance(cost, IterativeCost):
        goal = {} if cost.goal is None else {"goal": _states(cost.goal)}
        spent = {"actions": amounts(cost.actions), "test": amounts(cost.test)}
        return {"kind": "iterative", **goal, **spent}
    if isinstance(cost, EntropyCost):
        return {"kind": "entropy", "actions": amounts(cost.actions)}
    if isinstance(cost, VarianceCost):
        angles = {
            state: {
                "turns": rational_text(angle.turn_part),
                "direction": [str(n) for n in angle.direction],
            }
            for state, angle in cost.orientations.items()
        }
        return {"kind": "variance", "orientations": angles, "actions": amounts(cost.actions)}
    raise ProblemError(f"the cost {cost!r:.60} has no document; accepted: {', '.join(_READERS)}")


def _states(goal: Any) -> list[Any]:
    return (
        sorted(goal)
        if isinstance(goal, set | frozenset)
        else (list(goal) if isinstance(goal, list) else [goal])
    )
