"""Check the certificate of a feeding plan for a part over a real algebraic field.

    python field_certificate_checker.py FILE      exit codes as those of certificate_checker

It needs the standard library and `certificate_checker` beside it, nothing of the planner, and
checks what that file claims to check, and certificates of rational parts as well.

**Numbers.** The part names its field L: ``{"square root of": d}``, or ``{"regular polygon": m}``
for the field of g = 2 cos(2 pi / m) and s = 2 sin(2 pi / m). Coordinates are polynomials in these,
in the one form of lowest terms, and are scaled up by a whole number. Everything computed from them
is a `Number`: a sum of algebraic integers, or a sum, difference or product of two. It is never
multiplied out, but it can be enclosed to any number of bits, and it knows a bound 2^k on the
absolute values of all its conjugates. If it is not zero, the product of all D conjugates is a whole
number other than 0, D being the degree of the field: so it is at least 2^(-k (D - 1)). An enclosure
around 0 that is narrower than that holds zero; that is all there is to deciding signs.

**Angles** are (t, x, y) as in `certificate_checker`, with such numbers x and y. They have no unique
form, so a claimed angle is compared as a value: any positive multiple of a direction is accepted.
A claim may state a rational number of turns, such as 1/10, beside its direction: then x + i y is
turned that far. A multiple of 1/(2 w) turn, w being the number of roots of unity of L(i), is a
direction over L. No other rational number of turns is: z / conj(z) has twice the argument of z and
would be such a root. So nominal angles like 1/7 turn tie with no angle over L, and for their
cosines the enclosures alone always decide.
"""

from __future__ import annotations

import math
import sys
from fractions import Fraction
from functools import cache
from typing import Any, Final

if __package__:
    from stochgeom.feeding import certificate_checker as base
else:  # run as a script, or copied beside that file
    import certificate_checker as base  # type: ignore[import-not-found, no-redef]

SCHEMA: Final = "stochgeom/certificate/2"
MAX_VERTICES: Final = 1000
MAX_RADICAND: Final = 10**12
START_BITS: Final = 128
Vector = dict[int, Any]  # coefficients of a sum of basis elements, by their numbers

# --- algebraic integers ---------------------------------------------------------------------------


class Field:
    """A real field with some algebraic integers e_0 = 1, e_1, ...; here, with e_0 only.

    `degree` is at least that of the field, and no conjugate of e_k is beyond 2**`bound`.
    """

    def __init__(self, degree: int, bound: int = 0) -> None:
        self.degree, self.bound = degree, bound

    def value(self, k: int, bits: int) -> int:
        """Return e_k times 2**bits, off by less than 2; e_0 exactly."""
        assert k == 0
        return 1 << bits


