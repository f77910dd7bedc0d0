"""A folder of the workspace, or the open files of a folder outside it: a lint run of its own."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from pathlib import Path

from kinlint.configuration.project_trust import untrusted_message
from kinlint.configuration.settings import Settings
from kinlint.errors import SourceError
from kinlint.files.pathname import shown
from kinlint.formats.dependencies.companions import pair
from kinlint.formats.dependencies.file_groups import group_sources, join_keys
from kinlint.formats.options import ReadOptions
from kinlint.formats.records import JSON
from kinlint.formats.yaml.format import YAML
from kinlint.light_dataclasses import dataclass, replace
from kinlint.project.discovery import Input, Search
from kinlint.project.layers import Layers
from kinlint.project.model_detection import is_model
from kinlint.project.reading import own_contexts
from kinlint.project.turtle_parts import TurtleParts
from kinlint.server.document_store import DocumentStore
from kinlint.server.frozen_state import FrozenState
from kinlint.text import PerText, SourceText


@dataclass(frozen=True)
class Model:
    """Files that are judged together."""

    paths: Mapping[str, Path]
    """The paths of the files by their names."""
    sources: tuple[SourceText, ...]
    """The texts."""
    settings: Settings
    """The settings of the run."""
    beside: tuple[SourceText, ...] = ()
    """Companion files that the model was written for."""
    errors: tuple[SourceError, ...] = ()
    """The files that cannot be read at all."""

    @property
    def key(self) -> frozenset[Path]:
        """Return the paths of the model's files, which identify it whatever they contain."""
        return frozenset(self.paths.values())


class WorkspaceFolder:
    """The models below a directory, found as `kinlint DIRECTORY` finds them.

    A *loose* one has only what is open.
    """

    def __init__(self, directory: Path, snapshot: FrozenState, cache: Path, *, loose: bool) -> None:
        self.directory, self._loose, self._cache = directory, loose, cache
        preferences = snapshot.preferences
        self._layers = Layers(
            preferences.configs(directory), preferences.top(directory), here=directory
        )
        self._settings: dict[frozenset[str], Settings] = {}
        self._verdicts: dict[Path, tuple[SourceText, bool]] = {}
        self._own_contexts: dict[Path, Sequence[str]] = {}
        self._ties = PerText(join_keys)
        self._found: list[Input] = []
        self._turtle: list[Input] = []
        self._parts = TurtleParts()
        if not loose:
            layers = self._layers
            search = Search(layers.exclusions, gitignored=layers.respects_gitignore)
            found = search.find([str(directory)])
            self._found = [
                one for one in found.inputs if one.path and self._own(one.path, snapshot)
            ]
            self._turtle = [
                Input(shown(path), path, named=False)
                for path in found.turtle
                if self._own(path, snapshot)
            ]

    def _own(self, path: Path, snapshot: FrozenState) -> bool:
        root = snapshot.root_of(path)
        return path.parent == self.directory if root is None else root == self.directory

    def _inputs(self, snapshot: FrozenState) -> Iterator[Input]:
        """Yield the files that a search found, and open ones that are not excluded."""
        known = {one.path for one in self._found}
        yield from self._found
        for path in snapshot.buffers:
            if path not in known and self._own(path, snapshot) and not self._excluded(path):
                yield Input(shown(path), path, named=False)

    def _excluded(self, path: Path) -> bool:
        return any(pattern.covers(path) for pattern in self._layers.exclusions(path.parent))

    def models(self, documents: DocumentStore) -> Iterator[Model]:
        """The models, as the files are now. Raises `UsageError` for a wrong configuration."""
        sources: list[SourceText] = []
        given: dict[str, Input] = {}
        inputs = sorted(self._inputs(documents.snapshot), key=lambda one: one.name)
        for one in inputs:
            given[one.name] = one
            try:
                source = documents.text(one)
            except SourceError as error:
                yield Model(_paths([one]), (), self._of([one]), errors=(error,))
                continue
            if self._is_model(one, source):
                sources.append(source)
        if self._turtle and sources:
            given.update((one.name, one) for one in self._turtle)
            sources += self._turtle_parts(sources, documents)
        settings = self._of([given[each.name] for each in sources])
        for group in self._groups(sources, settings, documents):
            own = [source for source in group if not source.companion]
            if not own:
                continue
            inputs = [given[source.name] for source in own]
            settings = self._of(inputs)
            paired = pair(group, settings, documents.overlay)
            more = [source for source in paired if source.companion]
            own = [source for source in paired if not source.companion]
            yield Model(_paths(inputs), tuple(own), settings, tuple(more))

    def _groups(
        self, sources: Sequence[SourceText], settings: Settings, documents: DocumentStore
    ) -> Iterator[Sequence[SourceText]]:
        """Yield *sources* by models; YAML is paired with robots first, and has its companions."""
        if any(each.format == YAML for each in sources):
            sources = pair(sources, settings, documents.overlay)
        yield from group_sources(sources, self._ties) if sources else ()

    def _turtle_parts(
        self, sources: Sequence[SourceText], documents: DocumentStore
    ) -> Sequence[SourceText]:
        """Return the Turtle files that describe what *sources* only name."""

        def options() -> ReadOptions:
            return replace(
                ReadOptions.from_settings(self._of(self._found)), overlay=documents.overlay
            )

        texts = list[SourceText]()
        for one in self._turtle:
            with suppress(SourceError):
                texts.append(documents.text(one))
        return self._parts.find(sources, texts, options)

    def untrusted(self) -> list[str]:
        """Return the messages about configurations of which a part does not count."""
        return list(map(untrusted_message, self._layers.untrusted(self._found)))

    def _is_model(self, one: Input, source: SourceText) -> bool:
        assert one.path is not None
        known = self._verdicts.get(one.path)
        if known is None or known[0] is not source:
            own = self._contexts(one.path.parent, one) if one.path.suffix == JSON else ()
            known = source, is_model(source, own)
            self._verdicts[one.path] = known
        return known[1]

    def _contexts(self, directory: Path, one: Input) -> Sequence[str]:
        if directory not in self._own_contexts:
            self._own_contexts[directory] = own_contexts(self._of([one]))
        return self._own_contexts[directory]

    def _of(self, inputs: Sequence[Input]) -> Settings:
        names = frozenset(one.name for one in inputs)
        if names not in self._settings:
            self._settings[names] = self._layers.settings(inputs, cache=self._cache)
        return self._settings[names]


def _paths(inputs: Iterable[Input]) -> Mapping[str, Path]:
    return {one.name: one.path for one in inputs if one.path is not None}
