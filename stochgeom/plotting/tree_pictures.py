"""Plans as trees on matplotlib `Axes`; extra ``plot``.

All open-loop plans (thesis Fig. 2.1), a plan with sensors (Fig. 7.1), all of those (Fig. 7.4).
"""

from __future__ import annotations

from typing import TYPE_CHECKING

from stochgeom.arguments import expect
from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.plotting.and_or_scenes import and_or_scene
from stochgeom.plotting.axes import PIXEL, draw_scene, need_matplotlib
from stochgeom.plotting.hyperstate_trees import open_loop_scene
from stochgeom.plotting.tree_scenes import tree_scene
from stochgeom.sensing.and_or_tree import AndOrTree
from stochgeom.sensing.plan_tree import PlanTree
from stochgeom.sensing.sensor_plan import SensorPlan

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def draw_open_loop_plans(problem: PlanningProblem, stages: int, ax: Axes | None = None) -> Axes:
    """Draw all plans of so many actions as a tree of hyperstates (Fig. 2.1).

    The bars in a box are the probabilities of the states. Of a problem with a cost, each plan's
    cost stands at its end and the cheapest plans are heavy, decided exactly.

    Parameters
    ----------
    problem : PlanningProblem
        States, prior, actions; a cost or none.
    stages : int
        The number of actions of each plan.
    ax : Axes, optional
        Where; default: on a new figure.

    Raises
    ------
    InputError
        If the number of actions is none.
    NodeLimitError
        If there are more than 81 plans.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> from stochgeom.decision.additive_costs import AdditiveCost
    >>> turn = PlanningProblem.from_matrices(
    ...     ["1/4", "3/4"], {"turn": [[0, 1], [1, 0]], "wait": [[1, 0], [0, 1]]},
    ...     cost=AdditiveCost(states={"1": 1}),
    ... )
    >>> ax = draw_open_loop_plans(turn, 1, Figure().subplots())
    >>> [text.get_text() for text in ax.texts]
    ['turn', 'wait', 'cost 0.2500', 'cost 0.7500']
    """
    need_matplotlib()
    return draw_scene(open_loop_scene(problem, stages), ax, inches=PIXEL)


def draw_plan_tree(tree: PlanTree | SensorPlan, ax: Axes | None = None, *, digits: int = 4) -> Axes:
    """Draw a plan with sensors as a tree (Fig. 7.1).

    Boxes are actions, hexagons sensings, round boxes ends; an arc joins the branches of a sensing,
    which all belong to the plan.

    Parameters
    ----------
    tree : PlanTree or SensorPlan
        The plan.
    ax : Axes, optional
        Where; default: on a new figure.
    digits : int
        Decimals of the probabilities.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> from gmpy2 import mpq
    >>> from stochgeom.sensing.tree_nodes import Leaf
    >>> tree = PlanTree(Leaf((mpq(1),), "up", mpq(1)), ("up",))
    >>> draw_plan_tree(tree, Figure().subplots(), digits=1).texts[0].get_text()
    'accept up (1.0)'
    """
    need_matplotlib()
    found = tree.tree if isinstance(tree, SensorPlan) else tree
    found = expect(found, PlanTree, "a PlanTree, such as sensor_plan(problem, sensor, 2).tree")
    return draw_scene(tree_scene(found, digits), ax, inches=PIXEL)


def draw_all_plans(tree: AndOrTree, ax: Axes | None = None, *, digits: int = 4) -> Axes:
    """Draw all plans with sensors as an AND/OR tree of hyperstates (Fig. 7.4).

    The bars in a box are the probabilities of the states. A branch is an action or, in a bundle
    with an arc across it, a reading of one look at a sensor. Of a problem with a cost, the ways of
    the cheapest plans are heavy, decided exactly, and so are the boxes where one of them ends.

    Parameters
    ----------
    tree : AndOrTree
        From `all_sensor_plans`.
    ax : Axes, optional
        Where; default: on a new figure.
    digits : int
        Decimals of probabilities and costs.

    Raises
    ------
    NodeLimitError
        If more than 120 nodes stand at the horizon.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> from stochgeom.decision.additive_costs import AdditiveCost
    >>> from stochgeom.sensing.and_or_tree import all_sensor_plans
    >>> from stochgeom.sensing.sensors import Sensor
    >>> coin = PlanningProblem(
    ...     ["heads", "tails"], ["1/2", "1/2"], ["turn"], [[[0, 1], [1, 0]]],
    ...     AdditiveCost(actions="1/8", states={"tails": 1}))
    >>> tree = all_sensor_plans(coin, Sensor.perfect(coin.states, cost="1/16"), 1)
    >>> ax = draw_all_plans(tree, Figure().subplots(), digits=2)
    >>> [text.get_text() for text in ax.texts if "(" in text.get_text()]
    ['heads (0.50)', 'tails (0.50)', 'end (0.50)', 'end (0.50)', 'end (0.00)', 'end (1.00)']
    """
    need_matplotlib()
    tree = expect(tree, AndOrTree, "an AndOrTree, such as all_sensor_plans(problem, sensor, 2)")
    return draw_scene(and_or_scene(tree, digits), ax, inches=PIXEL)
