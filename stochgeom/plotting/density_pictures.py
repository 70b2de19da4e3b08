"""Densities of the Beta distribution (thesis Figs. G.1 to G.4); needs the extra ``plot``.

The source plots the density of p_2, not of p_1: so Fig. G.4, with a_1 = 4 and a_2 = 1, has its mean
at .2. See `stochgeom.tilting.beta_density`.
"""

from __future__ import annotations

from math import floor, log10
from typing import TYPE_CHECKING, Final

import numpy as np
from gmpy2 import mpq

from stochgeom.errors import NumberLimitError
from stochgeom.exact.decimals import rational_decimal
from stochgeom.exact.scalars import RationalLike, rational_text
from stochgeom.plotting.axes import axes_or_new
from stochgeom.plotting.scene import shortened
from stochgeom.plotting.styles import STYLES
from stochgeom.tilting.beta_density import BetaDensity

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_EDGE: Final = 1 / 1000
"""The density may be infinite at 0 and 1; it is drawn from here on."""

_LEAST, _MOST = mpq(1, 10**100), mpq(10**9)
"""Of the parameters: beyond these the density in floats is off by more than a line's width."""

_MOST_OF_A_POLE: Final = 6.0

_DEVIATIONS: Final = 6.0
_NARROW: Final = 0.25
"""A density that stands within 6 deviations in less of [0, 1] is drawn larger."""

_LONG: Final = 12
_LETTERS: Final = 64
"""Longer fractions are written as decimals, longer titles in two lines."""


def draw_beta_density(alpha_1: RationalLike, alpha_2: RationalLike, ax: Axes | None = None) -> Axes:
    """Draw the density of p_2 under a Beta distribution, its mean and variance in the title.

    Where nearly all of it stands in less than a quarter of [0, 1], only that part is drawn.

    Parameters
    ----------
    alpha_1, alpha_2 : positive rational
        The parameters of the Dirichlet distribution of (p_1, p_2).
    ax : Axes, optional
        Where; default: on a new figure.

    Raises
    ------
    PriorError
        If a parameter is not positive.
    NumberLimitError
        If one is so small or large that floats do not hold the density.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> draw_beta_density("0.1", "0.1", Figure().subplots()).get_title()
    'α₁ = 1/10, α₂ = 1/10: mean 0.500, variance 0.208'
    """
    beta = BetaDensity(alpha_1, alpha_2)
    for alpha, name in ((beta.alpha_1, "alpha_1"), (beta.alpha_2, "alpha_2")):
        if not _LEAST <= alpha <= _MOST:
            raise NumberLimitError(
                f"{shortened(rational_text(alpha), _LONG)} is no parameter to draw; accepted: "
                f"{float(_LEAST):g} to {float(_MOST):g}",
                where=name,
            )
    ax = axes_or_new(ax, (4.8, 3.0))
    low, high = _range(beta)
    edge = _EDGE * (high - low)
    p = np.linspace(low + edge, high - edge, 999)
    density = np.array([beta(float(x)) for x in p])
    ax.plot(p, density, color=STYLES["curve"].stroke, linewidth=1.5)
    ax.axvline(float(beta.mean), color=STYLES["ghost"].stroke, linewidth=0.9, linestyle="--")
    pole = (beta.alpha_2 < 1 and low == 0.0) or (beta.alpha_1 < 1 and high == 1.0)
    inner = float(density[49:-49].max())
    ax.set_ylim(0.0, _MOST_OF_A_POLE * inner if pole else 1.15 * float(density.max()))
    ax.set_xlim(low, high)
    ax.set_xlabel("p₂" if (low, high) == (0.0, 1.0) else "p₂ (a part of 0 to 1)")
    ax.set_ylabel("density")
    if high - low < 1.0:
        ax.ticklabel_format(axis="x", useOffset=False, style="plain")
        ax.locator_params(axis="x", nbins=4)
    title = f"α₁ {_parameter(beta.alpha_1)}, α₂ {_parameter(beta.alpha_2)}: "
    variance = float(beta.variance)
    mean = _decimal(beta.mean, variance**0.5)
    moments = f"mean {mean}, variance {_decimal(beta.variance, variance)}"
    ax.set_title(title + ("\n" if len(title + moments) > _LETTERS else "") + moments, fontsize=9)
    return ax


def _range(beta: BetaDensity) -> tuple[float, float]:
    """Return 0 and 1, or what holds nearly all of a narrow density."""
    mean, sd = float(beta.mean), float(beta.variance) ** 0.5
    low, high = max(0.0, mean - _DEVIATIONS * sd), min(1.0, mean + _DEVIATIONS * sd)
    return (low, high) if high - low < _NARROW else (0.0, 1.0)


def _parameter(alpha: mpq) -> str:
    text = rational_text(alpha)
    return f"= {text}" if len(text) <= _LONG else f"≈ {rational_decimal(alpha, 6)}"


def _decimal(value: mpq, smallest: float) -> str:
    """Return a number with three decimals, or as many as show two digits of something smaller."""
    digits = 3 if smallest >= _EDGE else 1 - floor(log10(smallest))
    return rational_decimal(value, digits)
