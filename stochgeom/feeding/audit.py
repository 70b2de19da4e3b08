"""The audit: hostile parts planned, certified, checked, and compared with exhaustive search.

For each part the stochastically optimal plan and the shortest one that orients it are computed;
each plan's certificate is written as JSON, read again and checked by the stand-alone checker,
which shares nothing with the planner; and a search that goes through all plans may be asked for
the widest arc that plans of each length collapse. Everything is compared exactly: whatever
differs, or raises, is a disagreement, and the row tells how to make the part again.

Nothing is printed here; the command ``stochgeom audit`` does that.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Iterator
from dataclasses import dataclass
from itertools import groupby
from typing import Final, final

from stochgeom.errors import InputError
from stochgeom.exact.scalars import RationalLike, rational_text
from stochgeom.feeding import certificate_checker
from stochgeom.feeding.adversarial import FAMILIES, Family, families_named
from stochgeom.feeding.certificates import certificate
from stochgeom.feeding.exhaustive import first_disagreement, search_plans
from stochgeom.feeding.plans import FeedingPlan
from stochgeom.feeding.problem import FeedingProblem
from stochgeom.geometry.part import Part

SCHEMA: Final = "stochgeom/finding/1"

NODE_LIMIT: Final = 10_000
"""Nodes a search generates at most: ten times what the source's own did."""

MOST_STATES: Final = 16
"""Parts with more stable orientations in a period are not searched."""


@final
@dataclass(frozen=True, slots=True)
class Comparison:
    """What an exhaustive search says about a problem.

    Attributes
    ----------
    lengths : int
        How many plan lengths were gone through completely and compared; 0 if the part was too
        large.
    complete : bool
        Whether the search ended by itself.
    disagreement : str or None
        What differs, if anything does.
    """

    lengths: int
    complete: bool
    disagreement: str | None = None


Exhaustive = Callable[[FeedingProblem], Comparison]
"""A way to compare phase I with a search, such as `compare_with_search`."""


@final
@dataclass(frozen=True, slots=True)
class Case:
    """One part of an audit: a family's name, a size and a seed.

    Examples
    --------
    >>> Case("long plans", 5, 1).part().name
    'long plan 5, seed 1'
    """

    family: str
    size: int
    seed: int

    def part(self) -> Part:
        """Return the part."""
        return FAMILIES[self.family](self.size, self.seed)


@final
@dataclass(frozen=True, slots=True)
class AuditRow:
    """What was found for one part.

    Attributes
    ----------
    case : Case
        Where the part comes from.
    part : Part
        The part.
    optimal_steps, shortest_steps : int
        Steps of the stochastically optimal plan and of the shortest one that orients the part up
        to symmetry; 0 if planning failed.
    certificates : int
        How many certificates the checker found valid: 2, or 1 if the two plans are the same.
    comparison : Comparison or None
        What exhaustive search says; None if it was not asked.
    disagreement : str or None
        The first thing that is wrong, if any is.
    """

    case: Case
    part: Part
    optimal_steps: int = 0
    shortest_steps: int = 0
    certificates: int = 0
    comparison: Comparison | None = None
    disagreement: str | None = None

    def reproduction(self) -> str:
        """Return the finding as JSON text, see `reproduction`."""
        case = self.case
        message = self.disagreement or "no disagreement"
        return reproduction(self.part, case.family, case.size, case.seed, message)


@final
@dataclass(frozen=True, slots=True)
class FamilySummary:
    """What was found for the parts of one family.

    Attributes
    ----------
    family : str
        Its name.
    parts, certificates : int
        Parts planned and certificates found valid.
    sides, longest : int
        Most hull edges of a part, most steps of a shortest plan up to symmetry.
    searched : int
        Parts that exhaustive search went through.
    disagreements : int
        Parts for which something was wrong.
    """

    family: str
    parts: int
    certificates: int
    sides: int
    longest: int
    searched: int
    disagreements: int


def audit_cases(
    families: Iterable[str] | None = None, count: int = 100, seed: int = 0
) -> Iterator[Case]:
    """Yield the cases of an audit, family by family: `count` parts of each, in their usual sizes.

    Parameters
    ----------
    families : names, optional
        Default: all.
    count : int, default 100
        Parts of each family.
    seed : int, default 0
        The seed of the first part; the others have the seeds that follow.

    Raises
    ------
    InputError
        For a family that does not exist, or a count below 1.

    Examples
    --------
    >>> [(case.size, case.seed) for case in audit_cases(["long plans"], 3, 7)]
    [(10, 7), (11, 8), (12, 9)]
    """
    if count < 1:
        raise InputError(f"{count} parts of each family; accepted: 1 or more")
    chosen = families_named(families)
    return (_case(family, seed + k) for family in chosen for k in range(count))


def _case(family: Family, seed: int) -> Case:
    # Case k is the same in whichever audit it occurs.
    return Case(family.name, family.usual_size(seed), seed)


