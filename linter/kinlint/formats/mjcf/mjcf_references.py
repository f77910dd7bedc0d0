"""References by name in MJCF: one name space for each kind of element in a whole model."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from functools import cache

from kinlint.formats.mjcf.compiled_model import CompiledModel
from kinlint.formats.mjcf.default_classes import MAIN
from kinlint.formats.mjcf.format import MJCF
from kinlint.formats.mjcf.mjcf_elements import MjcfElement
from kinlint.formats.source_layer import src
from kinlint.formats.xml.element_types import Reference
from kinlint.formats.xml.references import NameUse, gap_of
from kinlint.formats.xml.schema import schema
from kinlint.light_dataclasses import dataclass, field
from kinlint.suggestion import LOOKED_UP, nearest
from kinlint.terms import Triple, iri, literal, literal_value
from kinlint.vocabulary import ATTRIBUTE, REFERENCE
from kinlint.vocabulary import MJCF as NAMESPACE

BY_TYPE = {"objname": "objtype", "refname": "reftype"}
"""Attributes with a name, and those that say of what kind it is."""
SAME_KIND = {"xbody": "body"}
CLASS = "default"
_AT = f"<{ATTRIBUTE}"
_IN_MODEL = frozenset(f"<{ATTRIBUTE}{name}>" for name in ("body", "frame"))
"""Attributes of what attaches a model, with names of that model."""
MAKERS = frozenset({"composite", "flexcomp"})
"""Elements of which the compiler makes others, with names of its own."""
MADE = frozenset({"body", "geom", "joint", "site", "tendon", "flex", "skin"})
"""The kinds of those."""
STEMS = frozenset({"mesh", "texture", "hfield"})
"""Kinds of what is called after its file without a name."""


@dataclass
class KnownNames:
    """The elements of one model by kind and name."""

    named: dict[str, dict[str, MjcfElement]] = field(default_factory=dict)
    """The first element of each name, by kind."""
    repeated: list[tuple[MjcfElement, MjcfElement]] = field(default_factory=list)
    """Elements with a name that another one of their kind has already, and that one."""

    @classmethod
    def from_model(cls, root: MjcfElement, model: CompiledModel) -> KnownNames:
        """Return the names of the file with *root*, and those of the copies in *model*."""
        known = cls()
        for each in root.below():
            kind = each.type.kind
            if kind:
                known.add_once(kind, _name(each), each)
            if each.tag == "worldbody":
                known.add("body", "world", each)
            elif each.tag == CLASS and each.parent is not None and each.parent.type.tag != CLASS:
                known.add(CLASS, MAIN, each)
        known._add_copies(model)
        return known

    def _add_copies(self, model: CompiledModel) -> None:
        """Add the names of what is replicated and attached."""
        for body in model.bodies:
            self.add("body", body.name, body.element)
            for part in (*body.joints, *body.parts):
                self.add(part.element.type.kind, part.name, part.element)
        for inner, prefix in dict.fromkeys(model.attached):
            for each in inner.below():
                if each.type.kind and _name(each):
                    self.add(each.type.kind, f"{prefix}{_name(each)}", each)

    def add_once(self, kind: str, name: str, element: MjcfElement) -> None:
        """Let *name* be that of *element*, or note that another one of its *kind* has it.

        The body of the world has its name, and the top default class may be there in parts.
        """
        self.add(kind, name, element)
        first = self.named.get(kind, {}).get(name, element)
        top = (kind, name) == (CLASS, MAIN) and not _is_default(element)
        if first is not element and first.tag != "worldbody" and not top:
            self.repeated.append((element, first))

    def add(self, kind: str, name: str, element: MjcfElement) -> None:
        """Let *name* be that of *element*, unless another one of its *kind* has it."""
        if name:
            self.named.setdefault(kind, {}).setdefault(name, element)

    def find(self, kinds: Sequence[str], name: str) -> MjcfElement | None:
        """Return the element that *name* refers to; None if there is none of these *kinds*."""
        found = (self.named.get(kind, {}).get(name) for kind in kinds)
        return next((each for each in found if each is not None), None)


def references(
    root: MjcfElement, known: KnownNames, model: CompiledModel, *, certain: bool
) -> Iterator[tuple[Triple, Triple]]:
    """Yield what leads from the elements below *root* to what they name, there or not.

    With each statement comes the one that has the name. What dangles is left out unless it is
    *certain* that all names are known; then what *model* cannot attach does, too. Beside an element
    of `MAKERS`, names of the kinds that it makes are not.
    """
    alike: dict[tuple[str, ...], str | None] = {}
    makers = any(each.tag in MAKERS for each in root.below())
    uncertain = MADE if makers else frozenset[str]()
    for element in root.below():
        # A class may name what only the files have that include it.
        is_certain = certain and not _is_default(element)
        for use, kinds in _uses(element):
            name = literal_value(use.value)
            source = use.element, use.place, use.value
            target = known.find(kinds, name)
            if target is not None:
                if use.element == element.node:  # Classes lead to what they name themselves.
                    yield (element.node, use.reference.predicate, target.node), source
            elif is_certain and uncertain.isdisjoint(kinds) and (name, *kinds) != (MAIN, CLASS):
                names = [each for kind in kinds for each in known.named.get(kind, ())]
                key = (name, *kinds)
                if key not in alike and len(alike) < LOOKED_UP:
                    alike[key] = nearest(name, names)
                for gap in _dangling(use, kinds[0], alike.get(key)):
                    yield gap, source
    for element, tag, parts in model.unmatched if certain else ():
        said = element.said[tag][0]
        use = NameUse(element.node, said[1], said[2], element.type.references[said[1]])
        for gap in _dangling(use, tag, nearest(literal_value(said[2]), parts)):
            yield gap, said


def _uses(element: MjcfElement) -> Iterator[tuple[NameUse, Sequence[str]]]:
    """Yield the names that *element* refers to others by, with the kinds that are meant."""
    elsewhere = _IN_MODEL if element.tag == "attach" and element.text("model") else frozenset()
    for place, reference in element.type.references.items():
        name = place[len(_AT) : -1]
        said = element.said.get(name) or element.inherited.get(name)
        if not said or place in elsewhere:
            continue
        if literal_value(said[0][2]):
            kinds = list(dict.fromkeys(_kinds()[tag] for _, tag in reference.targets))
            yield NameUse(said[0][0], place, said[0][2], reference), kinds
    for name, type_ in BY_TYPE.items():
        said = element.said.get(name)
        if said and literal_value(said[0][2]) and element.text(type_):
            kind = SAME_KIND.get(element.text(type_), element.text(type_))
            predicate = iri(f"{REFERENCE}{name}")
            target = Reference(predicate, ((NAMESPACE, kind),), False, False, False)  # noqa: FBT003
            yield NameUse(element.node, said[0][1], said[0][2], target), [kind]


def _is_default(element: MjcfElement) -> bool:
    return element.parent is not None and element.parent.type.tag == CLASS


@cache
def _kinds() -> Mapping[str, str]:
    """Return the kind of names of each tag."""
    found: dict[str, str] = {}
    for tag, types in schema(MJCF.name).types.items():
        for each in types:
            if each.kind:
                found.setdefault(tag, each.kind)
    return found


def _name(element: MjcfElement) -> str:
    if element.tag == CLASS:
        return element.text("class")
    if element.name or element.type.kind not in STEMS:
        return element.name
    file = element.text("file").replace("\\", "/").rpartition("/")[2]
    return file.rpartition(".")[0] or file


def _dangling(use: NameUse, kind: str, near: str | None) -> Iterator[Triple]:
    gap = gap_of(use)
    yield use.element, src("dangling"), gap
    yield gap, src("node"), use.element
    yield gap, src("property"), use.place
    yield gap, src("written"), use.value
    yield gap, src("role"), literal(use.place[len(_AT) : -1])
    yield gap, src("tag"), literal(kind)
    if near is not None:
        yield gap, src("resembles"), literal(near)
