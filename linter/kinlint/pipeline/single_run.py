"""The stages of a run that keeps nothing, which costs the least."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from pathlib import Path

from kinlint.engine.closure import close
from kinlint.engine.evaluate import check
from kinlint.engine.lifting import lift
from kinlint.engine.result import Result
from kinlint.engine.store import Store
from kinlint.facts.computation import facts, hints
from kinlint.pipeline.stage_inputs import Demand, Inputs


class SingleRun:
    """Each stage makes everything; none is run twice."""

    def __init__(self, vocabulary: Sequence[Path]) -> None:
        self.store = Store()
        self.results: Sequence[Result] = ()
        self._vocabulary = vocabulary

    def loading(self, inputs: Inputs, demand: Demand, ask: Callable[[], None]) -> None:  # noqa: ARG002
        """Assert what the documents and the vocabulary say."""
        self.store.load(inputs.documents)
        self.store.load_vocabulary(self._vocabulary)

    def lifting(self, inputs: Inputs, demand: Demand, ask: Callable[[], None]) -> None:  # noqa: ARG002
        """Make a composable model of elements."""
        lift(self.store, demand.terms, demand.lifted)

    def closure(self, inputs: Inputs, demand: Demand, ask: Callable[[], None]) -> None:  # noqa: ARG002
        """Infer what follows by axioms."""
        close(self.store, demand.axioms)

    def facts(self, inputs: Inputs, demand: Demand, ask: Callable[[], None]) -> None:  # noqa: ARG002
        """Compute facts, hints for repairs, and which files are missing."""
        helpful = hints(self.store, demand.hints)
        found = facts(self.store, demand.terms)
        self.store.state((*found, *inputs.missing(demand), *helpful))

    def checking(self, inputs: Inputs, demand: Demand, ask: Callable[[], None]) -> None:  # noqa: ARG002
        """Find what violates the constraints.

        The reference engine judges what is deferred to it. Asked for, it closes composable models
        itself. What is lifted is closed as far as rules ask, and owlrl could not do that.
        """
        constraints = demand.constraints
        if demand.engine != "pyshacl":
            results = list(check(self.store, constraints))
            if any(each.deferred is not None for each in constraints):
                from kinlint.engine.reference import shacl  # noqa: PLC0415

                results += shacl.check_deferred(self.store, demand.shapes, constraints)
        else:
            from kinlint.engine.reference import shacl  # noqa: PLC0415

            owners = {each.owner for each in constraints}
            if all(document.format.is_tree for document in inputs.documents):
                found = shacl.check_store(self.store, demand.shapes, constraints)
            else:
                found = shacl.check(
                    inputs.documents,
                    demand.shapes,
                    self._vocabulary,
                    constraints=constraints,
                    computed=(*self.store.lifted(), *self.store.facts()),
                )
            results = [result for result in found if result.constraint.owner in owners]
        self.results = results if inputs.documents else ()
