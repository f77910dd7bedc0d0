"""Concludes: from violations, through findings and suppressions, to a report."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from kinlint.addresses import is_address, split
from kinlint.catalogue.rule_selection import RuleSelection
from kinlint.catalogue.rulebook import Rulebook
from kinlint.document import Document
from kinlint.engine.store import Store
from kinlint.errors import SourceError
from kinlint.finding import Finding
from kinlint.findings.consequences import Unread, folded, sentence, with_consequences_told
from kinlint.findings.finding_builder import FindingBuilder
from kinlint.findings.grouping import grouped
from kinlint.findings.locator import Locator
from kinlint.report import Report
from kinlint.structure import Structure
from kinlint.suppression import suppress
from kinlint.terms import RDF_TYPE, iri_value
from kinlint.vocabulary import KINLINT, METAMODELS, QUDT, SRC

KNOWN = tuple(f"<{namespace}" for namespace in (METAMODELS, QUDT, KINLINT))
PARTIAL = f"SELECT DISTINCT ?document {{ [] a <{SRC}MissingPart> ; <{SRC}document> ?document }}"
"""Query for the documents of which a part could not be read."""
IDLE = frozenset(
    f"<{SRC}{name}>"
    for name in ("Document", "NamedGraph", "ContextUse", "TermDefinition", "ClearedKey")
)
"""Classes of the source layer that every file has."""


def conclude(  # noqa: PLR0913
    builder: FindingBuilder,
    documents: Sequence[Document],
    joined: Sequence[Document],
    selection: RuleSelection,
    failed: Sequence[SourceError],
    *,
    brief: bool = False,
) -> Report:
    """Return the report on *documents*, which *joined* has with their companions.

    If *brief*, findings lack what they rest on and what else they speak of.
    """
    policies = selection.policies
    meant = _of_whole_documents(_meant(builder.brief(), documents, joined), builder.store)
    judged = policies.apply_severities(meant)
    silenced = suppress.apply_suppressions(judged, documents, policies, complete=not failed)
    apart, failed = _apart(tuple(silenced), builder, failed)
    told = grouped(apart, None if brief else builder.detailed, _reused(joined))
    told = [with_consequences_told(finding) for finding in told]
    told.sort(key=lambda finding: finding.sort_key)
    unapplied = (each for each in documents if not has_judged_vocabulary(each, selection.rulebook))
    return Report(
        findings=tuple(finding for finding in told if finding.suppressed is None),
        suppressed=tuple(finding for finding in told if finding.suppressed is not None),
        files=tuple(document.source.name for document in documents),
        unapplied=tuple(document.source.name for document in unapplied),
        errors=tuple(failed),
        rules=tuple(selection.asked),
        triples=sum(len(document.statements) for document in documents),
        applied=len(selection.asked) if documents else 0,
    )


def _apart(
    findings: Sequence[Finding], builder: FindingBuilder, failed: Sequence[SourceError]
) -> tuple[list[Finding], list[SourceError]]:
    """Return *findings* without consequences, and *failed* with what follows from each."""
    unread: list[Unread] = []
    if findings and any(error.text for error in failed):
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


def robot_structures(
    store: Store, documents: Sequence[Document], report: Report
) -> tuple[Structure, ...]:
    """Return the robots in *store*, with what *report* has found in each."""
    from kinlint.facts.robot_structures import structures  # noqa: PLC0415  few outputs draw

    told = sorted((*report.findings, *report.suppressed), key=lambda each: each.sort_key)
    return structures(store, Locator(documents, store), told)


def _meant(
    found: Iterable[Finding], documents: Sequence[Document], joined: Sequence[Document]
) -> Iterable[Finding]:
    """Return those of *found* outside of companions, which *joined* has after *documents*."""
    if len(joined) == len(documents):
        return found
    companions = set(_names(joined[len(documents) :])) - set(_names(documents))
    return [each for each in found if each.location.source.name not in companions]


def _of_whole_documents(found: Iterable[Finding], store: Store) -> Iterable[Finding]:
    """Return *found* without what rules about whole models say of documents that lack a part."""
    partial = {split(iri_value(row["document"]))[0] for row in store.rows(PARTIAL)}
    if not partial:
        return found
    return [
        each
        for each in found
        if not each.rule.whole_model
        or not is_address(each.iri)
        or split(each.iri)[0] not in partial
    ]


def _reused(documents: Iterable[Document]) -> set[str]:
    """Return the texts that may stand in a robot several times: macros, and what is included."""
    return {
        source.name
        for document in documents
        for source in document.sources
        if document.format.expands_to or source is not document.source
    }


def _names(documents: Iterable[Document]) -> Iterator[str]:
    return (source.name for document in documents for source in document.sources)


def has_judged_vocabulary(document: Document, rulebook: Rulebook) -> bool:
    """Tell whether *document* uses any vocabulary that a rule can judge, or lost what it said."""
    return document.format.is_tree or any(
        o.startswith(KNOWN) or o in rulebook.terms
        if p == RDF_TYPE
        else p.startswith(KNOWN[:2]) or p in rulebook.terms
        for _, p, o in document.statements
        if o not in IDLE
    )
