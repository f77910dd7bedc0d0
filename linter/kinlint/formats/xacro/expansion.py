"""Result of expanding a xacro file: the robot and remarks, or the fault and its place."""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator, Mapping
from types import FrameType, TracebackType

from kinlint.formats.xacro.dom import Element, VisitRecord
from kinlint.formats.xacro.expansion_limits import Refused
from kinlint.formats.xacro.substitution import UnknownSubstitution
from kinlint.formats.xacro.xacro_parser import Malformed, ParsedXacro
from kinlint.light_dataclasses import dataclass, field
from kinlint.text import SourceText, Span

STRANGE = "the macro has no parameter"
WORDS = (
    (r"unknown macro name: (?:xacro:)?(.*)", "there is no macro '{0}'"),
    (r'Invalid parameter "(.*)"', STRANGE + " '{0}'"),
    (r"Undefined parameters \[(.*)\]", "the macro is called without '{0}'"),
    (r"Not enough blocks", "the macro is called without a block that it needs"),
    (r'Unused block "(.*)"', "the macro takes no block like '{0}'"),
    (r'Undefined block "(.*)"', "there is no block '{0}' here"),
    (r"Undefined property to forward: (.*)", "there is no property '{0}' to forward"),
    (r"(\S+): missing attribute '(.*)'", "element '{0}' lacks the attribute '{1}'"),
    (r"(\S+): empty name", "element '{0}' has an empty name"),
    (r"Invalid use of macro name 'call'", "no macro may be called 'call'"),
    (r"macro names must not contain '\.' .*: (.*)", "the name of macro '{0}' has a dot"),
    (
        r"Property names must be valid python identifiers: ?(.*)",
        "'{0}' is not a valid property name",
    ),
    (
        r"Property names must not start with double underscore: ?(.*)",
        "the name of property '{0}' begins with two underscores",
    ),
    (
        r"Property attributes default, value, and remove are mutually exclusive: (.*)",
        "property '{0}' has more than one of default, value and remove",
    ),
    (
        r'Xacro conditional "(.*)" evaluated to "(.*)", which is not a boolean expression\.',
        "the condition '{0}' is '{1}', which is neither true nor false",
    ),
    (r"'dict' object has no attribute '_setitem'", "there is no scope around this one"),
    (r"circular variable definition: (.*?) Consider.*", "properties define each other: {0}"),
)
"""Patterns of xacro's messages with the messages that replace them."""
BY_NAME = ("grab_macro", "grab_property", "eval_all")
"""Functions of xacro that complain about what is in the attribute `name`."""
MALFORMED = "malformed"
CALLING = ("handle_macro_call", "handle_dynamic_macro_call", "resolve_macro")


class Failure(Exception):
    """An expansion cannot go on; `kind` and `name` say what is unknown here, if that is why."""

    def __init__(self, reason: str, kind: str = "", name: str = "") -> None:
        super().__init__(reason)
        self.kind = kind
        self.name = name


@dataclass(frozen=True)
class Fault:
    """Failure of an expansion."""

    reason: str
    """The fault, in words."""
    source: SourceText
    """The text."""
    span: Span
    """The place in the text."""
    kind: str = ""
    """Kind of an unknown name, if that is the cause."""
    name: str = ""
    """The unknown name."""


REDEFINED = "redefining global symbol: "
WITHHELD = "environment variable: "
NAMED = (REDEFINED, WITHHELD)
"""Beginnings of remarks that end with a name: of a symbol of xacro itself, and of a variable."""


@dataclass(frozen=True)
class Remark:
    """Warning of xacro."""

    message: str
    """The warning."""
    source: SourceText
    """The text."""
    span: Span
    """The place in the text."""
    kind: str = ""
    """One of `NAMED` if the remark is about a name."""
    name: str = ""
    """The name."""


@dataclass
class Expansion:
    """Expansion of a file."""

    parsed: ParsedXacro
    """The robot, unless there is a fault."""
    files: Mapping[int, ParsedXacro]
    """Files before the expansion, the main one first."""
    includes: list[tuple[Element, SourceText]] = field(default_factory=list)
    """Elements that had files included, each with one of them."""
    remarks: list[Remark] = field(default_factory=list)
    """Warnings of xacro."""
    fault: Fault | None = None
    """Error that ended the expansion; None if it succeeded."""
    missing: list[Fault] = field(default_factory=list)
    """Packages that are not found, each where it is named first."""
    omitted: list[Element] = field(default_factory=list)
    """Elements that were left out, since they need such a package."""


