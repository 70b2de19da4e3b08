"""All that is asked about the grasp of one part, computed when it is looked at."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import cached_property
from typing import final

from gmpy2 import mpq

from stochgeom.arguments import expect
from stochgeom.decision.priors import Prior
from stochgeom.errors import InputError
from stochgeom.exact.angles import HALF_TURN, ZERO, Angle
from stochgeom.exact.cells import CellSet
from stochgeom.exact.scalars import RationalLike, rational
from stochgeom.exact.sums import AngleSum, Probability
from stochgeom.geometry.part import PartLike
from stochgeom.grasping.friction import FrictionLike
from stochgeom.grasping.friction_bounds import GuaranteedBound
from stochgeom.grasping.friction_limits import FrictionLimit, as_probability
from stochgeom.grasping.grasp_diagram import GraspDiagram, GraspTolerance
from stochgeom.grasping.pushing_model import pushing_bound, pushing_bounds
from stochgeom.grasping.pushing_over_friction import PushingBound
from stochgeom.grasping.squeeze_stability import StableEdge


@final
class GraspReport:
    """The grasp of a part: diagram, bounds, tolerance, and what else is asked.

    Parameters
    ----------
    part : Part, or its vertices
        Only its hull and its centre of mass matter.
    mu : rational, Angle or Friction
        The coefficient of friction, 0 or more, or the friction angle.
    tolerance : Angle, or degrees as an exact number, optional
        Error of the part's orientation, either way; from 0 to 180 degrees.
    prior : Prior, optional
        Of the initial orientation, for the bound under it.
    probability : rational, optional
        Asks for the largest friction that guarantees it.

    Raises
    ------
    InputError
        If one of them is not acceptable; the message says which.

    Examples
    --------
    >>> report = GraspReport([(0, 0), (1, 0), (1, 1), (0, 1)], "0.25", tolerance="10")
    >>> report.pushing_bound.decimal(), bool(report.grasps)
    ('0.9453', True)
    """

    def __init__(
        self,
        part: PartLike,
        mu: FrictionLike,
        *,
        tolerance: Angle | RationalLike | None = None,
        prior: Prior | None = None,
        probability: RationalLike | None = None,
    ) -> None:
        self.tolerance = None if tolerance is None else _tolerance(tolerance)
        if prior is not None:
            expect(prior, Prior, "a prior, such as WrappedNormal('30', '12')", "prior")
        self.prior = prior
        self.probability: mpq | None = None if probability is None else as_probability(probability)
        self.diagram = GraspDiagram(part, mu)

    def compute(self) -> Iterator[float]:
        """Compute all that was asked; yield the share that is done, from 0 to 1."""
        stages: list[Callable[[], object]] = [
            lambda: self.diagram.bound,
            lambda: self.diagram.strict_bound,
            lambda: self.pushing_bound,
            lambda: self.pushing_bounds,
            lambda: self.tolerances,
        ]
        if self.prior is not None:
            stages.append(lambda: self.prior_bound)
        if self.probability is not None:
            stages += [lambda: self.largest_mu, lambda: self.largest_mu_pushing]
        for done, stage in enumerate(stages, start=1):
            stage()
            yield done / len(stages)

    @cached_property
    def tolerances(self) -> tuple[GraspTolerance, ...]:
        """The grasps that bear the largest error of the orientation."""
        return self.diagram.largest_tolerances()

    @cached_property
    def grasps(self) -> CellSet:
        """Angles of the gripper, relative to the part's input pose, that bear the tolerance."""
        if self.tolerance is None:
            raise InputError("no tolerance was given")
        orientations = self.diagram.grasps_bearing(self.tolerance)
        return orientations.reflect()

    @cached_property
    def pushing_bound(self) -> Probability:
        """The bound under the uniform pushing model."""
        return pushing_bound(self.diagram)

    @cached_property
    def pushing_bounds(self) -> tuple[tuple[StableEdge, Probability], ...]:
        """The same for each stable orientation."""
        return pushing_bounds(self.diagram)

    @cached_property
    def prior_bound(self) -> Probability:
        """The bound under the prior."""
        if self.prior is None:
            raise InputError("no prior was given")
        return self.diagram.bound_under(self.prior)

    @cached_property
    def largest_mu(self) -> FrictionLimit | None:
        """The largest friction under which the bound is at least the probability; None: any."""
        return self._bound_over_friction.largest_friction(self._asked())

    @cached_property
    def _bound_over_friction(self) -> GuaranteedBound:
        return GuaranteedBound(self.diagram.part)

    @property
    def limit(self) -> AngleSum:
        """What the bound goes to as the friction goes to 0, where it is 1."""
        return self._bound_over_friction.limit

    @cached_property
    def largest_mu_pushing(self) -> FrictionLimit | None:
        """The same under the uniform pushing model."""
        return PushingBound(self.diagram.part).largest_friction(self._asked())

    def _asked(self) -> mpq:
        if self.probability is None:
            raise InputError("no probability was given")
        return self.probability


def _tolerance(value: Angle | RationalLike) -> Angle:
    angle = (
        value
        if isinstance(value, Angle)
        else Angle.from_degrees(rational(value, where="tolerance"))
    )
    if not ZERO <= angle <= HALF_TURN:
        raise InputError(f"{angle!s:.40}; accepted: from 0 to 180 degrees", where="tolerance")
    return angle
