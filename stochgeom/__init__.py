"""stochgeom: exact planning for feeding, grasping and sensing planar parts.

The public names, each imported when it is first used, so that ``import stochgeom`` is quick.

Examples
--------
>>> import stochgeom as sg
>>> plan = sg.plan_feeding([(0, 0), (3, 0), (3, 2), (0, 2)])
>>> plan.expected_cost.decimal(2)
'6.00'
"""

from __future__ import annotations

from importlib import import_module
from typing import TYPE_CHECKING, Any

__version__ = "0.1.0"

if TYPE_CHECKING:
    from stochgeom.decision.callable_prior import CallablePrior
    from stochgeom.decision.density_priors import VonMises, WrappedNormal
    from stochgeom.decision.discrete_prior import DiscretePrior
    from stochgeom.decision.hyperstates import Hyperstate
    from stochgeom.decision.mixture_prior import MixturePrior
    from stochgeom.decision.piecewise_prior import PiecewisePrior
    from stochgeom.decision.prior_estimates import PriorEstimate, cells_between
    from stochgeom.decision.priors import Prior, Window, uniform_prior
    from stochgeom.decision.rejections import Observation, Rejections
    from stochgeom.errors import StochgeomError
    from stochgeom.exact.algebraic import Algebraic
    from stochgeom.exact.angles import EIGHTH_TURN, FULL_TURN, HALF_TURN, QUARTER_TURN, ZERO, Angle
    from stochgeom.exact.arcs import Arc, ClosedArc, union_arcs, union_measure
    from stochgeom.exact.forms import sign_of_form
    from stochgeom.exact.ratios import TurnRatio
    from stochgeom.exact.scalars import from_float_exact, from_float_shortest, rational
    from stochgeom.exact.sums import AngleSum
    from stochgeom.exact.surds import exact_scalar
    from stochgeom.exact.vectors import AngleVector
    from stochgeom.feeding.actions import Action
    from stochgeom.feeding.adversarial import FAMILIES
    from stochgeom.feeding.grasp_costs import plan_weighing_grasps, stability_costs
    from stochgeom.feeding.gripper_error import ErrorBound
    from stochgeom.feeding.nearby_courses import PartErrorReport
    from stochgeom.feeding.part_errors import tolerance_of
    from stochgeom.feeding.planner import orient_up_to_symmetry, plan_feeding, plan_transfer
    from stochgeom.feeding.plans import FeedingPlan
    from stochgeom.feeding.preimages import Preimage, Preimages, preimages
    from stochgeom.feeding.problem import FeedingProblem
    from stochgeom.feeding.reports import PlanReport
    from stochgeom.feeding.stability import StableGrasp, most_stable_grasps, stable_grasps
    from stochgeom.feeding.verification import check_claim, parse_angles, verify_plan
    from stochgeom.geometry.calipers import antipodal_pairs
    from stochgeom.geometry.diameter import DiameterFunction, Sinusoid
    from stochgeom.geometry.hull import ConvexHull, convex_hull
    from stochgeom.geometry.part import Part
    from stochgeom.geometry.radius import RadiusFunction, RadiusPiece
    from stochgeom.io.load import load_part
    from stochgeom.io.outlines import parse_outline, read_outline
    from stochgeom.plotting.analysis_pictures import (
        draw_analysis,
        draw_phase_one,
        draw_push_grasp_analysis,
    )
    from stochgeom.plotting.axes import save_figure
    from stochgeom.plotting.density_pictures import draw_beta_density
    from stochgeom.plotting.function_pictures import (
        draw_diameter,
        draw_distribution,
        draw_preimages,
        draw_radius,
        draw_step_function,
    )
    from stochgeom.plotting.pictures import (
        draw_closing,
        draw_funnel,
        draw_grasp,
        draw_gripper,
        draw_part,
        draw_scooped_blocks,
        draw_sensed_blocks,
        draw_sliding_jaw,
        draw_stable_grasps,
        draw_trace,
        draw_uncertain_grasp,
    )
    from stochgeom.thesis.parts import catalogue_names, catalogue_part
    from stochgeom.transfer.push import push_function
    from stochgeom.transfer.push_grasp import push_grasp_function
    from stochgeom.transfer.squeeze import squeeze_function
    from stochgeom.transfer.step_function import StepFunction

