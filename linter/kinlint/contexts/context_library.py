"""The JSON-LD contexts that models may name, by IRI: bundled releases and further ones.

Nothing is ever fetched. A context that is not here is unknown, and that is for the reader to say.
"""

from __future__ import annotations

import json
import re
from collections.abc import Hashable, Iterator, Mapping, Sequence
from functools import cache
from pathlib import Path
from types import MappingProxyType
from typing import Any, TypeAlias

from kinlint.contexts.context_dsl import expand_context
from kinlint.errors import ConfigError, UsageError
from kinlint.light_dataclasses import dataclass, field
from kinlint.resources import data
from kinlint.suggestion import did_you_mean, slips
from kinlint.vocabulary import KINLINT

RELEASE_DATES: Mapping[str, str] = MappingProxyType(
    {"59e0b06": "2022-06", "6d34a4f": "2023-10", "ba7e601": "2025-04"}
)
"""The month in which the comp-rob2b authors published each bundled release."""

RELEASES = tuple(RELEASE_DATES)
"""The bundled releases, oldest first, by abbreviated commit of comp-rob2b/metamodels."""

NEWEST = RELEASES[-1]

COMMUNITY = ("secorolab", "hbrs-sesame")
"""Further metamodels that are bundled, each in the state of one commit."""

COMPOSABLE = f"{KINLINT}composable.json"
"""Stands for all documents of the release in force that do not take each other's terms."""

INDEX = "contexts.json"
"""File in a directory of contexts that maps IRIs to relative paths."""

REVISION = re.compile(
    r"^https://(?:raw\.githubusercontent\.com|github\.com|cdn\.jsdelivr\.net/gh)"
    r"/([\w-]+)/([\w.-]+?)(?:/blob|/raw)?(?:/refs/(?:heads|tags))?[/@][\w.-]+/"
)
"""Address of a file in a revision of a repository, up to its path: by owner and name."""

_ALIASES = {
    **{release: release for release in RELEASES},
    **{date: release for release, date in RELEASE_DATES.items()},
    "newest": NEWEST,
}

Document: TypeAlias = dict[str, Any]
Extra: TypeAlias = Path | tuple[str, Path]


@dataclass(frozen=True)
class Contexts:
    """Contexts by IRI under one release."""

    release: str
    """Release of the metamodels whose contexts these are."""
    _further: Mapping[str, Document] = field(default_factory=dict, repr=False)
    _known: dict[str, Document | None] = field(default_factory=dict, repr=False, compare=False)
    memory: dict[Hashable, Any] = field(default_factory=dict, repr=False, compare=False)
    """Results of readers that follow from these documents alone, which never change."""

    @classmethod
    def bundled(cls, release: str | None = None, extra: Sequence[Extra] = ()) -> Contexts:
        """The contexts of *release*, by commit, month or "newest" (the default), and *extra* ones.

        An extra is an IRI with the file that holds it, a directory of contexts, or the
        `contexts.json` of one. Later extras, and extras over bundled contexts, win.

        Raises UsageError for an unknown release, ConfigError for an extra that is no context.
        """
        name = _release_named(release or NEWEST)
        return cls(name, _further(extra)) if extra else _bundled_alone(name)

    def at_release(self, release: str) -> Contexts:
        """Return the same further contexts with another bundled release."""
        return Contexts(_release_named(release), self._further)

    @property
    def extra_documents(self) -> Mapping[str, Document]:
        """The documents that are not bundled, by their IRIs."""
        return self._further

    @property
    def iris(self) -> tuple[str, ...]:
        """The IRIs that `document` answers."""
        ours = (iri for name in self._bundles for iri in _iris(name))
        return tuple(dict.fromkeys([*ours, COMPOSABLE, *self._further]))

    def document(self, iri: str) -> Document | None:
        """The context document at *iri*, `{"@context": ...}`, or None if there is none."""
        if iri not in self._known:
            self._known[iri] = self._further.get(iri) or self._bundled(iri)
        return self._known[iri]

    def resembling(self, iri: str) -> str | None:
        """Return the IRI of the only document that the unknown *iri* can be a slip for.

        They differ in the scheme, in the end of the name, or in at most two letters; or *iri* is
        that of a revision of the file, at GitHub or a mirror of it.
        """
        if "://" not in iri or self.document(iri) is not None:
            return None
        wanted = _plain(REVISION.sub(r"https://\1.github.io/\2/", iri))
        names = {each: _plain(each) for each in self.iris}
        same = [each for each, name in names.items() if name == wanted]
        near = same or [each for each, name in names.items() if slips(wanted, name) is not None]
        return near[0] if len(near) == 1 else None

    def below(self, iri: str) -> tuple[str, ...]:
        """Return the names of known documents in the folder that the unknown *iri* is called as."""
        folder = re.sub(r"(\.json(ld)?)?[#/]*$", "/", iri, count=1)
        return tuple(
            name
            for each in self.iris
            if each.startswith(folder) and "/" not in (name := each.removeprefix(folder))
        )

    def _bundled(self, iri: str) -> Document | None:
        if iri == COMPOSABLE:
            return {"@context": list(self._composed())}
        for name in self._bundles:
            if found := _iris(name).get(iri):
                return {"@context": _local(*found)}
        return None

    @property
    def _bundles(self) -> tuple[str, ...]:
        return self.release, "kinlint", *COMMUNITY

    def _composed(self) -> Iterator[Document]:
        # The contexts themselves, not their IRIs: processors limit how many one may load.
        for name in (self.release, "kinlint"):
            source = bundled_source(name)
            paths = source["composable"] if "composable" in source else source["documents"]
            yield from (_local(name, path) for path in paths)


