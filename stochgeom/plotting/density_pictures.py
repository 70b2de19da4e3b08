"""Densities of the Beta distribution (thesis Figs. G.1 to G.4); needs the extra ``plot``.

The source plots the density of p_2, not of p_1: so Fig. G.4, with a_1 = 4 and a_2 = 1, has its mean
at .2. See `stochgeom.tilting.beta_density`.
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Final

import numpy as np

from stochgeom.exact.decimals import rational_decimal
from stochgeom.exact.scalars import RationalLike, rational_text
from stochgeom.plotting.axes import axes_or_new
from stochgeom.plotting.styles import STYLES
from stochgeom.tilting.beta_density import BetaDensity

if TYPE_CHECKING:
    from matplotlib.axes import Axes

_EDGE: Final = 1 / 1000
"""The density may be infinite at 0 and 1; it is drawn from here on."""

_MOST_OF_A_POLE: Final = 6.0


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
    PriorError
        If a parameter is not positive.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> draw_beta_density("0.1", "0.1", Figure().subplots()).get_title()
    'α₁ = 1/10, α₂ = 1/10: mean 0.500, variance 0.208'
    """
    beta = BetaDensity(alpha_1, alpha_2)
    ax = axes_or_new(ax, (4.8, 3.0))
    p = np.linspace(_EDGE, 1 - _EDGE, 999)
    density = np.array([beta(float(x)) for x in p])
    ax.plot(p, density, color=STYLES["curve"].stroke, linewidth=1.5)
    ax.axvline(float(beta.mean), color=STYLES["ghost"].stroke, linewidth=0.9, linestyle="--")
    pole = min(beta.alpha_1, beta.alpha_2) < 1
    inner = float(density[49:-49].max())
    ax.set_ylim(0.0, _MOST_OF_A_POLE * inner if pole else 1.15 * float(density.max()))
    ax.set_xlim(0.0, 1.0)
    ax.set_xlabel("p₂")
    ax.set_ylabel("density")
    ax.set_title(
        f"α₁ = {rational_text(beta.alpha_1)}, α₂ = {rational_text(beta.alpha_2)}: "
        f"mean {rational_decimal(beta.mean, 3)}, variance {rational_decimal(beta.variance, 3)}",
        fontsize=9,
    )
    return ax
