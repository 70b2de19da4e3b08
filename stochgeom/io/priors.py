"""Priors from the command line and from files.

A source is ``uniform``, ``normal:MEAN,SD``, ``von-mises:MEAN,KAPPA`` (degrees), or the path of a
file. A file holds measured orientations, one to a line in degrees, each followed by how often it
was seen if that is not once::

    # orientation  count
    12.5
    40    3

or a JSON object with a ``kind``, numbers in it as such or as text, angles in degrees:

- ``{"kind": "uniform"}``;
- ``{"kind": "discrete", "points": [[ANGLE, WEIGHT], ...]}``, weights of sum 1;
- ``{"kind": "measurements", "degrees": [ANGLE, ...]}``;
- ``{"kind": "binned measurements", "degrees": [ANGLE, ...], "bins": COUNT}``, in bins from 0 on;
- ``{"kind": "histogram", "edges": [ANGLE, ...], "counts": [COUNT, ...]}``;
- ``{"kind": "piecewise", "pieces": [[START, WIDTH, DENSITY], ...]}``, densities per full turn;
- ``{"kind": "normal", "mean": ANGLE, "sd": DEGREES}``;
- ``{"kind": "von mises", "mean": ANGLE, "kappa": NUMBER}``;
- ``{"kind": "mixture", "components": [[WEIGHT, {"kind": ...}], ...]}``, weights of sum 1.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, Final

from gmpy2 import mpq

from stochgeom.arguments import expect
from stochgeom.decision.density_priors import VonMises, WrappedNormal
from stochgeom.decision.discrete_prior import DiscretePrior
from stochgeom.decision.mixture_prior import MixturePrior
from stochgeom.decision.piecewise_prior import MAX_BINS, PiecewisePrior
from stochgeom.decision.priors import Prior, as_orientation, as_share, uniform_prior
from stochgeom.errors import FormatError, InvalidArcError, PriorError, ReadError, StochgeomError
from stochgeom.exact.angles import Angle
from stochgeom.exact.arcs import Arc
from stochgeom.exact.scalars import parse_rational
from stochgeom.io.exact_json import kind_of, load_json
from stochgeom.io.files import decode_text, naming, read_bytes
from stochgeom.io.rings import shown

ACCEPTED: Final = (
    'accepted: uniform, "normal:MEAN,SD", "von-mises:MEAN,KAPPA", or a file with an orientation in '
    'degrees to a line or a JSON object with a "kind"'
)

_MAX_DEPTH: Final = 20

Tell = Callable[[float], None]

_INTERVAL: Final = 256
"""Entries between two reports of progress."""

_READING: Final = 0.35
"""Share of the work that reading is, of 300,000 measurements; the rest weighs and sorts them."""


def load_prior(source: str, tell: Tell | None = None) -> Prior:
    """Return the prior that a source names; see the module for what a file may hold.

    Parameters
    ----------
    source : str
        A known word, or the path of a file.
    tell : callable, optional
        Told the share of the work done now and then.

    Raises
    ------
    ReadError
        If it is neither a known word nor a readable file.
    FormatError, NumberError, PriorError
        If the content is no prior; the place in it is named.

    Examples
    --------
    >>> load_prior("normal:10,2.5").describe()
    'normal, mean 10.0000°, standard deviation 2.5000°'
    """
    expect(source, str, "a known word, or a file's path as text", "source")
    word, colon, rest = source.partition(":")
    if source == "uniform":
        return uniform_prior()
    if colon and word in _WORDS:
        numbers = rest.split(",")
        if len(numbers) != 2:
            raise FormatError(f"{shown(source)} is no prior; {ACCEPTED}", where="prior")
        mean, spread = (parse_rational(number, where=f"prior {word}") for number in numbers)
        return _WORDS[word](mean, spread)
    try:
        content = read_bytes(source)
    except ReadError as error:
        if not isinstance(error.__cause__, FileNotFoundError):
            raise
        raise ReadError(
            f"neither a kind of prior nor a file; {ACCEPTED}", where=error.where
        ) from None
    with naming(source):
        return parse_prior(decode_text(content), tell)


def parse_prior(text: str, tell: Tell | None = None) -> Prior:
    r"""Return the prior that the content of a file describes.

    Examples
    --------
    >>> parse_prior("12.5\n40 3  # seen three times\n").describe()
    'discrete, 2 orientations'
    """
    expect(text, str, "text", "prior")
    if text.lstrip("\ufeff \t\r\n").startswith(("{", "[")):
        read = _Entries(text.count(","), tell)
        return _from_json(load_json(text.lstrip("\ufeff"), ACCEPTED), "", 0, read)
    lines = text.lstrip("\ufeff").splitlines()
    read = _Entries(len(lines), tell)
    counts: dict[Angle, mpq] = {}
    for number, line in enumerate(lines, start=1):
        read.next()
        fields = line.partition("#")[0].replace(",", " ").split()
        if not fields:
            continue
        place = f"line {number}"
        if len(fields) > 2:
            raise FormatError(
                f"{shown(line.strip())}; accepted: an orientation in degrees, and how often it was "
                "seen",
                where=place,
            )
        angle = as_orientation(fields[0], where=place)
        times = as_share(fields[1], where=place, what="count") if len(fields) > 1 else mpq(1)
        counts[angle] = counts.get(angle, mpq(0)) + times
    if not counts:
        raise FormatError(f"no orientations; {ACCEPTED}")
    return DiscretePrior.from_counts(counts.items())


class _Entries:
    """Counts the entries of a file while they are read, and tells how far that is."""

    def __init__(self, total: int, tell: Tell | None) -> None:
        self._total, self._tell, self._done = total, tell, 0

    def next(self) -> None:
        self._done += 1
        if self._tell is not None and self._done % _INTERVAL == 0:
            self._tell(min(_READING * self._done / self._total, 1.0))


# --- JSON ----------------------------------------------------------------------------------------


def _from_json(document: Any, place: str, depth: int, read: _Entries) -> Prior:
    if depth > _MAX_DEPTH:
        raise FormatError(f"mixtures in mixtures, {depth} deep; accepted: at most {_MAX_DEPTH}")
    if not isinstance(document, dict):
        raise FormatError(f"{kind_of(document)} is no prior; {ACCEPTED}", where=place or None)
    kind = document.get("kind")
    maker = _MAKERS.get(kind) if isinstance(kind, str) else None
    if maker is None:
        raise FormatError(
            f"{kind_of(kind)} is not a kind of prior; accepted: {', '.join(_MAKERS)}",
            where=f"{place}kind",
        )
    keys, make = maker
    if set(document) != {"kind", *keys}:
        found = ", ".join(sorted(key for key in document if key != "kind")) or "none"
        raise FormatError(
            f"the keys of {kind} are {shown(found)}; accepted: {', '.join(keys) or 'none'}",
            where=f"{place}kind",
        )
    try:
        return make(*(_Field(document[key], f"{place}{key}", depth, read) for key in keys))
    except StochgeomError as error:
        where = error.where or ""
        if where.startswith(place):
            raise
        # A component's own complaint, which does not know where the component stands.
        raise type(error)(error.message, where=f"{place}{where}".removesuffix(", ")) from None


class _Field:
    """A value in the document, with the place where it stands."""

    def __init__(self, value: Any, place: str, depth: int, read: _Entries) -> None:
        self.value, self.place, self.depth, self.read = value, place, depth, read

    def number(self) -> mpq:
        self.read.next()
        if not isinstance(self.value, str):
            raise FormatError(
                f"{kind_of(self.value)}; accepted: a number, or its text", where=self.place
            )
        return parse_rational(self.value, where=self.place)

    def items(self) -> list[_Field]:
        if not isinstance(self.value, list):
            raise FormatError(f"{kind_of(self.value)}; accepted: a list", where=self.place)
        return [
            _Field(v, f"{self.place} {k}", self.depth, self.read) for k, v in enumerate(self.value)
        ]

    def rows(self, what: str) -> list[list[_Field]]:
        found = []
        for item in self.items():
            row = item.items()
            if len(row) != len(what.split(", ")):
                raise FormatError(f"a list of {len(row)}; accepted: [{what}]", where=item.place)
            found.append(row)
        return found

    def prior(self) -> Prior:
        return _from_json(self.value, f"{self.place}, ", self.depth + 1, self.read)


def _discrete(points: _Field) -> Prior:
    return DiscretePrior(
        [(angle.number(), weight.number()) for angle, weight in points.rows("ANGLE, WEIGHT")]
    )


def _measurements(degrees: _Field) -> Prior:
    return DiscretePrior.from_measurements([angle.number() for angle in degrees.items()])


def _binned(degrees: _Field, bins: _Field) -> Prior:
    count = bins.number()
    listed = [angle.number() for angle in degrees.items()]
    whole = int(count) if count.denominator == 1 else 0
    try:
        return PiecewisePrior.from_measurements(listed, whole)
    except PriorError as error:
        place = bins if not 0 < whole <= MAX_BINS else degrees
        raise PriorError(error.message, where=place.place) from None


def _histogram(edges: _Field, counts: _Field) -> Prior:
    return PiecewisePrior.from_histogram(
        [edge.number() for edge in edges.items()], [count.number() for count in counts.items()]
    )


def _piecewise(pieces: _Field) -> Prior:
    rows = pieces.rows("START, WIDTH, DENSITY")
    arcs = [_arc(start, width) for start, width, _ in rows]
    return PiecewisePrior(
        [(arc, density.number()) for arc, (_, _, density) in zip(arcs, rows, strict=True)]
    )


def _arc(start: _Field, width: _Field) -> Arc:
    try:
        return Arc(Angle.from_degrees(start.number()), Angle.from_degrees(width.number()))
    except InvalidArcError as error:
        raise InvalidArcError(error.message, where=width.place) from None


def _mixture(components: _Field) -> Prior:
    rows = components.rows("WEIGHT, PRIOR")
    return MixturePrior([(weight.number(), prior.prior()) for weight, prior in rows])


_WORDS: Final[dict[str, Callable[[mpq, mpq], Prior]]] = {
    "normal": WrappedNormal,
    "von-mises": VonMises,
}

_MAKERS: Final[dict[str, tuple[tuple[str, ...], Callable[..., Prior]]]] = {
    "uniform": ((), uniform_prior),
    "discrete": (("points",), _discrete),
    "measurements": (("degrees",), _measurements),
    "binned measurements": (("degrees", "bins"), _binned),
    "histogram": (("edges", "counts"), _histogram),
    "piecewise": (("pieces",), _piecewise),
    "normal": (("mean", "sd"), lambda mean, sd: WrappedNormal(mean.number(), sd.number())),
    "von mises": (("mean", "kappa"), lambda mean, kappa: VonMises(mean.number(), kappa.number())),
    "mixture": (("components",), _mixture),
}
