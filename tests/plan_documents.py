"""A reader of stochgeom/plan/1 documents: it checks the contract and runs the plans.

It takes the contract at its word and, apart from the type `Angle`, nothing from the library:
decimals are recomputed by mpmath and fractions, and the step function is applied by a scan.
"""

from __future__ import annotations

import re
from bisect import bisect_right
from fractions import Fraction
from math import gcd
from typing import Any

from mpmath import MPContext, mpf

from stochgeom.exact.angles import FULL_TURN, ZERO, Angle

Json = dict[str, Any]

_INTEGER = re.compile(r"0|-?[1-9][0-9]*")
_FRACTION = re.compile(r"(-?[1-9][0-9]*)/([1-9][0-9]*)")
_EIGHTHS = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)]

MP = MPContext()
MP.dps = 200

ANGLE_KEYS = {"turns", "direction", "degrees"}
PLAN_KEYS = {
    "steps",
    "actions",
    "mouth",
    "expected_cost",
    "probability",
    "expected_cost_up_to_symmetry",
    "probability_up_to_symmetry",
    "orients_up_to_symmetry",
    "margin",
    "error_bound",
}


def check_document(document: Json, digits: int = 4, cost_ratio: Fraction = Fraction(1)) -> None:
    """Assert that a document keeps the contract, key by key."""
    assert list(document) == [
        "schema",
        "part",
        "transfer",
        "cost_ratio",
        "preimages",
        "plan",
        "geometric_plan",
    ]
    assert document["schema"] == "stochgeom/plan/1"
    _check_part(document["part"])
    transfer = Transfer(document["transfer"], digits)
    assert rational_of(document["cost_ratio"]) == cost_ratio
    widths = [
        _check_preimage(preimage, steps, transfer, digits, cost_ratio)
        for steps, preimage in enumerate(document["preimages"], start=1)
    ]
    assert widths == sorted(set(widths))
    assert widths[-1] == transfer.period
    for key in ("plan", "geometric_plan"):
        _check_plan(document[key], transfer, widths, digits, cost_ratio)
    assert document["geometric_plan"]["steps"] == len(widths)
    assert document["geometric_plan"]["orients_up_to_symmetry"] is True


# --- scalars -------------------------------------------------------------------------------------


def rational_of(text: Any) -> Fraction:
    """Read "p" or "p/q" in lowest terms."""
    assert isinstance(text, str)
    if _INTEGER.fullmatch(text):
        return Fraction(text)
    match = _FRACTION.fullmatch(text)
    assert match is not None, text
    assert int(match[2]) > 1
    assert gcd(int(match[1]), int(match[2])) == 1
    return Fraction(text)


def decimal_of(value: Fraction | mpf, digits: int) -> str:
    """Round half to even; an irrational value must carry digits to spare."""
    scaled = value * 10**digits
    whole = round(scaled) if isinstance(scaled, Fraction) else int(MP.nint(scaled))
    text = str(abs(whole)).zfill(digits + 1)
    sign = "-" if whole < 0 else ""
    return sign + (f"{text[:-digits]}.{text[-digits:]}" if digits else text)


def degrees_of(angle: Json) -> Fraction | mpf:
    """Return the degrees of an angle: exactly if rational, else to 200 digits."""
    x, y = (int(text) for text in angle["direction"])
    turns = Fraction(angle["turns"])
    if (x, y) in _EIGHTHS:
        return 360 * turns + 45 * _EIGHTHS.index((x, y))
    argument = MP.atan2(y, x) % (2 * MP.pi)
    return 360 * MP.mpf(turns.numerator) / turns.denominator + MP.degrees(argument)


def angle_of(document: Any, digits: int = 4) -> Angle:
    """Rebuild an angle, asserting that it is in canonical form and its decimals are right."""
    assert set(document) == ANGLE_KEYS
    turns, direction = document["turns"], document["direction"]
    assert isinstance(direction, list)
    assert all(isinstance(text, str) and _INTEGER.fullmatch(text) for text in direction)
    x, y = (int(text) for text in direction)
    assert gcd(x, y) == 1
    if type(turns) is not int:
        t = rational_of(turns)
        assert t.denominator > 1
        assert (8 * t).denominator > 1
        assert 0 <= y < x
    assert document["degrees"] == decimal_of(degrees_of(document), digits)
    angle = Angle(turns, (x, y))
    assert str(angle.turn_part) == str(turns)
    assert [str(value) for value in angle.direction] == direction
    return angle


def exact(document: Json) -> Angle:
    """Rebuild an angle that was checked before."""
    return Angle(document["turns"], document["direction"])


# --- the parts of a document ---------------------------------------------------------------------


def _check_part(part: Json) -> None:
    assert set(part) - {"holes"} == {"name", "vertices", "center_of_mass"}
    assert part["name"] is None or isinstance(part["name"], str)
    assert len(part["vertices"]) >= 3
    for ring in [part["vertices"], *part.get("holes", [])]:
        for x, y in ring:
            rational_of(x)
            rational_of(y)
    x, y = part["center_of_mass"]
    rational_of(x)
    rational_of(y)


