"""Suppressions in the configuration (`settings.Ignore`), and those that silence nothing."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from kinlint.addresses import is_address
from kinlint.configuration.selection import Policies
from kinlint.configuration.settings import Ignore
from kinlint.finding import Finding
from kinlint.light_dataclasses import dataclass, field, replace
from kinlint.rule import Rule
from kinlint.suppression import json_pointer
from kinlint.suppression.suppression_faults import UNUSED, fill_message
from kinlint.terms import iri
from kinlint.text import Location, Span


@dataclass(frozen=True)
class ConfigIgnores:
    """The ignores of a run; remembers which of their selectors silenced something."""

    policies: Policies
    """The policies of each file."""
    _used: set[tuple[Ignore, str]] = field(default_factory=set)
    _places: dict[tuple[str, str], Span | None] = field(default_factory=dict)

    def mark_silenced(self, findings: Iterable[Finding]) -> list[Finding]:
        """Return *findings* with those marked that the configuration silences."""
        out = []
        for finding in findings:
            name = finding.location.source.name
            for ignore in self.policies.settings.for_file(name).ignores:
                selector = self._selector(ignore, finding)
                if finding.suppressed is None and selector is not None:
                    self._used.add((ignore, selector))
                    justification = f"ignored by {ignore.origin}: {ignore.key}"
                    finding = replace(finding, suppressed=justification)  # noqa: PLW2901
            out.append(finding)
        return out

    def unused(self, files: Iterable[str], rules: Mapping[str, Rule]) -> Iterator[Finding]:
        """A finding for each selector that silenced nothing on an entity or at a pointer.

        Whole files are none: what is ignored in many of them need not be in all. *files* are the
        names of those read; *rules* are found by name.
        """
        governed: dict[Ignore, list[str]] = {}
        for name in files:
            for ignore in self.policies.settings.for_file(name).ignores:
                if ignore.iri is not None or ignore.pointer is not None:
                    governed.setdefault(ignore, []).append(name)
        for ignore, names in governed.items():
            enabled = self.policies.enabled(names)
            for selector in ignore.selectors:
                known = self._codes(selector) & enabled
                if ignore.place is None or not known or (ignore, selector) in self._used:
                    continue
                if UNUSED in rules:
                    yield from self.policies.apply_severities(
                        [_finding(rules[UNUSED], ignore, selector)]
                    )

    def _selector(self, ignore: Ignore, finding: Finding) -> str | None:
        """The selector of *ignore* that silences *finding*, if one does."""
        named = (one for one in ignore.selectors if finding.rule.code in self._codes(one))
        selector = next(named, None)
        if selector is None:
            return None
        if ignore.iri is not None:
            meant = iri(ignore.iri) == finding.focus or ignore.iri == finding.iri
        else:
            meant = ignore.pointer is None or self._covers(ignore.pointer, finding)
        return selector if meant else None

    def _codes(self, selector: str) -> frozenset[str]:
        return self.policies.catalogue.find(selector)[1]

    def _covers(self, path: str, finding: Finding) -> bool:
        """Tell whether *finding* is in the value or element at *path*, its key included.

        *path* is a JSON Pointer (RFC 6901), or the path of an XML element, as in
        `/link/base/inertial`.
        """
        if is_address(finding.iri):
            _, _, address = finding.entity.partition("#")
            if f"{address}/".startswith(f"{path}/"):
                return True
        source, span = finding.location.source, finding.location.span
        key = (source.name, path)
        if key not in self._places:
            place = json_pointer.locate(source.text, path)
            self._places[key] = place and place.member
        whole = self._places[key]
        return whole is not None and whole.start <= span.start and span.end <= whole.end


def _finding(rule: Rule, ignore: Ignore, selector: str) -> Finding:
    assert ignore.place is not None
    message, template, arguments = fill_message(rule, {"rule": selector, "place": ignore.key})
    return Finding(
        rule=rule,
        severity=rule.severity,
        message=message,
        location=Location(*ignore.place),
        iri=ignore.iri or "",
        focus=iri(ignore.iri) if ignore.iri is not None else "",
        template=template,
        arguments=arguments,
    )
