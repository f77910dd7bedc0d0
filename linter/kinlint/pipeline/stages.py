"""The stages between reading and concluding: each makes something of what the store holds."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Literal, Protocol

from kinlint.engine.result import Result
from kinlint.engine.store import Store
from kinlint.phases import Phases
from kinlint.pipeline.stage_inputs import Demand, Inputs

StageName = Literal["loading", "lifting", "closure", "facts", "checking"]
ORDER: tuple[StageName, ...] = ("loading", "lifting", "closure", "facts", "checking")
ANYTHING = Demand()


class Run(Protocol):
    """The stages of one model: from documents to statements of the store, and to violations."""

    store: Store
    """The results of the stages, each in a graph of its own.

    Asserted, lifted, inferred, computed.
    """
    results: Sequence[Result]
    """The violations of the constraints, once they were checked."""

    def loading(self, inputs: Inputs, demand: Demand, ask: Callable[[], None]) -> None:
        """Documents and vocabulary to asserted statements."""

    def lifting(self, inputs: Inputs, demand: Demand, ask: Callable[[], None]) -> None:
        """Asserted statements about elements to lifted ones."""

    def closure(self, inputs: Inputs, demand: Demand, ask: Callable[[], None]) -> None:
        """Asserted and lifted statements to inferred ones."""

    def facts(self, inputs: Inputs, demand: Demand, ask: Callable[[], None]) -> None:
        """All of these, and files on disk, to computed statements."""

    def checking(self, inputs: Inputs, demand: Demand, ask: Callable[[], None]) -> None:
        """All statements to violations."""


def never_cancel() -> None:
    """Do nothing: nobody cancels."""


def run_stages(  # noqa: PLR0913, PLR0917
    last: StageName,
    run: Run,
    inputs: Inputs,
    demand: Demand = ANYTHING,
    spent: Phases | None = None,
    ask: Callable[[], None] = never_cancel,
    *,
    first: StageName = "loading",
) -> Store:
    """Run the stages from *first* through *last*; return the store.

    *ask* is called between the units of work. Whatever it raises, what was done till then counts,
    and a tracked run does the rest the next time.
    """
    phases = spent or Phases()
    for name in ORDER[ORDER.index(first) : ORDER.index(last) + 1]:
        with phases.phase(name):
            getattr(run, name)(inputs, demand, ask)
        ask()
    return run.store
