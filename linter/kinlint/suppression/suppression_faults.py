"""Findings about suppressions, of the rules in `rules/lint/`.

Those rules have no SHACL check, since no graph tells what a run found; their files say
`kl:reportedBy kl:suppression` and hold everything else: code, reason, severity, messages.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from kinlint.configuration.selection import Policies
from kinlint.finding import Finding
from kinlint.light_dataclasses import dataclass
from kinlint.rule import PLACEHOLDER, Rule
from kinlint.suggestion import nearest
from kinlint.suppression.directive import Directive
from kinlint.terms import iri_value, is_iri

UNUSED = "unused-suppression"
UNKNOWN = "suppression-of-unknown-rule"
UNREASONED = "suppression-without-reason"
EXPIRED = "expired-suppression"
FAULTS = (UNUSED, UNKNOWN, UNREASONED, EXPIRED)
"""The names of the rules that these findings belong to."""


@dataclass(frozen=True, slots=True)
class SuppressionFault:
    """A fault of a directive."""

    rule: str
    """The name of the rule that reports it."""
    directive: Directive
    """The directive."""
    values: Mapping[str, str]
    """Values for the message of the rule."""


def faults(
    directives: Iterable[Directive], used: frozenset[Directive], policies: Policies
) -> Iterator[SuppressionFault]:
    """Yield the faults of *directives*, of which *used* silenced something."""
    for one in directives:
        named = {"rule": one.selector} if one.selector else {}
        if not one.codes:
            suggestion = nearest(one.selector, policies.catalogue.selectors)
            yield SuppressionFault(
                UNKNOWN, one, named | ({"suggestion": suggestion} if suggestion else {})
            )
        elif one.until is not None and not one.active:
            key = "until" if _is_date(one.until) else "written"
            yield SuppressionFault(EXPIRED, one, named | {key: one.until})
        elif one not in used and _could_be_used(one, policies):
            yield SuppressionFault(UNUSED, one, named)
        if (
            one.reason is None
            and policies.settings.for_file(one.document.source.name).require_reason
        ):
            yield SuppressionFault(UNREASONED, one, named)


def fault_finding(fault: SuppressionFault, rules: Mapping[str, Rule]) -> Finding | None:
    """The finding that states *fault*; None if the catalogue lacks its rule."""
    rule = rules.get(fault.rule)
    if rule is None:
        return None
    message, template, arguments = fill_message(rule, fault.values)
    one = fault.directive
    return Finding(
        rule=rule,
        severity=rule.severity,
        message=message,
        location=one.document.location(one.span),
        iri=iri_value(one.node) if is_iri(one.node) else one.node,
        focus=one.node,
        path=one.statement[1],
        value=one.statement[2],
        template=template,
        arguments=arguments,
    )


def fill_message(rule: Rule, values: Mapping[str, str]) -> tuple[str, str, tuple[str, ...]]:
    """The message of *rule* that says most of *values*, its template, and what fills that."""
    template = _template(rule, values)
    names = dict.fromkeys(PLACEHOLDER.findall(template))
    message = PLACEHOLDER.sub(lambda found: values[found[1]], template)
    return message, template, tuple(values[name] for name in names)


def _template(rule: Rule, values: Mapping[str, str]) -> str:
    """The message of *rule* that says most of *values* and nothing else."""
    sayable = [text for text in rule.messages if set(PLACEHOLDER.findall(text)) <= set(values)]
    return max(sayable, key=lambda text: len(PLACEHOLDER.findall(text)), default=rule.title)


def _could_be_used(directive: Directive, policies: Policies) -> bool:
    """Tell whether a rule that *directive* names was enabled in this run."""
    names = (directive.document.source.name, *policies.settings.files)
    return bool(directive.codes & policies.enabled(names))


def _is_date(text: str) -> bool:
    from datetime import date  # noqa: PLC0415  few models have such a day

    try:
        date.fromisoformat(text)
    except ValueError:
        return False
    return True
