"""Recalls the reports of models that nothing has changed of, and keeps those of others."""

from __future__ import annotations

import json
from collections.abc import Sequence
from pathlib import Path
from typing import Any

from kinlint.cache.cache_key import CacheKeys
from kinlint.cache.directory_store import DirectoryStore
from kinlint.cache.serialization import NotSerializable, parse_report, serialize_report
from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.settings import Settings
from kinlint.files.tracked_io import Asked, Record, answer
from kinlint.light_dataclasses import dataclass, field
from kinlint.report import Report
from kinlint.rule import Severity
from kinlint.text import SourceText

FOLDER = "reports"
"""Directory of reports in the cache."""


@dataclass
class ReportCache:
    """The reports of earlier runs with the same settings and rules.

    What was looked up for a report is looked up again before it is recalled, each thing once.
    """

    entries: DirectoryStore
    """The stored texts."""
    grounds: CacheKeys
    """The keys of this run."""
    _answers: dict[tuple[str, str], str] = field(default_factory=dict)
    _changed: bool = False

    @classmethod
    def from_settings(
        cls, settings: Settings, book: Rulebook, *, fixing: bool, least: Severity
    ) -> ReportCache | None:
        """Return the cache that *settings* allow, or None.

        If *fixing*, reports contain fixes of findings of the severity *least* or more.
        """
        if settings.cache is None or not book.digest:
            return None
        return cls(
            DirectoryStore(settings.cache / FOLDER), CacheKeys(settings, book, fixing, least)
        )

    def recall(self, sources: Sequence[SourceText], *, complete: bool) -> Report | None:
        """The report that was kept of *sources*, if it would be the same today."""
        text = self.entries.get(self.grounds.key(sources, complete=complete))
        if text is None:
            return None
        try:
            asked, _, report = text.partition("\n")
            if all(self._holds(*each) for each in json.loads(asked)):
                return parse_report(report, sources, self.grounds.book)
        except Exception:  # noqa: BLE001  whatever is wrong with it, it is not what was kept
            return None
        return None

    def keep(
        self, sources: Sequence[SourceText], report: Report, record: Record, *, complete: bool
    ) -> None:
        """Keep the *report* of *sources* for as long as what was asked has the same answers."""
        if record.torn:
            return
        try:
            asked = json.dumps([_plain(*each) for each in record.answers.items()])
            text = f"{asked}\n{serialize_report(report, sources)}"
        except (NotSerializable, TypeError):
            return
        self.entries.put(self.grounds.key(sources, complete=complete), text)
        self._changed = True

    def close(self) -> None:
        """See that not too much is kept."""
        if self._changed:
            self.entries.bound()

    def _holds(self, name: str, about: list[Any], before: str) -> bool:
        key = name, repr(about)
        if key not in self._answers:
            read = (Path(one[0]) if isinstance(one, list) else one for one in about)
            self._answers[key] = answer((name, tuple(read)))
        return self._answers[key] == before


def _plain(asked: Asked, said: str) -> list[Any]:
    """A question and its answer as JSON, in which paths are lists of one."""
    name, about = asked
    return [name, [[str(one)] if isinstance(one, Path) else one for one in about], said]