class Transfer:
    """The step function of a document, applied by the definition."""

    def __init__(self, document: Json, digits: int = 4) -> None:
        assert set(document) == {"action", "period", "breaks", "values"}
        assert document["action"] == "squeeze"
        self.period = angle_of(document["period"], digits)
        self.breaks = [angle_of(angle, digits) for angle in document["breaks"]]
        self.values = [angle_of(angle, digits) for angle in document["values"]]
        self.order = self._order()
        assert len(self.breaks) == len(self.values) > 0
        assert self.breaks[0] >= ZERO
        following = [*self.breaks[1:], self.breaks[0] + self.period]
        for here, value, after in zip(self.breaks, self.values, following, strict=True):
            assert here < value < after

    def _order(self) -> int:
        order, total = 1, self.period
        while total < FULL_TURN:
            order, total = order + 1, total + self.period
        assert total == FULL_TURN
        return order

    def __call__(self, theta: Angle) -> Angle:
        periods = theta // self.period
        rest = theta - self.period * periods
        # Below the first break the last step of the period before applies.
        step = bisect_right(self.breaks, rest) - 1
        value = self.values[step] - (self.period if step < 0 else ZERO)
        return value + self.period * periods

    def values_on(self, start: Angle, width: Angle) -> set[Angle]:
        """Return every value on [start, start + width)."""
        first = start // self.period
        lifted = {b + self.period * k for b in self.breaks for k in range(first - 1, first + 3)}
        return {self(start)} | {self(b) for b in lifted if start < b < start + width}


def _check_arc(document: Json, digits: int) -> tuple[Angle, Angle]:
    return angle_of(document["start"], digits), angle_of(document["width"], digits)


def _check_worth(
    document: Json, steps: int, width: Json, digits: int, cost_ratio: Fraction, order: int
) -> None:
    """Assert that costs and probabilities are those of an arc of this width."""
    h = degrees_of(width)
    per_round = steps + cost_ratio

    def over(a: Fraction, b: Fraction | mpf) -> Fraction | mpf:
        return a / b if isinstance(b, Fraction) else MP.mpf(a.numerator) / a.denominator / b

    assert document["expected_cost"] == decimal_of(over(per_round * 360, h), digits)
    assert document["probability"] == decimal_of(h / 360, digits)
    if "expected_cost_up_to_symmetry" in document:
        shared = over(per_round * 360 / order, h)
        assert document["expected_cost_up_to_symmetry"] == decimal_of(shared, digits)
        assert document["probability_up_to_symmetry"] == decimal_of(h * order / 360, digits)


def _check_preimage(
    document: Json, steps: int, transfer: Transfer, digits: int, cost_ratio: Fraction
) -> Angle:
    assert set(document) == {
        "steps",
        "start",
        "width",
        "image_width",
        "expected_cost",
        "probability",
    }
    assert document["steps"] == steps
    start, width = _check_arc(document, digits)
    assert ZERO <= start < transfer.period
    values = transfer.values_on(start, width)
    assert max(values) - min(values) == angle_of(document["image_width"], digits)
    _check_worth(document, steps, document["width"], digits, cost_ratio, transfer.order)
    return width


def _check_plan(
    document: Json, transfer: Transfer, widths: list[Angle], digits: int, cost_ratio: Fraction
) -> None:
    assert set(document) == PLAN_KEYS
    steps = document["steps"]
    assert type(steps) is int
    start, width = _check_arc(document["mouth"], digits)
    assert ZERO <= start < transfer.period
    assert width == widths[steps - 1]
    assert document["orients_up_to_symmetry"] is (width == transfer.period)
    _check_worth(document, steps, document["mouth"]["width"], digits, cost_ratio, transfer.order)
    first, *others = document["actions"]
    assert len(others) == steps - 1
    assert first["low"] is None
    assert first["high"] is None
    assert angle_of(first["angle"], digits) == ZERO
    distances, slacks = [], []
    for action in others:
        assert set(action) == {"angle", "low", "high"}
        low, angle, high = (angle_of(action[key], digits) for key in ("low", "angle", "high"))
        assert low < angle <= high
        distances += [angle - low, high - angle]
        slacks.append(high - low)
    bound = document["error_bound"]
    assert (bound is None) == (not slacks)
    assert bound is None or angle_of(bound["doubled"], digits) == min(slacks)
    margin = document["margin"]
    assert (margin is None) == (not distances)
    assert margin is None or angle_of(margin, digits) == min(distances)
    _check_execution(document, transfer)


def _check_execution(plan: Json, transfer: Transfer) -> None:
    """Run the actions forward, each at its angle and each at its upper end, in every mixture."""
    choices = [
        [exact(action[key]) for key in ("angle", "high") if action[key] is not None]
        for action in plan["actions"]
    ]
    ends = {final_orientations(plan, transfer, angles) for angles in _mixtures(choices)}
    assert len(ends) == 1
    assert len(ends.pop()) == 1


def _mixtures(choices: list[list[Angle]]) -> list[list[Angle]]:
    """Return all first choices, all last choices, and each with one exchanged."""
    rows = []
    for common in (0, -1):
        rows.append([choice[common] for choice in choices])
        for k, choice in enumerate(choices):
            row = list(rows[0] if common == 0 else [c[-1] for c in choices])
            row[k] = choice[-1 - common]
            rows.append(row)
    return rows


def final_orientations(plan: Json, transfer: Transfer, angles: list[Angle]) -> frozenset[Angle]:
    """Return where the orientations of the mouth end up, modulo a full turn."""
    start, width = exact(plan["mouth"]["start"]), exact(plan["mouth"]["width"])
    states = transfer.values_on(start - angles[0], width)
    for alpha in angles[1:]:
        states = {transfer(theta - alpha) for theta in states}
    return frozenset(theta.reduced() for theta in states)
