"""Check the certificate of a feeding plan; standard library only, nothing of the planner.

    python certificate_checker.py FILE      exit code 0 valid, 1 a claim fails, 2 no certificate

The file claims: this is the outline's convex hull; these are all strict extrema of its diameter
function, hence breaks and values of its squeeze function, of this smallest period; these are the
widest arcs that 1, 2, ... actions collapse, up to a whole period; so much do the plans of each
length cost; these actions, anywhere in their ranges, bring the mouth to one orientation. Where the
action is push-grasp, also: these are all strict extrema of the distance from the centre of mass to
the lower jaw, hence breaks and values of the push function; squeezed after it, the part turns by
these steps. From the outline, the centre of mass if need be, the cost ratio and the number of
steps everything is computed anew here, in whole numbers and by the plainest method, and compared
field by field. Only the nominal angles are free inside their ranges. (That the outline does not
cross itself is no claim: jaws touch the hull only. Nor is the centre of mass: that depends on
density and holes.)

An angle is (t, x, y): t turns plus the argument of x + i y in [0, 360) degrees, in whole numbers, x
and y coprime. At the orientation (t, x, y) a point p of the part stands at p (x + i y). Where the
coordinates are numbers of a real algebraic field, x and y are as well: `field_certificate_checker`,
beside this file, brings the arithmetic for these, and everything from the hull on is the same.
"""

from __future__ import annotations

import json
import math
import re
import sys
from bisect import bisect_left, bisect_right
from collections.abc import Callable
from decimal import Decimal
from fractions import Fraction
from functools import cmp_to_key, reduce
from heapq import nsmallest
from pathlib import Path
from reprlib import repr as shortened
from typing import Any, NamedTuple

SCHEMA = "stochgeom/certificate/1"
MAX_BYTES = 2**26
MAX_DIGITS = 2**16
Angle = tuple[int, Any, Any]
Corner = tuple[int, Any, Any]  # vertex number, x, y
CostSign = Callable[[Fraction, Angle, Fraction, Angle], int]


class InvalidClaimError(Exception):
    """A claim that does not hold: its place in the document, and why."""

    def __str__(self) -> str:
        return ": ".join(self.args)


class NoCertificateError(InvalidClaimError):
    """What was read is no certificate of this schema."""


def argument_sign(ax: Any, ay: Any, bx: Any, by: Any) -> int:
    """Return the sign of arg a - arg b, both in [0, 360) degrees."""
    a, b = ay < 0 or (ay == 0 and ax < 0), by < 0 or (by == 0 and bx < 0)
    if a is not b:
        return 1 if a else -1
    cross = ay * bx - ax * by
    return 1 if cross > 0 else -1 if cross < 0 else 0


def compare(a: Angle, b: Angle) -> int:
    """Return the sign of a - b."""
    return (a[0] > b[0]) - (a[0] < b[0]) or argument_sign(*a[1:], *b[1:])


ORDER = cmp_to_key(compare)


def angle(turns: int, x: Any, y: Any) -> Angle:
    """Return the angle with x and y made coprime; as they are if they are no whole numbers."""
    if type(x) is not int:
        return turns, x, y
    g = math.gcd(x, y)
    return turns, x // g, y // g


def add(a: Angle, b: Angle) -> Angle:
    """Return a + b: a turn is full if the argument of the product is below a factor's."""
    x, y = a[1] * b[1] - a[2] * b[2], a[1] * b[2] + a[2] * b[1]
    return angle(a[0] + b[0] + (argument_sign(x, y, *b[1:]) < 0), x, y)


def sub(a: Angle, b: Angle) -> Angle:
    """Return a - b."""
    borrow = argument_sign(*a[1:], *b[1:]) < 0
    return angle(a[0] - b[0] - borrow, a[1] * b[1] + a[2] * b[2], a[2] * b[1] - a[1] * b[2])


def eighths(n: int) -> Angle:
    """Return n eighths of a turn."""
    directions = ((1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1))
    return n // 8, *directions[n % 8]


