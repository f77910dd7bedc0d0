"""The stages between reading and concluding: each makes something of what the store holds."""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal

from kinlint.engine.store import Store
from kinlint.phases import Phases
from kinlint.pipeline.run import Run
from kinlint.pipeline.stage_inputs import Demand, Inputs

StageName = Literal["loading", "lifting", "closure", "facts", "checking"]
ORDER: tuple[StageName, ...] = ("loading", "lifting", "closure", "facts", "checking")
ANYTHING = Demand()


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
    and the next turn does the rest.
    """
    phases = spent or Phases()
    for name in ORDER[ORDER.index(first) : ORDER.index(last) + 1]:
        with phases.phase(name):
            getattr(run, name)(inputs, demand, ask)
        ask()
    return run.store
