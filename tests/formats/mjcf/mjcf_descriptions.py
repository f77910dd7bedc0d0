"""The elements of MJCF, from a table of what MuJoCo reads: `python mjcf_descriptions.py TABLE`.

TABLE has a row for each element and attribute of the schema of MuJoCo, with these columns separated
by tabs: the `element`, as its path below `mujoco` where body stands for worldbody too; `card`, how
often it may stand there (`?`: once); the `attribute`, or nothing; its `type`, where `id:K` is a
name of kind K and `ref:K` refers to one; its `default`, or `required`; and the versions `since` it
is there and in which it was `removed`.

Prints `shapes/formats/mjcf-elements.ttl`.
"""

from __future__ import annotations

import csv
import re
import sys
import textwrap
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import TypeAlias

HEAD = """\
# MJCF as MuJoCo {newest} reads it: which element stands where, and what attributes it has.
# One node is one kind of element; a tag that means something else under another parent has a
# node for each.  Made from a table by tests/formats/mjcf/mjcf_descriptions.py, not edited by hand;
# what the table does not say is in mjcf.ttl.
@prefix fmt:  <https://w3id.org/kinlint/format#> .
@prefix mjcf: <https://w3id.org/kinlint/mjcf#> .
@prefix ref:  <https://w3id.org/kinlint/reference#> .

"""
Row: TypeAlias = Mapping[str, str]
Version: TypeAlias = tuple[int, ...]
WIDTH = 100
LARGEST = 10
"""The most numbers of a vector whose sizes are listed; others may have any number of them."""
SIZE = re.compile(r"(?:real|int)\((\d+)(?:(?:\.\.| or )(\d+))?\)")
WHOLE = re.compile(r'\( "\w+"|"[^"]*"(?: \)?)?(?: ,)?|\S+ ,')
"""Stays on one line: a text, and what comes before or behind it without a meaning of its own."""
TIED = "\N{NO-BREAK SPACE}"
AFTER_THREE = {
    ("option", "actuatorgroupdisable"),
    ("visual/rgba", "frustum"),
    ("visual/scale", "frustum"),
}
"""What MuJoCo 3.0.1 brought. The table skips 3.0.0, which has all else that it has since 3.0.1."""
META = ("include", "frame", "replicate")
"""Elements that stand among others instead of below a section."""
STATIC = ("joint", "freejoint", "inertial")
"""Children of bodies that no world has, and which do not stand right below a replicate."""
ALTERNATIVES = ("body/flexcomp/pin",)
"""Elements whose required attributes stand for each other: any of them will do."""
SECTIONS_OF_BODY = ("body", *META)


def version(text: str) -> Version:
    """The numbers of a version."""
    return tuple(int(part) for part in text.split("."))


@dataclass
class Element:
    """An element of the schema, wherever its path leads to."""

    path: str
    row: Row
    attributes: list[Row] = field(default_factory=list)
    children: list[Element] = field(default_factory=list)

    @property
    def tag(self) -> str:
        """Its tag."""
        return self.path.rpartition("/")[2]

    @property
    def node(self) -> str:
        """The name of its node: its path, without the body that it may stand in."""
        return "mjcf:" + self.path.removeprefix("body/").replace("/", "-")


