"""Lints models that say nothing of each other in several processes."""

from __future__ import annotations

import os
import pickle
import signal
from collections.abc import Iterable, Sequence
from threading import Thread
from time import perf_counter
from typing import TYPE_CHECKING

from kinlint import lint
from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.settings import Settings
from kinlint.errors import SourceError
from kinlint.findings.account import identity
from kinlint.independence import models
from kinlint.model import Finding
from kinlint.report import Report
from kinlint.text import SourceText

if TYPE_CHECKING:
    from concurrent.futures import ProcessPoolExecutor

SHARES = 4
"""How many shares each process gets, so that none waits long for the last one."""


def run(  # noqa: PLR0913
    sources: Sequence[SourceText],
    errors: Sequence[SourceError],
    settings: Settings,
    rulebook: Rulebook,
    jobs: int,
    *,
    fixing: bool = False,
) -> Report | None:
    """Lint *sources* in at most *jobs* processes: the report is that of one process.

    If *fixing*, with the fixes that are offered.

    None where processes cannot be had, or where a file turns out not to be readable, which
    decides in all others what of their suppressions is told.
    """
    started = perf_counter()
    shares = _shares(list(models(sources)), jobs * SHARES)
    reports = _reports([(share, errors, settings, rulebook, fixing) for share in shares], jobs)
    if reports is None or any(len(report.errors) > len(errors) for report in reports):
        return None
    seconds = perf_counter() - started
    return _merged(reports, [source.name for source in sources], errors, seconds)


def divisible(sources: Sequence[SourceText], settings: Settings) -> bool:
    """Whether several processes can lint *sources*, with the outcome of one.

    An ignore of an entity that several of them might use is judged by one alone.
    """
    every = (settings.default, *settings.files.values())
    ignores = [ignore for each in every for ignore in each.ignores]
    shared = any(each.iri is not None or each.pointer is not None for each in ignores)
    return not shared and len(list(models(sources))) > 1


Task = tuple[Sequence[SourceText], Sequence[SourceError], Settings, Rulebook, bool]


def _reports(tasks: Sequence[Task], jobs: int) -> list[Report] | None:
    """What comes of each of *tasks*; None where the system gives no processes."""
    try:
        from concurrent.futures import ProcessPoolExecutor  # noqa: PLC0415  slow to import
        from concurrent.futures.process import BrokenProcessPool  # noqa: PLC0415

        pool = ProcessPoolExecutor(min(jobs, len(tasks)), initializer=_begin)
    except (ImportError, NotImplementedError, OSError, ValueError):
        return None
    try:
        reports = list(pool.map(_one, tasks))
    except (BrokenProcessPool, OSError, pickle.PicklingError):
        _end(pool)
        return None
    except BaseException:
        _end(pool)
        raise
    pool.shutdown()
    return reports


def _begin() -> None:
    """Leave interrupts to the process that began this one, and end when it ends."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    Thread(target=_outlive_nobody, daemon=True).start()


def _outlive_nobody() -> None:
    from multiprocessing import parent_process  # noqa: PLC0415

    if (parent := parent_process()) is not None:
        parent.join()
        os._exit(1)


def _end(pool: ProcessPoolExecutor) -> None:
    """End the processes of *pool* without waiting for what they are at."""
    from multiprocessing import active_children  # noqa: PLC0415

    processes = active_children()
    pool.shutdown(wait=False, cancel_futures=True)
    for process in processes:
        process.terminate()


def _shares(groups: Sequence[list[SourceText]], most: int) -> list[list[SourceText]]:
    """*groups* in at most *most* shares of about the same size, the longest texts first."""
    shares: list[list[SourceText]] = [[] for _ in range(min(most, len(groups)))]
    sizes = [0] * len(shares)
    for group in sorted(groups, key=_size, reverse=True):
        least = sizes.index(min(sizes))
        shares[least] += group
        sizes[least] += _size(group)
    return shares


def _size(group: Iterable[SourceText]) -> int:
    return sum(len(source.text) for source in group)


def _one(task: Task) -> Report:
    sources, errors, settings, rulebook, fixing = task
    if fixing:
        from kinlint.fixes.rounds import linted  # noqa: PLC0415  few outputs show fixes

        return linted(sources, errors, settings, rulebook).report
    return lint.run(sources, errors, settings, rulebook)


def _merged(
    reports: Sequence[Report], names: Sequence[str], errors: Sequence[SourceError], seconds: float
) -> Report:
    """One report of all, in the order of *names*; what several found at one place comes once."""
    place = {name: index for index, name in enumerate(names)}
    rules = {rule.code: rule for report in reports for rule in report.rules}
    files = _ordered((name for report in reports for name in report.files), place)
    return Report(
        findings=_once(finding for report in reports for finding in report.findings),
        suppressed=_once(finding for report in reports for finding in report.suppressed),
        files=files,
        unapplied=_ordered((name for report in reports for name in report.unapplied), place),
        errors=tuple(errors),
        rules=tuple(rules[code] for code in sorted(rules)),
        triples=sum(report.triples for report in reports),
        applied=len(rules) if files else 0,
        seconds=seconds,
        unfixed=tuple(refusal for report in reports for refusal in report.unfixed),
    )


def _ordered(names: Iterable[str], place: dict[str, int]) -> tuple[str, ...]:
    return tuple(sorted(names, key=lambda name: place.get(name, len(place))))


def _once(findings: Iterable[Finding]) -> tuple[Finding, ...]:
    told = sorted(findings, key=lambda finding: finding.sort_key)
    return tuple({identity(finding): finding for finding in reversed(told)}.values())[::-1]
