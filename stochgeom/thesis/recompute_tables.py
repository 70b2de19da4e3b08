"""What settles the errata of tables and of figures of numbers; see also `recompute_densities`."""

from __future__ import annotations

from collections.abc import Mapping
from fractions import Fraction
from typing import Final

from gmpy2 import mpq

from stochgeom.exact.angles import HALF_TURN, Angle
from stochgeom.exact.balls import (
    Ball,
    exact_value,
    full_turn_ball,
    rational_ball,
    working_precision,
)
from stochgeom.exact.decimals import rational_decimal
from stochgeom.exact.scalars import rational
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.thesis.appendix_g import FIGURES_G
from stochgeom.thesis.chapter_6 import (
    FIGURE_6_4_COPY,
    SPARE_COLUMNS,
    figure_6_4_counts,
    figure_6_4_model,
    figure_6_4_printed,
    recover_counts,
)
from stochgeom.thesis.errata import TABLE_4_1, TABLE_C_1
from stochgeom.thesis.facts import Fact, Facts, equal, fraction, half_unit, places
from stochgeom.thesis.figures_4 import FIGURE_4_6
from stochgeom.thesis.grasp_tables import table_c_1
from stochgeom.thesis.parts import catalogue_entry, catalogue_part
from stochgeom.tilting.beta_density import BetaDensity

RANGES: Final = 420
"""Of angles of rectangles, for each radian."""


def four_gon_at_three_steps() -> Facts:
    """Show that no 4gon with the printed Fig. 4.6 has 16.0 as the cost of its best 3-step plan.

    The last two squeezes of the figure take states 2 and 4 to one. A squeeze is a monotone map of
    degree one, so these two take all states between to that one too: 2, 3, 4, or 4, 5, 6 (5 is 1
    half a turn on, 6 is 2). A random squeeze and these two are a plan of three steps.
    """
    erratum = TABLE_4_1["4gon", 3]
    first, merged, _, last = FIGURE_4_6.rows
    shares = [fraction(share) for share in first[:4]]
    error = half_unit(first[0])
    runs = [shares[1] + shares[2] + shares[3], shares[3] + shares[0] + shares[1]]
    least = min(runs) - 3 * error
    most = 4 / least
    most_left_out = max(shares[0], shares[2]) + error
    sharp = 4 / (Fraction(1, 2) - most_left_out)
    cost = FeedingProblem(catalogue_part("4gon")).expected_cost(3)
    printed = fraction(erratum.printed)
    two = {k for k, share in enumerate(merged[:4], start=1) if fraction(share)}
    ends = [share for share in last[:4] if fraction(share)]
    return (
        equal("states with probability before the last two squeezes of Fig. 4.6", two, {2, 4}),
        equal("and after them: one state has all of half a turn", ends, ["0.50"]),
        Fact("least probability of what lies between, rounded down", places(least), least > 0),
        Fact(
            f"so the best 3-step plan costs at most 4 / {places(least)}, below {erratum.printed}",
            places(most),
            most < printed - half_unit(erratum.printed),
        ),
        Fact(
            "sharper, as the states of half a turn add up to one half: 4 / (1/2 - .115 or .125)",
            places(sharp),
            sum(shares) == Fraction(1, 2) and sharp < most,
        ),
        Fact("the rebuilt part keeps the bound", cost.decimal(), fraction(cost.decimal(6)) < sharp),
        equal(
            "16.0 is the cost of 4 over .25, the largest probability before",
            4 / Fraction(1, 4),
            printed,
        ),
    )


def key_at_three_steps() -> Facts:
    """Show that with 6.2 at two steps, three steps collapse the period of the key, and cost 8.0.

    An arc as wide as the period takes in all stable orientations of one period, so its image misses
    one gap between neighbours. Where that gap exceeds T - h_2 the arc is collapsed by 3 steps.
    """
    entry = catalogue_entry("key")
    two_steps = entry.printed["T4.1 2-step"]
    least_width = Fraction(3 * 360) / (fraction(two_steps) + half_unit(two_steps))
    gap = Fraction(180, entry.sides_printed)
    problem = FeedingProblem(entry.part)
    second = problem.preimages.of_steps(2)
    width = Angle.from_degrees(str(least_width))
    return (
        Fact(
            f"h_2 in degrees is at least 3 x 360 / {places(fraction(two_steps), 1)}5, "
            "which leaves of 180",
            places(180 - least_width),
            least_width > 90,  # so that T is 180: a shorter period is 90 at most
        ),
        Fact(
            f"the widest of at most {entry.sides_printed} gaps that share 180 degrees is at least",
            places(gap),
            gap > 180 - least_width,
        ),
        Fact(
            "h_2 of the rebuilt part",
            second.width.degrees(),
            width <= second.width < HALF_TURN,
        ),
        equal("its cost at three steps", problem.expected_cost(3).decimal(1), "8.0"),
    )


