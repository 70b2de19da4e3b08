"""Which of several parts lies between the jaws (thesis 7.2.7).

The state is a part together with its orientation. A squeeze acts on whichever part is there, so
the classes of equivalent squeezes are those of all parts together; the sensor reads the distance
between the jaws.

Whether two parts can be told apart at all is decided. With a sensor of given likelihoods, whatever
is squeezed and read, the probability of the readings is pi u, with pi the distribution of the
orientations after the first squeeze and u a product of transition and reading matrices, applied to
a vector of ones. The vectors u span a space that is found by closing it under all those matrices;
its dimension is at most the number of states, and all numbers are rational. Two parts give readings
the same probabilities under every plan exactly if pi u is the same for both and every u of a basis.
So a triangle cannot be told from the hexagon of the same diameter function.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace
from functools import cached_property
from typing import Any, final

from gmpy2 import mpq

from stochgeom.decision.labels import Labels
from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.decision.priors import as_share
from stochgeom.display import Displayed
from stochgeom.errors import SensorError
from stochgeom.exact.angles import FULL_TURN, HALF_TURN, ZERO, Angle
from stochgeom.exact.directions import nominal_angle
from stochgeom.exact.scalars import RationalLike
from stochgeom.exact.sums import AngleSum
from stochgeom.feeding.action_classes import action_classes
from stochgeom.feeding.planning_problems import planning_problem_of_transfer
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.part import PartLike, as_part
from stochgeom.sensing.decisions import Decisions, lose_by_table
from stochgeom.sensing.diameter_sensor import sensor_of_diameters
from stochgeom.sensing.planners import sensor_plan
from stochgeom.sensing.sensor_plan import SensorPlan
from stochgeom.sensing.sensors import Sensor
from stochgeom.transfer.squeeze import squeeze_function
from stochgeom.transfer.step_function import StepFunction

State = tuple[Any, str]
"""The name of a part, and its orientation in degrees as text."""


@final
class RecognitionProblem(Displayed):
    """Several parts, one of which lies between the jaws.

    Parameters
    ----------
    parts : mapping from names to parts
        At least two.
    shares : mapping from names to rationals, optional
        How often each part comes; they are divided by their sum. Default: all alike.
    bits, noise, **settings
        Of the sensor, as for `sensor_of_diameters`.

    Attributes
    ----------
    problem : PlanningProblem
        States are pairs of a part's name and an orientation.
    sensor : Sensor
        Of the distance between the jaws.
    angles : dict from action labels to Angle
        Representatives of the classes of squeezes.

    Examples
    --------
    >>> found = RecognitionProblem({
    ...     "plate": [(0, 0), (3, 0), (3, 2), (0, 2)],
    ...     "turned plate": [(0, 0), (2, 0), (2, 3), (0, 3)],
    ...     "square": [(0, 0), (2, 0), (2, 2), (0, 2)],
    ... }, {"plate": 1, "turned plate": 1, "square": 2})
    >>> found.problem
    <PlanningProblem: 12 states, 6 actions, angle sums numbers>
    >>> found.indistinguishable()
    (('plate', 'turned plate'),)
    >>> plan = found.plan(3, mistake_cost=10)
    >>> print(plan.tree.text(2))
    read diameter
      2 (0.81)
        turn 90.0000°, squeeze
        read diameter
          2 (0.62): square (0.00)
          3 (0.38): plate (5.00)
      3 (0.19): plate (5.00)
    """

    def __init__(
        self,
        parts: Mapping[Any, PartLike],
        shares: Mapping[Any, RationalLike] | None = None,
        bits: int | None = None,
        noise: RationalLike = 0,
        **settings: Any,
    ) -> None:
        self.names = Labels(parts, "part").all
        if len(self.names) < 2:
            raise SensorError("one part; accepted: two or more", where="parts")
        diameters = {name: DiameterFunction(as_part(parts[name])) for name in self.names}
        transfers = {name: squeeze_function(d) for name, d in diameters.items()}
        single = {name: planning_problem_of_transfer(s) for name, s in transfers.items()}
        self._priors = {
            name: tuple(AngleSum.of(p) for p in each.problem.prior) for name, each in single.items()
        }
        self.orientations: dict[State, Angle] = {
            (name, str(label)): theta
            for name, each in single.items()
            for label, theta in each.orientations.items()
        }
        weights = _shares(self.names, shares)
        prior = [p * weights[name] for name in self.names for p in self._priors[name]]
        self.angles, targets = _common_squeezes(transfers, self.orientations)
        self.problem = PlanningProblem(
            self.orientations,
            prior,
            self.angles,
            [[{target: 1} for target in row] for row in targets],
        )
        squares = {
            state: diameters[state[0]].squared(theta) for state, theta in self.orientations.items()
        }
        self.sensor: Sensor = sensor_of_diameters(squares, bits, noise, **settings)

    def __repr__(self) -> str:
        readings = len(self.sensor.readings)
        return (
            f"<RecognitionProblem: {len(self.names)} parts, {len(self.problem.actions)} squeezes, "
            f"a sensor of {readings} reading{'s' if readings != 1 else ''}>"
        )

    # --- plans -----------------------------------------------------------------------------------

    def decisions(self, mistake_cost: RationalLike = 1) -> Decisions:
        """Return the decisions to name a part, at a loss where it is another."""
        losses = {
            name: {state: mistake_cost for state in self.problem.states if state[0] != name}
            for name in self.names
        }
        return lose_by_table(self.problem, losses)

    def plan(
        self,
        horizon: int,
        mistake_cost: RationalLike = 1,
        squeeze_cost: RationalLike = 1,
        **more: Any,
    ) -> SensorPlan:
        """Return the plan of least expected cost that ends by naming the part.

        Parameters
        ----------
        horizon : int
            Most moves, looks included, after the random first squeeze.
        mistake_cost : rational, default 1
            Cost of a wrong name.
        squeeze_cost : rational, default 1
            Cost of a squeeze; a look costs what the sensor does.
        **more
            As for `sensor_plan`.
        """
        plan = sensor_plan(
            self.problem,
            {self.sensor.name: self.sensor},
            horizon,
            action_costs=squeeze_cost,
            decisions=self.decisions(mistake_cost),
            **more,
        )
        return replace(plan, tree=replace(plan.tree, action_form="turn {}°, squeeze"))

    def recognised(self, plan: SensorPlan) -> Any:
        """Return the probability that a plan names the right part."""
        total: Any = AngleSum()
        for leaf in plan.tree.leaves():
            for state, weight in zip(self.problem.states, leaf.weights, strict=True):
                if state[0] == leaf.decision:
                    total = total + weight
        return total

    # --- what no plan can do ---------------------------------------------------------------------

    def indistinguishable(self) -> tuple[tuple[Any, ...], ...]:
        """Return the groups of parts that no plan of squeezes and readings can tell apart.

        Groups of one are left out: if there is no group, every part can be told from every other,
        if not for certain, then by the frequencies of readings.
        """
        groups: list[list[Any]] = []
        signatures: list[tuple[AngleSum, ...]] = []
        for name in self.names:
            mine = self._signature(name)
            for group, signature in zip(groups, signatures, strict=True):
                if all(a.compare(b) == 0 for a, b in zip(mine, signature, strict=True)):
                    group.append(name)
                    break
            else:
                groups.append([name])
                signatures.append(mine)
        return tuple(tuple(group) for group in groups if len(group) > 1)

    def _signature(self, name: Any) -> tuple[AngleSum, ...]:
        """Return the probabilities of all that can be read, by a basis of it, for one part."""
        places = [k for k, state in enumerate(self.problem.states) if state[0] == name]
        found = []
        for vector in self._observable:
            total = AngleSum()
            for p, k in zip(self._priors[name], places, strict=True):
                total += p * vector[k]
            found.append(total)
        return tuple(found)

    @cached_property
    def _observable(self) -> list[tuple[mpq, ...]]:
        """A basis of the space of the vectors u.  O(states^3 (squeezes + readings))."""
        problem, count = self.problem, len(self.problem.states)
        columns = self.sensor.columns
        squeezes = [
            [problem.successors(number, k)[0][0] for k in range(count)]
            for number in range(len(problem.actions))
        ]
        basis = _Echelon()
        ones = (mpq(1),) * count
        basis.add(ones)
        pending, found = [ones], [ones]
        # Invariant: `found` spans what was reached; what its members not in `pending` lead to also.
        while pending:
            vector = pending.pop()
            following = [tuple(vector[target] for target in row) for row in squeezes]
            following += [tuple(p * v for p, v in zip(c, vector, strict=True)) for c in columns]
            for each in following:
                if basis.add(each):
                    pending.append(each)
                    found.append(each)
        return found


class _Echelon:
    """A growing linear space of rational vectors."""

    def __init__(self) -> None:
        self._rows: dict[int, list[mpq]] = {}

    def add(self, vector: tuple[mpq, ...]) -> bool:
        """Add a vector; tell whether it was not in the space."""
        rest = list(vector)
        for k in range(len(rest)):
            if not rest[k]:
                continue
            row = self._rows.get(k)
            if row is None:
                self._rows[k] = [value / rest[k] for value in rest]
                return True
            factor = rest[k]
            rest = [value - factor * other for value, other in zip(rest, row, strict=True)]
        return False


def _shares(names: tuple[Any, ...], shares: Mapping[Any, RationalLike] | None) -> dict[Any, mpq]:
    """Return how often each part comes, of sum 1."""
    if shares is None:
        return {name: mpq(1, len(names)) for name in names}
    labels = Labels(names, "part")
    for name in shares:
        labels.number(name, where="shares")
    given = {name: as_share(shares.get(name, 0), where=f"share of {name}") for name in names}
    total = sum(given.values(), start=mpq(0))
    if total == 0:
        raise SensorError("all shares are 0; accepted: a positive sum", where="shares")
    return {name: share / total for name, share in given.items()}


def _common_squeezes(
    transfers: Mapping[Any, StepFunction], orientations: Mapping[State, Angle]
) -> tuple[dict[str, Angle], list[list[State]]]:
    """Return representatives of the squeezes that differ on some part, and what they do.

    Angles of half a turn are enough: the gripper and its sensor are the same after it.
    """
    critical: set[Angle] = set()
    for transfer in transfers.values():
        laps = HALF_TURN // transfer.period
        for each in action_classes(transfer):
            critical |= {each.high + transfer.period * lap for lap in range(laps)}
    highs = sorted(critical)
    lows = [highs[-1] - HALF_TURN, *highs[:-1]]
    place = {(state[0], theta): state for state, theta in orientations.items()}
    found: dict[tuple[State, ...], Angle] = {}
    for low, high in zip(lows, highs, strict=True):
        alpha = nominal_angle(low, high)
        targets = tuple(
            place[name, transfers[name](theta - alpha) % FULL_TURN]
            for (name, _), theta in orientations.items()
        )
        found.setdefault(targets, alpha)
    digits = 4
    while len(set(labels := [a.degrees(digits) for a in found.values()])) < len(found):
        digits *= 2
    assert all(alpha >= ZERO - HALF_TURN for alpha in found.values())
    return dict(zip(labels, found.values(), strict=True)), [list(row) for row in found]
