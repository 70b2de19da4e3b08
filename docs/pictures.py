"""The pictures of the manual and the README, drawn anew.

    python docs/pictures.py

writes them into docs/pictures/. They are drawn without matplotlib, so that the same bytes come out
everywhere; `tests/repo/test_manual.py` holds the files to what is drawn here.
"""

from __future__ import annotations

from pathlib import Path
from typing import Final

from stochgeom import (
    AdditiveCost,
    DiameterFunction,
    FeedingPlan,
    FeedingProblem,
    Part,
    PlanningProblem,
    Sensor,
    all_sensor_plans,
    catalogue_part,
)
from stochgeom.exact.angles import Angle
from stochgeom.plotting.and_or_scenes import and_or_scene
from stochgeom.plotting.function_scenes import analysis_scene
from stochgeom.plotting.funnel_scenes import funnel_scene
from stochgeom.plotting.grasp_scenes import grasp_scene
from stochgeom.plotting.part_scenes import part_scene
from stochgeom.plotting.scene import Scene
from stochgeom.plotting.svg import svg_document
from stochgeom.plotting.trace_scenes import trace_scene

FOLDER: Final = Path(__file__).resolve().parent / "pictures"


WEDGE: Final = Part([(0, 0), ("2.5", 0), ("2.5", 1), ("0.3", "1.7")], name="wedge")
"""The part of the first tutorial."""


def plan_of(part: Part) -> FeedingPlan:
    """Return the shortest plan of a part."""
    return FeedingProblem(part).geometric_plan()


def trace(part: Part, degrees: tuple[int, ...]) -> Scene:
    """Return the part and the gripper after each action, a column for each orientation."""
    return trace_scene(plan_of(part), [Angle.from_degrees(value) for value in degrees])


def analysis(part: Part) -> Scene:
    """Return the diameter function, the squeeze function and the preimages of a part."""
    problem = FeedingProblem(part)
    wave = DiameterFunction(part)
    return analysis_scene(problem.transfer, problem.preimages, wave, name="squeeze function")


def coin_tree() -> Scene:
    """Return all plans of two moves of the coin of the tutorial."""
    cost = AdditiveCost(actions="1/8", states={"tails": 1})
    coin = PlanningProblem(
        ["heads", "tails"], ["1/2", "1/2"], ["turn"], {"turn": [[0, 1], [1, 0]]}, cost
    )
    eye = Sensor.noisy(coin.states, "1/10", cost="1/16")
    return and_or_scene(all_sensor_plans(coin, eye, 2))


def pictures() -> dict[str, str]:
    """Return the SVG documents by the names of their files."""
    rectangle = catalogue_part("rectangle")
    fourgon = catalogue_part("4gon")
    return {
        "wedge.svg": svg_document(part_scene(WEDGE), title="the part of the tutorial", scale=90),
        "wedge-analysis.svg": svg_document(
            analysis(WEDGE),
            title="diameter function, squeeze function and preimages of the wedge",
            scale=1,
        ),
        "wedge-trace.svg": svg_document(
            trace(WEDGE, (20, 71, 110, 150)),
            title="three squeezes orient the wedge up to symmetry",
            scale=24,
        ),
        "stable.svg": svg_document(
            grasp_scene(rectangle, Angle.from_degrees(0)), title="a stable grasp", scale=70
        ),
        "wedged.svg": svg_document(
            grasp_scene(rectangle, Angle.from_degrees(60)), title="a wedged grasp", scale=70
        ),
        "trace.svg": svg_document(
            trace(rectangle, (20, 75, 140)),
            title="two squeezes orient a rectangle, whatever its orientation was",
            scale=26,
        ),
        "fourgon-trace.svg": svg_document(
            trace(fourgon, (10, 60, 100, 150)),
            title="four squeezes orient the 4gon up to symmetry",
            scale=24,
        ),
        "analysis.svg": svg_document(
            analysis(fourgon),
            title="diameter function, squeeze function and preimages of the 4gon",
            scale=1,
        ),
        "funnel.svg": svg_document(
            funnel_scene(plan_of(fourgon)), title="the plan of the 4gon as a funnel", scale=1
        ),
        "coin-tree.svg": svg_document(
            coin_tree(), title="all plans of two moves, to turn or to look at a coin", scale=1
        ),
    }


def main() -> None:
    """Write the pictures."""
    FOLDER.mkdir(exist_ok=True)
    for name, text in pictures().items():
        (FOLDER / name).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    main()
