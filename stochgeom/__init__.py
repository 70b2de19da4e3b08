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
from typing import Any

__version__ = "0.1.0"

_NAMES = {
    "decision.additive_costs": "AdditiveCost distance_cost",
    "decision.callable_prior": "CallablePrior",
    "decision.circular_variance": "VarianceCost circular_variance",
    "decision.decision_rules": "DecisionProblem",
    "decision.density_priors": "VonMises WrappedNormal",
    "decision.discrete_prior": "DiscretePrior",
    "decision.entropy": "EntropyCost entropy information",
    "decision.exhaustive_plans": "every_plan",
    "decision.goal_costs": "GoalCost GuaranteedCost",
    "decision.hyperstates": "Hyperstate",
    "decision.infinity": "INFINITE",
    "decision.iterative_costs": "IterativeCost",
    "decision.mixture_prior": "MixturePrior",
    "decision.perfect_information": "ObservedPolicy observed_policy",
    "decision.piecewise_prior": "PiecewisePrior",
    "decision.plan_costs": "CostModel PlanCost",
    "decision.plan_results": "PlanResult",
    "decision.plan_search": "best_action find_plan",
    "decision.planning_problem": "PlanningProblem",
    "decision.prior_estimates": "PriorEstimate cells_between",
    "decision.priors": "Prior Window uniform_prior",
    "decision.random_search": "random_plan",
    "decision.randomised_rules": "RandomisedRule randomised_minimax",
    "decision.rejections": "Observation Rejections",
    "decision.rounds": "Rounds",
    "decision.two_argmins": "TwoArgmins two_argmins",
    "decision.uniform_difference": "cyclic_difference simulated_difference",
    "decision.worst_case_costs": "MinimaxCost",
    "errors": "StochgeomError",
    "exact.algebraic": "Algebraic",
    "exact.angles": "Angle EIGHTH_TURN FULL_TURN HALF_TURN QUARTER_TURN ZERO",
    "exact.arcs": "Arc ClosedArc union_arcs union_measure",
    "exact.cells": "CellSet",
    "exact.decimals": "Rounding rational_decimal",
    "exact.forms": "sign_of_form",
    "exact.halves": "HalfAngle",
    "exact.independent_sums": "LogSum RootSum",
    "exact.intervals": "Interval",
    "exact.quotients": "SumQuotient",
    "exact.ratios": "TurnRatio",
    "exact.scalars": "from_float_exact from_float_shortest rational",
    "exact.sums": "AngleSum",
    "exact.surds": "exact_scalar",
    "exact.vectors": "AngleVector",
    "feeding.actions": "Action",
    "feeding.adversarial": "FAMILIES",
    "feeding.closures": "Closure closure_of",
    "feeding.grasp_costs": "plan_weighing_grasps stability_costs",
    "feeding.gripper_error": "ErrorBound",
    "feeding.nearby_courses": "PartErrorReport",
    "feeding.part_errors": "tolerance_of",
    "feeding.planner": "orient_up_to_symmetry plan_feeding plan_transfer",
    "feeding.planning_problems": "OrientingProblem planning_problem_of",
    "feeding.plans": "FeedingPlan",
    "feeding.preimages": "Preimage Preimages preimages",
    "feeding.problem": "FeedingProblem",
    "feeding.reports": "PlanReport",
    "feeding.stability": "StableGrasp most_stable_grasps stable_grasps",
    "feeding.verification": "check_claim parse_angles verify_plan",
    "geometry.calipers": "antipodal_pairs",
    "geometry.diameter": "DiameterFunction Sinusoid",
    "geometry.hull": "ConvexHull convex_hull",
    "geometry.part": "Part",
    "geometry.radius": "RadiusFunction RadiusPiece",
    "grasping.friction": "Friction",
    "grasping.friction_bounds": "GuaranteedBound",
    "grasping.friction_limits": "FrictionLimit",
    "grasping.grasp_diagram": "GraspDiagram GraspTolerance",
    "grasping.grasp_report": "GraspReport",
    "grasping.push_stability": "Jaw Motion PushStability",
    "grasping.pushing_model": "density_after_push pushing_bound pushing_bounds",
    "grasping.pushing_over_friction": "PushingBound",
    "grasping.regular": "regular_bound",
    "grasping.squeeze_stability": "SqueezeStability",
    "grasping.uncertain_grasps": "UncertainGrasps",
    "io.load": "load_part",
    "io.outlines": "parse_outline read_outline",
    "io.pomdp_file": "write_pomdp",
    "io.priors": "load_prior",
    "io.problem_json": "load_problem problem_document",
    "io.recordings": "load_recording",
    "plotting.analysis_pictures": "draw_analysis draw_phase_one draw_push_grasp_analysis",
    "plotting.axes": "save_figure",
    "plotting.block_pictures": "draw_scooped_blocks draw_sensed_blocks",
    "plotting.closure_pictures": "draw_closure draw_monotone_step",
    "plotting.decision_pictures": "draw_risks draw_sensor_density",
    "plotting.density_pictures": "draw_beta_density",
    "plotting.feeder_pictures": "draw_feeder",
    "plotting.friction_pictures": "draw_friction_bounds",
    "plotting.function_pictures": (
        "draw_diameter draw_distribution draw_preimages draw_radius draw_step_function "
    ),
    "plotting.pictures": (
        "draw_closing draw_funnel draw_grasp draw_gripper draw_part draw_sliding_jaw "
        "draw_stable_grasps draw_trace draw_uncertain_grasp "
    ),
    "plotting.stability_pictures": (
        "draw_grasp_diagram draw_push_density draw_push_stability draw_squeeze_stability "
    ),
    "plotting.tilting_pictures": "draw_tilting draw_tilts draw_tray",
    "plotting.tree_pictures": "draw_all_plans draw_open_loop_plans draw_plan_tree",
    "sensing.and_or_tree": "AndOrTree all_sensor_plans",
    "sensing.calibration": "CalibrationProblem calibration_problem expected_entropy",
    "sensing.decisions": "Decisions",
    "sensing.diameter_sensor": "diameter_sensor",
    "sensing.one_step": "OneStepPlan one_step_plan",
    "sensing.plan_tree": "PlanTree",
    "sensing.planners": "iterative_sensor_plan plan_for_cost sensor_plan",
    "sensing.recognition": "RecognitionProblem",
    "sensing.sampling": "sampled_sensor sensor_from_counts",
    "sensing.sensing_problem": "SensingProblem",
    "sensing.sensor_design": "choose_bits compare_sensors fuse_sensors place_sensor",
    "sensing.sensor_plan": "SensorPlan",
    "sensing.sensors": "Sensor",
    "thesis.appendix_e": "figure_e_5 figure_e_8",
    "thesis.appendix_g": "FIGURES_G",
    "thesis.chapter_6": "PRINTED_PLANS figure_6_4_model",
    "thesis.errata_register": "find_errata",
    "thesis.grasp_tables": "table_3_1 table_c_1",
    "thesis.parts": "catalogue_names catalogue_part",
    "thesis.sensor_orders": "sensor_orders",
    "thesis.tables": "table_4_1",
    "tilting.all_plans": "best_tilt_plan best_tilt_plans",
    "tilting.beta_density": "BetaDensity",
    "tilting.bounded_search": "bounded_tilt_search",
    "tilting.counts": "TransitionCounts",
    "tilting.estimation": "TransitionModel",
    "tilting.experiment": "calibrate_tilt_plans measure_tilt_plans trials_study",
    "tilting.gripper": "SimulatedGripper random_grasps simulate_push_grasp simulate_squeeze",
    "tilting.intervals": "wilson_interval",
    "tilting.physics": "Tilt slide_tile",
    "tilting.posterior": (
        "credible_interval posterior_median predictive_check sample_matrices sampled_probabilities "
    ),
    "tilting.robot": "SimulatedRobot",
    "tilting.shortest_path": "likeliest_tilts shortest_path_tilt_plan",
    "tilting.states": "TilePose random_tile_pose tile_state",
    "tilting.tilt_plans": "TiltPlan evaluate_tilt_plan",
    "tilting.tray": "TraySetup",
    "tilting.uncertain_plans": "best_expected_tilt_plan expected_probability",
    "transfer.push": "push_function",
    "transfer.push_grasp": "push_grasp_function",
    "transfer.squeeze": "squeeze_function",
    "transfer.step_function": "StepFunction",
}
"""The public names by the module that each is loaded from; `__init__.pyi` tells type checkers."""

_HOMES = {name: home for home, names in _NAMES.items() for name in names.split()}

__all__ = sorted(_HOMES)


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
