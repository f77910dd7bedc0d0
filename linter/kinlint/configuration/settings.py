"""What a run was told: the settings of the whole run, and those of each file.

Rules speak per file, as the configuration nearest to that file says. What concerns the one
graph that all files make (contexts, user rules and shapes, engine, `partial`) holds for the run.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Literal, TypeAlias

from kinlint.model import Severity
from kinlint.text import SourceText, Span

Engine: TypeAlias = Literal["oxigraph", "pyshacl"]


@dataclass(frozen=True, slots=True)
class Choice:
    """One layer of rule selection: a configuration, or the command line above it.

    `select` replaces what lower layers chose, `extend_select` and `ignore` change it.
    `severity` pairs selectors with what the rules they name are to count as.
    `fixable` replaces what lower layers chose to mend, `unfixable` takes from it; unsafe fixes of
    `extend_safe_fixes` count as safe, safe ones of `extend_unsafe_fixes` as unsafe.
    `origin` says for messages where it was written.
    """

    origin: str = "command line"
    select: tuple[str, ...] | None = None
    extend_select: tuple[str, ...] = ()
    ignore: tuple[str, ...] = ()
    severity: tuple[tuple[str, Severity], ...] = ()
    fixable: tuple[str, ...] | None = None
    unfixable: tuple[str, ...] = ()
    extend_safe_fixes: tuple[str, ...] = ()
    extend_unsafe_fixes: tuple[str, ...] = ()


@dataclass(frozen=True, slots=True)
class Ignore:
    """Rules that configuration silences in one file.

    In all of it, or below the JSON Pointer `pointer`, or on the entity `iri` (an absolute IRI).
    `key` is what the configuration says, for messages, and `place` where in its file.
    """

    selectors: tuple[str, ...]
    key: str
    origin: str = "command line"
    pointer: str | None = None
    iri: str | None = None
    place: tuple[SourceText, Span] | None = None


@dataclass(frozen=True, slots=True)
class FileSettings:
    """What holds for one file: which rules speak, how loud, and where not.

    `targets` are the consumers that the file is meant for. `urdf` is, of an SRDF, the file that
    describes its robot, where the configuration says so. `packages` are ROS packages and where they
    lie, others are searched for in `workspace`; `xacro_args` are arguments. Later ones count.
    """

    choices: tuple[Choice, ...] = ()
    ignores: tuple[Ignore, ...] = ()
    require_reason: bool = False
    targets: tuple[str, ...] = ()
    urdf: Path | None = None
    packages: tuple[tuple[str, Path], ...] = ()
    workspace: Path | None = None
    xacro_args: tuple[tuple[str, str], ...] = ()


@dataclass(frozen=True, slots=True)
class Settings:
    """What holds for one run.

    `contexts` names a bundled release; None is the newest. `extra_contexts` maps context IRIs to
    the files that hold them; `context_directories` hold more, by the path of their IRI.
    `partial` says that the files are a part of a model. `unsafe_fixes` tells whether unsafe fixes
    are made when safe ones are; None leaves them, but hints at them. `files` has the
    settings of each source by its name; a source without is governed by `default`. `cache` is
    where compiled catalogues are kept; None keeps none. `drawn` tells that the report is to have
    the structures of the robots, for outputs that draw them.
    """

    contexts: str | None = None
    extra_contexts: Mapping[str, Path] = field(default_factory=dict)
    context_directories: tuple[Path, ...] = ()
    rules: tuple[Path, ...] = ()
    shapes: tuple[Path, ...] = ()
    engine: Engine = "oxigraph"
    partial: bool = False
    cache: Path | None = None
    ignore_suppressions: bool = False
    verbose: bool = False
    unsafe_fixes: bool | None = None
    drawn: bool = False
    default: FileSettings = field(default_factory=FileSettings)
    files: Mapping[str, FileSettings] = field(default_factory=dict)

    def partner(self, name: str) -> str | None:
        """The path of the URDF that the SRDF called *name* is about, where one is told."""
        urdf = self.of(name).urdf
        return None if urdf is None else urdf.as_posix()

    def of(self, name: str) -> FileSettings:
        """The settings of the source called *name*."""
        return self.files.get(name, self.default)
