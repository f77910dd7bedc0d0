"""The elements of SDF, from the descriptions of libsdformat: `python sdf_descriptions.py TABLE`.

TABLE has a row for each element and attribute that the files `sdf/1.*/*.sdf` of libsdformat
describe, with these columns separated by tabs: the `path` of tags from the root, with `@` before an
attribute, `*` for any element, and `(again)` after a tag whose description contains itself; `what`
it is; the `type` of its text or value; its `default`; how often it is `required` (0, 1, *, + or -1,
as there, where -1 is deprecated); `min` and `max`; and the `versions` that describe it so,
separated by spaces.

Prints `shapes/formats/sdf-elements.ttl`.
"""

from __future__ import annotations

import csv
import re
import sys
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import TypeAlias

HEAD = """\
# SDF {first} to {last}: which element stands where, what attributes it has, what its text is.
# One node is one kind of element; a tag that means something else under another parent has a
# node for each.  fmt:required are attributes without which libsdformat refuses a file; fmt:expects
# are children that should be there and have no default, fmt:assumes the defaults of the others.
# Made from its descriptions by tests/formats/sdf/sdf_descriptions.py, not edited by hand; what
# they do not say is in sdf.ttl.
@prefix fmt: <https://w3id.org/kinlint/format#> .
@prefix sdf: <https://w3id.org/kinlint/sdf#> .

"""
AGAIN = " (again)"
NO_DEFAULT = "__default__"
"""What the descriptions have for a value that readers cannot do without."""
ATTRIBUTE_KINDS = {
    "bool": "boolean",
    "double": "number",
    "int": "integer",
    "string": "text",
    "unsigned int": "integer",
}
CONTENTS = {
    "bool": ("boolean",),
    "color": ("vector3", "vector4"),
    "double": ("number",),
    "float": ("number",),
    "int": ("integer",),
    "pose": ("vector6", "vector7"),
    "string": ("text",),
    "time": ("vector2",),
    "unsigned int": ("integer",),
    "vector2d": ("vector2",),
    "vector3": ("vector3",),
}
NUMBERS = frozenset({"double", "float", "int", "unsigned int"})
"""The types of a single number."""
Row: TypeAlias = Mapping[str, str]
Version: TypeAlias = tuple[int, ...]
Lifetime: TypeAlias = tuple[Version, Version]
WIDTH = 100
WORD = re.compile(r'(?:"[^"]*"|\S+)(?: ,)?')


def version(text: str) -> Version:
    """The numbers of a version."""
    return tuple(int(part) for part in text.split("."))


def shown(number: Version) -> str:
    """The version *number* as it is written."""
    return ".".join(map(str, number))


@dataclass(frozen=True)
class Kind:
    """A kind of element, wherever it stands and whenever it was described."""

    tag: str
    types: tuple[str, ...]
    """The types of its text, and `*` if it may have any content."""
    infinite: bool
    """True if infinity is what it is by default, of one sign or the other."""
    bounds: tuple[str, str]
    """The least and the greatest number that the newest version takes; empty if there is none."""
    attributes: tuple[tuple[str, str, bool], ...]
    """Their names, their types, and whether they have to be given."""
    children: tuple[tuple[str, bool, str | None, int], ...]
    """Their tags, whether there may be several, the defaults of expected ones, and their kinds."""