@cache
def _bundled_alone(release: str) -> Contexts:
    return Contexts(release)


def _plain(iri: str) -> str:
    """Return *iri* without what is often left out or written otherwise."""
    return re.sub(r"^https?://(www\.)?|(\.json|\.jsonld|\.ttl)?[#/]*$", "", iri).casefold()


@cache
def bundled_source(name: str) -> Document:
    """Load the source of the release *name*, or of kinlint's own contexts, from shapes/contexts."""
    path = data("shapes") / "contexts" / f"{name}.json"
    source: Document = json.loads(path.read_text(encoding="utf-8"))
    return source


@cache
def known_terms() -> tuple[frozenset[str], frozenset[str]]:
    """Return the names of all classes and of all properties in the newest bundled contexts."""
    classes: set[str] = set()
    properties: set[str] = set()
    for name in (NEWEST, "kinlint"):
        for document in bundled_source(name)["documents"].values():
            said = document.get("classes", "")
            groups = {said: {}} if isinstance(said, str) else said
            classes.update(each for group in groups for each in group.split())
            for lines in (document.get("properties", {}), *groups.values()):
                properties.update(each for group in lines for each in group.split())
    return frozenset(classes), frozenset(properties)


@cache
def _iris(name: str) -> Mapping[str, tuple[str, str]]:
    """Return the sources and paths of the documents of *name*, by their IRIs.

    What it adopts was published at its own addresses before it moved on.
    """
    source = bundled_source(name)
    return {
        f"{source['base']}{path}.json": (each, path)
        for each in (*source.get("adopts", ()), name)
        for path in bundled_source(each)["documents"]
    }


def _local(name: str, path: str) -> Document:
    source = bundled_source(name)
    return expand_context(source["base"], path, source["documents"][path])


def _release_named(release: str) -> str:
    if release not in _ALIASES:
        known = ", ".join(f"{name} ({date})" for name, date in RELEASE_DATES.items())
        hint = did_you_mean(release, _ALIASES)
        raise UsageError(f"unknown release of the contexts '{release}'{hint}; there are {known}")
    return _ALIASES[release]


def _further(extra: Sequence[Extra]) -> Mapping[str, Document]:
    named = (pair for entry in extra for pair in _named(entry))
    return {iri: _context_document(path) for iri, path in named}


def _named(entry: Extra) -> Iterator[tuple[str, Path]]:
    if isinstance(entry, tuple):
        yield entry
        return
    index = entry / INDEX if entry.is_dir() else entry
    if entry.is_dir() and not index.exists():
        yield from _by_path(entry)
        return
    for iri, relative in _json_object(index).items():
        if not isinstance(relative, str):
            raise ConfigError(f"{index}: the path of '{iri}' must be a string")
        yield iri, index.parent / relative


def _by_path(directory: Path) -> Iterator[tuple[str, Path]]:
    """Without an index, `HOST/PATH` in *directory* answers `https://HOST/PATH`, and http."""
    paths = sorted(path for path in directory.rglob("*.json*") if path.is_file())
    if not paths:
        raise ConfigError(f"{directory}: neither {INDEX} nor any other JSON file in it")
    for path in paths:
        place = path.relative_to(directory).as_posix()
        yield f"https://{place}", path
        yield f"http://{place}", path


def _context_document(path: Path) -> Document:
    document = _json_object(path)
    if "@context" not in document:
        raise ConfigError(f"{path}: not a context document, it has no '@context'")
    return {"@context": document["@context"]}


def _json_object(path: Path) -> Document:
    try:
        found = json.loads(path.read_text(encoding="utf-8-sig"))
    except OSError as cause:
        raise ConfigError(f"{path}: {cause.strerror}") from cause
    except ValueError as cause:
        raise ConfigError(f"{path}: not a JSON file, {cause}") from cause
    if not isinstance(found, dict):
        raise ConfigError(f"{path}: not a JSON object")
    return found
