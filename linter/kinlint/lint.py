"""The whole pipeline: texts to a report."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from types import MappingProxyType

from kinlint.catalogue.applicability import (
    applicability,
    applicable,
    applies,
    axioms_for,
    demand,
    formats,
    possible,
)
from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.selection import Policies
from kinlint.configuration.settings import Settings
from kinlint.document import TREES, Document
from kinlint.engine.check import check
from kinlint.engine.closure import close
from kinlint.engine.constraint import Constraint
from kinlint.engine.demand import behind, made
from kinlint.engine.lifting import lift
from kinlint.engine.result import Result
from kinlint.engine.store import Store
from kinlint.errors import SourceError
from kinlint.facts.compute import facts, hints
from kinlint.findings.account import Account
from kinlint.findings.grouping import grouped
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import read
from kinlint.model import Finding
from kinlint.phases import Phases
from kinlint.references import STATED, references
from kinlint.report import Report
from kinlint.suppression import silence
from kinlint.terms import RDF_TYPE
from kinlint.text import SourceText
from kinlint.vocabulary import KINLINT, METAMODELS, QUDT, SRC

KNOWN = tuple(f"<{namespace}" for namespace in (METAMODELS, QUDT, KINLINT))
NOTHING: Mapping[Path, SourceText] = MappingProxyType({})
IDLE = frozenset(f"<{SRC}{name}>" for name in ("Document", "NamedGraph", "ContextUse"))
"""What the source layer says of every file, whatever it speaks of."""


@dataclass(frozen=True)
class Examination:
    """A report, and what it was made from: for those who mend what it tells of.

    `documents` are all that were read, companions too; `options` say how.
    """

    report: Report
    documents: Sequence[Document]
    store: Store
    account: Account
    options: ReadOptions


def run(
    sources: Sequence[SourceText],
    errors: Iterable[SourceError],
    settings: Settings,
    rulebook: Rulebook,
    phases: Phases | None = None,
) -> Report:
    """Lint *sources* as one model: the report of `examine`."""
    return examine(sources, errors, settings, rulebook, phases).report


def examine(  # noqa: PLR0913
    sources: Sequence[SourceText],
    errors: Iterable[SourceError],
    settings: Settings,
    rulebook: Rulebook,
    phases: Phases | None = None,
    *,
    repairing: bool = False,
    overlay: Mapping[Path, SourceText] = NOTHING,
) -> Examination:
    """Lint *sources* as one model. *errors* are of files that could not even be decoded.

    Nothing is reported of companions, not even that they cannot be read. Another source that
    cannot be read is reported in `Report.errors`; the rest is linted. The time that each phase
    takes is added to *phases*. The store holds what the rules look at, and if *repairing*, what
    their repairs do. *overlay* has texts of files that others include, by their real
    paths, which count in place of what the files hold.
    """
    spent = phases or Phases()
    before = sum(spent.seconds.values())
    failed = list(errors)
    with spent.phase("reading"):
        options = replace(ReadOptions.of(settings), overlay=overlay)
        given = [source for source in sources if not source.companion]
        beside = [source for source in sources if source.companion]
        documents = list(_documents(given, options, failed))
        joined = _joined([*documents, *_documents(beside, options, [])], settings)
        documents = joined[: len(documents)]
    policies = Policies(settings, rulebook.rules, formats(documents))
    enabled = policies.enabled(document.source.name for document in documents)
    asked = [
        rule
        for rule in rulebook.rules
        if rule.code in enabled and not (settings.partial and rule.whole_model)
    ]
    owners = applicability(asked, documents)
    constraints = applicable(rulebook.constraints, owners)
    repairs = [one for rule in asked if rule.iri in owners for one in rule.repairs if repairing]
    store = Store()
    with spent.phase("loading"):
        store.load(joined)
        store.load_vocabulary(rulebook.vocabulary)
    with spent.phase("lifting"):
        axioms = rulebook.axioms
        constraints = possible(constraints, joined, store, STATED | made(axioms))
        wanted = demand(constraints, repairs)
        lift(store, wanted, None if wanted is None else behind(axioms, wanted))
    with spent.phase("closure"):
        close(store, axioms_for(joined, axioms, wanted))
    with spent.phase("facts"):
        helpful = hints(store, {term for each in repairs for term in each.terms})
        named = references(documents, options.packages_of, wanted)
        store.state((*facts(store, wanted), *named, *helpful))
    with spent.phase("checking"):
        results = check_all(joined, store, constraints, settings, rulebook)
        results = list(applies(results, joined, owners))
    with spent.phase("locating"):
        account = Account(results, joined, store, rulebook)
        judged = policies.judged(_meant(account.brief(), documents, joined))
        silenced = silence.apply(judged, documents, policies, complete=not failed)
        told = grouped(silenced, account.detailed, _reused(joined))
        told.sort(key=lambda finding: finding.sort_key)
    report = Report(
        findings=tuple(finding for finding in told if finding.suppressed is None),
        suppressed=tuple(finding for finding in told if finding.suppressed is not None),
        files=tuple(document.source.name for document in documents),
        unapplied=tuple(each.source.name for each in documents if not speaks(each, rulebook)),
        errors=tuple(failed),
        rules=tuple(asked),
        triples=sum(len(document.statements) for document in documents),
        applied=len(asked) if documents else 0,
        seconds=sum(spent.seconds.values()) - before,
    )
    return Examination(report, joined, store, account, options)


def _meant(
    found: Iterable[Finding], documents: Sequence[Document], joined: Sequence[Document]
) -> Iterable[Finding]:
    """Those of *found* that do not lie in companions, which *joined* has beside *documents*."""
    if len(joined) == len(documents):
        return found
    companions = set(_names(joined[len(documents) :])) - set(_names(documents))
    return [each for each in found if each.location.source.name not in companions]


def _reused(documents: Iterable[Document]) -> set[str]:
    """The texts that may stand in a robot several times: macros, and what is included."""
    return {
        source.name
        for document in documents
        for source in document.sources
        if document.format == "xacro" or source is not document.source
    }


def _names(documents: Iterable[Document]) -> Iterator[str]:
    return (source.name for document in documents for source in document.sources)


def _joined(documents: Sequence[Document], settings: Settings) -> list[Document]:
    """*documents*, in which each SRDF says which URDF it is about."""
    if not any(each.format == "srdf" or ".srdf" in each.source.name for each in documents):
        return list(documents)
    from kinlint.formats.xml.joining import join, partners  # noqa: PLC0415  few models have SRDF

    texts = (document.source for document in documents)
    return join(documents, partners(texts, settings.partner))


def _documents(
    sources: Iterable[SourceText], options: ReadOptions, failed: list[SourceError]
) -> Iterator[Document]:
    """What *sources* say; the errors of those that cannot be read go to *failed*."""
    for source in sources:
        try:
            yield read(source, options)
        except SourceError as error:
            failed.append(error)


def check_all(
    documents: Sequence[Document],
    store: Store,
    constraints: Sequence[Constraint],
    settings: Settings,
    rulebook: Rulebook,
) -> list[Result]:
    """What the engine of *settings* finds; the reference engine judges what is deferred to it.

    Asked for, it closes composable models itself. What is lifted is closed as far as rules ask,
    and owlrl could not do that.
    """
    if not documents:
        return []
    if settings.engine == "pyshacl":
        from kinlint.engine.reference import shacl  # noqa: PLC0415

        owners = {each.owner for each in constraints}
        if all(document.format in TREES for document in documents):
            found = shacl.check_store(store, rulebook.shapes, constraints)
            return [result for result in found if result.constraint.owner in owners]
        found = shacl.check(
            documents,
            rulebook.shapes,
            rulebook.vocabulary,
            constraints=constraints,
            computed=(*store.lifted(), *store.facts()),
        )
        return [result for result in found if result.constraint.owner in owners]
    results = list(check(store, constraints))
    if any(each.deferred is not None for each in constraints):
        from kinlint.engine.reference import shacl  # noqa: PLC0415

        results += shacl.check_deferred(store, rulebook.shapes, constraints)
    return results


def speaks(document: Document, rulebook: Rulebook) -> bool:
    """Whether *document* uses any vocabulary that a rule can judge, or lost what it said."""
    return document.format in TREES or any(
        o.startswith(KNOWN) or o in rulebook.terms
        if p == RDF_TYPE
        else p.startswith(KNOWN[:2]) or p in rulebook.terms
        for _, p, o in document.statements
        if o not in IDLE
    )