def audit(
    families: Iterable[str] | None = None,
    count: int = 100,
    seed: int = 0,
    *,
    action: str = "squeeze",
    cost_ratio: RationalLike = 1,
    exhaustive: Exhaustive | None = None,
) -> Iterator[AuditRow]:
    """Plan the parts of hostile families, have every answer checked, and yield a row for each.

    Parameters
    ----------
    families, count, seed
        Which parts, see `audit_cases`.
    action : str, default "squeeze"
        What the plans are made of.
    cost_ratio : rational >= 0, default 1
        c, for the optimal plans.
    exhaustive : callable, optional
        Compares a problem with a search, for example `compare_with_search`.

    Notes
    -----
    Rows do not depend on each other: with several processes, map `audit_case` over
    `audit_cases`.

    Examples
    --------
    >>> row = next(audit(["long plans"], 1, exhaustive=compare_with_search))
    >>> row.shortest_steps, row.certificates, row.comparison.complete, row.disagreement
    (3, 1, True, None)
    """
    for case in audit_cases(families, count, seed):
        yield audit_case(case, action=action, cost_ratio=cost_ratio, exhaustive=exhaustive)


def audit_case(
    case: Case,
    *,
    action: str = "squeeze",
    cost_ratio: RationalLike = 1,
    exhaustive: Exhaustive | None = None,
) -> AuditRow:
    """Return the row of one case, whatever goes wrong with its part."""
    part = case.part()
    return audit_part(part, case, action=action, cost_ratio=cost_ratio, exhaustive=exhaustive)


def audit_part(
    part: Part,
    case: Case,
    *,
    action: str = "squeeze",
    cost_ratio: RationalLike = 1,
    exhaustive: Exhaustive | None = None,
) -> AuditRow:
    """Return the row of a part, which may come from elsewhere than the case says."""
    try:
        problem = FeedingProblem(part, action)
        optimal, shortest = problem.optimal_plan(cost_ratio), problem.geometric_plan(cost_ratio)
        plans = [optimal] if optimal.steps == shortest.steps else [optimal, shortest]
        wrong = [found for plan in plans if (found := _wrong_with(plan, optimal, shortest))]
        comparison = None if exhaustive is None else exhaustive(problem)
    except Exception as error:  # noqa: BLE001 -- any error at all is what an audit is looking for
        return AuditRow(case, part, disagreement=f"{type(error).__name__}: {error}")
    valid = len(plans) - len(wrong)
    if comparison is not None and comparison.disagreement is not None:
        wrong.append(comparison.disagreement)
    return AuditRow(
        case, part, optimal.steps, shortest.steps, valid, comparison, wrong[0] if wrong else None
    )


def _wrong_with(plan: FeedingPlan, optimal: FeedingPlan, shortest: FeedingPlan) -> str | None:
    """Return what the checker says against a plan's certificate, sent through its JSON text."""
    text = json.dumps(certificate(plan))
    try:
        document = certificate_checker.load(text.encode())
        certificate_checker.check(document)
    except certificate_checker.InvalidClaimError as error:
        return f"the certificate of the plan of {plan.steps} steps: {error}"
    # A certificate may truly say that its plan is not the best one.
    claims = document["plan"]
    for claim, holds in (
        ("optimal", plan.steps == optimal.steps),
        ("orients_up_to_symmetry", plan.steps == shortest.steps),
    ):
        if claims[claim] is not holds:
            return f"the plan of {plan.steps} steps: {claim} is {claims[claim]}, not {holds}"
    return None


def compare_with_search(
    problem: FeedingProblem, node_limit: int = NODE_LIMIT, most_states: int = MOST_STATES
) -> Comparison:
    """Compare phase I with breadth-first search, for each plan length that it goes through.

    Examples
    --------
    >>> compare_with_search(FeedingProblem([(0, 0), (3, 0), (3, 2), (0, 2)]))
    Comparison(lengths=2, complete=True, disagreement=None)
    """
    if len(problem.transfer) > most_states:
        return Comparison(0, complete=False)
    search = search_plans(problem.transfer, node_limit=node_limit)
    steps = first_disagreement(search, problem.preimages)
    message = None if steps is None else f"exhaustive search: plans of {steps} steps do not agree"
    lengths = sum(length.complete for length in search.lengths)
    return Comparison(lengths, search.solved, message)


def reproduction(part: Part, family: str, size: int, seed: int, message: str) -> str:
    """Return a finding as JSON text: the part, where it comes from, and what was wrong.

    The text is an outline as well: ``stochgeom plan FILE`` reads the part from it.

    Examples
    --------
    >>> text = reproduction(Case("near ties", 9, 4).part(), "near ties", 9, 4, "none")
    >>> sorted(json.loads(text))
    ['family', 'message', 'name', 'schema', 'seed', 'size', 'vertices']
    """
    document = {
        "schema": SCHEMA,
        "family": family,
        "size": size,
        "seed": seed,
        "message": message,
        "name": part.name,
        "vertices": [[rational_text(x), rational_text(y)] for x, y in part.vertices],
    }
    return json.dumps(document, indent=1) + "\n"


def summarize(rows: Iterable[AuditRow]) -> Iterator[FamilySummary]:
    """Yield a summary of each family, as soon as its last row is there.

    Examples
    --------
    >>> [summary] = summarize(audit(["long plans"], 5))
    >>> summary.parts, summary.longest, summary.disagreements
    (5, 7, 0)
    """
    for family, group in groupby(rows, key=lambda row: row.case.family):
        found = list(group)
        yield FamilySummary(
            family=family,
            parts=len(found),
            certificates=sum(row.certificates for row in found),
            sides=max(len(row.part.hull) for row in found),
            longest=max(row.shortest_steps for row in found),
            searched=sum(row.comparison is not None and row.comparison.complete for row in found),
            disagreements=sum(row.disagreement is not None for row in found),
        )