@dataclass
class Descriptions:
    """All rows of a table."""

    rows: Sequence[Row]

    @cached_property
    def elements(self) -> Mapping[str, Element]:
        """The elements by path, each with its attributes and children."""
        found: dict[str, Element] = {}
        for row in self.rows:
            path = row["element"]
            if path.startswith("("):
                continue
            if not row["attribute"]:
                found[path] = Element(path, row)
            else:
                found[path].attributes.append(row)
        for path, element in found.items():
            above = path.rpartition("/")[0]
            if above:
                found[above].children.append(element)
        return found

    @cached_property
    def versions(self) -> Sequence[str]:
        """All versions that the table names, the oldest first."""
        named = {row[column] for row in self.rows for column in ("since", "removed")} - {""}
        return sorted(named, key=version)

    @cached_property
    def kinds(self) -> Mapping[str, Sequence[str]]:
        """The tags of the elements of each kind of names."""
        found: dict[str, dict[str, None]] = defaultdict(dict)
        for element in self.elements.values():
            for row in element.attributes:
                if row["type"].startswith("id:"):
                    found[row["type"].removeprefix("id:")][element.tag] = None
        return {kind: [*tags] for kind, tags in found.items()}

    def before(self, removed: str) -> str:
        """The last version that the table names before *removed*."""
        earlier = [each for each in self.versions if version(each) < version(removed)]
        return earlier[-1] if earlier else "2.3.7"

    def lines(self) -> Iterator[str]:
        """Yield the nodes of all elements."""
        sections = [e for p, e in self.elements.items() if "/" not in p and p != "mujoco"]
        inside = [e for e in sections if e.tag in SECTIONS_OF_BODY]
        others = [e for e in sections if e.tag not in SECTIONS_OF_BODY]
        body = self.elements["body"]
        moving = [*body.children, *inside]
        still = [each for each in moving if each.tag not in STATIC]
        include = self.elements["include"]
        yield from self._node(self.elements["mujoco"], [*others, include], ["mjcf:worldbody"])
        yield 'mjcf:mujocoinclude fmt:tag "mujocoinclude" ;'
        yield from self._children([*others, *moving], ["mjcf:worldbody"])
        yield "    fmt:open true ."
        yield 'mjcf:worldbody fmt:tag "worldbody" ;'
        yield from self._children(still, [], last=True)
        below = {"body": moving, "frame": moving, "replicate": still, "include": []}
        for path, element in self.elements.items():
            if path != "mujoco":
                children = below.get(path, element.children)
                nested = [include] if element.children and path not in below else []
                own = ["mjcf:default"] if path == "default" else []
                yield from self._node(element, [*children, *nested], own)

    def _node(self, element: Element, children: Sequence[Element], more: list[str]) -> list[str]:
        said = [f'{element.node} fmt:tag "{element.tag}" ;']
        said += self._lifetime(element.row)
        said += self._attributes(element)
        said += self._children(children, more)
        said[-1] = said[-1].removesuffix(";") + "."
        return said

    def _lifetime(self, row: Row) -> Iterator[str]:
        if row["since"]:
            yield f'    fmt:since "{row["since"]}" ;'
        if row["removed"]:
            yield f'    fmt:until "{self.before(row["removed"])}" ;'

    def _children(
        self, children: Iterable[Element], more: list[str], *, last: bool = False
    ) -> list[str]:
        once, many = [], [*more]
        for each in children:
            (once if each.row["card"] == "?" else many).append(each.node)
        found = [*_listed("fmt:once", once), *_listed("fmt:many", many)]
        if found and last:
            found[-1] = found[-1].removesuffix(";") + "."
        return found

    def _attributes(self, element: Element) -> Iterator[str]:
        slots: dict[str, list[str]] = defaultdict(list)
        said: dict[str, list[str]] = defaultdict(list)
        for row in element.attributes:
            name, type_ = row["attribute"], row["type"]
            for slot in _slots(type_):
                slots[slot].append(f'"{name}"')
            if row["default"] == "required" and element.path not in ALTERNATIVES:
                said["required"].append(f'"{name}"')
            if row["since"] and row["since"] != element.row["since"]:
                said["introduced"].append(f'"{name} {row["since"]}"')
            if row["removed"] and row["removed"] != element.row["removed"]:
                said["removed"].append(f'"{name} {self.before(row["removed"])}"')
            for property_, value in self._meaning(name, type_):
                said[property_].append(value)
        for slot, names in slots.items():
            yield from _listed(f"fmt:{slot}", names)
        for property_, values in said.items():
            yield from _listed(f"fmt:{property_}", values)

    def _meaning(self, name: str, type_: str) -> Iterator[tuple[str, str]]:
        """Yield what else the schema says of the attribute *name* because of its type."""
        if type_.startswith("id:"):
            yield "kind", f'"{type_.removeprefix("id:")}"'
        elif type_.startswith("ref:") and "(" not in type_:
            ends = " ".join(f"mjcf:{tag}" for tag in self.kinds[type_.removeprefix("ref:")])
            yield "refersTo", f'( ref:{name} "{name}" {ends} )'
        elif type_.startswith("enum "):
            words = " ".join(f'"{word}"' for word in type_.removeprefix("enum ").split("|"))
            yield "choice", f'( "{name}" {words} )'
        elif type_ == "file":
            yield "file", f'"{name}"'


def _slots(type_: str) -> Sequence[str]:
    """Return the kinds of values, as schemas call them, that an attribute of *type_* has."""
    if type_ in ("real", "real(1)"):
        return ["number"]
    if type_ in ("int", "int(1)"):
        return ["integer"]
    if sized := SIZE.fullmatch(type_):
        least, most = int(sized[1]), int(sized[2] or sized[1])
        if least == most and most > LARGEST:
            return ["vectors"]
        either = " or " in type_
        sizes = (least, most) if either else range(least, most + 1)
        return [f"vector{size}" for size in sizes]
    return ["vectors"] if type_.startswith(("real(", "int(")) else ["text"]


def _listed(property_: str, values: Sequence[str]) -> list[str]:
    """Return a property with all its *values*, folded into lines."""
    if not values:
        return []
    text = f"{property_} {' , '.join(values)} ;"
    kept = WHOLE.sub(lambda match: match[0].replace(" ", TIED), text)
    indents = {"initial_indent": " " * 4, "subsequent_indent": " " * 8}
    wrapped = textwrap.wrap(kept, WIDTH, break_long_words=False, break_on_hyphens=False, **indents)
    return [line.replace(TIED, " ") for line in wrapped]


def elements(table: Path) -> str:
    """Return the Turtle file that the table makes."""
    with table.open(encoding="utf-8", newline="") as text:
        rows = list(csv.DictReader(text, delimiter="\t", quoting=csv.QUOTE_NONE))
    for row in rows:
        if row["since"] == "3.0.1" and (row["element"], row["attribute"]) not in AFTER_THREE:
            row["since"] = "3.0.0"
    described = Descriptions(rows)
    head = HEAD.format(newest=described.versions[-1])
    return head + "\n".join(described.lines()) + "\n"


if __name__ == "__main__":
    sys.stdout.write(elements(Path(sys.argv[1])))
