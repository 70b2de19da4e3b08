"""What notebooks show of a value: the table that the facade registers.

Small pictures and short tables; whoever wants more calls a drawing function or `to_html`.
"""

from __future__ import annotations

import os
from itertools import islice
from typing import Final

from stochgeom.decision.hyperstates import Hyperstate
from stochgeom.display import Renderers
from stochgeom.errors import NodeLimitError
from stochgeom.exact.cells import CellSet
from stochgeom.exact.ratios import TurnRatio
from stochgeom.exact.sums import AngleSum
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.feeding.preimages import Preimages
from stochgeom.geometry.diameter import DiameterFunction
from stochgeom.geometry.part import Part
from stochgeom.geometry.radius import RadiusFunction
from stochgeom.grasping.grasp_diagram import GraspDiagram
from stochgeom.grasping.push_stability import PushStability
from stochgeom.grasping.squeeze_stability import SqueezeStability
from stochgeom.plotting.and_or_scenes import and_or_scene
from stochgeom.plotting.distributions import distribution_scene
from stochgeom.plotting.function_scenes import bars_scene, step_scene, wave_scene
from stochgeom.plotting.part_scenes import part_scene
from stochgeom.plotting.rich_decisions import (
    decision_problem_html,
    planning_problem_html,
    recognition_problem_html,
    sensing_problem_html,
    sensor_plan_html,
)
from stochgeom.plotting.rich_html import MOST_PREIMAGES, counted, plan_html, problem_html
from stochgeom.plotting.silhouettes import size_is_drawn
from stochgeom.plotting.stability_scenes import (
    cells_scene,
    grasp_diagram_scene,
    push_scene,
    squeeze_scene,
)
from stochgeom.plotting.svg import svg_document
from stochgeom.plotting.tree_scenes import tree_scene
from stochgeom.sensing.and_or_tree import AndOrTree
from stochgeom.sensing.plan_tree import PlanTree
from stochgeom.transfer.step_function import StepFunction


def part_svg(part: Part) -> str:
    """Return a small picture of a part."""
    name = part.name or "a part"
    return svg_document(
        part_scene(part),
        title=name,
        description=f"{name}: outline of {len(part)} vertices, convex hull, centre of mass",
        scale=90.0,
    )


def step_function_svg(transfer: StepFunction) -> str:
    """Return the graph of a step function over a full turn."""
    return svg_document(
        step_scene(transfer),
        title=f"step function of {len(transfer)} steps in a period of {transfer.period}",
        scale=1.0,
    )


def wave_svg(function: DiameterFunction | RadiusFunction) -> str | None:
    """Return the graph of a diameter or radius function over a full turn, if floats hold it."""
    if not size_is_drawn(function.part):
        return None
    kind = "diameter" if isinstance(function, DiameterFunction) else "radius"
    name = function.part.name or "a part"
    return svg_document(wave_scene(function), title=f"{kind} function of {name}", scale=1.0)


def preimages_svg(chain: Preimages) -> str:
    """Return the preimages as bars; of a long chain the first."""
    return svg_document(bars_scene(islice(chain, MOST_PREIMAGES)), title="preimages", scale=1.0)


def hyperstate_svg(state: Hyperstate) -> str:
    """Return the distribution as bars over a full turn."""
    state = state.possible()
    return svg_document(
        distribution_scene(state),
        title=f"a distribution over {counted(len(state), 'orientation')}",
        description=", ".join(
            f"{theta.degrees(2)} degrees: {share}"
            for theta, share in list(zip(state.orientations, state.probabilities(), strict=True))[
                :24
            ]
        ),
        scale=44.0,
    )


def cells_svg(cells: CellSet) -> str:
    """Return a set of orientations as bars; of many intervals only what is seen."""
    return svg_document(cells_scene(cells), title=f"{cells!s:.200}", scale=1.0)


def push_svg(push: PushStability) -> str:
    """Return the push-stability diagram."""
    name = push.part.name or "a part"
    return svg_document(push_scene(push), title=f"push stability of {name}", scale=1.0)


def squeeze_svg(squeeze: SqueezeStability) -> str:
    """Return the squeeze-stability diagram."""
    name = squeeze.part.name or "a part"
    return svg_document(squeeze_scene(squeeze), title=f"squeeze stability of {name}", scale=1.0)


def grasp_diagram_svg(diagram: GraspDiagram) -> str:
    """Return the squeeze-grasp diagram."""
    name = diagram.part.name or "a part"
    scene = grasp_diagram_scene(diagram)
    return svg_document(scene, title=f"squeeze-grasp diagram of {name}", scale=1.0)


def tree_svg(tree: PlanTree, digits: int = 4) -> str:
    """Return a plan with sensors as a tree, whole."""
    return svg_document(tree_scene(tree, digits), title=repr(tree), scale=1.0)


def all_plans_svg(tree: AndOrTree, digits: int = 4) -> str | None:
    """Return the tree of all plans with sensors, nothing if it is too large for a picture."""
    try:
        return svg_document(and_or_scene(tree, digits), title=repr(tree), scale=1.0)
    except NodeLimitError:
        return None


def number_latex(number: TurnRatio | AngleSum) -> str:
    """Return an exact probability or cost as a formula."""
    import sympy

    return f"$\\displaystyle {sympy.latex(number.to_sympy())}$"


def plan_report(plan: FeedingPlan, path: str | os.PathLike[str], *, digits: int) -> None:
    """Write a plan as a page; see `stochgeom.plotting.report`."""
    from stochgeom.plotting.report import write_report

    write_report(plan, path, digits=digits)


RENDERERS: Final[Renderers] = {
    ("AndOrTree", "svg"): all_plans_svg,
    ("AngleSum", "latex"): number_latex,
    ("CellSet", "svg"): cells_svg,
    ("DecisionProblem", "html"): decision_problem_html,
    ("DiameterFunction", "svg"): wave_svg,
    ("FeedingPlan", "html"): plan_html,
    ("FeedingPlan", "report"): plan_report,
    ("FeedingProblem", "html"): problem_html,
    ("GraspDiagram", "svg"): grasp_diagram_svg,
    ("Hyperstate", "svg"): hyperstate_svg,
    ("Part", "svg"): part_svg,
    ("PlanTree", "svg"): tree_svg,
    ("PlanningProblem", "html"): planning_problem_html,
    ("Preimages", "svg"): preimages_svg,
    ("PushStability", "svg"): push_svg,
    ("RadiusFunction", "svg"): wave_svg,
    ("RecognitionProblem", "html"): recognition_problem_html,
    ("SensingProblem", "html"): sensing_problem_html,
    ("SensorPlan", "html"): sensor_plan_html,
    ("SqueezeStability", "svg"): squeeze_svg,
    ("StepFunction", "svg"): step_function_svg,
    ("TurnRatio", "latex"): number_latex,
}
