"""Messages as SARIF splits them: a template with numbered placeholders, and its arguments.

A template's placeholders (`'{?value}'`) become `'{0}'`, `'{1}'` in the order of their first
appearance. Brackets are escaped, since `[text](1)` is a link to a related location
(SARIF 2.1.0, 3.11.5 and 3.11.6).
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import partial
from typing import NamedTuple

from kinlint.model import PLACEHOLDER, Finding

RELATED_LOCATIONS = 10
"""Number of related locations that are linked; GitHub shows no others."""
_PLACEHOLDER = re.compile(f"'?{PLACEHOLDER.pattern}'?")
_BRACKET = re.compile(r"(\\*)([\[\]])")


class Message(NamedTuple):
    """`template` filled with `arguments` is `text`."""

    template: str
    arguments: tuple[str, ...]

    @property
    def text(self) -> str:
        """The message as people read it."""
        return _filled(self.template, self.arguments)


def message_of(finding: Finding) -> Message:
    """The message of *finding*, with links to its related locations, numbered from one."""
    template, arguments = _worded(finding)
    links = []
    for number, related in enumerate(finding.related[:RELATED_LOCATIONS], 1):
        place = f"{related.location.source.name}:{related.location.start.line}"
        links.append(f"['{{{len(arguments)}}}']({number})")
        arguments = (*arguments, escaped(place))
    if links:
        template += f" See {', '.join(links)}."
    return Message(template, arguments)


def message_template(template: str) -> str:
    """Convert *template* to a SARIF `messageString`.

    Numbered, quoted placeholders, a final period.
    """
    names: list[str] = []
    parts = []
    end = 0
    for match in _PLACEHOLDER.finditer(template):
        if match[1] not in names:
            names.append(match[1])
        parts.append(_literal(template[end : match.start()]))
        parts.append(f"'{{{names.index(match[1])}}}'")
        end = match.end()
    parts.append(_literal(template[end:]))
    text = "".join(parts).rstrip()
    text += "" if text.endswith(".") else "."
    return text if names else f"{text} Entity: '{{0}}'."


def escaped(text: str) -> str:
    """Escape the brackets in *text* that would make links."""
    return _BRACKET.sub(r"\1\1\\\2", text)


def _worded(finding: Finding) -> tuple[str, tuple[str, ...]]:
    """The template and its arguments; if they do not make the message, one that does.

    So it is with a message that an engine filled in: as a template it would serve once.
    """
    template, message = finding.template, finding.message
    names = list(dict.fromkeys(_PLACEHOLDER.findall(template)))
    if not names and template == message and template in finding.rule.messages:
        return message_template(template), (escaped(finding.entity),)
    if names and len(names) == len(finding.arguments):
        values = dict(zip(names, finding.arguments, strict=True))
        if _PLACEHOLDER.sub(partial(_in_place, values), template) == message:
            return message_template(template), tuple(map(escaped, finding.arguments))
    return "'{0}' Entity: '{1}'.", (escaped(message), escaped(finding.entity))


def _in_place(values: Mapping[str, str], match: re.Match[str]) -> str:
    """The value of a placeholder, between the quotes that the template has round it."""
    opening, closing = match[0].startswith("'"), match[0].endswith("'")
    return "'" * opening + values[match[1]] + "'" * closing


def _literal(text: str) -> str:
    return escaped(text).replace("{", "{{").replace("}", "}}")


def _filled(template: str, arguments: tuple[str, ...]) -> str:
    def part(match: re.Match[str]) -> str:
        return match[0][0] if match[1] is None else arguments[int(match[1])]

    return re.sub(r"\{\{|\}\}|\{(\d+)\}", part, template)
