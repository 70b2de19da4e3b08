"""Estimating the prior from what the filter rejects (thesis 4.9.1).

The orientation in which a part arrives is not seen. Seen is only whether a plan succeeded: an
accepted part began inside the plan's mouth S, a rejected one outside of it. Plans with different
mouths, or one plan at different first angles, tell more. With p_c the unknown probability of cell
c, and a_i accepted and r_i rejected parts for mouth S_i, the likelihood is

    L(p) = product over i of  P(S_i)^a_i (1 - P(S_i))^r_i,   P(S) = sum of p_c over the cells in S.

These are censored counts of a multinomial. Two estimates are offered:

- `maximum_likelihood`, by expectation and maximisation: every censored part is shared out among
  the cells it may have been in, in proportion to p, and p is replaced by the shares. Likelihoods
  never fall. log L is concave with gradient g_c, so no p exceeds it by more than max g_c - N, N
  the number of parts: that gap is the criterion of convergence, and is reported.
- `posterior_mean`, under a Dirichlet prior: exact where the sets seen do not overlap, as they do
  not for a single mouth, else by Gibbs sampling with a given seed, with its standard error.

Examples
--------
Parts arrive at 0, 90 or 180 degrees. A mouth over the first two accepts 60 of 100 parts, a mouth
over the last two 80 of 100:

>>> from stochgeom.exact.angles import Angle
>>> cells = [Angle.from_degrees(degrees) for degrees in (0, 90, 180)]
>>> wide = Angle.from_degrees(100)
>>> seen = Rejections(cells, [Observation(Arc(cells[0], wide), 60, 40),
...                           Observation(Arc(cells[1], wide), 80, 20)])
>>> estimate = seen.maximum_likelihood()
>>> [str(weight) for weight in estimate.weights], seen.is_identifiable
(['1/5', '2/5', '2/5'], True)
>>> estimate.to_prior().best_window(Angle.from_degrees(60)).start.degrees(0)
'90'

One mouth alone says nothing of how its cells share their probability; the Dirichlet prior does:

>>> seen = Rejections(cells, [Observation(Arc(cells[0], wide), 60, 40)])
>>> seen.is_identifiable, [str(weight) for weight in seen.posterior_mean().weights]
(False, ['31/103', '31/103', '41/103'])
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from typing import Any, Final, final

import numpy as np
from gmpy2 import mpq
from numpy.typing import NDArray

from stochgeom.arguments import as_count, as_list, expect
from stochgeom.decision.prior_estimates import PriorEstimate, round_to_sum_one
from stochgeom.decision.priors import as_share
from stochgeom.errors import InputError, PriorError
from stochgeom.exact.angles import FULL_TURN, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.scalars import RationalLike

_BATCHES: Final = 20


@final
@dataclass(frozen=True)
class Observation:
    """How many parts a plan with its mouth in place accepted and rejected.

    Attributes
    ----------
    mouth : Arc
        The initial orientations for which the plan succeeds.
    accepted, rejected : int
        Counts, 0 or more.
    """

    mouth: Arc
    accepted: int
    rejected: int

    def __post_init__(self) -> None:
        for name in ("accepted", "rejected"):
            count = as_count(getattr(self, name), "parts", least=0, error=PriorError, where=name)
            object.__setattr__(self, name, count)


@final
@dataclass(frozen=True)
class Rejections:
    """The censored counts of several mouths over a finite set of cells.

    Parameters
    ----------
    cells : sequence of Angle, or sequence of Arc
        Where parts may arrive: single orientations, or arcs that lie inside or outside each mouth,
        such as `stochgeom.decision.prior_estimates.cells_between` gives.
    observations : sequence of Observation
        What was counted.

    Raises
    ------
    PriorError
        If there are no cells, a mouth cuts one, or parts were accepted by a mouth without cells,
        or rejected by one with all of them.
    """

    cells: Sequence[Angle | Arc]
    observations: Iterable[Observation]
    _sets: dict[frozenset[int], int] = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        cells = tuple(as_list(self.cells, "a list of angles, or of arcs", "cells", PriorError))
        seen = tuple(
            as_list(self.observations, "a list of observations", "observations", PriorError)
        )
        for k, each in enumerate(seen):
            expect(each, Observation, "Observation(mouth, accepted, rejected)", f"observation {k}")
        if not cells or len({_is_angle(cell) for cell in cells}) != 1:
            raise PriorError(f"{len(cells)} cells; accepted: one or more, all angles or all arcs")
        sets: dict[frozenset[int], int] = {}
        for k, observation in enumerate(seen):
            inside = _cells_inside(cells, observation.mouth, k)
            outside = frozenset(range(len(cells))) - inside
            for which, count, what in (
                (inside, observation.accepted, "accepted by a mouth without cells"),
                (outside, observation.rejected, "rejected by a mouth with all cells"),
            ):
                if count and not which:
                    raise PriorError(f"{count} parts {what}", where=f"observation {k}")
                if count:
                    sets[which] = sets.get(which, 0) + count
        object.__setattr__(self, "cells", cells)
        object.__setattr__(self, "observations", seen)
        object.__setattr__(self, "_sets", sets)

    @property
    def total(self) -> int:
        """The number of parts counted."""
        return sum(self._sets.values())

    @cached_property
    def is_identifiable(self) -> bool:
        """Whether enough data of this kind would determine every weight: an exact rank."""
        m = len(self.cells)
        rows = [[mpq(c in which) for c in range(m)] for which in self._sets]
        return _rank([*rows, [mpq(1)] * m]) == m

    def log_likelihood(self, weights: Sequence[Any]) -> float:
        """Return log L, in floats; minus infinity if the weights make the data impossible."""
        total = 0.0
        for which, count in self._sets.items():
            share = float(sum(weights[c] for c in which))
            total += count * float(np.log(share)) if share > 0 else -np.inf
        return total

    # --- maximum likelihood ----------------------------------------------------------------------

    def maximum_likelihood(
        self,
        start: Sequence[RationalLike] | None = None,
        *,
        gap: float = 1e-9,
        most_iterations: int = 100_000,
    ) -> PriorEstimate:
        """Return weights of largest likelihood, in floats.

        Parameters
        ----------
        start : sequence of rational, optional
            Where to begin, all positive; equal weights if not given. Cells that no mouth tells
            apart keep the proportions they have there.
        gap : float
            Stop when log L cannot grow by more.
        most_iterations : int
            Stop in any case; the gap then reached is in the result.

        Raises
        ------
        PriorError
            If no parts were counted, or a start is not positive.
        """
        if not self._sets:
            raise PriorError("no parts were counted; accepted: observations of one part or more")
        incidence, counts = self._incidence()
        weights = self._start(start)
        total = counts.sum()
        rounds, missing = 0, np.inf
        while rounds < most_iterations:
            # The gradient of log L; shares of the censored parts are gradient times weights.
            gradient = incidence.T @ (counts / (incidence @ weights))
            missing = float(gradient.max() - total)
            if missing <= gap:
                break
            weights = weights * gradient
            weights /= weights.sum()
            rounds += 1
        return PriorEstimate(
            tuple(self.cells),
            round_to_sum_one(weights),
            "maximum likelihood (EM, floats)",
            exact=False,
            gap=max(missing, 0.0),
            iterations=rounds,
        )

    def _incidence(self) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        rows = [[float(c in which) for c in range(len(self.cells))] for which in self._sets]
        return np.array(rows), np.array(list(self._sets.values()), dtype=np.float64)

    def _start(self, start: Sequence[RationalLike] | None) -> NDArray[np.float64]:
        weights = self._alphas(start, "start")
        numbers = np.array([float(weight) for weight in weights])
        shares: NDArray[np.float64] = numbers / numbers.sum()
        return shares

    def _alphas(self, values: Sequence[RationalLike] | None, what: str) -> list[mpq]:
        m = len(self.cells)
        numbers = [as_share(v, where=f"{what} {k}", what=what) for k, v in enumerate(values or ())]
        if (values is not None and len(numbers) != m) or 0 in numbers:
            raise PriorError(f"{len(numbers)} values of {what}; accepted: {m}, all positive")
        return numbers or [mpq(1)] * m

    # --- Dirichlet -------------------------------------------------------------------------------

    def posterior_mean(
        self,
        alphas: Sequence[RationalLike] | None = None,
        *,
        seed: int = 0,
        sweeps: int = 4000,
        burn_in: int = 500,
    ) -> PriorEstimate:
        """Return the mean of the posterior under a Dirichlet prior.

        Parameters
        ----------
        alphas : sequence of rational, optional
            Its parameters, positive; all 1 if not given.
        seed, sweeps, burn_in : int
            For Gibbs sampling, where the sets seen overlap.

        Notes
        -----
        Sums of Dirichlet variables over disjoint sets are Dirichlet again, and independent of the
        proportions inside each set: so with n_U parts known to be in U, and alpha_U and alpha_0
        the sums of the parameters over U and over all cells, the mean of p_c for c in U is
        (alpha_c / alpha_U) (alpha_U + n_U) / (alpha_0 + N).
        """
        parameters = self._alphas(alphas, "alpha")
        sets = [(which, n) for which, n in self._sets.items() if len(which) < len(self.cells)]
        if sum(len(which) for which, _ in sets) == len(frozenset().union(*(u for u, _ in sets))):
            return self._exact_mean(parameters, sets)
        return self._sampled_mean(parameters, sets, seed, sweeps, burn_in)

    def _exact_mean(
        self, alphas: list[mpq], sets: list[tuple[frozenset[int], int]]
    ) -> PriorEstimate:
        whole = sum(alphas) + sum(count for _, count in sets)
        factors = [mpq(1)] * len(alphas)
        for which, count in sets:
            inside = sum(alphas[c] for c in which)
            for c in which:
                factors[c] = (inside + count) / inside
        weights = tuple(a * factor / whole for a, factor in zip(alphas, factors, strict=True))
        return PriorEstimate(tuple(self.cells), weights, "Dirichlet posterior mean", exact=True)

    def _sampled_mean(
        self,
        alphas: list[mpq],
        sets: list[tuple[frozenset[int], int]],
        seed: int,
        sweeps: int,
        burn_in: int,
    ) -> PriorEstimate:
        if sweeps < _BATCHES or burn_in < 0:
            raise InputError(f"{sweeps} sweeps; accepted: {_BATCHES} or more, burn_in 0 or more")
        random = np.random.default_rng(seed)
        base = np.array([float(alpha) for alpha in alphas])
        members = [(np.array(sorted(which)), count) for which, count in sets]
        weights = base / base.sum()
        means = np.empty((sweeps, len(base)))
        for sweep in range(-burn_in, sweeps):
            counted = base.copy()
            for cells, count in members:
                shares = weights[cells]
                counted[cells] += random.multinomial(count, shares / shares.sum())
            # The mean given the shared-out parts varies less than the sample drawn from it.
            if sweep >= 0:
                means[sweep] = counted / counted.sum()
            # Tiny parameters draw zeros by underflow, and a set of zeros could not be shared out.
            weights = np.maximum(random.dirichlet(counted), 1e-300)
        batches = np.array([batch.mean(axis=0) for batch in np.array_split(means, _BATCHES)])
        errors = batches.std(axis=0, ddof=1) / np.sqrt(_BATCHES)
        return PriorEstimate(
            tuple(self.cells),
            round_to_sum_one(means.mean(axis=0)),
            f"Dirichlet posterior mean (Gibbs sampling, seed {seed})",
            exact=False,
            standard_errors=tuple(float(e) for e in errors),
            iterations=sweeps,
        )


# --- helpers -------------------------------------------------------------------------------------


def _is_angle(cell: Angle | Arc) -> bool:
    return isinstance(cell, Angle)


def _cells_inside(cells: tuple[Angle | Arc, ...], mouth: Arc, k: int) -> frozenset[int]:
    if mouth.width == FULL_TURN:
        return frozenset(range(len(cells)))
    inside = set()
    for c, cell in enumerate(cells):
        if isinstance(cell, Angle):
            if mouth.contains(cell):
                inside.add(c)
        elif mouth.contains(cell.start) and (cell.start - mouth.start).reduced() + cell.width <= (
            mouth.width
        ):
            inside.add(c)
        elif mouth.intersects(cell):
            raise PriorError(
                f"the mouth cuts cell {c}; accepted: cells inside or outside each mouth",
                where=f"observation {k}",
            )
    return frozenset(inside)


def _rank(rows: list[list[mpq]]) -> int:
    """Return the rank of a rational matrix, by elimination."""
    rank = 0
    for column in range(len(rows[0])):
        pivot = next((r for r in range(rank, len(rows)) if rows[r][column]), None)
        if pivot is None:
            continue
        rows[rank], rows[pivot] = rows[pivot], rows[rank]
        for r in range(rank + 1, len(rows)):
            factor = rows[r][column] / rows[rank][column]
            if factor:
                rows[r] = [a - factor * b for a, b in zip(rows[r], rows[rank], strict=True)]
        rank += 1
    return rank