@dataclass
class Descriptions:
    """All rows of a table."""

    rows: Sequence[Row]
    kinds: dict[Kind, int] = field(default_factory=dict)
    """All kinds of elements, numbered."""
    places: dict[int, list[str]] = field(default_factory=lambda: defaultdict(list))
    """The paths at which elements of a kind stand."""
    orders: dict[int, dict[str, int]] = field(default_factory=dict)
    """The ranks of the children of a kind, by tag, as they are first described."""

    @cached_property
    def described(self) -> Mapping[str, Mapping[Version, Row]]:
        """The rows of each path, by version."""
        found: dict[str, dict[Version, Row]] = defaultdict(dict)
        for row in self.rows:
            for each in row["versions"].split():
                found[row["path"]][version(each)] = row
        return found

    @cached_property
    def below(self) -> Mapping[str, Sequence[str]]:
        """The paths right below each path."""
        found: dict[str, list[str]] = defaultdict(list)
        for path in self.described:
            found[path.rpartition("/")[0]].append(path)
        return found

    @cached_property
    def newest(self) -> Version:
        """The newest version."""
        return max(each for versions in self.described.values() for each in versions)

    @cached_property
    def oldest(self) -> Version:
        """The oldest version."""
        return min(each for versions in self.described.values() for each in versions)

    def kind(self, path: str) -> int:
        """The number of the kind of the element at *path*; those below it are numbered, too."""
        rows = self.described[path]
        attributes, children = [], []
        for each in self.below[path]:
            name = each.rpartition("/")[2]
            own = self.described[each]
            needed = max(rows) in own and own[max(rows)]["required"] in ("1", "+")
            if name.startswith("@"):
                attributes.append((name[1:], own[max(own)]["type"], needed))
            elif name != "*":
                many = _several(row["required"] for row in own.values())
                again = name.endswith(AGAIN)
                number = -1 if again else self.kind(each)
                default = own[max(rows)]["default"] if needed else None
                children.append((name.removesuffix(AGAIN), many, default, number))
        types = sorted({row["type"] for row in rows.values() if row["type"]})
        if f"{path}/*" in self.described:
            types.append("*")
        kind = Kind(
            path.rpartition("/")[2],
            tuple(types),
            any(row["default"].lower().endswith("inf") for row in rows.values()),
            _bounds(rows[max(rows)]),
            tuple(sorted(attributes)),
            tuple(sorted(children, key=lambda child: child[0])),
        )
        number = self.kinds.setdefault(kind, len(self.kinds))
        self.places[number].append(path)
        self.orders.setdefault(number, {each[0]: rank for rank, each in enumerate(children)})
        return number

    def lifetime(self, paths: Sequence[str]) -> Lifetime:
        """The first and the last version that describes one of *paths*.

        They are those of the whole format where each path is described as long as its parent.
        """
        own = [self.described[path] for path in paths]
        above = [
            self.described.get(path.rpartition("/")[0], each)
            for path, each in zip(paths, own, strict=True)
        ]
        born = any(min(each) > min(parent) for each, parent in zip(own, above, strict=True))
        dead = any(max(each) < max(parent) for each, parent in zip(own, above, strict=True))
        return (
            min(map(min, own)) if born else self.oldest,
            max(map(max, own)) if dead else self.newest,
        )


