"""Targets of a run: consumers, each with the version that is meant."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from typing import NamedTuple

from kinlint.errors import UsageError
from kinlint.suggestion import did_you_mean
from kinlint.targets.consumer_files import consumer_table
from kinlint.targets.version_range import Version, VersionRange, read_version


class Target(NamedTuple):
    """A consumer that a file is meant for."""

    name: str
    """Name of the consumer, such as `mujoco`."""
    version: Version | None = None
    """The version that is meant; None for the newest."""

    @property
    def text(self) -> str:
        """Return the target as an option spells it: `mujoco@3.3`."""
        return f"{self.name}@{'.'.join(map(str, self.version))}" if self.version else self.name


def read_target(text: str) -> Target:
    """Return the target that *text*, `NAME` or `NAME@VERSION`, spells.

    Raises `UsageError` for what is no version.
    """
    name, at, version = text.partition("@")
    if not at:
        return Target(name)
    try:
        return Target(name, read_version(version))
    except ValueError:
        message = f"target '{text}': expected a version such as {name}@3.3, got '{version}'"
        raise UsageError(message) from None


def checked_target(text: str, names: Collection[str]) -> Target:
    """Return the target that *text* spells, of a consumer that is one of *names*.

    Raises `UsageError` for other names, and for a version far beyond those that are known.
    """
    target = read_target(text)
    if target.name not in names:
        meant = did_you_mean(target.name, names) or f"; there are {', '.join(sorted(names))}"
        raise UsageError(f"unknown target '{target.name}'{meant}")
    if target.version:
        table = consumer_table()
        members = (table.consumers.get(each) for each in table.members(target.name))
        known = [each for each in members if each is not None and each.releases]
        newest = (read_version(each.releases[-1])[0] for each in known)
        if known and target.version[0] > max(newest) + 1:
            told = (f"{each.label} are {', '.join(each.releases)}" for each in known)
            raise UsageError(f"target '{text}': known versions of {'; of '.join(told)}")
    return target


def chosen_targets(texts: Iterable[str]) -> tuple[Target, ...]:
    """Return the targets that *texts* spell; a name that stands for several consumers is each.

    With a version it is those that have a release of that number, where one has.
    """
    return tuple(dict.fromkeys(each for text in texts for each in _members(read_target(text))))


def _members(target: Target) -> Iterator[Target]:
    table = consumer_table()
    names = table.members(target.name)
    if target.version:
        major = target.version[0]
        known = [
            name
            for name in names
            if any(read_version(each)[0] == major for each in table.consumers[name].releases)
        ]
        names = tuple(known) or names
    return (Target(name, target.version) for name in names)


def names_of(texts: Iterable[str]) -> tuple[str, ...]:
    """Return the names of consumers that *texts* spell, with those of which they are a part."""
    table = consumer_table()
    every = (name for text in texts for name in table.names_with(read_target(text).name))
    return tuple(sorted(set(every)))


def means_one(chosen: Iterable[Target], names: Iterable[str], versions: VersionRange) -> bool:
    """Tell whether one of *chosen* is one of the consumers *names*, in one of *versions*."""
    table = consumer_table()
    wanted = set(names)
    return any(
        not wanted.isdisjoint(table.names_with(each.name)) and versions.has(each.version)
        for each in chosen
    )
