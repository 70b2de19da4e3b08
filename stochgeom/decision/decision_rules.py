"""Statistical decision rules of a finite problem: classical, minimax, Bayes (thesis app. A).

A reading x is made in the unknown state theta with probability f(x | theta); a rule delta answers
it with an action, at the loss L(theta, delta(x)). The risk of a rule is a function of the state,

    R(theta, delta) = sum over x of L(theta, delta(x)) f(x | theta)                (Eq. A.1)

and there are three ways to call a rule best: none is better in any state (*classical*: a rule that
dominates all; often there is none); its largest risk is the least (*minimax*); its mean risk under
a prior pi, the Bayes risk (Eq. A.2, A.3), is the least (*Bayes*). A Bayes rule needs no table of
rules: it answers each reading with an action of least expected loss under the posterior,

    rho(pi(. | x), a) = sum over theta of L(theta, a) pi(theta | x)                 (Eq. A.4)

The source writes L(theta, delta) in Eq. A.1 where L(theta, delta(x)) is meant, and looks for a
"maximum" of r where it means the minimum.
"""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable, Iterator, Mapping
from functools import cached_property
from itertools import product
from typing import Any, Final, TypeAlias, final

from stochgeom.decision.distributions import distribution, listed
from stochgeom.decision.labels import Labels, named
from stochgeom.decision.number_kinds import NumberKind, common_kind, numbered, read_number
from stochgeom.display import Displayed
from stochgeom.errors import NodeLimitError, ProblemError, ShapeMismatchError

Rule: TypeAlias = "tuple[int, ...]"
"""For each reading the number of the action that answers it."""

RULE_LIMIT: Final = 1_000_000
"""Most rules that a table lists."""


