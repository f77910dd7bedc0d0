"""Fields of dataclasses."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

MISSING: Any = object()
"""Stands for a default that there is not."""
FIELDS = "__dataclass_fields__"
"""Attribute by which the standard library knows a dataclass."""


class Field:
    """A field of a dataclass."""

    __slots__ = ("compare", "default", "default_factory", "init", "kw_only", "name", "repr")

    def __init__(
        self, default: Any, default_factory: Any = MISSING, *, init: bool = True, **flags: bool
    ) -> None:
        """Begin without a name; the *flags* `repr`, `compare` and `kw_only` are as usual."""
        self.name = ""
        self.default = default
        self.default_factory = default_factory
        self.init = init
        self.repr = flags.get("repr", True)
        self.compare = flags.get("compare", True)
        self.kw_only = flags.get("kw_only", False)

    @property
    def has_default(self) -> bool:
        """Tell whether the field has a value if none is given."""
        return not (self.default is MISSING and self.default_factory is MISSING)


class Fields:
    """The fields of a class by name; as an attribute of the class, what `dataclasses` expects."""

    def __init__(self, own: Mapping[str, Field]) -> None:
        self.own = own
        self._standard: Mapping[str, Any] = {}

    def __get__(self, instance: object, owner: type) -> Mapping[str, Any]:
        if not self._standard:
            self._standard = _standard(self.own)
        return self._standard


def known_fields(given: object) -> Mapping[str, Field]:
    """Return the fields of *given*, a dataclass or an instance of one. Raises `TypeError`."""
    for base in (given if isinstance(given, type) else type(given)).__mro__:
        if isinstance(found := base.__dict__.get(FIELDS), Fields):
            return found.own
    raise TypeError(f"{given!r} is no dataclass")


def _standard(own: Mapping[str, Field]) -> Mapping[str, Any]:
    """Return the fields *own* as the standard library has them."""
    import dataclasses  # noqa: PLC0415  imports `inspect`; runs that lint do without

    stated = []
    for name, one in own.items():
        more: dict[str, Any] = {"init": one.init, "repr": one.repr, "compare": one.compare}
        if one.default is not MISSING:
            more["default"] = one.default
        elif one.default_factory is not MISSING:
            more["default_factory"] = one.default_factory
        stated.append((name, object, dataclasses.field(kw_only=True, **more)))
    made: Any = dataclasses.make_dataclass("Fields", stated)
    found: Mapping[str, Any] = made.__dataclass_fields__
    return found
