"""Default classes: the values that elements take from them.

A class says what the class around it says, but for what it says itself. An element takes the class
that it names, else the nearest `childclass` of a body or frame around it, else the top class.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping, Sequence
from typing import TypeAlias

from kinlint.formats.mjcf.mjcf_elements import MjcfElement
from kinlint.light_dataclasses import dataclass, field
from kinlint.terms import Triple

Values: TypeAlias = Mapping[str, list[Triple]]
"""Statements of attributes by name."""
MAIN = "main"
ORIENTATIONS = frozenset({"quat", "axisangle", "euler", "xyaxes", "zaxis"})
OF_BODIES = frozenset({"joint", "geom", "site", "camera", "light"})
OF_ASSETS = frozenset({"mesh", "texture", "material"})
PLACES = frozenset({"worldbody", "body", "frame", "replicate", "mujocoinclude"})
ACTUATORS = (
    "general", "motor", "position", "velocity", "intvelocity", "orientation", "pid", "damper",
    "cylinder", "muscle", "adhesion", "dcmotor",
)  # fmt: skip
SHARED = frozenset({"gear", "ctrlrange", "ctrllimited", "forcerange", "forcelimited", "group"})
"""Attributes that an actuator takes of any kind of actuator in its class."""


@dataclass
class DefaultClass:
    """A class of defaults."""

    outer: DefaultClass | None
    """The class around it."""
    said: dict[str, dict[str, list[Triple]]] = field(default_factory=dict)
    """Statements of its own about elements, by tag and attribute."""
    resolved: dict[str, Values] = field(default_factory=dict)
    """Statements that elements take from it and the classes around it, by tag, once asked for."""

    def values(self, tag: str) -> Values:
        """Return what elements with *tag* take from the class and those around it."""
        chain: list[DefaultClass] = []
        at: DefaultClass | None = self
        while at is not None and tag not in at.resolved:
            chain.append(at)
            at = at.outer
        found: Values = at.resolved[tag] if at is not None else {}
        for each in reversed(chain):
            own = each.said.get(tag, {})
            if own:
                found = {**_without_replaced(found, own), **own}
            each.resolved[tag] = found
        return found


@dataclass
class DefaultClasses:
    """All classes of a model by name."""

    classes: dict[str, DefaultClass] = field(default_factory=lambda: {MAIN: DefaultClass(None)})
    """The classes by name."""
    elements: dict[str, MjcfElement] = field(default_factory=dict)
    """The elements that define them; of the top one the first."""

    @classmethod
    def from_root(cls, root: MjcfElement) -> DefaultClasses:
        """Return the classes of the model below *root*."""
        found = cls()
        pending = deque((each, MAIN, found.classes[MAIN]) for each in root.all("default"))
        while pending:
            element, name, class_ = pending.popleft()
            found.elements.setdefault(name, element)
            for each in element.content():
                if each.tag != "default":
                    class_.said.setdefault(each.tag, {}).update(each.said)
                    continue
                inner = each.text("class")
                if inner not in found.classes:
                    found.classes[inner] = DefaultClass(class_)
                    pending.append((each, inner, found.classes[inner]))
        return found

    def apply(self, root: MjcfElement) -> None:
        """Give all elements of the model below *root* what they inherit."""
        pending: list[tuple[MjcfElement, str]] = [(root, MAIN)]
        while pending:
            above, nearest = pending.pop()
            for each in above.content():
                if each.tag in ("default", "model"):
                    continue
                inside = each.text("childclass") or nearest
                if each.tag == "frame":
                    inside = each.text("class") or inside
                tags = _default_tags(each, above)
                if tags:
                    of_body = each.tag in OF_BODIES and above.type.tag in PLACES
                    name = each.text("class") or (nearest if of_body else MAIN)
                    each.inherited = self._inherited(each, name, tags)
                    each.class_name = name
                pending.append((each, inside))

    def _inherited(self, element: MjcfElement, name: str, tags: Sequence[str]) -> Values:
        """Return what *element* inherits from the class *name*, where *tags* stand for it."""
        class_ = self.classes.get(name)
        if class_ is None:
            return {}
        found: dict[str, list[Triple]] = {}
        for tag in tags:
            own = tag in (element.tag, "general") or len(tags) == 1
            values = class_.values(tag)
            found |= {n: said for n, said in values.items() if own or n in SHARED}
        return {
            name: said
            for name, said in _without_replaced(found, element.said).items()
            if name not in element.said and name in element.type.attributes
        }


def _default_tags(element: MjcfElement, above: MjcfElement) -> Sequence[str]:
    """Return the tags in default classes that stand for *element*; the last one counts most."""
    section = above.type.tag
    if section in PLACES and element.tag in OF_BODIES:
        return (element.tag,)
    if section == "actuator" and element.tag in ACTUATORS:
        others = (each for each in ACTUATORS if each not in (element.tag, "general"))
        return (*others, "general", element.tag)
    if section in ("equality", "tendon"):
        return (section,)
    known = (section == "contact" and element.tag == "pair") or (
        section == "asset" and element.tag in OF_ASSETS
    )
    return (element.tag,) if known else ()


def _without_replaced(values: Values, own: Values) -> dict[str, list[Triple]]:
    """Return *values* without orientations if *own* has one, in whatever form."""
    replaced = ORIENTATIONS if ORIENTATIONS & own.keys() else frozenset()
    return {name: said for name, said in values.items() if name not in replaced}