@final
class DecisionProblem(Displayed):
    """States, readings, actions, f and L.

    Parameters
    ----------
    states, readings, actions : sequence of labels
        Hashable and different.
    likelihood : sequence of rows, or mapping from states to rows
        ``likelihood[theta][x]`` is f(x | theta); each row sums to 1.
    loss : sequence of rows, or mapping from states to rows, or function
        ``loss[theta][a]`` or ``loss(theta, a)`` is L(theta, a).

    Attributes
    ----------
    likelihood, loss : tuple of tuples of numbers
        The two tables, in the order of the labels.
    numbers : NumberKind
        Rational or float.

    Raises
    ------
    NotStochasticError, ShapeMismatchError, UnknownLabelError, MixedNumbersError
        If a table does not fit, or numbers of different kinds stand in them.

    Examples
    --------
    A part may be good or bad; a test says which, wrongly one time in ten; to throw away a good part
    costs 1, to keep a bad one 5:

    >>> test = DecisionProblem(
    ...     ["good", "bad"], ["pass", "fail"], ["keep", "throw"],
    ...     [["9/10", "1/10"], ["1/10", "9/10"]],
    ...     [[0, 1], [5, 0]],
    ... )
    >>> test.risk(test.rule({"pass": "keep", "fail": "throw"}))
    (mpq(1,10), mpq(1,2))
    >>> [test.answers(rule) for rule in test.bayes_rules(["9/10", "1/10"])]
    [{'pass': 'keep', 'fail': 'throw'}]
    """

    def __init__(
        self,
        states: Iterable[Hashable],
        readings: Iterable[Hashable],
        actions: Iterable[Hashable],
        likelihood: Any,
        loss: Any,
    ) -> None:
        self._states = Labels(states, "state")
        self._readings = Labels(readings, "reading")
        self._actions = Labels(actions, "action")
        if callable(loss):
            function: Callable[[Any, Any], Any] = loss
            loss = [[function(state, action) for action in self._actions] for state in self._states]
        chances = _rows(likelihood, self._states, self._readings, "likelihood")
        losses = _rows(loss, self._states, self._actions, "loss")
        self.numbers = common_kind(
            entry
            for what, table in (("likelihood", chances), ("loss", losses))
            for state, row in zip(self._states, table, strict=True)
            for entry in numbered(row, f"{what}, row {named(state)}")
        )
        if self.numbers is NumberKind.ANGLE_SUMS:
            raise ProblemError("a table holds an angle sum; accepted: rational numbers or floats")
        self.likelihood = tuple(
            tuple(distribution(row, self.numbers, f"likelihood, row {named(state)}"))
            for state, row in zip(self._states, chances, strict=True)
        )
        self.loss = tuple(
            tuple(
                read_number(value, self.numbers, where)
                for value, where in numbered(row, f"loss, row {named(state)}")
            )
            for state, row in zip(self._states, losses, strict=True)
        )

    @property
    def states(self) -> tuple[Any, ...]:
        """The labels of the states."""
        return self._states.all

    @property
    def readings(self) -> tuple[Any, ...]:
        """The labels of the readings."""
        return self._readings.all

    @property
    def actions(self) -> tuple[Any, ...]:
        """The labels of the actions."""
        return self._actions.all

    # --- rules -----------------------------------------------------------------------------------

    def rule(self, answers: Mapping[Any, Any]) -> Rule:
        """Return the rule that answers each reading as a mapping says.

        Raises
        ------
        UnknownLabelError, ShapeMismatchError
            If a label is unknown, or a reading has no answer.
        """
        for reading in answers:
            self._readings.number(reading)
        for reading in self.readings:
            if reading not in answers:
                raise ShapeMismatchError(
                    "no answer; accepted: an action for each reading",
                    where=f"reading {named(reading)}",
                )
        return tuple(self._actions.number(answers[reading]) for reading in self.readings)

    def answers(self, rule: Rule) -> dict[Any, Any]:
        """Return a rule as a mapping from readings to actions."""
        return {x: self.actions[a] for x, a in zip(self.readings, rule, strict=True)}

    def rules(self) -> Iterator[Rule]:
        """Yield all rules: m^r of them for m actions and r readings.

        Raises
        ------
        NodeLimitError
            If there are more than `RULE_LIMIT`.
        """
        count = len(self.actions) ** len(self.readings)
        if count > RULE_LIMIT:
            raise NodeLimitError(
                f"{len(self.actions)} actions for {len(self.readings)} readings make {count} "
                f"rules; accepted: at most {RULE_LIMIT}"
            )
        return product(range(len(self.actions)), repeat=len(self.readings))

    def risk(self, rule: Rule) -> tuple[Any, ...]:
        """Return R(theta, delta) for each state (Eq. A.1)."""
        return tuple(
            sum(f * losses[a] for f, a in zip(chances, rule, strict=True))
            for chances, losses in zip(self.likelihood, self.loss, strict=True)
        )

    @cached_property
    def risk_table(self) -> dict[Rule, tuple[Any, ...]]:
        """The risk of every rule."""
        return {rule: self.risk(rule) for rule in self.rules()}

    # --- best ones -------------------------------------------------------------------------------

    def dominating_rules(self) -> list[Rule]:
        """Return the rules whose risk is least in every state: the classical best, often none."""
        least = [min(column) for column in zip(*self.risk_table.values(), strict=True)]
        return [rule for rule, risk in self.risk_table.items() if list(risk) == least]

    def admissible_rules(self) -> list[Rule]:
        """Return the rules that no other rule dominates.

        A rule dominates another if its risk is nowhere larger and somewhere smaller. Randomised
        rules are left out of account: a mixture may dominate a rule that is listed here.
        O(states) for each pair of a rule and an admissible risk.
        """
        kept: dict[tuple[Any, ...], None] = {}
        # What dominates a risk comes before it in this order, and is kept or dominated itself.
        for risk in sorted(set(self.risk_table.values())):
            if not any(all(a <= b for a, b in zip(other, risk, strict=True)) for other in kept):
                kept[risk] = None
        return [rule for rule, risk in self.risk_table.items() if risk in kept]

    def minimax_rules(self) -> tuple[Any, list[Rule]]:
        """Return the least of the largest risks, and the rules that attain it.

        Of rules that are not randomised; see `stochgeom.decision.randomised_rules` for those that
        are.
        """
        worst = {rule: max(risk) for rule, risk in self.risk_table.items()}
        least = min(worst.values())
        return least, [rule for rule, value in worst.items() if value == least]

    def bayes_risk(self, prior: Any, rule: Rule) -> Any:
        """Return r(pi, delta), the mean risk under a prior (Eq. A.2, A.3)."""
        return self._mean(self._prior(prior), self.risk(rule))

    def bayes_rules(self, prior: Any) -> list[Rule]:
        """Return all rules of least Bayes risk, by expected losses of actions (Eq. A.4).

        Every answer to a reading that cannot occur is as good as any other.

        Parameters
        ----------
        prior : sequence of numbers, or mapping from states
            pi, of the numbers of the problem.
        """
        return list(product(*self.bayes_actions(prior)))

    def bayes_actions(self, prior: Any) -> list[list[int]]:
        """Return for each reading the actions of least posterior expected loss.

        The expected losses are compared without the common factor m(x), so that a reading of
        probability 0 needs no posterior. O(readings actions states).
        """
        shares = self._prior(prior)
        found = []
        for x in range(len(self.readings)):
            weights = [share * row[x] for share, row in zip(shares, self.likelihood, strict=True)]
            losses = [self._mean(weights, column) for column in zip(*self.loss, strict=True)]
            least = min(losses)
            found.append([a for a, value in enumerate(losses) if value == least])
        return found

    def expected_loss(self, hyperstate: Any, action: Hashable) -> Any:
        """Return rho(pi, a), the expected loss of an action under what is known (Eq. A.4)."""
        a = self._actions.number(action)
        return self._mean(self._prior(hyperstate), [row[a] for row in self.loss])

    def _prior(self, prior: Any) -> list[Any]:
        given = listed(prior, self._states, "prior")
        common_kind([(self.likelihood[0][0], "likelihood"), *numbered(given, "prior")])
        return distribution(given, self.numbers, "prior")

    @staticmethod
    def _mean(weights: Iterable[Any], values: Iterable[Any]) -> Any:
        return sum((w * v for w, v in zip(weights, values, strict=True)))

    def __repr__(self) -> str:
        return (
            f"<DecisionProblem: {len(self.states)} states, {len(self.readings)} readings, "
            f"{len(self.actions)} actions>"
        )


def _rows(table: Any, states: Labels, columns: Labels, what: str) -> list[list[Any]]:
    if isinstance(table, Mapping):
        for state in table:
            states.number(state, where=what)
        missing = [state for state in states if state not in table]
        if missing:
            raise ShapeMismatchError("no row; accepted: one", where=f"{what}, {named(missing[0])}")
        table = [table[state] for state in states]
    rows = list(table)
    if len(rows) != len(states):
        raise ShapeMismatchError(
            f"{len(rows)} rows; accepted: {len(states)}, one for each state", where=what
        )
    return [
        listed(row, columns, f"{what}, row {named(state)}")
        for state, row in zip(states, rows, strict=True)
    ]
