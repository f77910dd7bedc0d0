"""Adds to the summary of a step on GitHub, where a workflow runs there."""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from urllib.parse import quote

from kinlint.errors import UsageError
from kinlint.files.pathname import real
from kinlint.files.revision import Repository
from kinlint.report import Report
from kinlint.reporters.display_width import replace_surrogates
from kinlint.reporters.step_summary import render
from kinlint.structure import Structure

LIMIT = 1 << 20
"""The bytes that GitHub takes of one step."""


def append(report: Report, path: Path) -> None:
    """Append the summary of *report* to the file at *path*; a warning tells if that cannot be."""
    try:
        room = LIMIT - 1 - (path.stat().st_size if path.exists() else 0)
        text = "".join(render(report, _robots(report), _url, room))
        with path.open("ab") as stream:
            stream.write(text.encode())
    except OSError as error:
        cause = error.strerror or error
        sys.stderr.write(f"kinlint: warning: no summary of the step: {path}: {cause}\n")


def _robots(report: Report) -> Sequence[Structure]:
    """The robots of *report* that were changed, or have findings if nobody knows what changed."""
    try:
        changed = _changed(Path(report.root), os.environ)
    except UsageError:
        names = {finding.location.source.name for finding in report.unsuppressed}
        return [one for one in report.structures if not names.isdisjoint(one.files)]
    return [
        one
        for one in report.structures
        if any(real(Path(report.root, name)) in changed for name in one.files)
    ]


def _changed(root: Path, said: Mapping[str, str]) -> Mapping[Path, Path | None]:
    """Return the files changed since a pull request left its base, or else by the last commit.

    Raises UsageError where git cannot tell.
    """
    repository = Repository.from_directory(root)
    base = said.get("GITHUB_BASE_REF")
    if base:
        return repository.merge_base(f"origin/{base}").changed
    return repository.revision("HEAD^").changed


def _url(path: str, line: int | None) -> str:
    """Return the address of the file at *path* on GitHub; "" outside of a workflow."""
    where = [os.environ.get(f"GITHUB_{name}", "") for name in ("SERVER_URL", "REPOSITORY", "SHA")]
    if not all(where) or path.startswith("/"):
        return ""
    server, repository, commit = where
    return f"{server}/{repository}/blob/{commit}/{quote(replace_surrogates(path))}" + (
        f"#L{line}" if line else ""
    )
