"""The rules that apply to files, by the formats that rules name."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence

from kinlint.addresses import document_of
from kinlint.catalogue.deferred import heads
from kinlint.document import Document
from kinlint.engine.axioms import Axiom
from kinlint.engine.constraint import Constraint
from kinlint.engine.lifting import lifts
from kinlint.engine.pruning import Lookup, Presence
from kinlint.engine.required_terms import relevant, terms
from kinlint.engine.result import Result
from kinlint.facts.computation import sources
from kinlint.file_format import Format
from kinlint.formats.records import FORMATS, spoken_of_as
from kinlint.rule import Repair, Rule
from kinlint.terms import Term, is_iri
from kinlint.vocabulary import KL

CHOSEN_TARGETS = f"{KL}chosenTargets"
"""Value of `kl:speaksOf` of constraints that only speak of the targets of a run."""
COMPOSABLE = frozenset(each.name for each in FORMATS if not each.is_tree)
"""Formats in which models are written as they are meant; a rule for one is a rule for all."""


def applicability(
    rules: Iterable[Rule], documents: Sequence[Document]
) -> Mapping[str, frozenset[Format]]:
    """Return the rules, by IRI, that apply to some of *documents*, with the formats of these."""
    present = {document.format for document in documents}
    found = {rule.iri: frozenset(f for f in present if covers(rule.formats, f)) for rule in rules}
    return {owner: formats for owner, formats in found.items() if formats}


def applicable(
    constraints: Sequence[Constraint],
    owners: Mapping[str, frozenset[Format]],
    *,
    targets: bool = True,
) -> list[Constraint]:
    """Return those of *constraints* that look at a format which their rule applies to.

    *owners* are the rules, by IRI, with these formats. Without *targets*, none is returned that
    speaks only to those who mean certain consumers.
    """
    found = (
        constraints[number]
        for number, each in enumerate(heads(constraints))
        if any(covers(each.formats, form) for form in owners.get(each.owner, ()))
    )
    return [
        each
        for each in found
        if targets or not (each.consumers or each.speaks_of == CHOSEN_TARGETS)
    ]


def covers(named: Collection[str], form: Format) -> bool:
    """Tell whether the formats *named* include *form*; without names, all are included."""
    if not named:
        return True
    if not form.is_tree:
        return not COMPOSABLE.isdisjoint(named)
    return form.name in named or form.expands_to in named


def formats(documents: Iterable[Document]) -> Mapping[str, str]:
    """Return the name of the format of each text, as rules speak of it, by the name of the text."""
    return {
        source.name: spoken_of_as(document.format)
        for document in documents
        for source in document.sources
    }


def applies(
    results: Iterable[Result],
    documents: Sequence[Document],
    owners: Mapping[str, frozenset[Format]],
) -> Iterator[Result]:
    """Yield those of *results* that are about a file of a format that their rule applies to."""
    present = {document.format for document in documents}
    if len(present) == 1 or not any(each.is_tree for each in present):
        yield from results
        return
    forms = {document.graph: document.format for document in documents}
    homes = {
        node: document.format
        for document in documents
        for node in document.map.nodes
        if not is_iri(node)
    }
    for result in results:
        form = forms.get(document_of(result.focus)) or homes.get(result.focus)
        constraint = result.constraint
        if form is None or (form in owners[constraint.owner] and covers(constraint.formats, form)):
            yield result


def demand(
    constraints: Iterable[Constraint], repairs: Iterable[Repair] = ()
) -> frozenset[Term] | None:
    """Return the terms that *constraints* and *repairs* look at, and what those are computed from.

    None stands for any.
    """
    found = spoken_of(constraints, repairs)
    return None if found is None else sources(found)


def spoken_of(
    constraints: Iterable[Constraint], repairs: Iterable[Repair] = ()
) -> frozenset[Term] | None:
    """Return the terms that *constraints* and *repairs* look at themselves; None is any."""
    found = terms(constraints)
    return None if found is None else found.union(*(each.terms for each in repairs))


def named_by(constraints: Iterable[Constraint], repairs: Iterable[Repair]) -> frozenset[Term]:
    """Return the terms that *constraints* and *repairs* name, whether or not they need any."""
    premises = (pattern for each in constraints for pattern in each.premises)
    needs = (each.needs or () for each in constraints)
    return frozenset().union(*premises, *needs, *(each.terms for each in repairs))


def possible(
    constraints: Sequence[Constraint],
    documents: Iterable[Document],
    store: Lookup,
    coming: frozenset[Term],
) -> list[Constraint]:
    """Return those of *constraints* that something may violate, by what *store* has after loading.

    What is *coming* and what is lifted or computed may yet be there. Where no file is lifted, all:
    what is asked for makes no difference there.
    """
    present = {document.format for document in documents}
    if not any(each.is_tree for each in present):
        return list(constraints)
    presence = Presence(store, coming | lifts(present))
    return [each for each in constraints if presence.may_violate(each)]


def axioms_for(
    documents: Iterable[Document], axioms: Sequence[Axiom], wanted: frozenset[Term] | None
) -> Sequence[Axiom]:
    """Return the *axioms* worth applying: where every file is lifted, those that serve *wanted*.

    What is lifted is complete by construction, and most of it asked for by nobody.
    """
    if wanted is None or not all(document.format.is_tree for document in documents):
        return axioms
    return relevant(axioms, wanted)
