"""Exact scalars that need not be rational: numbers of a field as they are, text with square roots.

Text is an expression of rational numbers, ``sqrt(...)`` of a rational number, ``+ - * / ^`` and
parentheses, such as ``"1/2*sqrt(3)"`` or ``"(1 + sqrt(5))/2"``. All its roots have to lie in one
field Q(sqrt d): ``"sqrt(12) - sqrt(3)"`` is sqrt 3, ``"sqrt(2) + sqrt(3)"`` is refused.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, Final, TypeAlias

import gmpy2
from gmpy2 import mpq, mpz

from stochgeom.errors import MixedFieldsError, NumberError, NumberLimitError
from stochgeom.exact.algebraic import Algebraic, is_algebraic, simplified
from stochgeom.exact.balls import START_BITS, exact_value, working_precision
from stochgeom.exact.fields import MAX_RADICAND, RealField, quadratic_field, squarefree_part
from stochgeom.exact.scalars import (
    MAX_TEXT_LENGTH,
    RationalLike,
    parse_rational,
    rational,
    rational_text,
)

if TYPE_CHECKING:
    import sympy

Scalar: TypeAlias = "mpq | Algebraic"
"""An exact real number."""

ScalarLike: TypeAlias = "RationalLike | Algebraic"
"""Anything `exact_scalar` takes."""

MAX_DEPTH: Final = 100
"""Deepest nesting of parentheses."""

MAX_POWER: Final = 1000
"""Largest exponent."""

_TOKEN = re.compile(r"\s*(?:[a-z]+|(?:[0-9]+\.?[0-9]*|\.[0-9]+)(?:[eE][+-]?[0-9]+)?|[-+*/^()])")
_LETTERS = re.compile(r"[a-df-z]")  # an e may be that of 1e-3
_FORM: Final = "accepted: rational numbers and square roots of them, such as 1/2*sqrt(3)"


def exact_scalar(
    value: ScalarLike,
    *,
    where: str | None = None,
    symbols: Mapping[str, Algebraic] | None = None,
) -> Scalar:
    """Return the exact number that `value` stands for.

    Parameters
    ----------
    value : anything `stochgeom.exact.scalars.rational` takes, Algebraic, or text with square roots
        ``"1/2*sqrt(3)"``.
    where : str, optional
        The place named in an error.
    symbols : mapping, optional
        What letters in the text stand for: `field_symbols` of a field.

    Raises
    ------
    NumberError
        For text that is no such expression, a negative radicand, a division by zero, and whatever
        `rational` refuses.
    MixedFieldsError
        If the square roots do not lie in one quadratic field.
    NumberLimitError
        For radicands whose numerator times denominator is above `MAX_RADICAND`.

    Examples
    --------
    >>> exact_scalar("1/2*sqrt(12)"), exact_scalar("sqrt(9/4)")
    (Algebraic(quadratic_field(3), ['0', '1']), mpq(3,2))
    """
    if is_algebraic(value):
        return simplified(value)
    if isinstance(value, str) and ("sqrt" in value or (symbols and _LETTERS.search(value))):
        try:
            return simplified(_Parser(value, symbols or {}).number())
        except MixedFieldsError as error:
            raise MixedFieldsError(f"{value[:60]!r}: {error.message}", where=where) from None
        except NumberLimitError as error:
            raise NumberLimitError(f"{value[:60]!r}: {error.message}", where=where) from None
        except (NumberError, ZeroDivisionError) as error:
            reason = error.message if isinstance(error, NumberError) else f"divides by 0; {_FORM}"
            raise NumberError(f"{value[:60]!r}: {reason}", where=where) from None
    return rational(value, where=where)


def common_field(values: Sequence[Scalar], name: Callable[[int], str]) -> RealField | None:
    """Return the field of all irrational numbers among `values`, None if all are rational.

    Raises
    ------
    MixedFieldsError
        Naming, by `name`, the first number of another field than the first irrational one.
    """
    field, first = None, 0
    for k, value in enumerate(values):
        if not is_algebraic(value):
            continue
        if field is None:
            field, first = value.field, k
        elif value.field is not field:
            raise MixedFieldsError(
                f"{value!s:.40} is in {value.field}, {name(first)} in {field}; "
                "accepted: numbers of one field, and rational ones",
                where=name(k),
            )
    return field


class _Parser:
    """Recursive descent: a sum of products of powers of numbers, roots and parentheses."""

    def __init__(self, text: str, symbols: Mapping[str, Algebraic]) -> None:
        if len(text) > MAX_TEXT_LENGTH:
            raise NumberLimitError(f"{len(text)} characters; accepted: at most {MAX_TEXT_LENGTH}")
        self._symbols = symbols
        self._tokens = list(_tokens(text))
        self._place = self._depth = 0

    def number(self) -> Any:
        value = self._sum()
        if self._peek() is not None:
            raise NumberError(f"{self._peek()!r} is not expected there; {_FORM}")
        return value

    def _peek(self) -> str | None:
        return self._tokens[self._place] if self._place < len(self._tokens) else None

    def _take(self, *accepted: str) -> str | None:
        token = self._peek()
        if token not in accepted:
            return None
        self._place += 1
        return token

    def _sum(self) -> Any:
        value = self._product()
        while sign := self._take("+", "-"):
            other = self._product()
            value = value + other if sign == "+" else value - other
        return value

    def _product(self) -> Any:
        value = self._signed()
        while sign := self._take("*", "/"):
            other = self._signed()
            value = value * other if sign == "*" else value / other
        return value

    def _signed(self) -> Any:
        negative = False
        while sign := self._take("+", "-"):
            negative ^= sign == "-"
        value = self._power()
        return -value if negative else value

    def _power(self) -> Any:
        value = self._factor()
        if not self._take("^"):
            return value
        exponent = self._peek() or ""
        if not exponent.isdecimal() or len(exponent) > 4 or int(exponent) > MAX_POWER:
            raise NumberError(f"exponent {exponent!r:.20}; accepted: 0 to {MAX_POWER}")
        self._place += 1
        return value ** int(exponent)

    def _factor(self) -> Any:
        token = self._peek()
        if token == "(":
            return self._group()
        if token is None or token in "+-*/^)":
            raise NumberError(
                f"a number is missing{f' before {token!r}' if token else ''}; {_FORM}"
            )
        self._place += 1
        if token == "sqrt":
            if self._peek() != "(":
                raise NumberError(f"'sqrt' without '('; {_FORM}")
            return square_root(self._group())
        if token in self._symbols:
            return self._symbols[token]
        if token[0].isalpha():
            raise NumberError(f"{token!r:.20} is not known; {_FORM}")
        return parse_rational(token)

    def _group(self) -> Any:
        self._depth += 1
        if self._depth > MAX_DEPTH:
            raise NumberLimitError(f"more than {MAX_DEPTH} parentheses inside one another")
        self._take("(")
        value = self._sum()
        if not self._take(")"):
            raise NumberError(f"')' is missing; {_FORM}")
        self._depth -= 1
        return value


def square_root(radicand: Any) -> Any:
    """Return the square root of a rational number: rational, or a number of Q(sqrt d).

    Raises
    ------
    NumberError
        For a negative or an irrational radicand.
    NumberLimitError
        If numerator times denominator of one that is no square is above `MAX_RADICAND`.

    Examples
    --------
    >>> square_root(mpq(1, 2))
    Algebraic(quadratic_field(2), ['0', '1/2'])
    """
    value = simplified(radicand)
    if is_algebraic(value):
        raise NumberError(f"square root of {value!s:.40}; accepted: of rational numbers")
    value = mpq(value)
    if value < 0:
        raise NumberError(f"square root of {value!s:.40}; accepted: of 0 and positive numbers")
    n = value.numerator * value.denominator
    if gmpy2.is_square(n):
        return mpq(gmpy2.isqrt(n), value.denominator)
    if n > MAX_RADICAND:
        raise NumberLimitError(
            f"square root of {value!s:.40}; accepted: numerator times denominator at most "
            f"{MAX_RADICAND}, or a square"
        )
    k, d = squarefree_part(int(n))
    return Algebraic(quadratic_field(d), [0, mpq(k, value.denominator)])


def _tokens(text: str) -> Iterator[str]:
    place, body = 0, text.rstrip()
    while place < len(body):
        match = _TOKEN.match(body, place)
        if match is None:
            raise NumberError(f"{body[place:].strip()[:20]!r} is not expected; {_FORM}")
        yield match[0].strip()
        place = match.end()


def field_symbols(field: RealField) -> dict[str, Algebraic]:
    """Return what the letters in the text of a number of a field stand for.

    Examples
    --------
    >>> from stochgeom.exact.fields import regular_polygon_field
    >>> str(exact_scalar("1 - s^2", symbols=field_symbols(regular_polygon_field(5))))
    '-2 - g'
    """
    return {"g": Algebraic(field, [0, 1]), "s": Algebraic(field, [0], [1])}


def scalar_text(value: Scalar | mpz | int) -> str:
    """Return ``"p/q"``, or the text of a number of a field, which `exact_scalar` reads back.

    Examples
    --------
    >>> scalar_text(mpq(1, 2)), scalar_text(exact_scalar("sqrt(3)/2"))
    ('1/2', '1/2*sqrt(3)')
    """
    return str(value) if is_algebraic(value) else rational_text(value)


def scalar_to_sympy(value: Scalar) -> sympy.Expr:
    """Return an exact number as a sympy expression."""
    import sympy

    if is_algebraic(value):
        return value.to_sympy()
    return sympy.Rational(int(value.numerator), int(value.denominator))


def scalar_to_float(value: Scalar) -> float:
    """Return an exact number as a float, for plots: correctly rounded if rational.

    Raises
    ------
    OverflowError, NumberLimitError
        Beyond the largest float.
    """
    if is_algebraic(value):
        return float(value)
    return int(value.numerator) / int(value.denominator)


def rational_bounds(value: Scalar, bits: int = START_BITS) -> tuple[mpq, mpq]:
    """Return rational numbers not above and not below an exact number, about 2**-bits of it apart.

    Examples
    --------
    >>> low, high = rational_bounds(exact_scalar("sqrt(2)"), 8)
    >>> low * low < 2 < high * high
    True
    """
    if not is_algebraic(value):
        return value, value
    precision = bits + value.field.bits
    with working_precision(precision):
        ball = value.ball()
        return exact_value(ball.lower()), exact_value(ball.upper())
