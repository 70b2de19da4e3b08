"""`entropy` and `information`: worked values, and what is no distribution."""

from __future__ import annotations

import pytest

from stochgeom.decision.entropy import entropy, information
from stochgeom.errors import MixedNumbersError, NotStochasticError, NumberError


def test_worked_values():
    assert entropy(["1/2", "0.25", 0, "1/4"]).rational == 1.5
    assert entropy([1]).rational == 0
    assert entropy([0.5, 0.5]) == 1.0
    assert information(["1/4"] * 4, ["1/2", "1/2", 0, 0]).rational == 1


@pytest.mark.parametrize(
    ("probabilities", "error", "words"),
    [
        (["1/2", "1/3"], NotStochasticError, "the sum is 5/6; accepted: probabilities of sum 1"),
        ([], NotStochasticError, "the sum is 0"),
        ([-1, 2], NotStochasticError, "entry 0: probability -1 is negative"),
        (["x", 1], NumberError, "entry 0: 'x' is not a number"),
        ([0.5, "1/2"], MixedNumbersError, "entry 1: '1/2' is exact, and a float stands at"),
        ([float("nan"), 1.0], NumberError, "entry 0"),
    ],
)
def test_what_is_no_distribution(probabilities, error, words):
    with pytest.raises(error, match=words):
        entropy(probabilities)
