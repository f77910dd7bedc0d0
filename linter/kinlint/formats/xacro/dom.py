"""The tree that xacro works on: as much of the DOM as it uses, each node knowing its origin.

Expansion copies, moves and drops nodes. What a copy was copied from stays with it, so the robot
that is left at the end still says which text wrote each of its elements, attributes and texts.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import ClassVar
from xml.dom import Node as Kinds
from xml.dom import NotFoundErr

from kinlint.formats.xacro.expansion_limits import Limits
from kinlint.formats.xacro.origin import Origin
from kinlint.text import Span


class VisitRecord:
    """Record of what xacro looked at last, to locate a failure. It counts nodes made."""

    def __init__(self, bounds: Limits) -> None:
        self.element: Element | None = None
        self.attribute: str | None = None
        self.text: Text | None = None
        self.made = bounds.node

    def looked(self, element: Element, attribute: str | None = None) -> None:
        """Record that xacro works on *element*, and there on *attribute*."""
        self.element, self.attribute, self.text = element, attribute, None


class Node:
    """A node and its neighbours."""

    __slots__ = ("nextSibling", "origin", "parentNode", "previousSibling")
    nodeType: ClassVar[int] = 0  # noqa: N815  the names of the DOM

    def __init__(self, origin: Origin) -> None:
        self.origin = origin
        self.parentNode: Element | None = None
        self.previousSibling: Node | None = None
        self.nextSibling: Node | None = None

    def cloneNode(self, deep: bool = True) -> Node:  # noqa: FBT001, FBT002, N802
        """Return a copy without parent, of the same origin."""
        raise NotImplementedError


class Character(Node):
    """A text, a comment, or a processing instruction; `written` is its text in the file."""

    __slots__ = ("_data", "watch", "written")

    def __init__(self, data: str, origin: Origin, watch: VisitRecord) -> None:
        super().__init__(origin)
        watch.made()
        self.written = self._data = data
        self.watch = watch

    @property
    def data(self) -> str:
        """The text as it is now."""
        return self._data

    @data.setter
    def data(self, value: str) -> None:
        self._data = value

    def cloneNode(self, deep: bool = True) -> Node:  # noqa: FBT001, FBT002, N802
        """Return a copy without parent, of the same origin."""
        del deep
        copy = type(self)(self._data, self.origin, self.watch)
        copy.written = self.written
        return copy


class Text(Character):
    """Text between tags."""

    __slots__ = ()
    nodeType = Kinds.TEXT_NODE  # noqa: N815

    @property
    def data(self) -> str:
        """The text as it is now."""
        self.watch.text = self
        return self._data

    @data.setter
    def data(self, value: str) -> None:
        self._data = value


class Raw(Character):
    """A CDATA section or processing instruction, which xacro passes through."""

    __slots__ = ()
    nodeType = Kinds.CDATA_SECTION_NODE  # noqa: N815


class Comment(Character):
    """A comment."""

    __slots__ = ()
    nodeType = Kinds.COMMENT_NODE  # noqa: N815


class Attribute:
    """The value of an attribute, for the one place in xacro that asks for its node."""

    __slots__ = ("value",)

    def __init__(self, value: str) -> None:
        self.value = value


class Attributes:
    """The attributes of an element, as a copy that may change meanwhile."""

    __slots__ = ("_element",)

    def __init__(self, element: Element) -> None:
        self._element = element

    def keys(self) -> list[str]:
        """Return their names."""
        return list(self._element.values)

    def items(self) -> Iterator[tuple[str, str]]:
        """Yield their names and values."""
        watch = self._element.watch
        watch.looked(self._element)
        for name, value in list(self._element.values.items()):
            watch.looked(self._element, name)
            yield name, value


class Element(Node):
    """An element; `values` are its attributes.

    `written` is what the file says of them, `givers` the origins of those that an
    `xacro:attribute` gave it, and `giver` of the one that is about to.
    """

    __slots__ = (
        "firstChild",
        "giver",
        "givers",
        "lastChild",
        "nodeName",
        "tagName",
        "values",
        "watch",
        "written",
    )
    nodeType = Kinds.ELEMENT_NODE  # noqa: N815

    def __init__(
        self, tag: str, values: dict[str, str], origin: Origin, watch: VisitRecord
    ) -> None:
        super().__init__(origin)
        watch.made()
        self.tagName = self.nodeName = tag
        self.written = values
        self.values = dict(values)
        self.givers: dict[str, Origin] = {}
        self.giver: Origin | None = None
        self.firstChild: Node | None = None
        self.lastChild: Node | None = None
        self.watch = watch

    @property
    def attributes(self) -> Attributes:
        """The attributes as the DOM shows them."""
        return Attributes(self)

    @property
    def children(self) -> Iterator[Node]:
        """The nodes right inside."""
        child = self.firstChild
        while child is not None:
            after = child.nextSibling
            yield child
            child = after

    @property
    def elements(self) -> Iterator[Element]:
        """The elements right inside."""
        return (child for child in self.children if isinstance(child, Element))

    @property
    def everything(self) -> Iterator[Element]:
        """The element and all elements inside, in the order of the text."""
        waiting: list[Element] = [self]
        while waiting:
            element = waiting.pop()
            yield element
            waiting.extend(reversed(list(element.elements)))

    def span_of(self, attribute: str | None = None) -> Span:
        """Return the span of the value of *attribute*, or else of the tag."""
        spans = self.origin.attributes.get(attribute or "")
        return spans.value if spans else self.origin.tag

    def hasAttribute(self, name: str) -> bool:  # noqa: N802
        """Tell whether it has the attribute *name*."""
        if name in self.values:
            self.watch.looked(self, name)
            return True
        return False

    def getAttribute(self, name: str) -> str:  # noqa: N802
        """Return the value of the attribute *name*; empty if it has none."""
        return self.values.get(name, "")

    def getAttributeNode(self, name: str) -> Attribute | None:  # noqa: N802
        """Return the attribute *name*."""
        return Attribute(self.values[name]) if name in self.values else None

    def setAttribute(self, name: str, value: str) -> None:  # noqa: N802
        """Give it the attribute *name*."""
        self.values[name] = value if isinstance(value, str) else str(value)
        if self.giver is not None:
            self.givers[name], self.giver = self.giver, None

    def removeAttribute(self, name: str) -> None:  # noqa: N802
        """Take the attribute *name* away."""
        if name not in self.values:
            raise NotFoundErr
        del self.values[name]

    def insertBefore(self, node: Node, before: Node | None) -> None:  # noqa: N802
        """Put *node* inside, in front of *before* or at the end."""
        if node.parentNode is not None:
            node.parentNode.removeChild(node)
        node.parentNode = self
        self._join(self.lastChild if before is None else before.previousSibling, node)
        self._join(node, before)

    def removeChild(self, node: Node) -> None:  # noqa: N802
        """Take *node* out."""
        self._join(node.previousSibling, node.nextSibling)
        node.parentNode = node.previousSibling = node.nextSibling = None

    def _join(self, left: Node | None, right: Node | None) -> None:
        """Make neighbours of two nodes inside; None stands for what is beyond either end."""
        if left is None:
            self.firstChild = right
        else:
            left.nextSibling = right
        if right is None:
            self.lastChild = left
        else:
            right.previousSibling = left

    def cloneNode(self, deep: bool = True) -> Element:  # noqa: FBT001, FBT002, N802
        """Return a copy without parent, of the same origin; *deep*, with all that is inside."""
        copy = Element(self.tagName, self.written, self.origin, self.watch)
        copy.values = dict(self.values)
        copy.givers = dict(self.givers)
        if deep:
            for child in self.children:
                copy.insertBefore(child.cloneNode(deep=True), None)
        return copy
