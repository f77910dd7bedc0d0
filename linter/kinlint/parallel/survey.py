"""Looks at the files of a run that are read where they are linted."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from itertools import islice

from kinlint.errors import SourceError
from kinlint.parallel.shard import Job
from kinlint.parallel.unread import Survey, survey
from kinlint.project.discovery import Found, Input
from kinlint.text import SourceText

CHUNK = 64
"""Number of files that are looked at in one task."""


def survey_found(  # noqa: PLR0913, PLR0917  of one run
    found: Found,
    job: Job,
    jobs: int,
    executor: str,
    advance: Callable[[int], None],
    passed: list[SourceError],
) -> tuple[list[SourceText], list[SourceError]] | None:
    """Return the files *found*, unread, and errors; looked at by so many processes.

    Those by URL are looked at by *executor*. *advance* is called with the number of those looked
    at, *passed* is told which may have been meant as models. None where they are to be read
    here: they come by a stream, or speak of others, which are to be found for them.
    """
    remote = any(one.remote for one in found.inputs)
    streamed = any(one.path is None and not one.remote for one in found.inputs)
    if streamed or found.turtle or found.asides:
        return None
    left = iter(found.inputs)
    chunks = list(iter(lambda: list(islice(left, CHUNK)), []))
    texts, errors, more = list[SourceText](), [*found.errors], list[SourceError]()
    # What is known of files of this machine needs no cluster.
    parts = _surveys(chunks, job, jobs, executor if remote else "")
    for chunk, part in zip(chunks, parts, strict=True):
        if any(each.paired for each in part.texts):
            return None
        texts += part.texts
        errors += part.errors
        more += part.passed
        advance(len(chunk))
    passed += more
    return texts, errors


def _surveys(
    chunks: Sequence[Sequence[Input]], job: Job, jobs: int, executor: str
) -> Iterator[Survey]:
    if executor:
        from kinlint.parallel.dask_cluster import worker_pool  # noqa: PLC0415  few runs

        with worker_pool(executor, job, ()) as pool:
            yield from pool.survey(chunks)
    elif jobs > 1 and len(chunks) > 1:
        from concurrent.futures import ProcessPoolExecutor  # noqa: PLC0415  slow to import
        from functools import partial  # noqa: PLC0415

        from kinlint.parallel.processes import depend_on_parent  # noqa: PLC0415

        with ProcessPoolExecutor(min(jobs, len(chunks)), initializer=depend_on_parent) as pool:
            yield from pool.map(partial(survey, job.settings, job.roots), chunks)
    else:
        yield from (survey(job.settings, job.roots, chunk) for chunk in chunks)
