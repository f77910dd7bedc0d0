"""Reads the bytes of inputs and keeps what is a robot model."""

from __future__ import annotations

import re
import stat
import sys
from collections.abc import Iterable
from json import JSONDecodeError, JSONDecoder

from kinlint.config import Settings
from kinlint.contexts.library import Contexts, Extra
from kinlint.discovery import Input
from kinlint.errors import SourceError
from kinlint.formats.registry import decode, recognise
from kinlint.text import SourceText

KNOWN = "JSON-LD (.jsonld, .json with an @context), Turtle (.ttl), N-Triples (.nt), N-Quads (.nq)"
ROBOTIC = ("comp-rob2b", "metamodels", "kinlint")
"""What the IRIs of robot vocabularies have in them; one is in every JSON-LD robot model."""
_OPENING = re.compile(r'\s*\{\s*"@context"\s*:\s*')
_ENDING = re.compile(r"\s*\}\s*")


def read(inputs: Iterable[Input], settings: Settings) -> tuple[list[SourceText], list[SourceError]]:
    """The texts of those *inputs* that are models, and why others cannot be read.

    A file that a search found and that is no robot model after all is passed over: other JSON-LD
    (package metadata, web annotations) under a `.json` name, and documents that are a context.
    """
    sources: list[SourceText] = []
    errors: list[SourceError] = []
    marks = (*ROBOTIC, *_own_contexts(settings))
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
        elif not _is_model(source, marks):
            continue
        sources.append(source)
    return sources, errors


def _is_model(source: SourceText, marks: Iterable[str]) -> bool:
    """Whether a file is a model that nobody called one."""
    if source.name.lower().endswith(".json") and not any(mark in source.text for mark in marks):
        return False
    form = recognise(source.name, source.text)
    return form is not None and not (form == "jsonld" and is_context(source.text))


def is_context(text: str) -> bool:
    """Whether a JSON text is nothing but a context for others."""
    opening = _OPENING.match(text)
    if opening is None:
        return False
    try:
        _, end = JSONDecoder().raw_decode(text, opening.end())
    except (JSONDecodeError, RecursionError):
        return False
    return _ENDING.fullmatch(text, end) is not None


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
