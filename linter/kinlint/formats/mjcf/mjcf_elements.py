"""The elements of an MJCF file and of those that it includes, with the values of attributes."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from functools import lru_cache

from kinlint.formats.mjcf.format import MJCF
from kinlint.formats.xml.element_types import ANY, ElementType
from kinlint.formats.xml.schema import schema
from kinlint.light_dataclasses import dataclass, field
from kinlint.terms import Term, Triple, is_iri, literal_value
from kinlint.vocabulary import ATTRIBUTE
from kinlint.vocabulary import MJCF as NAMESPACE

_CHILD, _AT = f"<{NAMESPACE}", f"<{ATTRIBUTE}"
INCLUDE = "include"


@dataclass(eq=False, slots=True)
class MjcfElement:
    """Element of MJCF."""

    node: Term
    """Its node in the graph."""
    tag: str
    """Tag."""
    parent: MjcfElement | None
    """Element around it; None for the document."""
    type: ElementType
    """Type of elements at its place."""
    said: dict[str, list[Triple]] = field(default_factory=dict)
    """The statements of each attribute by its name, one for each number."""
    children: list[MjcfElement] = field(default_factory=list)
    """Child elements in their order."""
    inherited: Mapping[str, list[Triple]] = field(default_factory=dict)
    """The statements, of a default class, of attributes that it does not say itself."""
    class_name: str = ""
    """The default class that it takes; empty if elements of its kind take none."""

    @property
    def name(self) -> str:
        """Return its name, or an empty text."""
        return self.text("name")

    def text(self, attribute: str) -> str:
        """Return the text of *attribute*, of a default class if need be; empty if none is known."""
        said = self.said.get(attribute) or self.inherited.get(attribute)
        return literal_value(said[0][2]) if said else ""

    def number(self, attribute: str, default: float = 0.0) -> float:
        """Return the first number of *attribute*, or its *default*."""
        return next(iter(self.numbers(attribute)), default)

    def numbers(self, attribute: str) -> list[float]:
        """Return the numbers of *attribute*, like `text`; none where one is malformed."""
        said = self.said.get(attribute) or self.inherited.get(attribute)
        if not said:
            return []
        try:
            return [float(literal_value(value)) for _, _, value in said]
        except ValueError:
            return []

    def content(self) -> Iterator[MjcfElement]:
        """Yield the children, in place of includes what the included files say there."""
        pending = [*reversed(self.children)]
        while pending:
            at = pending.pop()
            if at.tag == INCLUDE:
                pending += (each for root in reversed(at.children) for each in root.children[::-1])
            else:
                yield at

    def all(self, *tags: str) -> Iterator[MjcfElement]:
        """Yield the children with one of *tags*, those in included files too."""
        return (each for each in self.content() if each.tag in tags)

    def below(self) -> Iterator[MjcfElement]:
        """Yield all elements below, each before what is in it, but for models to be attached."""
        pending = self.children[::-1] if self.tag != "model" else []
        while pending:
            at = pending.pop()
            if at.tag == INCLUDE:
                pending += (each for root in reversed(at.children) for each in root.children[::-1])
                continue
            yield at
            if at.tag != "model":
                pending += at.children[::-1]


def tree(document: Term, statements: Iterable[Triple]) -> MjcfElement | None:
    """Return the root element of what *statements* say of *document*, with all below it."""
    table = schema(MJCF.name)
    around = ElementType("", "", children=table.roots)
    top = MjcfElement(document, "", None, around)
    known = {document: top}
    for triple in statements:
        subject, predicate, value = triple
        element = known.get(subject)
        if element is None:
            continue
        attribute, tag = _meaning(predicate)
        if attribute:
            if (said := element.said.get(attribute)) is None:
                element.said[attribute] = [triple]
            else:
                said.append(triple)
        elif tag and is_iri(value):
            child = known[value] = MjcfElement(value, tag, element, _type(element, tag))
            element.children.append(child)
    return next((each for each in top.children if each.tag in table.roots), None)


@lru_cache(maxsize=4096)
def _meaning(predicate: Term) -> tuple[str, str]:
    """Return the attribute, or else the tag, that *predicate* stands for; empty if neither."""
    if predicate.startswith(_AT):
        return predicate[len(_AT) : -1].partition("-")[0], ""
    return "", predicate[len(_CHILD) : -1] if predicate.startswith(_CHILD) else ""


def _type(above: MjcfElement, tag: str) -> ElementType:
    """Return the type of the child of *above* with *tag*: in an include, that around it."""
    if above.tag == INCLUDE and above.parent is not None:
        return above.parent.type
    if above.tag == "model":
        return schema(MJCF.name).roots.get(tag, ANY)
    return above.type.children.get(tag, ANY)


def root_types(around: ElementType) -> dict[str, ElementType]:
    """Return the types of the root of a file whose content stands in an element of *around*."""
    found = {}
    for tag, root in schema(MJCF.name).roots.items():
        found[tag] = ElementType(
            tag, root.predicate, dict(root.attributes), around.children, checked=False
        )
    return found
