"""Findings as SARIF results, files that cannot be read as notifications."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from kinlint.addresses import is_address
from kinlint.edits import Edit
from kinlint.errors import SourceError
from kinlint.finding import Finding, Premise
from kinlint.reporters.hunk import edits_by_source
from kinlint.reporters.sarif.artifact_location import Artifacts
from kinlint.reporters.sarif.fingerprint import Fingerprints
from kinlint.reporters.sarif.line_hash import LineHashes
from kinlint.reporters.sarif.region import Regions
from kinlint.reporters.sarif.rule_descriptors import LEVELS, Catalogue, taxon_references
from kinlint.reporters.sarif.sarif_fix import anchored, fix_object
from kinlint.reporters.sarif.sarif_message import RELATED_LOCATIONS, escaped, sarif_message
from kinlint.rule import Applicability
from kinlint.text import Location, SourceText, Span

FLOW_LOCATIONS = 100
"""GitHub's limit for the steps of a derivation that its validator accepts."""


class Results:
    """Makes results; remembers what it computed for each source."""

    def __init__(self, artifacts: Artifacts, catalogue: Catalogue) -> None:
        self._artifacts = artifacts
        self._catalogue = catalogue
        self._fingerprints = Fingerprints()
        self._regions: dict[str, Regions] = {}
        self._hashes: dict[str, LineHashes] = {}

    def result(self, finding: Finding, *, silenced: bool = False) -> dict[str, Any]:
        """The `result` object of *finding*.

        *silenced* tells that some findings of the run are suppressed: then each must say
        whether it is (SARIF 2.1.0, 3.27.23).
        """
        rule, message = finding.rule, sarif_message(finding)
        result: dict[str, Any] = {
            "ruleId": rule.code,
            "ruleIndex": self._catalogue.index(rule),
            "level": LEVELS[finding.severity],
            "message": {
                "text": message.text,
                "id": self._catalogue.message_id(rule, message.template),
                "arguments": list(message.arguments),
            },
            "locations": [self._main(finding)],
            "partialFingerprints": {
                "kinlintFinding/v1": self._fingerprints.fingerprint(finding),
                "primaryLocationLineHash": self._line_hash(finding.location),
            },
        }
        if finding.related:
            result["relatedLocations"] = list(self._related(finding))
        if finding.because or finding.reason:
            result["codeFlows"] = [self._flow(finding)]
        if finding.consequences:
            told = [self._consequence(each) for each in finding.consequences]
            result["properties"] = {"kinlint/consequences": told}
        if taxa := taxon_references(rule):
            result["taxa"] = taxa
        if fixes := self._fixes(finding):
            result["fixes"] = fixes
        if silenced:
            result["suppressions"] = _suppressions(finding)
        return result

    def notification(self, error: SourceError) -> dict[str, Any]:
        """The `notification` of a file that cannot be read."""
        physical: dict[str, Any] = {"artifactLocation": self._artifacts.location(error.name)}
        if error.line is not None:
            physical["region"] = {"startLine": error.line}
            if error.column is not None:
                physical["region"]["startColumn"] = error.column
        return {
            "level": "error",
            "message": {"text": escaped(error.cause)},
            "locations": [{"physicalLocation": physical}],
        }

    def _fixes(self, finding: Finding) -> list[dict[str, Any]]:
        """Return the fixes of *finding* that can be written, the preferred first, each once."""
        made: list[dict[str, Any]] = []
        for fix in finding.fixes:
            if fix.applicability is not Applicability.DISPLAY:
                changes = [self._change(source, edits) for source, edits in edits_by_source(fix)]
                made += [each for each in [fix_object(fix, changes)] if each not in made]
        return made

    def _change(self, source: SourceText, edits: Sequence[Edit]) -> dict[str, Any]:
        """The `artifactChange` that makes *edits* in *source*."""
        regions = self._region(Location(source, Span(0, 0)))
        return {
            "artifactLocation": self._artifacts.location(source.name),
            "replacements": [
                {"deletedRegion": regions.exact(span), "insertedContent": {"text": text}}
                for span, text in anchored(source.text, edits)
            ],
        }

    def _main(self, finding: Finding) -> dict[str, Any]:
        place = self._place(finding.location)
        context = self._region(finding.location).context(finding.location.span)
        if context is not None:
            place["physicalLocation"]["contextRegion"] = context
        if is_address(finding.iri):
            _, _, address = finding.entity.partition("#")
            kind = "element"
        else:
            address, kind = finding.iri if finding.iri[:2] != "_:" else "", "object"
        if address:
            name = address.rstrip("/#").replace("#", "/").rsplit("/", 1)[-1]
            place["logicalLocations"] = [
                {"name": name, "fullyQualifiedName": address, "kind": kind}
            ]
        return place

    def _related(self, finding: Finding) -> Iterator[dict[str, Any]]:
        for number, related in enumerate(finding.related[:RELATED_LOCATIONS], 1):
            place = {"id": number, **self._place(related.location)}
            if related.message:
                place["message"] = {"text": escaped(related.message)}
            yield place

    def _consequence(self, finding: Finding) -> dict[str, Any]:
        """A finding that follows from that of the result: what it says, and where."""
        place = self._place(finding.location)
        return {"ruleId": finding.rule.code, "message": {"text": finding.message}, **place}

    def _flow(self, finding: Finding) -> dict[str, Any]:
        """The derivation as steps: what is written first, what follows from it after it."""
        steps = [
            (location or finding.location, _step(premise), premise.depth + 1)
            for premise, location in _derivation(finding.because)
        ][-FLOW_LOCATIONS + 2 :]
        if finding.reason:
            steps.append((finding.location, finding.reason, 1))
        steps.append((finding.location, finding.message, 0))
        locations = [
            {
                "location": {**self._place(location), "message": {"text": escaped(text)}},
                "nestingLevel": depth,
            }
            for location, text, depth in steps
        ]
        return {"threadFlows": [{"locations": locations}]}

    def _place(self, location: Location) -> dict[str, Any]:
        return {
            "physicalLocation": {
                "artifactLocation": self._artifacts.location(location.source.name),
                "region": self._region(location).region(location.span),
            }
        }

    def _region(self, location: Location) -> Regions:
        name = location.source.name
        if name not in self._regions:
            self._regions[name] = Regions(location.source)
        return self._regions[name]

    def _line_hash(self, location: Location) -> str:
        name = location.source.name
        if name not in self._hashes:
            self._hashes[name] = LineHashes(location.source)
        return self._hashes[name].line_hash(location.start.line)


def _suppressions(finding: Finding) -> list[dict[str, str]]:
    """Return what silences *finding*: a statement in its source, or the configuration."""
    if finding.suppressed is None:
        return []
    kind = "external" if finding.suppressed.startswith("ignored by ") else "inSource"
    return [{"kind": kind, "justification": finding.suppressed}]


def _step(premise: Premise) -> str:
    """A statement, and by which axiom it follows; what it follows from stands before it."""
    if premise.computed:
        return f"{premise.statement} (computed)"
    return f"{premise.statement} ({premise.axiom})" if premise.inferred else premise.statement


def _derivation(premises: Sequence[Premise]) -> Iterator[tuple[Premise, Location | None]]:
    """Premises before what follows from them, each with its place or that of a premise."""
    pending: list[tuple[Premise, Location | None]] = []

    def settled(depth: int) -> Iterator[tuple[Premise, Location | None]]:
        while pending and pending[-1][0].depth >= depth:
            premise, location = pending.pop()
            yield premise, location
            if pending and pending[-1][1] is None and pending[-1][0].depth < premise.depth:
                pending[-1] = (pending[-1][0], location)

    for premise in premises:
        yield from settled(premise.depth)
        pending.append((premise, premise.location))
    yield from settled(0)
