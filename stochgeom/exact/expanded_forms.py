"""Whether a rational combination of arguments over a real field is a rational number of turns.

With n the common denominator of the coefficients q_k, sum n q_k arg(z_k) is, up to whole turns, the
argument of the product of the z_k^(n q_k), with conj z_k for negative powers. The product lies over
the same field, so it is a rational number of turns iff it is along one of the multiples of 1/N turn
(see `stochgeom.exact.algebraic_directions`); an enclosure tells the whole turns.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any, Final

from gmpy2 import mpq

from stochgeom.errors import NumberLimitError
from stochgeom.exact.angles import Angle, make_angle
from stochgeom.exact.scalars import common_denominator

MAX_EXPANDED_BITS: Final = 1_000_000
"""A product of directions is refused when its coefficients would need more bits than this."""


def rational_turns_over_field(directions: Mapping[tuple[Any, Any], mpq]) -> mpq | None:
    """Return sum of q arg(x + i y) in turns if it is rational, else None.

    Parameters
    ----------
    directions : mapping of (x, y) to q
        Directions over one real field, or over Q, and their coefficients.

    Raises
    ------
    NumberLimitError
        If the product of the directions is too large.
    MixedFieldsError
        If there are two fields.

    Examples
    --------
    >>> from stochgeom.exact.surds import exact_scalar
    >>> root = exact_scalar("sqrt(2)")
    >>> rational_turns_over_field({(root, 1): mpq(1), (root - 1, root + 1): mpq(-1)})
    mpq(-1,8)
    """
    denominator = common_denominator(list(directions.values()))
    powers = {z: int((q * denominator).numerator) for z, q in directions.items()}
    size = sum(abs(n) * (max(x.bit_length(), y.bit_length()) + 2) for (x, y), n in powers.items())
    if size > MAX_EXPANDED_BITS:
        raise NumberLimitError(
            f"a sum of angles over a field that expands to {size} bits; accepted: at most "
            f"{MAX_EXPANDED_BITS}"
        )
    # Angles add by multiplying their directions; whole turns are kept on the way.
    total = Angle()
    for (x, y), n in powers.items():
        total += make_angle(0, x, y) * n
    turns = total.rational_turns
    return None if turns is None else turns / denominator
