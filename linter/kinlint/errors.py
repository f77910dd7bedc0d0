"""Exceptions that kinlint raises on purpose.

    KinlintError
    ├── UsageError          an option, selector, configuration key or path is wrong
    │   └── ConfigError     ... in a configuration file
    ├── SourceError         a file cannot be read as what it claims to be
    │   ├── InternalError   ... because of an error in kinlint
    │   └── FileTimeout     ... within the time that it may take
    └── RuleInvalid         a rule or shapes file is not what it must be

A defect of a robot is never an exception: it is a `Finding`.
"""

from __future__ import annotations

from typing import Any


class KinlintError(Exception):
    """The root of the tree; its text is one sentence fit for a user."""


class UsageError(KinlintError):
    """The command was given something it cannot use."""


class ConfigError(UsageError):
    """A configuration file says something kinlint does not understand."""


class SourceError(KinlintError):
    """A file cannot be read; *line* and *column* count from one where they are known."""

    def __init__(
        self, name: str, cause: str, line: int | None = None, column: int | None = None
    ) -> None:
        super().__init__(cause)
        self.name = name
        self.cause = cause
        self.line = line
        self.column = column
        self.text = ""
        """The text, until a report tells what follows from this; empty if not decoded."""
        self.consequences: tuple[Any, ...] = ()
        """The findings that follow from this."""

    def __reduce__(self) -> tuple[type[SourceError], tuple[str, str, int | None, int | None]]:
        return type(self), (self.name, self.cause, self.line, self.column)

    def __str__(self) -> str:
        place = [str(part) for part in (self.line, self.column) if part is not None]
        return ":".join([self.name, *place]) + f": {self.cause}"


class InternalError(SourceError):
    """A file makes kinlint itself fail, which is never the fault of its author."""

    @classmethod
    def from_exception(cls, name: str, error: Exception) -> InternalError:
        """Return what to tell of *error*, which linting the file *name* ended in."""
        text = " ".join(f"{type(error).__name__}: {error}".split())
        return cls(name, f"error in kinlint itself: {text}; 'kinlint --report-bug {name}' helps us")


class FileTimeout(SourceError):
    """A file was given up because it took too long, or ended the process that linted it."""


class RuleInvalid(KinlintError):
    """A rule file breaks the form that `shapes/rule.ttl` describes, or is no Turtle."""
