"""The `xacro` package, some of whose names stand for ours for the time of one expansion."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from types import ModuleType
from typing import Any
from xml.dom import minidom

from kinlint.formats.xacro.dom import Element
from kinlint.formats.xacro.expansion import Failure
from kinlint.light_dataclasses import dataclass


def xacro_package() -> ModuleType:
    """Return the package, which is kept from changing how others write XML."""
    before = minidom.Element.writexml
    try:
        import xacro  # noqa: PLC0415  few files are xacro

        module: ModuleType = xacro
        return module
    finally:
        minidom.Element.writexml = before  # type: ignore[method-assign]


@contextmanager
def replaced(module: ModuleType, values: Mapping[str, Any]) -> Iterator[None]:
    """Replace the values of names in *module* by *values* within the block."""
    before = {name: getattr(module, name) for name in values}
    vars(module).update(values)
    try:
        yield
    finally:
        vars(module).update(before)


def reqd_attrs(tag: Element, names: list[str]) -> list[str]:
    """Return the values of the attributes *names*, all of which *tag* must have."""
    for name in names:
        if not tag.hasAttribute(name):
            raise Failure(f"element '{tag.nodeName}' lacks the attribute '{name}'")
    return [tag.getAttribute(name) for name in names]


@dataclass
class Included:
    """Part of a document's interface that xacro uses."""

    documentElement: Element | None  # noqa: N815
    """The outermost element."""
