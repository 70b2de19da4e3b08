"""Pictures of blocks in places, sensed and scooped: the two ways to reduce uncertainty.

Needs the extra ``plot``.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING

from stochgeom.exact.scalars import RationalLike
from stochgeom.plotting.axes import draw_scene, need_matplotlib
from stochgeom.plotting.block_scenes import scooped_blocks_scene, sensed_blocks_scene

if TYPE_CHECKING:
    from matplotlib.axes import Axes


def draw_sensed_blocks(
    prior: Sequence[RationalLike], likelihood: Sequence[RationalLike], ax: Axes | None = None
) -> Axes:
    """Draw what a sensor reading makes of a distribution over places (thesis Fig. 1.2).

    Parameters
    ----------
    prior : sequence of rational
        A weight for each place; they are divided by their sum.
    likelihood : sequence of rational
        How likely the reading is in each place.
    ax : Axes, optional
        Where; default: on a new figure.

    Raises
    ------
    InputError
        If the lengths differ, or the reading is impossible under the prior.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> ax = draw_sensed_blocks([1, 1, 1, 1], [1, 2, 4, 3], Figure().subplots())
    >>> [text.get_text() for text in ax.texts][-4:]
    ['1/10', '1/5', '2/5', '3/10']
    """
    need_matplotlib()
    return draw_scene(sensed_blocks_scene(prior, likelihood), ax, inches=0.6)


def draw_scooped_blocks(
    prior: Sequence[RationalLike], lands: Sequence[int], ax: Axes | None = None
) -> Axes:
    """Draw what a blind action makes of a distribution over places (thesis Fig. 1.3).

    Parameters
    ----------
    prior : sequence of rational
        A weight for each place; they are divided by their sum.
    lands : sequence of int
        The place, counted from 0, that a block in each place is moved to.
    ax : Axes, optional
        Where; default: on a new figure.

    Raises
    ------
    InputError
        If the lengths differ, or a number names no place.

    Examples
    --------
    >>> from matplotlib.figure import Figure
    >>> ax = draw_scooped_blocks([1, 1, 1, 1], [0, 1, 3, 3], Figure().subplots())
    >>> [text.get_text() for text in ax.texts][-4:]
    ['1/4', '1/4', '0', '1/2']
    """
    need_matplotlib()
    return draw_scene(scooped_blocks_scene(prior, lands), ax, inches=0.6)
