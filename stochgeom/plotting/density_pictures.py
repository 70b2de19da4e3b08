"""Densities of the Beta distribution (thesis Figs. G.1 to G.4); needs the extra ``plot``.

The two-state case of the Dirichlet distribution: with p_1 + p_2 = 1 the density of p_2 is

    f(p) = p**(a_2 - 1) (1 - p)**(a_1 - 1) G(a_1 + a_2) / (G(a_1) G(a_2)),    G the Gamma function,

with mean a_2 / a_0 and variance a_1 a_2 / (a_0**2 (a_0 + 1)), a_0 = a_1 + a_2. The source plots the
density of p_2, not of p_1: so Fig. G.4, with a_1 = 4 and a_2 = 1, has its mean at .2.
"""

from __future__ import annotations

from math import lgamma
from typing import TYPE_CHECKING, Final

import numpy as np
from gmpy2 import mpq

from stochgeom.errors import InputError
from stochgeom.exact.decimals import rational_decimal
from stochgeom.exact.scalars import RationalLike, rational, rational_text
from stochgeom.plotting.axes import axes_or_new
from stochgeom.plotting.silhouettes import FloatArray
from stochgeom.plotting.styles import STYLES

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_EDGE: Final = 1 / 1000
"""The density may be infinite at 0 and 1; it is drawn from here on."""

_MOST_OF_A_POLE: Final = 6.0


def beta_moments(alpha_1: RationalLike, alpha_2: RationalLike) -> tuple[mpq, mpq]:
    """Return mean and variance of p_2, exactly.

    Raises
    ------
    InputError
        If a parameter is not positive.

    Examples
    --------
    >>> beta_moments(4, 1)
    (mpq(1,5), mpq(2,75))
    """
    a, b = (rational(value, where=f"alpha {k}") for k, value in enumerate((alpha_1, alpha_2), 1))
    for k, value in enumerate((a, b), 1):
        if value <= 0:
            raise InputError(f"{value}; accepted: positive numbers", where=f"alpha {k}")
    return b / (a + b), a * b / ((a + b) ** 2 * (a + b + 1))


def beta_density(alpha_1: RationalLike, alpha_2: RationalLike, p: FloatArray) -> FloatArray:
    """Return the density of p_2 at places in (0, 1), in floats."""
    a, b = float(rational(alpha_1)), float(rational(alpha_2))
    constant = lgamma(a + b) - lgamma(a) - lgamma(b)
    density: FloatArray = np.exp(constant + (b - 1) * np.log(p) + (a - 1) * np.log1p(-p))
    return density


def draw_beta_density(alpha_1: RationalLike, alpha_2: RationalLike, ax: Axes | None = None) -> Axes:
    """Draw the density of p_2 under a Beta distribution, its mean and variance in the title.

    Parameters
    ----------
    alpha_1, alpha_2 : positive rational
        The parameters of the Dirichlet distribution of (p_1, p_2).
    ax : Axes, optional
        Where; default: on a new figure.

    Raises
    ------
    InputError
        If a parameter is not positive.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> draw_beta_density("0.1", "0.1", Figure().subplots()).get_title()
    'α₁ = 1/10, α₂ = 1/10: mean 0.500, variance 0.208'
    """
    mean, variance = beta_moments(alpha_1, alpha_2)
    ax = axes_or_new(ax, (4.8, 3.0))
    p = np.linspace(_EDGE, 1 - _EDGE, 999)
    density = beta_density(alpha_1, alpha_2, p)
    ax.plot(p, density, color=STYLES["curve"].stroke, linewidth=1.5)
    ax.axvline(float(mean), color=STYLES["ghost"].stroke, linewidth=0.9, linestyle="--")
    pole = min(rational(alpha_1), rational(alpha_2)) < 1
    inner = float(density[49:-49].max())
    ax.set_ylim(0.0, _MOST_OF_A_POLE * inner if pole else 1.15 * float(density.max()))
    ax.set_xlim(0.0, 1.0)
    ax.set_xlabel("p₂")
    ax.set_ylabel("density")
    words = [rational_text(rational(value)) for value in (alpha_1, alpha_2)]
    ax.set_title(
        f"α₁ = {words[0]}, α₂ = {words[1]}: mean {rational_decimal(mean, 3)}, "
        f"variance {rational_decimal(variance, 3)}",
        fontsize=9,
    )
    return ax
