"""Exact predicates, each by itself: determinants, angles, linear forms, decimals.

Time for one sign or one angle, on coordinates of 20 and 40 bits. Expected: constant for numbers of
fixed size. Arrays of int64 decide a determinant in some ten nanoseconds, Python objects of gmpy2 in
a fraction of a microsecond, fractions in microseconds; forms and decimals ask Arb, which takes
microseconds for each term.
"""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from itertools import pairwise

import numpy as np
from gmpy2 import mpz

from benchmarks.harness import measure_small
from benchmarks.report import Report
from stochgeom import Angle, rational, sign_of_form
from stochgeom.exact.predicates import as_objects, cross_sign, cross_signs

BITS = 40
Action = Callable[[], object]


def run(*, quick: bool = False) -> Report:
    report = Report("predicates", "time for one sign, one sum, one decimal")
    rounds, count = (2, 200) if quick else (21, 1_000)
    for title, actions, items in (
        ("sign of a 2x2 determinant, entries below 2^40, for one", _determinants(count), count),
        (
            "the same on arrays, for one of 100000",
            _determinant_arrays(1_000 if quick else 100_000),
            1_000 if quick else 100_000,
        ),
        ("angles of 20-bit directions, for one", _angle_arithmetic(count), count - 1),
        ("sign of a form, for one", _forms(), 1),
        ("correctly rounded decimals, for one", _decimals(count), count),
    ):
        report.section(title)
        for label, samples in measure_small(actions, rounds).items():
            report.time(label, samples.per(items))
    return report


def _determinants(count: int) -> dict[str, Action]:
    rows = np.random.default_rng(1).integers(-(2**BITS), 2**BITS, (count, 4)).tolist()
    as_mpz = [tuple(map(mpz, row)) for row in rows]
    as_fractions = [tuple(map(Fraction, row)) for row in rows]
    return {
        "mpz": lambda: [cross_sign(*row) for row in as_mpz],
        "int": lambda: [cross_sign(*row) for row in rows],
        "Fraction": lambda: [cross_sign(*row) for row in as_fractions],
    }


def _determinant_arrays(count: int) -> dict[str, Action]:
    columns = np.random.default_rng(2).integers(-(2**BITS), 2**BITS, (4, count))
    ties = np.concatenate((columns[:2], columns[:2]))
    objects = [as_objects(column) for column in columns]
    return {
        "int64": lambda: cross_signs(*columns),
        "int64, all of them zero": lambda: cross_signs(*ties),
        "objects (mpz)": lambda: cross_signs(*objects),
    }


def _angle_arithmetic(count: int) -> dict[str, Action]:
    directions = np.random.default_rng(3).integers(1, 2**20, (count, 2)).tolist()
    angles = [Angle(0, direction) for direction in directions]
    pairs = list(pairwise(angles))
    return {
        "sum": lambda: [a + b for a, b in pairs],
        "difference": lambda: [a - b for a, b in pairs],
        "comparison": lambda: [a < b for a, b in pairs],
        "equality": lambda: [a == b for a, b in pairs],
    }


def _forms() -> dict[str, Action]:
    a, b, c = Angle(0, (3, 2)), Angle(0, (1001, 730)), Angle(0, (2**20 - 3, 2**19 + 1))
    tenth, eighth = rational("1/10"), rational("-1/8")
    total = a + b
    return {
        "two angles, far from zero": lambda: sign_of_form(0, [(3, a), (-2, b)]),
        "three angles and turns, far from zero": lambda: sign_of_form(
            tenth, [(3, a), (-2, b), (1, c)]
        ),
        "two angles, zero up to 10^-30": lambda: sign_of_form(
            0, [(1, a), (-1, Angle(0, (3 * 10**30 + 1, 2 * 10**30)))]
        ),
        "exactly zero: a + b - (a + b)": lambda: sign_of_form(0, [(1, a), (1, b), (-1, total)]),
        "exactly zero: Machin's formula": lambda: sign_of_form(
            eighth, [(4, Angle(0, (5, 1))), (-1, Angle(0, (239, 1)))]
        ),
    }


def _decimals(count: int) -> dict[str, Action]:
    directions = np.random.default_rng(4).integers(1, 2**20, (count, 2)).tolist()
    angles = [Angle(0, direction) for direction in directions]
    return {
        "degrees, 4 decimals": lambda: [angle.degrees(4) for angle in angles],
        "degrees, 50 decimals": lambda: [angle.degrees(50) for angle in angles],
        "radians as float": lambda: [angle.to_float() for angle in angles],
    }
