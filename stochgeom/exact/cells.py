"""Sets of orientations with closed ends, open ends and single points, as unions of cells.

Finitely many *critical* orientations cut the circle into cells: the critical orientations
themselves and the open arcs between them. A `CellSet` holds a Boolean for each cell. So complement,
union and intersection are exact, down to the single orientation: what half-open arcs could not say
of sets that friction makes.
"""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Collection, Iterable, Iterator, Sequence
from typing import final

from stochgeom.arguments import as_list, expect
from stochgeom.display import Displayed
from stochgeom.errors import InvalidArcError
from stochgeom.exact.angles import FULL_TURN, ZERO, Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.intervals import Interval
from stochgeom.exact.sums import AngleSum


@final
class CellSet(Displayed):
    """A set of orientations on the circle: a union of cells, exactly.

    Parameters
    ----------
    angles : sequence of Angle
        Critical orientations, strictly increasing in [0, 360) degrees.
    points : sequence of bool
        For each of them whether it belongs to the set.
    arcs : sequence of bool
        For each of them whether the open arc from it to the next one does; without any, one
        Boolean for the whole circle.

    Attributes
    ----------
    angles, points, arcs : tuples
        The same, without the critical orientations at which nothing changes: equal sets have
        equal parts.

    Raises
    ------
    InvalidArcError
        If the orientations are not increasing in [0, 360) degrees, or the lengths do not fit.

    Examples
    --------
    >>> quarter = CellSet.of([Interval(ZERO, Angle.from_degrees(90), True, True)])
    >>> print(quarter, ~quarter)
    {[0.0000°, 90.0000°]} {(90.0000°, 360.0000°)}
    >>> ZERO in quarter, ZERO in ~quarter, (quarter | ~quarter).is_whole
    (True, False, True)
    """

    __slots__ = ("angles", "arcs", "points")
    angles: tuple[Angle, ...]
    points: tuple[bool, ...]
    arcs: tuple[bool, ...]

    def __init__(
        self, angles: Sequence[Angle], points: Sequence[bool], arcs: Sequence[bool]
    ) -> None:
        _check(angles, points, arcs)
        self._fill(angles, points, arcs)

    def _fill(self, angles: Sequence[Angle], points: Sequence[bool], arcs: Sequence[bool]) -> None:
        kept = [k for k in range(len(angles)) if not arcs[k - 1] == points[k] == arcs[k]]
        store = object.__setattr__
        store(self, "angles", tuple(angles[k] for k in kept))
        store(self, "points", tuple(bool(points[k]) for k in kept))
        store(self, "arcs", tuple(bool(arcs[k]) for k in kept) or (bool(arcs[0]),))

    # --- makers ----------------------------------------------------------------------------------

    @classmethod
    def unchecked(
        cls, angles: Sequence[Angle], points: Sequence[bool], arcs: Sequence[bool]
    ) -> CellSet:
        """Return a set of cells that are known to be well formed: what the class itself checks."""
        cells = object.__new__(cls)
        cells._fill(angles, points, arcs)
        return cells

    @classmethod
    def empty(cls) -> CellSet:
        """Return the set of no orientation."""
        return cls((), (), (False,))

    @classmethod
    def whole(cls) -> CellSet:
        """Return the set of all orientations."""
        return cls((), (), (True,))

    @classmethod
    def at(cls, orientations: Iterable[Angle]) -> CellSet:
        """Return a set of single orientations, taken modulo a full turn."""
        listed = as_list(orientations, "a list of angles", "orientations")
        for k, theta in enumerate(listed):
            expect(theta, Angle, "an Angle", f"orientation {k}")
        angles = sorted({theta.reduced() for theta in listed})
        return cls(angles, [True] * len(angles), [False] * max(1, len(angles)))

    @classmethod
    def of(cls, intervals: Iterable[Interval]) -> CellSet:
        """Return the union of intervals, which may overlap.  O(k log k) if they do not.

        Examples
        --------
        >>> arc = Interval(Angle.from_degrees(270), Angle.from_degrees(180), False, False)
        >>> print(CellSet.of([arc, Interval(ZERO, Angle(), True, True)]))
        {(270.0000°, 450.0000°)}
        """
        listed = as_list(intervals, "a list of intervals", "intervals")
        for k, item in enumerate(listed):
            expect(item, Interval, "an Interval", f"interval {k}")
        if any(item.width == FULL_TURN and item.is_closed for item in listed):
            return cls.whole()
        starts = [item.start.reduced() for item in listed]
        ends = [item.end.reduced() for item in listed]
        angles = sorted({*starts, *ends})
        place = {angle: k for k, angle in enumerate(angles)}
        points, arcs = [False] * len(angles), [False] * max(1, len(angles))
        for item, start, end in zip(listed, starts, ends, strict=True):
            first, last = place[start], place[end]
            points[first] |= item.includes_start
            points[last] |= item.includes_end
            if not item.width:
                continue
            count = (last - first) % len(angles) or len(angles)
            for step in range(count):
                arcs[(first + step) % len(angles)] = True
                if step:
                    points[(first + step) % len(angles)] = True
        return cls(angles, points, arcs)

    # --- questions -------------------------------------------------------------------------------

    def __contains__(self, theta: object) -> bool:
        if not isinstance(theta, Angle):
            return False
        rest = theta.reduced()
        k = bisect_right(self.angles, rest) - 1
        # Before the first critical orientation runs the last arc, which is arc -1.
        return self.points[k] if k >= 0 and self.angles[k] == rest else self.arcs[k]

    @property
    def is_whole(self) -> bool:
        """Whether every orientation belongs to the set."""
        return not self.angles and self.arcs[0]

    def __bool__(self) -> bool:
        """Tell whether any orientation belongs to the set."""
        return bool(self.angles) or self.arcs[0]

    def __iter__(self) -> Iterator[Interval]:
        return iter(self.intervals())

    def intervals(self) -> tuple[Interval, ...]:
        """Return the maximal intervals, by their starts in [0, 360) degrees.

        The whole circle is the closed interval [0, 360] degrees.

        Examples
        --------
        >>> marks = CellSet.at([Angle.from_degrees(90)])
        >>> [str(item) for item in marks.intervals()], [str(item) for item in (~marks).intervals()]
        (['[90.0000°, 90.0000°]'], ['(90.0000°, 450.0000°)'])
        """
        m = len(self.angles)
        if not m:
            return (Interval(ZERO, FULL_TURN, True, True),) if self.arcs[0] else ()
        # Cell 2 k is the critical orientation k, cell 2 k + 1 the arc that follows it.
        cells = [flag for pair in zip(self.points, self.arcs, strict=True) for flag in pair]
        found = []
        first = cells.index(False)  # a set with critical orientations is not the whole circle
        start: int | None = None
        for cell in range(first + 1, first + 2 * m + 1):
            if cells[cell % (2 * m)]:
                start = cell if start is None else start
            elif start is not None:
                found.append(self._run(start, cell - 1))
                start = None
        return tuple(sorted(found, key=lambda item: item.start))

    def _run(self, start: int, last: int) -> Interval:
        m = len(self.angles)
        first, end = self.angles[start // 2 % m], self.angles[(last + 1) // 2 % m]
        width = (end - first).reduced()
        if not width and (start != last or start % 2):
            width = FULL_TURN
        return Interval(first, width, start % 2 == 0, last % 2 == 0)

    @property
    def measure(self) -> AngleSum:
        """The measure in full turns, exactly: the probability of the set after a random turn.

        Examples
        --------
        >>> CellSet.of([Interval(Angle(0, (3, 2)), Angle.from_degrees(90), False, True)]).measure
        AngleSum('1/4', [])
        """
        m = len(self.angles)
        if not m:
            return AngleSum(int(self.arcs[0]))
        signs = [int(self.arcs[k - 1]) - int(self.arcs[k]) for k in range(m)]
        # Sum of end - start over the arcs; the one that runs over 0 ends a full turn on.
        return AngleSum(int(self.arcs[-1]), list(zip(signs, self.angles, strict=True)))

    def half_open(self) -> tuple[Arc, ...]:
        """Return the intervals of positive width as half-open arcs, for output: ends are lost."""
        return tuple(Arc(item.start, item.width) for item in self.intervals() if item.width)

    def widest(self) -> tuple[Interval, ...]:
        """Return the widest of the maximal intervals, all that are equally wide.

        Examples
        --------
        >>> [str(item) for item in CellSet.at([ZERO, Angle.from_degrees(90)]).widest()]
        ['[0.0000°, 0.0000°]', '[90.0000°, 90.0000°]']
        """
        found = self.intervals()
        most = max((item.width for item in found), default=ZERO)
        return tuple(item for item in found if item.width == most)

    # --- algebra ---------------------------------------------------------------------------------

    def __invert__(self) -> CellSet:
        points, arcs = [not p for p in self.points], [not a for a in self.arcs]
        return CellSet.unchecked(self.angles, points, arcs)

    def __or__(self, other: CellSet) -> CellSet:
        return self._combine(other, lambda a, b: a or b)

    def __and__(self, other: CellSet) -> CellSet:
        return self._combine(other, lambda a, b: a and b)

    def __sub__(self, other: CellSet) -> CellSet:
        return self._combine(other, lambda a, b: a and not b)

    def __xor__(self, other: CellSet) -> CellSet:
        return self._combine(other, lambda a, b: a != b)

    def __le__(self, other: CellSet) -> bool:
        """Tell whether every orientation of this set belongs to the other one."""
        return not self - other

    def _combine(self, other: CellSet, rule: Callable[[bool, bool], bool]) -> CellSet:
        angles = merge(self.angles, other.angles)
        mine, theirs = self.on(angles), other.on(angles)
        points = [rule(a, b) for a, b in zip(mine[0], theirs[0], strict=True)]
        arcs = [rule(a, b) for a, b in zip(mine[1], theirs[1], strict=True)]
        return CellSet.unchecked(angles, points, arcs)

    def on(self, angles: Sequence[Angle]) -> tuple[list[bool], list[bool]]:
        """Return the Booleans of the cells that finer critical orientations make.  O(k).

        Parameters
        ----------
        angles : sequence of Angle
            Increasing in [0, 360) degrees, all critical orientations of this set among them.
        """
        points, arcs, arc, k = [], [], self.arcs[-1], 0
        for angle in angles:
            point = arc
            if k < len(self.angles) and self.angles[k] == angle:
                point, arc, k = self.points[k], self.arcs[k], k + 1
            points.append(point)
            arcs.append(arc)
        return points, arcs or [arc]

    def rotate(self, angle: Angle) -> CellSet:
        """Return the set turned counter-clockwise by an angle.

        Examples
        --------
        >>> print(CellSet.at([ZERO]).rotate(Angle.from_degrees(-90)))
        {[270.0000°, 270.0000°]}
        """
        if not self.angles:
            return self
        moved = [(theta + angle).reduced() for theta in self.angles]
        start = moved.index(min(moved))
        order = [*range(start, len(moved)), *range(start)]
        return CellSet(
            [moved[k] for k in order],
            [self.points[k] for k in order],
            [self.arcs[k] for k in order],
        )

    def reflect(self) -> CellSet:
        """Return the set of minus its orientations.

        Examples
        --------
        >>> arc = Interval(Angle.from_degrees(10), Angle.from_degrees(20), True, False)
        >>> print(CellSet.of([arc]).reflect())
        {(330.0000°, 350.0000°]}
        """
        if self.is_whole:
            return self
        return CellSet.of(
            Interval(-item.end, item.width, item.includes_end, item.includes_start)
            for item in self.intervals()
        )

    def shrunk(self, margin: Angle) -> CellSet:
        """Return the orientations all of whose neighbours within `margin` belong to the set."""
        if self.is_whole:
            return self
        smaller = (item.shrunk(margin) for item in self.intervals())
        return CellSet.of(item for item in smaller if item is not None)

    # --- value semantics -------------------------------------------------------------------------

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, CellSet):
            return NotImplemented
        return (self.angles, self.points, self.arcs) == (other.angles, other.points, other.arcs)

    def __hash__(self) -> int:
        return hash((self.angles, self.points, self.arcs))

    def __setattr__(self, name: str, value: object) -> None:
        raise AttributeError("a CellSet is immutable")

    def __delattr__(self, name: str) -> None:
        raise AttributeError("a CellSet is immutable")

    def __reduce__(self) -> tuple[type[CellSet], tuple[object, ...]]:
        return CellSet, (self.angles, self.points, self.arcs)

    def __repr__(self) -> str:
        return f"CellSet({list(self.angles)!r}, {list(self.points)!r}, {list(self.arcs)!r})"

    def __str__(self) -> str:
        """Return the intervals with their ends rounded inwards: what is printed is in the set."""
        return "{" + ", ".join(str(item) for item in self.intervals()) + "}"


