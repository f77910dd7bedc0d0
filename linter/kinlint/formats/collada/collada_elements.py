"""The elements of a COLLADA document, with their identifiers and the statements of their values."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from itertools import islice

from kinlint.errors import SourceError
from kinlint.formats.collada.format import COLLADA
from kinlint.formats.xml.element_types import ANY, ElementType
from kinlint.formats.xml.schema import schema
from kinlint.light_dataclasses import dataclass, field
from kinlint.terms import Term, Triple, is_iri, literal_value
from kinlint.text import SourceText
from kinlint.vocabulary import ATTRIBUTE, EXTENSION, SRC
from kinlint.vocabulary import COLLADA as NAMESPACE

MOST = {
    "joint": 3_000,
    "link": 3_000,
    "newparam": 10_000,
    "node": 30_000,
    "rigid_body": 3_000,
    "rotate": 40_000,
    "translate": 40_000,
}
"""Most elements of a document, by tag."""
MOST_TRANSFORMS = 2_000
"""Most transforms of a link, a node or a frame."""

_TRANSFORMS = frozenset({"translate", "rotate", "scale", "matrix", "skew", "lookat"})
_AT, _TEXT, _WORDS = f"<{ATTRIBUTE}", f"<{SRC}text", f"<{SRC}words>"


@dataclass(eq=False, slots=True)
class ColladaElement:
    """Element of COLLADA."""

    node: Term
    """Its node in the graph."""
    tag: str
    """Tag, without prefix."""
    parent: ColladaElement | None = field(repr=False)
    """Element around it; None for the document."""
    type: ElementType = field(repr=False)
    """Type of elements at its place."""
    said: dict[str, Triple] = field(default_factory=dict, repr=False)
    """The statements of attributes by their names, and of a text ("")."""
    components: list[Triple] = field(default_factory=list, repr=False)
    """The statements of the numbers of its text, if that is a vector."""
    words: int | None = None
    """Number of words of its text, if that is bulk data."""
    children: list[ColladaElement] = field(default_factory=list, repr=False)
    """Child elements in their order."""

    def text(self, attribute: str = "") -> str:
        """Return the value of *attribute*, or of the text; empty if there is none."""
        said = self.said.get(attribute)
        return literal_value(said[2]).strip() if said else ""

    def numbers(self) -> list[float]:
        """Return the numbers of its text, if that is a vector."""
        return [float(literal_value(each[2])) for each in self.components]

    def all(self, *tags: str) -> Iterator[ColladaElement]:
        """Yield the children with one of *tags*."""
        return (each for each in self.children if each.tag in tags)

    def first(self, *path: str) -> ColladaElement | None:
        """Return the first descendant on the way that the tags of *path* tell."""
        at: ColladaElement | None = self
        for tag in path:
            at = next(at.all(tag), None) if at is not None else None
        return at

    def below(self) -> Iterator[ColladaElement]:
        """Yield all elements below, each before what is in it."""
        pending = self.children[::-1]
        while pending:
            at = pending.pop()
            yield at
            pending += at.children[::-1]

    def ancestors(self) -> Iterator[ColladaElement]:
        """Yield the elements around it, the nearest first."""
        at = self.parent
        while at is not None and at.tag:
            yield at
            at = at.parent


class Excess(Exception):
    """Element that no robot has as many of, as the *node*, and what is too much."""

    def __init__(self, node: Term, cause: str) -> None:
        super().__init__(cause)
        self.node = node
        self.cause = cause


def refuse_countless(source: SourceText) -> None:
    """Raise SourceError, before *source* is parsed, for elements that no robot has as many of."""
    for tag, most in MOST.items():
        if source.text.count(f"<{tag}") <= most:
            continue
        written = re.finditer(rf"<{tag}(?=[\s/>])", source.text)
        excessive = next(islice(written, most, None), None)
        if excessive is not None:
            line, column = source.position(excessive.start())
            cause = f"more than {most} elements <{tag}>"
            raise SourceError(source.name, cause, line, column)


def tree(document: Term, statements: Iterable[Triple]) -> ColladaElement | None:
    """Return the root element of what *statements* say of *document*, with all below it.

    Raises Excess for what no robot is as large as.
    """
    top = ColladaElement(document, "", None, ElementType("", "", children=_roots()))
    known = {document: top}
    moves = Counter[Term]()
    for triple in statements:
        subject, predicate, value = triple
        element = known.get(subject)
        if element is None:
            continue
        if predicate.startswith(_TEXT):
            if predicate == f"{_TEXT}>":
                element.said[""] = triple
            else:
                element.components.append(triple)
        elif predicate == _WORDS:
            element.words = int(literal_value(value))
        elif predicate.startswith(_AT):
            element.said.setdefault(predicate[len(_AT) : -1], triple)
        elif is_iri(value) and (tag := _tag(predicate)):
            type_ = element.type.children.get(tag, ANY)
            child = known[value] = ColladaElement(value, tag.rpartition(":")[2], element, type_)
            element.children.append(child)
            if child.tag in _TRANSFORMS:
                moves[subject] += 1
                if moves[subject] > MOST_TRANSFORMS:
                    cause = f"<{element.tag}> has more than {MOST_TRANSFORMS} transforms"
                    raise Excess(value, cause)
    return top.first("COLLADA")


def _roots() -> dict[str, ElementType]:
    return schema(COLLADA.name).roots


def _tag(predicate: Term) -> str:
    """Return the tag of the elements that *predicate* leads to; empty if it leads to none."""
    for namespace in _NAMESPACES:
        if predicate.startswith(namespace):
            return predicate[len(namespace) : -1]
    return ""


_NAMESPACES: Sequence[str] = (f"<{NAMESPACE}", f"<{EXTENSION}")
