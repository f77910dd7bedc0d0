"""Prepares findings for a report: without consequences, grouped and sorted."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from kinlint.document import Document
from kinlint.errors import SourceError
from kinlint.finding import Finding
from kinlint.findings.consequences import Unread, folded, sentence, with_consequences_told
from kinlint.findings.finding_builder import FindingBuilder
from kinlint.findings.grouping import grouped


def told_findings(
    findings: Sequence[Finding],
    builder: FindingBuilder,
    documents: Sequence[Document],
    failed: Sequence[SourceError],
    *,
    brief: bool,
) -> tuple[list[Finding], list[SourceError]]:
    """Return *findings* in *documents* as a report has them, and *failed* with what follows.

    If *brief*, findings lack what they rest on and what else they speak of.
    """
    apart, unread = _apart(findings, builder, failed)
    told = grouped(apart, None if brief else builder.detailed, _reused(documents))
    told = [with_consequences_told(finding) for finding in told]
    return sorted(told, key=lambda finding: finding.sort_key), unread


def _apart(
    findings: Sequence[Finding], builder: FindingBuilder, failed: Sequence[SourceError]
) -> tuple[list[Finding], list[SourceError]]:
    """Return *findings* without consequences, and *failed* with what follows from each."""
    unread: list[Unread] = []
    if any(error.text for error in failed):
        from kinlint.findings.unread_files import unread_file  # noqa: PLC0415  most files are read

        unread = [unread_file(error.text, builder.store) for error in failed]
        for error in failed:  # Reports keep no texts, and each is asked once.
            error.text = ""
    apart, following = folded(findings, builder.results, builder.store, unread)
    told = list(failed)
    for number, found in enumerate(following):
        if found:
            error = failed[number]
            cause = f"{error.cause}; {sentence(found)}"
            told[number] = type(error)(error.name, cause, error.line, error.column)
            told[number].consequences = tuple(found)
    return apart, told


def _reused(documents: Iterable[Document]) -> set[str]:
    """Return the texts that may stand in a robot several times: macros, and what is included."""
    return {
        source.name
        for document in documents
        for source in document.sources
        if document.format.expands_to or source is not document.source
    }
