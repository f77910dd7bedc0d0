"""Reads the bytes of inputs and keeps what is a robot model."""

from __future__ import annotations

import stat
import sys
from collections.abc import Iterable

from kinlint.cli.recognition import is_model
from kinlint.configuration.settings import Settings
from kinlint.contexts.library import Contexts, Extra
from kinlint.errors import SourceError
from kinlint.files.discovery import Input
from kinlint.formats.registry import decode, recognise
from kinlint.text import SourceText

KNOWN = "JSON-LD (.jsonld, .json with an @context), Turtle (.ttl), N-Triples (.nt), N-Quads (.nq)"


def read(inputs: Iterable[Input], settings: Settings) -> tuple[list[SourceText], list[SourceError]]:
    """The texts of those *inputs* that are models, and why others cannot be read.

    A file that a search found and that is no robot model after all is passed over: other JSON-LD
    (package metadata, web annotations) under a `.json` name, and documents that are a context.
    """
    sources: list[SourceText] = []
    errors: list[SourceError] = []
    own = _own_contexts(settings)
    for one in inputs:
        try:
            source = decode(one.name, _bytes(one))
        except SourceError as error:
            errors.append(error)
            continue
        if one.named:
            if recognise(one.name, source.text) is None:
                cause = f"not a robot model: kinlint reads {KNOWN}"
                errors.append(SourceError(one.name, cause))
                continue
        elif not is_model(source, own):
            continue
        sources.append(source)
    return sources, errors


def _own_contexts(settings: Settings) -> tuple[str, ...]:
    extra: list[Extra] = [*settings.context_directories, *settings.extra_contexts.items()]
    return Contexts.bundled(settings.contexts, extra).iris if extra else ()


def _bytes(one: Input) -> bytes:
    if one.path is None:
        return sys.stdin.buffer.read()
    try:
        mode = one.path.stat().st_mode
        if not stat.S_ISREG(mode):
            raise SourceError(one.name, "not a regular file; for a pipe, use - as the path")
        return one.path.read_bytes()
    except OSError as error:
        dangling = one.path.is_symlink() and not one.path.exists()
        cause = "a link to nothing" if dangling else error.strerror or str(error)
        raise SourceError(one.name, cause) from None
