"""Virtual blocks: a sensor reading and an action as maps of a distribution (Figs. 1.2 and 1.3).

A block is in one of a few places, drawn dashed; the bars under them are probabilities, computed
exactly. A reading multiplies them by likelihoods (Bayes); a blind action moves places together
and adds their probabilities.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

from gmpy2 import mpq

from stochgeom.arguments import as_count, as_list
from stochgeom.decision.priors import as_share, normalise
from stochgeom.errors import InputError
from stochgeom.exact.decimals import rational_decimal
from stochgeom.exact.scalars import RationalLike
from stochgeom.plotting.scene import Label, Line, Polygon, Scene, arrow, rectangle

_PITCH: Final = 1.35
_BLOCK: Final = 0.8
_BAR_HEIGHT: Final = 1.7
_SIZE: Final = 0.28
_MOST_LETTERS: Final = 5


def sensed_blocks_scene(prior: Sequence[RationalLike], likelihood: Sequence[RationalLike]) -> Scene:
    """Return the picture of `draw_sensed_blocks`, which says what is accepted."""
    before = normalise(prior)
    chances = [
        as_share(value, where=f"likelihood {k}", what="likelihood")
        for k, value in enumerate(as_list(likelihood, "a list of likelihoods", "likelihood"))
    ]
    if len(chances) != len(before):
        raise InputError(f"{len(chances)} likelihoods; accepted: {len(before)}, one for each place")
    products = [p * q for p, q in zip(before, chances, strict=True)]
    if not any(products):
        raise InputError("the reading is impossible in every place that the prior allows")
    scene = Scene()
    _add_places(scene, 0.0, before)
    most = max(chances)
    heights = [1.1 * float(q / most) for q in chances]
    centers = [k * _PITCH for k in range(len(before))]
    scene.add(Line(tuple(zip(centers, [1.0 + h for h in heights], strict=True)), "jump"))
    scene.add(Label((centers[0] - 0.5, 2.45), "likelihood of the reading", _SIZE, "start"))
    _add_arrow(scene, len(before), "sensor")
    _add_places(scene, len(before) * _PITCH + 2.2, normalise(products))
    return scene


def scooped_blocks_scene(prior: Sequence[RationalLike], lands: Sequence[int]) -> Scene:
    """Return the picture of `draw_scooped_blocks`, which says what is accepted.

    Examples
    --------
    >>> scene = scooped_blocks_scene([1, 1, 1, 1], [0, 1, 3, 3])
    >>> scene.labels()[-4:]
    ['1/4', '1/4', '0', '1/2']
    """
    before = normalise(prior)
    lands = as_list(lands, "a list of places", "landing places")
    if len(lands) != len(before):
        raise InputError(f"{len(lands)} places to land in; accepted: {len(before)}")
    after = [mpq(0)] * len(before)
    lands = [
        as_count(place, "as a place", least=0, most=len(before) - 1, where=f"landing place {k}")
        for k, place in enumerate(lands)
    ]
    for place, share in zip(lands, before, strict=True):
        after[place] += share
    touched = [k for k, place in enumerate(lands) if k != place]
    scene = Scene()
    _add_places(scene, 0.0, before)
    right = len(before) * _PITCH + 2.2
    if touched:
        first, last = min(*touched, lands[touched[0]]), max(*touched, lands[touched[0]])
        _add_hand(scene, first * _PITCH - 0.62, last * _PITCH + 0.62)
        landed = right + lands[touched[0]] * _PITCH
        _add_hand(scene, landed - _BLOCK / 2 - 0.14, landed + _BLOCK / 2 + 0.14)
    _add_arrow(scene, len(before), "close the gripper")
    _add_places(scene, right, after)
    return scene


def _add_hand(scene: Scene, left: float, right: float) -> None:
    """Draw a gripper from above the table, its fingers at two places."""
    for x, side in ((left, -1), (right, 1)):
        scene.add(rectangle((x, 0.05), (x + 0.12 * side, 1.5), "jaw"))
    scene.add(rectangle((left - 0.12, 1.5), (right + 0.12, 1.75), "palm"))


def _add_arrow(scene: Scene, count: int, text: str) -> None:
    x = (count - 1) * _PITCH + 1.0
    scene.add(*arrow((x, 0.4), (x + 1.5, 0.4), 0.25), Label((x + 0.75, 0.75), text, 0.8 * _SIZE))


def _add_places(scene: Scene, left: float, shares: Sequence[mpq]) -> None:
    """Draw the blocks of the places that are possible, and the probabilities under them."""
    end = left + (len(shares) - 1) * _PITCH
    scene.add(Line(((left - 0.6, 0.0), (end + 0.6, 0.0)), "frame"))
    base = -0.6 - _BAR_HEIGHT
    texts = _share_texts(shares)
    scene.add(Line(((left - 0.6, base), (end + 0.6, base)), "frame"))
    for k, (share, text) in enumerate(zip(shares, texts, strict=True)):
        x, half = left + k * _PITCH, _BLOCK / 2
        corners = ((x - half, 0.0), (x + half, 0.0), (x + half, _BLOCK), (x - half, _BLOCK))
        if share:
            scene.add(Polygon(corners, "part" if share == 1 else "ghost"))
            scene.add(
                rectangle((x - 0.25, base), (x + 0.25, base + float(share) * _BAR_HEIGHT), "bar")
            )
        top = base + float(share) * _BAR_HEIGHT + 0.22
        scene.add(Label((x, top), text, _SIZE))


def _share_texts(shares: Sequence[mpq]) -> list[str]:
    """Return fractions, or decimals of all where one fraction is long: they are compared."""
    texts = [str(share) for share in shares]
    if max(map(len, texts)) <= _MOST_LETTERS:
        return texts
    return [rational_decimal(share, 3) for share in shares]
