"""Divides what a process does not finish: a share into its models, a model into its files."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from typing import TypeAlias

from kinlint.errors import FileTimeout, SourceError
from kinlint.files.tracked_io import Record
from kinlint.light_dataclasses import dataclass, field, replace
from kinlint.parallel.partition import Model
from kinlint.parallel.shard import Outcome
from kinlint.report import Report
from kinlint.text import SourceText

Answer: TypeAlias = list[Outcome] | str
"""Outcomes of a task, or why there are none."""


@dataclass(eq=False)
class Task:
    """Models for one process, and what to do with their outcomes."""

    models: Sequence[Model]
    """The models."""
    done: Callable[[Answer], None]
    """A function of the outcomes, or of why there are none."""
    errors: Sequence[SourceError] = ()
    """The errors in other files of the same model."""

    @property
    def files(self) -> int:
        """The number of files that are judged together, at most."""
        return max(map(len, self.models))

    @property
    def is_divisible(self) -> bool:
        """Tell whether there are several files."""
        return len(self.models) > 1 or self.files > 1


class TaskQueue(deque[Task]):
    """The tasks that no process has begun; those that follow from an unfinished one join them."""

    def add_shares(
        self, shares: Sequence[Sequence[Model]], done: Callable[[int, list[Outcome]], None]
    ) -> None:
        """Add *shares*; *done* is called with the number and the outcomes of each.

        A share that is not finished is divided into models; a model that is not, into files. Those
        files that are not finished by themselves are reported, and the others judged as if these
        could not be read; if there is none, all are reported.
        """
        for number, models in enumerate(shares):
            self.append(self._share(models, partial(done, number)))

    def _share(self, models: Sequence[Model], done: Callable[[list[Outcome]], None]) -> Task:
        """Return the task to lint *models*, one by one if that is not finished."""
        if len(models) == 1:
            return self._model(models[0], lambda outcome: done([outcome]))
        found: dict[int, Outcome] = {}

        def one(number: int, outcome: Outcome) -> None:
            found[number] = outcome
            if len(found) == len(models):
                done([found[each] for each in range(len(models))])

        def divided(answer: Answer) -> None:
            if not isinstance(answer, str):
                done(answer)
                return
            self.extend(self._model(each, partial(one, n)) for n, each in enumerate(models))

        return Task(models, divided)

    def _model(self, model: Model, done: Callable[[Outcome], None]) -> Task:
        """Return the task to lint *model*, without the files that are not finished."""
        return Task([model], _Division(model, done, self.append).whole)


@dataclass
class _Division:
    """A model that is linted as a whole or, if that is not finished, less some of its files."""

    model: Model
    """The model."""
    done: Callable[[Outcome], None]
    """A function of the outcome."""
    add: Callable[[Task], None]
    """A function that adds a task."""
    _unfinished: dict[str, str] = field(default_factory=dict)
    _finished: list[SourceText] = field(default_factory=list)

    def whole(self, answer: Answer) -> None:
        """Take the *answer* for the whole model."""
        if not isinstance(answer, str):
            self.done(answer[0])
        elif len(self.model) == 1:
            self._give_up(answer)
        else:
            for source in self.model:
                self.add(Task([[source]], partial(self._alone, source, answer)))

    def _alone(self, source: SourceText, why: str, answer: Answer) -> None:
        """Take the *answer* for *source* alone; *why* there was none for the whole model."""
        if isinstance(answer, str):
            self._unfinished[source.name] = answer
        else:
            self._finished.append(source)
        if len(self._unfinished) + len(self._finished) < len(self.model):
            return
        if not self._unfinished or not self._finished:
            self._give_up(why)
            return
        failed = _given_up(self._unfinished, self.model).report.errors
        others = [each for each in self.model if each.name not in self._unfinished]
        self.add(Task([others], partial(self._others, failed), failed))

    def _others(self, failed: Sequence[SourceError], answer: Answer) -> None:
        """Take the *answer* for the finished files; *failed* are the errors of the others."""
        if isinstance(answer, str):
            self._give_up(answer)
            return
        report = replace(answer[0].report, errors=(*failed, *answer[0].report.errors))
        self.done(answer[0]._replace(report=report))

    def _give_up(self, why: str) -> None:
        self.done(_given_up({each.name: why for each in self.model}, self.model))


def _given_up(reasons: Mapping[str, str], model: Model) -> Outcome:
    """Return the outcome of *model*, of which some files are given up, for *reasons* by name."""
    others = len(model) - 1
    beside = f", checked with {others} other{'s' * (others > 1)}" if others else ""
    errors = tuple(FileTimeout(name, f"{why}{beside}") for name, why in reasons.items())
    return Outcome(Report(errors=errors), Record())
