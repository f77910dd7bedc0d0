"""Messages as SARIF splits them: a template with numbered placeholders, and its arguments.

A template's placeholders (`'{?value}'`) become `'{0}'`, `'{1}'` in the order of their first
appearance. Brackets are escaped, since `[text](1)` is a link to a related location
(SARIF 2.1.0, 3.11.5 and 3.11.6).
"""

from __future__ import annotations

import re
from typing import NamedTuple

from kinlint.finding import Finding
from kinlint.message_template import bare, filled
from kinlint.rule import PLACEHOLDER

RELATED_LOCATIONS = 10
"""Number of related locations that are linked; GitHub shows no others."""
_PLACEHOLDER = re.compile(f"'?{PLACEHOLDER.pattern}'?")
_BRACKET = re.compile(r"(\\*)([\[\]])")


class SarifMessage(NamedTuple):
    """A message in SARIF."""

    text: str
    """The message for people."""
    template: str
    """The same with placeholders."""
    arguments: tuple[str, ...]
    """Values of the placeholders."""


def sarif_message(finding: Finding) -> SarifMessage:
    """The message of *finding*, with links to its related locations, numbered from one."""
    template, arguments = _worded(finding)
    text = f"{escaped(finding.message.removesuffix('.'))}."
    places, links = [], []
    for number, related in enumerate(finding.related[:RELATED_LOCATIONS], 1):
        place = escaped(f"{related.location.source.name}:{related.location.start.line}")
        places.append(f"[{place}]({number})")
        links.append(f"['{{{len(arguments)}}}']({number})")
        arguments = (*arguments, place)
    if links:
        text += f" See {', '.join(places)}."
        template += f" See {', '.join(links)}."
    return SarifMessage(text, template, arguments)


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
    """The template and its arguments; if there are none, one that any message fits.

    So it is with a message that an engine filled in: as a template it would serve once.
    """
    template, message = finding.template, finding.message
    names = list(dict.fromkeys(_PLACEHOLDER.findall(template)))
    if not names and template == message and template in finding.rule.messages:
        return message_template(template), (escaped(finding.entity),)
    if names and len(names) == len(finding.arguments):
        words = dict(zip(names, finding.arguments, strict=True))
        if _plain(message).startswith(_plain(filled(template, words)).removesuffix(".")):
            return message_template(template), tuple(escaped(bare(each)) for each in words.values())
    return "'{0}' Entity: '{1}'.", (escaped(message), escaped(finding.entity))


def _plain(text: str) -> str:
    """Return *text* without quotes and capitals, which depend on the values filled in."""
    return text.replace("'", "").lower()


def _literal(text: str) -> str:
    return escaped(text).replace("{", "{{").replace("}", "}}")
