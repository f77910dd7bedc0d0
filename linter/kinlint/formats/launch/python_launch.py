"""Calls of xacro in launch files in Python, which are parsed and never run.

Known are literals, names that are assigned once, joined paths, and the functions that find
packages; all else is a value that only the running file knows.
"""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator
from functools import cached_property

from kinlint.formats.launch.xacro_call import HERE, SHARE, UNKNOWN, XacroCall, command_call
from kinlint.text import SourceText, Span

DEEPEST = 50
"""Most expressions within each other that are looked into."""
SHARES = frozenset(
    {"FindPackageShare", "get_package_share_directory", "get_package_share_path"}
)  # fmt: skip
"""Functions that find the directory of a package."""
JOINS = frozenset({"PathJoinSubstitution", "joinpath", "join"})
SAME = frozenset(
    {"str", "Path", "PurePath", "as_posix", "resolve", "absolute", "abspath", "realpath",
     "TextSubstitution", "ParameterValue", "FindExecutable"}
)  # fmt: skip
"""Functions and methods that make the same text of a text."""

Text = tuple[str, list[int]]
"""A text as far as it is known, and the offset of each of its characters, or -1."""
NOT_KNOWN: Text = (UNKNOWN, [-1])


class PythonLaunch:
    """The calls of xacro in a launch file in Python."""

    def __init__(self, source: SourceText) -> None:
        self._source = source
        try:
            self._tree: ast.Module | None = ast.parse(source.text)
        except (SyntaxError, ValueError, RecursionError, MemoryError):
            self._tree = None

    def calls(self) -> Iterator[XacroCall]:
        """Yield the calls that can be understood, in the order of the text."""
        if self._tree is None:
            return
        for node in ast.walk(self._tree):
            if isinstance(node, ast.Call):
                found = {
                    "Command": self._command,
                    "process_file": self._processed,
                    "process": self._processed,
                    "robot_description": self._configured,
                }.get(_name(node.func), _nothing)(node)
                if found is not None:
                    yield found

    def _command(self, node: ast.Call) -> XacroCall | None:
        """Return the call of `Command(["xacro ", path, " prefix:=", prefix])`."""
        if not node.args:
            return None
        text, places = self._text(node.args[0], DEEPEST)
        return command_call(text, places, self._span(node))

    def _processed(self, node: ast.Call) -> XacroCall | None:
        """Return the call of `xacro.process_file(path, mappings={...})`."""
        if not node.args or not isinstance(node.func, ast.Attribute):
            return None
        if _name(node.func.value) != "xacro":
            return None
        return self._mapped(self._text(node.args[0], DEEPEST)[0], node)

    def _configured(self, node: ast.Call) -> XacroCall | None:
        """Return the call of `MoveItConfigsBuilder(...).robot_description(file_path=...)`."""
        path = _keyword(node, "file_path") or (node.args[0] if node.args else None)
        builder = node.func.value if isinstance(node.func, ast.Attribute) else None
        while isinstance(builder, ast.Call) and isinstance(builder.func, ast.Attribute):
            builder = builder.func.value
        if path is None or not isinstance(builder, ast.Call) or not builder.args:
            return None
        if _name(builder.func) != "MoveItConfigsBuilder":
            return None
        given = _keyword(builder, "package_name")
        package = self._text(given or builder.args[0], DEEPEST)[0]
        home = f"{SHARE}{package}" if given else f"{SHARE}{package}_moveit_config"
        written = self._text(path, DEEPEST)[0]
        return self._mapped(written if "://" in written else f"{home}/{written}", node)

    def _mapped(self, file: str, node: ast.Call) -> XacroCall | None:
        """Return the call for *file* with the `mappings` of *node*."""
        mappings = _keyword(node, "mappings")
        if isinstance(mappings, ast.Name):
            mappings = self._assigned.get(mappings.id)
        if not isinstance(mappings, ast.Dict) or UNKNOWN in file:
            return None
        names = []
        for key in mappings.keys:
            if isinstance(key, ast.Constant) and isinstance(key.value, str):
                span = self._span(key)
                written = self._source.text[span.start : span.end]
                inner = written.find(key.value) if key.value else -1
                start = span.start + max(inner, 0)
                names.append(
                    (key.value, Span(start, start + len(key.value)) if inner > 0 else span)
                )
        return XacroCall(file, self._span(node), tuple(names))

    def _text(self, node: ast.expr, depth: int) -> Text:
        """Return the text that *node* stands for, with `UNKNOWN` for what is not known."""
        found: Text | None = None
        if depth <= 0:
            return NOT_KNOWN
        if isinstance(node, ast.Constant) and isinstance(node.value, str):
            found = node.value, self._places(node, node.value)
        elif isinstance(node, (ast.List, ast.Tuple, ast.JoinedStr)):
            parts = node.values if isinstance(node, ast.JoinedStr) else node.elts
            found = _concatenated(self._text(each, depth - 1) for each in parts)
        elif isinstance(node, ast.FormattedValue):
            found = self._unplaced(node.value, depth)
        elif isinstance(node, ast.BinOp):
            found = self._operation(node, depth)
        elif isinstance(node, ast.Name):
            found = self._variable(node.id, depth)
        elif isinstance(node, ast.Attribute) and node.attr == "parent":
            found = _parent(self._text(node.value, depth - 1)[0])
        elif isinstance(node, ast.Call):
            found = self._called(node, depth)
        return NOT_KNOWN if found is None else found

    def _operation(self, node: ast.BinOp, depth: int) -> Text | None:
        parts = [self._text(each, depth - 1) for each in (node.left, node.right)]
        if isinstance(node.op, ast.Add):
            return _concatenated(parts)
        return _joined(part for part, _ in parts) if isinstance(node.op, ast.Div) else None

    def _variable(self, name: str, depth: int) -> Text | None:
        if name == "__file__":
            return _plain(f"{HERE}__file__")
        value = self._assigned.get(name)
        return None if value is None else self._text(value, depth - 1)

    def _unplaced(self, node: ast.expr, depth: int) -> Text:
        return _plain(self._text(node, depth - 1)[0])

    def _called(self, node: ast.Call, depth: int) -> Text | None:
        """Return the path or text that the call *node* makes."""
        name, owner = _name(node.func), getattr(node.func, "value", None)
        given = [*node.args, *(each.value for each in node.keywords)]
        if not given:
            if name not in SAME or not isinstance(owner, ast.expr):
                return None
            return self._unplaced(owner, depth)
        if name in JOINS:
            parts = given[0].elts if isinstance(given[0], (ast.List, ast.Tuple)) else given
            parts = [owner, *parts] if name == "joinpath" and owner is not None else parts
            return _joined(self._text(each, depth - 1)[0] for each in parts)
        first = self._text(given[0], depth - 1)[0]
        if name in SHARES and UNKNOWN not in first:
            return _plain(f"{SHARE}{first}")
        if name == "dirname":
            return _parent(first)
        return _plain(first) if name in SAME else None

    @cached_property
    def _assigned(self) -> dict[str, ast.expr]:
        """The values of names that are assigned once in the file."""
        return {
            node.targets[0].id: node.value
            for node in (ast.walk(self._tree) if self._tree is not None else ())
            if isinstance(node, ast.Assign)
            and isinstance(node.targets[0], ast.Name)
            and len(node.targets) == 1
            and self._stored[node.targets[0].id] == 1
        }

    @cached_property
    def _stored(self) -> dict[str, int]:
        """Number of times that each name is bound."""
        counts: dict[str, int] = {}
        for node in ast.walk(self._tree) if self._tree is not None else ():
            name = None
            if isinstance(node, ast.Name) and not isinstance(node.ctx, ast.Load):
                name = node.id
            elif isinstance(node, ast.arg):
                name = node.arg
            if name is not None:
                counts[name] = counts.get(name, 0) + 1
        return counts

    def _places(self, node: ast.expr, value: str) -> list[int]:
        """Return the offsets of the characters of a literal that is written as it reads."""
        span = self._span(node)
        written = self._source.text[span.start : span.end]
        if written[1:-1] == value and written[:1] in "\"'":
            return list(range(span.start + 1, span.end - 1))
        return [-1] * len(value)

    def _span(self, node: ast.expr) -> Span:
        start = self._offset(node.lineno, node.col_offset)
        if node.end_lineno is None or node.end_col_offset is None:
            return Span(start, start)
        return Span(start, self._offset(node.end_lineno, node.end_col_offset))

    def _offset(self, line: int, column: int) -> int:
        """Return the offset of *column*, in bytes of UTF-8, on *line*."""
        starts = self._lines
        start = starts[min(line, len(starts)) - 1]
        text = self._source.text[start : start + column]
        return start + (
            column if text.isascii() else len(text.encode()[:column].decode("utf-8", "ignore"))
        )

    @cached_property
    def _lines(self) -> list[int]:
        """Offsets at which lines begin, as Python counts them."""
        text = self._source.text
        found = [0]
        for at, each in enumerate(text):
            if each == "\n" or (each == "\r" and text[at + 1 : at + 2] != "\n"):
                found.append(at + 1)
        return found


def _plain(text: str) -> Text:
    return text, [-1] * len(text)


def _nothing(_node: ast.Call) -> XacroCall | None:
    return None


def _name(node: ast.expr) -> str:
    return node.id if isinstance(node, ast.Name) else getattr(node, "attr", "")


def _keyword(node: ast.Call, name: str) -> ast.expr | None:
    return next((each.value for each in node.keywords if each.arg == name), None)


def _concatenated(parts: Iterable[Text]) -> Text:
    every = [*parts]
    return "".join(text for text, _ in every), [at for _, places in every for at in places]


def _joined(parts: Iterable[str]) -> Text:
    path = ""
    for part in parts:
        if UNKNOWN in part:
            return NOT_KNOWN
        path = part if "://" in part or part.startswith("/") or not path else f"{path}/{part}"
    return _plain(path)


def _parent(path: str) -> Text:
    above = UNKNOWN
    if path.startswith(HERE):
        inner = path.removeprefix(HERE)
        above = HERE if inner == "__file__" else f"{HERE}{inner}/.."
    return _plain(above)
