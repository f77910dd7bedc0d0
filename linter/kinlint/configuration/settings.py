"""Settings of a run, and of each file.

Rules are selected per file, as the configuration nearest to that file says. What concerns the one
graph that all files make (contexts, user rules and shapes, engine, `partial`) holds for the run.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Literal, TypeAlias

from kinlint.light_dataclasses import dataclass, field
from kinlint.rule import Severity
from kinlint.text import SourceText, Span

Engine: TypeAlias = Literal["oxigraph", "pyshacl"]


@dataclass(frozen=True, slots=True)
class Choice:
    """A layer of rule selection: a configuration, or the command line above it."""

    origin: str = "command line"
    """The place where the layer was written, for messages."""
    select: tuple[str, ...] | None = None
    """Selectors that replace those of lower layers; None keeps them."""
    preview: bool | None = None
    """True if preview rules are on; None keeps what lower layers say."""
    extend_select: tuple[str, ...] = ()
    """Selectors of rules to add."""
    ignore: tuple[str, ...] = ()
    """Selectors of rules to remove."""
    severity: tuple[tuple[str, Severity], ...] = ()
    """Selectors with the severity of the rules they name."""
    fixable: tuple[str, ...] | None = None
    """Selectors of rules whose findings are fixed; None keeps those of lower layers."""
    unfixable: tuple[str, ...] = ()
    """Selectors of rules whose findings are not fixed."""
    extend_safe_fixes: tuple[str, ...] = ()
    """Selectors of rules whose unsafe fixes count as safe."""
    extend_unsafe_fixes: tuple[str, ...] = ()
    """Selectors of rules whose safe fixes count as unsafe."""


@dataclass(frozen=True, slots=True)
class Ignore:
    """Rules that the configuration silences in one file, or in a part of it."""

    selectors: tuple[str, ...]
    """Selectors of the rules."""
    key: str
    """The key in the configuration, for messages."""
    origin: str = "command line"
    """The place where it was written, for messages."""
    pointer: str | None = None
    """JSON Pointer (RFC 6901) or path of an XML element below which they are silent."""
    iri: str | None = None
    """Absolute IRI of the entity about which they are silent."""
    place: tuple[SourceText, Span] | None = None
    """Place of the key in the configuration file."""


@dataclass(frozen=True, slots=True)
class FileSettings:
    """Settings of one file."""

    choices: tuple[Choice, ...] = ()
    """Layers of rule selection, the lowest first."""
    ignores: tuple[Ignore, ...] = ()
    """Rules silenced in the file."""
    require_reason: bool = False
    """True if suppressions must give a reason."""
    targets: tuple[str, ...] = ()
    """Consumers that the file is meant for."""
    urdf: Path | None = None
    """The URDF that an SRDF is about, where the configuration names it."""
    packages: tuple[tuple[str, Path], ...] = ()
    """ROS packages and their directories; later ones win."""
    workspace: Path | None = None
    """Directory of its configuration file, below which packages are searched for."""
    xacro_args: tuple[tuple[str, str], ...] = ()
    """Arguments for xacro; later ones win."""
    xacro_env: tuple[str, ...] = ()
    """Environment variables that xacro may see, besides those of ROS."""


@dataclass(frozen=True, slots=True)
class Settings:
    """Settings of one run."""

    contexts: str | None = None
    """Bundled release of the contexts; None is the newest."""
    extra_contexts: Mapping[str, Path] = field(default_factory=dict)
    """Files of further contexts by IRI."""
    context_directories: tuple[Path, ...] = ()
    """Directories of further contexts, by the path of their IRI."""
    rules: tuple[Path, ...] = ()
    """Rule files, and directories of them, in addition to the built-in ones."""
    shapes: tuple[Path, ...] = ()
    """SHACL files to check in addition to the rules."""
    engine: Engine = "oxigraph"
    """The SHACL engine."""
    linted: tuple[Path, ...] = ()
    """Directories that are linted, and the working directory; packages are searched for there."""
    partial: bool = False
    """True if the files are a part of a model."""
    file_timeout: float | None = None
    """Seconds that each file may take; None for no limit."""
    cache: Path | None = None
    """Directory of kept reports; None keeps none."""
    ignore_suppressions: bool = False
    """True if suppressed findings are reported as if they were not."""
    verbose: bool = False
    """True if details of the run are printed."""
    unsafe_fixes: bool | None = None
    """True if unsafe fixes are made with the safe ones; None makes none, but counts them."""
    drawn: bool = False
    """True if the report contains the structures of the robots, for outputs that draw them."""
    default: FileSettings = field(default_factory=FileSettings)
    """Settings of sources that are not in `files`."""
    files: Mapping[str, FileSettings] = field(default_factory=dict)
    """Settings of sources by name."""

    def partner(self, name: str) -> str | None:
        """The path of the URDF that the SRDF called *name* is about, where one is told."""
        urdf = self.for_file(name).urdf
        return None if urdf is None else urdf.as_posix()

    def for_file(self, name: str) -> FileSettings:
        """The settings of the source called *name*."""
        return self.files.get(name, self.default)