def message(error: BaseException) -> str:
    """Return the message of *error*, in one line."""
    if isinstance(error, KeyError) and error.args:
        return f"there is no '{error.args[0]}'"
    if isinstance(error, SyntaxError):
        return error.msg
    if isinstance(error, Refused):
        return f"it contains {error}, which kinlint does not evaluate"
    text = " ".join(str(error).split()) or type(error).__name__
    for pattern, words in WORDS:
        if match := re.fullmatch(pattern, text):
            return words.format(*match.groups())
    return text


def expansion_fault(error: Exception, watch: VisitRecord, main: SourceText) -> Fault:
    """Return the fault of *error*, which ended an expansion of *main*, with its place."""
    if isinstance(error, Malformed):
        end = min(error.offset + 1, len(error.source.text))
        return Fault(str(error), error.source, Span(error.offset, end), MALFORMED)
    frames = list(_frames(error.__traceback__))
    calls = _calls(frames)
    if isinstance(error, RecursionError):
        return _endless(_calls(frames), watch, main)
    source, span = _place(frames, watch, main, message(error))
    if calls and calls[-1] is _blamed(frames, watch):
        calls.pop()
    reason = message(error) + _through(calls)
    known = error if isinstance(error, UnknownSubstitution | Failure) else Failure("")
    return Fault(reason, source, span, known.kind, known.name)


def _frames(traceback: TracebackType | None) -> Iterator[FrameType]:
    while traceback is not None:
        yield traceback.tb_frame
        traceback = traceback.tb_next


def _calls(frames: list[FrameType]) -> list[Element]:
    """Return the calls of macros that are under way, the outermost first."""
    found = [f.f_locals.get("node") for f in frames if f.f_code.co_name == "handle_macro_call"]
    return [node for node in found if isinstance(node, Element)]


def _blamed(frames: list[FrameType], watch: VisitRecord) -> Element | None:
    """Return the element that the failing function worked on, or else the last one looked at."""
    if frames and frames[-1].f_code.co_name in CALLING:
        node = frames[-1].f_locals["node"]
        return node if isinstance(node, Element) else None
    return watch.element if watch.text is None else None


def _place(
    frames: list[FrameType], watch: VisitRecord, main: SourceText, reason: str = ""
) -> tuple[SourceText, Span]:
    """Return the place that the function that failed worked on, or else the one looked at last."""
    if frames and frames[-1].f_code.co_name == "eval_default_arg":
        frames = frames[:-1]
    if frames:
        name, local = frames[-1].f_code.co_name, frames[-1].f_locals
        if name in CALLING:
            return _at(local["node"], local["name"] if reason.startswith(STRANGE) else None)
        if name in BY_NAME:
            return _at(local.get("node") or local["elt"], "name")
        if name == "reqd_attrs":
            return _at(local["tag"], None)
    return last_place(watch, main)


def last_place(watch: VisitRecord, main: SourceText) -> tuple[SourceText, Span]:
    """Return the place of the attribute, text or element that xacro looked at last."""
    if watch.text is not None and watch.text.origin is not None:
        return watch.text.origin.source, watch.text.origin.stripped
    if watch.element is None:
        return main, Span(0, min(1, len(main.text)))
    return _at(watch.element, watch.attribute)


def _at(element: Element, attribute: str | None) -> tuple[SourceText, Span]:
    return element.origin.source, element.span_of(attribute)


def _endless(calls: list[Element], watch: VisitRecord, main: SourceText) -> Fault:
    if not calls:
        source, span = last_place(watch, main)
        return Fault("definitions refer to each other without end", source, span)
    again = Counter(call.tagName for call in calls).most_common(1)[0][0]
    call = next(call for call in reversed(calls) if call.tagName == again)
    source, span = _at(call, None)
    name = again.removeprefix("xacro:")
    return Fault(f"macro '{name}' calls itself without end", source, span)


def _through(calls: list[Element]) -> str:
    """Describe the innermost macro call that led to the failure."""
    if not calls:
        return ""
    origin = calls[-1].origin
    line = origin.source.position(origin.start).line
    name = calls[-1].tagName.removeprefix("xacro:")
    return f", in macro '{name}' called at {origin.source.name}:{line}"
