"""Files of every format, for tests: the examples of rules, and what schemas say of references."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import cache

from support.linting import book, document

from kinlint.document import Document
from kinlint.file_format import Format
from kinlint.formats.dependencies.joined_documents import join_companions
from kinlint.formats.records import LIFTED
from kinlint.formats.xml.element_types import ElementType, Reference, Schema
from kinlint.formats.xml.schema import TEXT, schema
from kinlint.rule import Rule
from kinlint.rule_testing.example_texts import unmarked
from kinlint.terms import iri_value

GOAL = "goal"
"""The name of what references in specimens lead to."""
NOWHERE = "nobody"
"""The name that nothing in a specimen has."""
BY_WORD = {("sdf", "world")}
"""What is referred to by a word of the format, whatever its name is."""
OUTSIDE = {
    ("sdf", "model", "pose"),
    ("sdf", "world", "pose"),
    ("sdf", "include", "placement_frame"),
}
"""Elements whose names are looked for around the element that they stand in, or in another file."""
YAML = {
    "joint": "controller:\n  joints: [{}]\n  command_joints: [goal]\n",
    "joint_limit": "joint_limits:\n  {}: {{max_velocity: 1}}\njoints: [goal]\n",
    "initial_position": "initial_positions:\n  {}: 0.5\njoints: [goal]\n",
    "link": "controller:\n  tip_link: {}\n  base_link: goal\n",
    "frame": "planner:\n  octomap_frame: {}\n  base_link: goal\n",
    "group": "servo:\n  move_group_name: {}\n  planning_group: goal\n",
}
"""Files of YAML for each kind of entry, which name `GOAL` besides."""


@cache
def examples(form: Format, *, good: bool = True) -> tuple[tuple[Rule, str], ...]:
    """Return the good or the bad examples of rules that are files of *form* and stand alone.

    After them come those of the format that *form* expands to.
    """
    return tuple(
        (rule, unmarked(text)[0])
        for name in dict.fromkeys((form.name, form.lifted_as))
        for rule in book().rules
        for each in rule.examples
        if each.format == name and not each.companions and not each.beside
        if (text := each.good if good else each.bad)
    )


def models(form: Format) -> Iterator[tuple[Document, ...]]:
    """Yield the examples of rules that are files of *form*, read with the files that come along."""
    for rule in book().rules:
        for each in rule.examples:
            for text in (each.bad, each.good) if each.format == form.name else ():
                if text is not None:
                    companions = enumerate(each.companions)
                    beside = [(t, f"other{n}.{name}", name) for n, (name, t) in companions]
                    files = [(unmarked(text)[0], f"arm{form.suffixes[0]}", form.name), *beside]
                    yield tuple(join_companions([document(*file) for file in files]))


@dataclass(frozen=True)
class ReferenceKind:
    """A property by which elements of one type refer to others, below certain elements."""

    form: Format
    path: tuple[ElementType, ...] = field(repr=False)
    """From the root to the element that refers."""
    attribute: str
    """The attribute that has the name; "" for the text of the element."""
    reference: Reference = field(repr=False)
    namespace: str
    """The namespace of the format of what is referred to."""
    tag: str
    """The tag of what is referred to."""

    def __str__(self) -> str:
        return f"{'/'.join(each.tag for each in self.path)}@{self.attribute}->{self.tag}"

    @property
    def own(self) -> bool:
        """Whether what is referred to is in the same file."""
        return self.namespace == self.form.namespace

    def texts(self, name: str = GOAL) -> dict[str, str]:
        """Return the files of a model in which the element refers to *name*, by their names.

        The model has a `GOAL` where the name is looked for; it is named once besides.
        """
        if self.form.fence == "yaml":
            text = YAML[self.path[-1].tag].format(name)
        else:
            text = self._element(0, self._scope(), name)
        files = {f"arm{self.form.suffixes[0]}": text}
        if not self.own:
            other = next(each for each in LIFTED if each.namespace == self.namespace)
            (root,) = schema(other.name).roots.values()
            files[f"arm{other.suffixes[0]}"] = (
                _element(root, name=GOAL)
                if root.tag == self.tag
                else _element(root, _element(root.children[self.tag], name=GOAL), name="arm")
            )
        return files

    def _scope(self) -> int:
        """Return the place in the path of the element in which names are looked for, or -1."""
        return _scope(self) if self.own else -1

    def _element(self, depth: int, scope: int, name: str) -> str:
        type_ = self.path[depth]
        inner = ""
        if depth == scope:
            *around, goal = _way(self.form, type_, self.tag)
            inner = _element(goal, name=GOAL)
            for each in reversed(around):
                inner = _element(each, inner)
        said = {} if depth else {"name": "arm"}
        if depth + 1 < len(self.path):
            inner += self._element(depth + 1, scope, name)
        elif self.attribute:
            said[self.attribute] = name
        else:
            inner += name
        return _element(type_, inner, **said)

    def place(self) -> tuple[str, int]:
        """Return the file and the offset at which the reference to `GOAL` is written."""
        (name, there), *_ = self.texts().items()
        other = self.texts(NOWHERE)[name]
        return name, next(n for n, (a, b) in enumerate(zip(there, other, strict=False)) if a != b)


def _element(type_: ElementType, inner: str = "", **said: str) -> str:
    """Return an element of *type_* that has a name, and what it must have."""
    attributes = dict.fromkeys(type_.required, "1") | said
    if "name" in type_.attributes:
        attributes.setdefault("name", f"some_{type_.tag}")
    if "version" in type_.attributes and type_.tag == "sdf":
        attributes["version"] = "1.9"
    told = "".join(f' {key}="{value}"' for key, value in attributes.items())
    return f"<{type_.tag}{told}>{inner}</{type_.tag}>"


def reference_kinds(form: Format) -> Iterator[ReferenceKind]:
    """Yield each kind of reference that the schema of *form* tells of, once for each target.

    Where names are by kind, one element for each attribute and target stands for all.
    """
    table = schema(form.name)
    seen: set[tuple[str, str]] = set()
    for path in _paths(table):
        for property_, reference in path[-1].references.items():
            attribute = "" if property_ == TEXT else iri_value(property_).rpartition("#")[2]
            for namespace, tag in reference.targets:
                kind = ReferenceKind(form, path, attribute, reference, namespace, tag)
                if table.nested and (attribute, tag) in seen:
                    continue
                seen.add((attribute, tag))
                if (form.name, tag) not in BY_WORD and (not kind.own or _scope(kind) >= 0):
                    yield kind


def _scope(kind: ReferenceKind) -> int:
    """Return the place in the path of the innermost element that knows others by name.

    -1 if it knows none of the tag.
    """
    last = len(kind.path) if kind.reference.inside else len(kind.path) - 1
    scopes = [number for number, each in enumerate(kind.path[:last]) if each.scope]
    ends = (kind.form.name, *(each.tag for each in kind.path[-2:]))
    if not scopes or ends in OUTSIDE:
        return -1
    around = kind.path[scopes[-1]]
    known = kind.tag in around.scope and _way(kind.form, around, kind.tag)
    return scopes[-1] if known else -1


def _way(form: Format, around: ElementType, tag: str) -> list[ElementType]:
    """Return a shortest path to elements with *tag* and a name in elements of the type *around*.

    Where names are by kind, elements are passed over that have the tag of another kind.
    """
    own_kind = any(each.kind == tag for each in schema(form.name).types.get(tag, ()))
    queue = [[each] for each in around.children.values()]
    seen: set[int] = set()
    while queue:
        path = queue.pop(0)
        known = path[-1].kind == tag or not own_kind
        if path[-1].tag == tag and "name" in path[-1].attributes and known:
            return path
        if id(path[-1]) not in seen:
            seen.add(id(path[-1]))
            queue += [[*path, each] for each in path[-1].children.values() if each.tag != "include"]
    return []


def _paths(table: Schema) -> Iterator[tuple[ElementType, ...]]:
    """Yield a shortest path from a root to each type of element."""
    seen: set[int] = set()
    queue: list[tuple[ElementType, ...]] = [(root,) for root in table.roots.values()]
    while queue:
        path = queue.pop(0)
        if id(path[-1]) in seen:
            continue
        seen.add(id(path[-1]))
        yield path
        queue += [(*path, child) for child in path[-1].children.values()]


KINDS = [kind for form in LIFTED for kind in reference_kinds(form)]
