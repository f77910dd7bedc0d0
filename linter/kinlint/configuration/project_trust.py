"""Trust in projects: whose own rules run, and whose xacro files see the environment.

A repository brings its own configuration. What that selects is harmless; the rules and shapes that
it adds, the environment variables that it asks for, and paths that lead out of it and of where
kinlint runs, except to ROS packages, count only where the user says so: with `--trust`, or with
`trusted = [directories]` in a configuration of the user's own.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from kinlint.configuration.config_file import Config
from kinlint.configuration.user_configuration import read_user_file, user_file
from kinlint.errors import ConfigError
from kinlint.files.packages import package_name, working_copies
from kinlint.files.pathglob import absolute
from kinlint.files.pathname import real, shown
from kinlint.light_dataclasses import dataclass, replace

GUARDED: Mapping[str, str] = {"rules": "rules", "shapes": "shapes", "xacro_env": "xacro-env"}
"""Fields of a configuration that count in trusted projects only, with their keys."""
LEADING: Mapping[str, str] = {
    "packages": "packages",
    "extra_contexts": "extra-contexts",
    "context_directories": "extra-contexts",
    "baseline": "baseline",
    "srdf": "srdf",
}
"""Fields whose paths lead out of their project in trusted projects only, with their keys."""


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
        if home is None or self._trusts(home):
            return config
        inside = dict(_inside(config, home))
        left_out = tuple(name for name in GUARDED if getattr(config, name))
        shortened = tuple(name for name in inside if inside[name] != getattr(config, name))
        guarded: dict[str, Any] = dict.fromkeys(GUARDED)
        untrusted = (*config.untrusted, *left_out, *shortened)
        return replace(config, **guarded, **inside, untrusted=untrusted)

    def may_extend(self, directory: Path, path: Path) -> bool:
        """Tell whether the configuration of the project in *directory* may extend that at *path*.

        Of untrusted projects no file elsewhere is read, as its keys would be told in messages.
        """
        return self._trusts(directory) or _reach(directory)(path)

    def _trusts(self, home: Path) -> bool:
        return self.everything or any(map(home.is_relative_to, self.directories))


def _reach(home: Path) -> Callable[[Path], bool]:
    """Return the test whether a path stays in the project at *home*."""
    around = Path.cwd()
    is_part = home.is_relative_to(around) and not Path.home().is_relative_to(around)
    above = (around,) if is_part else ()
    roots = [real(each) for each in (home, *above, *working_copies(home))]

    def stays(path: Path) -> bool:
        target = real(path)
        return any(map(target.is_relative_to, roots))

    return stays


def _inside(config: Config, home: Path) -> Iterator[tuple[str, Any]]:
    """Yield the fields of `LEADING` with the paths that stay in the project at *home*."""
    stays = _reach(home)
    yield (
        "packages",
        tuple(each for each in config.packages if stays(each[1]) or package_name(each[1])),
    )
    if config.extra_contexts is not None:
        kept = {iri: path for iri, path in config.extra_contexts.items() if stays(path)}
        yield "extra_contexts", kept
    if config.context_directories is not None:
        yield "context_directories", tuple(filter(stays, config.context_directories))
    if config.srdf is not None:
        yield "srdf", tuple(each for each in config.srdf if stays(each[1]) or _packaged(each[1]))
    if config.baseline is not None and not stays(config.baseline):
        yield "baseline", None


def _packaged(path: Path) -> bool:
    """Tell whether *path* lies in a ROS package."""
    return any(package_name(each) is not None for each in path.parents)


def untrusted_message(config: Config) -> str:
    """Return the line that tells what of *config* does not count."""
    leading = {**LEADING, "extend": "extend"}
    known = {**GUARDED, **{name: f"{key} outside of it" for name, key in leading.items()}}
    keys = " and ".join(dict.fromkeys(known[name] for name in config.untrusted))
    where = f"trusted = ['{config.home}'] in {user_file(os.environ)}"
    return f"{config.origin}: {keys} left out: you do not trust this project; --trust, or {where}"


def _trusted(path: Path) -> tuple[Path, ...]:
    found = read_user_file(path).get("trusted", [])
    if not isinstance(found, list) or not all(isinstance(each, str) for each in found):
        raise ConfigError(f"{shown(path)}: trusted: expected strings")
    return tuple(absolute(path.parent / os.path.expanduser(each)) for each in found)  # noqa: PTH111
