"""Plans with sensors as JSON documents: exact numbers as text, decimals correctly rounded."""

from __future__ import annotations

from typing import Any

from stochgeom.exact.quotients import number_decimal, quotient
from stochgeom.exact.scalars import rational_text
from stochgeom.io.plan_json import Json, angle_json, part_json
from stochgeom.sensing.diameter_sensor import root_text
from stochgeom.sensing.one_step import OneStepPlan
from stochgeom.sensing.plan_tree import PlanTree
from stochgeom.sensing.sensing_problem import OrderComparison, SensingProblem
from stochgeom.sensing.sensor_plan import SensorPlan
from stochgeom.sensing.sensors import Sensor
from stochgeom.sensing.tree_nodes import Act, Leaf, Node, mass_of
from stochgeom.sensing.tree_text import label_text


def number_text(value: Any, digits: int = 4) -> str:
    """Return a number as text: a rational one exactly, any other as a decimal.

    Examples
    --------
    >>> from gmpy2 import mpq
    >>> number_text(mpq(1, 3)), number_text(0.5, 2)
    ('1/3', '0.50')
    """
    if isinstance(value, float) or getattr(value, "rational", value) is None:
        return number_decimal(value, digits)
    return rational_text(getattr(value, "rational", value))


def sensor_json(sensor: Sensor) -> Json:
    """Return a sensor with its likelihoods.

    Examples
    --------
    >>> sensor_json(Sensor.noisy(["a", "b"], "1/10"))["likelihood"]
    {'a': ['9/10', '1/10'], 'b': ['1/10', '9/10']}
    """
    return {
        "name": sensor.name,
        "readings": [label_text(x) for x in sensor.readings],
        "likelihood": {
            label_text(state): [number_text(p, 17) for p in row]
            for state, row in zip(sensor.states, sensor.likelihood, strict=True)
        },
        "cost": number_text(sensor.cost),
        "row_error": rational_text(sensor.row_error),
    }


def tree_json(tree: PlanTree, digits: int = 4) -> Json:
    """Return a plan tree, node in node.

    Examples
    --------
    >>> from gmpy2 import mpq
    >>> leaf = Leaf((mpq(1),), "up", mpq(1))
    >>> tree_json(PlanTree(Act((mpq(1),), "turn", mpq(1), leaf), ("up",)), 2)
    {'act': 'turn', 'cost': '1', 'then': {'accept': 'up', 'probability': '1.00'}}
    """
    return _node_json(tree.root, tree.accepts, digits)


def _node_json(node: Node, accepts: bool, digits: int) -> Json:
    if isinstance(node, Act):
        then = _node_json(node.child, accepts, digits)
        return {"act": label_text(node.action), "cost": number_text(node.cost), "then": then}
    if isinstance(node, Leaf):
        worth = quotient(node.gain, mass_of(node))
        found: Json = {"accept" if accepts else "decide": label_text(node.decision)}
        if accepts:
            found["probability"] = number_decimal(worth, digits)
        else:
            found["loss"] = number_decimal(0 - worth, digits)
        return {**found, "truncated": True} if node.truncated else found
    return {
        "read": label_text(node.sensor),
        "cost": number_text(node.cost),
        "branches": [
            {
                "reading": label_text(reading),
                "probability": number_decimal(quotient(mass_of(child), mass_of(node)), digits),
                "then": _node_json(child, accepts, digits),
            }
            for reading, child in node.branches
        ],
    }


def sensor_plan_json(plan: SensorPlan, digits: int = 4) -> Json:
    """Return a plan with its worth and its tree."""
    return {
        "expected_cost": plan.decimal(digits),
        "cost_of_round": number_decimal(plan.cost_of_round, digits),
        "success": number_decimal(plan.success, digits),
        "proven_optimal": plan.proven,
        "lower_bound": number_decimal(plan.lower_bound, digits),
        "moves": plan.tree.depth,
        "tree": tree_json(plan.tree, digits),
    }


def one_step_json(plan: OneStepPlan, digits: int = 4) -> Json:
    """Return the plan that looks once and accepts."""
    return {
        "expected_cost": number_decimal(plan.expected_cost, digits),
        "success": number_decimal(plan.success, digits),
        "equation_7_5": number_decimal(plan.printed_cost, digits),
        "decisions": [
            {
                "reading": label_text(d.reading),
                "probability": number_decimal(d.marginal, digits),
                "accept": label_text(d.state),
                "posterior": number_decimal(d.probability, digits),
            }
            for d in plan.decisions
        ],
    }


def sensing_document(
    problem: SensingProblem,
    plan: SensorPlan,
    orders: OrderComparison | None,
    digits: int = 4,
) -> Json:
    """Return the document ``stochgeom/sense/1``.

    Examples
    --------
    >>> problem = SensingProblem([(0, 0), (3, 0), (3, 2), (0, 2)], bits=1)
    >>> document = sensing_document(problem, problem.plan(1), None)
    >>> document["schema"], document["plan"]["expected_cost"]
    ('stochgeom/sense/1', '4.0000')
    """
    prior = problem.orienting.problem.prior
    document: Json = {
        "schema": "stochgeom/sense/1",
        "part": part_json(problem.part),
        "cost_ratio": rational_text(problem.cost_ratio),
        "sensor": {
            **sensor_json(problem.sensor),
            "bits": problem.bits,
            "range": [rational_text(problem.covered.low), rational_text(problem.covered.high)],
            "standard_deviation": rational_text(problem.deviation),
        },
        "states": [
            {
                "state": label,
                "orientation": angle_json(theta, digits),
                "diameter": root_text(problem.squared_diameters[label], digits),
                "prior": number_decimal(share, digits),
            }
            for (label, theta), share in zip(problem.states.items(), prior, strict=True)
        ],
        "actions": {
            label: angle_json(problem.orienting.angle(label), digits)
            for label in problem.orienting.problem.actions
        },
        "one_step": one_step_json(problem.one_step, digits),
        "plan": sensor_plan_json(plan, digits),
    }
    if orders is not None:
        document["orders"] = {
            "squeezes": orders.actions,
            "blind": orders.blind.decimal(digits),
            "sense_then_act": orders.sense_then_act.decimal(digits),
            "act_then_sense": orders.act_then_sense.decimal(digits),
            "mixed": orders.mixed.decimal(digits),
        }
    return document
