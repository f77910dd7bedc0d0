"""Losses of a conversion, counted by kind, each with the reason."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass

from kinlint.conversion.coverage import Coverage, coverage
from kinlint.document import FROM, Document
from kinlint.terms import (
    RDF,
    RDF_TYPE,
    Term,
    Triple,
    iri,
    is_blank,
    literal_datatype,
    literal_value,
)
from kinlint.vocabulary import ATTRIBUTE, EXTENSION, KINLINT, SRC

Path = tuple[str, ...]

ORDER = iri(f"{SRC}order")
FIRST, REST = iri(f"{RDF}first"), iri(f"{RDF}rest")
FAULTS = {
    f"<{SRC}MalformedValue>": "malformed values",
    f"<{SRC}MalformedText>": "places that are not well-formed",
    f"<{SRC}UnresolvedInclude>": "included files that are not there",
    f"<{SRC}CircularInclude>": "files that include themselves",
    f"<{SRC}Unexpanded>": "places that xacro would have to expand",
}
FAULTY = "kinlint check tells where"
FOREIGN = "the format has no such thing here"
REPEATED = "the first of several counts"
UNUSED = "nothing in the model takes it here"


@dataclass(frozen=True, slots=True)
class Loss:
    """`count` elements or attributes called `what` that are not in the result."""

    what: str
    count: int
    why: str

    def __str__(self) -> str:
        return f"{self.count} {self.what}: {self.why}"


def losses(documents: Iterable[Document], lifted: Iterable[Triple]) -> list[Loss]:
    """Return what is in *documents* and not in what was *lifted* from them, by kind."""
    made = _numbers(lifted)
    counted: Counter[tuple[str, str]] = Counter()
    for document in documents:
        counted.update(_Contents(document, made).lost())
    return [Loss(what, count, why) for (what, why), count in sorted(counted.items())]


def _numbers(lifted: Iterable[Triple]) -> Mapping[Term, set[float]]:
    """The numbers of what comes from each element."""
    origins: dict[Term, list[Term]] = {}
    said: dict[Term, list[Term]] = {}
    for s, p, o in lifted:
        if p == FROM:
            origins.setdefault(s, []).append(o)
        elif p != RDF_TYPE and (p in (FIRST, REST) or is_blank(o) or o[0] == '"'):
            said.setdefault(s, []).append(o)
    found: dict[Term, set[float]] = {}
    for node, elements in origins.items():
        pending, numbers = [node], set()
        while pending:
            for value in said.get(pending.pop(), ()):
                if is_blank(value):
                    pending.append(value)
                elif (number := _number(value)) is not None:
                    numbers.add(number)
        for element in elements:
            found.setdefault(element, set()).update(numbers)
    return found


def _number(term: Term) -> float | None:
    numeric = term[0] == '"' and literal_datatype(term).endswith(("double", "integer", "decimal"))
    return float(literal_value(term)) if numeric else None


class _Contents:
    """The elements of one document below each other, with their attributes."""

    def __init__(self, document: Document, made: Mapping[Term, set[float]]) -> None:
        form = document.format.lifted_as
        self.known: Coverage = coverage(form)
        self.made = made
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
        if element in self.made or (reason is not None and reason.lifted == "yes"):
            return None
        if element in self.repeated:
            return REPEATED
        if any(_number(value) is not None for _, value in self.attributes.get(element, ())):
            return reason.why if reason else UNUSED
        return None

    def _attributes(self, path: Path, element: Term) -> Iterator[tuple[str, str]]:
        """The attributes of *element* that nothing has the values of."""
        made = self.made.get(element, ())
        told = set()
        for name, value in self.attributes.get(element, ()):
            stem, _, component = name.rpartition("-")
            attribute = stem if component.isdecimal() else name
            reason = self.known.reason(path, attribute)
            if attribute in told or (reason is not None and reason.lifted == "yes"):
                continue
            number = _number(value)
            lifted = self.known.lifts_attribute(path, attribute)
            if not lifted or (number is not None and number not in made):
                told.add(attribute)
                why = reason.why if reason else UNUSED if lifted else FOREIGN
                yield f"'{path[-1]}/@{attribute}'", why
