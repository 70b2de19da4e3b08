"""Hostile parts: families of parts that provoke the mistakes planners make.

Each family is a generator with a size and a seed: the same ones give the same part everywhere and
always. The docstring of a generator says what it provokes, and a test that it does. `FAMILIES`
lists them by name; `stochgeom.feeding.audit` plans all of them and has every answer checked.

Some sizes count vertices, others bits or digits: `Family.counts` tells which.

Examples
--------
>>> family = FAMILIES["long plans"]
>>> part = family(5, seed=1)
>>> part.name, len(part), part == family(5, seed=1)
('long plan 5, seed 1', 5, True)
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from types import MappingProxyType
from typing import Final, final

from stochgeom.errors import InputError
from stochgeom.feeding.hostile_shapes import (
    collinear_points,
    constant_width,
    huge_coordinates,
    needles,
    random_hulls,
    slivers,
    spirals,
    stars,
    tiny_coordinates,
)
from stochgeom.feeding.hostile_ties import (
    long_plans,
    near_parallel,
    near_symmetric,
    near_ties,
    structural_ties,
)
from stochgeom.geometry.part import Part


@final
@dataclass(frozen=True, slots=True)
class Family:
    """A family of hostile parts.

    Attributes
    ----------
    name : str
        Its name, such as ``"long plans"``.
    description : str
        What its parts are and what they provoke, in a line.
    generate : callable
        ``generate(size, seed)`` makes a part; a family can be called as well, with a check of the
        size.
    counts : str
        What the size counts: ``"vertices"``, ``"points"``, ``"bits"`` or ``"digits"``.
    smallest, largest : int
        The smallest size there is, and the largest sensible one. Beyond that a part is no more
        hostile, only slower.
    usual : (int, int)
        The sizes an audit takes: the smallest and the largest of them.
    """

    name: str
    description: str
    generate: Callable[[int, int], Part]
    counts: str
    smallest: int
    largest: int
    usual: tuple[int, int]

    def __call__(self, size: int, seed: int = 0) -> Part:
        """Return the part of a size and a seed.

        Raises
        ------
        InputError
            If the size is below the smallest one.
        """
        if size < self.smallest:
            raise InputError(
                f"{size} {self.counts}; accepted: {self.smallest} or more",
                where=f"family {self.name}",
            )
        return self.generate(size, seed)

    def usual_size(self, number: int) -> int:
        """Return the size of part `number` of an audit: all usual ones in turn."""
        low, high = self.usual
        return low + number % (high - low + 1)


_ALL = (
    Family(
        "long plans",
        "nearly regular, an odd number n of vertices: the shortest plan has n steps",
        long_plans,
        "vertices",
        smallest=3,
        largest=101,
        usual=(3, 15),
    ),
    Family(
        "structural ties",
        "an image exactly as wide as the preimage before, for whatever coordinates",
        structural_ties,
        "vertices",
        smallest=4,
        largest=100,
        usual=(4, 12),
    ),
    Family(
        "near ties",
        "an image that differs by about 2**-bits from the preimage before",
        near_ties,
        "bits",
        smallest=8,
        largest=2000,
        usual=(8, 200),
    ),
    Family(
        "near-parallel edges",
        "edges that are parallel, or on one line, but for about 2**-bits",
        near_parallel,
        "bits",
        smallest=4,
        largest=2000,
        usual=(4, 200),
    ),
    Family(
        "near-symmetric parts",
        "a symmetry of 90 degrees that fails by 10**-60 at one vertex",
        near_symmetric,
        "vertices",
        smallest=4,
        largest=60,
        usual=(4, 16),
    ),
    Family(
        "huge coordinates",
        "coordinates of many digits, of which the first are the same for all vertices",
        huge_coordinates,
        "digits",
        smallest=2,
        largest=1000,
        usual=(2, 60),
    ),
    Family(
        "tiny coordinates",
        "coordinates near zero with many digits, no two of them of one denominator",
        tiny_coordinates,
        "digits",
        smallest=2,
        largest=300,
        usual=(2, 40),
    ),
    Family(
        "collinear points",
        "a quadrilateral with all other vertices in the middle of its edges, some twice",
        collinear_points,
        "vertices",
        smallest=4,
        largest=1000,
        usual=(4, 30),
    ),
    Family(
        "slivers",
        "rods 2**bits times as long as wide: breaks and values within 2**-bits",
        slivers,
        "bits",
        smallest=4,
        largest=2000,
        usual=(4, 100),
    ),
    Family(
        "needles",
        "thin sectors of a circle: all steps but two share a millionth",
        needles,
        "vertices",
        smallest=3,
        largest=200,
        usual=(3, 16),
    ),
    Family(
        "Reuleaux-like parts",
        "nearly of constant width: every edge stable, most maxima of the diameter equal",
        constant_width,
        "vertices",
        smallest=6,
        largest=90,
        usual=(6, 18),
    ),
    Family(
        "random hulls",
        "the hull of random points in the unit square, as in the source's experiments",
        random_hulls,
        "points",
        smallest=3,
        largest=1000,
        usual=(10, 10),
    ),
    Family(
        "star-shaped outlines",
        "not convex, vertices at random distances in order around the origin",
        stars,
        "vertices",
        smallest=3,
        largest=1000,
        usual=(3, 30),
    ),
    Family(
        "spirals",
        "a corridor that winds around itself: few vertices are on the hull",
        spirals,
        "vertices",
        smallest=6,
        largest=1000,
        usual=(6, 40),
    ),
)

FAMILIES: Final = MappingProxyType({family.name: family for family in _ALL})
"""The families by name."""


def families_named(names: Iterable[str] | None = None) -> tuple[Family, ...]:
    """Return families by their names, or all.

    Raises
    ------
    InputError
        For a name that is not one of them.

    Examples
    --------
    >>> [family.counts for family in families_named(["near ties", "needles"])]
    ['bits', 'vertices']
    """
    if names is None:
        return _ALL
    found = []
    for name in names:
        if name not in FAMILIES:
            raise InputError(f"family {name!r}; accepted: {', '.join(FAMILIES)}")
        found.append(FAMILIES[name])
    return tuple(found)
