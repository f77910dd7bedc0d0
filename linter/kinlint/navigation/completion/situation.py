"""The place at which something is to be completed, and what is known around it."""

from __future__ import annotations

from collections.abc import Sequence
from functools import cached_property
from pathlib import Path

from kinlint.catalogue.rulebook import Rulebook
from kinlint.document import Document
from kinlint.file_format import Format
from kinlint.files.packages import Packages
from kinlint.files.pathglob import absolute
from kinlint.finding import Finding
from kinlint.formats.options import ReadOptions
from kinlint.light_dataclasses import dataclass
from kinlint.navigation.completion.known_names import KnownNames
from kinlint.text import SourceText


@dataclass(frozen=True, slots=False)
class Situation:
    """A place in a text that is being typed."""

    source: SourceText
    """The text as it is now."""
    offset: int
    """The place of the cursor."""
    format: Format
    """The format that the text is read as."""
    documents: Sequence[Document]
    """The documents of the model, each as it was when it could be read last."""
    options: ReadOptions
    """Options by which they were read."""
    rulebook: Rulebook
    """The rules."""
    findings: Sequence[Finding] = ()
    """Findings in the text."""

    @cached_property
    def document(self) -> Document | None:
        """The document of the text when it could be read last; None if it never could."""
        name = self.source.name
        found = (each for each in self.documents if each.source.name == name)
        included = (
            each for each in self.documents if any(one.name == name for one in each.sources)
        )
        return next(found, None) or next(included, None)

    @cached_property
    def names(self) -> KnownNames:
        """The named parts of the model."""
        return KnownNames(self.documents)

    @property
    def directory(self) -> Path:
        """The directory of the file."""
        return absolute(self.source.name).parent

    @cached_property
    def packages(self) -> Packages:
        """The packages that the file can name."""
        return self.options.packages_of(self.source.name)
