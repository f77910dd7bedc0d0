"""One model as it was last examined, and what each stage of the pipeline made of it."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from kinlint.catalogue.applicability import applies, axioms_for, demand
from kinlint.catalogue.rule_selection import Inquiry
from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.settings import Settings
from kinlint.document import Document
from kinlint.engine.closure import close
from kinlint.engine.constraint import Constraint
from kinlint.engine.required_terms import behind
from kinlint.findings.finding_builder import Account
from kinlint.formats.options import ReadOptions
from kinlint.incremental.change import Changes
from kinlint.incremental.checking import Checks
from kinlint.incremental.computation import Computation
from kinlint.incremental.inference import Inference
from kinlint.incremental.lifting import Lifted
from kinlint.incremental.proofs import Proofs, WatchedStore
from kinlint.incremental.said import vocabulary_of
from kinlint.incremental.statements import assert_again
from kinlint.lint import wanted_for
from kinlint.missing_files import references
from kinlint.phases import Phases


class Model:
    """What is known of the documents of some graphs, which may change what they say.

    *constraints* are those of *inquiry* that they may violate.
    """

    def __init__(
        self,
        documents: Sequence[Document],
        inquiry: Inquiry,
        constraints: Sequence[Constraint],
        settings: Settings,
        spent: Phases,
    ) -> None:
        rulebook = inquiry.rulebook
        self.inquiry = inquiry
        self.rulebook: Rulebook = rulebook
        self.wanted = wanted_for(demand(constraints, inquiry.repairs), settings)
        self.store = WatchedStore()
        with spent.phase("loading"):
            self.store.load(documents)
            self.store.load_vocabulary(rulebook.vocabulary)
        self._vocabulary = vocabulary_of(rulebook.vocabulary)
        kept = None if self.wanted is None else behind(rulebook.axioms, self.wanted)
        self._lifted = Lifted(self.store, self.wanted, kept)
        self._axioms = axioms_for(documents, rulebook.axioms, self.wanted)
        self._inference = Inference(self.store, self._axioms)
        self._closed = False
        helpful = {term for each in inquiry.repairs for term in each.terms}
        self._computation = Computation(self.store, self.wanted, helpful)
        self._proofs = Proofs(self.store, rulebook.axioms)
        self._checks = Checks(self.store, constraints)
        self._pending = Changes(self.store)

    def examine(
        self,
        documents: Sequence[Document],
        joined: Sequence[Document],
        options: ReadOptions,
        spent: Phases,
        ask: Callable[[], None],
    ) -> Account:
        """What is found in *documents*, which *joined* has with their companions.

        *ask* is called between the units of work. Whatever it raises, what was done till then
        counts, and the rest is done next time.
        """
        changes = self._pending
        with spent.phase("loading"):
            assert_again(self.store, joined, self._vocabulary.quads, changes)
        with spent.phase("lifting"):
            self._lifted.lift(changes, ask)
        ask()
        with spent.phase("closure"):
            if self._closed:
                self._inference.follow(changes)
            else:
                close(self.store, self._axioms)
                self._closed = True
        ask()
        with spent.phase("facts"):
            named = tuple(references(documents, options.packages_of, self.wanted))
            self._computation.compute(changes, named, ask)
        with spent.phase("checking"):
            self._checks.check(changes, ask)
            results = list(applies(self._checks.results, joined, self.inquiry.owners))
            self._proofs.forget(changes, results)
        self._pending = Changes(self.store)
        with spent.phase("locating"):
            return Account(results, joined, self.store, self.rulebook, self._proofs.because)