def rectangle_in_table_c_1() -> Facts:
    """Show that no rectangle has .99 at mu = .05 and its two other cells of Table C.1.

    With its centre of mass in the middle, side ratio r, alpha = arctan mu, and L for each of atan r
    and atan 1 / r: between a stable orientation and the unstable one L beyond it all but the last
    alpha is safe, so the bound is (2 / pi) times the sum of F = b (1 + ln(L / b)), b = L - alpha (0
    if L is below alpha). F grows with L, as dF / dL = ln(L / b) + b / L > 0; so on a range of
    angles F is enclosed by its values at the ends. The smaller angle is cut into ranges.
    """
    erratum = TABLE_C_1["rectangle", "0.05"]
    cells = {(row.name, k): cell for row in table_c_1() for k, cell in enumerate(row.cells)}
    printed = catalogue_entry("rectangle").printed
    cell = cells.pop(("rectangle", 2))
    rounded = sum(other.agrees for other in cells.values())
    with working_precision(64):
        ranges = [(mpq(k, RANGES), mpq(k + 1, RANGES)) for k in range(RANGES * 11 // 14 + 1)]
        near = rectangle_bounds(mpq(58800, 10**5), mpq(58801, 10**5), "0.05")  # arctan 2 / 3
        closed = [rational_decimal(exact_value(ball.mid()), 4) for ball in near]
        left = [r for r in ranges if all(_may_be(r, mu, printed) for mu in ("0.25", "0.1"))]
        least = min(exact_value(rectangle_bounds(*r, "0.05")[0].lower()) for r in left)
    return (
        equal("the bound of the rebuilt rectangle, 3 to 2", cell.computed.decimal(), "0.9978"),
        equal("  by the closed form, of a range around it", closed, [cell.computed.decimal()] * 2),
        Fact(
            f"rounds to two decimals, not to {erratum.printed}",
            cell.computed.decimal(2),
            cell.computed.decimal(2) != erratum.printed,
        ),
        Fact(
            f"ranges of the smaller angle, of {len(ranges)} that are all rectangles, in which .94 "
            "and .99 may hold at mu = .25 and .10",
            str(len(left)),
            0 < len(left) < len(ranges),
        ),
        Fact(
            "in all of these the bound at mu = .05 is at least",
            rational_decimal(least, 4),
            least > mpq(995, 1000),
        ),
        equal(f"of {len(cells)} other cells, rounded as printed", rounded, len(cells)),
    )


def rectangle_bounds(low: mpq, high: mpq, mu: str) -> tuple[Ball, Ball]:
    """Return balls no more and no less than Table C.1's bound of all rectangles of a range.

    ``low`` and ``high`` are radians between the long side and a diagonal, from 0 on. At the working
    precision.
    """
    ends = [rational_ball(low), rational_ball(high)]
    across = [full_turn_ball() / 4 - end for end in ends]
    alpha = rational_ball(rational(mu)).atan()
    safe = [_safe(length, alpha) for length in (*ends, *across)]
    share = 4 / full_turn_ball()
    return share * (safe[0] + safe[3]), share * (safe[1] + safe[2])


def _safe(length: Ball, alpha: Ball) -> Ball:
    b = length - alpha
    return rational_ball(0) if b < 0 else b * (1 + (length / b).log())


def _may_be(angles: tuple[mpq, mpq], mu: str, printed: Mapping[str, str]) -> bool:
    """Tell whether a rectangle of the range may have its printed cell, unless that is excluded."""
    cell = rational(printed[f"C.1 mu={mu}"])
    least, most = rectangle_bounds(*angles, mu)
    half = mpq(1, 200)
    return not (least > rational_ball(cell + half) or most < rational_ball(cell - half))


def sides_of_the_rectangle() -> Facts:
    """Show that a rectangle has four sides, as Table 4.1 says."""
    entry = catalogue_entry("rectangle")
    return (
        equal("edges of the rebuilt part", len(entry.part), 4),
        equal("sides in Table 4.1", entry.sides_printed, 4),
    )


def figure_6_4_row_8() -> Facts:
    """Show that no counts give p(8, 12) and the rest of its row."""
    return _one_misprint(8, 12, "0.0715")


def figure_6_4_row_12() -> Facts:
    """Show that no counts give p(12, 12) and the rest of its row."""
    return _one_misprint(12, 12, "0.9909")


def _one_misprint(state: int, column: int, holds: str) -> Facts:
    row = figure_6_4_printed()[state - 1]
    exact = recover_counts(row, misprints=0)
    best = recover_counts(row)[0]
    entry = figure_6_4_model().row(1, state)[column - 1]
    return (
        equal(f"counts of up to 400 trials that give row {state} as printed", len(exact), 0),
        equal("columns that the nearest counts give otherwise", best.misprints, (column - 1,)),
        equal(
            f"with the counts {sorted(filter(None, best.counts), reverse=True)} the entry is",
            rational_decimal(entry, 4),
            holds,
        ),
    )


def columns_of_figure_6_4() -> Facts:
    """Show that a column of the copy is spare, and that it does not matter which."""
    rows = [row.split() for row in FIGURE_6_4_COPY]
    alike = all(len({row[k] for k in SPARE_COLUMNS}) == 1 for row in rows)
    with_13 = recover_counts(rows[0], misprints=0)
    return (
        equal("rows of the copy", len(rows), 12),
        equal("entries in each", {len(row) for row in rows}, {13}),
        Fact("columns 4 to 11 are alike in every row", str(alike), alike),
        equal("counts that give the first row with 13 columns", len(with_13), 0),
        equal("trials behind the matrix with 12", figure_6_4_counts().total, 177),
    )


def figure_g_3() -> Facts:
    """Show that the printed variance is that of alpha = 16."""
    printed = next(figure for figure in FIGURES_G if figure.figure == "G.3")
    decimals = [rational_decimal(BetaDensity(a, a).variance, 4) for a in (8, 16)]
    return (
        equal("variance for alpha = 8", decimals[0], "0.0147"),
        equal("variance for alpha = 16", decimals[1], "0.0076"),
        equal(
            "to the printed digits, alpha = 16 gives",
            rational_decimal(printed.density.variance, 3),
            printed.variance,
        ),
    )


def text_of_section_4_8() -> Facts:
    """Show that 6.0 is the cost of two squeezes of the house; one costs 5.0."""
    problem = FeedingProblem(catalogue_part("house"))
    return (
        equal("cost of one step", problem.expected_cost(1).decimal(1), "5.0"),
        equal("cost of two steps", problem.expected_cost(2).decimal(1), "6.0"),
    )
