"""The four Beta densities of appendix G, with what is printed of them."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final, final

from stochgeom.thesis.errata import Erratum
from stochgeom.tilting.beta_density import BetaDensity


@final
@dataclass(frozen=True, slots=True)
class PrintedDensity:
    """One figure of the appendix.

    Attributes
    ----------
    figure : str
        Its number.
    density : BetaDensity
        The density of p_2.
    mean, variance : str
        As printed.
    erratum : Erratum or None
        Where the text says something else.
    """

    figure: str
    density: BetaDensity
    mean: str
    variance: str
    erratum: Erratum | None = None


FIGURES_G: Final = (
    PrintedDensity("G.1", BetaDensity(1, 1), "0.5", "0.083"),
    PrintedDensity("G.2", BetaDensity("0.1", "0.1"), "0.5", "0.208"),
    PrintedDensity(
        "G.3",
        BetaDensity(16, 16),
        "0.5",
        "0.008",
        Erratum(
            "Fig. G.3",
            "alpha_1 = alpha_2 = 8 in the text, 16 in the caption",
            "16",
            "the printed variance .008 is that of 16, .0076; 8 gives .0147",
        ),
    ),
    PrintedDensity("G.4", BetaDensity(4, 1), "0.20", "0.027"),
)
"""In the order of the figures."""
