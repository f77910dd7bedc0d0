"""Options that make no sense together."""

from __future__ import annotations

from argparse import Namespace

from kinlint.errors import UsageError
from kinlint.project.discovery import Found

EXCLUDING = (
    ("--new-from-rev", ("--new-from-merge-base",)),
    ("--write-baseline", ("--new-from-rev", "--new-from-merge-base")),
    ("--prune-baseline", ("--new-from-rev", "--new-from-merge-base")),
    (
        "--watch",
        (
            *("--fix", "--fix-only", "--diff", "--add-ignore", "--write-baseline"),
            *("--prune-baseline", "--show-files", "--show-settings", "--profile"),
        ),
    ),
    ("--executor", ("--fix", "--fix-only", "--diff", "--add-ignore", "--file-timeout")),
    ("--add-ignore", ("--fix", "--fix-only", "--diff", "--write-baseline", "--prune-baseline")),
)
"""Each option with those that it excludes."""
LOCAL = (
    *("fix", "fix_only", "diff", "add_ignore", "watch", "in_project", "report_bug"),
    *("new_from_rev", "new_from_merge_base"),
)
"""The options that are for files on this machine."""


def check_together(options: Namespace) -> None:
    """Raise UsageError if two of *options* exclude each other."""
    for option, others in EXCLUDING:
        for other in others:
            if _given(options, option) and _given(options, other):
                raise UsageError(f"{option} and {other} exclude each other")


def check_urls(options: Namespace, found: Found) -> None:
    """Raise `UsageError` for options that mean nothing for files by URL, which are only read."""
    if any(one.remote for one in found.inputs):
        for name in LOCAL:
            if getattr(options, name) not in (None, False):
                raise UsageError(f"--{name.replace('_', '-')} is not for files by URL")


def _given(options: Namespace, option: str) -> bool:
    return getattr(options, option[2:].replace("-", "_")) not in (None, False)
