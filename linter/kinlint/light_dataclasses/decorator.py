"""The decorator `dataclass`, which compiles nothing but `__init__`, and that of busy classes only.

A run that lints makes some 130 dataclasses. The standard library compiles up to six methods for
each, which took a fifth of a run on a small file, and imports `inspect`. Here the other methods are
shared, and the first instances are made without compiling anything. That instances of frozen
classes do not change is left to type checkers.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from operator import attrgetter
from reprlib import recursive_repr
from typing import Any

from kinlint.light_dataclasses.fields import FIELDS, MISSING, Field, Fields, known_fields

CLASS_VARIABLE = ("ClassVar", "typing.ClassVar")
"""The beginnings of annotations of what is no field."""
UNCOMPILED = 8
"""Number of instances of a class that take less time than to compile its `__init__`."""


def field(
    *, default: Any = MISSING, default_factory: Any = MISSING, init: bool = True, **flags: bool
) -> Any:
    """Return what `dataclasses.field` would, for the flags `repr`, `compare` and `kw_only`."""
    return Field(default, default_factory, init=init, **flags)


def dataclass(cls: Any = None, /, **flags: bool) -> Any:
    """Do what `dataclasses.dataclass` does, for the flags `frozen`, `slots` and `eq`."""
    return _dataclass(cls, **flags) if cls is not None else lambda own: _dataclass(own, **flags)


def _dataclass(cls: Any, *, frozen: bool = False, slots: bool = False, eq: bool = True) -> Any:
    found: dict[str, Field] = {}
    for base in reversed(cls.__mro__[1:]):
        found |= base.__dict__[FIELDS].own if FIELDS in base.__dict__ else {}
    own = [name for name, kind in cls.__annotations__.items() if not _is_class_variable(kind)]
    found |= {name: _stated_field(cls, name) for name in own}
    if slots:
        cls = _with_slots(cls, own)
    setattr(cls, FIELDS, Fields(found))
    for name, method in _methods(cls, found, frozen=frozen, eq=eq).items():
        if cls.__dict__.get(name) is None:
            setattr(cls, name, method)
    return cls


def _is_class_variable(kind: Any) -> bool:
    return isinstance(kind, str) and kind.startswith(CLASS_VARIABLE)


def _stated_field(cls: Any, name: str) -> Field:
    """Return the field *name* of *cls*, to which no more than the default is left of it."""
    given = cls.__dict__.get(name, MISSING)
    if not isinstance(given, Field):
        given = Field(given)
    elif given.default is MISSING:
        delattr(cls, name)
    else:
        setattr(cls, name, given.default)
    given.name = name
    return given


def _with_slots(cls: Any, names: list[str]) -> Any:
    """Return *cls* made anew with slots for the fields *names*."""
    left_out = {*names, "__dict__", "__weakref__"}
    values = {name: value for name, value in cls.__dict__.items() if name not in left_out}
    made = type(cls)(cls.__name__, cls.__bases__, {**values, "__slots__": tuple(names)})
    made.__qualname__ = cls.__qualname__
    return made


def _methods(
    cls: Any, found: Mapping[str, Field], *, frozen: bool, eq: bool
) -> Mapping[str, object]:
    """Return what *cls* with the fields *found* has unless it defines it."""
    positional = (one.name for one in found.values() if one.init and not one.kw_only)
    methods: dict[str, object] = {
        "__init__": _first_init(cls, found),
        "__repr__": _repr,
        "__match_args__": tuple(positional),
    }
    if not eq:
        return methods
    compared = [one.name for one in found.values() if one.compare]
    values: Callable[[Any], Any] = attrgetter(*compared) if compared else _nothing

    def equal(self: Any, other: object) -> Any:
        return (
            values(self) == values(other) if other.__class__ is self.__class__ else NotImplemented
        )

    def hashed(self: Any) -> int:
        return hash(values(self))

    return methods | {"__eq__": equal, "__hash__": hashed if frozen else None}


def _nothing(_instance: object) -> tuple[()]:
    return ()


@recursive_repr()
def _repr(self: Any) -> str:
    shown = (one.name for one in known_fields(self).values() if one.repr)
    told = ", ".join(f"{name}={getattr(self, name)!r}" for name in shown)
    return f"{type(self).__qualname__}({told})"


def _first_init(cls: Any, found: Mapping[str, Field]) -> Callable[..., None]:
    """Return an `__init__` that makes a few instances, then compiles the one of *cls*.

    The compiled one takes its place, and is called for arguments that do not fit, too.
    """
    stated = [one for one in found.values() if one.init or one.has_default]
    positional = [one.name for one in stated if one.init and not one.kw_only]
    taken = {one.name for one in stated if one.init}
    left = UNCOMPILED

    def first(self: Any, *args: Any, **named: Any) -> None:
        nonlocal left
        left -= 1
        given = dict(zip(positional, args, strict=False))
        fitting = len(args) <= len(positional) and given.keys().isdisjoint(named)
        given |= named
        if left >= 0 and fitting and given.keys() <= taken and _filled(self, stated, given):
            if hasattr(cls, "__post_init__"):
                self.__post_init__()
            return
        init = _compiled_init(cls, found)
        if cls.__init__ is first:
            cls.__init__ = init
        init(self, *args, **named)

    return first


def _filled(self: Any, stated: Iterable[Field], given: Mapping[str, Any]) -> bool:
    """Set the fields *stated* to what is *given*, else their defaults; False if one has neither."""
    for one in stated:
        value = given.get(one.name, MISSING)
        if value is MISSING:
            make = one.default_factory
            value = one.default if make is MISSING else make()
            if value is MISSING:
                return False
        setattr(self, one.name, value)
    return True


def _compiled_init(cls: Any, found: Mapping[str, Field]) -> Callable[..., None]:
    """Return `__init__` of *cls*, whose parameters are the fields *found*."""
    scope: dict[str, Any] = {"MISSING": MISSING}
    positional, keyword, body = ["self"], list[str](), list[str]()
    for one in found.values():
        if not (one.init or one.has_default):
            continue
        parameter, value = _parameter(one, scope)
        if one.init:
            (keyword if one.kw_only else positional).append(parameter)
        body.append(f"self.{one.name} = {value}")
    if hasattr(cls, "__post_init__"):
        body.append("self.__post_init__()")
    parameters = ", ".join([*positional, *(["*", *keyword] if keyword else [])])
    lines = [f"def __init__({parameters}):", *(body or ["pass"])]
    exec("\n    ".join(lines), scope)  # noqa: S102  made of names of fields
    init: Callable[..., None] = scope["__init__"]
    return init


def _parameter(one: Field, scope: dict[str, Any]) -> tuple[str, str]:
    """Return the parameter and the value of *one*, whose default goes into *scope*."""
    name = one.name
    if one.default_factory is not MISSING:
        scope[f"make_{name}"] = one.default_factory
        made = f"make_{name}()"
        return f"{name}=MISSING", f"{made} if {name} is MISSING else {name}" if one.init else made
    if one.default is MISSING:
        return name, name
    scope[f"default_{name}"] = one.default
    return f"{name}=default_{name}", name if one.init else f"default_{name}"
