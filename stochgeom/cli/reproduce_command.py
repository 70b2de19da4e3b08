"""``stochgeom reproduce``: the source's tables and figures, recomputed beside what is printed."""

from __future__ import annotations

import argparse
from collections.abc import Callable, Sequence
from contextlib import nullcontext
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any, Final

from stochgeom.cli.options import add_digits, add_json, read_digits
from stochgeom.cli.output import write, write_json
from stochgeom.cli.progress import Progress
from stochgeom.errors import InputError, MissingExtraError, UnknownReproductionError

if TYPE_CHECKING:  # loaded when the command runs: other commands start without them
    from stochgeom.cli.reproduce_files import ResultFolder
    from stochgeom.cli.reproduce_text import Outcome
    from stochgeom.thesis.number_tables import NumberTable

_MODULES: Final = {"plot": "matplotlib", "sim": "pymunk"}
"""What an extra brings."""

NEEDS_FOLDER: Final = "needs -o"
NOT_WANTED: Final = "not drawn"


def add_parser(commands: Any) -> None:
    """Register the command."""
    parser = commands.add_parser(
        "reproduce",
        help="recompute the tables and figures of the source",
        description="Recompute tables and figures of Goldberg (1990): numbers beside the printed "
        "ones, pictures as SVG files, and a summary of what is reproduced, explained by an "
        "erratum, or open.",
    )
    parser.add_argument(
        "names", nargs="*", metavar="NAME", help="such as 4.1, fig4.6, sec4.8; or --all"
    )
    parser.add_argument("--all", action="store_true", help="everything but long experiments")
    parser.add_argument("--long", action="store_true", help="with --all: long experiments too")
    parser.add_argument(
        "-o", "--out", metavar="DIR", help="folder to write text, JSON, CSV and SVG files to"
    )
    parser.add_argument("--no-pictures", action="store_true", help="numbers only")
    add_digits(parser)
    add_json(parser, "print a JSON document")
    parser.set_defaults(run=run)


def run(arguments: argparse.Namespace) -> int:
    """Recompute; exit code 1 if a printed number differs and no erratum explains it."""
    from stochgeom.cli.reproduce_files import ResultFolder
    from stochgeom.cli.reproduce_text import summary_document, summary_text, table_text

    digits = read_digits(arguments.digits)
    names = chosen_names(arguments.names, every=arguments.all, long=arguments.long)
    pictures = not arguments.no_pictures and arguments.out is not None
    _need_extras(names, pictures=pictures)
    with ResultFolder(arguments.out) if arguments.out is not None else nullcontext() as folder:
        with Progress("reproducing") as progress:
            outcomes = []
            unseen = NOT_WANTED if arguments.no_pictures else NEEDS_FOLDER
            for place, name in enumerate(names):
                tell = _part_of(progress.show, place, len(names))
                outcomes.append(
                    _outcome(name, folder, tell, digits, unseen="" if pictures else unseen)
                )
                tell(1.0)
        omitted = left_out(names) if arguments.all else []
        document = summary_document(outcomes, digits, omitted)
        summary = summary_text(outcomes, omitted)
        if folder is not None:
            _write_summary(folder, summary, document)
    if arguments.json:
        write_json(document)
    else:
        tables = [table_text(o.name, o.numbers, digits) for o in outcomes if o.numbers is not None]
        write("\n\n\n".join([*(tables if folder is None else []), summary]))
    return 1 if document["open"] else 0


def chosen_names(names: Sequence[str], *, every: bool, long: bool) -> list[str]:
    """Return the names that are meant, each once, in the order of the source.

    Raises
    ------
    UnknownReproductionError
        If there is nothing of some name, or nothing is named; the known ones are listed.
    InputError
        If ``--long`` stands without ``--all``.
    """
    from stochgeom.plotting.source_figures import SOURCE_FIGURES
    from stochgeom.thesis.reproductions import REPRODUCTIONS, canonical_name, number_of, place_of

    short = [name for name, item in REPRODUCTIONS.items() if long or not item.long]
    known = {*REPRODUCTIONS, *SOURCE_FIGURES}
    listed = ", ".join(sorted(known, key=place_of))
    if long and not every:
        raise InputError("without --all; accepted: --all --long, or the names", where="--long")
    if not names and not every:
        raise UnknownReproductionError(f"nothing is named; accepted: --all, or some of {listed}")
    found = {*short, *SOURCE_FIGURES} if every else set()
    for text in names:
        name = canonical_name(text)
        if name not in known:
            alike = [other for other in known if number_of(other) == number_of(name)]
            hint = f"; is {' or '.join(sorted(alike, key=place_of))} meant?" if alike else ""
            raise UnknownReproductionError(
                f"no table or figure {text[:40]!r}{hint}; accepted: {listed}"
            )
        found.add(name)
    return sorted(found, key=place_of)


