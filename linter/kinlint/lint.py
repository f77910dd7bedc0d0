"""The whole pipeline: texts to a report."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from kinlint.configuration.selection import Policies
from kinlint.configuration.settings import Settings
from kinlint.document import Document
from kinlint.engine.check import check
from kinlint.engine.closure import close
from kinlint.engine.constraint import Constraint
from kinlint.engine.result import Result
from kinlint.engine.store import Store
from kinlint.errors import SourceError
from kinlint.facts.compute import facts
from kinlint.findings import findings
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import read
from kinlint.profile import Profile
from kinlint.report import Report
from kinlint.rulebook import Rulebook
from kinlint.suppression import silence
from kinlint.terms import RDF_TYPE
from kinlint.text import SourceText
from kinlint.vocabulary import KINLINT, METAMODELS, QUDT, SRC

KNOWN = tuple(f"<{namespace}" for namespace in (METAMODELS, QUDT, KINLINT))
IDLE = frozenset(f"<{SRC}{name}>" for name in ("Document", "NamedGraph", "ContextUse"))
"""What the source layer says of every file, whatever it speaks of."""


def run(
    sources: Sequence[SourceText],
    errors: Iterable[SourceError],
    settings: Settings,
    rulebook: Rulebook,
    profile: Profile | None = None,
) -> Report:
    """Lint *sources* as one model. *errors* are of files that could not even be decoded.

    A source that cannot be read is reported in `Report.errors`; the others are linted. The time
    that each phase takes is added to *profile*.
    """
    spent = profile or Profile()
    before = sum(spent.phases.values())
    failed = list(errors)
    with spent.phase("reading"):
        documents = list(_documents(sources, ReadOptions.of(settings), failed))
    policies = Policies(settings, rulebook.rules)
    enabled = policies.enabled(document.source.name for document in documents)
    asked = [
        rule
        for rule in rulebook.rules
        if rule.code in enabled and not (settings.partial and rule.whole_model)
    ]
    owners = {rule.iri for rule in asked}
    constraints = [each for each in rulebook.constraints if each.owner in owners]
    store = Store()
    with spent.phase("loading"):
        store.load(documents)
        store.load_vocabulary(rulebook.vocabulary)
    with spent.phase("closure"):
        close(store, rulebook.axioms)
    with spent.phase("facts"):
        store.state(facts(store))
    with spent.phase("checking"):
        results = check_all(documents, store, constraints, settings, rulebook)
    with spent.phase("locating"):
        judged = policies.judged(findings(results, documents, store, rulebook))
        told = silence.apply(judged, documents, policies, complete=not failed)
        told.sort(key=lambda finding: finding.sort_key)
    return Report(
        findings=tuple(finding for finding in told if finding.suppressed is None),
        suppressed=tuple(finding for finding in told if finding.suppressed is not None),
        files=tuple(document.source.name for document in documents),
        unapplied=tuple(each.source.name for each in documents if not speaks(each, rulebook)),
        errors=tuple(failed),
        rules=tuple(asked),
        triples=sum(len(document.statements) for document in documents),
        applied=len(asked) if documents else 0,
        seconds=sum(spent.phases.values()) - before,
    )


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
    """What the engine of *settings* finds; the reference engine judges what is deferred to it."""
    if not documents:
        return []
    if settings.engine == "pyshacl":
        from kinlint.engine.reference import shacl  # noqa: PLC0415

        owners = {each.owner for each in constraints}
        found = shacl.check(
            documents,
            rulebook.shapes,
            rulebook.vocabulary,
            constraints=constraints,
            facts=store.facts(),
        )
        return [result for result in found if result.constraint.owner in owners]
    results = list(check(store, constraints))
    if any(each.deferred is not None for each in constraints):
        from kinlint.engine.reference import shacl  # noqa: PLC0415

        results += shacl.check_deferred(store, rulebook.shapes, constraints)
    return results


def speaks(document: Document, rulebook: Rulebook) -> bool:
    """Whether *document* uses any vocabulary that a rule can judge, or lost what it said."""
    return any(
        o.startswith(KNOWN) or o in rulebook.terms
        if p == RDF_TYPE
        else p.startswith(KNOWN[:2]) or p in rulebook.terms
        for _, p, o in document.statements
        if o not in IDLE
    )
