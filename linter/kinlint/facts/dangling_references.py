"""Names that refer to nothing, and existing names that are almost the same."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator
from functools import cached_property
from itertools import islice
from urllib.parse import unquote

from kinlint.addresses import root_of
from kinlint.facts.fact_statements import fact
from kinlint.facts.metamodel_terms import attribute
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.formats.xml.references import properties
from kinlint.suggestion import LOOKED_UP, distance
from kinlint.terms import Term, Triple

MOST = 2
"""Largest edit distance between a slip of the pen and the name that was meant."""
DIGITS = re.compile(r"\d+")


class DanglingReferences:
    """Targets of references by name, whether they exist or not."""

    def __init__(self, scan: PredicateIndex) -> None:
        forms = {each.format for each in scan.documents if each.format.is_tree}
        leading = {each for form in forms for each in properties(form)}
        self._targets = {
            target
            for each in sorted(leading)
            for _, targets in scan.table(each).items()
            for target in targets
            if target != root_of(target)
        }
        self._named = scan.table(attribute("name"))

    def facts(self) -> Iterator[Triple]:
        """Yield the element that each missing target resembles, where there is one.

        Of many missing targets, only the first few are compared.
        """
        missing = (target for target in sorted(self._targets) if target not in self._named)
        for target in islice(missing, LOOKED_UP):
            home, name = _parts(target)
            known = nearest(name, self._known.get(home, {}))
            if known is not None:
                yield target, fact("resembles"), self._known[home][known]

    @cached_property
    def _known(self) -> dict[str, dict[str, Term]]:
        """Elements with a name, by where they are and what they are called."""
        homes = {_parts(target)[0] for target in self._targets}
        found: dict[str, dict[str, Term]] = {}
        for element in (*self._named.one, *self._named.several):
            home, name = _parts(element)
            if home in homes:
                found.setdefault(home, {})[name] = element
        return found


def _parts(element: Term) -> tuple[str, str]:
    """Return the address of an element without its name, and the name."""
    home, _, name = element.rpartition("/")
    return home, unquote(name[:-1])


def nearest(name: str, known: Iterable[str]) -> str | None:
    """Return the one of *known* that *name* is a slip for: not a sibling with another number."""
    digits = DIGITS.findall(name)
    alike = (
        (distance(name.casefold(), each.casefold(), MOST), each)
        for each in known
        if abs(len(each) - len(name)) <= MOST and DIGITS.findall(each) == digits
    )
    slips, found = min(alike, default=(len(name), ""))
    return found if slips <= min(MOST, len(name) - 1) else None
