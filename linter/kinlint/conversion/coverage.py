"""Coverage of a format by the lifting queries, and the reasons for what is left out."""

from __future__ import annotations

import csv
import re
from collections.abc import Iterator
from fnmatch import fnmatchcase
from functools import cache

from kinlint import resources
from kinlint.conversion.published import published_terms
from kinlint.engine.derivation import derivations
from kinlint.engine.lifting import Lifting, queries
from kinlint.formats.xml.element_types import ElementType
from kinlint.formats.xml.schema import schema
from kinlint.light_dataclasses import dataclass
from kinlint.terms import Term, iri_value
from kinlint.vocabulary import ATTRIBUTE, KINLINT

REASONS = "lifting/left-out.tsv"
"""Path of the reasons below shapes/."""

REST = ("attribute", "lifted", "why")
DEEPEST = 12
"""No deeper than this do elements stand below each other that may stand below themselves."""

_COMPONENT = re.compile(r"-\d+$")


@dataclass(frozen=True, slots=True)
class Reason:
    """Why nothing, or not everything, is made of an element or an attribute."""

    format: str
    """The name of the format."""
    path: tuple[str, ...]
    """The tag, after those of elements that it must stand below."""
    attribute: str
    """The attribute, or "" for the element itself; a pattern with * is for several."""
    lifted: str
    """"no", "part", or "yes" for what the queries take without naming it."""
    why: str
    """The reason, in words."""

    def covers(self, path: tuple[str, ...], attribute: str) -> bool:
        """Tell whether this is about *attribute*, or with "" the element itself, at *path*."""
        return path[-len(self.path) :] == self.path and (
            self.attribute == attribute
            or ("*" in self.attribute and fnmatchcase(attribute, self.attribute))
        )


@cache
def lifting_reasons() -> tuple[Reason, ...]:
    """All reasons, the most specific first."""
    file = resources.data("shapes") / REASONS
    with file.open(encoding="utf-8", newline="") as stream:
        rows = list(csv.DictReader(stream, delimiter="\t"))
    found = [
        Reason(row["format"], tuple(row["element"].split("/")), *map(row.__getitem__, REST))
        for row in rows
    ]
    return tuple(sorted(found, key=lambda one: -len(one.path)))


class Coverage:
    """The elements and attributes of one format that are lifted."""

    def __init__(self, form: str) -> None:
        self.form = form
        self.reasons = [one for one in lifting_reasons() if one.format == form]
        self._reads = frozenset(pair for query in queries(form) for pair in _reads(query))

    def reason(self, path: tuple[str, ...], attribute: str = "") -> Reason | None:
        """Why the element at *path*, or its *attribute*, is not lifted, or not all of it."""
        return next((one for one in self.reasons if one.covers(path, attribute)), None)

    def lifts(self, path: tuple[str, ...]) -> bool:
        """Tell whether a query reads elements at *path*, whose parents are lifted."""
        if (reason := self.reason(path)) is not None:
            return reason.lifted != "no"
        return not self._reads.isdisjoint(((path[-2], path[-1]), ("", path[-1])))

    def lifts_attribute(self, path: tuple[str, ...], attribute: str) -> bool:
        """Tell whether a query reads *attribute* of the elements at *path*, which are lifted."""
        if (reason := self.reason(path, attribute)) is not None:
            return reason.lifted != "no"
        if attribute == "name":
            return True
        return (path[-1], f"@{attribute}") in self._reads

    def unlifted(self) -> Iterator[tuple[tuple[str, ...], str]]:
        """The path of each element that is not lifted, but its parent is, and such attributes.

        Of an element that takes any attribute, those are told that have a reason.
        """
        roots = schema(self.form).roots
        pending: list[tuple[tuple[str, ...], ElementType]] = [
            ((tag,), type_) for tag, type_ in reversed(roots.items())
        ]
        seen: set[tuple[tuple[str, ...], int]] = set()
        while pending:
            path, type_ = pending.pop()
            if (path[-2:], id(type_)) in seen or len(path) > DEEPEST:
                continue
            seen.add((path[-2:], id(type_)))
            if len(path) > 1 and not self.lifts(path):
                yield path, ""
                continue
            yield from (
                (path, name) for name in type_.attributes if not self.lifts_attribute(path, name)
            )
            if type_.open:
                yield from self._reasoned(path, type_)
            pending += [((*path, tag), each) for tag, each in reversed(type_.children.items())]

    def _reasoned(
        self, path: tuple[str, ...], type_: ElementType
    ) -> Iterator[tuple[tuple[str, ...], str]]:
        """Yield attributes of elements at *path* that have a reason and are not in *type_*."""
        for one in self.reasons:
            name = one.attribute
            if (
                one.lifted == "no"
                and name
                and name not in type_.attributes
                and one.covers(path, name)
            ):
                yield path, name


def _reads(query: Lifting) -> Iterator[tuple[str, str]]:
    """Yield the tags that *query* follows, each with that of the element around it, "" for any.

    Attributes have `@` before their names. Nothing for a query that published contexts cannot say
    what it makes.
    """
    known = published_terms()
    if not any(iri_value(term) in known for term in query.makes):
        return
    derived = derivations(query)
    for pattern in derived.patterns:
        around = {_local(way) for way in derived.leading_to(pattern.subject)}
        for way in pattern.path:
            if way.startswith((f"<{ATTRIBUTE}", f"<{KINLINT}{query.format}#")):
                sign = "@" if way.startswith(f"<{ATTRIBUTE}") else ""
                yield from (
                    (each, sign + _COMPONENT.sub("", _local(way))) for each in around or {""}
                )


def _local(term: Term) -> str:
    return term.rpartition("#")[2][:-1]


@cache
def format_coverage(form: str) -> Coverage:
    """Return the coverage of the format called *form*."""
    return Coverage(form)
