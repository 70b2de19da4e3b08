"""At the lower end of a range the plan fails, but not whatever the other actions do.

It was first written that a plan with its other actions at their nominal angles fails at `low`.
For the part below that is false: action 1 at its nominal angle sends the mouth to an arc that is
narrower than it may be, and action 2 may then be turned a little further than its range says.
What holds, and what `FeedingPlan.verify` checks, is told in `stochgeom.feeding.plans`: `low`
fails when the actions before it stand close enough above their own lower ends, and it fails to
collapse the whole preimage that it starts from.
"""

from __future__ import annotations

import pytest

from stochgeom.exact.angles import Angle
from stochgeom.feeding.execution import run_arc
from stochgeom.feeding.planner import FeedingProblem

PROBLEM = FeedingProblem([(-4, 3), (-2, -4), (0, -3), (2, 2), (0, 4)])
PLAN = PROBLEM.geometric_plan()
FREE, FIRST, SECOND = PLAN.actions
SLIGHT = Angle(0, (10**6, 1))


def final(*angles, mouth=PLAN.mouth, transfer=PLAN.transfer):
    """Return the closed arc that the mouth has become at the end."""
    return run_arc(transfer, [FREE.angle, *angles], mouth)[-1]


def collapses(*angles, mouth=PLAN.mouth):
    last = final(*angles, mouth=mouth)
    return not last.width and last.start == PLAN.final_orientation


def test_the_plan_has_three_steps_and_does_its_work():
    assert PLAN.steps == 3
    assert collapses(FIRST.angle, SECOND.angle)
    assert PLAN.verify()


def test_the_naive_statement_is_false():
    """At the nominal angle of action 1 the plan survives action 2 at its lower end, and below."""
    assert collapses(FIRST.angle, SECOND.low)
    assert collapses(FIRST.angle, SECOND.low - SLIGHT)
    # Why: the image after action 1 ends before that of the whole preimage.
    after_first = run_arc(PLAN.transfer, [FREE.angle, FIRST.angle], PLAN.mouth)[-1]
    preimage = PROBLEM.preimages.of_steps(2)
    assert after_first.start == preimage.image.start
    assert after_first.end < preimage.image.end


def test_the_upper_end_of_action_1_does_not_help_either():
    assert collapses(FIRST.high, SECOND.low)


def test_just_above_the_lower_end_of_action_1_the_plan_fails_at_that_of_action_2():
    assert collapses(FIRST.low + SLIGHT, SECOND.low + SLIGHT)
    assert not collapses(FIRST.low + SLIGHT, SECOND.low)
    assert not collapses(FIRST.low + SLIGHT, SECOND.low - SLIGHT)


@pytest.mark.parametrize("following", [SECOND.angle, SECOND.high, SECOND.low + SLIGHT])
def test_action_1_fails_at_its_lower_end_whatever_follows(following):
    """Nothing stands between the mouth and action 1 but the free turn."""
    assert not collapses(FIRST.low, following)


def test_the_whole_preimage_of_action_2_is_not_collapsed_at_its_lower_end():
    """The plan of two steps, which starts from all of the preimage, fails at `low`."""
    shorter = PROBLEM.plan_of(2)
    assert shorter.actions[1] == SECOND
    assert collapses(SECOND.low + SLIGHT, mouth=shorter.mouth)
    assert not collapses(SECOND.low, mouth=shorter.mouth)
