"""Rules as SARIF reporting descriptors, anti-patterns as a taxonomy."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any
from urllib.parse import quote

from kinlint.finding import Finding
from kinlint.light_dataclasses import replace
from kinlint.reporters.antipatterns import ANTIPATTERNS
from kinlint.reporters.rule_page import help_markdown, help_text, paragraphs
from kinlint.reporters.sarif.sarif_message import message_template
from kinlint.rule import Example, Rule, Severity
from kinlint.vocabulary import KINLINT, RULE

TAXONOMY = "kinlint-antipatterns"
EXAMPLES = 2
"""Number of examples in the help of a rule; `kinlint rule` shows all."""
TEXT_LENGTH = 1_024
"""GitHub cuts descriptions here."""
LEVELS = {Severity.ERROR: "error", Severity.WARNING: "warning", Severity.INFO: "note"}
_PROBLEMS = {
    Severity.ERROR: "error",
    Severity.WARNING: "warning",
    Severity.INFO: "recommendation",
}
_INDEX = {pattern.id: index for index, pattern in enumerate(ANTIPATTERNS)}


class Catalogue:
    """The rules of *findings* in the order of their codes, each with the messages it made."""

    def __init__(self, findings: Sequence[Finding]) -> None:
        rules = {finding.rule.code: finding.rule for finding in findings}
        self._rules = [rules[code] for code in sorted(rules)]
        self._formats: dict[str, set[str]] = {code: set() for code in rules}
        for finding in findings:
            if (form := finding.location.source.format) is not None:
                self._formats[finding.rule.code].add(form.name)
        self._indices = {rule.code: index for index, rule in enumerate(self._rules)}
        self._messages: dict[str, dict[str, str]] = {}
        for rule in self._rules:
            for template in rule.messages:
                self.message_id(rule, message_template(template))

    def index(self, rule: Rule) -> int:
        """Return the index of *rule* in `tool.driver.rules`."""
        return self._indices[rule.code]

    def message_id(self, rule: Rule, template: str) -> str:
        """The key of *template* among the message strings of *rule*."""
        messages = self._messages.setdefault(rule.code, {})
        return messages.setdefault(template, f"message{len(messages) + 1}")

    def descriptors(self) -> list[dict[str, Any]]:
        """`tool.driver.rules`, once all messages are known."""
        return [self._descriptor(rule) for rule in self._rules]

    def _descriptor(self, rule: Rule) -> dict[str, Any]:
        messages = self._messages.get(rule.code, {})
        why = "\n\n".join(paragraphs(rule.why))
        page = help_markdown(replace(rule, examples=self._examples(rule)))
        descriptor: dict[str, Any] = {
            "id": rule.code,
            "name": friendly_name(rule.name),
            "shortDescription": {"text": (rule.title or rule.name)[:TEXT_LENGTH]},
            "fullDescription": {"text": (why or rule.title or rule.name)[:TEXT_LENGTH]},
            "help": {"text": help_text(rule), "markdown": page},
            "helpUri": web_address(rule.iri),
            "defaultConfiguration": {"level": LEVELS[rule.severity]},
            "properties": {
                "precision": "high",
                "problem.severity": _PROBLEMS[rule.severity],
                "tags": ["robotics", rule.family.lower(), *map(str.lower, rule.antipatterns)],
            },
        }
        if messages:
            strings = {key: {"text": text} for text, key in messages.items()}
            descriptor["messageStrings"] = strings
        if taxa := taxon_references(rule):
            kinds = ["superset"]
            descriptor["relationships"] = [{"target": taxon, "kinds": kinds} for taxon in taxa]
        return descriptor

    def _examples(self, rule: Rule) -> Sequence[Example]:
        """Return a few examples of *rule*, in the formats of its findings if there are any."""
        formats = self._formats[rule.code]
        return sorted(rule.examples, key=lambda each: each.format not in formats)[:EXAMPLES]


def friendly_name(name: str) -> str:
    """A kebab-case name in Pascal case: words of a capital and at least one small character.

    Validators know no word of one letter, so it joins the word before it: `NotaRotation`.
    """
    parts = (part if len(part) == 1 else part.capitalize() for part in name.split("-"))
    joined = "".join(parts)
    if not joined[:1].isalpha():
        return f"Rule{joined}"
    return joined[0].upper() + joined[1:2].lower() + joined[2:]


def web_address(iri: str) -> str:
    """Return *iri* as a web address; user shapes may have any other IRI."""
    if not iri.startswith(("http://", "https://")):
        return RULE
    return quote(iri, safe="%:/?#[]@!$&'()*+,;=~")


def taxon_references(rule: Rule) -> list[dict[str, Any]]:
    """References to the anti-patterns of *rule* in the taxonomy."""
    component = {"name": TAXONOMY, "index": 0}
    return [
        {"id": pattern, "index": _INDEX[pattern], "toolComponent": component}
        for pattern in rule.antipatterns
        if pattern in _INDEX
    ]


def taxonomy() -> dict[str, Any]:
    """The `toolComponent` that describes the anti-patterns."""
    return {
        "name": TAXONOMY,
        "informationUri": KINLINT,
        "shortDescription": {"text": "Anti-patterns of robot description formats."},
        "isComprehensive": True,
        "taxa": [
            {
                "id": pattern.id,
                "name": pattern.name,
                "shortDescription": {"text": pattern.description},
                "helpUri": pattern.iri,
            }
            for pattern in ANTIPATTERNS
        ],
    }
