"""The whole pipeline: texts to a report."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path
from types import MappingProxyType

from kinlint.catalogue.applicability import applies, axioms_for, demand, possible
from kinlint.catalogue.rule_selection import Inquiry
from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.settings import Settings
from kinlint.document import Document
from kinlint.engine.closure import close
from kinlint.engine.constraint import Constraint
from kinlint.engine.evaluate import check
from kinlint.engine.lifting import lift
from kinlint.engine.required_terms import behind, made
from kinlint.engine.result import Result
from kinlint.engine.store import Store
from kinlint.errors import SourceError
from kinlint.facts.compute import facts, hints
from kinlint.findings.finding_builder import Account
from kinlint.findings.grouping import grouped
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import read
from kinlint.missing_files import STATED, references
from kinlint.model import Finding
from kinlint.phases import Phases
from kinlint.report import Report
from kinlint.structure import Structure
from kinlint.suppression import suppress
from kinlint.terms import RDF_TYPE, Term
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
        documents, joined = gathered(sources, failed, settings, partial(read, options=options))
    inquiry = Inquiry.of(documents, settings, rulebook, repairing=repairing)
    repairs = inquiry.repairs
    store = Store()
    with spent.phase("loading"):
        store.load(joined)
        store.load_vocabulary(rulebook.vocabulary)
    with spent.phase("lifting"):
        axioms = rulebook.axioms
        constraints = possible(inquiry.constraints, joined, store, STATED | made(axioms))
        wanted = wanted_for(demand(constraints, repairs), settings)
        lift(store, wanted, None if wanted is None else behind(axioms, wanted))
    with spent.phase("closure"):
        close(store, axioms_for(joined, axioms, wanted))
    with spent.phase("facts"):
        helpful = hints(store, {term for each in repairs for term in each.terms})
        named = references(documents, options.packages_of, wanted)
        store.state((*facts(store, wanted), *named, *helpful))
    with spent.phase("checking"):
        results = check_all(joined, store, constraints, settings, rulebook)
        results = list(applies(results, joined, inquiry.owners))
    with spent.phase("locating"):
        account = Account(results, joined, store, rulebook)
        report = concluded(account, documents, joined, inquiry, failed)
    structures = drawn(store, joined, report) if settings.drawn else ()
    seconds = sum(spent.seconds.values()) - before
    report = replace(report, structures=structures, seconds=seconds)
    return Examination(report, joined, store, account, options)


def gathered(
    sources: Iterable[SourceText],
    failed: list[SourceError],
    settings: Settings,
    reading: Callable[[SourceText], Document],
) -> tuple[list[Document], list[Document]]:
    """What *sources* say to *reading*, without companions and with them, SRDF joined to its URDF.

    The errors of those that cannot be read go to *failed*, unless they are companions.
    """
    texts = list(sources)
    documents = list(_documents([each for each in texts if not each.companion], reading, failed))
    beside = _documents([each for each in texts if each.companion], reading, [])
    joined = _joined([*documents, *beside], settings)
    return joined[: len(documents)], joined


def concluded(
    account: Account,
    documents: Sequence[Document],
    joined: Sequence[Document],
    inquiry: Inquiry,
    failed: Sequence[SourceError],
) -> Report:
    """What *account* says of *documents*, which *joined* has with their companions."""
    policies = inquiry.policies
    judged = policies.judged(_meant(account.brief(), documents, joined))
    silenced = suppress.apply(judged, documents, policies, complete=not failed)
    told = grouped(silenced, account.detailed, _reused(joined))
    told.sort(key=lambda finding: finding.sort_key)
    unapplied = (each for each in documents if not speaks(each, inquiry.rulebook))
    return Report(
        findings=tuple(finding for finding in told if finding.suppressed is None),
        suppressed=tuple(finding for finding in told if finding.suppressed is not None),
        files=tuple(document.source.name for document in documents),
        unapplied=tuple(document.source.name for document in unapplied),
        errors=tuple(failed),
        rules=tuple(inquiry.asked),
        triples=sum(len(document.statements) for document in documents),
        applied=len(inquiry.asked) if documents else 0,
    )


def wanted_for(terms: frozenset[Term] | None, settings: Settings) -> frozenset[Term] | None:
    """*terms*, and if robots are to be drawn, those that say what they look like."""
    if terms is None or not settings.drawn:
        return terms
    from kinlint.kinematics.demand import ASKED  # noqa: PLC0415  few outputs draw

    return terms | ASKED


def drawn(store: Store, documents: Sequence[Document], report: Report) -> tuple[Structure, ...]:
    """The robots in *store*, with what *report* has found in each."""
    from kinlint.kinematics.extraction import structures  # noqa: PLC0415  few outputs draw

    told = sorted((*report.findings, *report.suppressed), key=lambda each: each.sort_key)
    return structures(store, documents, told)


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
        if document.format.expands_to or source is not document.source
    }


def _names(documents: Iterable[Document]) -> Iterator[str]:
    return (source.name for document in documents for source in document.sources)


def _joined(documents: Sequence[Document], settings: Settings) -> list[Document]:
    """*documents*, in which each SRDF says which URDF it is about."""
    from kinlint.formats.srdf.pairing import join, may_be_srdf, partners  # noqa: PLC0415

    texts = [document.source for document in documents]
    if not any(map(may_be_srdf, texts)):
        return list(documents)
    return join(documents, partners(texts, settings.partner))


def _documents(
    sources: Iterable[SourceText],
    reading: Callable[[SourceText], Document],
    failed: list[SourceError],
) -> Iterator[Document]:
    """What *sources* say; the errors of those that cannot be read go to *failed*."""
    for source in sources:
        try:
            yield reading(source)
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
        if all(document.format.is_tree for document in documents):
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
    return document.format.is_tree or any(
        o.startswith(KNOWN) or o in rulebook.terms
        if p == RDF_TYPE
        else p.startswith(KNOWN[:2]) or p in rulebook.terms
        for _, p, o in document.statements
        if o not in IDLE
    )
