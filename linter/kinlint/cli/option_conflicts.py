"""Options that make no sense together."""

from __future__ import annotations

from argparse import Namespace

from kinlint.errors import UsageError

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


def check_together(options: Namespace) -> None:
    """Raise UsageError if two of *options* exclude each other."""
    for option, others in EXCLUDING:
        for other in others:
            if _given(options, option) and _given(options, other):
                raise UsageError(f"{option} and {other} exclude each other")


def _given(options: Namespace, option: str) -> bool:
    return getattr(options, option[2:].replace("-", "_")) not in (None, False)
