"""Completes at places of models that tests write, and type in."""

from __future__ import annotations

from pathlib import Path

from navigating import Model
from support.linting import book

from kinlint import lint
from kinlint.configuration.settings import Settings
from kinlint.formats.recognition import with_format
from kinlint.navigation.completion.candidate import Candidate
from kinlint.navigation.completion.dispatch import complete
from kinlint.navigation.completion.situation import Situation
from kinlint.server.readable_documents import ReadableDocuments
from kinlint.text import SourceText


class Typing:
    """The *files* of one model in *folder*, which can all be read, and in which somebody types."""

    def __init__(self, folder: Path, files: dict[str, str], given=(), **settings) -> None:
        self.model = Model(folder, files, given, **settings)
        self.settings = Settings(**settings)
        self.given = given or tuple(files)
        self.readable = ReadableDocuments()
        self.readable.remember(self.model.examination)

    def candidates(self, where: str) -> list[Candidate]:
        """`name: old => new`: *new* is typed over *old*, with a bar where the cursor is then."""
        name, _, change = where.partition(": ")
        old, _, new = change.partition(" => ")
        before = self.model.files[name]
        assert before.count(old) == 1, where
        at = before.index(old) + new.index("|")
        texts = {**self.model.files, name: before.replace(old, new.replace("|", ""))}
        folder = self.model.folder
        sources = [SourceText(str(folder / each), texts[each]) for each in self.given]
        made = lint.examine(sources, [], self.settings, book())
        path = str(folder / name)
        source = with_format(next(each for each in sources if each.name == path))
        found = complete(
            Situation(
                source,
                at,
                source.format,
                self.readable.of(path, made),
                made.options,
                book(),
                [one for one in made.report.findings if one.location.source.name == path],
            )
        )
        self.text, self.span = source.text, found.span
        return list(found.candidates)

    def labels(self, where: str) -> list[str]:
        return [each.label for each in self.candidates(where)]

    def replaced(self, where: str) -> str:
        """What the candidates replace."""
        self.candidates(where)
        return self.text[slice(*self.span)]