@dataclass
class Table:
    """The nodes of the Turtle file: a kind of element, with the versions that have it there."""

    all: Descriptions
    names: dict[tuple[int, Lifetime], str] = field(default_factory=dict)
    _paths: dict[tuple[int, Lifetime], list[str]] = field(default_factory=lambda: defaultdict(list))
    _child: dict[tuple[int, str], tuple[int, Lifetime]] = field(default_factory=dict)

    def __post_init__(self) -> None:
        """Find the nodes and name them."""
        root = self.all.kind("sdf"), (self.all.oldest, self.all.newest)
        self._paths[root].append("sdf")
        pending, kinds = [root], list(self.all.kinds)
        while pending:
            number, _ = pending.pop()
            for tag, _, _, child in kinds[number].children:
                if child < 0 or (number, tag) in self._child:
                    continue
                paths = [f"{each}/{tag}" for each in self.all.places[number]]
                node = child, self.all.lifetime(paths)
                self._child[number, tag] = node
                if node not in self._paths:
                    pending.append(node)
                self._paths[node] += paths
        by_tag: dict[str, list[tuple[int, Lifetime]]] = defaultdict(list)
        for node in self._paths:
            by_tag[kinds[node[0]].tag].append(node)
        taken: set[str] = set()
        for nodes in by_tag.values():
            nodes.sort(key=self._rank)
            for rank, node in enumerate(nodes):
                steps = self._shortest(node)[1].split("/")
                count = 1 if not rank else 2
                while (name := "-".join(steps[-count:])) in taken:
                    count += 1
                taken.add(name)
                self.names[node] = name

    def _rank(self, node: tuple[int, Lifetime]) -> tuple[int, int, str]:
        """The node of a tag that is nearest the root, and of most paths, has the tag for a name."""
        depth, path = self._shortest(node)
        return depth, -len(self._paths[node]), path

    def _shortest(self, node: tuple[int, Lifetime]) -> tuple[int, str]:
        return min((path.count("/"), path) for path in self._paths[node])

    def turtle(self) -> str:
        """The whole file."""
        head = HEAD.format(first=shown(self.all.oldest), last=shown(self.all.newest))
        order = sorted(self.names.items(), key=lambda each: (self._shortest(each[0]), each[1]))
        return head + "".join(self._node(node, name) for node, name in order)

    def _node(self, node: tuple[int, Lifetime], name: str) -> str:
        number, life = node
        kind = list(self.all.kinds)[number]
        parts = [f'fmt:tag "{kind.tag}"']
        parts += self._since(life)
        by_type: dict[str, list[str]] = defaultdict(list)
        for attribute, type_, _ in kind.attributes:
            by_type[ATTRIBUTE_KINDS[type_]].append(f'"{attribute}"')
        parts += [_statement(each, by_type[each]) for each in sorted(by_type)]
        parts += _given("required", [f'"{name}"' for name, _, needed in kind.attributes if needed])
        parts += self._dated(number, kind)
        if "*" in kind.types:
            parts.append("fmt:open true")
        else:
            said = dict.fromkeys(each for type_ in kind.types for each in CONTENTS[type_])
            parts += _given("content", [f"fmt:{each}" for each in said])
        if kind.infinite:
            parts.append("fmt:infinite true")
        least, greatest = kind.bounds
        parts += _given("least", [least] if least else [])
        parts += _given("greatest", [greatest] if greatest else [])
        once, many, expects, assumes = [], [], [], []
        order = self.all.orders[number]
        for tag, several, default, child in sorted(kind.children, key=lambda each: order[each[0]]):
            term = f"sdf:{self._named(number, tag, child)}"
            (many if several else once).append(term)
            if default == NO_DEFAULT:
                expects.append(term)
            elif default:
                assumes.append(f'"{tag} {default}"')
        parts += _given("once", once) + _given("many", many)
        parts += _given("expects", expects) + _given("assumes", assumes)
        return _laid_out(f"sdf:{name}", parts)

    def _named(self, number: int, tag: str, child: int) -> str:
        """The name of the child with *tag* of an element of the kind *number*."""
        if child >= 0:
            return self.names[self._child[number, tag]]
        own = [name for (kind, _), name in self.names.items() if kind == number]
        return own[0] if list(self.all.kinds)[number].tag == tag else tag

    def _since(self, life: Lifetime) -> Iterator[str]:
        if life[0] > self.all.oldest:
            yield f'fmt:since "{shown(life[0])}"'
        if life[1] < self.all.newest:
            yield f'fmt:until "{shown(life[1])}"'

    def _dated(self, number: int, kind: Kind) -> Iterator[str]:
        introduced, removed = [], []
        for name, _, _ in kind.attributes:
            paths = [
                path
                for each in self.all.places[number]
                if (path := f"{each}/@{name}") in self.all.described
            ]
            first, last = self.all.lifetime(paths)
            if first > self.all.oldest:
                introduced.append(f'"{name} {shown(first)}"')
            if last < self.all.newest:
                removed.append(f'"{name} {shown(last)}"')
        yield from _given("introduced", introduced)
        yield from _given("removed", removed)


def _bounds(row: Row) -> tuple[str, str]:
    """The least and the greatest number that *row* allows, if it is of one number."""
    least, greatest = (row[end] if row["type"] in NUMBERS else "" for end in ("min", "max"))
    return least, greatest


def _several(required: Iterable[str]) -> bool:
    """Tell whether an element that is so often *required*, by version, may be there repeatedly.

    Nothing is said of one that was deprecated before it was known.
    """
    said = set(required) - {"-1"}
    return not said or not said.isdisjoint({"*", "+"})


def _given(word: str, values: Sequence[str]) -> list[str]:
    return [_statement(word, values)] if values else []


def _statement(word: str, values: Sequence[str]) -> str:
    return f"fmt:{word} {' , '.join(values)}"


def _laid_out(subject: str, parts: Sequence[str]) -> str:
    """The statements *parts* of *subject*, in one line if they fit."""
    line = f"{subject} {' ; '.join(parts)} .\n"
    if len(line) <= WIDTH:
        return line
    lines = [f"{subject} {parts[0]} ;"]
    for part in parts[1:]:
        at = "   "
        for word in WORD.findall(part):
            if len(at) + 1 + len(word) > WIDTH - len(" ;"):
                lines.append(at)
                at = "       "
            at += f" {word}"
        lines.append(f"{at} ;")
    return "\n".join(lines).removesuffix(";") + ".\n"


def elements(table: Path) -> str:
    """The Turtle file of the elements that *table* has."""
    with table.open(encoding="utf-8", newline="") as text:
        rows = list(csv.DictReader(text, delimiter="\t", quoting=csv.QUOTE_NONE))
    return Table(Descriptions(rows)).turtle()


if __name__ == "__main__":
    sys.stdout.write(elements(Path(sys.argv[1])))
