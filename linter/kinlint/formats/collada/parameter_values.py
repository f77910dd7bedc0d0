"""Numbers that COLLADA has in an element itself, in a child of it, or by way of a parameter."""

from __future__ import annotations

from math import isfinite

from kinlint.formats.collada.addressing import Addressing
from kinlint.formats.collada.collada_elements import ColladaElement


def number_of(value: ColladaElement, addressing: Addressing) -> tuple[ColladaElement, float] | None:
    """Return the element whose text is the number of *value*, and the number; None if none is."""
    holder = _holder(value, addressing)
    number = _float(holder.text()) if holder is not None else None
    return None if holder is None or number is None else (holder, number)


def meant_by(named: ColladaElement, addressing: Addressing) -> ColladaElement | None:
    """Return what the text of *named*, a path or the name of a parameter, stands for in the end."""
    if named.tag == "SIDREF":
        found = addressing.by_path(named.text(), named)
    else:
        found = addressing.by_parameter(named.text() or named.text("ref"), named)
    return addressing.followed(found) if isinstance(found, ColladaElement) else None


def _holder(value: ColladaElement, addressing: Addressing) -> ColladaElement | None:
    if value.text():
        return value
    number = value.first("float")
    param = value.first("param")
    if number is not None or param is None:
        return number
    meant = meant_by(param, addressing)
    return meant.first("float") if meant is not None else None


def _float(written: str) -> float | None:
    try:
        value = float(written)
    except ValueError:
        return None
    return value if isfinite(value) else None
