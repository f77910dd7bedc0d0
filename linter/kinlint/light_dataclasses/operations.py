"""Functions on dataclasses, as the standard library has them."""

from __future__ import annotations

from typing import Any

from kinlint.light_dataclasses.fields import Field, known_fields


def fields(given: object) -> tuple[Field, ...]:
    """Return the fields of *given*, a dataclass or an instance of one."""
    return tuple(known_fields(given).values())


def is_dataclass(given: object) -> bool:
    """Tell whether *given* is a dataclass or an instance of one."""
    try:
        known_fields(given)
    except TypeError:
        return False
    return True


def replace(given: Any, /, **changes: Any) -> Any:
    """Return *given* with *changes* to its fields."""
    for name, one in known_fields(given).items():
        if one.init and name not in changes:
            changes[name] = getattr(given, name)
    return given.__class__(**changes)


def asdict(given: Any) -> dict[str, Any]:
    """Return the fields of *given* by name, and those of dataclasses in them."""
    import dataclasses  # noqa: PLC0415  imports `inspect`; runs that lint do without

    return dataclasses.asdict(given)


def astuple(given: Any) -> tuple[Any, ...]:
    """Return the values of the fields of *given*, and of those of dataclasses in them."""
    import dataclasses  # noqa: PLC0415  imports `inspect`; runs that lint do without

    return dataclasses.astuple(given)
