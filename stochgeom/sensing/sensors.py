"""Sensors: which reading to expect in which state, and what a reading tells (thesis 7.2.1).

A sensor is a finite set of readings x and the likelihood P(x | theta) of each in every state theta.
From a hyperstate, a probability for each state,

    m(x) = sum over theta of P(x | theta) P(theta)                                    (Eq. 7.2)
    P(theta | x) = P(x | theta) P(theta) / m(x)                                       (Eq. 7.1)

are the marginal probability of a reading and the posterior. The numerator of Eq. 7.1 is the
hyperstate times a diagonal matrix (Eq. 7.3); it is called `joint` here. Joint hyperstates are what
plans with sensors are made of: they need no division, so that they stay sums of angles where the
hyperstate was made of those, and their sum is the probability of the readings so far.

Given the state, readings are independent of all that happened before.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Mapping, Sequence
from functools import cached_property
from itertools import chain
from typing import Any, final

from stochgeom.arguments import as_list
from stochgeom.decision.distributions import distribution
from stochgeom.decision.labels import Labels, named
from stochgeom.decision.number_kinds import Number, NumberKind, common_kind, numbered, read_number
from stochgeom.errors import (
    ImpossibleReadingError,
    MixedNumbersError,
    SensorError,
    ShapeMismatchError,
)
from stochgeom.exact.quotients import quotient
from stochgeom.exact.scalars import RationalLike, rational
from stochgeom.sensing.likelihoods import covering, rows_by_state, sensor_cost


@final
class Sensor:
    """A sensor with finitely many readings.

    Parameters
    ----------
    readings : sequence of labels
        Hashable and different.
    likelihood : mapping, or sequence of rows
        ``likelihood[state][reading]`` is P(reading | state): for each state a mapping from every
        reading, or a sequence in the order of the readings.
    states : sequence of labels, optional
        Needed where the likelihood is a sequence and the states are not 0, 1, 2, ...
    cost : number, default 0
        Cost of consulting it once, in units of one action.
    name : str, optional
        For people.
    row_error : rational, default 0
        By how much, summed over a row, the likelihood may differ from the one that is meant, where
        it is a rounded one.

    Attributes
    ----------
    readings, states : tuple
        The labels.
    likelihood : tuple of rows
        For each state the probabilities of the readings.
    numbers : NumberKind
        Rational or float.

    Raises
    ------
    NotStochasticError
        If a row does not sum to 1 or has a negative entry; state and sum are named.
    ShapeMismatchError, UnknownLabelError
        If a row does not cover the readings, or names others.
    MixedNumbersError
        If floats and exact numbers that are not whole stand together.
    SensorError
        If the cost is negative.

    Examples
    --------
    A test that is right nine times in ten:

    >>> test = Sensor(["+", "-"], {"ill": ["0.9", "0.1"], "well": {"+": "0.1", "-": "0.9"}})
    >>> test.marginal(["1/100", "99/100"])
    {'+': mpq(27,250), '-': mpq(223,250)}
    >>> test.posterior(["1/100", "99/100"], "+")
    (mpq(1,12), mpq(11,12))
    """

    def __init__(
        self,
        readings: Iterable[Hashable],
        likelihood: Mapping[Any, Any] | Iterable[Any],
        *,
        states: Iterable[Hashable] | None = None,
        cost: Any = 0,
        name: str | None = None,
        row_error: RationalLike = 0,
    ) -> None:
        self._readings = Labels(readings, "reading")
        rows = rows_by_state(likelihood, states)
        self._states = Labels(rows, "state")
        places = [f"likelihood of state {named(state)}" for state in rows]
        table = [
            covering(row, self._readings, place)
            for row, place in zip(rows.values(), places, strict=True)
        ]
        self.numbers = common_kind(chain.from_iterable(map(numbered, table, places)))
        if self.numbers is NumberKind.ANGLE_SUMS:
            raise SensorError("a likelihood is a sum of angles; accepted: rationals, or floats")
        self.likelihood: tuple[tuple[Number, ...], ...] = tuple(
            tuple(distribution(row, self.numbers, place))
            for row, place in zip(table, places, strict=True)
        )
        self.name = name
        self.row_error = rational(row_error, where="row error of a sensor")
        self.cost = sensor_cost(cost, self.numbers)

    # --- other ways to make one ------------------------------------------------------------------

    @classmethod
    def from_function(
        cls, states: Iterable[Hashable], reading: Callable[[Any], Hashable], **settings: Any
    ) -> Sensor:
        """Return the sensor without noise that reads ``reading(state)``.

        It is partition-valued: it tells in which block of states the state is. Readings are listed
        in the order of the states that give them first.

        Examples
        --------
        >>> parity = Sensor.from_function(range(4), lambda state: "odd" if state % 2 else "even")
        >>> parity.blocks
        {'even': (0, 2), 'odd': (1, 3)}
        """
        shown = {state: reading(state) for state in Labels(states, "state")}
        readings = list(dict.fromkeys(shown.values()))
        table = {state: [int(x == given) for x in readings] for state, given in shown.items()}
        return cls(readings, table, **settings)

    @classmethod
    def perfect(cls, states: Iterable[Hashable], **settings: Any) -> Sensor:
        """Return the sensor that reads the state itself.

        Examples
        --------
        >>> Sensor.perfect(["up", "down"]).posterior(["1/2", "1/2"], "up")
        (mpq(1,1), mpq(0,1))
        """
        return cls.from_function(states, lambda state: state, **settings)

    @classmethod
    def blind(cls, states: Iterable[Hashable], **settings: Any) -> Sensor:
        """Return the sensor that always reads ``"nothing"``."""
        return cls.from_function(states, lambda _: "nothing", **settings)

    @classmethod
    def noisy(cls, states: Iterable[Hashable], error: Any, **settings: Any) -> Sensor:
        """Return the sensor that reads the state, but errs with some probability.

        Parameters
        ----------
        states : sequence of labels
            At least two.
        error : number
            The probability of a wrong reading; all wrong ones are equally likely.

        Examples
        --------
        >>> Sensor.noisy(["a", "b", "c"], "1/5").likelihood[0]
        (mpq(4,5), mpq(1,10), mpq(1,10))
        """
        labels = Labels(states, "state")
        others = len(labels) - 1
        if not others:
            raise SensorError("one state; accepted: two or more, or a sensor without error")
        kind = common_kind([(error, "error")])
        e: Any = read_number(error, kind, "error")
        table = [
            [1 - e if j == k else e / others for j in range(len(labels))] for k in range(others + 1)
        ]
        return cls(labels, table, states=labels, **settings)

    # --- what it says ----------------------------------------------------------------------------

    @property
    def readings(self) -> tuple[Any, ...]:
        """The labels of the readings."""
        return self._readings.all

    @property
    def states(self) -> tuple[Any, ...]:
        """The labels of the states."""
        return self._states.all

    @property
    def exact(self) -> bool:
        """Whether the numbers are exact."""
        return self.numbers.exact

    def state_number(self, state: Hashable) -> int:
        """Return the place of a state, from 0; an unknown label is refused."""
        return self._states.number(state)

    def probability(self, reading: Hashable, state: Hashable) -> Number:
        """Return P(reading | state)."""
        return self.likelihood[self.state_number(state)][self._readings.number(reading)]

    def column(self, reading: Hashable) -> tuple[Number, ...]:
        """Return the likelihood of one reading in every state."""
        return self.columns[self._readings.number(reading)]

    @cached_property
    def columns(self) -> tuple[tuple[Number, ...], ...]:
        """For each reading its likelihood in every state."""
        return tuple(zip(*self.likelihood, strict=True))

    def matrix(self, reading: Hashable) -> tuple[tuple[Number, ...], ...]:
        """Return the diagonal matrix of a reading (Eq. 7.3).

        Examples
        --------
        >>> Sensor.perfect(["a", "b"]).matrix("a")
        ((mpq(1,1), mpq(0,1)), (mpq(0,1), mpq(0,1)))
        """
        column = self.column(reading)
        nothing = 0 * column[0]
        return tuple(
            tuple(p if j == k else nothing for j in range(len(column)))
            for k, p in enumerate(column)
        )

    @cached_property
    def blocks(self) -> dict[Any, tuple[Any, ...]] | None:
        """The states of each reading if there is no noise, else None."""
        if any(p not in (0, 1) for row in self.likelihood for p in row):
            return None
        return {
            x: tuple(state for state, p in zip(self.states, column, strict=True) if p)
            for x, column in zip(self.readings, self.columns, strict=True)
        }

    # --- what a reading tells --------------------------------------------------------------------

    def joint(self, hyperstate: Sequence[Any] | Any, reading: Hashable) -> tuple[Any, ...]:
        """Return P(theta) P(reading | theta) for each state: the posterior times m(reading).

        Parameters
        ----------
        hyperstate : sequence of numbers, or mapping from states
            Rational numbers, `AngleSum` numbers or floats; it need not sum to 1.
        reading : label
            What was read.
        """
        column = self.column(reading)
        return tuple(w * p for w, p in zip(self.weights(hyperstate), column, strict=True))

    def marginal(self, hyperstate: Sequence[Any] | Any) -> dict[Any, Any]:
        """Return the probability m(x) of each reading (Eq. 7.2)."""
        weights = self.weights(hyperstate)
        return {
            x: sum((w * p for w, p in zip(weights, column, strict=True)), start=0 * weights[0])
            for x, column in zip(self.readings, self.columns, strict=True)
        }

    def posterior(self, hyperstate: Sequence[Any] | Any, reading: Hashable) -> tuple[Any, ...]:
        """Return the probability of each state, given a reading (Eq. 7.1).

        Exact: where the hyperstate is made of `AngleSum` numbers, of `SumQuotient` numbers.

        Raises
        ------
        ImpossibleReadingError
            If the reading has probability 0: there is no posterior then.

        Examples
        --------
        >>> Sensor.noisy(["a", "b", "c"], "1/5").posterior([1, 0, 0], "b")
        (mpq(1,1), mpq(0,1), mpq(0,1))
        >>> Sensor.perfect(["a", "b", "c"]).posterior([1, 0, 0], "b")
        Traceback (most recent call last):
        ...
        stochgeom.errors.ImpossibleReadingError: reading 'b': its probability is 0, so it has no \
