"""Commands to terminals and CI systems that texts of files could smuggle into a log.

Runners read the logs of their jobs: GitHub takes a line that begins with `::name` for a command,
and, as Azure and TeamCity do, what follows `##[`, `##vso[` or `##teamcity[` anywhere in a line.
Terminals obey control characters, some of them those of ISO 8859 as well. Bidirectional controls
show text in another order than it has (https://trojansource.codes).
"""

from __future__ import annotations

import re

_CONTROL = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f\u061c\u200e\u200f\u2028-\u202e\u2066-\u2069]")
_COMMAND = re.compile(r"^([^\S\n]*):(?=:[^:])|(?<=#)()#(?=\w*\[)", re.MULTILINE)

UNICODE = r"\u{:04x}"
"""A character as JSON, Turtle and texts for people escape it."""
ENTITY = "&#{};"
"""The same in XML, HTML and Markdown."""


def without_commands(text: str, escape: str) -> str:
    """Return *text* with a character of each command to a CI system written by *escape*."""
    return _COMMAND.sub(lambda match: (match[1] or "") + escape.format(ord(match[0][-1])), text)


def without_controls(text: str, escape: str) -> str:
    """Return *text* with control characters, but for line feeds and tabs, written by *escape*."""
    return _CONTROL.sub(lambda match: escape.format(ord(match[0])), text)
