"""The elements of an SDF file and of those that it includes, as far as names and poses matter."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from kinlint.light_dataclasses import dataclass, field
from kinlint.terms import Term, Triple, is_iri, literal_value
from kinlint.vocabulary import ATTRIBUTE, SDF, SRC

_CHILD, _AT, _TEXT = f"<{SDF}", f"<{ATTRIBUTE}", f"<{SRC}text"


@dataclass(eq=False, slots=True)
class SdfElement:
    """Element of SDF."""

    node: Term
    """Its node in the graph."""
    tag: str
    """Tag, without prefix."""
    parent: SdfElement | None
    """Element around it; None for the root."""
    order: int = 0
    """Number of elements before it in the file."""
    attributes: dict[str, str] = field(default_factory=dict)
    """Values of attributes by name."""
    children: list[SdfElement] = field(default_factory=list)
    """Child elements in their order."""
    text: str = ""
    """Text, with white space as written."""
    numbers: list[float] = field(default_factory=list)
    """Components of its text, if that is a vector."""

    @property
    def name(self) -> str:
        """Return its name, or an empty text."""
        return self.attributes.get("name", "")

    def all(self, tag: str) -> Iterator[SdfElement]:
        """Yield the children with *tag*."""
        return (each for each in self.children if each.tag == tag)

    def first(self, tag: str) -> SdfElement | None:
        """Return the first child with *tag*."""
        return next(self.all(tag), None)

    def child_text(self, tag: str) -> str:
        """Return the text of the first child with *tag*, or nothing."""
        found = self.first(tag)
        return found.text.strip() if found else ""

    def truth(self, tag: str) -> bool:
        """Tell whether the first child with *tag* is true."""
        return self.child_text(tag).lower() in ("true", "1")

    @property
    def holder(self) -> SdfElement | None:
        """The element that it stands in, whatever file that is in."""
        above = self.parent
        if above is not None and above.tag == "sdf" and above.parent is not None:
            include = above.parent
            return include.parent if include.tag == "include" else above
        return above

    @property
    def version(self) -> tuple[int, ...]:
        """The version of SDF that its file claims to be written in."""
        at = self
        while at.tag != "sdf" and at.parent is not None:
            at = at.parent
        parts = at.attributes.get("version", "").split(".")
        return tuple(int(part) for part in parts) if all(p.isdecimal() for p in parts) else ()


def tree(document: Term, statements: Iterable[Triple]) -> SdfElement | None:
    """Return the root element of what *statements* say of *document*, with all below it."""
    top = SdfElement(document, "", None)
    known = {document: top}
    for subject, predicate, value in statements:
        element = known.get(subject)
        if element is None:
            continue
        if predicate.startswith(_CHILD) and is_iri(value):
            child = known[value] = SdfElement(
                value, predicate[len(_CHILD) : -1], element, len(known)
            )
            element.children.append(child)
        elif predicate.startswith(_AT):
            element.attributes.setdefault(predicate[len(_AT) : -1], literal_value(value))
        elif predicate.startswith(_TEXT):
            if predicate == f"{_TEXT}>":
                element.text = literal_value(value)
            else:
                element.numbers.append(float(literal_value(value)))
    return top.first("sdf")
