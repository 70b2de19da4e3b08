"""Planning problems: states, a prior, actions, their stochastic matrices, a cost (thesis ch. 2).

The five-tuple of section 2.1. What is known of the state is a *hyperstate*, a probability for each
state; an action with the matrix P makes lambda P of the hyperstate lambda, a row vector (Eq. 2.1):

    P(theta_j | a) = sum over i of P(theta_i) P(theta_j | theta_i, a)              (Eq. 2.2)

A plan is a sequence of actions; it makes lambda P_1 P_2 ... P_k (Eq. 2.4).

Numbers are of one kind (`stochgeom.decision.number_kinds`). Exact hyperstates are tuples and can be
compared and hashed: equal ones are equal. Float hyperstates are numpy arrays.
"""

from __future__ import annotations

from collections.abc import Callable, Collection, Hashable, Iterable, Mapping, Sequence
from functools import cached_property
from itertools import chain
from typing import Any, Final, Protocol, TypeAlias, final

import numpy as np
from gmpy2 import lcm, mpq, mpz
from numpy.typing import NDArray

from stochgeom.arguments import as_list, expect
from stochgeom.decision.distributions import distribution, listed, listed_tables
from stochgeom.decision.labels import Labels, named
from stochgeom.decision.number_kinds import (
    Number,
    NumberKind,
    common_kind,
    numbered,
    read_number,
)
from stochgeom.display import Displayed

Vector: TypeAlias = "tuple[Number, ...] | NDArray[np.float64]"
"""A hyperstate: a tuple of exact numbers, or an array of floats."""

Matrix: TypeAlias = "tuple[tuple[mpq, ...], ...] | NDArray[np.float64]"


class Cost(Protocol):
    """What a problem asks of its cost; `stochgeom.decision.plan_costs.PlanCost` is one."""

    def on(self, problem: PlanningProblem, /) -> Any:
        """Return the cost of the plans of a problem."""

    def describe(self) -> str:
        """Return one line for people."""


