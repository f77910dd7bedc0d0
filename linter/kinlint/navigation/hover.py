"""Hover text of a place: the rule that is broken or ignored there, or the entity."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

from kinlint.finding import Finding
from kinlint.reporters import rule_page
from kinlint.reporters.sarif.rule_descriptors import web_address
from kinlint.rule import Rule
from kinlint.suppression.directive import Directive
from kinlint.text import Span

ACROSS = "\n\n---\n\n"
"""A line across."""
MOST_RULES = 3


class Hover(NamedTuple):
    """Text to show for a place."""

    markdown: str
    """Text to show."""
    span: Span
    """Place that it is about."""


def on_findings(findings: Sequence[Finding]) -> str:
    """Return the messages of *findings* at one place, each with the reason and a link."""
    return ACROSS.join(map(_on_finding, findings))


def _on_finding(finding: Finding) -> str:
    said = f"**{finding.severity.label}**: {finding.message}"
    if finding.suppressed is not None:
        said += f" ({finding.suppressed})"
    if finding.reason:
        said += f"  \nbecause {finding.reason}"
    rule = finding.rule
    return f"{said}  \n[{rule.code}]({web_address(rule.iri)}) {rule.title}"


def on_ignore(directive: Directive, rules: Sequence[Rule]) -> str:
    """Return the pages of *rules*, which *directive* silences."""
    why = f": {directive.reason}" if directive.reason else ""
    until = f", until {directive.until}" if directive.until else ""
    if not rules:
        return f"Ignores `{directive.selector}`, which names no rule{why}{until}"
    pages = [rule_page.markdown(rule_page.brief(rule)) for rule in rules[:MOST_RULES]]
    more = len(rules) - MOST_RULES
    rest = [f"and {more} more rules"] if more > 0 else []
    return ACROSS.join([f"Ignored here{why}{until}", *pages, *rest])