class Cosines(Field):
    """The real numbers of Q(zeta_w), 4 dividing w: e_k = 2 cos(2 pi k / w) for 0 < k <= w / 2."""

    def __init__(self, w: int) -> None:
        # Beyond the fields of parts, w bounds the degree as well.
        units = range(w) if w <= 4 * MAX_VERTICES else ()
        super().__init__(sum(math.gcd(k, w) == 1 for k in units) // 2 or w, 1)
        self.w = w

    def value(self, k: int, bits: int) -> int:
        """Return twice a cosine, or 1."""
        return twice_cosine(k, self.w, bits) if k else super().value(k, bits)

    def cosine(self, k: int) -> Vector:
        """Return 2 cos(2 pi k / w) for any k."""
        k = min(k % self.w, -k % self.w)
        return {k: 1} if k else {0: 2}

    def product(self, vector: Vector, k: int) -> Vector:
        """Return a sum times 2 cos(2 pi k / w), by the cosines of sums and differences."""
        total: Vector = {}
        for j, c in vector.items():
            for turned in (k + j, k - j) if j else (k,):
                for i, factor in self.cosine(turned).items():
                    total[i] = total.get(i, 0) + factor * c
        return total


class Root(Field):
    """Q(sqrt d): e_1 is the root."""

    def __init__(self, d: int) -> None:
        super().__init__(2, math.isqrt(d).bit_length())
        self.d = d

    def value(self, k: int, bits: int) -> int:
        """Return the root, or 1."""
        return math.isqrt(self.d << (2 * bits)) if k else super().value(k, bits)


RATIONALS: Final = Field(1)


@cache
def cosines(w: int) -> Cosines:
    """Return the one field of a number w of roots of unity."""
    return Cosines(w)


@cache
def joined(a: Field, b: Field) -> Field:
    """Return a field that holds two others."""
    if a is b or b.degree == 1:
        return a
    return b if a.degree == 1 else Field(a.degree * b.degree)


@cache
def twice_cosine(k: int, w: int, bits: int) -> int:
    """Return 2 cos(2 pi k / w) times 2**bits for 0 < k <= w / 2, off by less than 2.

    The Taylor series far below 1 radian, then cos 2t = 2 cos^2 t - 1. Each of these doublings makes
    the error four times as large: two spare bits for each, and 64 for the roundings before.
    """
    halvings = math.isqrt(bits)
    spare = 2 * halvings + 64
    digits = bits + spare
    t = (eighth_turn(digits) * 8 * k // w) >> halvings
    square, term, total, n = t * t >> digits, 1 << digits, 0, 0
    while term:
        total += -term if n % 4 else term
        term, n = (term * square >> digits) // ((n + 1) * (n + 2)), n + 2
    for _ in range(halvings):
        total = (2 * total * total >> digits) - (1 << digits)
    return total >> (spare - 1)


@cache
def eighth_turn(bits: int) -> int:
    """Return about pi / 4 times 2**bits."""
    return base.eighth_turn(1 << bits)


class Number:
    """A sum of algebraic integers of a field, or the sum, difference or product of two numbers.

    No conjugate is beyond 2**`size`. Enclosures are made when they are asked for, and kept.
    """

    __slots__ = ("_known", "_of", "_sign", "field", "size")

    def __init__(self, field: Field, size: int, of: Any) -> None:
        self.field, self.size, self._of = field, size, of
        self._known: dict[int, tuple[int, int]] = {}
        self._sign: int | None = None

    def enclose(self, bits: int) -> tuple[int, int]:
        """Return the number times 2**bits and how far that may be off."""
        found = self._known.get(bits)
        if found is None:
            found = self._known[bits] = self._enclose(bits)
        return found

    def _enclose(self, bits: int) -> tuple[int, int]:
        if isinstance(self._of, dict):
            total = sum(c * self.field.value(k, bits) for k, c in self._of.items())
            return total, 2 * sum(abs(c) for k, c in self._of.items() if k)
        operation, left, right = self._of
        (a, da), (b, db) = left.enclose(bits), right.enclose(bits)
        if operation == "*":
            return a * b >> bits, ((abs(a) * db + abs(b) * da + da * db) >> bits) + 2
        return a + b if operation == "+" else a - b, da + db

    def sign(self) -> int:
        """Return -1, 0 or 1: see the top of this file."""
        bits = START_BITS
        while self._sign is None:
            value, error = self.enclose(bits)
            if abs(value) > error:
                self._sign = 1 if value > 0 else -1
            # Now it is at most 2 error / 2**bits.
            elif not error or (
                (2 * error).bit_length() + self.size * (self.field.degree - 1) <= bits
            ):
                self._sign = 0
            bits *= 2
        return self._sign

    def __add__(self, other: Any) -> Number:
        return self._with("+", other)

    def __sub__(self, other: Any) -> Number:
        return self._with("-", other)

    def __neg__(self) -> Number:
        return 0 - self

    def __rsub__(self, other: int) -> Number:
        return whole_number(other) - self

    def __mul__(self, other: Any) -> Any:
        if type(other) is int and other in (0, 1):
            return self if other else 0
        return self._with("*", other)

    __radd__, __rmul__ = __add__, __mul__

    def _with(self, operation: str, other: Any) -> Number:
        if type(other) is int:
            if other == 0 and operation != "*":
                return self
            other = whole_number(other)
        sizes = self.size, other.size
        size = sum(sizes) if operation == "*" else max(sizes) + 1
        return Number(joined(self.field, other.field), size, (operation, self, other))

    def __eq__(self, other: object) -> bool:
        return self._with("-", other).sign() == 0

    def __lt__(self, other: Any) -> bool:
        return self._with("-", other).sign() < 0

    def __gt__(self, other: Any) -> bool:
        return self._with("-", other).sign() > 0

    def __le__(self, other: Any) -> bool:
        return self._with("-", other).sign() <= 0

    def __ge__(self, other: Any) -> bool:
        return self._with("-", other).sign() >= 0

    __hash__ = None  # type: ignore[assignment]


def leaf(field: Field, vector: Vector) -> Number:
    """Return a sum of basis elements with whole coefficients."""
    size = sum(map(abs, vector.values())).bit_length() + field.bound
    return Number(field, size, vector)


def whole_number(n: int) -> Number:
    """Return a whole number."""
    return leaf(RATIONALS, {0: n})


# --- numbers and angles of a document -------------------------------------------------------------


class Reader:
    """What a document says over a field: how to read it, and what is decided about angles."""

    def __init__(self, description: Any) -> None:
        """Take ``{"square root of": d}`` or ``{"regular polygon": m}``, each field by one name."""
        if not isinstance(description, dict) or len(description) != 1:
            raise base.NoCertificateError("part.field", "no object of one entry")
        [(kind, n)] = description.items()
        if type(n) is not int:
            raise base.NoCertificateError("part.field", "its number is not a whole one")
        self.description = description
        self.nominal: dict[str, base.Angle] = {}
        if kind == "square root of" and 2 <= n <= MAX_RADICAND and is_squarefree(n):
            self._quadratic(n)
        elif (
            kind == "regular polygon" and 5 <= n <= MAX_VERTICES and n % 4 != 2 and n not in (8, 12)
        ):
            self._polygon(n)
        else:
            name = base.shown(f"{kind} {n}")
            raise base.NoCertificateError("part.field", f"{name} is no field by its proper name")

    def _quadratic(self, d: int) -> None:
        self.w = {2: 8, 3: 12}.get(d, 4)
        # sqrt 2 and sqrt 3 are twice the cosines of 45 and of 30 degrees.
        self.field: Field = Root(d) if self.w == 4 else cosines(self.w)
        self.monomials: dict[str, Vector] = {"": {0: 1}, f"sqrt({d})": {1: 1}}

    def _polygon(self, m: int) -> None:
        self.w = math.lcm(4, m)
        self.field = field = cosines(self.w)
        powers: dict[str, Vector] = {"": {0: 1}}
        for k in range(1, sum(math.gcd(j, m) == 1 for j in range(m)) // 2):
            last = list(powers.values())[-1]
            powers["g" if k == 1 else f"g^{k}"] = field.product(last, self.w // m)
        sine = self.w // 4 - self.w // m
        self.monomials = dict(powers)
        if m % 4:
            for name, power in powers.items():
                self.monomials[f"{name}*s" if name else "s"] = field.product(power, sine)

    def read(self, value: Any, place: str) -> Vector:
        """Read a sum such as ``-1/2 + 3*g^2*s``, in the one form that each number has."""
        order, total = list(self.monomials), dict[int, Any]()
        if not isinstance(value, str) or len(value) > base.MAX_DIGITS:
            raise base.NoCertificateError(place, f"{base.shown(value)} is no text of a number")
        first, *others = value.split(" ")
        signs = ["-" if first.startswith("-") else "+", *others[::2]]
        terms, last = [first.removeprefix("-"), *others[1::2]], -1
        if value == "0":
            return total
        for sign, term in zip(signs, terms, strict=len(signs) == len(terms)):
            coefficient, name = self._term(term, place)
            here = order.index(name) if name in self.monomials else -1
            if sign not in ("+", "-") or here <= last or len(signs) != len(terms):
                raise base.NoCertificateError(
                    place, f"{base.shown(value)} is no number of the field"
                )
            last = here
            for k, c in self.monomials[name].items():
                total[k] = total.get(k, 0) + (c if sign == "+" else -c) * coefficient
        return total

    def _term(self, term: str, place: str) -> tuple[Fraction, str]:
        """Return the coefficient and the monomial of a term without a sign."""
        if not term[:1].isdecimal():
            return Fraction(1), term or "?"
        digits, star, name = term.partition("*")
        coefficient = base.rational(digits, place)
        if coefficient == 0 or (star and (coefficient == 1 or not name)):
            raise base.NoCertificateError(place, f"{base.shown(term)} has a simpler form")
        return coefficient, name

    def whole(self, points: list[tuple[Vector, Vector]]) -> list[base.Corner]:
        """Return the points with their numbers, scaled to sums with whole coefficients."""
        vectors = [vector for point in points for vector in point]
        scale = math.lcm(*(Fraction(c).denominator for v in vectors for c in v.values()))
        rows = [leaf(self.field, {k: int(c * scale) for k, c in v.items() if c}) for v in vectors]
        return [(k, *pair) for k, pair in enumerate(zip(rows[::2], rows[1::2], strict=True))]

    def angle(self, action: Any, place: str) -> base.Angle:
        """Read a nominal angle, the member of an action that the place ends with."""
        found = self.nominal[place] = self.read_angle(base.read(action, place, dict), place)
        return found

    def read_angle(self, claimed: Any, place: str) -> base.Angle:
        """Read an angle: whole turns, or a rational number of them as text, and a direction."""
        if not isinstance(claimed, dict) or claimed.keys() != {"turns", "direction"}:
            raise base.NoCertificateError(place, f"{base.shown(claimed)} is no angle")
        direction, turns = claimed["direction"], claimed["turns"]
        pair = base.read_point(direction, f"{place}.direction", self.read)
        [(_, x, y)] = self.whole([pair])
        if x == 0 and y == 0:
            raise base.NoCertificateError(f"{place}.direction", "is zero")
        if type(turns) is int:
            return turns, x, y
        part = base.rational(turns, f"{place}.turns")
        if part.denominator == 1:
            raise base.NoCertificateError(f"{place}.turns", "whole turns are no text")
        return base.add(self.turned(part), (0, x, y))

    def turned(self, turns: Fraction) -> base.Angle:
        """Return a rational number of turns: over L if it is a multiple of 1/(2 w)."""
        whole, rest = divmod(turns, 1)
        w, k = cosines(self.w), rest * self.w
        if (2 * k).denominator > 1:
            w = cosines(math.lcm(4, turns.denominator))
            k = rest * w.w
        # Between two roots of unity, their sum.
        ends = {math.floor(k), math.ceil(k)}
        x, y = (sum(leaf(w, w.cosine(j - shift)) for j in ends) for shift in (0, w.w // 4))
        return whole, x, y

    def written(self, true: base.Angle, claimed: Any, place: str) -> Any:
        """Return what is claimed if it is this angle, and raise if it is not."""
        if true is self.nominal.get(place):  # it was read here
            return claimed
        found = self.read_angle(claimed, place)
        if base.compare(found, true):
            near, right = (f"{45 * in_eighths(a, 64) / 2**64:.9g}" for a in (found, true))
            claim = "another angle as near" if near == right else f"about {near} degrees"
            holds = f"about {right}" + (" degrees" if near == right else "")
            raise base.InvalidClaimError(place, f"claimed {claim}, but {holds} holds")
        return claimed

    def cost_sign(self, p: Fraction, a: base.Angle, q: Fraction, b: base.Angle) -> int:
        """Return the sign of p / a - q / b, that is of n b - m a, as for rational parts."""
        n, m = (p / q).as_integer_ratio()
        units = self.units(a), self.units(b)
        if None not in units:
            left, right = n * units[1], m * units[0]  # type: ignore[operator]
            return (left > right) - (left < right)
        bits = 64
        while abs(difference := n * in_eighths(b, bits) - m * in_eighths(a, bits)) <= 4 * (n + m):
            # A multiple of an angle is a rational number of turns where the angle is.
            if bits == 64 and units == (None, None) and tied(n, a, m, b):
                return 0
            bits *= 2
        return 1 if difference > 0 else -1

    def units(self, a: base.Angle) -> int | None:
        """Return an angle as a number of 1/(2 w) turns, None if it is no whole number of them.

        None then means that it is no rational number of turns.
        """
        n = 2 * self.w
        near = (in_eighths(a, 64) * n + (1 << 66)) >> 67
        return near if base.compare(a, self.turned(Fraction(near, n))) == 0 else None


def is_squarefree(n: int) -> bool:
    """Tell whether no square divides n."""
    return all(n % (k * k) for k in range(2, math.isqrt(n) + 1))


def tied(n: int, a: base.Angle, m: int, b: base.Angle) -> bool:
    """Tell whether n b = m a, for n, m > 0 without common factor and irrational turns a, b over L.

    If so, a = n g and b = m g for an angle g over L. z / conj(z) for g lies in L(i), an abelian
    field, and is no root of unity: by Amoroso and Dvornicich (J. Number Theory 80, 2000) its height
    is log 5 / 12 or more, that for a n times as large, and at most the logarithm of what bounds the
    conjugates of x + i y. So a long multiple is none, and short ones are compared.
    """
    for k, (_, x, y) in ((n, a), (m, b)):
        # 12 log 2 / log 5 is below 26/5.
        if 5 * k > 26 * (max(x.size, y.size) + 1):
            return False
    return base.compare(multiple(n, b), multiple(m, a)) == 0


def multiple(n: int, a: base.Angle) -> base.Angle:
    """Return n a for n > 0."""
    if n == 1:
        return a
    half = multiple(n // 2, a)
    twice = base.add(half, half)
    return base.add(twice, a) if n % 2 else twice


def in_eighths(a: base.Angle, bits: int) -> int:
    """Return a / 45 degrees times 2**bits, off by less than 4."""
    if type(a[1]) is int:
        return base.in_eighths(a, bits)
    one, whole = 1 << (bits + 64), base.floor_eighths(a)
    _, x, y = base.add(a, base.eighths(-whole))
    digits = bits
    while True:
        digits *= 2
        (run, slip), (rise, slide) = x.enclose(digits), y.enclose(digits)
        # 0 <= y < x; the slope is to be right to 2**-(bits + 30).
        if run >> (bits + 32) > slip + slide:
            slope = min(max(rise * one // run, 0), one)
            eighth = base.arctan(slope, one) * one // base.eighth_turn(one)
            return (whole << bits) + (eighth >> 64)


# --- documents ------------------------------------------------------------------------------------


def load(data: bytes) -> Any:
    """Parse the bytes of a certificate file, of a part over a field or a rational one."""
    return base.load(data, (base.SCHEMA, SCHEMA))


def check(document: Any) -> None:
    """Raise `InvalidClaimError` with the first claim that fails."""
    if document.get("schema") == base.SCHEMA:
        return base.check(document)
    reader = Reader(base.read(document, "part", dict).get("field"))
    numbers = base.Numbers(
        schema=SCHEMA,
        field={"field": reader.description},
        read=reader.read,
        whole=reader.whole,
        angle=reader.angle,
        written=reader.written,
        cost_sign=reader.cost_sign,
    )
    return base.check(document, numbers)


if __name__ == "__main__":
    sys.exit(base.main(sys.argv[1:], load, check))
