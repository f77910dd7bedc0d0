"""Cache keys of reports: a digest of texts, rules, settings, and kinlint itself."""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Mapping, Sequence
from hashlib import sha256
from pathlib import Path
from typing import Any

from kinlint import __version__, resources
from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.settings import FileSettings, Settings
from kinlint.contexts.context_library import Contexts, Extra
from kinlint.formats.dependencies.mentions import includes_nothing
from kinlint.installation import Installation
from kinlint.light_dataclasses import dataclass, field, fields, is_dataclass, replace
from kinlint.rule import Severity
from kinlint.text import SourceText

FOLLOWS = ("text", "format")
"""Fields of a text that the digest of its characters and its name stand for."""
DATA = (".json", ".rq", ".ttl", ".tsv", ".csv")
"""Suffixes of the files of `shapes/` that decide what a report says."""
LIBRARIES = ("owlrl", "pyld", "pyoxigraph", "pyshacl", "pyyaml", "rdflib", "xacro")
"""Libraries whose versions are part of the key."""


@dataclass(frozen=True)
class CacheKeys:
    """The common part of all keys of a run."""

    settings: Settings
    """The settings of the run."""
    book: Rulebook
    """Its rules."""
    fixing: bool
    """True if reports contain fixes."""
    least: Severity
    """Least severity of findings that have them."""
    _base: str = field(init=False, repr=False)
    _known: dict[int, str] = field(default_factory=dict, repr=False)

    def __post_init__(self) -> None:
        wide = replace(self.settings, files={}, cache=None, verbose=False, file_timeout=None)
        extra: Sequence[Extra] = (
            *wide.context_directories,
            *wide.extra_contexts.items(),
        )
        installed = self.book.installation
        said = [
            __version__,
            sys.version,
            sys.platform,
            *_libraries(),
            installed.digest("code", self.settings.cache, lambda: _code(installed)),
            os.getcwd(),  # noqa: PTH109  a text
            self.book.digest,
            (self.fixing, self.least.label),
            plain(wide),
            dict(Contexts.bundled(wide.contexts, extra).extra_documents) if extra else {},
        ]
        object.__setattr__(self, "_base", _digest(said))

    def key(self, sources: Sequence[SourceText], *, complete: bool) -> str:
        """Return the key of the report of *sources*.

        *complete* tells that no file was left unread.
        """
        each = [[plain(one), self._file(self.settings.for_file(one.name))] for one in sources]
        others = [] if all(map(includes_nothing, sources)) else self._special()
        return _digest([self._base, complete, each, others])

    def _special(self) -> list[list[str]]:
        """The settings of files that are not governed like those that a model only includes."""
        usual = self._file(self.settings.default)
        files = self.settings.files.items()
        return [[name, own] for name, one in files if (own := self._file(one)) != usual]

    def _file(self, settings: FileSettings) -> str:
        if id(settings) not in self._known:
            self._known[id(settings)] = _digest(plain(settings))
        return self._known[id(settings)]


def plain(value: Any) -> Any:
    """*value*, made of frozen data, as JSON that differs where it does; of texts, a digest."""
    if isinstance(value, SourceText):
        data = value.text.encode("utf-8", "surrogatepass")
        more = [
            [one.name, getattr(value, one.name)] for one in fields(value) if one.name not in FOLLOWS
        ]
        return [sha256(data).hexdigest(), repr(more)]
    if is_dataclass(value):
        return [type(value).__name__, *(plain(getattr(value, one.name)) for one in fields(value))]
    if isinstance(value, Mapping):
        return [[plain(key), plain(one)] for key, one in value.items()]
    if isinstance(value, tuple):
        return [plain(one) for one in value]
    return value if value is None or isinstance(value, bool) else f"{type(value).__name__} {value}"


def _digest(value: Any) -> str:
    return sha256(json.dumps(value).encode()).hexdigest()


def _code(installed: Installation) -> str:
    """A digest of kinlint itself, which in a checkout changes without its version."""
    shapes = f"{resources.data('shapes')}{os.sep}"
    digest = sha256()
    for path, *_ in installed.files:
        if path.endswith(".py" if not path.startswith(shapes) else DATA):
            digest.update(f"\0{os.path.basename(path)}\0".encode())  # noqa: PTH119  a text
            digest.update(Path(path).read_bytes())
    return digest.hexdigest()


def _libraries() -> list[str]:
    """The versions of `LIBRARIES`, without loading what could tell them better."""
    found = []
    for entry in sys.path:
        try:
            names = os.listdir(entry or ".")  # noqa: PTH208  as few steps as can be
        except OSError:
            continue
        found += [
            name
            for name in names
            if name.endswith(".dist-info") and name.partition("-")[0].lower() in LIBRARIES
        ]
    return sorted(found)
