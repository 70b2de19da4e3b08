"""Grasps as uncertain actions: pushing as control uncertainty, and plans of such grasps.

The states are the stable orientations and one more, *wedged*, which is never left: the filter
rejects a wedged part. A grasp at angle a turns a state sigma into sigma - a; either jaw touches
first with probability 1/2, pushes as in App. C, and the squeeze follows. So each action has a
matrix of conditional probabilities (thesis 4.9.2). They change with a; which of them are zero
changes only where some sigma - a crosses a critical orientation of the diagrams. Angles between two
such crossings make one *class*, which the simplest angle near its middle stands for.

A plan begins with a grasp at a random angle. Plans are searched level by level. Floats only choose
candidates: probabilities within the proven error of the best are computed again by balls, and what
balls of 512 bits do not tell apart counts as equal, the first one found being taken.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property
from itertools import pairwise
from typing import Any, Final, final

import flint
import numpy as np
from numpy.typing import NDArray

from stochgeom.decision.costs import as_cost_ratio
from stochgeom.decision.probabilities import Atom, Enclosed
from stochgeom.errors import InputError, NoPlanError
from stochgeom.exact.angles import FULL_TURN, Angle
from stochgeom.exact.balls import Ball, ball_sign, working_precision
from stochgeom.exact.directions import nominal_angle
from stochgeom.exact.scalars import RationalLike
from stochgeom.exact.sums import AngleSum, Probability
from stochgeom.geometry.part import PartLike
from stochgeom.grasping.friction import FrictionLike
from stochgeom.grasping.grasp_diagram import GraspDiagram
from stochgeom.grasping.pushed_rows import PushedRows, as_probability
from stochgeom.grasping.pushing_model import average, pushing_bounds
from stochgeom.grasping.squeeze_stability import WEDGED, StableEdge

NODE_LIMIT: Final = 200_000
"""Hyperstates of one level beyond which only the best are kept."""

MOST_TIES: Final = 64
"""Candidates that floats do not tell apart and balls compare; the others count as equal."""

COMPARE_BITS: Final = (128, 512)
"""Precisions with which balls compare."""


@final
@dataclass(frozen=True, slots=True)
class GraspClass:
    """Angles of the gripper that bring the states into the same cells of the diagrams.

    Attributes
    ----------
    angle : Angle
        The simplest angle near the middle, for which the matrix is computed.
    low, high : Angle
        The class is the open interval between them.
    """

    angle: Angle
    low: Angle
    high: Angle


@final
@dataclass(frozen=True)
class UncertainPlan:
    """A random grasp followed by grasps at given angles.

    Attributes
    ----------
    actions : tuple of GraspClass
        The grasps after the random one.
    state : StableEdge
        The stable orientation that is most likely in the end.
    probability : Probability
        How likely it is, enclosed.
    complete : bool
        Whether all plans of this length were compared.
    """

    actions: tuple[GraspClass, ...]
    state: StableEdge
    probability: Probability
    complete: bool

    @property
    def steps(self) -> int:
        """The number of grasps, the random one included."""
        return len(self.actions) + 1


@final
class UncertainGrasps:
    """The grasps of a part with friction as a finite decision problem.

    Parameters
    ----------
    part : Part, or its vertices
        Only its hull and its centre of mass matter.
    mu : rational, Angle or Friction
        The coefficient of friction, 0 or more, or the friction angle.

    Notes
    -----
    O(n^2) classes: the number of states times that of critical orientations.

    Examples
    --------
    >>> grasps = UncertainGrasps([(0, 0), (3, 0), (3, 2), (0, 2)], "1/4")
    >>> len(grasps.states), len(grasps.classes), grasps.first[4].decimal()
    (4, 28, '0.0596')
    >>> plan = grasps.best_plan(2)
    >>> plan.actions[0].angle.degrees(0), plan.probability.decimal()
    ('45', '0.4417')
    """

    def __init__(self, part: PartLike, mu: FrictionLike) -> None:
        self.diagram = GraspDiagram(part, mu)
        self.states: tuple[StableEdge, ...] = self.diagram.stable
        starts = self.diagram.squeeze.contacts.starts
        number = {edge.orientation: k for k, edge in enumerate(self.states)}
        self._column = {p: number[theta] for p, theta in enumerate(starts) if theta in number}
        self._column[WEDGED] = len(self.states)
        squeeze = self.diagram.squeeze
        self._jaws = [PushedRows(push, squeeze) for push in self.diagram.jaws]

    @cached_property
    def classes(self) -> tuple[GraspClass, ...]:
        """The classes of gripper angles in [0, 360) degrees, by their lower ends."""
        diagram = self.diagram
        critical = {*diagram.squeeze.angles}
        for push in diagram.jaws:
            critical.update(push.critical)
        ends = sorted(
            {(edge.orientation - theta).reduced() for edge in self.states for theta in critical}
        )
        closed = [*ends, ends[0] + FULL_TURN]
        return tuple(
            GraspClass(nominal_angle(low, high), low, high) for low, high in pairwise(closed)
        )

    @cached_property
    def first(self) -> tuple[Probability, ...]:
        """The probabilities of the states after a random grasp, that of wedged last (App. C)."""
        found = [bound for _, bound in pushing_bounds(self.diagram)]
        rest: Any = AngleSum(1)
        for bound in found:
            rest = rest + bound.scaled(-1)
        return (*found, rest)

    def row(self, theta: Angle) -> tuple[Probability, ...]:
        """Return the probabilities of all states after a grasp of a part at theta, wedged last.

        Examples
        --------
        >>> grasps = UncertainGrasps([(0, 0), (3, 0), (3, 2), (0, 2)], "1/4")
        >>> [p.decimal() for p in grasps.row(Angle.from_degrees(50))]
        ['0.8455', '0.0000', '0.0000', '0.0000', '0.1545']
        """
        columns: list[list[Probability]] = [[] for _ in range(len(self.states) + 1)]
        for jaw in self._jaws:
            for outcome, share in jaw.shares(theta).items():
                columns[self._column[outcome]].append(as_probability(share))
        zeros = [AngleSum(0), AngleSum(0)]
        return tuple(average([*column, *zeros][:2]) for column in columns)

    def matrix(self, action: GraspClass) -> tuple[tuple[Probability, ...], ...]:
        """Return the conditional probabilities of an action: a row for each state, wedged last."""
        rows = [self.row((edge.orientation - action.angle).reduced()) for edge in self.states]
        last = (*(AngleSum(0) for _ in self.states), AngleSum(1))
        return (*rows, last)

    @cached_property
    def matrices(self) -> tuple[tuple[tuple[Probability, ...], ...], ...]:
        """The matrices of all classes."""
        return tuple(self.matrix(action) for action in self.classes)

    # --- search ----------------------------------------------------------------------------------

    @cached_property
    def _floats(self) -> NDArray[np.float64]:
        return np.array([[[float(p) for p in row] for row in matrix] for matrix in self.matrices])

    def best_plan(self, steps: int, *, node_limit: int = NODE_LIMIT) -> UncertainPlan:
        """Return the plan of so many grasps that makes one stable orientation most likely.

        Parameters
        ----------
        steps : int
            Number of grasps, the random one included; at least 1.
        node_limit : int
            Beyond so many hyperstates of one level only the best are kept, and the answer is not
            `complete`.

        Raises
        ------
        InputError
            If there are no steps or no nodes.
        """
        if steps < 1 or node_limit < 1:
            raise InputError(f"{steps} grasps and {node_limit} nodes; accepted: 1 or more of both")
        level = np.array([[float(number) for number in self.first]])
        words, complete = np.zeros((1, 0), dtype=np.intp), True
        for _ in range(steps - 1):
            if len(level) * len(self.classes) > node_limit:
                # The best ones, in their old order: ties go to the first.
                best = np.argsort(-level[:, :-1].max(axis=1), kind="stable")
                kept = np.sort(best[: max(1, node_limit // len(self.classes))])
                complete &= len(kept) == len(level)
                level, words = level[kept], words[kept]
            after = np.einsum("hs,ast->hat", level, self._floats)
            count = len(self.classes)
            letters = np.tile(np.arange(count), len(words))[:, None]
            words = np.concatenate((np.repeat(words, count, axis=0), letters), axis=1)
            level = after.reshape(-1, after.shape[2])
        word, state, number = self._certified(level[:, :-1], words)
        actions = tuple(self.classes[k] for k in word)
        return UncertainPlan(actions, self.states[state], number, complete)

    def _certified(
        self, worth: NDArray[np.float64], words: NDArray[np.intp]
    ) -> tuple[tuple[int, ...], int, Probability]:
        """Compare by balls what floats do not tell apart; return plan, state and probability."""
        size, steps = len(self.states) + 1, words.shape[1] + 1
        # Entries of matrices and of the first distribution are at most 1, rows sum to 1, and each
        # is a float within 2**-52; a step adds size + 2 roundings of numbers below 1 at most.
        margin = 2 * steps * (size + 3) * 2.0**-52
        places = np.argwhere(worth >= worth.max() - margin).tolist()
        found = [(tuple(words[node].tolist()), state) for node, state in places[:MOST_TIES]]
        best = found[0]
        number = self._probability(*best)
        for candidate in found[1:]:
            other = self._probability(*candidate)
            if _exceeds(other, number):
                best, number = candidate, other
        return *best, number

    def _probability(self, word: tuple[int, ...], state: int) -> Probability:
        """Return the probability of a state after a plan, as tightly as asked."""
        if not word:
            return self.first[state]

        def enclose() -> Ball:
            weights = [number.ball() for number in self.first]
            for k in word:
                columns = zip(*self.matrices[k], strict=True)
                weights = [
                    sum((w * p.ball() for w, p in zip(weights, column, strict=True)), flint.arb())
                    for column in columns
                ]
            return weights[state]

        return Enclosed([(1, Atom(("plan", self, word, state), enclose))])

    def cheapest_plan(
        self, most_steps: int, cost_ratio: RationalLike = 1, *, node_limit: int = NODE_LIMIT
    ) -> UncertainPlan:
        """Return the plan of least expected cost (i + c) / p among those of at most so many grasps.

        Equal costs: the fewest grasps. A part that ends wedged or in another orientation is
        rejected by the filter and tried again.

        Parameters
        ----------
        most_steps : int
            Most grasps, the random one included; at least 1.
        cost_ratio : rational
            c, the cost of the filter over that of a grasp, 0 or more.

        Raises
        ------
        InputError, CostError
            If there are no steps, or the cost ratio is negative.
        NoPlanError
            If no plan has a positive probability.
        """
        c = as_cost_ratio(cost_ratio)
        plans = [self.best_plan(i, node_limit=node_limit) for i in range(1, max(1, most_steps) + 1)]
        if most_steps < 1:
            raise InputError(f"{most_steps} grasps; accepted: 1 or more")
        best: UncertainPlan | None = None
        for plan in plans:
            if not _is_positive(plan.probability):
                continue
            # (i + c) / p < (j + c) / q  iff  (j + c) p > (i + c) q
            if best is None or _exceeds(
                plan.probability.scaled(best.steps + c), best.probability.scaled(plan.steps + c)
            ):
                best = plan
        if best is None:
            raise NoPlanError(f"with friction {self.diagram.friction} every grasp may end wedged")
        return best

    def __repr__(self) -> str:
        return f"UncertainGrasps({self.diagram.part!r}, {self.diagram.friction.angle!r})"


def _is_positive(number: Probability) -> bool:
    with working_precision(COMPARE_BITS[-1]):
        return bool(number.ball() > 0)


def _exceeds(first: Probability, second: Probability) -> bool:
    """Tell whether one number exceeds another; what balls do not tell apart counts as equal."""
    if isinstance(first, AngleSum) and isinstance(second, AngleSum):
        return first.compare(second) > 0
    for bits in COMPARE_BITS:
        with working_precision(bits):
            found = ball_sign(first.ball() - second.ball())
        if found is not None:
            return found > 0
    return False
