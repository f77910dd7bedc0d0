"""Reads the bytes of inputs and keeps what is a robot model."""

from __future__ import annotations

import stat
import sys
from collections.abc import Iterable, Mapping
from pathlib import Path
from types import MappingProxyType

from kinlint.configuration.settings import Settings
from kinlint.contexts.context_library import Contexts, Extra
from kinlint.errors import SourceError
from kinlint.files.time_limit import time_limit
from kinlint.files.url_mirror import contents_of
from kinlint.formats.recognition import objection
from kinlint.formats.registry import decode
from kinlint.light_dataclasses import replace
from kinlint.project.discovery import Input
from kinlint.project.model_detection import doubt, is_model
from kinlint.text import SourceText

NOTHING: Mapping[Path, SourceText] = MappingProxyType({})
MOST_BYTES = 512 * 2**20
"""A file that is larger is no model but a slip, such as a device in the place of a file."""


def read_models(
    inputs: Iterable[Input], settings: Settings, passed: list[SourceError] | None = None
) -> tuple[list[SourceText], list[SourceError]]:
    """The texts of those *inputs* that are models, and why others cannot be read.

    A file that a search found and that is no robot model after all is passed over: other JSON-LD
    (package metadata, web annotations) under a `.json` name, and documents that are a context.
    *passed* is told which of these may have been meant as models after all.
    """
    sources: list[SourceText] = []
    errors: list[SourceError] = []
    own = own_contexts(settings)
    for one in inputs:
        try:
            # Whoever writes to standard input may take any time.
            seconds = None if one.path is None and not one.remote else settings.file_timeout
            with time_limit(one.name, seconds):
                source = read_source(one)
                is_read = one.named or is_model(source, own)
                cause = "" if is_read else doubt(source)
        except SourceError as error:
            errors.append(error)
            continue
        if one.named and source.format is None:
            cause = f"not a robot model: {objection()}"
            errors.append(SourceError(one.name, cause))
            continue
        if is_read:
            sources.append(source)
        elif passed is not None and cause:
            passed.append(SourceError(one.name, cause))
    return sources, errors


def _bounded(one: Input, read: bytes) -> bytes:
    if len(read) > MOST_BYTES:
        raise SourceError(one.name, f"more than {MOST_BYTES // 2**20} MiB")
    return read


def read_source(one: Input) -> SourceText:
    """Read and decode *one*. Raises `SourceError` if that fails."""
    source = decode(one.name, _bytes(one))
    return source if one.named else replace(source, named=False)


def own_contexts(settings: Settings) -> tuple[str, ...]:
    """The IRIs of all contexts that models may name, if *settings* add some."""
    extra: list[Extra] = [*settings.context_directories, *settings.extra_contexts.items()]
    return Contexts.bundled(settings.contexts, extra).iris if extra else ()


def _bytes(one: Input) -> bytes:
    if one.remote:
        return _bounded(one, contents_of(one.name))
    if one.path is None:
        return _bounded(one, sys.stdin.buffer.read(MOST_BYTES + 1))
    try:
        mode = one.path.stat().st_mode
        if not stat.S_ISREG(mode):
            raise SourceError(one.name, "not a regular file; for a pipe, use - as the path")
        with one.path.open("rb") as file:
            return _bounded(one, file.read(MOST_BYTES + 1))
    except OSError as error:
        dangling = one.path.is_symlink() and not one.path.exists()
        cause = "a link to nothing" if dangling else error.strerror or str(error)
        raise SourceError(one.name, cause) from None