def merge(first: Sequence[Angle], second: Sequence[Angle]) -> list[Angle]:
    """Return the union of two increasing sequences, increasing.  O(k) comparisons."""
    merged, i, j = [], 0, 0
    while i < len(first) and j < len(second):
        order = first[i].compare(second[j])
        merged.append(first[i] if order <= 0 else second[j])
        i, j = i + (order <= 0), j + (order >= 0)
    return [*merged, *first[i:], *second[j:]]


def _check(angles: Sequence[Angle], points: Sequence[bool], arcs: Sequence[bool]) -> None:
    for what, given in (("angles", angles), ("points", points), ("arcs", arcs)):
        expect(given, Collection, "a list", what)
    for k, angle in enumerate(angles):
        expect(angle, Angle, "an Angle", f"critical orientation {k}")
    if len(points) != len(angles) or len(arcs) != max(1, len(angles)):
        raise InvalidArcError(
            f"{len(angles)} critical orientations, {len(points)} points and {len(arcs)} arcs; "
            "accepted: as many of each, or none, none and 1"
        )
    lasts = (None, *angles)
    for last, angle in zip(lasts, angles, strict=False):
        if angle < ZERO or (last is not None and angle <= last):
            raise InvalidArcError(
                f"critical orientation {angle} after {last}; accepted: increasing from 0"
            )
    if angles and angles[-1] >= FULL_TURN:
        raise InvalidArcError(f"critical orientation {angles[-1]}; accepted: below 360°")
