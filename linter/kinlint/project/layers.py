"""Puts configuration files and options together into the settings of a run."""

from __future__ import annotations

import os
from collections.abc import Iterable, Mapping, Sequence
from functools import cached_property
from pathlib import Path
from typing import Any

from kinlint.configuration.config_file import Config, Configs
from kinlint.configuration.settings import FileSettings, Ignore, Settings
from kinlint.configuration.user_directories import user_directory
from kinlint.contexts.context_library import NEWEST, Contexts
from kinlint.errors import ConfigError, UsageError
from kinlint.files.pathglob import Glob, absolute
from kinlint.files.pathname import missing, shown
from kinlint.light_dataclasses import dataclass, field
from kinlint.project.discovery import SKIPPED, Input

DEFAULTS: Mapping[str, Any] = {
    "contexts": NEWEST,
    "extra_contexts": {},
    "context_directories": (),
    "rules": (),
    "shapes": (),
    "partial": False,
    "engine": "oxigraph",
}
WIDE = tuple(DEFAULTS)
"""Keys that concern the one graph that all files make."""
ADDED = ("extra_contexts", "rules", "shapes")
"""Keys whose values add up over configurations, for all files.

On the rest of `WIDE` they must agree.
"""


@dataclass
class Layers:
    """The configuration of each directory: options on top of its file."""

    files: Configs
    """The configuration files."""
    top: Config
    """The options."""
    here: Path = field(default_factory=Path.cwd)
    """The directory that default exclusions are relative to."""
    _known: dict[Path, Config] = field(default_factory=dict)

    def config_for(self, directory: Path) -> Config:
        """Return the configuration that holds in *directory*, an absolute path."""
        if directory not in self._known:
            below = self.files.nearest(directory) or Config("defaults")
            self._known[directory] = below.extended_by(self.top)
        return self._known[directory]

    def exclusions(self, directory: Path) -> Sequence[Glob]:
        """The patterns of what to pass over in *directory*."""
        config = self.config_for(directory)
        exclude = self._skipped if config.exclude is None else config.exclude
        return (*exclude, *config.extend_exclude)

    def respects_gitignore(self, directory: Path) -> bool:
        """Tell whether what git ignores in *directory* is passed over."""
        return self.config_for(directory).respect_gitignore is not False

    @cached_property
    def _skipped(self) -> tuple[Glob, ...]:
        return tuple(Glob(self.here, name) for name in SKIPPED)

    def project_config(self, inputs: Iterable[Input]) -> Config:
        """The configuration nearest to the directory that all *inputs* have in common."""
        folders = {str(governing_directory(one)) for one in inputs}
        return self.config_for(Path(os.path.commonpath(folders)) if folders else self.here)

    def origin(self, one: Input) -> str:
        """Return the name, for messages, of the configuration that governs *one*."""
        return self._home(one).origin

    def untrusted(self, inputs: Iterable[Input]) -> list[Config]:
        """Return the configurations of *inputs* of which a part does not count."""
        found = {id(config): config for config in map(self._home, inputs)}
        return [config for config in found.values() if config.untrusted]

    def settings(
        self, inputs: Sequence[Input], directories: Iterable[Path] = (), **given: Any
    ) -> Settings:
        """The settings of a run over *inputs*; *given* are those that only options decide.

        *directories* are those that were searched for *inputs*. Raises `ConfigError` if files
        differ in what concerns the whole graph.
        """
        project = self.project_config(inputs)
        wide = self._wide(project, inputs)
        wide["contexts"] = _release(wide["contexts"], self.top if self.top.contexts else project)
        for name in ("rules", "shapes"):
            _exist(wide[name], f"{self._source(name, project)}: {name}")
            _exist(more := given.pop(name, ()), f"--{name}")
            wide[name] = (*wide[name], *more)
        contexts = (*wide["context_directories"], *wide["extra_contexts"].values())
        source = self._source("context_directories", project)
        _exist(contexts, f"{self._source('extra_contexts', project, source)}: extra-contexts")
        return Settings(
            **wide,
            unsafe_fixes=project.unsafe_fixes,
            file_timeout=project.file_timeout or None,
            linted=tuple(dict.fromkeys((*directories, *_unless_home(self.here)))),
            default=_file(project, self.here),
            files={
                one.name: _file(self.config_for(governing_directory(one)), _path(one))
                for one in inputs
            },
            **given,
        )

    def _source(self, name: str, project: Config, source: str = "") -> str:
        """Return who sets *name*: the options, which come on top, or the configuration."""
        return "--config" if getattr(self.top, name) is not None else source or project.origin

    def _wide(self, project: Config, inputs: Iterable[Input]) -> dict[str, Any]:
        """The value of each key of `WIDE`."""
        configs = list({id(each): each for each in map(self._home, inputs)}.values()) or [project]
        each = [_graph_settings(config, project) for config in configs]
        contexts: dict[str, Path] = {}
        for config, said in zip(configs, each, strict=True):
            for key in WIDE:
                if key not in ADDED and said[key] != each[0][key]:
                    raise ConfigError(_disagreement(key, config, configs[0]))
            for iri, file in said["extra_contexts"].items():
                if contexts.setdefault(iri, file) != file:
                    raise ConfigError(_disagreement("extra_contexts", config, configs[0]))
        added = {
            key: tuple(dict.fromkeys(one for said in each for one in said[key]))
            for key in ("rules", "shapes")
        }
        return {**each[0], **added, "extra_contexts": contexts}

    def _home(self, one: Input) -> Config:
        return self.config_for(governing_directory(one))


