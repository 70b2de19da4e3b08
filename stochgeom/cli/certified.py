"""What a certificate that was found valid has proved, and what it says nothing of."""

from __future__ import annotations

from typing import Any

from stochgeom.errors import NumberError
from stochgeom.exact.angles import Angle
from stochgeom.exact.decimals import Rounding, significant
from stochgeom.exact.surds import exact_scalar


def scope(document: dict[str, Any]) -> list[str]:
    """Return for whom the plan of a valid certificate was certified, and what follows from it.

    The final orientation and the ranges are claims that the checker has found to be right. What
    follows is worked out here: the gripper error that the plan bears, which is the least distance
    of an angle from an end of its range.
    """
    plan = document["plan"]
    lines = [
        "certified for parts that arrive in any orientation, all equally likely; compared with all",
        "plans of an exact gripper, whatever their final orientation. No prior is certified.",
    ]
    try:
        final = angle_of(plan["final_orientation"]).reduced()
        rooms = [room for claim in plan["actions"] for room in _rooms(claim)]
    except NumberError:  # directions over a field, in letters that only the field explains
        return [*lines, "Its final orientation and its ranges are in the certificate."]
    least = min(rooms, default=None)
    if least is None:
        borne = "any gripper error"
    elif not least:  # an angle at the closed end of its range
        borne = "no gripper error"
    else:
        room = least
        shown = significant(lambda digits: room.degrees(digits, Rounding.DOWN), 4)
        borne = f"gripper errors below {shown} degrees"
    where = f"{final.degrees()} degrees relative to the gripper"
    return [*lines, f"The plan ends at {where}, and bears {borne}."]


def angle_of(claim: dict[str, Any]) -> Angle:
    """Return the angle of a claim.

    Raises
    ------
    NumberError
        If its direction is over a field that the text alone does not tell.

    Examples
    --------
    >>> angle_of({"turns": "1/10", "direction": ["3", "2"]}).degrees(2)
    '69.69'
    """
    x, y = (exact_scalar(text) for text in claim["direction"])
    return Angle(claim["turns"], (x, y))


def _rooms(claim: dict[str, Any]) -> tuple[Angle, ...]:
    """Return the distances of an angle from the ends of its range, if it has one."""
    if claim["low"] is None:
        return ()
    low, angle, high = (angle_of(claim[key]) for key in ("low", "angle", "high"))
    return angle - low, high - angle
