"""Asks about places in models that tests write."""

from __future__ import annotations

from pathlib import Path

from support.linting import book

from kinlint.configuration.settings import Settings
from kinlint.navigation.navigator import Navigator
from kinlint.pipeline.analyzer import Analyzer
from kinlint.text import Location, SourceText

NON_BMP = "\U0001f916\U0001d538"
"""Characters that take two units in UTF-16 and four in UTF-8."""


class Model:
    """The *files* of one model, in *folder*, as if the user had named those in *given*."""

    def __init__(self, folder: Path, files: dict[str, str], given=(), **settings) -> None:
        self.folder, self.files = folder, files
        for name, text in files.items():
            path = folder / name
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_bytes(text.encode())
        names = given or files
        texts = [SourceText(str(folder / name), files[name]) for name in names]
        settings = Settings(**settings)
        self.examination = Analyzer(settings, book(), repeated=True).examine(texts)
        self.navigator = Navigator(self.examination, book(), settings.extra_contexts)

    def _asked(self, where: str) -> tuple[str, int]:
        """`name: text` with a bar where the cursor is; the text must be there once."""
        name, _, around = where.partition(": ")
        at = around.index("|")
        needle = around.replace("|", "")
        assert self.files[name].count(needle) == 1, where
        return str(self.folder / name), self.files[name].index(needle) + at

    def definitions(self, where: str) -> list[str]:
        return [self.shown(each) for each in self.navigator.definitions(*self._asked(where))]

    def references(self, where: str, *, described: bool = False) -> list[str]:
        found = self.navigator.references(*self._asked(where), described=described)
        return [self.shown(each) for each in found]

    def hover(self, where: str) -> str:
        found = self.navigator.hover(*self._asked(where))
        return "" if found is None else found.markdown

    def hovered(self, where: str) -> str:
        """The text that the hover is about."""
        name, offset = self._asked(where)
        found = self.navigator.hover(name, offset)
        assert found is not None
        return self.files[self.own(name)][slice(*found.span)]

    def own(self, name: str) -> str:
        return Path(name).relative_to(self.folder).as_posix()

    def shown(self, place: Location) -> str:
        """`name:line: text`."""
        text = place.source[place.span]
        return f"{self.own(place.source.name)}:{place.start.line}: {text}"
