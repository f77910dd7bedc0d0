"""Asks git about a repository: nothing is fetched, locked, checked out or run by its hooks."""

from __future__ import annotations

import os
import subprocess
from collections.abc import Mapping, Sequence
from pathlib import Path

from kinlint.errors import UsageError

QUIET = {
    "LC_ALL": "C",
    "GIT_OPTIONAL_LOCKS": "0",
    "GIT_TERMINAL_PROMPT": "0",
    "GIT_NO_LAZY_FETCH": "1",
    "GIT_ALLOW_PROTOCOL": "none",
    "GIT_LITERAL_PATHSPECS": "1",
}
"""Environment that keeps git from asking, waiting and using the network."""
CONFIGURED = ("core.fsmonitor=false", "core.splitIndex=false", "core.quotePath=false")
"""Overrides of what a repository could configure: programs to run, and files to write."""


class GitFailed(Exception):
    """A command of git failed; the text is the first line that it had to say."""


def git(
    directory: Path,
    words: Sequence[str],
    given: bytes = b"",
    more: Mapping[str, str] | None = None,
) -> bytes:
    """Return the output of `git WORDS` in *directory*.

    *given* is its standard input, *more* its environment. Raises GitFailed, and UsageError if there
    is no git.
    """
    settings = [word for each in CONFIGURED for word in ("-c", each)]
    try:
        done = subprocess.run(  # noqa: S603  the words are ours, and options end before names
            ["git", "--no-pager", *settings, *words],  # noqa: S607  wherever it is installed
            cwd=directory,
            env={**os.environ, **QUIET, **(more or {})},
            input=given,
            capture_output=True,
            check=False,
        )
    except FileNotFoundError:
        raise UsageError("git is not installed, and revisions need it") from None
    except OSError as error:
        raise UsageError(f"git cannot be run: {error.strerror or error}") from None
    if done.returncode:
        said = done.stderr.decode("utf-8", "replace").strip().partition("\n")[0]
        raise GitFailed(said.removeprefix("fatal: ").removeprefix("error: "))
    return done.stdout
