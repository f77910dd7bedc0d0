"""Addresses in a COLLADA document: URIs, paths of scoped identifiers, and names of parameters.

The search by scoped identifiers is that of collada-dom (daeSIDResolver), which most readers use.
"""

from __future__ import annotations

import re
from collections import deque
from collections.abc import Iterable, Iterator
from urllib.parse import unquote

from kinlint.formats.collada.collada_elements import ColladaElement
from kinlint.light_dataclasses import dataclass

MEMBERS = re.compile(r"[A-Z]|ANGLE|TIME", re.ASCII)
"""Parts of a value that may follow a point at the end of a path."""
INSTANCE = "instance_"
LONGEST = 4_000
"""Greatest length of a path, in characters."""
MOST_FOLLOWED = 64
"""Greatest number of parameters that lead to each other."""
MOST_SEARCHES, SMALL = 16, 100_000
"""Greatest number of searches of all elements for scoped identifiers, beside SMALL elements.

Instances that lead to each other in a ring make each search one of all elements.
"""


@dataclass(frozen=True)
class Missing:
    """Address that leads nowhere."""

    step: str
    """The first step of it that is not found."""
    within: ColladaElement | None = None
    """The element in which that step is not found; None for the document."""


class Addressing:
    """Identifiers of the elements below *root*, and the search by them."""

    def __init__(self, root: ColladaElement) -> None:
        self.root = root
        self.ids: dict[str, ColladaElement] = {}
        self.repeated: list[tuple[ColladaElement, ColladaElement]] = []
        """Elements with an id that another one has already, each with that one."""
        self.repeated_sids: list[tuple[ColladaElement, ColladaElement]] = []
        """Elements with the sid of one before them beside them, each with that one."""
        self.searched = 0
        """Number of elements looked at in search of scoped identifiers."""
        self._sids: dict[ColladaElement, dict[str, ColladaElement]] = {}
        self._anywhere: dict[str, ColladaElement] = {}
        elements = [root, *root.below()]
        self._most_searched = SMALL + MOST_SEARCHES * len(elements)
        for each in elements:
            self._anywhere.setdefault(each.text("sid"), each)
            id_ = each.text("id")
            if id_ and self.ids.setdefault(id_, each) is not each:
                self.repeated.append((each, self.ids[id_]))
            self.repeated_sids += _repeated_sids(each)
        self._anywhere.pop("", None)

    def by_uri(self, uri: str) -> ColladaElement | Missing | None:
        """Return the element that *uri* leads to; None if that is in another document.

        Without a fragment it is a file, unless that is the id of an element, or has no suffix.
        """
        document, mark, fragment = uri.partition("#")
        if not mark and (document in self.ids or not re.search(r"[./:]", document)):
            return Missing(document)
        if document or not mark:
            return None
        return self.ids.get(fragment) or self.ids.get(unquote(fragment)) or Missing(fragment)

    def by_path(self, path: str, holder: ColladaElement) -> ColladaElement | Missing:
        """Return the element that *path*, in *holder*, leads to.

        Old files have a single sid of the model around in place of a path.
        """
        if len(path) > LONGEST:
            return Missing(path[:LONGEST])
        first, *steps = re.sub(r"(\([^()]*\))+$", "", path).split("/")
        at = holder if first == "." else self.ids.get(first.removeprefix("#"))
        if at is None and not steps:
            at = self._near(first, holder)
        if at is None and steps:
            at = self.ids.get(path)
            steps = [] if at is not None else steps
        if at is None:
            return Missing(first)
        for step in steps:
            found = self._step(at, step)
            if found is None:
                return Missing(step, at)
            at = found
        return at

    def by_parameter(self, name: str, holder: ColladaElement) -> ColladaElement | Missing:
        """Return the parameter *name* that counts in *holder*, or what a path of that text is."""
        for around in holder.ancestors():
            found = self._declared(around, name)
            if found is not None:
                return found
        found_ = self.by_path(name, holder) if "/" in name or name in self.ids else None
        return found_ or Missing(name)

    def followed(self, element: ColladaElement) -> ColladaElement | None:
        """Return what *element* stands for: a parameter for what it refers to, by way of others."""
        at: ColladaElement | Missing | None = element
        for _ in range(MOST_FOLLOWED):
            if not isinstance(at, ColladaElement):
                return None
            if at.tag not in ("newparam", "setparam", "bind"):
                return at
            sidref, param = at.first("SIDREF"), at.first("param")
            if sidref is not None:
                at = self.by_path(sidref.text(), sidref)
            elif param is not None:
                at = self.by_parameter(param.text() or param.text("ref"), at)
            else:
                return at
        return None

    def instanced(self, element: ColladaElement) -> ColladaElement | None:
        """Return what *element* is an instance of, if it is one, and of something that is there."""
        if not element.tag.startswith(INSTANCE):
            return None
        found = self.by_uri(element.text("url"))
        return found if isinstance(found, ColladaElement) else None

    def _declared(self, around: ColladaElement, name: str) -> ColladaElement | None:
        """Return the parameter *name* that *around* declares, or what it is an instance of."""
        for each in around.all("newparam"):
            if each.text("sid") == name:
                return each
        inner = self.instanced(around)
        if inner is None:
            return None
        found = self._step(inner, name)
        return found if found is not None and found.tag == "newparam" else None

    def _near(self, sid: str, holder: ColladaElement) -> ColladaElement | None:
        """Return the element with *sid* in the model, the system or the scene around *holder*."""
        for around in holder.ancestors():
            if around.tag in ("kinematics_model", "instance_physics_model", "physics_model"):
                return self._step(around, sid)
        return None

    def _step(self, at: ColladaElement, step: str) -> ColladaElement | None:
        """Return the element that *step* leads to from *at*; the name of a member leads nowhere."""
        parts = step.split(".")
        for count in range(len(parts), 0, -1):
            sid = ".".join(parts[:count])
            if sid in self._anywhere and all(MEMBERS.fullmatch(each) for each in parts[count:]):
                found = self._known(at).get(sid)
                if found is not None:
                    return found
        return None

    def _known(self, at: ColladaElement) -> dict[str, ColladaElement]:
        """Return the elements with scoped identifiers below *at*, the nearest of each.

        What *at* is an instance of comes first, and last what those below are instances of.
        Once too much was searched it is the first elements of the document, wherever they are.
        """
        if at not in self._sids:
            if self.searched > self._most_searched:
                return self._anywhere
            found = self._sids[at] = {}
            inner = self.instanced(at)
            starts = [inner, at] if inner is not None else [at]
            entered = set(starts)
            instances: list[ColladaElement] = []
            for start in starts:
                for each in _breadth_first(start.children):
                    self.searched += 1
                    found.setdefault(each.text("sid"), each)
                    if each.tag.startswith(INSTANCE):
                        instances.append(each)
            for each in instances:
                self.searched += 1
                inner = self.instanced(each)
                if inner is not None and inner not in entered:
                    entered.add(inner)
                    below = [*_breadth_first(inner.children)]
                    self.searched += len(below) + 1
                    for one in below:
                        found.setdefault(one.text("sid"), one)
                    instances += (one for one in below if one.tag.startswith(INSTANCE))
            found.pop("", None)
        return self._sids[at]


def _repeated_sids(parent: ColladaElement) -> Iterator[tuple[ColladaElement, ColladaElement]]:
    first: dict[str, ColladaElement] = {}
    for each in parent.children:
        sid = each.text("sid")
        if sid and first.setdefault(sid, each) is not each:
            yield each, first[sid]


def _breadth_first(elements: Iterable[ColladaElement]) -> Iterator[ColladaElement]:
    queue = deque(elements)
    while queue:
        at = queue.popleft()
        yield at
        queue += at.children