@final
class PlanningProblem(Displayed):
    """A finite planning problem under uncertainty of state and control (Eq. 2.1 to 2.3).

    Parameters
    ----------
    states : sequence of labels
        Hashable and different; text where the problem is to be written to a file.
    prior : sequence of numbers, or mapping
        The probability of each state before the first action, of sum 1. A mapping gives the
        probabilities that are not 0.
    actions : sequence of labels
        Hashable and different.
    transitions : mapping, or sequence in the order of the actions
        For each action its stochastic matrix: entry (i, j) is the probability that state i becomes
        state j.
    cost : PlanCost, optional
        What plans are compared by, unless another cost is given to the search.
    name : str, optional
        For people.

    Attributes
    ----------
    states, actions : tuple
        The labels.
    prior : tuple of mpq, tuple of AngleSum, or array of float64
        The hyperstate before the first action.
    numbers : NumberKind
        Rational, angle sums (in the prior; the matrices are rational), or float.

    Raises
    ------
    NotStochasticError
        If the prior or a row of a matrix does not sum to 1 or has a negative entry: the action,
        the row and the sum are named. Sums of floats may be off by
        `stochgeom.decision.distributions.ROW_TOLERANCE`.
    ShapeMismatchError
        If a matrix is not n by n, or the numbers of labels and of probabilities differ.
    MixedNumbersError
        If floats and exact numbers that are not whole stand together.
    EmptyProblemError, DuplicateLabelError, UnknownLabelError
        For labels that are missing, given twice, or not known.

    Examples
    --------
    A coin that lies heads up with probability 2/3 and can be turned over, which fails one time in
    ten:

    >>> coin = PlanningProblem(
    ...     ["heads", "tails"], ["2/3", "1/3"],
    ...     ["turn"], {"turn": [["1/10", "9/10"], ["9/10", "1/10"]]},
    ... )
    >>> coin.after(coin.prior, "turn")
    (mpq(11,30), mpq(19,30))
    """

    def __init__(
        self,
        states: Iterable[Hashable],
        prior: Iterable[Any] | Mapping[Any, Any],
        actions: Iterable[Hashable],
        transitions: Mapping[Any, Any] | Sequence[Any],
        cost: Cost | None = None,
        *,
        name: str | None = None,
    ) -> None:
        self._states = Labels(states, "state")
        self._actions = Labels(actions, "action")
        self.name, self.cost = name, cost
        given = listed(prior, self._states, "prior")
        tables = listed_tables(transitions, self._actions, self._states)
        places = [f"action {named(label)}" for label in self.actions]
        self.numbers = common_kind(
            chain(
                numbered(given, "prior"),
                *(
                    numbered(row, f"{place}, row {named(state)}")
                    for place, table in zip(places, tables, strict=True)
                    for state, row in zip(self.states, table, strict=True)
                ),
            )
        )
        self.prior: Vector = self._vector(distribution(given, self.numbers, "prior"))
        kind = NumberKind.FLOAT if self.numbers is NumberKind.FLOAT else NumberKind.RATIONAL
        self._matrices: list[Matrix] = [
            self._matrix(
                [
                    distribution(row, kind, f"{place}, row {named(state)}")
                    for state, row in zip(self.states, table, strict=True)
                ]
            )
            for place, table in zip(places, tables, strict=True)
        ]

    # --- other ways to make one ------------------------------------------------------------------

    @classmethod
    def from_matrices(
        cls,
        prior: Iterable[Any],
        matrices: Mapping[Any, Any] | Sequence[Any],
        *,
        states: Iterable[Hashable] | None = None,
        cost: Cost | None = None,
        name: str | None = None,
    ) -> PlanningProblem:
        """Return the problem of some matrices; labels not given are ``"0"``, ``"1"``, ...

        Examples
        --------
        >>> PlanningProblem.from_matrices([1, 0], [[[0, 1], [1, 0]]]).actions
        ('0',)
        """
        known = as_list(prior, "a list of probabilities", "prior")
        expect(matrices, Collection, "a list of matrices, or a mapping", "matrices")
        labels = [str(k) for k in range(len(known))] if states is None else states
        actions = (
            list(matrices) if isinstance(matrices, Mapping) else map(str, range(len(matrices)))
        )
        return cls(labels, known, actions, matrices, cost, name=name)

    @classmethod
    def from_function(
        cls,
        states: Iterable[Hashable],
        prior: Iterable[Any] | Mapping[Any, Any],
        actions: Iterable[Hashable],
        transition: Callable[[Any, Any], Any],
        cost: Cost | None = None,
        *,
        name: str | None = None,
    ) -> PlanningProblem:
        """Return the problem of a function of states and actions.

        Parameters
        ----------
        states, prior, actions, cost, name
            As for the problem itself.
        transition : callable
            ``transition(state, action)`` is a mapping from next states to probabilities, or, of an
            action that is deterministic there, the next state alone.

        Examples
        --------
        >>> walk = PlanningProblem.from_function(
        ...     range(3), {0: 1}, ["left", "right"],
        ...     lambda k, a: max(k - 1, 0) if a == "left" else min(k + 1, 2),
        ... )
        >>> walk.run(["right", "right"]) == (0, 0, 1)
        True
        """
        rows, columns = Labels(states, "state"), Labels(actions, "action")
        tables = {}
        for action in columns:
            table = []
            for state in rows:
                following = transition(state, action)
                place = f"action {named(action)}, row {named(state)}"
                shares = following if isinstance(following, Mapping) else {following: 1}
                table.append(listed(shares, rows, place))
            tables[action] = table
        return cls(rows, prior, columns, tables, cost, name=name)

    def with_cost(self, cost: Cost | None) -> PlanningProblem:
        """Return the same problem with another cost."""
        tables = dict(zip(self.actions, self._matrices, strict=True))
        return PlanningProblem(self.states, self.prior, self.actions, tables, cost, name=self.name)

    def to_float(self) -> PlanningProblem:
        """Return the same problem with each number rounded to a float, the cost left out.

        Examples
        --------
        >>> PlanningProblem.from_matrices(["1/3", "2/3"], [[[1, 0], [0, 1]]]).to_float().prior
        array([0.33333333, 0.66666667])
        """
        tables = [[[float(p) for p in row] for row in matrix] for matrix in self._matrices]
        prior = [float(p) for p in self.prior]
        return PlanningProblem(self.states, prior, self.actions, tables, name=self.name)

    # --- what it says ----------------------------------------------------------------------------

    @property
    def states(self) -> tuple[Any, ...]:
        """The labels of the states."""
        return self._states.all

    @property
    def actions(self) -> tuple[Any, ...]:
        """The labels of the actions."""
        return self._actions.all

    @property
    def exact(self) -> bool:
        """Whether the numbers are exact."""
        return self.numbers.exact

    def state_number(self, state: Hashable, *, where: str | None = None) -> int:
        """Return the place of a state, from 0; an unknown label is refused."""
        return self._states.number(state, where=where)

    def action_number(self, action: Hashable, *, where: str | None = None) -> int:
        """Return the place of an action, from 0; an unknown label is refused."""
        return self._actions.number(action, where=where)

    def matrix(self, action: Hashable) -> Matrix:
        """Return the stochastic matrix of an action: rows of mpq, or a float array.

        Raises
        ------
        UnknownLabelError
            If there is no such action.
        """
        return self._matrices[self.action_number(action)]

    def vector(self, values: Iterable[Any] | Mapping[Any, Any]) -> Vector:
        """Return a hyperstate of this problem's kind from probabilities, checked like the prior.

        Examples
        --------
        >>> PlanningProblem.from_matrices([1, 0], [[[0, 1], [1, 0]]]).vector({"1": 1})
        (mpq(0,1), mpq(1,1))
        """
        given = listed(values, self._states, "hyperstate")
        return self._vector(distribution(given, self.numbers, "hyperstate"))

    # --- what actions do -------------------------------------------------------------------------

    def after(self, hyperstate: Vector, action: Hashable) -> Vector:
        """Return lambda P, what an action makes of a hyperstate (Eq. 2.1).  O(nonzero entries).

        The hyperstate need not sum to 1: the map is linear.
        """
        return self.after_number(hyperstate, self.action_number(action))

    def after_number(self, hyperstate: Vector, number: int) -> Vector:
        """Do as `after`, the action given by its place."""
        if self.numbers is NumberKind.FLOAT:
            return np.asarray(hyperstate) @ self._matrices[number]
        if self.numbers is NumberKind.RATIONAL and self._integer_rows[number] is not None:
            return self._after_by_integers(hyperstate, self._integer_rows[number])
        result: list[Any] = [_NOTHING[self.numbers]] * len(self.states)
        for share, entries in zip(hyperstate, self._sparse[number], strict=True):
            if share:
                for j, p in entries:
                    result[j] += share if p == 1 else share * p
        return tuple(result)

    def _after_by_integers(self, hyperstate: Vector, rows: Any) -> Vector:
        """Multiply over one common denominator: a sum of fractions would be reduced n^2 times."""
        weights = [
            (share / denominator, entries)
            for share, (denominator, entries) in zip(hyperstate, rows, strict=True)
            if share
        ]
        common = lcm(mpz(1), *(weight.denominator for weight, _ in weights))
        totals = [mpz(0)] * len(self.states)
        for weight, entries in weights:
            factor = weight.numerator * (common // weight.denominator)
            for j, numerator in entries:
                totals[j] += factor * numerator
        return tuple(mpq(total, common) for total in totals)

    def run(self, plan: Iterable[Hashable], hyperstate: Vector | None = None) -> Vector:
        """Return the hyperstate after a plan, from the prior or another hyperstate (Eq. 2.4).

        Examples
        --------
        >>> turn = PlanningProblem.from_matrices(["1/4", "3/4"], {"turn": [[0, 1], [1, 0]]})
        >>> turn.run(["turn", "turn", "turn"])
        (mpq(3,4), mpq(1,4))
        """
        result = self.prior if hyperstate is None else hyperstate
        for action in plan:
            result = self.after(result, action)
        return result

    @cached_property
    def _sparse(self) -> list[list[list[tuple[int, mpq]]]]:
        """For each action and state the next states of positive probability."""
        return [
            [[(j, p) for j, p in enumerate(row) if p] for row in matrix]
            for matrix in self._matrices
        ]

    @cached_property
    def _integer_rows(self) -> list[Any]:
        """For each action and state a denominator and numerators; None for 0-1 matrices."""
        found: list[Any] = []
        for matrix in self._sparse:
            rows = []
            for row in matrix:
                common = lcm(mpz(1), *(p.denominator for _, p in row))
                rows.append((common, [(j, mpz(p * common)) for j, p in row]))
            found.append(None if all(len(row) == 1 for row in matrix) else rows)
        return found

    def successors(self, number: int, state: int) -> Sequence[tuple[int, Any]]:
        """Return the possible next states of a state, with probabilities, all by their places."""
        return self._sparse[number][state]

    @cached_property
    def stacked(self) -> NDArray[np.float64]:
        """The matrices as one array of floats: action, row, column."""
        return np.array([[[float(p) for p in row] for row in m] for m in self._matrices])

    @property
    def deterministic(self) -> bool:
        """Whether every action sends every state to one state."""
        return all(len(row) == 1 for matrix in self._sparse for row in matrix)

    # --- as a value ------------------------------------------------------------------------------

    def _vector(self, values: list[Number]) -> Vector:
        return _frozen(values) if self.numbers is NumberKind.FLOAT else tuple(values)

    def _matrix(self, rows: list[list[Number]]) -> Matrix:
        return _frozen(rows) if self.numbers is NumberKind.FLOAT else tuple(map(tuple, rows))

    def _key(self) -> tuple[Any, ...]:
        rows = tuple(tuple(map(tuple, matrix)) for matrix in self._matrices)
        return self.states, self.actions, self.numbers, tuple(self.prior), rows, self.cost

    def __eq__(self, other: object) -> bool:
        return self._key() == other._key() if isinstance(other, PlanningProblem) else NotImplemented

    def __hash__(self) -> int:
        return hash((self.states, self.actions, tuple(self.prior)))

    def __repr__(self) -> str:
        title = "" if self.name is None else f" {self.name}"
        return (
            f"<PlanningProblem{title}: {len(self.states)} states, {len(self.actions)} actions, "
            f"{self.numbers.value} numbers>"
        )


_NOTHING: Final[dict[NumberKind, Any]] = {
    NumberKind.RATIONAL: mpq(0),
    NumberKind.ANGLE_SUMS: read_number(0, NumberKind.ANGLE_SUMS, ""),
}


def _frozen(values: list[Any]) -> NDArray[np.float64]:
    array = np.array(values, dtype=np.float64)
    array.setflags(write=False)
    return array