_HOMES = {
    "Algebraic": "exact.algebraic",
    "AngleSum": "exact.sums",
    "exact_scalar": "exact.surds",
    "CallablePrior": "decision.callable_prior",
    "DiscretePrior": "decision.discrete_prior",
    "MixturePrior": "decision.mixture_prior",
    "Observation": "decision.rejections",
    "PiecewisePrior": "decision.piecewise_prior",
    "Prior": "decision.priors",
    "PriorEstimate": "decision.prior_estimates",
    "Rejections": "decision.rejections",
    "cells_between": "decision.prior_estimates",
    "VonMises": "decision.density_priors",
    "Window": "decision.priors",
    "WrappedNormal": "decision.density_priors",
    "uniform_prior": "decision.priors",
    "FAMILIES": "feeding.adversarial",
    "PartErrorReport": "feeding.nearby_courses",
    "PlanReport": "feeding.reports",
    "tolerance_of": "feeding.part_errors",
    "check_claim": "feeding.verification",
    "parse_angles": "feeding.verification",
    "verify_plan": "feeding.verification",
    "Hyperstate": "decision.hyperstates",
    "StochgeomError": "errors",
    "Angle": "exact.angles",
    "EIGHTH_TURN": "exact.angles",
    "FULL_TURN": "exact.angles",
    "HALF_TURN": "exact.angles",
    "QUARTER_TURN": "exact.angles",
    "ZERO": "exact.angles",
    "Arc": "exact.arcs",
    "ClosedArc": "exact.arcs",
    "union_arcs": "exact.arcs",
    "union_measure": "exact.arcs",
    "sign_of_form": "exact.forms",
    "TurnRatio": "exact.ratios",
    "from_float_exact": "exact.scalars",
    "from_float_shortest": "exact.scalars",
    "rational": "exact.scalars",
    "AngleVector": "exact.vectors",
    "FeedingProblem": "feeding.problem",
    "ErrorBound": "feeding.gripper_error",
    "plan_weighing_grasps": "feeding.grasp_costs",
    "stability_costs": "feeding.grasp_costs",
    "StableGrasp": "feeding.stability",
    "most_stable_grasps": "feeding.stability",
    "stable_grasps": "feeding.stability",
    "plan_transfer": "feeding.planner",
    "orient_up_to_symmetry": "feeding.planner",
    "plan_feeding": "feeding.planner",
    "Action": "feeding.actions",
    "FeedingPlan": "feeding.plans",
    "Preimage": "feeding.preimages",
    "Preimages": "feeding.preimages",
    "preimages": "feeding.preimages",
    "antipodal_pairs": "geometry.calipers",
    "DiameterFunction": "geometry.diameter",
    "Sinusoid": "geometry.diameter",
    "ConvexHull": "geometry.hull",
    "convex_hull": "geometry.hull",
    "Part": "geometry.part",
    "load_part": "io.load",
    "parse_outline": "io.outlines",
    "read_outline": "io.outlines",
    "catalogue_names": "thesis.parts",
    "catalogue_part": "thesis.parts",
    "draw_analysis": "plotting.analysis_pictures",
    "draw_phase_one": "plotting.analysis_pictures",
    "draw_push_grasp_analysis": "plotting.analysis_pictures",
    "save_figure": "plotting.axes",
    "draw_beta_density": "plotting.density_pictures",
    "draw_diameter": "plotting.function_pictures",
    "draw_distribution": "plotting.function_pictures",
    "draw_preimages": "plotting.function_pictures",
    "draw_radius": "plotting.function_pictures",
    "draw_step_function": "plotting.function_pictures",
    "draw_closing": "plotting.pictures",
    "draw_funnel": "plotting.pictures",
    "draw_grasp": "plotting.pictures",
    "draw_gripper": "plotting.pictures",
    "draw_part": "plotting.pictures",
    "draw_scooped_blocks": "plotting.pictures",
    "draw_sensed_blocks": "plotting.pictures",
    "draw_sliding_jaw": "plotting.pictures",
    "draw_stable_grasps": "plotting.pictures",
    "draw_trace": "plotting.pictures",
    "draw_uncertain_grasp": "plotting.pictures",
    "RadiusFunction": "geometry.radius",
    "RadiusPiece": "geometry.radius",
    "push_function": "transfer.push",
    "push_grasp_function": "transfer.push_grasp",
    "squeeze_function": "transfer.squeeze",
    "StepFunction": "transfer.step_function",
}

