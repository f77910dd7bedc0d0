"""Reads robots and lifts all that they say."""

from __future__ import annotations

from pathlib import Path

from robot import Robot

from kinlint.engine.lifting import lift
from kinlint.engine.store import Store
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import decode, read
from kinlint.terms import Triple


def triples(*paths: Path) -> tuple[Triple, ...]:
    """What the files at *paths* say together, and what is lifted from it."""
    documents = [read(decode(path.name, path.read_bytes()), ReadOptions()) for path in paths]
    store = Store()
    store.load(documents)
    lift(store)
    return (*(each for one in documents for each in one.statements), *store.lifted())


def robot(*paths: Path) -> Robot:
    """The robot that the files at *paths* describe together."""
    return Robot(triples(*paths))
