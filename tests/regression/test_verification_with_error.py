"""Plans made for an inexact gripper were said to be wrong.

`FeedingPlan.verify` asked of every plan that it fails at the open end of each range. A preimage
found with a gripper error may be narrower than what exact actions collapse, and then the actions
after one at its open end can make up for it: the plan is right, and so is its range.
"""

from __future__ import annotations

import pytest

from stochgeom.exact.angles import QUARTER_TURN, Angle
from stochgeom.feeding.execution import run_arc
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.transfer.step_function import StepFunction


def grid(breaks, values, period):
    return StepFunction(
        *([Angle.from_degrees(d) for d in row] for row in (breaks, values)),
        Angle.from_degrees(period),
    )


CASES = [
    (grid([5, 30, 45], [15, 30, 90], 90), 10),
    (grid([10, 50, 55, 85], [40, 55, 90, 125], 90), 10),
]


@pytest.mark.parametrize(("s", "delta"), CASES)
def test_a_plan_that_works_at_an_open_end_is_right(s, delta):
    plan = FeedingProblem.of_transfer(s, gripper_error=delta).plan_of(3)
    assert s.period == QUARTER_TURN
    assert plan.verify()
    nominal = plan.angles
    at_low = run_arc(s, [nominal[0], plan.actions[1].low, nominal[2]], plan.mouth)
    assert not at_low[-1].width
    # The image leaves the next preimage there, as the range says.
    goal, turned = plan.preimages[1].arc, at_low[0].rotate(-plan.actions[1].low)
    assert turned.end == goal.end
    assert not goal.contains(turned.end)
