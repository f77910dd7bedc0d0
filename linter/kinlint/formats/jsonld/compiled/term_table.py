"""Meanings of keys, types, IRIs and values under one active context, looked up once each."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from enum import Enum, auto
from functools import cached_property
from typing import Any, NamedTuple

from kinlint.terms import Term


class Declined(Exception):
    """PyLD has to expand this: something about it is told, or the compiled walk leaves it out."""


class NoWord(Exception):
    """A value that is no string was looked up as one."""


class Kind(Enum):
    """Kind of a key of an object."""

    PROPERTY = auto()
    ID = auto()
    TYPE = auto()
    VALUE = auto()
    LANGUAGE = auto()
    LIST = auto()
    SET = auto()


class Lookup(dict[str, Any]):
    """A table that is filled by a function; Declined is raised for what it gives no meaning to."""

    __slots__ = ("_meaning",)

    def __init__(self, meaning: Callable[[str], Any]) -> None:
        super().__init__()
        self._meaning = meaning

    def __missing__(self, written: str) -> Any:
        if not isinstance(written, str):
            raise NoWord
        plain = str(written)
        meaning = self._meaning(plain)
        if meaning is None:
            raise Declined(f"'{plain}'")
        self[plain] = meaning
        return meaning


class Meaning:
    """Meaning of a key."""

    def __init__(self, kind: Kind, predicate: Term = "", *, listed: bool = False) -> None:
        self.kind = kind
        self.predicate = predicate
        """Its property; empty for keywords."""
        self.listed = listed
        """True if its arrays are lists."""
        self.words: Lookup
        """Terms of strings under it."""
        self.numbers: Lookup
        """Terms of numbers and truth values under it, by their Python spelling."""
        self.scoped: Callable[[], Scope]
        """Function that compiles `scope`."""

    @cached_property
    def scope(self) -> Scope:
        """Contexts of objects under it."""
        return self.scoped()


class Shape(NamedTuple):
    """Roles of the keys of a node, in their order."""

    naming: str | None
    """The key of its name."""
    typing: str | None
    """The key of its types."""
    members: tuple[tuple[Meaning, str], ...]
    """Properties and their keys."""


class TermTable:
    """Meanings at an object, given its contexts and those of its types."""

    def __init__(
        self,
        keys: Lookup,
        names: Iterable[str],
        types: Lookup,
        identifiers: Lookup,
        datatypes: Lookup,
    ) -> None:
        self.keys = keys
        """A `Meaning` for each key."""
        self._names = names
        self._types = types
        self.identifiers = identifiers
        """Terms of identifiers of nodes."""
        self.datatypes = datatypes
        """IRIs of the names of datatypes."""
        self.shapes: dict[tuple[str, ...], Shape] = {}
        """Shapes of nodes, by their keys."""

    @cached_property
    def classes(self) -> list[Term]:
        """Terms of the types of the object."""
        return [self._types[name] for name in self._names]

    def shape(self, keys: Iterable[str]) -> Shape:
        """Return the shape of a node with *keys*. Raises Declined if it has none."""
        naming = typing = None
        members: dict[Term, tuple[Meaning, str]] = {}
        for key in keys:
            meaning: Meaning = self.keys[key]
            if meaning.kind is Kind.PROPERTY and meaning.predicate not in members:
                members[meaning.predicate] = meaning, key
            elif meaning.kind is Kind.ID and naming is None:
                naming = key
            elif meaning.kind is Kind.TYPE and typing is None:
                typing = key
            else:
                raise Declined("a keyword, or two keys for one property")
        return Shape(naming, typing, tuple(members.values()))


class Scope:
    """Term tables of the objects in one place, by their types."""

    def __init__(
        self,
        aliases: tuple[str, ...],
        kinds: Lookup,
        compiled: Callable[[tuple[str, ...]], TermTable],
        unreverted: Callable[[], Scope] | None = None,
    ) -> None:
        self._aliases = aliases
        self._kinds = kinds
        self._compiled = compiled
        self._tables: dict[Any, TermTable] = {}
        self._unreverted = unreverted

    @cached_property
    def _inside(self) -> Scope | None:
        """The contexts of references and values, which the types around them hold for, too."""
        return self._unreverted() if self._unreverted else None

    def table(self, element: dict[str, Any]) -> TermTable:
        """Return the meanings at *element*. Raises Declined where they cannot be compiled."""
        if self._inside is not None and len(element) <= 2 and self._inside.keeps(element):  # noqa: PLR2004  as JSON-LD says
            return self._inside.table(element)
        types: Any = ()
        for key in self._aliases:
            if key in element:
                if types != ():
                    raise Declined("two keys for types")
                types = element[key]
        kind = type(types)
        if isinstance(types, list):
            types = tuple(types)
        elif kind is not tuple and not isinstance(types, str):
            raise Declined("a type that is no string")
        try:
            return self._tables[types]
        except KeyError:
            return self._add(types)
        except TypeError:
            raise Declined("a type that is no string") from None

    def _add(self, types: str | tuple[Any, ...]) -> TermTable:
        names = (types,) if isinstance(types, str) else types
        if not all(isinstance(name, str) for name in names):
            raise Declined("a type that is no string")
        plain = tuple(map(str, names))
        table = self._compiled(plain)
        self._tables[plain[0] if isinstance(types, str) else plain] = table
        return table

    def keeps(self, element: dict[str, Any]) -> bool:
        """Tell whether the contexts of the types around *element* hold in it (API 5.1.2, 7)."""
        kinds = [self._kinds[key] for key in element]
        return Kind.VALUE in kinds or kinds == [Kind.ID]
