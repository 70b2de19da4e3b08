"""All errata, numbered, each with the function that recomputes it.

Order: tables, figures, then equations, theorems and prose, each by place in the source.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from typing import Final, final

from stochgeom.arguments import expect
from stochgeom.errors import UnknownErratumError
from stochgeom.thesis import errata, errata_statements
from stochgeom.thesis import recompute_backchaining as backchaining
from stochgeom.thesis import recompute_densities as densities
from stochgeom.thesis import recompute_framework as framework
from stochgeom.thesis import recompute_grasps as grasps
from stochgeom.thesis import recompute_orientations as orientations
from stochgeom.thesis import recompute_planning as planning
from stochgeom.thesis import recompute_tables as tables
from stochgeom.thesis.appendix_g import FIGURES_G
from stochgeom.thesis.chapter_6 import FIGURE_6_4_ERRATA
from stochgeom.thesis.errata import Erratum
from stochgeom.thesis.facts import Facts

MOST_DIGITS: Final = 4
"""A longer number is no number of an erratum."""


@final
@dataclass(frozen=True, slots=True)
class ErratumEntry:
    """An erratum of the register.

    Attributes
    ----------
    number : int
        From 1.
    erratum : Erratum
        What is printed, what holds, and why.
    recompute : callable
        Returns the facts that settle it.
    """

    number: int
    erratum: Erratum
    recompute: Callable[[], Facts]

    @property
    def recomputed_by(self) -> str:
        """The dotted name of the function that settles it."""
        return f"{self.recompute.__module__}.{self.recompute.__name__}"

    @property
    def argument(self) -> str:
        """What the recomputation shows, as the first paragraph of its documentation says."""
        shows = " ".join((self.recompute.__doc__ or "").split("\n\n")[0].split())
        return shows.removeprefix("Show ").removeprefix("that ")


def _numbered() -> tuple[ErratumEntry, ...]:
    statements = errata_statements
    g_3 = next(figure.erratum for figure in FIGURES_G if figure.erratum is not None)
    listed: list[tuple[Erratum, Callable[[], Facts]]] = [
        (errata.TABLE_4_1["4gon", 3], tables.four_gon_at_three_steps),
        (errata.TABLE_4_1["key", 3], tables.key_at_three_steps),
        (errata.TABLE_C_1["rectangle", "0.05"], tables.rectangle_in_table_c_1),
        (errata.GRASP_TABLE_SIDES, tables.sides_of_the_rectangle),
        (FIGURE_6_4_ERRATA[8, 12], tables.figure_6_4_row_8),
        (FIGURE_6_4_ERRATA[12, 12], tables.figure_6_4_row_12),
        (statements.COLUMNS_OF_6_4, tables.columns_of_figure_6_4),
        (errata.APPENDIX_E["angles"], grasps.angles_of_figure_e_5),
        (errata.APPENDIX_E["cost"], grasps.text_of_appendix_e),
        (g_3, tables.figure_g_3),
        (statements.HOUSE_DENSITY, densities.density_of_the_house),
        (statements.OTHER_DENSITIES, densities.density_of_other_parts),
        (statements.FIGURE_E_1, orientations.caption_of_figure_e_1),
        (statements.TEXT_OF_4_8, tables.text_of_section_4_8),
        (statements.LENGTH_OF_PLANS, framework.length_of_cheap_plans),
        (statements.WORDS, framework.words_on_decisions),
        (statements.INFINITE_COST, framework.infinite_costs),
        (statements.STABLE_ORIENTATIONS, orientations.stable_orientations),
        (errata.LIMIT_OF_3_13, grasps.limit_of_the_bound),
        (errata.EQUATION_3_14, grasps.equation_3_14),
        (statements.PERIOD, planning.period_and_symmetry),
        (statements.THEOREM_4_1, planning.bound_of_theorem_4_1),
        (statements.FIGURE_5_1, planning.first_step_of_figure_5_1),
        (statements.EQUATION_5_3, planning.angles_of_equation_5_3),
        (statements.NUMBER_OF_PLANS, backchaining.plans_of_phase_one),
        (statements.LEMMA_5_1, backchaining.closure_in_lemma_5_1),
        (statements.EQUATION_5_7, backchaining.wider_arcs_in_5_7),
        (statements.FIGURE_5_8, planning.cost_in_figure_5_8),
        (statements.THEOREM_5_4, planning.time_of_phase_one),
        (statements.CONJECTURE_5_4_1, planning.length_of_plans),
        (statements.TRAY_STATES, framework.states_of_the_tray),
        (statements.POSTERIOR, framework.variance_of_a_posterior),
        (statements.RANDOM_TILTS, framework.random_tilts),
        (statements.MEASURED_PLAN, framework.success_of_the_second_plan),
        (statements.SHORTEST_PATH, framework.shortest_paths),
        (errata.SENSORS["7.5"], framework.cost_with_a_sensor),
        (statements.SHANNON, framework.information_of_a_sensor),
        (errata.APPENDIX_C_TEXT, grasps.text_of_appendix_c),
        (statements.SWEEP, grasps.sweep_of_appendix_d),
        (statements.POTENTIAL, orientations.sign_of_the_potential),
        (statements.DERIVATIVE, planning.derivative_in_f_4),
    ]
    return tuple(
        ErratumEntry(number, erratum, recompute)
        for number, (erratum, recompute) in enumerate(listed, start=1)
    )


ERRATA: Final = _numbered()
"""The register."""


def find_errata(query: str | None = None) -> tuple[ErratumEntry, ...]:
    """Return the errata of a number, or those in which a text occurs; None for all.

    Parameters
    ----------
    query : str, optional
        A whole number from 1 to the number of errata, or a text such as ``"sensor"`` or ``"7.5"``;
        capitals do not matter.

    Raises
    ------
    UnknownErratumError
        If there is none.

    Examples
    --------
    >>> [entry.erratum.where for entry in find_errata("7.5")]
    ['Eq. 7.5']
    """
    if query is None:
        return ERRATA
    text = expect(query, str, "a number as text, or words", "erratum").strip()
    if re.fullmatch(rf"[+-]?[0-9]{{1,{MOST_DIGITS}}}", text):
        found = tuple(entry for entry in ERRATA if entry.number == int(text))
    else:
        found = tuple(entry for entry in ERRATA if text and text.casefold() in _searched(entry))
    if not found:
        raise UnknownErratumError(
            f"no erratum {query[:60]!r}; accepted: a number from 1 to {len(ERRATA)}, or a text "
            "that occurs in one, such as 'Table 4.1' or 'sensor'"
        )
    return found


def _searched(entry: ErratumEntry) -> str:
    erratum = entry.erratum
    return " ".join((erratum.where, erratum.printed, erratum.holds, erratum.reason)).casefold()
