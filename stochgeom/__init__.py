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
    from stochgeom.decision.prior_estimates import PriorEstimate
    from stochgeom.decision.priors import Prior, Window, uniform_prior
    from stochgeom.decision.rejections import Observation, Rejections
    from stochgeom.errors import StochgeomError
    from stochgeom.exact.angles import EIGHTH_TURN, FULL_TURN, HALF_TURN, QUARTER_TURN, ZERO, Angle
    from stochgeom.exact.arcs import Arc, ClosedArc, union_arcs, union_measure
    from stochgeom.exact.forms import sign_of_form
    from stochgeom.exact.ratios import TurnRatio
    from stochgeom.exact.scalars import from_float_exact, from_float_shortest, rational
    from stochgeom.exact.sums import AngleSum
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
    from stochgeom.io.recordings import load_recording
    from stochgeom.thesis.appendix_g import FIGURES_G
    from stochgeom.thesis.chapter_6 import PRINTED_PLANS, figure_6_4_model
    from stochgeom.thesis.parts import catalogue_names, catalogue_part
    from stochgeom.tilting.all_plans import best_tilt_plan, best_tilt_plans
    from stochgeom.tilting.beta_density import BetaDensity
    from stochgeom.tilting.bounded_search import bounded_tilt_search
    from stochgeom.tilting.counts import TransitionCounts
    from stochgeom.tilting.estimation import TransitionModel
    from stochgeom.tilting.experiment import calibrate_tilt_plans, measure_tilt_plans, trials_study
    from stochgeom.tilting.gripper import (
        SimulatedGripper,
        random_grasps,
        simulate_push_grasp,
        simulate_squeeze,
    )
    from stochgeom.tilting.intervals import wilson_interval
    from stochgeom.tilting.physics import Tilt, slide_tile
    from stochgeom.tilting.posterior import (
        credible_interval,
        posterior_median,
        predictive_check,
        sample_matrices,
        sampled_probabilities,
    )
    from stochgeom.tilting.robot import SimulatedRobot
    from stochgeom.tilting.shortest_path import likeliest_tilts, shortest_path_tilt_plan
    from stochgeom.tilting.states import TilePose, draw_tile_pose, tile_state
    from stochgeom.tilting.tilt_plans import TiltPlan, evaluate_tilt_plan
    from stochgeom.tilting.tray import TraySetup
    from stochgeom.tilting.uncertain_plans import best_expected_tilt_plan, expected_probability
    from stochgeom.transfer.push import push_function
    from stochgeom.transfer.push_grasp import push_grasp_function
    from stochgeom.transfer.squeeze import squeeze_function
    from stochgeom.transfer.step_function import StepFunction

_HOMES = {
    "AngleSum": "exact.sums",
    "CallablePrior": "decision.callable_prior",
    "DiscretePrior": "decision.discrete_prior",
    "MixturePrior": "decision.mixture_prior",
    "Observation": "decision.rejections",
    "PiecewisePrior": "decision.piecewise_prior",
    "Prior": "decision.priors",
    "PriorEstimate": "decision.prior_estimates",
    "Rejections": "decision.rejections",
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
    "RadiusFunction": "geometry.radius",
    "RadiusPiece": "geometry.radius",
    "push_function": "transfer.push",
    "push_grasp_function": "transfer.push_grasp",
    "squeeze_function": "transfer.squeeze",
    "StepFunction": "transfer.step_function",
    "BetaDensity": "tilting.beta_density",
    "FIGURES_G": "thesis.appendix_g",
    "PRINTED_PLANS": "thesis.chapter_6",
    "TilePose": "tilting.states",
    "SimulatedRobot": "tilting.robot",
    "Tilt": "tilting.physics",
    "TiltPlan": "tilting.tilt_plans",
    "TransitionCounts": "tilting.counts",
    "TransitionModel": "tilting.estimation",
    "TraySetup": "tilting.tray",
    "best_expected_tilt_plan": "tilting.uncertain_plans",
    "best_tilt_plan": "tilting.all_plans",
    "best_tilt_plans": "tilting.all_plans",
    "bounded_tilt_search": "tilting.bounded_search",
    "calibrate_tilt_plans": "tilting.experiment",
    "credible_interval": "tilting.posterior",
    "evaluate_tilt_plan": "tilting.tilt_plans",
    "expected_probability": "tilting.uncertain_plans",
    "figure_6_4_model": "thesis.chapter_6",
    "load_recording": "io.recordings",
    "measure_tilt_plans": "tilting.experiment",
    "posterior_median": "tilting.posterior",
    "predictive_check": "tilting.posterior",
    "sample_matrices": "tilting.posterior",
    "sampled_probabilities": "tilting.posterior",
    "shortest_path_tilt_plan": "tilting.shortest_path",
    "slide_tile": "tilting.physics",
    "tile_state": "tilting.states",
    "trials_study": "tilting.experiment",
    "wilson_interval": "tilting.intervals",
    "SimulatedGripper": "tilting.gripper",
    "random_grasps": "tilting.gripper",
    "simulate_push_grasp": "tilting.gripper",
    "simulate_squeeze": "tilting.gripper",
    "likeliest_tilts": "tilting.shortest_path",
    "draw_tile_pose": "tilting.states",
}

__all__ = [
    "EIGHTH_TURN",
    "FAMILIES",
    "FIGURES_G",
    "FULL_TURN",
    "HALF_TURN",
    "PRINTED_PLANS",
    "QUARTER_TURN",
    "ZERO",
    "Action",
    "Angle",
    "AngleSum",
    "AngleVector",
    "Arc",
    "BetaDensity",
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
    "SimulatedGripper",
    "SimulatedRobot",
    "Sinusoid",
    "StableGrasp",
    "StepFunction",
    "StochgeomError",
    "TilePose",
    "Tilt",
    "TiltPlan",
    "TransitionCounts",
    "TransitionModel",
    "TraySetup",
    "TurnRatio",
    "VonMises",
    "Window",
    "WrappedNormal",
    "antipodal_pairs",
    "best_expected_tilt_plan",
    "best_tilt_plan",
    "best_tilt_plans",
    "bounded_tilt_search",
    "calibrate_tilt_plans",
    "catalogue_names",
    "catalogue_part",
    "check_claim",
    "convex_hull",
    "credible_interval",
    "draw_tile_pose",
    "evaluate_tilt_plan",
    "expected_probability",
    "figure_6_4_model",
    "from_float_exact",
    "from_float_shortest",
    "likeliest_tilts",
    "load_part",
    "load_recording",
    "measure_tilt_plans",
    "most_stable_grasps",
    "orient_up_to_symmetry",
    "parse_angles",
    "parse_outline",
    "plan_feeding",
    "plan_transfer",
    "plan_weighing_grasps",
    "posterior_median",
    "predictive_check",
    "preimages",
    "push_function",
    "push_grasp_function",
    "random_grasps",
    "rational",
    "read_outline",
    "sample_matrices",
    "sampled_probabilities",
    "shortest_path_tilt_plan",
    "sign_of_form",
    "simulate_push_grasp",
    "simulate_squeeze",
    "slide_tile",
    "squeeze_function",
    "stability_costs",
    "stable_grasps",
    "tile_state",
    "tolerance_of",
    "trials_study",
    "uniform_prior",
    "union_arcs",
    "union_measure",
    "verify_plan",
    "wilson_interval",
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
