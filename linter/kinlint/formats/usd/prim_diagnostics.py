"""Deviations of a layer from the schemas of its prims, as statements without judgement.

What a prim has in all is not told by one layer: of an `over`, and of a prim to which references,
inherited classes or weaker layers contribute, only names and words that no schema has are stated.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from functools import cache
from typing import TypeAlias

from kinlint.formats.source_layer import SourceLayer
from kinlint.formats.usd.layer_opinions import Opinions, specs
from kinlint.formats.usd.prim_schemas import (
    PropertyType,
    base_types,
    expanded,
    owners,
    owners_of,
    prim_schemas,
    properties_of,
)
from kinlint.formats.usd.schema_resemblance import (
    LONGEST_WORD,
    resembling_property,
    resembling_schema,
)
from kinlint.formats.usd.usda_syntax import Prim, Property
from kinlint.formats.usd.value_types import value_type
from kinlint.light_dataclasses import dataclass
from kinlint.suggestion import nearest
from kinlint.terms import XSD, Term, iri, literal
from kinlint.text import Span
from kinlint.vocabulary import ATTRIBUTE

Detail: TypeAlias = str | bool | None
OPEN_NAMESPACES = (
    "primvars:", "userProperties:", "inputs:", "outputs:", "info:", "omni:", "material:",
    "xformOp:",
)  # fmt: skip
"""Beginnings of the names of properties that no schema has to list."""
CONSTANT = ("physics:", "drive:", "limit:")
"""Beginnings of the names of properties that readers read at one time only."""
UP_AXES = ("Y", "Z")
MOST_EXPLAINED = 200
"""Most schemas of a prim with which one that is not known is compared."""
WORD_TYPES = frozenset({"asset", "group", "opaque", "pathExpression", "string", "token"})
"""Types whose values are words."""
TYPES = (
    *sorted(WORD_TYPES),
    "bool",
    "double",
    "float",
    "int",
    "float3",
    "double3",
    "point3f",
    "quatf",
)
"""Types that one that is not known is compared with."""


def state_deviations(
    root: Prim, node_of: Mapping[Prim, Term], opinions: Mapping[str, Opinions], layer: SourceLayer
) -> None:
    """State where the layer *root*, whose prims have the nodes *node_of*, departs from schemas."""
    whole = _Check(root, node_of[root], Opinions("", (), whole=True), layer)
    axis = root.field("upAxis")
    if axis is not None:
        whole.state_choice("upAxis", axis.value.text, axis.value.content, UP_AXES)
    for path, prim in specs(root):
        _Check(prim, node_of[prim], opinions[path], layer).state()


@dataclass(frozen=True, slots=True)
class _Check:
    """Comparison of *prim*, an opinion about the prim with all *opinions*, with schemas."""

    prim: Prim
    """The opinion."""
    node: Term
    """Its node."""
    opinions: Opinions
    """Opinions of the whole layer about the prim."""
    layer: SourceLayer
    """Layer of statements that the deviations are added to."""

    def state(self) -> None:
        """State all deviations."""
        self._state_type()
        self._state_applied()
        known = properties_of(self.opinions.type_name, self.opinions.applied)
        for each in self.prim.properties:
            if not each.is_relationship and not _is_type(each.type_name):
                like = nearest(each.type_name, TYPES)
                types = {"written": each.type_name, "resembles": like}
                self._note("UnknownValueType", each.type_span, attribute=each.name, **types)
                continue
            found = known.get(_listed_as(each.name))
            if found is None:
                self._state_unlisted(each, known)
            else:
                self._state_listed(each, found)

    def _note(self, kind: str, span: Span | None, **details: Detail) -> None:
        """State a deviation of *kind* at *span*, with words, truths or IRIs as its *details*."""
        said = ((name, _term(value)) for name, value in details.items())
        place = span or self.prim.name_span
        self.layer.add_node(kind, place, ("node", self.node), *said)

    def _state_type(self) -> None:
        name = self.prim.type_name
        schema = prim_schemas().get(name)
        if not name or (schema is not None and not schema.applied and not schema.abstract):
            return
        like = resembling_schema(name, applied=False)
        self._note("UnknownSchema", self.prim.type_span, written=name, resembles=like, role="type")

    def _state_applied(self) -> None:
        for given in self.prim.metadata:
            if given.name == "apiSchemas" and given.operation != "delete":
                for item in given.value.scalars():
                    if item.kind == "string":
                        self._state_use(item.text, item.content)

    def _state_use(self, written: str, span: Span) -> None:
        """State how the schema *written*, with its instance, is not known or does not fit."""
        name, _, instance = written.partition(":")
        schema = prim_schemas().get(name)
        if schema is None or not schema.applied:
            few = len(self.opinions.applied) <= MOST_EXPLAINED
            like = resembling_schema(name, applied=True) if few else None
            self._note("UnknownSchema", span, written=name, resembles=like, role="applied")
            return
        if schema.multiple is not bool(instance):
            self._note("WrongInstance", span, schema=name, instance=instance)
        elif schema.instances and instance not in schema.instances:
            like = nearest(instance, schema.instances)
            known = ", ".join(schema.instances)
            details: dict[str, Detail] = {"instance": instance, "resembles": like, "choices": known}
            self._note("WrongInstance", span, schema=name, **details)
        if schema.applies_to and self._is_misapplied(schema.applies_to):
            fitting: dict[str, Detail] = {"expected": " or ".join(schema.applies_to)}
            type_ = self.opinions.type_name
            self._note("MisappliedSchema", span, schema=name, primType=type_, **fitting)
        if schema.replaced_by:
            successor = schema.replaced_by
            still = not schema.unread
            self._note("ReplacedSchema", span, schema=name, successor=successor, stillRead=still)

    def _is_misapplied(self, ends: tuple[str, ...]) -> bool:
        """Tell whether the prim is known to have none of the types and schemas *ends*."""
        bases = base_types(self.opinions.type_name)
        if not bases or set(bases) & set(ends):
            return False
        schemas = prim_schemas()
        if not any(schemas[each].applied for each in ends):
            return True
        if self._is_open():
            return False
        applied = {each.partition(":")[0] for each in expanded(self.opinions.applied)}
        return self.opinions.whole and not applied & set(ends)

    def _state_listed(self, given: Property, known: PropertyType) -> None:
        """State how a property does not fit what is *known* of it."""
        if given.suffix == "connect":
            return
        name, value = given.name, given.value
        if given.is_relationship or known.type == "rel":
            if given.type_name != known.type:
                types = {"written": given.type_name, "expected": known.type}
                self._note("MistypedAttribute", given.type_span, attribute=name, **types)
            return
        if given.type_name not in _expected_types(name, known.type):
            types = {"written": given.type_name, "expected": known.type}
            self._note("MistypedAttribute", given.type_span, attribute=name, **types)
        if known.choices and value is not None and value.kind == "string":
            self.state_choice(name, value.text, value.content, known.choices)
        if given.suffix in ("timeSamples", "spline") and name.startswith(CONSTANT):
            self._note("SampledConstant", given.name_span, attribute=name)

    def state_choice(self, name: str, said: str, span: Span, known: tuple[str, ...]) -> None:
        """State that *said*, the value of the property *name*, is none of *known*, if so."""
        if said not in known:
            like = next((each for each in known if each.lower() == said.lower()), None)
            words = {"written": said, "choices": ", ".join(known), "resembles": like}
            place = iri(ATTRIBUTE + name)
            self._note("UnknownChoice", span, property=place, tag=name, **words)

    def _state_unlisted(self, given: Property, known: Mapping[str, PropertyType]) -> None:
        """State a property that is not *known* of the prim, if it looks as if it should be."""
        name, type_ = given.name, self.opinions.type_name
        if name.startswith(OPEN_NAMESPACES) or given.suffix == "connect" or self._is_open():
            return
        owning, instance = owners_of(_listed_as(name))
        if owning:
            if self.opinions.whole and type_ and ":" in name:
                schema = _applicable(owning, instance, type_)
                applied = prim_schemas()[schema.partition(":")[0]].applied
                about: dict[str, Detail] = {"schema": schema, "tag": type_, "applicable": applied}
                self._note("UnappliedProperty", given.name_span, attribute=name, **about)
            return
        if given.custom or len(name) > LONGEST_WORD:
            return
        like = resembling_property(name, frozenset(known))
        if like is not None or (":" in name and name.partition(":")[0] in _namespaces()):
            details: dict[str, Detail] = {"tag": type_ or "prim", "resembles": like}
            self._note("UndeclaredAttribute", given.name_span, attribute=name, **details)

    def _is_open(self) -> bool:
        """Tell whether one of the schemas of the prim has properties that are not known."""
        schemas = prim_schemas()
        applied = (each.partition(":")[0] for each in self.opinions.applied)
        names = filter(None, (self.opinions.type_name, *applied))
        return any(name not in schemas or schemas[name].open for name in names)


def _term(value: Detail) -> Term | None:
    """Return *value* as a term; an IRI in brackets is one."""
    if isinstance(value, bool):
        return literal(str(value).lower(), f"{XSD}boolean")
    return value if value is None or value.startswith("<") else literal(value)


def _applicable(owning: Iterable[str], instance: str, type_: str) -> str:
    """Return the first of the schemas *owning* a property that a prim of *type_* may have."""
    schemas = prim_schemas()
    bases = set(base_types(type_))
    fitting = [
        each
        for each in owning
        if not schemas[each].applies_to or bases & set(schemas[each].applies_to)
    ]
    name = next(iter(fitting or owning))
    return f"{name}:{instance}" if instance else name


def _expected_types(name: str, type_: str) -> tuple[str, ...]:
    """Return the types that values of the property *name* may have, if *type_* is listed."""
    if name.startswith("xformOp:"):
        stem = type_.rstrip("dfh")
        if stem == "quat":
            return "quatd", "quatf", "quath"
        if type_.startswith("double"):
            size = type_.removeprefix("double")
            return f"double{size}", f"float{size}", f"half{size}"
    return (type_,)


def _is_type(name: str) -> bool:
    """Tell whether attributes may have values of the type called *name*."""
    base = name.removesuffix("[]")
    return base in WORD_TYPES or value_type(base) is not None or "::" in name


@cache
def _namespaces() -> frozenset[str]:
    """Return the first parts of the names of all properties that have several."""
    return frozenset(each.partition(":")[0] for each in owners() if ":" in each)


def _listed_as(name: str) -> str:
    """Return the name by which schemas list *name*: that of an operation may have a suffix."""
    return ":".join(name.split(":", 2)[:2]) if name.startswith("xformOp:") else name
