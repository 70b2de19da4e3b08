"""The figures of Goldberg (1990), drawn, by name.

Drawings of the source did not survive in the copies at hand; parts are those of the catalogue, and
where the source does not name a part one of them stands in. The flow charts of Figs. 5.1 and 5.8
are code, and Fig. 6.4 is a table of numbers.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from types import MappingProxyType
from typing import TYPE_CHECKING, Final, final

from stochgeom.decision.decision_rules import DecisionProblem
from stochgeom.decision.goal_costs import GoalCost
from stochgeom.decision.iterative_costs import IterativeCost
from stochgeom.decision.piecewise_prior import PiecewisePrior
from stochgeom.decision.plan_costs import PlanCost
from stochgeom.decision.planning_problem import PlanningProblem
from stochgeom.feeding.planner import plan_feeding
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.geometry.part import Part
from stochgeom.plotting.analysis_pictures import (
    draw_analysis,
    draw_phase_one,
    draw_push_grasp_analysis,
)
from stochgeom.plotting.axes import need_matplotlib
from stochgeom.plotting.block_pictures import draw_scooped_blocks, draw_sensed_blocks
from stochgeom.plotting.closure_pictures import draw_closure, draw_monotone_step
from stochgeom.plotting.decision_pictures import draw_risks, draw_sensor_density
from stochgeom.plotting.density_pictures import draw_beta_density
from stochgeom.plotting.feeder_pictures import draw_feeder
from stochgeom.plotting.function_pictures import (
    draw_diameter,
    draw_radius,
    draw_step_function,
)
from stochgeom.plotting.pictures import (
    draw_closing,
    draw_funnel,
    draw_gripper,
    draw_sliding_jaw,
    draw_stable_grasps,
    draw_trace,
    draw_uncertain_grasp,
)
from stochgeom.plotting.stability_pictures import (
    draw_grasp_diagram,
    draw_push_density,
    draw_push_stability,
    draw_squeeze_stability,
)
from stochgeom.plotting.tilting_pictures import draw_tilting, draw_tilts, draw_tray
from stochgeom.plotting.tree_pictures import draw_all_plans, draw_open_loop_plans
from stochgeom.sensing.and_or_tree import all_sensor_plans
from stochgeom.sensing.sensing_problem import SensingProblem
from stochgeom.sensing.sensors import Sensor
from stochgeom.thesis.appendix_e import figure_e_5, figure_e_8
from stochgeom.thesis.chapter_6 import figure_6_4_model
from stochgeom.thesis.figures_4 import figure_4_6
from stochgeom.thesis.parts import catalogue_part
from stochgeom.transfer.push import push_function
from stochgeom.transfer.squeeze import squeeze_function
from stochgeom.transfer.step_function import StepFunction

if TYPE_CHECKING:
    from matplotlib.axes import Axes

Drawing = Callable[[], "Axes | str"]

SQUARE: Final = ((0, 0), (1, 0), (1, 1), (0, 1))

NINE_SIDED: Final = ((0, 1), (2, 0), (3, 0), (7, 1), (8, 3), (7, 5), (5, 8), (1, 6), (0, 2))
"""A stand-in for the part of Fig. 5.11, of which the source prints no number.

