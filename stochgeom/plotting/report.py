"""A plan as one HTML page: what is fed, how, how well, and the proof.

The page refers to nothing outside itself and runs no script; the policy in its head forbids both.
The same plan gives the same bytes. Numbers are decimals of exact ones, correctly rounded; pictures
are drawn in floats.
"""

from __future__ import annotations

import os
from collections.abc import Iterable, Iterator
from typing import TYPE_CHECKING, Final

from stochgeom.exact.decimals import check_digits
from stochgeom.io.files import write_whole
from stochgeom.plotting.animation_stage import (
    definitions,
    stage_style,
)
from stochgeom.plotting.part_scenes import part_scene
from stochgeom.plotting.report_sections import (
    actions_section,
    certificate_section,
    costs_section,
    distributions_section,
    exact_section,
    functions_section,
    player_section,
)
from stochgeom.plotting.report_style import PAGE_STYLE
from stochgeom.plotting.report_subject import Subject
from stochgeom.plotting.report_words import (
    facts,
    headline,
)
from stochgeom.plotting.svg import svg_document, text_of

if TYPE_CHECKING:
    from stochgeom.feeding.plans import FeedingPlan

_POLICY: Final = "default-src 'none'; style-src 'unsafe-inline'"
_LONG: Final = 8
"""Figures with more characters are written smaller."""


def write_report(plan: FeedingPlan, path: str | os.PathLike[str], *, digits: int = 4) -> None:
    """Write a plan as an HTML page, whole or not at all.

    Parameters
    ----------
    plan : FeedingPlan
        Any plan; one for no part has no pictures of it.
    path : path
        The file to write; what stands there is replaced.
    digits : int, default 4
        Decimals after the point.

    Raises
    ------
    WriteError
        If the folder is missing or not writable; nothing is written then.
    InputError
        If `digits` is not acceptable.
    """
    write_whole(os.fsdecode(path), report_html(plan, digits=digits))


def report_html(plan: FeedingPlan, *, digits: int = 4) -> str:
    """Return a plan as an HTML page.  About 0.1 s for a part of ten vertices.

    Examples
    --------
    >>> from stochgeom.feeding.planner import plan_feeding
    >>> page = report_html(plan_feeding([(0, 0), (3, 0), (3, 2), (0, 2)]))
    >>> page[:15], "<script src" in page
    ('<!DOCTYPE html>', False)
    """
    subject = Subject(plan, check_digits(digits))
    title = f"Feeding plan for {text_of(subject.name)}"
    style = PAGE_STYLE
    if subject.traces:
        style += stage_style(subject.traces, subject.actions)
    return "\n".join(
        [
            '<!DOCTYPE html>\n<html lang="en">\n<head>\n<meta charset="utf-8">',
            f'<meta http-equiv="Content-Security-Policy" content="{_POLICY}">',
            '<meta name="viewport" content="width=device-width, initial-scale=1">',
            '<meta name="generator" content="stochgeom">',
            f"<title>{title}</title>\n<style>\n{style}\n</style>\n</head>\n<body>\n<main>",
            _hero(subject, title),
            *_sections(subject),
            "</main>\n</body>\n</html>\n",
        ]
    )


def _sections(subject: Subject) -> Iterator[str]:
    if subject.traces:
        yield _section("The plan at work", player_section(subject))
    yield _section("Actions and their tolerances", actions_section(subject))
    yield _section("Where the part may be", distributions_section(subject))
    yield _section("Why this plan: the functions behind it", functions_section(subject))
    yield _section("What plans of other lengths cost", costs_section(subject))
    yield _section("Exact numbers", exact_section(subject))
    yield _section("Certificate", certificate_section(subject))


def _section(title: str, content: Iterable[str]) -> str:
    return f"<section>\n<h2>{title}</h2>\n" + "\n".join(content) + "\n</section>"


def _size_of(value: str) -> str:
    return ' class="long"' if len(value) > _LONG else ""


def _hero(subject: Subject, title: str) -> str:
    part = subject.plan.part
    picture = ""
    if part is not None:
        words = f"{subject.name}: {len(part)} vertices, {len(part.hull)} on the convex hull"
        picture = svg_document(
            part_scene(part), title=subject.name, description=words, scale=90.0, background=False
        )
    rows = "".join(
        f"<div><dt>{what}</dt><dd{_size_of(value)}>{value}</dd></div>"
        for value, what in facts(subject)
    )
    return (
        f'<header><div class="hero">{definitions(subject.traces[0]) if subject.traces else ""}'
        f"{picture}<div><h1>{title}</h1>{headline(subject)}</div></div>"
        f'<dl class="facts">{rows}</dl></header>'
    )
