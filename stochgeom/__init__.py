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
    from stochgeom.decision.additive_costs import AdditiveCost, distance_cost
    from stochgeom.decision.callable_prior import CallablePrior
    from stochgeom.decision.circular_variance import VarianceCost, circular_variance
    from stochgeom.decision.decision_rules import DecisionProblem
    from stochgeom.decision.density_priors import VonMises, WrappedNormal
    from stochgeom.decision.discrete_prior import DiscretePrior
    from stochgeom.decision.entropy import EntropyCost, entropy, information
    from stochgeom.decision.exhaustive_plans import every_plan
    from stochgeom.decision.goal_costs import GoalCost, GuaranteedCost
    from stochgeom.decision.hyperstates import Hyperstate
    from stochgeom.decision.infinity import INFINITE
    from stochgeom.decision.iterative_costs import IterativeCost
    from stochgeom.decision.mixture_prior import MixturePrior
    from stochgeom.decision.perfect_information import ObservedPolicy, observed_policy
    from stochgeom.decision.piecewise_prior import PiecewisePrior
    from stochgeom.decision.plan_costs import CostModel, PlanCost
    from stochgeom.decision.plan_results import PlanResult
    from stochgeom.decision.plan_search import best_action, find_plan
    from stochgeom.decision.planning_problem import PlanningProblem
    from stochgeom.decision.prior_estimates import PriorEstimate, cells_between
    from stochgeom.decision.priors import Prior, Window, uniform_prior
    from stochgeom.decision.random_search import random_plan
    from stochgeom.decision.randomised_rules import RandomisedRule, randomised_minimax
    from stochgeom.decision.rejections import Observation, Rejections
    from stochgeom.decision.rounds import Rounds
    from stochgeom.decision.two_argmins import TwoArgmins, two_argmins
    from stochgeom.decision.uniform_difference import cyclic_difference, simulated_difference
    from stochgeom.decision.worst_case_costs import MinimaxCost
    from stochgeom.errors import StochgeomError
    from stochgeom.exact.algebraic import Algebraic
    from stochgeom.exact.angles import EIGHTH_TURN, FULL_TURN, HALF_TURN, QUARTER_TURN, ZERO, Angle
    from stochgeom.exact.arcs import Arc, ClosedArc, union_arcs, union_measure
    from stochgeom.exact.cells import CellSet
    from stochgeom.exact.forms import sign_of_form
    from stochgeom.exact.halves import HalfAngle
    from stochgeom.exact.independent_sums import LogSum, RootSum
    from stochgeom.exact.intervals import Interval
    from stochgeom.exact.quotients import SumQuotient
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
    from stochgeom.feeding.planning_problems import OrientingProblem, planning_problem_of
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
    from stochgeom.grasping.friction import Friction
    from stochgeom.grasping.friction_bounds import GuaranteedBound
    from stochgeom.grasping.friction_limits import FrictionLimit
    from stochgeom.grasping.grasp_diagram import GraspDiagram, GraspTolerance
    from stochgeom.grasping.grasp_report import GraspReport
    from stochgeom.grasping.push_stability import Jaw, Motion, PushStability
    from stochgeom.grasping.pushing_model import density_after_push, pushing_bound, pushing_bounds
    from stochgeom.grasping.pushing_over_friction import PushingBound
    from stochgeom.grasping.regular import regular_bound
    from stochgeom.grasping.squeeze_stability import SqueezeStability
    from stochgeom.grasping.uncertain_grasps import UncertainGrasps
    from stochgeom.io.load import load_part
    from stochgeom.io.outlines import parse_outline, read_outline
    from stochgeom.io.pomdp_file import write_pomdp
    from stochgeom.io.problem_json import load_problem, problem_document
    from stochgeom.io.recordings import load_recording
    from stochgeom.sensing.calibration import (
        CalibrationProblem,
        calibration_problem,
        expected_entropy,
    )
    from stochgeom.sensing.decisions import Decisions
    from stochgeom.sensing.diameter_sensor import diameter_sensor
    from stochgeom.sensing.one_step import OneStepPlan, one_step_plan
    from stochgeom.sensing.plan_tree import PlanTree
    from stochgeom.sensing.planners import iterative_sensor_plan, plan_for_cost, sensor_plan
    from stochgeom.sensing.recognition import RecognitionProblem
    from stochgeom.sensing.sampling import sampled_sensor, sensor_from_counts
    from stochgeom.sensing.sensing_problem import SensingProblem
    from stochgeom.sensing.sensor_design import (
        choose_bits,
        compare_sensors,
        fuse_sensors,
        place_sensor,
    )
    from stochgeom.sensing.sensor_plan import SensorPlan
    from stochgeom.sensing.sensors import Sensor
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
    "Algebraic": "exact.algebraic",
    "AdditiveCost": "decision.additive_costs",
    "CostModel": "decision.plan_costs",
    "DecisionProblem": "decision.decision_rules",
    "EntropyCost": "decision.entropy",
    "GoalCost": "decision.goal_costs",
    "GuaranteedCost": "decision.goal_costs",
    "INFINITE": "decision.infinity",
    "IterativeCost": "decision.iterative_costs",
    "LogSum": "exact.independent_sums",
    "MinimaxCost": "decision.worst_case_costs",
    "ObservedPolicy": "decision.perfect_information",
    "OrientingProblem": "feeding.planning_problems",
    "PlanCost": "decision.plan_costs",
    "PlanResult": "decision.plan_results",
    "PlanningProblem": "decision.planning_problem",
    "RandomisedRule": "decision.randomised_rules",
    "RootSum": "exact.independent_sums",
    "Rounds": "decision.rounds",
    "TwoArgmins": "decision.two_argmins",
    "VarianceCost": "decision.circular_variance",
    "best_action": "decision.plan_search",
    "circular_variance": "decision.circular_variance",
    "cyclic_difference": "decision.uniform_difference",
    "distance_cost": "decision.additive_costs",
    "entropy": "decision.entropy",
    "every_plan": "decision.exhaustive_plans",
    "find_plan": "decision.plan_search",
    "information": "decision.entropy",
    "load_problem": "io.problem_json",
    "observed_policy": "decision.perfect_information",
    "planning_problem_of": "feeding.planning_problems",
    "problem_document": "io.problem_json",
    "random_plan": "decision.random_search",
    "randomised_minimax": "decision.randomised_rules",
    "simulated_difference": "decision.uniform_difference",
    "two_argmins": "decision.two_argmins",
    "write_pomdp": "io.pomdp_file",
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
    "RadiusFunction": "geometry.radius",
    "RadiusPiece": "geometry.radius",
    "push_function": "transfer.push",
    "push_grasp_function": "transfer.push_grasp",
    "squeeze_function": "transfer.squeeze",
    "StepFunction": "transfer.step_function",
    "CellSet": "exact.cells",
    "Interval": "exact.intervals",
    "HalfAngle": "exact.halves",
    "Friction": "grasping.friction",
    "FrictionLimit": "grasping.friction_limits",
    "GraspDiagram": "grasping.grasp_diagram",
    "GraspReport": "grasping.grasp_report",
    "GraspTolerance": "grasping.grasp_diagram",
    "GuaranteedBound": "grasping.friction_bounds",
    "Jaw": "grasping.push_stability",
    "Motion": "grasping.push_stability",
    "PushStability": "grasping.push_stability",
    "PushingBound": "grasping.pushing_over_friction",
    "SqueezeStability": "grasping.squeeze_stability",
    "UncertainGrasps": "grasping.uncertain_grasps",
    "density_after_push": "grasping.pushing_model",
    "pushing_bound": "grasping.pushing_model",
    "pushing_bounds": "grasping.pushing_model",
    "regular_bound": "grasping.regular",
    "SumQuotient": "exact.quotients",
    "CalibrationProblem": "sensing.calibration",
    "calibration_problem": "sensing.calibration",
    "expected_entropy": "sensing.calibration",
    "Decisions": "sensing.decisions",
    "diameter_sensor": "sensing.diameter_sensor",
    "OneStepPlan": "sensing.one_step",
    "one_step_plan": "sensing.one_step",
    "PlanTree": "sensing.plan_tree",
    "iterative_sensor_plan": "sensing.planners",
    "sensor_plan": "sensing.planners",
    "plan_for_cost": "sensing.planners",
    "RecognitionProblem": "sensing.recognition",
    "sampled_sensor": "sensing.sampling",
    "sensor_from_counts": "sensing.sampling",
    "SensingProblem": "sensing.sensing_problem",
    "choose_bits": "sensing.sensor_design",
    "compare_sensors": "sensing.sensor_design",
    "fuse_sensors": "sensing.sensor_design",
    "place_sensor": "sensing.sensor_design",
    "SensorPlan": "sensing.sensor_plan",
    "Sensor": "sensing.sensors",
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
    "INFINITE",
    "PRINTED_PLANS",
    "QUARTER_TURN",
    "ZERO",
    "Action",
    "AdditiveCost",
    "Algebraic",
    "Angle",
    "AngleSum",
    "AngleVector",
    "Arc",
    "BetaDensity",
    "CalibrationProblem",
    "CallablePrior",
    "CellSet",
    "ClosedArc",
    "ConvexHull",
    "CostModel",
    "DecisionProblem",
    "Decisions",
    "DiameterFunction",
    "DiscretePrior",
    "EntropyCost",
    "ErrorBound",
    "FeedingPlan",
    "FeedingProblem",
    "Friction",
    "FrictionLimit",
    "GoalCost",
    "GraspDiagram",
    "GraspReport",
    "GraspTolerance",
    "GuaranteedBound",
    "GuaranteedCost",
    "HalfAngle",
    "Hyperstate",
    "Interval",
    "IterativeCost",
    "Jaw",
    "LogSum",
    "MinimaxCost",
    "MixturePrior",
    "Motion",
    "Observation",
    "ObservedPolicy",
    "OneStepPlan",
    "OrientingProblem",
    "Part",
    "PartErrorReport",
    "PiecewisePrior",
    "PlanCost",
    "PlanReport",
    "PlanResult",
    "PlanTree",
    "PlanningProblem",
    "Preimage",
    "Preimages",
    "Prior",
    "PriorEstimate",
    "PushStability",
    "PushingBound",
    "RadiusFunction",
    "RadiusPiece",
    "RandomisedRule",
    "RecognitionProblem",
    "Rejections",
    "RootSum",
    "Rounds",
    "SensingProblem",
    "Sensor",
    "SensorPlan",
    "SimulatedGripper",
    "SimulatedRobot",
    "Sinusoid",
    "SqueezeStability",
    "StableGrasp",
    "StepFunction",
    "StochgeomError",
    "SumQuotient",
    "TilePose",
    "Tilt",
    "TiltPlan",
    "TransitionCounts",
    "TransitionModel",
    "TraySetup",
    "TurnRatio",
    "TwoArgmins",
    "UncertainGrasps",
    "VarianceCost",
    "VonMises",
    "Window",
    "WrappedNormal",
    "antipodal_pairs",
    "best_action",
    "best_expected_tilt_plan",
    "best_tilt_plan",
    "best_tilt_plans",
    "bounded_tilt_search",
    "calibrate_tilt_plans",
    "calibration_problem",
    "catalogue_names",
    "catalogue_part",
    "cells_between",
    "check_claim",
    "choose_bits",
    "circular_variance",
    "compare_sensors",
    "convex_hull",
    "credible_interval",
    "cyclic_difference",
    "density_after_push",
    "diameter_sensor",
    "distance_cost",
    "draw_tile_pose",
    "entropy",
    "evaluate_tilt_plan",
    "every_plan",
    "exact_scalar",
    "expected_entropy",
    "expected_probability",
    "figure_6_4_model",
    "find_plan",
    "from_float_exact",
    "from_float_shortest",
    "fuse_sensors",
    "information",
    "iterative_sensor_plan",
    "likeliest_tilts",
    "load_part",
    "load_problem",
    "load_recording",
    "measure_tilt_plans",
    "most_stable_grasps",
    "observed_policy",
    "one_step_plan",
    "orient_up_to_symmetry",
    "parse_angles",
    "parse_outline",
    "place_sensor",
    "plan_feeding",
    "plan_for_cost",
    "plan_transfer",
    "plan_weighing_grasps",
    "planning_problem_of",
    "posterior_median",
    "predictive_check",
    "preimages",
    "problem_document",
    "push_function",
    "push_grasp_function",
    "pushing_bound",
    "pushing_bounds",
    "random_grasps",
    "random_plan",
    "randomised_minimax",
    "rational",
    "read_outline",
    "regular_bound",
    "sample_matrices",
    "sampled_probabilities",
    "sampled_sensor",
    "sensor_from_counts",
    "sensor_plan",
    "shortest_path_tilt_plan",
    "sign_of_form",
    "simulate_push_grasp",
    "simulate_squeeze",
    "simulated_difference",
    "slide_tile",
    "squeeze_function",
    "stability_costs",
    "stable_grasps",
    "tile_state",
    "tolerance_of",
    "trials_study",
    "two_argmins",
    "uniform_prior",
    "union_arcs",
    "union_measure",
    "verify_plan",
    "wilson_interval",
    "write_pomdp",
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