Ours, not the source's, so it is no part of the catalogue: convex, without parallel edges, seven
steps in half a turn, and five squeezes orient it up to symmetry.
"""

RECTANGLE_STARTS: Final = ("75", "110", "165", "220")
"""Initial orientations of Figs. 1.1 and 4.1, degrees: they end alike, though far apart."""


@final
@dataclass(frozen=True, slots=True)
class SourceFigure:
    """A figure of the source that can be drawn.

    Attributes
    ----------
    name, title : str
        Such as ``"fig4.6"``, and what it shows.
    draw : callable
        Returns axes of a new figure, or the text of an SVG picture.
    """

    name: str
    title: str
    draw: Drawing


def _first(axes: tuple[Axes, ...]) -> Axes:
    return axes[0]


def _plan(name: str) -> FeedingPlan:
    return FeedingProblem(catalogue_part(name)).geometric_plan()


def _traces_of_the_rectangle() -> Axes:
    return draw_trace(_plan("rectangle"), orientations=RECTANGLE_STARTS)


def _two_axes() -> tuple[Axes, Axes]:
    """Return axes one under the other."""
    need_matplotlib()
    import matplotlib.pyplot as plt

    _, (top, bottom) = plt.subplots(2, figsize=(6.4, 6.4), layout="constrained")
    return top, bottom


def _diameter_and_squeeze() -> Axes:
    top, bottom = _two_axes()
    draw_diameter(catalogue_part("4gon"), top)
    draw_step_function(squeeze_function(catalogue_part("4gon")), bottom, name="squeeze")
    return top


def _radius_and_push() -> Axes:
    top, bottom = _two_axes()
    draw_radius(catalogue_part("4gon"), top)
    draw_step_function(push_function(catalogue_part("4gon")), bottom, name="push")
    return top


def _squeezes(name: str) -> StepFunction:
    return squeeze_function(catalogue_part(name))


def _analysis(name: str) -> Axes:
    return _first(draw_analysis(FeedingProblem(catalogue_part(name))))


def _nine_sided_analysis() -> Axes:
    top, *_ = draw_analysis(FeedingProblem(Part(NINE_SIDED)))
    top.set_title("a 9-sided stand-in: the source prints no number of its part")
    return top


def _push_grasp_analysis(name: str) -> Axes:
    return _first(draw_push_grasp_analysis(catalogue_part(name, appendix="E")))


def _push_preimages(name: str) -> Axes:
    problem = FeedingProblem(catalogue_part(name, appendix="E"), "push-grasp")
    return _first(draw_analysis(problem))


def _sensor_tree() -> str:
    """Return the SVG text of the tree of one look at the jaws and one squeeze of the 4gon."""
    problem = SensingProblem(catalogue_part("4gon"), 2, "0.05")
    return problem.compare_orders(1).sense_then_act.tree.svg()


def _push_and_shake(cost: PlanCost) -> PlanningProblem:
    """Return a problem of three states in a row: a push moves to the right, mostly."""
    third = ["1/3", "1/3", "1/3"]
    push = [["1/4", "3/4", 0], [0, "1/4", "3/4"], [0, 0, 1]]
    return PlanningProblem(
        ["left", "middle", "right"], third, ["push", "shake"], {"push": push, "shake": [third] * 3},
        cost,
    )  # fmt: skip


def _open_loop_plans() -> Axes:
    return draw_open_loop_plans(_push_and_shake(GoalCost("right", actions="1/10")), 2)


def _all_plans() -> Axes:
    """Return all plans of two moves: to push, to shake, to look whether it is at the right."""
    problem = _push_and_shake(IterativeCost("right", actions=1, test=2))
    eye = Sensor.from_function(
        problem.states, lambda state: "yes" if state == "right" else "no", cost="1/10"
    )
    return draw_all_plans(all_sensor_plans(problem, eye, 2), digits=2)


def _risks_of_two_rules() -> Axes:
    """Return the risks of trusting a test, and of looking no further than the costs."""
    test = DecisionProblem(
        ["good", "bad"], ["pass", "fail"], ["keep", "throw"],
        [["9/10", "1/10"], ["1/5", "4/5"]], [[0, 2], [3, 0]],
    )  # fmt: skip
    rules = [{"pass": "keep", "fail": "throw"}, {"pass": "keep", "fail": "keep"}]
    return draw_risks(test, rules)


def _figure_f_1() -> Axes:
    prior = PiecewisePrior.from_histogram(
        ["0", "60", "120", "180", "240", "300", "360"], [1, 3, 6, 4, 2, 1]
    )
    return draw_funnel(plan_feeding(catalogue_part("house"), prior=prior), prior=prior)


_DRAWN: Final[tuple[tuple[str, str, Drawing], ...]] = (
    ("1.1", "a two-step plan orients the rectangle", _traces_of_the_rectangle),
    ("1.2", "a sensor reading maps a distribution",
     lambda: draw_sensed_blocks([1, 1, 1, 1, 1], [1, 2, 6, 2, 1])),
    ("1.3", "an action maps a distribution",
     lambda: draw_scooped_blocks([1, 1, 1, 1, 1], [1, 1, 1, 3, 3])),
    ("2.1", "all plans of two actions, as a tree", _open_loop_plans),
    ("3.1", "a parallel-jaw gripper", draw_gripper),
    ("3.2", "a small error is cancelled", lambda: draw_uncertain_grasp(SQUARE, 0, "20")),
    ("3.3", "a large error is not", lambda: draw_uncertain_grasp(SQUARE, 0, "50")),
    ("3.4", "a square wedged, and stable", lambda: draw_sliding_jaw(SQUARE, 40)),
    ("3.5", "push-stability diagram of a square", lambda: draw_push_stability(SQUARE)),
    ("3.6", "squeeze-stability diagram of a square, mu = 1/4",
     lambda: draw_squeeze_stability(SQUARE, "1/4")),
    ("3.7", "squeeze-grasp diagram of a square, mu = 1/4",
     lambda: draw_grasp_diagram(SQUARE, "1/4")),
    ("4.1", "a two-step plan orients the rectangle", _traces_of_the_rectangle),
    ("4.2", "a feeder that carries out the plan of the 4gon", lambda: draw_feeder(_plan("4gon"))),
    ("4.3", "diameter function of the 4gon", lambda: draw_diameter(catalogue_part("4gon"))),
    ("4.4", "diameter and squeeze function of the 4gon", _diameter_and_squeeze),
    ("4.5", "two squeezes of the house", lambda: draw_trace(_plan("house"))),
    ("4.6", "four squeezes of the 4gon", lambda: draw_trace(figure_4_6().plan)),
    ("5.2", "squeeze function of the rectangle",
     lambda: draw_step_function(_squeezes("rectangle"), name="squeeze")),
    ("5.3", "its widest step", lambda: draw_phase_one(_squeezes("rectangle"), 1)),
    ("5.4", "the widest arc with a narrower image",
     lambda: draw_phase_one(_squeezes("rectangle"), 2)),
    ("5.5", "the closure of a set that the plan of the 4gon collapses",
     lambda: draw_closure(_plan("4gon"))),
    ("5.6", "its parts keep their order under a step", lambda: draw_monotone_step(_plan("4gon"))),
    ("5.7", "a plan as a funnel", lambda: draw_funnel(_plan("4gon"))),
    ("5.9", "geometric analysis of the 4gon", partial(_analysis, "4gon")),
    ("5.10", "geometric analysis of the 5gon", partial(_analysis, "5gon")),
    ("5.11", "geometric analysis of a 9-sided stand-in, the source's part being lost",
     _nine_sided_analysis),
    ("6.1", "a robot tilts a tray, from the side", draw_tilting),
    ("6.2", "the twelve states of a tile in a tray", draw_tray),
    ("6.3", "outcomes of tilt 1 from state 7", lambda: draw_tilts(figure_6_4_model(), 7, [1])),
    ("7.1", "a plan of one look and one squeeze, as a tree", _sensor_tree),
    ("7.2", "density of a noisy sensor", lambda: draw_sensor_density(2, 1)),
    ("7.3", "the readings of a 2-bit sensor", lambda: draw_sensor_density(2, 1, [1, 2, 3])),
    ("7.4", "all plans of two moves, sensing or acting, as a tree", _all_plans),
    ("A.1", "risks of two decision rules", _risks_of_two_rules),
    ("B.1", "the standard gripper", draw_gripper),
    ("B.2", "a hex nut wedged, and stable", lambda: draw_sliding_jaw(Part.regular(6), 20)),
    ("B.3", "the gripper with a sliding jaw", lambda: draw_gripper(sliding=True)),
    ("B.4", "it closes on a hex nut", lambda: draw_closing(Part.regular(6), 20)),
    ("C.1", "density after a push of the house",
     lambda: draw_push_density(catalogue_part("house"))),
    ("D.1", "diameter function of the 4gon", lambda: draw_diameter(catalogue_part("4gon"))),
    ("D.2", "stable grasps of the 4gon", lambda: draw_stable_grasps(catalogue_part("4gon"))),
    ("E.1", "radius function of the 4gon", lambda: draw_radius(catalogue_part("4gon"))),
    ("E.2", "radius and push function of the 4gon", _radius_and_push),
    ("E.3", "push-grasp analysis of the 4gon", partial(_push_grasp_analysis, "4gon")),
    ("E.4", "preimages of the 4gon's push-grasps", partial(_push_preimages, "4gon")),
    ("E.5", "push-grasps of the 4gon", lambda: draw_trace(figure_e_5().plan)),
    ("E.6", "push-grasp analysis of the house", partial(_push_grasp_analysis, "house")),
    ("E.7", "preimages of the house's push-grasps", partial(_push_preimages, "house")),
    ("E.8", "push-grasps of the house", lambda: draw_trace(figure_e_8().plan)),
    ("F.1", "a funnel under a prior", _figure_f_1),
    ("G.1", "Beta density, alpha = 1, 1", lambda: draw_beta_density(1, 1)),
    ("G.2", "Beta density, alpha = .1, .1", lambda: draw_beta_density("0.1", "0.1")),
    ("G.3", "Beta density, alpha = 16, 16", lambda: draw_beta_density(16, 16)),
    ("G.4", "Beta density, alpha = 4, 1", lambda: draw_beta_density(4, 1)),
)  # fmt: skip

SOURCE_FIGURES: Final[Mapping[str, SourceFigure]] = MappingProxyType(
    {f"fig{number}": SourceFigure(f"fig{number}", title, draw) for number, title, draw in _DRAWN}
)
"""The figures that are drawn, by name, in the order of the source."""
