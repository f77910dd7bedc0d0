"""Lets the `xacro` package expand a file, with what it reads, evaluates and says in our hands.

The package keeps its state in its module and calls its own functions by their global names. For
the time of one expansion some of these names stand for ours: files are read into our tree,
expressions are walked instead of given to Python, and warnings are collected.
"""

from __future__ import annotations

import sys
from collections.abc import Collection, Iterator, Mapping
from fnmatch import fnmatch
from pathlib import Path
from threading import Lock
from typing import Any, TypeAlias

from kinlint.errors import SourceError
from kinlint.files.bounded_read import Unreadable
from kinlint.files.environment import listing
from kinlint.files.packages import Packages
from kinlint.files.pathglob import MAGIC, absolute
from kinlint.formats.xacro import yaml_table
from kinlint.formats.xacro.dom import Element, Text, VisitRecord
from kinlint.formats.xacro.expansion import (
    NAMED,
    REDEFINED,
    WITHHELD,
    Expansion,
    Failure,
    Fault,
    Remark,
    expansion_fault,
    last_place,
)
from kinlint.formats.xacro.expansion_limits import LimitExceeded, Limits, Refused
from kinlint.formats.xacro.expression import Members, evaluate
from kinlint.formats.xacro.expression_symbols import dotted, symbols, tokenize
from kinlint.formats.xacro.included_files import Pieces, table
from kinlint.formats.xacro.kept_comments import comment_remover, inherit
from kinlint.formats.xacro.origin import Origin
from kinlint.formats.xacro.substitution import Substitution, UnknownSubstitution
from kinlint.formats.xacro.text_evaluation import TextEvaluator
from kinlint.formats.xacro.xacro_package import Included, replaced, reqd_attrs, xacro_package
from kinlint.formats.xacro.xacro_parser import ParsedXacro, parse
from kinlint.light_dataclasses import dataclass, field
from kinlint.text import SourceText

PACKAGE_URI = "package://"
INCLUDES = 40
"""Maximum depth of includes."""
_ONE_AT_A_TIME = Lock()
Omitted: TypeAlias = frozenset[tuple[str, int]]
"""Elements that are left out, by the names of their files and their offsets there."""


