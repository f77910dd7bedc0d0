"""Identity of a finding across changes of its line, its file and the working directory."""

from __future__ import annotations

import os
from collections.abc import Mapping
from pathlib import Path

from kinlint.addresses import is_address, without_file
from kinlint.finding import Finding
from kinlint.light_dataclasses import dataclass, field, replace
from kinlint.report import STDIN_NAMES
from kinlint.terms import is_blank
from kinlint.text import Span


@dataclass(frozen=True, slots=True)
class Entry:
    """A finding as a baseline remembers it."""

    path: str
    """Path of the file, relative to the root of the baseline."""
    rule: str
    """Code of the rule."""
    entity: str
    """The entity concerned, for people."""
    message: str
    """The message, for people."""
    fingerprint: str
    """The fingerprint, which does not depend on the file."""
    elsewhere: bool = field(default=False, compare=False)
    """True if the entity has an IRI of its own, the same in whatever file."""
    span: Span = field(default=Span(0, 0), compare=False)
    """The place of the entry in the baseline file."""

    @property
    def key(self) -> tuple[str, ...]:
        """The order of a baseline: by file, rule and entity."""
        return self.path, self.rule, self.entity, self.message, self.fingerprint


@dataclass(frozen=True)
class Names:
    """Names of files relative to a root."""

    root: Path
    """An absolute path with links followed."""
    renamed: Mapping[str, str] = field(default_factory=dict)
    """Other names for some of the files."""
    _known: dict[str, str] = field(default_factory=dict, repr=False, compare=False)

    def relative_path(self, name: str) -> str:
        """The path from `root` to the file that a source called *name* was read from."""
        if name not in self._known:
            path = name
            if name not in STDIN_NAMES:
                head, tail = os.path.split(os.path.abspath(name))  # noqa: PTH100  links of files stay
                path = relative(Path(os.path.realpath(head), tail), self.root)
            self._known[name] = self.renamed.get(path, path)
        return self._known[name]


def relative(path: Path, root: Path) -> str:
    """Return *path* relative to *root*, with forward slashes; absolute where no way leads there."""
    try:
        return Path(os.path.relpath(path, root)).as_posix()
    except ValueError:  # another drive
        return path.as_posix()


def entry_of(finding: Finding, names: Names) -> Entry:
    """Return the entry that identifies *finding*."""
    own = finding.location.source.name
    path, entity, iri = names.relative_path(own), finding.entity, finding.iri
    free = iri != "" and not is_address(iri) and not is_blank(iri) and not finding.rule.group_by
    if is_address(iri):
        name, mark, way = entity.partition("#")
        entity = f"{names.relative_path(name)}{mark}{way}"
        iri = without_file(iri)
    # What a message says may be the name of a file, which depends on where kinlint runs.
    files = {own, *(each.location.source.name for each in finding.related)}
    meant = tuple(
        "" if each == own else names.relative_path(each) if each in files else each
        for each in finding.meant or finding.arguments
    )
    same = replace(finding, iri=iri, meant=meant).fingerprint
    return Entry(path, finding.rule.code, entity, finding.message, same, free)
