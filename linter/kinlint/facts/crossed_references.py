"""References from a part of the left to one of the right, or the other way around.

Where the counterpart of what refers names the same, and the one on the proper side is named by
neither, the reference was probably not changed when one side was copied.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from kinlint.facts.fact_statements import fact
from kinlint.facts.laterality import counterpart, is_left
from kinlint.facts.metamodel_terms import attribute
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.formats.source_layer import src
from kinlint.formats.xml.references import properties
from kinlint.terms import Term, Triple

ELSEWHERE = re.compile(r"/(?:parent|child)>$|/transmission/")
"""Addresses of elements that other facts compare: the ends of joints, and transmissions."""


def crossed_references(scan: PredicateIndex) -> Iterator[Triple]:
    """Yield each reference to the other side, with the element of the proper side."""
    forms = {each.format for each in scan.documents if each.format.is_tree}
    named = scan.table(attribute("name"))
    lists = _claimed(scan)
    for prop in sorted({each for form in forms for each in properties(form)}):
        found: dict[str, dict[Term, Term]] = {}
        for subject, targets in scan.table(prop).items():
            for target in targets:
                owner = lists.get(subject) or _owner(subject, target)
                found.setdefault(owner, {})[target] = subject
        for owner, own in sorted(found.items()):
            twin = found.get(_across(owner), {})
            side = _side(owner)
            if side is None or ELSEWHERE.search(owner):
                continue
            for target in sorted(own.keys() & twin.keys()):
                proper = _across(target)
                free = proper in named and proper not in own and proper not in twin
                if free and _side(target) is (not side) and not _leads(found, proper, target):
                    yield own[target], fact("refers-across"), target
                    yield own[target], fact("proper-target"), proper


def _claimed(scan: PredicateIndex) -> Mapping[Term, Term]:
    """Return the controllers of the joints that they list."""
    claiming = {
        listed: controller
        for role in ("joints", "left", "right")
        for controller, listed in scan.single(src(role)).items()
    }
    members = scan.single(src("memberOf")).items()
    return {each: claiming[listed] for each, listed in members if listed in claiming}


def _owner(subject: Term, target: Term) -> Term:
    """Return the address of *subject* without the name that is only that of its *target*."""
    name = _steps(target)[-1]
    file, _, path = subject[:-1].partition("#")
    return f"{file}#{'/'.join(each for each in path.split('/') if _bare(each) != name)}>"


def _across(address: Term) -> Term:
    """Return what *address* would be on the other side: itself, if it names no side."""
    file, _, path = address[:-1].partition("#")
    return f"{file}#{'/'.join(counterpart(each) or each for each in path.split('/'))}>"


def _side(address: Term) -> bool | None:
    """Tell whether all sides in the path of *address* are left; None if there are none or both."""
    sides = {is_left(each) for each in _steps(address)} - {None}
    return sides.pop() if len(sides) == 1 else None


def _steps(address: Term) -> list[str]:
    return [_bare(each) for each in address[:-1].partition("#")[2].split("/")]


def _bare(step: str) -> str:
    """Return *step* of a path without the order that tells it from others of its name."""
    return step.partition(";")[0]


def _leads(found: Mapping[str, Mapping[Term, Term]], one: Term, target: Term) -> bool:
    """Tell whether something in the element *one* refers to *target*, as followers do."""
    within = f"{one[:-1]}/"
    return any(owner.startswith(within) and target in named for owner, named in found.items())
