"""A grasp with friction in words and tables."""

from __future__ import annotations

from collections.abc import Sequence

from gmpy2 import mpq

from stochgeom.cli.layout import table
from stochgeom.exact.angles import Angle
from stochgeom.exact.cells import CellSet
from stochgeom.exact.intervals import Interval, inward_decimals
from stochgeom.exact.scalars import rational_text
from stochgeom.grasping.contacts import Pair
from stochgeom.grasping.friction_limits import FrictionLimit
from stochgeom.grasping.grasp_report import GraspReport

MOST_ROWS = 40
"""Longer tables are cut; ``--json`` has every row."""


def grasp_text(report: GraspReport, digits: int) -> str:
    """Return the whole report of ``stochgeom grasp``."""
    blocks = [
        _headline(report, digits),
        _outcomes(report, digits),
        _wedging(report, digits),
        _guaranteed(report, digits),
        _bounds(report, digits),
    ]
    if report.probability is not None:
        blocks.append(_largest(report, digits))
    blocks.append(
        "Orientations are degrees counter-clockwise of the part relative to the gripper, whose "
        "jaws\nare parallel to the x axis. A square bracket takes the end in, a round one leaves "
        "it out."
    )
    return "\n\n".join(blocks)


def _headline(report: GraspReport, digits: int) -> str:
    part, friction = report.diagram.part, report.diagram.friction
    lower = report.diagram.lower
    x, y = part.center_of_mass
    degrees = friction.angle.degrees(digits)
    name = f"{part.name or 'part'}: {len(part)} vertices, {len(part.hull)} on the convex hull"
    return "\n".join(
        [
            f"{name}, centre of mass ({rational_text(x)}, {rational_text(y)})",
            f"friction: mu = {_short(str(friction))}, friction angle {degrees} degrees",
            f"pushed by the lower jaw: stable at {_listed(lower.stable, digits)};",
            f"  unstable at {_listed(lower.unstable, digits)}",
        ]
    )


def _short(number: str) -> str:
    return number if len(number) <= 40 else f"{number[:16]}... ({len(number)} characters)"


def _listed(angles: Sequence[Angle], digits: int) -> str:
    shown = [angle.degrees(digits) for angle in angles[: MOST_ROWS // 2]]
    more = len(angles) - len(shown)
    return ", ".join([*shown, f"and {more} more"] if more else shown)


def _outcomes(report: GraspReport, digits: int) -> str:
    rows = [
        [
            edge.orientation.degrees(digits),
            _edge(edge.lower_edge),
            _edge(edge.upper_edge),
            "friction" if edge.by_friction else "shape",
            bound.decimal(digits),
        ]
        for edge, bound in report.pushing_bounds
    ]
    header = ["orientation", "lower edge", "upper edge", "held by", "ends here at least"]
    return "Stable orientations\n" + _cut(header, rows)


def _edge(edge: Pair | None) -> str:
    return "-" if edge is None else f"{edge[0]}-{edge[1]}"


def _wedging(report: GraspReport, digits: int) -> str:
    rows = [
        [
            "({}, {})".format(*inward_decimals(wedge.start, wedge.arc.end, digits)),
            f"{wedge.vertices[0]}, {wedge.vertices[1]}",
        ]
        for wedge in report.diagram.wedging
    ]
    if not rows:
        return "Wedged: in no orientation."
    return "Wedged\n" + _cut(["orientations", "between vertices"], rows)


def _cut(header: list[str], rows: list[list[str]]) -> str:
    text = table(header, rows[:MOST_ROWS])
    more = len(rows) - MOST_ROWS
    return f"{text}\n  and {more} more; --json has all of them" if more > 0 else text


def _guaranteed(report: GraspReport, digits: int) -> str:
    guaranteed = report.diagram.guaranteed
    if not guaranteed:
        lines = ["No orientation is guaranteed to end stable: some push may wedge it."]
    elif guaranteed.is_whole:
        return "Every orientation is guaranteed to end stable: any tolerance, any grasp angle."
    else:
        lines = [
            "Guaranteed to end stable, whichever jaw touches first and however far it pushes:",
            *_intervals(guaranteed, digits),
        ]
    if report.tolerances:
        shown = [item.decimals(digits) for item in report.tolerances[: MOST_ROWS // 2]]
        angles = ", ".join(angle for angle, _ in shown)
        margin = min((margin for _, margin in shown), key=mpq)
        least = "at most" if report.tolerances[0].attained else "less than"
        lines += [
            f"Largest tolerance: an orientation known to {least} {margin} degrees (rounded down),",
            f"  with the gripper turned by {angles} degrees from the part's input pose",
        ]
    if report.tolerance is not None:
        lines += _tolerance(report, digits)
    return "\n".join(lines)


def _tolerance(report: GraspReport, digits: int) -> list[str]:
    assert report.tolerance is not None
    asked = report.tolerance.degrees(digits)
    if not report.grasps:
        return [f"No grasp bears an error of {asked} degrees."]
    return [
        f"An error of {asked} degrees either way is borne by the gripper turned by",
        *_intervals(report.grasps, digits),
    ]


def _intervals(cells: CellSet, digits: int) -> list[str]:
    found = cells.intervals()
    lines = [f"  {_interval(item, digits)}" for item in found[:MOST_ROWS]]
    more = len(found) - MOST_ROWS
    return [*lines, f"  and {more} more; --json has all of them"] if more > 0 else lines


def _interval(item: Interval, digits: int) -> str:
    """Return an interval rounded inwards, but for a single orientation."""
    if not item.width:
        return f"{item.start.degrees(digits)} exactly"
    return item.text(digits)


def _bounds(report: GraspReport, digits: int) -> str:
    diagram = report.diagram
    rows = [
        ["whatever the push does (Eq. 3.13)", diagram.bound.decimal(digits)],
        [
            "  turning into a wedging interval counted as wedged",
            diagram.strict_bound.decimal(digits),
        ],
        ["every length of the push equally likely (App. C)", report.pushing_bound.decimal(digits)],
    ]
    if report.prior is not None:
        rows.insert(
            1, [f"  under the prior: {report.prior.describe()}", report.prior_bound.decimal(digits)]
        )
    title = "A random grasp ends stable with a probability of at least"
    return title + "\n" + "\n".join(table(["", ""], rows, left=[0]).splitlines()[1:])


def _largest(report: GraspReport, digits: int) -> str:
    assert report.probability is not None
    rows = [
        ["whatever the push does", _limit(report.largest_mu, digits)],
        ["every length equally likely", _limit(report.largest_mu_pushing, digits)],
    ]
    shown = rational_text(report.probability)
    title = f"Largest mu for a probability of at least {shown}, rounded down"
    lines = [title, *table(["", ""], rows, left=[0]).splitlines()[1:]]
    if report.limit.compare(1) < 0:
        limit = report.limit.decimal(digits)
        lines.append(
            f"As mu goes to 0 the bound whatever the push does goes to {limit};\n"
            "without friction it is 1."
        )
    return "\n".join(lines)


def _limit(limit: FrictionLimit | None, digits: int) -> str:
    return "any" if limit is None else limit.decimal(digits)
