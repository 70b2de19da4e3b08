"""The estimator on worked cases, the errors of alpha."""

from __future__ import annotations

from fractions import Fraction

import numpy as np
import pytest
from gmpy2 import mpq

from stochgeom.errors import FloatRefusedError, PriorError, RecordingError
from stochgeom.tilting.counts import OTHER, TransitionCounts
from stochgeom.tilting.estimation import ALPHA, TransitionModel

SEEN = TransitionCounts([[[3, 1, 0], [0, 0, 0]], [[0, 0, 0], [0, 0, 0]]])
"""Two tilts, the second one never tried; two states; the third column is another outcome."""


def test_the_mean_of_equation_6_13():
    model = TransitionModel(SEEN, "1/100")
    assert model.row(1, 1) == (mpq(301, 403), mpq(101, 403), mpq(1, 403))
    assert model.row(1, 2) == (mpq(1, 3),) * 3
    assert model.probability(1, 1, OTHER) == mpq(1, 403)
    assert TransitionModel(SEEN).alpha == model.alpha
    assert mpq(1, 100) == ALPHA


def test_the_variance_of_equation_6_11():
    model = TransitionModel(SEEN, 1)
    a, whole = mpq(4), mpq(7)
    assert model.variance(1, 1, 1) == a * (whole - a) / (whole**2 * (whole + 1))
    assert model.covariance(1, 1, 1, 2) == -a * 2 / (whole**2 * (whole + 1))
    assert model.covariance(1, 1, 1, 1) == model.variance(1, 1, 1)


def test_the_variance_may_grow():
    """After one success Beta(1, 9) has more than twice its variance: .0082 becomes .0124."""
    prior = [[1, 9]]
    before = TransitionModel(TransitionCounts([[[0, 0]]]), prior).variance(1, 1, 1)
    after = TransitionModel(TransitionCounts([[[1, 0]]]), prior).variance(1, 1, 1)
    assert (before, after) == (mpq(9, 1100), mpq(3, 242))


def test_the_variance_falls_in_expectation():
    """E(Var after a trial) = Var x alpha_0 / (alpha_0 + 1), whatever the prior."""
    for a, b in ((1, 9), (Fraction(1, 100), 1), (3, 2)):
        model = TransitionModel(TransitionCounts([[[0, 0]]]), [[a, b]])
        mean = model.row(1, 1)
        after = [
            TransitionModel(TransitionCounts([[seen]]), [[a, b]]).variance(1, 1, 1)
            for seen in ([1, 0], [0, 1])
        ]
        expected = sum(m * v for m, v in zip(mean, after, strict=True))
        whole = mpq(a) + mpq(b)
        assert expected == model.variance(1, 1, 1) * whole / (whole + 1)


def test_frequencies_are_undefined_without_observations():
    model = TransitionModel(SEEN)
    assert model.maximum_likelihood(1, 1) == (mpq(3, 4), mpq(1, 4), 0)
    assert model.maximum_likelihood(1, 2) is None
    assert model.undefined_rows == ((1, 2), (2, 1), (2, 2))
    assert model.unobserved_actions == (2,)


def test_alpha_is_one_number_a_row_or_a_table():
    one = TransitionModel(SEEN, 2)
    assert one == TransitionModel(SEEN, [2, 2, 2])
    assert one == TransitionModel(SEEN, [["2", 2, Fraction(2)], [2, 2, 2]])
    assert hash(one) == hash(one.with_alpha(2))
    assert one != one.with_alpha(3)
    assert repr(one) == "<TransitionModel: 4 trials, alpha 2>"
    assert repr(TransitionModel(SEEN, [1, 2, 3])) == "<TransitionModel: 4 trials, alpha a table>"


@pytest.mark.parametrize(
    ("alpha", "error", "message"),
    [
        (0, PriorError, "alpha: 0; accepted: numbers above 0"),
        ("-1/2", PriorError, "alpha: -1/2; accepted: numbers above 0"),
        ([1, 0, 1], PriorError, "alpha: 0; accepted"),
        ([1, 1], PriorError, "alpha: a table of alphas with 2 rows; accepted: one number, 3"),
        ([[1, 1, 1]], PriorError, "alpha: a table of alphas with 1 rows"),
        ([[1, 1, 1], [1, 1]], PriorError, "alpha: a table of alphas with 2 rows"),
        (0.01, FloatRefusedError, "alpha: 0.01 is a binary float"),
    ],
)
def test_a_bad_alpha_is_refused(alpha, error, message):
    with pytest.raises(error) as caught:
        TransitionModel(SEEN, alpha)
    assert str(caught.value).startswith(message)


@pytest.mark.parametrize(
    "ask",
    [
        lambda model: model.row(3, 1),
        lambda model: model.row(1, 3),
        lambda model: model.probability(1, 1, 3),
        lambda model: model.marginal(1, 1, "elsewhere"),
    ],
)
def test_what_does_not_exist_is_refused(ask):
    with pytest.raises(RecordingError, match="accepted: 1 to 2"):
        ask(TransitionModel(SEEN))


def test_matrices_keep_what_ended_elsewhere():
    matrices = TransitionModel(SEEN, 1).matrices
    assert matrices.shape == (2, 3, 3)
    assert matrices[0, 0].tolist() == [4 / 7, 2 / 7, 1 / 7]
    assert matrices[:, 2].tolist() == [[0, 0, 1]] * 2
    assert not matrices.flags.writeable


def test_the_evidence_prefers_the_alpha_that_made_the_data():
    """Sure rows are better told by a small alpha, spread ones by a large one."""
    sure = TransitionCounts([[[20, 0, 0], [0, 20, 0]]])
    spread = TransitionCounts([[[7, 7, 6], [6, 7, 7]]])
    assert TransitionModel(sure).log_evidence() > TransitionModel(sure, 5).log_evidence()
    assert TransitionModel(spread).log_evidence() < TransitionModel(spread, 5).log_evidence()
    assert np.isfinite(TransitionModel(SEEN).log_evidence())
