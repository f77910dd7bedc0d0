"""PyLD, imported without what only its loaders of remote documents and of web pages need."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from functools import partial
from importlib import import_module
from types import ModuleType
from typing import Any

_BY_TYPE = "pyld.documentloader.type_directed"
UNUSED = ("asyncio", "lxml.html", "urllib.request", _BY_TYPE)
"""Modules that PyLD imports and kinlint does not use; they load more slowly than PyLD itself.

A loader of PyLD is among them, as it imports `dataclasses` and with it `inspect`.
"""
NAMED = {"urllib.request": "url2pathname", _BY_TYPE: "TypeDirectedDocumentLoader"}
"""The function or class that PyLD imports by name from one of them."""
CLIENTS = ("requests", "aiohttp")
"""HTTP clients that PyLD makes its default loader of, where they are installed."""


class Postponed(ModuleType):
    """Stands for a module until something asks for its content, which imports it."""

    def __getattr__(self, name: str) -> Any:
        if name.startswith("__"):
            raise AttributeError(name)
        if sys.modules.get(self.__name__) is self:
            del sys.modules[self.__name__]
        return getattr(import_module(self.__name__), name)


def _call(module: str, function: str, *given: Any) -> Any:
    return getattr(import_module(module), function)(*given)


@contextmanager
def _postponed() -> Iterator[None]:
    """Replace `UNUSED` modules by stand-ins, so that importing them takes no time.

    `CLIENTS` cannot be imported meanwhile, so that PyLD is left without a loader.
    """
    clients = {name: sys.modules.get(name) for name in CLIENTS}
    sys.modules.update(dict.fromkeys(CLIENTS))  # type: ignore[arg-type]
    waiting = {name: Postponed(name) for name in UNUSED if name not in sys.modules}
    for name in NAMED.keys() & waiting.keys():
        setattr(waiting[name], NAMED[name], partial(_call, name, NAMED[name]))
    sys.modules.update(waiting)
    try:
        yield
    finally:
        for name, client in clients.items():
            if client is None:
                del sys.modules[name]
            else:
                sys.modules[name] = client
        for name, stand_in in waiting.items():
            if sys.modules.get(name) is stand_in:
                del sys.modules[name]
        for name, stand_in in waiting.items():
            above, _, own = name.rpartition(".")
            if above in sys.modules and not hasattr(sys.modules[above], own):
                setattr(sys.modules[above], own, stand_in)


with _postponed():
    from pyld.iri_resolver import resolve
    from pyld.jsonld import (
        KEYWORD_PATTERN,
        KEYWORDS,
        JsonLdError,
        JsonLdProcessor,
        canonicalize,
        frozendict,
    )

__all__ = [
    "KEYWORDS",
    "KEYWORD_PATTERN",
    "JsonLdError",
    "JsonLdProcessor",
    "canonicalize",
    "frozendict",
    "resolve",
]
