"""Text style of an output: colours, links, characters and width."""

from __future__ import annotations

import codecs
import os
from collections.abc import Mapping
from typing import Literal, TextIO, TypeAlias

from kinlint.light_dataclasses import dataclass
from kinlint.rule import Severity

When: TypeAlias = Literal["auto", "always", "never"]
Ink: TypeAlias = Literal["error", "warning", "info", "place", "note", "strong", "removed", "added"]

_INKS: Mapping[Ink, str] = {
    "error": "1;31",
    "warning": "1;33",
    "info": "1;36",
    "place": "1;34",
    "note": "32",
    "strong": "1",
    "removed": "31",
    "added": "32",
}
INK_OF: Mapping[Severity, Ink] = {
    Severity.ERROR: "error",
    Severity.WARNING: "warning",
    Severity.INFO: "info",
}
PLAIN_WIDTH = 140
LEAST_WIDTH = 40


@dataclass(frozen=True, slots=True)
class Style:
    """Capabilities of an output. Nothing is ever said by colour alone."""

    color: bool = False
    """True if the 16 ANSI colours may be used."""
    links: bool = False
    """True if OSC 8 links may be used."""
    unicode: bool = True
    """True if characters beyond ASCII may be used."""
    width: int = PLAIN_WIDTH
    """Width of the terminal in columns."""

    def ink(self, text: str, ink: Ink) -> str:
        """Return *text* in a colour, if colours may be used."""
        return f"\x1b[{_INKS[ink]}m{text}\x1b[0m" if self.color and text else text

    def link(self, text: str, url: str) -> str:
        """Return *text* as a link to *url* (the OSC 8 escape sequence), if links may be used."""
        return f"\x1b]8;;{url}\x1b\\{text}\x1b]8;;\x1b\\" if self.links and url else text


def detect_style(
    stream: TextIO, when: When = "auto", environment: Mapping[str, str] | None = None
) -> Style:
    """Return the style that *stream* can show.

    *when* decides over everything else, then NO_COLOR, then FORCE_COLOR and CLICOLOR_FORCE, then
    TERM=dumb, then whether the stream is a terminal (https://no-color.org,
    https://bixense.com/clicolors).
    """
    said = os.environ if environment is None else environment
    terminal = stream.isatty()
    dumb = said.get("TERM") == "dumb"
    color = when == "always" or (when == "auto" and _wants_color(said, terminal=terminal))
    return Style(
        color=color,
        links=color and terminal and not dumb,
        unicode=_shows_unicode(stream),
        width=max(_columns() if terminal else PLAIN_WIDTH, LEAST_WIDTH),
    )


def _columns() -> int:
    from shutil import get_terminal_size  # noqa: PLC0415  not needed for pipes

    return get_terminal_size((PLAIN_WIDTH, 24)).columns


def _wants_color(said: Mapping[str, str], *, terminal: bool) -> bool:
    if said.get("NO_COLOR"):
        return False
    if said.get("FORCE_COLOR", "0") not in {"", "0"}:
        return True
    if said.get("CLICOLOR_FORCE", "0") not in {"", "0"}:
        return True
    return terminal and said.get("TERM") != "dumb" and said.get("CLICOLOR") != "0"


def _shows_unicode(stream: TextIO) -> bool:
    encoding = getattr(stream, "encoding", None)
    if encoding is None:
        return True
    try:
        return codecs.lookup(encoding).name.startswith("utf")
    except LookupError:
        return False
