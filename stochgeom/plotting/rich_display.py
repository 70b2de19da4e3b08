"""What notebooks show of a value: the table that the facade registers.

Small pictures and short tables; whoever wants more calls a drawing function or `to_html`.
"""

from __future__ import annotations

import os
from typing import Final

from stochgeom.display import Renderers
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.geometry.part import Part
from stochgeom.plotting.function_scenes import step_scene
from stochgeom.plotting.part_scenes import part_scene
from stochgeom.plotting.svg import svg_document
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


def plan_report(plan: FeedingPlan, path: str | os.PathLike[str], *, digits: int) -> None:
    """Write a plan as a page; see `stochgeom.plotting.report`."""
    from stochgeom.plotting.report import write_report

    write_report(plan, path, digits=digits)


RENDERERS: Final[Renderers] = {
    ("FeedingPlan", "report"): plan_report,
    ("Part", "svg"): part_svg,
    ("StepFunction", "svg"): step_function_svg,
}
