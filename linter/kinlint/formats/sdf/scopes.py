"""Scopes of names in SDF, and the elements that names refer to."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from functools import cache

from kinlint.formats.sdf.format import SDF
from kinlint.formats.sdf.sdf_elements import SdfElement
from kinlint.formats.xml.schema import schema
from kinlint.light_dataclasses import dataclass, field

MODEL, WORLD = "__model__", "world"
SEPARATOR = "::"


@cache
def known_by_name(tag: str) -> frozenset[str]:
    """Return the tags of what others refer to by name in an element with *tag*.

    A world is not among them: names that are not its own do not lead out of one.
    """
    types = [type_ for same in schema(SDF.name).types.values() for type_ in same]
    named = {end for each in types for ref in each.references.values() for _, end in ref.targets}
    scopes = (each.scope for each in types if each.tag == tag)
    return frozenset(name for scope in scopes for name in scope if name in named - {WORLD})


@dataclass(eq=False)
class SdfScope:
    """Names of one world or model, with those of models that are merged into it."""

    element: SdfElement
    """The world or model."""
    outer: SdfScope | None = None
    """Enclosing scope."""
    names: dict[str, SdfElement] = field(default_factory=dict)
    """Elements by name."""
    unread: set[str | None] = field(default_factory=set)
    """Names of included models from files that cannot be read; None stands for one whose name is in
    the file."""


@dataclass(frozen=True)
class UnknownName:
    """A name that stands for nothing."""

    certain: bool
    """True if no unread file may define it."""
    known: Mapping[str, SdfElement]
    """The names that are known instead."""


@dataclass
class Scopes:
    """Scopes of a file."""

    world: SdfElement
    """The outermost element."""
    own: dict[SdfElement, SdfScope] = field(default_factory=dict)
    """Scope of the inside of each world and model."""
    enclosing: dict[SdfElement, SdfScope] = field(default_factory=dict)
    """Scope that each element is in."""
    included: dict[SdfElement, SdfElement] = field(default_factory=dict)
    """`include` that a model comes from."""
    models: list[SdfElement] = field(default_factory=list)
    """All models."""

    @classmethod
    def below(cls, root: SdfElement) -> Scopes:
        """Return the scopes of a whole file; *root* stands for the world if it has none."""
        scopes = cls(root)
        scopes._enter(root, SdfScope(root))
        for world in root.all("world"):
            scopes._enter(world, SdfScope(world))
        return scopes

    def _enter(self, element: SdfElement, scope: SdfScope) -> None:
        """Take in the names of *element* and of all models in it."""
        pending = [(element, scope)]
        while pending:
            at, inside = pending.pop()
            self.own.setdefault(at, inside)
            for child, name, merged in self._members(at, inside):
                self.enclosing[child] = inside
                if child.tag == "model":
                    self.models.append(child)
                    pending.append((child, inside if merged else SdfScope(child, inside)))
                if not merged:
                    inside.names.setdefault(name, child)

    def _members(self, at: SdfElement, scope: SdfScope) -> Iterator[tuple[SdfElement, str, bool]]:
        """Yield the frames of *at*, what they are called, and whether they are merged into it."""
        for child in at.children:
            if child.tag in known_by_name(at.tag):
                yield child, child.name, False
            elif child.tag == "include":
                merged = child.attributes.get("merge", "").lower() in ("true", "1")
                name = child.child_text("name")
                file = child.first("sdf")
                model = file.first("model") if file else None
                if model is not None:
                    self.included[model] = child
                    yield model, name or model.name, merged
                elif file is None:
                    scope.unread.add(None if merged else name or None)

    def find(self, name: str, user: SdfElement) -> SdfElement | UnknownName:
        """Return the element that *name* refers to where *user*, an element in a scope, uses it."""
        scope = self.enclosing[user]
        return self.look_up(name, scope, user.holder or scope.element)

    def look_up(self, name: str, scope: SdfScope, home: SdfElement) -> SdfElement | UnknownName:
        """Return the element that *name* refers to in *scope*, to an element in *home*."""
        if name == WORLD and name not in scope.names and scope.element.tag != "model":
            return scope.element
        return self._found(name, scope, home)

    def outermost(self, user: SdfElement) -> SdfElement:
        """Return the world that *user* is in."""
        scope = self.enclosing[user]
        while scope.outer is not None:
            scope = scope.outer
        return scope.element

    def find_inside(self, name: str, model: SdfElement) -> SdfElement | UnknownName:
        """Return the element that *name* refers to inside *model*."""
        return self._found(name, self.own[model], model)

    def _found(self, name: str, scope: SdfScope, home: SdfElement) -> SdfElement | UnknownName:
        while True:
            if name == MODEL and home.tag == "model":
                return home
            if name in scope.names:
                return scope.names[name]
            first, separator, rest = name.partition(SEPARATOR)
            model = scope.names.get(first)
            if not separator or model is None or model.tag != "model":
                certain = None not in scope.unread and first not in scope.unread
                return UnknownName(certain, scope.names)
            name, scope, home = rest, self.own[model], model
