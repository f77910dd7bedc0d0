"""The configuration of the user's own: what no project can say."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

from kinlint.configuration.user_directories import user_directory
from kinlint.errors import ConfigError
from kinlint.files.pathname import shown

FILE = "config.toml"
KEYS = frozenset({"trusted", "endpoints"})
QUERY, UPDATE = "query", "update"


class StoreAddress(NamedTuple):
    """The addresses of a triple store."""

    query: str
    """The address that takes queries."""
    update: str | None = None
    """The address that takes updates, if it is told."""


def user_file(environment: Mapping[str, str]) -> Path:
    """Return the path of the user's own configuration, which need not exist."""
    return user_directory("settings", environment) / FILE


def read_user_file(path: Path) -> Mapping[str, Any]:
    """Return what the file of the user's own at *path* says. Raises `ConfigError`."""
    if not path.is_file():
        return {}
    import tomllib  # noqa: PLC0415  few users have a configuration of their own

    try:
        said = tomllib.loads(path.read_text("utf-8"))
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as error:
        raise ConfigError(f"{shown(path)}: {error}") from None
    if set(said) - KEYS:
        known = "trusted = [directories] and [endpoints]"
        raise ConfigError(f"{shown(path)}: expected {known}, and nothing else")
    return said


def known_store(name: str, environment: Mapping[str, str]) -> StoreAddress | None:
    """Return the addresses of the store that the user calls *name*. Raises `ConfigError`."""
    path = user_file(environment)
    stores = read_user_file(path).get("endpoints", {})
    found = stores.get(name) if isinstance(stores, dict) else 0
    match found:
        case None:
            return None
        case str():
            return StoreAddress(found)
        case {"query": str(query), **more} if set(more) <= {UPDATE}:
            update = more.get(UPDATE)
            if update is None or isinstance(update, str):
                return StoreAddress(query, update)
    kinds = f'"URL" or {{ {QUERY} = "URL", {UPDATE} = "URL" }}'
    raise ConfigError(f"{shown(path)}: endpoints: {name}: expected {kinds}")
