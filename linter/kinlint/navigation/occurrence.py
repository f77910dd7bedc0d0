"""A place where something is named."""

from __future__ import annotations

from enum import Enum, auto
from typing import NamedTuple, TypeAlias

from kinlint.terms import Term
from kinlint.text import Location

Entity: TypeAlias = Term
"""Named thing: a term of the graph or, for what no graph has, its kind and its origin.

Such are the macros, properties and arguments of xacro (`macro:`, `property:`, `argument:`), and
default classes of MJCF.
"""
CLASS = "class"
"""Kind of default classes."""


class Role(Enum):
    """Relation of a place to the entity that it names."""

    DESCRIPTION = auto()
    """It says what the entity is."""
    REFERENCE = auto()
    """It speaks of the entity in saying something of another, or repeats its name."""


class Occurrence(NamedTuple):
    """`entity` is named at `location`."""

    location: Location
    """Place of the name."""
    entity: Entity
    """Entity that is named."""
    role: Role
    """Role of the name there."""
