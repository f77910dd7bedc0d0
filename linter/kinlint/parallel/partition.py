"""Divides the files of a run into models, and models into shares that are linted together."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import TypeAlias

from kinlint.configuration.settings import Settings
from kinlint.formats.dependencies.file_groups import CONFIGURATIONS, group_sources
from kinlint.parallel.unread import is_closed, keys_of, size
from kinlint.text import SourceText

Model: TypeAlias = Sequence[SourceText]
"""Files that are judged together."""
MOST = 8
"""Largest number of models in a shard.

Each shard loads what all models need, and each query of a shard goes through all its models: for
small robots, eight take the least time.
"""


def partition(sources: Sequence[SourceText], settings: Settings) -> list[Model]:
    """Split *sources* into models that can be checked apart, which may be one."""
    return (
        [*group_sources(sources, keys_of)] if sources and _separable(settings) else [list(sources)]
    )


def is_divisible(sources: Sequence[SourceText], settings: Settings) -> bool:
    """Tell whether *sources* are several models that can be checked apart."""
    return len(partition(sources, settings)) > 1


def _separable(settings: Settings) -> bool:
    """Tell whether no configured suppression names an entity that several models might have."""
    every = (settings.default, *settings.files.values())
    ignores = [ignore for each in every for ignore in each.ignores]
    return not any(each.iri is not None or each.pointer is not None for each in ignores)


def split_into_shares(
    found: Sequence[Model], least: int, settings: Settings, *, recorded: bool
) -> list[list[int]]:
    """The numbers of the models *found*, in *least* shares or more, the largest first.

    If it is *recorded* what models depend on, one that may include other files is a share of its
    own; so is one with a configuration.
    """
    joint = [
        number
        for number, each in enumerate(found)
        if not settings.drawn and not _stands_alone(each, recorded=recorded)
    ]
    apart = set(range(len(found))).difference(joint)
    count = min(len(joint), max(least - len(apart), -(-len(joint) // MOST)))
    made: list[list[int]] = [[] for _ in range(count)]
    sizes = [0] * count
    for number in sorted(joint, key=lambda one: -_size(found[one])):
        smallest = min(range(count), key=lambda one: (len(made[one]) >= MOST, sizes[one]))
        made[smallest].append(number)
        sizes[smallest] += _size(found[number])
    every = [*([n] for n in apart), *(sorted(each) for each in made)]
    return sorted(every, key=lambda share: -sum(_size(found[one]) for one in share))


def split_in_order(
    found: Sequence[Model], least: int, settings: Settings, *, recorded: bool
) -> list[list[int]]:
    """The numbers of the models *found*, in *least* shares or more, by the names of their files.

    Those that may include other files go first, and if it is *recorded* what models depend on, each
    in a share of its own; so is one with a configuration.
    """
    order = sorted(range(len(found)), key=lambda number: first_name(found[number]))
    if settings.drawn:
        return [[number] for number in order]
    width = max(1, min(MOST, -(-len(order) // least)))
    closed = [number for number in order if first_name(found[number])]
    opened = order[: len(order) - len(closed)]
    alone = [number for number in opened if _stands_alone(found[number], recorded=recorded)]
    others = [number for number in opened if number not in alone]
    return [*_sliced(alone, 1), *_sliced(others, width), *_sliced(closed, width)]


def _sliced(numbers: Sequence[int], width: int) -> Iterator[list[int]]:
    return (list(numbers[start : start + width]) for start in range(0, len(numbers), width))


def first_name(model: Model) -> str:
    """Return the first of the names of the files of *model*; empty if it may include others."""
    return "" if _is_open(model) else min(source.name for source in model)


def _stands_alone(model: Model, *, recorded: bool) -> bool:
    """Tell whether no other model may be in the share of *model*.

    Configurations of robots are told by all robots that are linted with them.
    """
    return _is_open(model) and (recorded or any(one.format in CONFIGURATIONS for one in model))


def _is_open(model: Model) -> bool:
    """Tell whether *model* may include other files."""
    return not all(map(is_closed, model))


def _size(model: Model) -> int:
    return sum(map(size, model))