@dataclass
class Session:
    """Expansion of the main file of `pieces` with `arguments`."""

    pieces: Pieces
    """Files of the expansion, the main one first."""
    arguments: Mapping[str, str]
    """Values of arguments by name."""
    packages: Packages
    """Packages that `$(find)` looks up."""
    variables: Collection[str] = ()
    """Environment variables that the files may ask for, besides those of ROS."""
    bounds: Limits = field(default_factory=Limits)
    """Limits of the work that it may do."""
    omitted: Omitted = frozenset()
    """Elements that are left out."""

    def __post_init__(self) -> None:
        self._xacro = xacro_package()
        self._watch = VisitRecord(self.bounds)
        self._open = [self.pieces.path]
        self._files: dict[int, ParsedXacro] = {}
        self._tables: dict[Path, Any] = {}
        self._remarks: list[Remark] = []
        self._missing: list[Fault] = []
        self._includes: list[tuple[Element, SourceText]] = []
        self._including = self._watch.element
        self._substitution = Substitution(
            dict(self.arguments),
            self._find,
            self._directory,
            lambda expression, names: evaluate(expression, {**self._known, **names}, self.bounds),
            self.variables,
            lambda name: self._add_remark(WITHHELD + name),
        )
        self._texts = TextEvaluator(self.bounds, self._substitution.value)
        self._known = symbols(self.bounds, self._own())

    def expand(self) -> Expansion:
        """Return the robot that the file stands for."""
        result = Expansion(
            ParsedXacro(), self._files, self._includes, self._remarks, missing=self._missing
        )
        with _ONE_AT_A_TIME, replaced(self._xacro, self._replacements()):
            try:
                result.parsed = parse(self.pieces.main, self._watch)
                self._files[id(self.pieces.main)] = self._copy(result.parsed)
                self._omit(result.parsed.root)
                self._evaluate(result.parsed.root)
            except Exception as error:  # noqa: BLE001  whatever xacro raises is about the file
                result.fault = expansion_fault(error, self._watch, self.pieces.main)
        return result

    def _evaluate(self, root: Element | None) -> None:
        assert root is not None
        xacro = self._xacro
        namespace = root.getAttribute("xacro:targetNamespace")
        if namespace:
            root.removeAttribute("xacro:targetNamespace")
            root.setAttribute("xmlns", namespace)
        xacro.eval_all(root, xacro.Table(), xacro.Table(self._known))

    def _replacements(self) -> Mapping[str, Any]:
        xacro = self._xacro
        origin = Origin(self.pieces.main, 0, 0)
        stop = Text("\n\n", origin, self._watch)

        class Space(xacro.Table, Members):  # type: ignore[misc, name-defined]
            """The properties of a file that is included under a name."""

            def member(self, name: str) -> Any:
                try:
                    return self[name]
                except KeyError:
                    raise NameError(f"name '{name}' is not defined") from None

        return {
            "NameSpace": Space,
            "all_includes": [],
            "error": self._remark,
            "eval_text": self._texts.evaluate,
            "filestack": [str(self.pieces.path)],
            "get_include_files": self._included,
            "macrostack": [],
            "message": self._remark,
            "parse": self._parse,
            "print_location": lambda: "",
            "remove_previous_comments": comment_remover(stop),
            "reqd_attrs": self._required,
            "substitution_args_context": {"arg": self._substitution.arguments},
            "verbosity": 0,
            "warning": self._remark,
        }

    def _own(self) -> Mapping[str, Any]:
        """Return the functions that files may call as `xacro.…`."""

        def warn(*words: Any, **_: Any) -> str:
            self._add_remark(" ".join(map(str, words)))
            return ""

        def fatal(*words: Any) -> str:
            raise Failure(" ".join(map(str, words)))

        return {
            "abs_filename": lambda name: str(self._resolved(str(name))),
            "arg": self._substitution.argument,
            "dotify": dotted,
            "error": warn,
            "fatal": fatal,
            "load_yaml": self._load_yaml,
            "message": lambda *_, **__: "",
            "print_location": lambda: "",
            "tokenize": tokenize,
            "warning": warn,
        }

    def _directory(self) -> Path:
        """Return the directory of the current file."""
        return Path(self._xacro.filestack[-1]).parent

    def _find(self, name: str) -> str:
        """Return the directory of a package; its URI if it is missing, which is recorded."""
        found = self.packages.find(name, self._directory())
        if found is not None:
            return str(found)
        source, span = last_place(self._watch, self.pieces.main)
        fault = Fault(f"package '{name}' is not known", source, span, "package", name)
        if all(each.name != name for each in self._missing):
            self._missing.append(fault)
        return f"{PACKAGE_URI}{name}"

    def _resolved(self, name: str) -> Path:
        if name.startswith(PACKAGE_URI):
            package = name.removeprefix(PACKAGE_URI).partition("/")[0]
            found = self.packages.find(package, self._directory())
            if found is None:
                raise UnknownSubstitution("package", package)
            return absolute(found / name.removeprefix(f"{PACKAGE_URI}{package}").lstrip("/"))
        return absolute(self._directory() / name)

    def _omit(self, root: Element | None) -> None:
        """Take the elements that are left out from *root*."""
        if root is None or not self.omitted:
            return
        for each in list(root.everything):
            origin = each.origin
            if each.parentNode and (origin.source.name, origin.start) in self.omitted:
                each.parentNode.removeChild(each)

    def _included(self, name: str, scope: Any) -> Iterator[str]:
        """Yield the paths of the files that an include names."""
        element = self._watch.element
        for path in self._named(name, scope):
            self._including = element
            yield str(path)

    def _named(self, name: str, scope: Any) -> Iterator[Path]:
        given = str(self._texts.evaluate(name, scope))
        path = self._resolved(given)
        if not MAGIC.search(given):
            yield path
            return
        if MAGIC.search(str(path.parent)):
            raise Refused("wildcards for directories")
        self.pieces.reach.require(path.parent)
        names = [each for each in listing(path.parent) if fnmatch(each, path.name)]
        if not names:
            self._add_remark(f"no file matches '{given}'")
        yield from (path.parent / each for each in names)

    def _parse(self, _: None, name: str) -> Any:
        """Return the tree of an included file, as what xacro takes for a document."""
        path = Path(name)
        if len(self._xacro.filestack) > INCLUDES:
            ring = name in self._xacro.filestack[:-1]
            raise LimitExceeded(
                f"'{path.name}' includes itself" if ring else "files include files without end"
            )
        try:
            source = self.pieces.text(path)
        except Unreadable as error:
            self._xacro.filestack.pop()
            if error.missing:
                raise self._xacro.XacroException(str(error), exc=FileNotFoundError()) from None
            raise Failure(str(error)) from None
        except SourceError as error:
            raise Failure(f"'{error.name}' cannot be read: {error.cause}") from None
        if self._including is not None:
            self._includes.append((self._including, source))
        if id(source) not in self._files:
            self._files[id(source)] = parse(source, self._watch)
        parsed = self._files[id(source)]
        root = self._copy(parsed).root
        self._omit(root)
        if root is not None:
            inherit(root, parsed)
        return Included(root)

    def _copy(self, parsed: ParsedXacro) -> ParsedXacro:
        copy = ParsedXacro()
        copy.root = None if parsed.root is None else parsed.root.cloneNode(deep=True)
        return copy

    def _load_yaml(self, name: str) -> Any:
        path = self._resolved(str(name))
        if path not in self._tables:
            self._tables[path] = yaml_table.load(
                table(path, self.pieces.reach),
                path.name,
                lambda text: evaluate(text, self._known, self.bounds),
                self.bounds,
            )
        return self._tables[path]

    def _required(self, tag: Element, names: list[str]) -> list[str]:
        """Check attributes as xacro does.

        Record an `xacro:attribute` in the element that it is for.
        """
        found = reqd_attrs(tag, names)
        if tag.tagName == "xacro:attribute" and tag.parentNode is not None:
            tag.parentNode.giver = tag.origin
        return found

    def _remark(self, *words: Any, **_: Any) -> None:
        local = sys._getframe(1).f_locals  # noqa: SLF001  only the caller knows the element
        self._add_remark(" ".join(map(str, words)), local.get("tag") or local.get("elt"))

    def _add_remark(self, message: str, element: Element | None = None) -> None:
        element = element or self._watch.element
        if element is None:
            return
        message = " ".join(message.split())
        kind = next((each for each in NAMED if message.startswith(each)), "")
        name = message.removeprefix(kind) if kind else ""
        source = element.origin.source
        span = element.span_of("name" if kind == REDEFINED else None)
        if kind == WITHHELD:
            source, span = last_place(self._watch, self.pieces.main)
        remark = Remark(message, source, span, kind, name)
        if remark not in self._remarks:
            self._remarks.append(remark)
