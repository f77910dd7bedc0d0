"""Schemas of prims: what a prim of a type, with the schemas applied to it, may state.

The tables are `shapes/formats/usd-elements.ttl` and `usd.ttl`; they are loaded once in a process.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import cache

from kinlint import resources
from kinlint.light_dataclasses import dataclass, field, replace

TABLES = ("usd-elements.ttl", "usd.ttl")
INSTANCE = "*"
"""Stands for the name of the instance in the names of properties."""
ARRAY = "-array"
_WORDS = """
    abstract applied appliesTo choice deprecated extends includes instances names open refersByPath
    replaced tag type uniform unit
"""
WORDS = frozenset(_WORDS.split())
"""Properties of the tables that do not list properties of prims by the type of their values."""


@dataclass(frozen=True, slots=True)
class PropertyType:
    """Attribute or relationship that a schema defines."""

    name: str
    """Its name, with a * for the name of the instance."""
    type: str
    """Type of its values in the words of USD ("float3", "token[]"), or "rel" of a relationship."""
    schema: str
    """The schema that defines it."""
    choices: tuple[str, ...] = ()
    """Words that it may be; none if any."""
    unit: str = ""
    """"length", "degree", "mass" and so on; "" if it has none or it depends on the prim."""
    uniform: bool = False
    """True if it may not change with time."""
    reference: str = ""
    """IRI of the property of `ref:` that leads to the targets of a relationship."""
    targets: tuple[str, ...] = ()
    """Schemas of which each target has to have one; none if it may be any prim."""


@dataclass(frozen=True, slots=True)
class PrimSchema:
    """Schema that a prim has by its type, or by being applied to it."""

    name: str
    """Its name, without that of an instance."""
    applied: bool
    """True if it is applied, false if it is a type."""
    multiple: bool
    """True if it is applied as often as there are instances."""
    abstract: bool
    """True if no prim can be of the type."""
    open: bool
    """True if its properties are not known."""
    extends: str
    """The type that it extends; "" if none."""
    includes: tuple[str, ...]
    """Schemas that a prim with this one has, too."""
    applies_to: tuple[str, ...]
    """Types of the prims that it may be applied to; none if any."""
    instances: tuple[str, ...]
    """Names of instances that readers know; none if any."""
    replaced_by: str
    """The schema to be used instead of this one; "" if it is current."""
    unread: bool
    """True if readers no longer read it."""
    properties: dict[str, PropertyType] = field(default_factory=dict)
    """Properties that it defines itself, by name."""
    units: dict[str, str] = field(default_factory=dict)
    """Units of properties, by name, which may be that of one instance."""


@cache
def prim_schemas() -> dict[str, PrimSchema]:
    """Return all known schemas, by name."""
    nodes = _nodes()
    found = (_schema(entries, nodes) for entries in nodes.values())
    return {each.name: each for each in found if each is not None}


@cache
def base_types(name: str) -> tuple[str, ...]:
    """Return the type *name* and all that it extends; nothing if it is not known."""
    known = prim_schemas().get(name)
    return (name, *base_types(known.extends)) if known and not known.applied else ()


def expanded(names: Iterable[str]) -> tuple[str, ...]:
    """Return the applied schemas *names*, with instances, and those that they include."""
    found: dict[str, None] = {}
    queue = list(names)
    while queue:
        name = queue.pop(0)
        if name not in found:
            found[name] = None
            known = prim_schemas().get(name.partition(":")[0])
            queue += known.includes if known else ()
    return tuple(found)


@cache
def properties_of(type_: str, applied: tuple[str, ...]) -> dict[str, PropertyType]:
    """Return what a prim of *type_* may state, by name, with the schemas *applied* to it.

    These have the names of their instances, such as "PhysicsDriveAPI:angular".
    """
    known = prim_schemas()
    found: dict[str, PropertyType] = {}
    included: list[str] = []
    for name in reversed(base_types(type_)):
        found.update(known[name].properties)
        included += known[name].includes
    for schema, _, instance in (each.partition(":") for each in expanded((*included, *applied))):
        for name, property_ in known[schema].properties.items() if schema in known else ():
            own = name.replace(INSTANCE, instance)
            unit = known[schema].units.get(own, property_.unit)
            found[own] = property_ if unit == property_.unit else replace(property_, unit=unit)
    return found


@cache
def owners() -> dict[str, tuple[str, ...]]:
    """Return the schemas that define each property, by its name with a * for the instance."""
    found: dict[str, list[str]] = {}
    for schema in prim_schemas().values():
        for name in schema.properties:
            found.setdefault(name, []).append(schema.name)
    return {name: tuple(schemas) for name, schemas in found.items()}


def owners_of(name: str) -> tuple[tuple[str, ...], str]:
    """Return the schemas that define the property *name*, and the instance that it is of.

    `drive:angular:physics:damping` is defined by PhysicsDriveAPI, as its instance "angular".
    """
    if direct := owners().get(name):
        return direct, ""
    first, _, rest = name.partition(":")
    instance, _, last = rest.partition(":")
    return owners().get(f"{first}:{INSTANCE}:{last}", ()), instance


def _nodes() -> dict[str, dict[str, list[str]]]:
    """Return the statements of the tables, by subject and property."""
    import pyoxigraph as ox  # noqa: PLC0415  a native module

    nodes: dict[str, dict[str, list[str]]] = {}
    for table in TABLES:
        path = resources.data("shapes") / "formats" / table
        for quad in ox.parse(path=path, format=ox.RdfFormat.TURTLE, base_iri="urn:usd"):
            name = quad.predicate.value.rpartition("#")[2]
            nodes.setdefault(quad.subject.value, {}).setdefault(name, []).append(quad.object.value)
    return nodes


def _schema(
    entries: dict[str, list[str]], nodes: dict[str, dict[str, list[str]]]
) -> PrimSchema | None:
    """Return the schema with the statements *entries*; None if they are about parts of a layer.

    Names of schemas begin with a capital letter, tags of parts do not.
    """
    name, manner = (next(iter(entries.get(word, ())), "") for word in ("tag", "applied"))
    if not name[:1].isupper():
        return None
    extends, old, older = (
        next(iter(entries.get(word, ())), "") for word in ("extends", "deprecated", "replaced")
    )
    return PrimSchema(
        name,
        applied=bool(manner),
        multiple=manner == "multiple",
        abstract="true" in entries.get("abstract", ()),
        open="true" in entries.get("open", ()),
        extends=_local(extends),
        includes=tuple(map(_local, entries.get("includes", ()))),
        applies_to=tuple(map(_local, entries.get("appliesTo", ()))),
        instances=tuple(entries.get("instances", ())),
        replaced_by=old or older,
        unread=bool(older),
        properties={each.name: each for each in _properties(name, entries, nodes)},
        units=_units(entries, nodes),
    )


def _units(entries: dict[str, list[str]], nodes: dict[str, dict[str, list[str]]]) -> dict[str, str]:
    lists = (list(_list(head, nodes)) for head in entries.get("unit", ()))
    return {name: unit for unit, *names in lists for name in names}


def _properties(
    schema: str, entries: dict[str, list[str]], nodes: dict[str, dict[str, list[str]]]
) -> Iterator[PropertyType]:
    choices, references = (
        [list(_list(head, nodes)) for head in entries.get(word, ())]
        for word in ("choice", "refersByPath")
    )
    words = {name: tuple(choice) for name, *choice in choices}
    unit_of = _units(entries, nodes)
    leads = {name: (predicate, targets) for predicate, name, *targets in references}
    uniform = set(entries.get("uniform", ()))
    for type_, names in entries.items():
        for name in names if type_ not in WORDS else ():
            reference, targets = leads.get(name, ("", ()))
            yield PropertyType(
                name,
                type_.replace(ARRAY, "[]"),
                schema,
                words.get(name, ()),
                unit_of.get(name, ""),
                uniform=name in uniform,
                reference=reference,
                targets=tuple(map(_local, targets)),
            )


def _list(head: str, nodes: dict[str, dict[str, list[str]]]) -> Iterator[str]:
    """Yield the members of the RDF list *head*."""
    while head in nodes:
        (first,), (head,) = nodes[head]["first"], nodes[head]["rest"]
        yield first


def _local(iri: str) -> str:
    return iri.rpartition("#")[2]