def left_out(names: Sequence[str]) -> list[str]:
    """Return the long experiments that are not among the names, in the order of the source."""
    from stochgeom.thesis.reproductions import REPRODUCTIONS, place_of

    experiments = {name for name, item in REPRODUCTIONS.items() if item.long}
    return sorted(experiments - {*names}, key=place_of)


def _need_extras(names: Sequence[str], *, pictures: bool) -> None:
    """Say before the work begins what is not installed."""
    from stochgeom.plotting.source_figures import SOURCE_FIGURES
    from stochgeom.thesis.reproductions import REPRODUCTIONS

    needed = {item.extra for name in names if (item := REPRODUCTIONS.get(name)) and item.extra}
    if pictures and any(name in SOURCE_FIGURES for name in names):
        needed.add("plot")
    for extra in sorted(needed):
        if not _is_installed(_MODULES[extra]):
            other = " (or --no-pictures)" if extra == "plot" else ""
            what = "pictures" if extra == "plot" else "experiments on simulated robots"
            raise MissingExtraError.of(what, _MODULES[extra], extra, instead=other)


def _is_installed(module: str) -> bool:
    try:
        return find_spec(module) is not None
    except ValueError:  # hidden on purpose
        return False


def _part_of(tell: Callable[[float], None], place: int, count: int) -> Callable[[float], None]:
    return lambda share: tell((place + share) / count)


def _outcome(
    name: str,
    folder: ResultFolder | None,
    tell: Callable[[float], None],
    digits: int,
    *,
    unseen: str,
) -> Outcome:
    """Recompute and draw; or say of pictures why they are not drawn."""
    from stochgeom.cli.reproduce_text import Outcome
    from stochgeom.plotting.source_figures import SOURCE_FIGURES
    from stochgeom.thesis.reproductions import REPRODUCTIONS

    item, figure = REPRODUCTIONS.get(name), SOURCE_FIGURES.get(name)
    numbers = None if item is None else item.make(tell)
    files = [] if numbers is None or folder is None else _write(folder, name, numbers, digits)
    picture, title = "", item.title if item else ""
    if figure is not None:
        title = title or figure.title
        picture = unseen or "drawn"
        if folder is not None and not unseen:
            files.append(_draw(folder, name))
    return Outcome(name, title, numbers, picture, tuple(files))


def _write(folder: ResultFolder, name: str, numbers: NumberTable, digits: int) -> list[str]:
    from stochgeom.cli.reproduce_text import table_csv, table_document, table_text

    stem = file_stem(name)
    return [
        folder.write(f"{stem}.txt", table_text(name, numbers, digits) + "\n"),
        folder.write(f"{stem}.json", _dumped(table_document(name, numbers, digits))),
        folder.write(f"{stem}.csv", table_csv(numbers, digits)),
    ]


def _draw(folder: ResultFolder, name: str) -> str:
    import matplotlib

    matplotlib.use("Agg")
    import matplotlib.pyplot as plt

    from stochgeom.plotting.axes import save_figure
    from stochgeom.plotting.source_figures import SOURCE_FIGURES

    file = f"{file_stem(name)}.svg"
    drawn = SOURCE_FIGURES[name].draw()
    if isinstance(drawn, str):
        return folder.write(file, drawn)
    save_figure(drawn, folder.path_of(file))
    plt.close(drawn.get_figure(root=True))
    return file


def file_stem(name: str) -> str:
    """Return the name of the files of a table or figure, without ending.

    Examples
    --------
    >>> file_stem("4.1"), file_stem("figE.5"), file_stem("sec4.8")
    ('table-4.1', 'fig-E.5', 'sec-4.8')
    """
    for prefix in ("fig", "sec"):
        if name.startswith(prefix):
            return f"{prefix}-{name.removeprefix(prefix)}"
    return f"table-{name}"


def _write_summary(folder: ResultFolder, summary: str, document: dict[str, Any]) -> None:
    folder.write("summary.txt", summary + "\n")
    folder.write("summary.json", _dumped(document))


def _dumped(document: dict[str, Any]) -> str:
    import json

    return json.dumps(document, indent=1) + "\n"
