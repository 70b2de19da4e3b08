"""Options that several commands share."""

from __future__ import annotations

import argparse
import re

from stochgeom.errors import InputError
from stochgeom.exact.decimals import MAX_DIGITS


def add_digits(parser: argparse.ArgumentParser) -> None:
    """Add ``--digits``; `read_digits` reads its text."""
    parser.add_argument(
        "--digits", default="4", metavar="N", help="decimals after the point; default 4"
    )


def read_digits(text: str) -> int:
    """Return the number of decimals that the text of ``--digits`` asks for.

    Raises
    ------
    InputError
        If it is no whole number, negative or absurd.

    Examples
    --------
    >>> read_digits("12")
    12
    """
    # The length is judged first: Python refuses to read integers of thousands of digits.
    if re.fullmatch(r"[0-9]{1,9}", text) is None or int(text) > MAX_DIGITS:
        raise InputError(
            f"{text[:60]!r} decimals; accepted: whole numbers from 0 to {MAX_DIGITS}",
            where="--digits",
        )
    return int(text)
