"""Options that several commands share."""

from __future__ import annotations

import argparse
import re

from stochgeom.errors import InputError
from stochgeom.exact.decimals import MAX_DIGITS


def add_part(parser: argparse.ArgumentParser, what: str) -> None:
    """Add SOURCE, ``--vertices`` and ``--center-of-mass``; `plan_command.read_part` reads them."""
    parser.add_argument("source", nargs="?", metavar="SOURCE", help=what)
    parser.add_argument("--vertices", metavar="LIST", help='the outline itself: "0,0 3,0 3,2"')
    parser.add_argument("--center-of-mass", metavar="X,Y", help="default: uniform centroid")


def add_json(parser: argparse.ArgumentParser, what: str) -> None:
    """Add ``--json``."""
    parser.add_argument("--json", action="store_true", help=what)


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


def read_count(text: str, option: str, least: int = 1) -> int:
    """Return the whole number that an option's text is.

    Raises
    ------
    InputError
        If it is none, below `least` or absurd.

    Examples
    --------
    >>> read_count("2000", "--trials")
    2000
    """
    if re.fullmatch(r"[0-9]{1,15}", text) is None or int(text) < least:
        most = ", of at most 15 digits" if text.isdecimal() and len(text) > 15 else ""
        raise InputError(
            f"{text[:60]!r}; accepted: whole numbers from {least} on{most}", where=option
        )
    return int(text)
