"""Settings from the user's editor, which come on top of configuration files."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from pathlib import Path
from typing import Any

from kinlint.configuration.config_file import Config, Configs, load_config, parse_config
from kinlint.configuration.project_trust import ProjectTrust
from kinlint.configuration.value_kinds import unknown_message
from kinlint.errors import ConfigError, KinlintError
from kinlint.files.pathglob import absolute
from kinlint.light_dataclasses import dataclass, field

ORIGIN = "editor settings"
LISTS = {
    "select": "select",
    "extendSelect": "extend-select",
    "ignore": "ignore",
    "target": "target",
}
"""Settings that are keys of configuration files."""
RUNS = ("onType", "onSave")
KNOWN = (*LISTS, "configuration", "run", "trust", "unsafeFixes")


@dataclass(frozen=True)
class ClientSettings:
    """Settings that a client sends."""

    keys: Mapping[str, Any] = field(default_factory=dict)
    """Keys of configuration files, which override these."""
    file: str | None = None
    """The only configuration file, if given."""
    on_save: bool = False
    """True if texts are analyzed when they are saved."""
    unsafe_fixes: bool = True
    """True if unsafe fixes are offered, too."""
    trust: bool = False
    """True if the configuration of every project may add rules and shapes."""
    problems: tuple[str, ...] = ()
    """Messages about settings that cannot be used."""

    @classmethod
    def from_json(cls, said: object) -> ClientSettings:
        """Parse the settings a client sends, in any of the forms that clients use."""
        settings = _settings(said)
        keys: dict[str, Any] = {}
        problems = [
            f"{ORIGIN}: {problem}" for name in settings if (problem := unknown_message(name, KNOWN))
        ]
        configuration = settings.get("configuration")
        if isinstance(configuration, Mapping):
            keys |= configuration
        keys |= {key: settings[name] for name, key in LISTS.items() if settings.get(name)}
        run = settings.get("run", RUNS[0])
        if run not in RUNS:
            problems.append(f"{ORIGIN}: run: expected one of {', '.join(RUNS)}, got '{run}'")
        try:
            parse_config(keys, ORIGIN, Path(os.sep))
        except KinlintError as error:
            problems.append(str(error))
            keys = {}
        return cls(
            keys=keys,
            file=configuration if isinstance(configuration, str) and configuration else None,
            on_save=run == RUNS[1],
            unsafe_fixes=bool(settings.get("unsafeFixes", True)),
            trust=bool(settings.get("trust", False)),
            problems=tuple(problems),
        )

    def top(self, root: Path) -> Config:
        """Return the configuration that overrides configuration files.

        Paths are relative to *root*.
        """
        return parse_config(self.keys, ORIGIN, root)

    def configs(self, root: Path) -> Configs:
        """Return where configuration comes from below *root*.

        The file the client names, or the nearest. Raises `ConfigError` if the named file does not
        exist.
        """
        if self.file is None:
            trust = ProjectTrust.from_user(os.environ, everything=self.trust)
            return Configs(restrict=trust.restricted, may_extend=trust.may_extend)
        path = absolute(root / Path(self.file).expanduser())
        if not path.is_file():
            raise ConfigError(f"{ORIGIN}: configuration: '{self.file}' is not a file")
        return Configs(fixed=load_config(path))


def _settings(said: object) -> Mapping[str, Any]:
    """The settings within `settings`, `kinlint` and `lint`, which some clients put round them."""
    found = dict(said) if isinstance(said, Mapping) else {}
    unwrap: Callable[[str], Any] = found.get
    for name in ("settings", "kinlint", "lint"):
        if isinstance(inner := unwrap(name), Mapping):
            found.pop(name)
            found |= inner
    return {name: value for name, value in found.items() if value is not None}