__all__ = [
    "EIGHTH_TURN",
    "FAMILIES",
    "FULL_TURN",
    "HALF_TURN",
    "QUARTER_TURN",
    "ZERO",
    "Action",
    "Algebraic",
    "Angle",
    "AngleSum",
    "AngleVector",
    "Arc",
    "CallablePrior",
    "ClosedArc",
    "ConvexHull",
    "DiameterFunction",
    "DiscretePrior",
    "ErrorBound",
    "FeedingPlan",
    "FeedingProblem",
    "Hyperstate",
    "MixturePrior",
    "Observation",
    "Part",
    "PartErrorReport",
    "PiecewisePrior",
    "PlanReport",
    "Preimage",
    "Preimages",
    "Prior",
    "PriorEstimate",
    "RadiusFunction",
    "RadiusPiece",
    "Rejections",
    "Sinusoid",
    "StableGrasp",
    "StepFunction",
    "StochgeomError",
    "TurnRatio",
    "VonMises",
    "Window",
    "WrappedNormal",
    "antipodal_pairs",
    "catalogue_names",
    "catalogue_part",
    "cells_between",
    "check_claim",
    "convex_hull",
    "draw_analysis",
    "draw_beta_density",
    "draw_closing",
    "draw_diameter",
    "draw_distribution",
    "draw_funnel",
    "draw_grasp",
    "draw_gripper",
    "draw_part",
    "draw_phase_one",
    "draw_preimages",
    "draw_push_grasp_analysis",
    "draw_radius",
    "draw_scooped_blocks",
    "draw_sensed_blocks",
    "draw_sliding_jaw",
    "draw_stable_grasps",
    "draw_step_function",
    "draw_trace",
    "draw_uncertain_grasp",
    "exact_scalar",
    "from_float_exact",
    "from_float_shortest",
    "load_part",
    "most_stable_grasps",
    "orient_up_to_symmetry",
    "parse_angles",
    "parse_outline",
    "plan_feeding",
    "plan_transfer",
    "plan_weighing_grasps",
    "preimages",
    "push_function",
    "push_grasp_function",
    "rational",
    "read_outline",
    "save_figure",
    "sign_of_form",
    "squeeze_function",
    "stability_costs",
    "stable_grasps",
    "tolerance_of",
    "uniform_prior",
    "union_arcs",
    "union_measure",
    "verify_plan",
]


def __getattr__(name: str) -> Any:
    home = _HOMES.get(name)
    if home is None:
        raise AttributeError(f"module {__name__!r} has no attribute {name!r}")
    value = getattr(import_module(f"{__name__}.{home}"), name)
    globals()[name] = value
    return value


def __dir__() -> list[str]:
    return sorted({*globals(), *__all__})


def _renderers() -> Any:
    return import_module(f"{__name__}.plotting.rich_display").RENDERERS


# By name, like everything here; pictures are loaded when the first value is displayed.
import_module(f"{__name__}.display").register_renderers(_renderers)
