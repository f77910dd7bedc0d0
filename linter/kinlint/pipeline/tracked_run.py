"""The stages of a run that keeps what they made together with what they looked at."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from kinlint.engine.axioms import Axiom
from kinlint.engine.closure import close
from kinlint.engine.constraint import Constraint
from kinlint.engine.explanation import Step
from kinlint.engine.result import Result
from kinlint.engine.store import Store
from kinlint.incremental.change import Changes
from kinlint.incremental.inference import Inference
from kinlint.incremental.tracked_checking import TrackedChecking
from kinlint.incremental.tracked_explanations import Explanations, TrackedStore
from kinlint.incremental.tracked_facts import TrackedFacts
from kinlint.incremental.tracked_lifting import TrackedLifting
from kinlint.incremental.tracked_loading import TrackedLoading
from kinlint.pipeline.stage_inputs import Demand, Inputs


class TrackedRun:
    """Each stage makes everything at first, and then what changed of it.

    All runs have the same demand, and documents of the same graphs.
    """

    def __init__(self, vocabulary: Sequence[Path], axioms: Sequence[Axiom]) -> None:
        store = TrackedStore()
        self.store: Store = store
        self.results: Sequence[Result] = ()
        self._changes = Changes(self.store)
        self._loading = TrackedLoading(self.store, vocabulary)
        self._lifting: TrackedLifting | None = None
        self._inference: Inference | None = None
        self._facts: TrackedFacts | None = None
        self._checking: TrackedChecking | None = None
        self._explanations = Explanations(store, axioms)

    def loading(self, inputs: Inputs, demand: Demand, ask: Callable[[], None]) -> None:  # noqa: ARG002
        """Assert what the documents say in place of what they said."""
        self._loading.run(inputs.documents, self._changes)

    def lifting(self, inputs: Inputs, demand: Demand, ask: Callable[[], None]) -> None:  # noqa: ARG002
        """Lift what changed."""
        if self._lifting is None:
            self._lifting = TrackedLifting(self.store, demand.terms, demand.lifted)
        self._lifting.run(self._changes, ask)

    def closure(self, inputs: Inputs, demand: Demand, ask: Callable[[], None]) -> None:  # noqa: ARG002
        """Follow what changed by the axioms."""
        if self._inference is None:
            close(self.store, demand.axioms)
            self._inference = Inference(self.store, demand.axioms)
        else:
            self._inference.follow(self._changes)

    def facts(self, inputs: Inputs, demand: Demand, ask: Callable[[], None]) -> None:
        """Compute what changed, and which files are missing."""
        if self._facts is None:
            self._facts = TrackedFacts(self.store, demand.terms, demand.hints)
        self._facts.run(self._changes, inputs.missing(demand), ask)

    def checking(self, inputs: Inputs, demand: Demand, ask: Callable[[], None]) -> None:  # noqa: ARG002
        """Check what looks at something that changed."""
        if self._checking is None:
            self._checking = TrackedChecking(self.store, demand.constraints)
        self._checking.run(self._changes, ask)
        self.results = list(self._checking.results)
        self._explanations.forget(self._changes, self.results)
        self._changes = Changes(self.store)

    def because(self, constraint: Constraint, result: Result) -> tuple[Step, ...]:
        """Return what *result* rests on, as `kinlint.engine.explanation.because` does."""
        return self._explanations.because(constraint, result)
