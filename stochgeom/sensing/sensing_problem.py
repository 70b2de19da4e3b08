"""A part, a gripper that squeezes, and a sensor of the distance between its jaws.

A round begins with a squeeze at a random angle: its cost, 1, and that of the filter, c, are the
cost of a round; every further squeeze costs 1 and every look at the sensor what the sensor costs.
So a plan that never looks costs what `stochgeom.feeding` says it does.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from functools import cached_property
from typing import TYPE_CHECKING, Any, final

from stochgeom.arguments import as_count, as_list
from stochgeom.decision.costs import as_cost_ratio
from stochgeom.display import Displayed
from stochgeom.exact.angles import Angle
from stochgeom.exact.scalars import RationalLike
from stochgeom.feeding.planning_problems import OrientingProblem, planning_problem_of_transfer
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.part import PartLike, as_part
from stochgeom.sensing.diameter_sensor import (
    LIKELIHOOD_DIGITS,
    check_rational,
    covered_range,
    noise_deviation,
    sensor_of_diameters,
)
from stochgeom.sensing.one_step import OneStepPlan, one_step_plan
from stochgeom.sensing.plan_tasks import MOST_MOVES
from stochgeom.sensing.planners import iterative_sensor_plan
from stochgeom.sensing.sensor_plan import SensorPlan
from stochgeom.sensing.tree_search import NODE_LIMIT
from stochgeom.transfer.squeeze import squeeze_function

if TYPE_CHECKING:
    from stochgeom.decision.priors import Prior


@final
@dataclass(frozen=True)
class OrderComparison:
    """Expected costs of plans with so many further actions and one look, by their order.

    Attributes
    ----------
    actions : int
        Most squeezes after the first one.
    blind : SensorPlan
        No look.
    sense_then_act : SensorPlan
        Look first; the squeezes depend on what was read.
    act_then_sense : SensorPlan
        Squeeze first; which orientation is accepted depends on what is read.
    mixed : SensorPlan
        As many moves in all, in any order, and any number of looks. If it is not proven to be the
        best, it is no worse than the two before.
    """

    actions: int
    blind: SensorPlan
    sense_then_act: SensorPlan
    act_then_sense: SensorPlan
    mixed: SensorPlan


@final
class SensingProblem(Displayed):
    """Plans with a jaw-diameter sensor for a part.

    Parameters
    ----------
    part : Part, or its vertices
        What is oriented.
    bits : int, optional
        Bits of the sensor; default: it reads the exact diameter.
    noise : rational, default 0
        Standard deviation of its noise, as a share of its range.
    sd : rational, optional
        Instead: the standard deviation as a length.
    between : pair of rationals, optional
        The sensor's range; default: that of the part's diameters.
    cost_ratio : rational, default 1
        Cost of the filter, c, in units of one squeeze.
    sensor_cost : rational, default 0
        Cost of a look.
    prior : Prior, optional
        Of the orientations before the first squeeze, which is then made at angle 0.
    accepted : sequence of state labels, optional
        Orientations that the filter can be set to; default: every stable one.
    digits : int, default 15
        Decimals of the likelihoods of a noisy sensor.

    Attributes
    ----------
    part : Part
        What is oriented.
    orienting : OrientingProblem
        States, prior, and the classes of squeezes. Where the squeeze function has a period of less
        than half a turn, which a sensor may well notice, squeezes at angles of a whole turn.
    sensor : Sensor
        The sensor.
    squared_diameters : dict from state labels to mpq
        What it measures, squared.
    covered : JawRange
        The sensor's range.
    deviation : mpq
        Standard deviation of its noise, as a length.

    Examples
    --------
    >>> problem = SensingProblem([(0, 0), (3, 0), (3, 2), (0, 2)], bits=1, noise="0.1")
    >>> [problem.plan(moves).decimal(6) for moves in (0, 1, 2)]
    ['6.393188', '4.000001', '4.000001']
    """

    def __init__(
        self,
        part: PartLike,
        bits: int | None = None,
        noise: RationalLike = 0,
        *,
        sd: RationalLike | None = None,
        between: tuple[RationalLike, RationalLike] | None = None,
        cost_ratio: RationalLike = 1,
        sensor_cost: RationalLike = 0,
        prior: Prior | None = None,
        accepted: Iterable[Any] | None = None,
        digits: int = LIKELIHOOD_DIGITS,
    ) -> None:
        self.part = as_part(part)
        self.cost_ratio = as_cost_ratio(cost_ratio)
        diameter = DiameterFunction(self.part)
        transfer = squeeze_function(diameter)
        self.orienting: OrientingProblem = planning_problem_of_transfer(
            transfer, prior=prior, all_periods=transfer.order > 2, name=self.part.name
        )
        states = "a list of states"
        self.accepted = None if accepted is None else tuple(as_list(accepted, states, "accepted"))
        self.squared_diameters = {
            label: diameter.squared(theta) for label, theta in self.states.items()
        }
        check_rational(self.squared_diameters)
        self.bits = bits
        self.covered = covered_range(between, self.squared_diameters)
        self.deviation = noise_deviation(noise, sd, self.covered)
        self.sensor = sensor_of_diameters(
            self.squared_diameters,
            bits,
            noise,
            sd=sd,
            between=between,
            cost=sensor_cost,
            digits=digits,
        )

    def __repr__(self) -> str:
        name = f" for {self.part.name}" if self.part.name else ""
        problem, readings = self.orienting.problem, len(self.sensor.readings)
        return (
            f"<SensingProblem{name}: {len(problem.states)} orientations, {len(problem.actions)} "
            f"squeezes, a sensor of {readings} reading{'s' if readings != 1 else ''}>"
        )

    @property
    def round_cost(self) -> Any:
        """Cost of the random first squeeze and of the filter."""
        return self.cost_ratio + 1

    @property
    def states(self) -> dict[Any, Angle]:
        """The stable orientations by their labels."""
        return self.orienting.orientations

    @cached_property
    def one_step(self) -> OneStepPlan:
        """The plan that squeezes once, looks once, and accepts the most likely orientation."""
        return one_step_plan(
            self.sensor,
            self.orienting.problem.prior,
            self.round_cost + self.sensor.cost,
            accepted=self.accepted,
        )

    def plan(
        self,
        horizon: int | None = None,
        *,
        stages: Sequence[str] | None = None,
        good_enough: RationalLike | None = None,
        node_limit: int = NODE_LIMIT,
        time_limit: float | None = None,
        progress: Callable[[float], None] | None = None,
    ) -> SensorPlan:
        """Return the plan of least expected cost with so many moves after the first squeeze.

        Parameters
        ----------
        horizon, stages, good_enough, node_limit, time_limit, progress
            As for `iterative_sensor_plan`.
        """
        plan = iterative_sensor_plan(
            self.orienting.problem,
            {"diameter": self.sensor},
            horizon,
            stages=stages,
            round_cost=self.round_cost,
            accepted=self.accepted,
            good_enough=good_enough,
            node_limit=node_limit,
            time_limit=time_limit,
            progress=progress,
        )
        tree = replace(plan.tree, action_form="turn {}°, squeeze", decision_form="{}°")
        return replace(plan, tree=tree)

    def compare_orders(
        self, actions: int, *, mixed: SensorPlan | None = None, **settings: Any
    ) -> OrderComparison:
        """Return what looking before acting costs, and what looking after it (7.2.5).

        Parameters
        ----------
        actions : int
            Most squeezes after the first one, from 0 to 299.
        mixed : SensorPlan, optional
            The plan of ``actions + 1`` moves of any kind, if it is known.
        **settings
            Limits and progress, as for `plan`.

        Examples
        --------
        A sensor of one noisy bit is better used at the end, one of two good bits at the start:

        >>> part = [(52, 58), (0, 55), (8, 17), (51, 0)]
        >>> for bits, noise in ((1, "0.3"), (2, "0.05")):
        ...     found = SensingProblem(part, bits, noise).compare_orders(1)
        ...     print(found.sense_then_act.decimal(), found.act_then_sense.decimal())
        7.4164 6.3023
        5.0018 5.1314
        """
        actions = as_count(actions, "actions", least=0, most=MOST_MOVES - 1)  # and a look
        squeezes = ["act"] * actions

        def best(stages: Sequence[str]) -> SensorPlan:
            return self.plan(stages=stages, **settings)

        blind, first = best(squeezes), best(["sense", *squeezes])
        last = best([*squeezes, "sense"])
        whole = best(["any"] * (actions + 1)) if mixed is None else mixed
        for plan in (first, last):  # they are plans of that many moves, too
            if not whole.proven and plan.expected_cost < whole.expected_cost:
                whole = replace(plan, proven=False, lower_bound=whole.lower_bound)
        return OrderComparison(actions, blind, first, last, whole)
