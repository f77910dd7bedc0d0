"""The run of the stages on one model, which keeps what it made with what it looked at."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from kinlint.engine.axioms import Axiom
from kinlint.engine.closure import close
from kinlint.engine.constraint import Constraint
from kinlint.engine.explanation import Step
from kinlint.engine.lifting import lift, makes
from kinlint.engine.result import Result
from kinlint.engine.store import Store
from kinlint.incremental.change import Changes
from kinlint.incremental.tracked_checking import TrackedChecking
from kinlint.incremental.tracked_explanations import Explanations, TrackedStore
from kinlint.incremental.tracked_facts import TrackedFacts
from kinlint.incremental.tracked_loading import TrackedLoading
from kinlint.pipeline.stage_inputs import Demand, Inputs

if TYPE_CHECKING:
    from kinlint.incremental.inference import Inference
    from kinlint.incremental.tracked_lifting import TrackedLifting


class Run:
    """The stages of one model. Each makes everything at first, and then what changed of it.

    All turns have documents of the same graphs, and a demand by which stages before checking make
    the same; constraints only become more. What only a further turn needs is worked out when there
    is one, so that a single turn costs no more than the stages themselves.
    """

    def __init__(self, vocabulary: Sequence[Path], axioms: Sequence[Axiom] = ()) -> None:
        store = TrackedStore()
        self.store: Store = store
        """The results of the stages: asserted, lifted, inferred, computed, a graph for each."""
        self.results: Sequence[Result] = ()
        """The violations of the constraints, once they were checked."""
        self.computed: TrackedFacts | None = None
        """The computation of facts, once there were some to compute."""
        self._vocabulary = vocabulary
        self._changes = Changes(self.store)
        self._loading = TrackedLoading(self.store, vocabulary)
        self._lifted = self._closed = False
        self._lifting: TrackedLifting | None = None
        self._inference: Inference | None = None
        self._checking: TrackedChecking | None = None
        self._explanations = Explanations(store, axioms)

    def loading(self, inputs: Inputs, demand: Demand, ask: Callable[[], None]) -> None:  # noqa: ARG002
        """Assert what documents and vocabulary say, in place of what they said."""
        self._loading.run(inputs.documents, self._changes)

    def lifting(self, inputs: Inputs, demand: Demand, ask: Callable[[], None]) -> None:
        """Lift asserted statements about elements, where they changed."""
        if not self._lifted:
            if demand.browsed and demand.terms is not None:
                formats = {document.format for document in inputs.documents}
                self._explanations.keep_to(makes(formats, demand.terms, demand.lifted))
            lift(self.store, *demand.lifting)
            self._lifted = True
            return
        if self._lifting is None:
            from kinlint.incremental.tracked_lifting import TrackedLifting  # noqa: PLC0415  most runs run once

            self._lifting = TrackedLifting(self.store, *demand.lifting)
        self._lifting.run(self._changes, ask)

    def closure(self, inputs: Inputs, demand: Demand, ask: Callable[[], None]) -> None:  # noqa: ARG002
        """Infer what follows from asserted and lifted statements, where they changed."""
        if not self._closed:
            close(self.store, demand.axioms)
            self._closed = True
            return
        if self._inference is None:
            from kinlint.incremental.inference import Inference  # noqa: PLC0415  most runs run once

            self._inference = Inference(self.store, demand.axioms)
        self._inference.follow(self._changes)

    def facts(self, inputs: Inputs, demand: Demand, ask: Callable[[], None]) -> None:
        """Compute facts and hints from all of these, and which files are missing."""
        if self.computed is None:
            self.computed = TrackedFacts(self.store, demand.terms, demand.hints, demand.named)
        self.computed.run(self._changes, inputs.missing(demand), ask, hinting=inputs.repairing)

    def checking(self, inputs: Inputs, demand: Demand, ask: Callable[[], None]) -> None:
        """Find what violates the constraints, where something changed that they look at."""
        if self._checking is None:
            self._checking = TrackedChecking(self.store, demand.constraints)
        self._checking.widen(demand.constraints)
        if demand.engine != "pyshacl":
            self._checking.run(self._changes, ask)
        results = list(self._checking.results)
        if demand.engine == "pyshacl" or self._checking.deferred:
            results += self._referred(inputs, demand)
        self.results = results if inputs.documents else ()
        self._explanations.forget(self._changes, self.results)
        self._changes = Changes(self.store)

    def _referred(self, inputs: Inputs, demand: Demand) -> Sequence[Result]:
        """Return what the reference engine judges: what is deferred to it, or everything.

        Asked for everything, it closes composable models itself. What is lifted is closed as far as
        rules ask, and owlrl could not do that.
        """
        from kinlint.engine.reference import shacl  # noqa: PLC0415  few rules defer

        constraints = demand.constraints
        if demand.engine != "pyshacl":
            return list(shacl.check_deferred(self.store, demand.shapes, constraints))
        if all(document.format.is_tree for document in inputs.documents):
            found = shacl.check_store(self.store, demand.shapes, constraints)
        else:
            computed = (*self.store.lifted(), *self.store.facts())
            found = shacl.check(
                inputs.documents,
                demand.shapes,
                self._vocabulary,
                constraints=constraints,
                computed=computed,
            )
        owners = {each.owner for each in constraints}
        return [result for result in found if result.constraint.owner in owners]

    def because(self, constraint: Constraint, result: Result) -> tuple[Step, ...]:
        """Return what *result* rests on, as `kinlint.engine.explanation.because` does."""
        return self._explanations.because(constraint, result)
