"""Losses of a conversion, counted by kind, each with the reason."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Mapping

from kinlint.conversion.coverage import Coverage, format_coverage
from kinlint.document import FROM, Document
from kinlint.engine.provenance import Provenance
from kinlint.light_dataclasses import dataclass
from kinlint.terms import (
    NUMERIC,
    RDF_TYPE,
    Term,
    Triple,
    iri,
    literal_datatype,
)
from kinlint.vocabulary import ATTRIBUTE, EXTENSION, KINLINT, SRC

Path = tuple[str, ...]

ORDER = iri(f"{SRC}order")
FAULTS = {
    f"<{SRC}MalformedValue>": "malformed values",
    f"<{SRC}MalformedText>": "places that are not well-formed",
    f"<{SRC}UnresolvedInclude>": "included files that are not there",
    f"<{SRC}CircularInclude>": "files that include themselves",
    f"<{SRC}MissingPart>": "parts that need a package which is not there",
    f"<{SRC}Unexpanded>": "places that xacro would have to expand",
}
COMPONENT = re.compile(r"-\d+$")
FAULTY = "kinlint check lists the places"
FOREIGN = "the format has no such thing here"
REPEATED = "the first of several counts"
UNUSED = "nothing in the model takes it here"


@dataclass(frozen=True, slots=True)
class Loss:
    """Elements or attributes of one name that are not in the result."""

    what: str
    """The name."""
    count: int
    """Number of elements or attributes."""
    why: str
    """The reason."""

    def __str__(self) -> str:
        return f"{self.count} {self.what}: {self.why}"


def conversion_losses(
    documents: Iterable[Document], lifted: Iterable[Triple], provenance: Provenance
) -> list[Loss]:
    """Return what is in *documents* and not in what was *lifted* from them, by kind."""
    read: dict[Term, set[str]] = {o: set() for _, p, o in lifted if p == FROM}
    for element, property_ in provenance.all_read():
        read.setdefault(element, set()).add(_attribute(property_))
    counted: Counter[tuple[str, str]] = Counter()
    for document in documents:
        counted.update(_Contents(document, read).lost())
    return [Loss(what, count, why) for (what, why), count in sorted(counted.items())]


def _attribute(property_: Term) -> str:
    """Return the name of the attribute that has *property_*, or a component of it."""
    return COMPONENT.sub("", property_.rpartition("#")[2][:-1])


def _is_number(term: Term) -> bool:
    return term[0] == '"' and literal_datatype(term) in NUMERIC


class _Contents:
    """The elements of one document below each other, with their attributes.

    *read* are the elements that something is lifted from, each with the attributes that enter it.
    """

    def __init__(self, document: Document, read: Mapping[Term, set[str]]) -> None:
        form = document.format.lifted_as
        self.known: Coverage = format_coverage(form)
        self.read = read
        self.root = document.graph
        self.below: dict[Term, list[tuple[str, Term]]] = {}
        self.attributes: dict[Term, list[tuple[str, Term]]] = {}
        self.repeated: set[Term] = set()
        self.faults: list[str] = []
        elements, attribute = (f"<{KINLINT}{form}#", f"<{EXTENSION}"), f"<{ATTRIBUTE}"
        for s, p, o in document.statements:
            if p.startswith(elements):
                self.below.setdefault(s, []).append((p.rpartition("#")[2][:-1], o))
            elif p.startswith(attribute):
                self.attributes.setdefault(s, []).append((p.rpartition("#")[2][:-1], o))
            elif p == ORDER:
                self.repeated.add(s)
            elif p == RDF_TYPE and o in FAULTS:
                self.faults.append(FAULTS[o])

    def lost(self) -> Iterator[tuple[str, str]]:
        """Each thing that is not lifted, with the reason; not what is below of it."""
        yield from ((fault, FAULTY) for fault in self.faults)
        pending: list[tuple[Path, Term]] = [
            ((tag,), each) for tag, each in self.below.get(self.root, ())
        ]
        while pending:
            path, element = pending.pop()
            if len(path) > 1 and (why := self._unmade(path, element)):
                yield f"'{'/'.join(path[-2:])}'", why
                continue
            yield from self._attributes(path, element)
            pending += [((*path, tag), each) for tag, each in self.below.get(element, ())]

    def _unmade(self, path: Path, element: Term) -> str | None:
        """Why nothing is made of *element*; None if something is."""
        reason = self.known.reason(path)
        if not self.known.lifts(path):
            return reason.why if reason else FOREIGN
        if element in self.read or (reason is not None and reason.lifted == "yes"):
            return None
        if element in self.repeated:
            return REPEATED
        if any(_is_number(value) for _, value in self.attributes.get(element, ())):
            return reason.why if reason else UNUSED
        return None

    def _attributes(self, path: Path, element: Term) -> Iterator[tuple[str, str]]:
        """The attributes of *element* that nothing has the values of."""
        read = self.read.get(element, ())
        told = set()
        for name, value in self.attributes.get(element, ()):
            attribute = COMPONENT.sub("", name)
            reason = self.known.reason(path, attribute)
            if attribute in told or (reason is not None and reason.lifted == "yes"):
                continue
            lifted = self.known.lifts_attribute(path, attribute)
            if not lifted or (_is_number(value) and attribute not in read):
                told.add(attribute)
                why = reason.why if reason else UNUSED if lifted else FOREIGN
                yield f"'{path[-1]}/@{attribute}'", why
