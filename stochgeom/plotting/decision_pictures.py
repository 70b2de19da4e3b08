"""Pictures of decisions on matplotlib `Axes`: risks and sensors; extra ``plot``.

Risk curves (thesis Fig. A.1), and the density of a sensor's data with the bins it is read in (Figs.
7.2 and 7.3).
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from itertools import pairwise
from textwrap import wrap
from typing import TYPE_CHECKING, Any, Final

import numpy as np
from gmpy2 import mpq

from stochgeom.arguments import expect
from stochgeom.decision.decision_rules import DecisionProblem, Rule
from stochgeom.errors import InputError, SensorError
from stochgeom.exact.decimals import rational_decimal
from stochgeom.exact.quotients import number_decimal
from stochgeom.exact.scalars import RationalLike, rational, rational_text
from stochgeom.plotting.arguments import as_drawn
from stochgeom.plotting.axes import axes_or_new, need_matplotlib
from stochgeom.plotting.function_pictures import LETTERS, size_in_points
from stochgeom.plotting.styles import INK, STYLES
from stochgeom.sensing.gaussian import gaussian_bins

if TYPE_CHECKING:
    from matplotlib.axes import Axes

MOST_RULES: Final = 8
"""More curves in one picture cannot be told apart."""

_LEAST_DEVIATION: Final = 1e-9
"""Of the true value: floats do not tell the data of a smaller one apart."""

_DASHES: Final = ("-", "--", ":", "-.", (0, (7, 2)), (0, (1, 3)), (0, (7, 2, 1, 2, 1, 2)),
                  (0, (3, 1)))  # fmt: skip
_MARKERS: Final = "osD^vP*X"
_LETTERS: Final = 60
"""On a line of the legend of a new figure."""

_MOST_LINES: Final = 3


def draw_sensor_density(
    true_value: RationalLike,
    sd: RationalLike,
    edges: Iterable[RationalLike] = (),
    ax: Axes | None = None,
) -> Axes:
    r"""Draw the density of a sensor's data, and the probabilities of the bins it is read in.

    The data are normal about the true value (Fig. 7.2); a sensor of b bits tells which of 2^b bins
    they fall into (Fig. 7.3). The probabilities are certified decimals. They stand upright in
    narrow bins; of bins that are too narrow even for that, the label of the axis counts.

    Parameters
    ----------
    true_value : rational, 0 or more
        Such as the diameter of the part between the jaws.
    sd : positive rational
        Standard deviation.
    edges : iterable of rationals
        Increasing; the first bin begins at minus infinity, the last one has no end.
    ax : Axes, optional
        Where; default: on a new figure.

    Raises
    ------
    SensorError
        If the true value is negative, the deviation is not positive or too small to be seen beside
        it, or edges do not increase.
    NumberLimitError
        If floats do not hold a number.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> ax = draw_sensor_density(2, 1, [1, 2, 3], Figure().subplots())
    >>> [text.get_text() for text in ax.texts]
    ['x₁\n0.1587', 'x₂\n0.3413', 'x₃\n0.3413', 'x₄\n0.1587']
    """
    center, spread, ends = _checked_density(true_value, sd, edges)
    ax = axes_or_new(ax, (5.6, 3.2))
    d, s = as_drawn(center, "true value"), as_drawn(spread, "sd")
    places = [as_drawn(edge, f"edge {k}") for k, edge in enumerate(ends, 1)]
    if s < _LEAST_DEVIATION * d:
        raise SensorError(
            f"{s:g} beside a true value of {d:g} is too small to be seen; accepted: from "
            f"{_LEAST_DEVIATION:g} of it on",
            where="sd",
        )
    low, high = d - 4 * s, d + 4 * s
    if ends:
        margin = 0.12 * (places[-1] - places[0] or s)
        low, high = min(low, places[0] - margin), max(high, places[-1] + margin)
    x = np.union1d(np.linspace(low, high, 401), d + s * np.linspace(-4, 4, 201))
    y = np.exp(-(((x - d) / s) ** 2) / 2) / (s * np.sqrt(2 * np.pi))
    top = 1.3 * float(y.max())
    look = STYLES["curve"]
    ax.fill_between(x, y, color=STYLES["density"].fill, linewidth=0)
    ax.plot(x, y, color=look.stroke, linewidth=look.width)
    ax.vlines(places, 0, top, colors=INK, linewidth=0.9)
    ax.axvline(d, color=STYLES["ghost"].stroke, linewidth=0.9, linestyle="--")
    ax.set(xlim=(low, high), ylim=(0.0, top), xlabel="data", ylabel="density")
    if ends:
        shares = _bin_decimals(center, spread, ends)
        unnamed = _name_bins(ax, [low, *places, high], shares)
        if unnamed:
            ax.set_xlabel(f"data ({unnamed} of {len(shares)} bins too narrow to be named)")
    title = f"true value {rational_text(center)}, standard deviation {rational_text(spread)}"
    ax.set_title(title, fontsize=LETTERS + 1)
    return ax


def _name_bins(ax: Axes, ends: Sequence[float], shares: Sequence[str]) -> int:
    """Write the numbers of the bins and their probabilities; return for how many is no room."""
    (low, high), (_, top), size = ax.get_xlim(), ax.get_ylim(), LETTERS - 1.5
    unit, unnamed = size_in_points(ax)[0] / (high - low), 0
    for k, (left, right) in enumerate(pairwise(ends)):
        room, name = (right - left) * unit, f"x{_lowered(k + 1)}"
        level = room >= 0.64 * size * len(shares[k]) + 2
        if not level and room < 1.25 * size:
            unnamed += 1
            continue
        text = f"{name}\n{shares[k]}" if level else f"{name} {shares[k]}"
        ax.text((left + right) / 2, 0.97 * top, text, ha="center", va="top", fontsize=size,
                rotation=0 if level else 90)  # fmt: skip
    return unnamed


def _checked_density(
    true_value: RationalLike, sd: RationalLike, edges: Iterable[RationalLike]
) -> tuple[mpq, mpq, list[mpq]]:
    center, spread = rational(true_value, where="true value"), rational(sd, where="sd")
    listed = expect(edges, Iterable, "a list of edges")
    ends = [rational(edge, where=f"edge {k}") for k, edge in enumerate(listed, 1)]
    if center < 0:
        raise SensorError(f"{rational_text(center)}; accepted: 0 or more", where="true value")
    if spread <= 0:
        raise SensorError(f"{rational_text(spread)}; accepted: positive numbers", where="sd")
    for k, (low, high) in enumerate(pairwise(ends), 2):
        if low >= high:
            text = f"{rational_text(high)} after {rational_text(low)}; accepted: increasing"
            raise SensorError(text, where=f"edge {k}")
    return center, spread, ends


def _bin_decimals(center: mpq, spread: mpq, ends: list[mpq]) -> list[str]:
    """Return the probabilities of the bins with 4 decimals, each correctly rounded.

    From more digits, as many as it takes: those of a row are adjusted so that their sum is 1.
    """
    digits = 12
    while True:
        row, error = gaussian_bins(center * center, spread, ends, digits)
        low, high = ([rational_decimal(p + e, 4) for p in row] for e in (-error, error))
        if not ends:
            return ["1.0000"]
        if all(a.lstrip("-") == b for a, b in zip(low, high, strict=True)):
            return high
        digits *= 2


def _lowered(number: int) -> str:
    return "".join("₀₁₂₃₄₅₆₇₈₉"[int(digit)] for digit in str(number))


# --- risks ---------------------------------------------------------------------------------------


def draw_risks(
    problem: DecisionProblem,
    rules: Sequence[Rule | Mapping[Any, Any]] | None = None,
    ax: Axes | None = None,
) -> Axes:
    """Draw the risk of decision rules over the states, and the largest risk of each (Fig. A.1).

    The rules of least largest risk among those drawn are heavy, decided exactly.

    Parameters
    ----------
    problem : DecisionProblem
        States, readings, actions, likelihood and loss.
    rules : sequence of rules, or of mappings from readings to actions, optional
        At most 8; default: the first admissible ones, of those of equal risk one.
    ax : Axes, optional
        Where; default: on a new figure.

    Raises
    ------
    InputError
        If there are no rules, or more than 8.
    UnknownLabelError, ShapeMismatchError
        If a mapping does not fit the problem.
    NumberLimitError
        If floats do not hold a risk.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> test = DecisionProblem(
    ...     ["good", "bad"], ["pass", "fail"], ["keep", "throw"],
    ...     [["9/10", "1/10"], ["1/10", "9/10"]], [[0, 1], [5, 0]],
    ... )
    >>> ax = draw_risks(test, [{"pass": "keep", "fail": "throw"}], Figure().subplots())
    >>> ax.lines[0].get_ydata().tolist(), ax.lines[0].get_label()
    ([0.1, 0.5], 'pass: keep, fail: throw; at most 0.5000')
    """
    need_matplotlib()
    problem = expect(problem, DecisionProblem, "a DecisionProblem")
    chosen = _chosen_rules(problem, rules)
    risks = [problem.risk(rule) for rule in chosen]
    curves = [[as_drawn(value, "risk") for value in risk] for risk in risks]
    least = min(max(risk) for risk in risks)
    heavy = [max(risk) == least and len(chosen) > 1 for risk in risks]
    letters = _LETTERS if ax is None else int((size_in_points(ax)[0] - 40) / (0.6 * LETTERS))
    texts = [
        _legend_text(problem.answers(rule), max(risk), minimax, max(letters, 16))
        for rule, risk, minimax in zip(chosen, risks, heavy, strict=True)
    ]
    rows = sum(text.count("\n") + 1 for text in texts)
    ax = axes_or_new(ax, (5.6, 3.6 + 0.17 * rows))
    places = range(len(problem.states))
    for k, curve in enumerate(curves):
        ax.plot(places, curve, label=texts[k],
                color=INK if heavy[k] else STYLES["curve"].stroke,
                linewidth=2.2 if heavy[k] else 1.2, linestyle=_DASHES[k], marker=_MARKERS[k],
                markersize=5, clip_on=False)  # fmt: skip
        ax.axhline(max(curve), color=STYLES["rule"].stroke, linewidth=0.7, zorder=1)
    ax.set_xticks(places, [str(state) for state in problem.states])
    if sum(len(str(state)) for state in problem.states) > 60:
        ax.tick_params("x", labelrotation=90)
    ax.set_ylim(min(0.0, *map(min, curves)), None)
    ax.set(xlabel="state", ylabel="risk")
    ax.legend(loc="lower left", bbox_to_anchor=(0.0, 1.01), fontsize=LETTERS, frameon=False)
    return ax


def _legend_text(answers: Mapping[Any, Any], worst: Any, minimax: bool, letters: int) -> str:
    """Return a rule in lines of so many letters, its largest risk at the end."""
    words = ", ".join(f"{reading}: {action}" for reading, action in answers.items())
    lines = wrap(words, letters, max_lines=_MOST_LINES, placeholder=" …")
    tail = f"at most {number_decimal(worst)}" + ", minimax" * minimax
    joined = f"{lines[-1]}; {tail}"
    return "\n".join([*lines[:-1], joined] if len(joined) <= letters else [*lines, tail])


def _chosen_rules(
    problem: DecisionProblem, rules: Sequence[Rule | Mapping[Any, Any]] | None
) -> list[Rule]:
    if rules is None:  # of rules of equal risk, whose curves would hide each other, one
        by_risk = {problem.risk_table[rule]: rule for rule in problem.admissible_rules()[::-1]}
        return list(by_risk.values())[::-1][:MOST_RULES]
    for rule in expect(rules, Iterable, "a list of rules"):
        expect(rule, Mapping | Sequence, "a mapping from readings to actions, or their numbers")
    chosen = [problem.rule(rule) if isinstance(rule, Mapping) else tuple(rule) for rule in rules]
    if not 1 <= len(chosen) <= MOST_RULES:
        raise InputError(f"{len(chosen)} rules; accepted: 1 to {MOST_RULES}")
    known = range(len(problem.actions))
    for k, rule in enumerate(chosen, 1):
        if len(rule) != len(problem.readings) or not all(a in known for a in rule):
            raise InputError(
                f"{rule!r:.60}; accepted: for each of {len(problem.readings)} readings the number "
                f"of an action, 0 to {len(known) - 1}",
                where=f"rule {k}",
            )
    return chosen