def _unless_home(directory: Path) -> tuple[Path, ...]:
    """Return *directory*, unless it holds the home directory: all of that is no workspace."""
    home = absolute(os.path.expanduser("~"))  # noqa: PTH111  never fails
    return () if home.is_relative_to(directory) else (directory,)


def governing_directory(one: Input) -> Path:
    """The directory whose configuration governs *one*."""
    return _path(one).parent


def _path(one: Input) -> Path:
    """Return the path by which *one* is governed; files by URL are as below the working directory.

    So nothing in a bucket configures a run.
    """
    if one.remote:
        return Path(os.path.abspath(one.name))  # noqa: PTH100  not that of its mirror
    return absolute(one.name) if one.path is None else one.path


def _file(config: Config, path: Path) -> FileSettings:
    entries = (*(config.per_file_ignores or ()), *config.extend_per_file_ignores)
    return FileSettings(
        choices=config.choices,
        ignores=tuple(
            Ignore(one.selectors, one.key, one.origin, one.pointer, one.iri, one.place)
            for one in entries
            if one.iri is not None or one.glob.covers(path)
        ),
        require_reason=bool(config.require_reason),
        targets=_targets(config, path),
        packages=config.packages,
        workspace=config.home,
        xacro_args=tuple(
            (one.name, one.value)
            for one in config.xacro_args
            if one.glob is None or one.glob.covers(path)
        ),
        xacro_env=config.xacro_env or (),
        urdf=next((urdf for glob, urdf in config.srdf or () if glob.covers(path)), None),
    )


def _targets(config: Config, path: Path) -> tuple[str, ...]:
    """Return the consumers that the file at *path* is meant for, each once."""
    more = (names for glob, names in config.per_file_target or () if glob.covers(path))
    every = (*(config.target or ()), *(name for names in more for name in names))
    return tuple(dict.fromkeys(every))


def _release(name: str, config: Config) -> str:
    """The release that *config* calls *name*."""
    try:
        return Contexts.bundled(name).release
    except UsageError as error:
        raise type(error)(f"{config.origin}: contexts: {error}") from None


def _graph_settings(config: Config, project: Config) -> dict[str, Any]:
    """Return the values of the keys of `WIDE` by *config*, else by *project*, else the defaults."""
    said = {key: getattr(config, key) for key in WIDE}
    said = {key: getattr(project, key) if value is None else value for key, value in said.items()}
    return {key: DEFAULTS[key] if value is None else value for key, value in said.items()}


def _exist(paths: Iterable[Path], key: str) -> None:
    """Raise `ConfigError` if one of *paths*, which *key* names, is not there."""
    for path in paths:
        if not path.exists():
            raise ConfigError(f"{key}: {shown(path)}: {missing(path)}")


def _disagreement(key: str, one: Config, other: Config) -> str:
    name = "extra-contexts" if key == "context_directories" else key.replace("_", "-")
    return (
        f"{one.origin} and {other.origin} differ in '{name}', but all files of a run are one graph;"
        f" say it on the command line, or lint the files apart"
    )


def cache_directory(environment: Mapping[str, str], given: str | None = None) -> Path:
    """Return the directory *given*, else KINLINT_CACHE_DIR, else where this system keeps caches."""
    if given:
        return Path(given)
    if said := environment.get("KINLINT_CACHE_DIR"):
        return Path(said)
    return user_directory("cache", environment)
