"""Calls of xacro in launch files in XML and YAML: commands in attributes and values."""

from __future__ import annotations

import re
from collections.abc import Iterator

from kinlint.formats.launch.xacro_call import HERE, SHARE, UNKNOWN, XacroCall, command_call
from kinlint.text import Span

_COMMENT = re.compile(r"<!--.*?(?:-->|\Z)|(?m:(?:^|(?<=\s))#[^\r\n]*)", re.DOTALL)
_QUOTED = re.compile(r"(?:command|value)\s*[=:]\s*(?:\"([^\"]*)\"|'([^']*)')")
_SUBSTITUTION = re.compile(
    r"(?P<loader>\$\(find\s+xacro\s*\)/)"
    r"|\$\(find(?:-pkg-share)?\s+(?P<package>[\w.-]+)\s*\)"
    r"|(?P<directory>\$\(dirname\)/?)"
    r"|(?P<command>\$\(command\s*|&quot;|&apos;)"
    r"|(?P<value>\$\((?:[^()]|\([^()]*\))*\))"
)
_STANDING: dict[str | None, str] = {
    "loader": "", "directory": HERE, "command": " ", "value": UNKNOWN,
}  # fmt: skip
"""Texts that substitutions stand for."""


def markup_calls(text: str, *, xml: bool) -> Iterator[XacroCall]:
    """Yield the calls in the *text* of a launch file."""
    for match in _QUOTED.finditer(_blanked(text, xml=xml)):
        group = 1 if match[1] is not None else 2
        if "xacro" in match[group]:
            call = _call(match[group], match.start(group), Span(*match.span(group)))
            if call is not None:
                yield call


def _blanked(text: str, *, xml: bool) -> str:
    """Return *text* with spaces for its comments."""

    def blank(match: re.Match[str]) -> str:
        return " " * len(match[0]) if match[0].startswith("<" if xml else "#") else match[0]

    return _COMMENT.sub(blank, text)


def _call(written: str, start: int, whole: Span) -> XacroCall | None:
    """Return the call in *written*, a value at *start*, with substitutions as far as known."""
    pieces: list[tuple[str, int]] = []
    at = 0
    while at < len(written):
        match = _SUBSTITUTION.match(written, at)
        if match is None:
            pieces.append((written[at], start + at))
            at += 1
            continue
        said = f"{SHARE}{match['package']}" if match["package"] else _STANDING[match.lastgroup]
        pieces += [(each, -1) for each in said]
        at = match.end()
    joined = "".join(each for each, _ in pieces).rstrip(") ")
    return command_call(joined, [place for _, place in pieces], whole)