posterior; accepted: 'a'
        """
        joint = self.joint(hyperstate, reading)
        total = sum(joint[1:], start=joint[0])
        if total == 0:
            possible = [named(x) for x, m in self.marginal(hyperstate).items() if m != 0]
            raise ImpossibleReadingError(
                "its probability is 0, so it has no posterior; "
                f"accepted: {', '.join(possible) or 'none, the hyperstate is 0'}",
                where=f"reading {named(reading)}",
            )
        return tuple(quotient(w, total) for w in joint)

    def weights(self, hyperstate: Any) -> tuple[Any, ...]:
        """Return a hyperstate as numbers that agree with the kind of this sensor.

        Raises
        ------
        ShapeMismatchError, UnknownLabelError, MixedNumbersError
            If it has not one number for each state, or numbers of another kind.
        """
        if isinstance(hyperstate, Mapping):
            listed: list[Any] = [0] * len(self.states)
            for state, value in hyperstate.items():
                listed[self._states.number(state, where="hyperstate")] = value
        else:
            listed = as_list(hyperstate, "a list of probabilities", "hyperstate", SensorError)
        if len(listed) != len(self.states):
            raise ShapeMismatchError(
                f"{len(listed)} probabilities; accepted: {len(self.states)}, one for each state",
                where="hyperstate",
            )
        entries = list(numbered(listed, "hyperstate"))
        kind = common_kind([*entries, *self._telling])
        return tuple(read_number(value, kind, where) for value, where in entries)

    @cached_property
    def _telling(self) -> list[tuple[Any, str]]:
        """A likelihood that shows the kind of all, with its place; none if 0 and 1 are all."""
        if not self.exact:
            return [(self.likelihood[0][0], "likelihood of the sensor")]
        shares = [p for row in self.likelihood for p in row if p not in (0, 1)]
        return [(shares[0], "likelihood of the sensor")] if shares else []

    def check_kind(self, other: NumberKind) -> None:
        """Refuse a problem whose numbers are of the other kind.

        Raises
        ------
        MixedNumbersError
            For floats beside exact numbers that are not whole.
        """
        if self.exact == other.exact or (self.exact and self.blocks is not None):
            return
        mine, theirs = ("exact", "floats") if self.exact else ("floats", "exact")
        raise MixedNumbersError(
            f"the sensor's numbers are {mine} and the problem's {theirs}; accepted: one kind, or "
            "to_float() of either"
        )

    # --- new sensors from old --------------------------------------------------------------------

    def to_float(self) -> Sensor:
        """Return the same sensor with each number rounded to a float."""
        table = [[float(p) for p in row] for row in self.likelihood]
        return Sensor(
            self.readings, table, states=self.states, cost=float(self.cost), name=self.name
        )

    def with_cost(self, cost: Any) -> Sensor:
        """Return the same sensor at another cost."""
        return Sensor(
            self.readings,
            self.likelihood,
            states=self.states,
            cost=cost,
            name=self.name,
            row_error=self.row_error,
        )

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, Sensor):
            return NotImplemented
        return self._key() == other._key()

    def __hash__(self) -> int:
        return hash(self._key())

    def _key(self) -> tuple[Any, ...]:
        return self.readings, self.states, self.numbers, self.likelihood, self.cost

    def __repr__(self) -> str:
        title = "" if self.name is None else f" {self.name}"
        return (
            f"<Sensor{title}: {len(self.readings)} readings of {len(self.states)} states, "
            f"{self.numbers.value} numbers>"
        )
