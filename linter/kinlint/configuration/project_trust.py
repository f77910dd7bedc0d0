"""Trust in projects: whose own rules run, and whose xacro files see the environment.

A repository brings its own configuration. What that selects is harmless; the rules and shapes that
it adds, and the environment variables that it asks for, count only where the user says so: with
`--trust`, or with `trusted = [directories]` in a configuration of the user's own.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path

from kinlint.configuration.config_file import Config
from kinlint.errors import ConfigError
from kinlint.files.pathglob import absolute
from kinlint.files.pathname import shown
from kinlint.light_dataclasses import dataclass, replace

GUARDED: Mapping[str, str] = {"rules": "rules", "shapes": "shapes", "xacro_env": "xacro-env"}
"""Fields of a configuration that count in trusted projects only, with their keys."""
FILE = "config.toml"


@dataclass(frozen=True)
class ProjectTrust:
    """The projects that the user trusts."""

    everything: bool = False
    """True if every project is trusted in this run."""
    directories: Sequence[Path] = ()
    """Directories below which every project is trusted."""

    @classmethod
    def from_user(
        cls, environment: Mapping[str, str], *, everything: bool | None = False
    ) -> ProjectTrust:
        """Return the trust that the user's own configuration states. Raises `ConfigError`."""
        return cls(bool(everything), _trusted(user_file(environment)))

    def restricted(self, config: Config) -> Config:
        """Return *config* of a project without what the user does not trust it with."""
        home = config.home
        if self.everything or home is None or any(map(home.is_relative_to, self.directories)):
            return config
        kept = tuple(name for name in GUARDED if getattr(config, name))
        return replace(config, rules=None, shapes=None, xacro_env=None, untrusted=kept)


def user_file(environment: Mapping[str, str]) -> Path:
    """Return the path of the user's own configuration, which need not exist."""
    if sys.platform == "win32":
        base = Path(environment.get("APPDATA") or Path.home() / "AppData" / "Roaming")
    elif sys.platform == "darwin":
        base = Path.home() / "Library" / "Application Support"
    else:
        base = Path(environment.get("XDG_CONFIG_HOME") or Path.home() / ".config")
    return base / "kinlint" / FILE


def untrusted_message(config: Config) -> str:
    """Return the line that tells what of *config* does not count."""
    keys = " and ".join(GUARDED[name] for name in config.untrusted)
    where = f"trusted = ['{config.home}'] in {user_file(os.environ)}"
    return f"{config.origin}: {keys} left out: you do not trust this project; --trust, or {where}"


def _trusted(path: Path) -> tuple[Path, ...]:
    if not path.is_file():
        return ()
    import tomllib  # noqa: PLC0415  few users have a configuration of their own

    try:
        said = tomllib.loads(path.read_text("utf-8"))
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise ConfigError(f"{shown(path)}: {error}") from None
    found = said.get("trusted", [])
    if set(said) - {"trusted"} or not isinstance(found, list):
        raise ConfigError(f"{shown(path)}: expected trusted = [directories], and nothing else")
    if not all(isinstance(each, str) for each in found):
        raise ConfigError(f"{shown(path)}: trusted: expected strings")
    return tuple(absolute(path.parent / os.path.expanduser(each)) for each in found)  # noqa: PTH111
