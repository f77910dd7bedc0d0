"""Concludes: from violations, through findings and suppressions, to a report."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING

from kinlint.addresses import is_address, split
from kinlint.catalogue.rule_selection import RuleSelection
from kinlint.catalogue.rulebook import Rulebook
from kinlint.document import Document
from kinlint.engine.result import Result
from kinlint.engine.store import Store
from kinlint.errors import SourceError
from kinlint.finding import Finding
from kinlint.formats.yaml.format import YAML
from kinlint.report import Report
from kinlint.structure import Structure
from kinlint.suppression import suppress
from kinlint.terms import RDF_TYPE, iri_value
from kinlint.vocabulary import KINLINT, METAMODELS, QUDT, SRC

if TYPE_CHECKING:
    from kinlint.findings.finding_builder import FindingBuilder

CONFIGURED = f"<{YAML.namespace}configuration>"
"""Property from a YAML file to the robot of which it names parts."""
KNOWN = tuple(f"<{namespace}" for namespace in (METAMODELS, QUDT, KINLINT))
PARTIAL = f"SELECT DISTINCT ?document {{ [] a <{SRC}MissingPart> ; <{SRC}document> ?document }}"
"""Query for the documents of which a part could not be read."""
IDLE = frozenset(
    f"<{SRC}{name}>"
    for name in ("Document", "NamedGraph", "ContextUse", "TermDefinition", "ClearedKey")
)
"""Classes of the source layer that every file has."""


def conclude(  # noqa: PLR0913, PLR0917
    results: Sequence[Result],
    builder: Callable[[], FindingBuilder],
    documents: Sequence[Document],
    joined: Sequence[Document],
    selection: RuleSelection,
    failed: Sequence[SourceError],
    *,
    brief: bool = False,
) -> Report:
    """Return the report on *documents*, which *joined* has with their companions.

    *builder* returns the builder of findings from *results*; a model without findings needs none.
    If *brief*, findings lack what they rest on and what else they speak of.
    """
    policies = selection.policies
    meant: Iterable[Finding] = ()
    if results:
        brief_ones = _meant(builder().brief(), documents, joined)
        meant = _of_whole_documents(brief_ones, builder().store)
    judged = policies.apply_severities(meant)
    told = suppress.apply_suppressions(judged, documents, policies, complete=not failed)
    if told:
        from kinlint.pipeline.told_findings import told_findings  # noqa: PLC0415  many files are clean

        told, failed = told_findings(told, builder(), joined, failed, brief=brief)
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


def robot_structures(
    store: Store, documents: Sequence[Document], report: Report
) -> tuple[Structure, ...]:
    """Return the robots in *store*, with what *report* has found in each."""
    from kinlint.facts.robot_structures import structures  # noqa: PLC0415  few outputs draw
    from kinlint.findings.locator import Locator  # noqa: PLC0415

    told = sorted((*report.findings, *report.suppressed), key=lambda each: each.sort_key)
    return structures(store, Locator(documents, store), told, placed=True)


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


def _names(documents: Iterable[Document]) -> Iterator[str]:
    return (source.name for document in documents for source in document.sources)


def has_judged_vocabulary(document: Document, rulebook: Rulebook) -> bool:
    """Tell whether *document* uses any vocabulary that a rule can judge, or lost what it said.

    A YAML file that a search found may be of something else than robots.
    """
    if document.format == YAML:
        return not document.source.named or any(p == CONFIGURED for _, p, _ in document.statements)
    return document.format.is_tree or any(
        o.startswith(KNOWN) or o in rulebook.terms
        if p == RDF_TYPE
        else p.startswith(KNOWN[:2]) or p in rulebook.terms
        for _, p, o in document.statements
        if o not in IDLE
    )