def floor_eighths(a: Angle) -> int:
    """Return how many whole eighths of a turn an angle holds."""
    (t, x, y), n = a, 0
    if argument_sign(x, y, -1, 0) >= 0:
        x, y, n = -x, -y, 4
    if x <= 0:
        x, y, n = y, -x, n + 2
    return 8 * t + n + int(y >= x)


def remainder(a: Angle, e: int) -> Angle:
    """Return a in [0, T), where T is e eighths of a turn."""
    return add(a, eighths(-(floor_eighths(a) // e) * e))


def whole(points: list[tuple[Fraction, Fraction]]) -> list[Corner]:
    """Return the points with their numbers, scaled to whole coordinates."""
    scale = math.lcm(*(number.denominator for point in points for number in point))
    return [(k, int(x * scale), int(y * scale)) for k, (x, y) in enumerate(points)]


def convex_hull(points: list[Corner]) -> list[Corner]:
    """Return the strict corners, counter-clockwise, from the one of smallest number."""
    ordered = sorted((x, y, k) for k, x, y in points)
    # Of repeated ones, the first in the outline.
    corners = [c for k, c in enumerate(ordered) if not k or c[:2] != ordered[k - 1][:2]]
    halves = []
    for row in (corners, corners[::-1]):
        chain: list[tuple[Any, Any, int]] = []
        for c in row:
            while len(chain) > 1 and cross(chain[-2], chain[-1], c) <= 0:
                chain.pop()
            chain.append(c)
        halves += chain[:-1]
    if len(halves) < 3:
        raise InvalidClaimError("part", "the outline has no area")
    start = min(range(len(halves)), key=lambda n: halves[n][2])
    return [(k, x, y) for x, y, k in halves[start:] + halves[:start]]


def cross(a: tuple[Any, ...], b: tuple[Any, ...], c: tuple[Any, ...]) -> Any:
    """Return twice the signed area of a triangle."""
    return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])


def contacts(hull: list[Corner], a: Angle) -> tuple[list[Corner], list[Corner]]:
    """Return the corners on the lower and on the upper jaw, from left to right along them."""
    heights = [height(c, a) for c in hull]
    ends = min(heights), max(heights)
    sides = [[c for c, h in zip(hull, heights, strict=True) if h == end] for end in ends]
    lower, upper = (sorted(side, key=lambda c: along(c, a)) for side in sides)
    return lower, upper


def height(corner: Corner, a: Angle) -> Any:
    """Return the height of a corner over the origin."""
    return corner[1] * a[2] + corner[2] * a[1]


def along(corner: Corner, a: Angle) -> Any:
    """Return the position of a corner along the jaws."""
    return corner[1] * a[1] - corner[2] * a[2]


def extrema(hull: list[Corner]) -> tuple[list[Angle], list[Angle]]:
    """Return all strict maxima and minima of the diameter, in [0, 180) degrees, sorted.

    Between two flush edges the same corners touch. The slope of the diameter is the upper contact
    less the lower one, along the jaws: just after a flush orientation the right end of the upper
    and the left end of the lower side touch, just before it the other ends. In between, the slope
    falls to zero where the chord of the contacts stands upright.
    """
    edges = zip(hull, hull[1:] + hull[:1], strict=True)
    flush = sorted((remainder(angle(0, b[1] - a[1], a[2] - b[2]), 4) for a, b in edges), key=ORDER)
    maxima, minima = [], []
    turns = [a for k, a in enumerate(flush) if not k or compare(flush[k - 1], a)]
    for here, following in zip(turns, [*turns[1:], add(turns[0], eighths(4))], strict=True):
        lower, upper = contacts(hull, here)
        before = along(upper[0], here) - along(lower[-1], here)
        after = along(upper[-1], here) - along(lower[0], here)
        if before < 0 < after:
            minima.append(here)
        p, q = lower[0], upper[-1]
        if after > 0 > along(q, following) - along(p, following):
            maxima.append(remainder(angle(0, q[2] - p[2], q[1] - p[1]), 4))
    return sorted(maxima, key=ORDER), minima


def radius_extrema(hull: list[Corner], center: Corner) -> tuple[list[Angle], list[Angle]]:
    """Return all strict maxima and minima, in [0, 360) degrees, sorted, of the radius.

    That is the centre's distance from the lower jaw. Just after a flush orientation the left end
    of the edge touches, just before it the right end, and the slope is how far the centre stands
    to the right of the contact: so a minimum is a flush edge with the centre above its inside, a
    maximum a corner straight below the centre that touches alone.
    """
    edges, minima = zip(hull, hull[1:] + hull[:1], strict=True), []
    for a, b in edges:
        here = angle(0, b[1] - a[1], a[2] - b[2])
        left, right = contacts(hull, here)[0]
        if height(center, here) <= height(left, here):
            raise InvalidClaimError("part.center_of_mass", "not strictly inside the hull")
        if along(left, here) < along(center, here) < along(right, here):
            minima.append(here)
    upright = [(c, angle(0, center[2] - c[2], center[1] - c[1])) for c in hull]
    maxima = [here for c, here in upright if contacts(hull, here)[0] == [c]]
    return sorted(maxima, key=ORDER), sorted(minima, key=ORDER)


class StepMap:
    """A monotone step map: b_k and v_k for all whole k, the same again after e eighths of a turn.

    Made of the breaks and values of e eighths, the first value being that of the first break.
    Values that are equal become one step: `kept` are the numbers of the breaks that remain, `rows`
    the breaks and values. The first m of them, `breaks` and `values`, are those of the smallest
    `period`.
    """

    def __init__(self, breaks: list[Angle], values: list[Angle], e: int) -> None:
        before = [sub(values[-1], eighths(e)), *values]
        self.e, self.kept = e, [k for k, value in enumerate(values) if compare(value, before[k])]
        self.rows = [[row[k] for k in self.kept] for row in (breaks, values)]
        n = len(self.kept)
        # Every m steps, all must have turned alike; after all n, they have.
        for m in (m for m in range(1, n + 1) if n % m == 0):
            turned = (sub(self.at(row, k + m), row[k]) for row in self.rows for k in range(n))
            self.m, self.period = m, next(turned)
            if not any(compare(other, self.period) for other in turned):
                break
        self.breaks, self.values = (row[: self.m] for row in self.rows)

    def at(self, row: list[Angle], k: int) -> Angle:
        """Return entry k of one of the rows."""
        return add(row[k % len(row)], eighths(k // len(row) * self.e))

    def value(self, k: int) -> Angle:
        """Return v_k."""
        return self.at(self.rows[1], k)

    def step(self, a: Angle, *, from_left: bool = False) -> int:
        """Return the number of the step at a, or just before a."""
        laps = floor_eighths(a) // self.e
        rest = ORDER(add(a, eighths(-laps * self.e)))
        search = bisect_left if from_left else bisect_right
        return laps * len(self.kept) + search(self.rows[0], rest, key=ORDER) - 1

    def apply(self, a: Angle, *, from_left: bool = False) -> Angle:
        """Return s(a), or the value of s just before a."""
        return self.value(self.step(a, from_left=from_left))


def from_extrema(maxima: list[Angle], minima: list[Angle], e: int) -> StepMap:
    """Return the map from each maximum on to the minimum that follows, perhaps a period on."""
    if compare(minima[0], maxima[0]) < 0:
        minima = [*minima[1:], add(minima[0], eighths(e))]
    return StepMap(maxima, minima, e)


def touching(hull: list[Corner], row: list[Angle]) -> list[dict[str, Any]]:
    """Return angles with the vertices on both jaws: one that is upright, or a flush edge."""
    sides = [contacts(hull, a) for a in row]
    numbers = [[[c[0] for c in side] for side in pair] for pair in sides]
    return [{"angle": a, "lower": p, "upper": q} for a, (p, q) in zip(row, numbers, strict=True)]


def squeeze(hull: list[Corner]) -> tuple[StepMap, dict[str, Any]]:
    """Return the squeeze function, and what a certificate says of it."""
    s = from_extrema(*extrema(hull), 4)
    breaks, values = (touching(hull, row) for row in (s.breaks, s.values))
    return s, {"period": s.period, "breaks": breaks, "values": values}


def push(hull: list[Corner], center: Corner) -> tuple[StepMap, dict[str, Any]]:
    """Return the push function, and what a certificate says of it."""
    p = from_extrema(*radius_extrema(hull, center), 8)
    breaks, values = (touching(hull, row) for row in (p.breaks, p.values))
    return p, {
        "period": p.period,
        "breaks": [{"angle": row["angle"], "vertex": row["lower"][0]} for row in breaks],
        "values": [{"angle": row["angle"], "edge": row["lower"]} for row in values],
    }


def push_grasp(hull: list[Corner], center: Corner) -> tuple[StepMap, dict[str, Any]]:
    """Return squeeze after push, by the numbers of their steps, and what a certificate says."""
    (p, push_claims), (s, squeeze_claims) = push(hull, center), squeeze(hull)
    steps = [s.step(value) for value in p.rows[1]]
    both = StepMap(p.rows[0], [s.value(step) for step in steps], 8)
    numbered = list(zip(both.kept, both.breaks, both.values, strict=False))
    return both, {
        "push": push_claims,
        "squeeze": squeeze_claims,
        "period": both.period,
        "breaks": [{"angle": b, "push_break": k} for k, b, _ in numbered],
        "values": [{"angle": v, "squeeze_value": steps[k]} for k, _, v in numbered],
    }


def preimages(s: StepMap) -> list[dict[str, Any]]:
    """Return the widest arcs with an image narrower than the last one, up to a period.

    They begin at breaks: one pointer runs over the starts, one over the ends. Of equally wide ones
    the narrowest image wins, then the first start; the rival is the best of the other starts.
    """
    b, v = ([s.at(row, k) for k in range(2 * s.m + 1)] for row in s.rows)

    def order(p: Any, q: Any) -> int:
        return compare(q[0], p[0]) or compare(p[1], q[1])

    chain: list[dict[str, Any]] = []
    while not chain or compare(chain[-1]["width"], s.period):
        arcs, last = [], 0
        for first in range(s.m):
            last = max(last, first)
            while chain and compare(sub(v[last + 1], v[first]), chain[-1]["width"]) < 0:
                last += 1
            arcs.append((sub(b[last + 1], b[first]), sub(v[last], v[first]), first, last))
        (width, image_width, first, last), *other = nsmallest(2, arcs, key=cmp_to_key(order))
        rival = {"first": other[0][2], "width": other[0][0]} if other else None
        arc = {"steps": len(chain) + 1, "first": first, "last": last, "start": b[first]}
        arc |= {"width": width, "image_start": v[first], "image_width": image_width, "rival": rival}
        chain.append(arc)
    return chain


def costs(rows: list[tuple[Fraction, Angle]], decide: CostSign) -> tuple[int, list[dict[str, Any]]]:
    """Return the best length, and each length's (i + c) and how its cost compares with the best."""
    best = 0
    for k, row in enumerate(rows):
        best = k if decide(*row, *rows[best]) < 0 else best
    signs = [{"numerator": text(p), "comparison": decide(p, a, *rows[best])} for p, a in rows]
    return best + 1, signs


def cost_sign(p: Fraction, a: Angle, q: Fraction, b: Angle) -> int:
    """Return the sign of p / a - q / b, that is of n b - m a for whole n, m without common factor.

    Eighths of a turn are whole numbers. Else, if this is not zero, enclosures must show its sign.
    """
    n, m = (p / q).as_integer_ratio()
    if all(0 in (x, y) or abs(x) == abs(y) for _, x, y in (a, b)):
        left, right = n * floor_eighths(b), m * floor_eighths(a)
        return (left > right) - (left < right)
    bits = 64
    while abs(difference := n * in_eighths(b, bits) - m * in_eighths(a, bits)) <= 4 * (n + m):
        if bits == 64 and tied(n, a, m, b):
            return 0
        bits *= 2
    return 1 if difference > 0 else -1


def tied(n: int, a: Angle, m: int, b: Angle) -> bool:
    """Tell whether n b = m a > 0, for n, m > 0 without common factor, not both whole eighths.

    If so, a = n g and b = m g, where g = u a + v b with u n + v m = 1, and Euclid's subtractions
    lead from n and m to 1 and 0, from a and b to g and 0. Directions get shorter on the way: g is
    no whole number of eighths, so its direction has a prime factor of norm 5 or more in the
    Gaussian integers, not also the conjugate one, and in that of k g its k-th power remains.
    """
    while m:
        if n < m:
            n, a, m, b = m, b, n, a
        rest = sub(a, b)
        if rest[1] ** 2 + rest[2] ** 2 >= a[1] ** 2 + a[2] ** 2:
            return False
        n, a, m, b = m, b, n - m, rest
    return b == eighths(0)


def in_eighths(a: Angle, bits: int) -> int:
    """Return a / 45 degrees times 2**bits, off by less than 4."""
    one, whole = 1 << (bits + 64), floor_eighths(a)
    _, x, y = add(a, eighths(-whole))
    return (whole << bits) + ((arctan(y * one // x, one) * one // eighth_turn(one)) >> 64)


def eighth_turn(one: int) -> int:
    """Return about one * pi / 4; here and in `arctan`, 64 spare bits cover 2**50 roundings."""
    return 4 * arctan(one // 5, one) - arctan(one // 239, one)


def arctan(t: int, one: int) -> int:
    """Return about one * arctan(t / one), 0 <= t <= one: three halvings and the Taylor series."""
    for _ in range(3):
        t = t * one // (one + math.isqrt(one * one + t * t))
    total, power, k = 0, t, 1
    while power:
        total += power // k if k % 4 == 1 else -(power // k)
        power, k = power * t // one * t // one, k + 2
    return 8 * total


def actions(chain: list[dict[str, Any]], nominal: list[Angle]) -> list[dict[str, Any]]:
    """Return the actions of the plan that begins with the last arc of the chain."""
    if len(nominal) != len(chain):
        raise InvalidClaimError("plan.actions", f"{len(nominal)} of them in {len(chain)} steps")
    found: list[dict[str, Any]] = [{"angle": eighths(0), "low": None, "high": None}]
    for here, goal, alpha in zip(chain[:0:-1], chain[-2::-1], nominal[1:], strict=True):
        end = add(here["image_start"], here["image_width"])
        low = sub(end, add(goal["start"], goal["width"]))
        high = sub(here["image_start"], goal["start"])
        if compare(alpha, low) <= 0 or compare(alpha, high) > 0:
            raise InvalidClaimError(f"plan.actions.{len(found)}.angle", "outside (low, high]")
        found.append({"angle": alpha, "low": low, "high": high})
    return found


def run_forward(s: StepMap, chain: list[dict[str, Any]], plan: list[dict[str, Any]]) -> None:
    """Run the mouth through the plan: it must collapse inside the ranges, and not at a lower end.

    Just above a lower end, the step just before the sum applies. At a lower end the plan must fail
    if the actions before it stand just above theirs (else an image may be narrower than allowed).
    """
    start, end = chain[-1]["start"], add(chain[-1]["start"], chain[-1]["width"])
    goal = remainder(chain[0]["image_start"], 8)

    def act(ends: list[Angle], alpha: Angle, *, just_above: bool = False) -> list[Angle]:
        return [s.apply(sub(end, alpha), from_left=just_above) for end in ends]

    def collapses(ends: list[Angle], alphas: list[Angle]) -> bool:
        low, high = reduce(act, alphas, ends)  # a turn apart, they would not be one
        return compare(low, high) == 0 == compare(remainder(low, 8), goal)

    first = above = [s.apply(start), s.apply(end, from_left=True)]
    for k, action in enumerate(plan[1:], start=1):
        if collapses(act(above, action["low"]), [later["angle"] for later in plan[k + 1 :]]):
            raise InvalidClaimError(f"plan.actions.{k}.low", "the plan works there as well")
        above = act(above, action["low"], just_above=True)
    nominal, highest = ([action[which] for action in plan[1:]] for which in ("angle", "high"))
    if not (collapses(above, []) and collapses(first, nominal) and collapses(first, highest)):
        raise InvalidClaimError("plan", "does not collapse the mouth")


def read_point(pair: Any, place: str, read_number: Callable[[Any, str], Any]) -> tuple[Any, Any]:
    """Read two coordinates."""
    if not isinstance(pair, list) or len(pair) != 2:
        raise NoCertificateError(place, f"{shown(pair)} is no pair")
    return read_number(pair[0], place), read_number(pair[1], place)


def read(value: Any, place: str, kind: type) -> Any:
    """Return a member of the right type; its key ends the place."""
    key = place.rpartition(".")[2]
    if not isinstance(value, dict) or type(value.get(key)) is not kind:
        raise NoCertificateError(place, f"missing, or not a JSON {kind.__name__}")
    return value[key]


def rational(value: Any, place: str) -> Fraction:
    """Read "p" or "p/q" in lowest terms."""
    if isinstance(value, str) and len(value) <= MAX_DIGITS:
        found = re.fullmatch("(-?[0-9]+)(?:/([1-9][0-9]*))?", value)
        number = Fraction(*(int(Decimal(n or 1)) for n in found.groups())) if found else None
        if number is not None and text(number) == value:
            return number
    raise NoCertificateError(place, f"{shown(value)} is not p or p/q in lowest terms, as text")


def text(number: Fraction | int) -> str:
    """Return p or p/q in digits; `str` refuses whole numbers of more than 4300."""
    p, q = (str(Decimal(n)) for n in number.as_integer_ratio())
    return p if q == "1" else f"{p}/{q}"


def read_angle(action: Any, place: str) -> Angle:
    """Read an angle; whether it is canonical shows when it is compared."""
    found = read(action, place, dict)
    pair = [rational(number, place) for number in read(found, f"{place}.direction", list)]
    if len(pair) != 2 or not any(pair) or any(number.denominator > 1 for number in pair):
        raise NoCertificateError(place, "its direction is not two whole numbers, or is zero")
    return angle(read(found, f"{place}.turns", int), int(pair[0]), int(pair[1]))


def written(true: Angle, _claimed: Any, _place: str) -> Any:
    """Return an angle as a document has to write it."""
    return {"turns": true[0], "direction": [text(true[1]), text(true[2])]}


class Numbers(NamedTuple):
    """What differs between rational parts and those over a field: how to read, write, decide."""

    schema: str
    field: dict[str, Any]  # what the part's claims say of it
    read: Callable[[Any, str], Any]
    whole: Callable[[list[Any]], list[Corner]]
    angle: Callable[[Any, str], Angle]
    written: Callable[[Angle, Any, str], Any]
    cost_sign: CostSign


RATIONAL = Numbers(SCHEMA, {}, rational, whole, read_angle, written, cost_sign)


def certify(document: Any, numbers: Numbers) -> dict[str, Any]:
    """Return what a certificate must say, given its outline, cost ratio, steps and angles.

    The centre of mass is given as well where the action is push-grasp.
    """
    part, plan = read(document, "part", dict), read(document, "plan", dict)
    if not isinstance(name := part.get("name"), str | None):
        raise NoCertificateError("part.name", f"{shown(name)} is neither text nor null")
    pairs = read(part, "part.vertices", list)
    points = [read_point(pair, f"part.vertices.{k}", numbers.read) for k, pair in enumerate(pairs)]
    if (action := document.get("action")) not in ("squeeze", "push-grasp"):
        raise InvalidClaimError("action", f"claimed {shown(action)}, no squeeze or push-grasp")
    if pushed := action == "push-grasp":
        pair = read(part, "part.center_of_mass", list)
        points.append(read_point(pair, "part.center_of_mass", numbers.read))
    corners = numbers.whole(points)
    cost_ratio = rational(read(document, "cost_ratio", str), "cost_ratio")
    if cost_ratio < 0:
        raise InvalidClaimError("cost_ratio", "negative")
    hull = convex_hull(corners[: len(pairs)])
    s, transfer = push_grasp(hull, corners[-1]) if pushed else squeeze(hull)
    chain = preimages(s)
    rows = [(i + cost_ratio, arc["width"]) for i, arc in enumerate(chain, start=1)]
    best, compared = costs(rows, numbers.cost_sign)
    steps = read(plan, "plan.steps", int)
    if not 1 <= steps <= len(chain):
        raise InvalidClaimError("plan.steps", f"not in 1 to {len(chain)}")
    used = chain[:steps]
    claimed = enumerate(read(plan, "plan.actions", list))
    nominal = [numbers.angle(action, f"plan.actions.{k}.angle") for k, action in claimed]
    listed = actions(used, nominal)
    run_forward(s, used, listed)
    given = numbers.field | ({"center_of_mass": pair} if pushed else {})
    return {
        "schema": numbers.schema,
        "action": action,
        "part": {"name": name, "vertices": pairs} | given,
        "hull": [k for k, _, _ in hull],
        **transfer,
        "preimages": chain,
        "cost_ratio": document["cost_ratio"],
        "costs": compared,
        "optimal_steps": best,
        "plan": {
            "steps": steps,
            "mouth": {"start": used[-1]["start"], "width": used[-1]["width"]},
            "actions": listed,
            "final_orientation": chain[0]["image_start"],
            "optimal": steps == best,
            "orients_up_to_symmetry": steps == len(chain),
        },
    }


def agree(claimed: Any, true: Any, place: str, numbers: Numbers = RATIONAL) -> None:
    """Raise at the first place where a claim differs from what holds."""
    if isinstance(true, tuple):
        true = numbers.written(true, claimed, place)
    if isinstance(true, list) and isinstance(claimed, list) and len(claimed) == len(true):
        claimed, true = dict(enumerate(claimed)), dict(enumerate(true))
    if isinstance(true, dict) and isinstance(claimed, dict) and claimed.keys() == true.keys():
        for key in true:
            agree(claimed[key], true[key], f"{place}.{key}".removeprefix("document."), numbers)
    elif type(claimed) is not type(true) or claimed != true:
        raise InvalidClaimError(place, f"claimed {shown(claimed)}, but {shown(true)} holds")


def shown(value: Any) -> str:
    """Return a value, or the keys of an object, as one short line of ASCII."""
    line = shortened(list(value) if isinstance(value, dict) else value)
    return line[:200].encode("ascii", "backslashreplace").decode()


def load(data: bytes, schemas: tuple[str, ...] = (SCHEMA,)) -> Any:
    """Parse the bytes of a certificate file; refuse what Python reads beyond plain JSON."""

    def unique(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
        if len({key for key, _ in pairs}) < len(pairs):
            raise ValueError("a key occurs twice in one object")
        return dict(pairs)

    def whole(digits: str) -> int:
        if not re.fullmatch("0|-?[1-9][0-9]{0,18}", digits):
            raise ValueError(f"{digits[:20]} is no short whole number")
        return int(digits)

    if len(data) > MAX_BYTES:
        raise NoCertificateError("file", f"more than {MAX_BYTES} bytes")
    hooks: dict[str, Any] = {"parse_int": whole, "parse_constant": whole}
    try:
        found = json.loads(data.decode(), object_pairs_hook=unique, **hooks)
    except (ValueError, RecursionError) as error:
        raise NoCertificateError("file", f"not JSON: {str(error)[:100]}") from None
    schema = found.get("schema") if isinstance(found, dict) else None
    if schema not in schemas:
        accepted = " or ".join(map(repr, schemas))
        raise NoCertificateError("schema", f"{shown(schema)}; accepted: {accepted}")
    return found


def check(document: Any, numbers: Numbers = RATIONAL) -> None:
    """Raise `InvalidClaimError` with the first claim that fails."""
    agree(document, certify(document, numbers), "document", numbers)


def main(arguments: list[str], load: Any = load, check: Any = check) -> int:
    """Check the file named; say "valid", or the first claim that fails."""
    try:
        if len(arguments) != 1:
            raise NoCertificateError("arguments", "accepted: the name of one file")
        with Path(arguments[0]).open("rb") as file:
            check(load(file.read(MAX_BYTES + 1)))
    except (NoCertificateError, OSError) as error:
        sys.stderr.write(f"no certificate: {error}\n")
        return 2
    except InvalidClaimError as error:
        sys.stdout.write(f"invalid: {error}\n")
        return 1
    sys.stdout.write("valid\n")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
