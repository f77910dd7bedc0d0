"""Divides the text of a layer into tokens, and says where it is none."""

from __future__ import annotations

import re
from typing import NoReturn

from kinlint.errors import SourceError
from kinlint.formats.usd.prim_paths import is_path
from kinlint.text import SourceText, Span

MOST_DEEP = 200
MOST_STATEMENTS = 1_000_000
LONGEST_NAME = 4_000
LONGEST_NUMBER = 1_000
MOST = {
    "prims": 30_000,
    "rigid bodies": 5_000,
    "joints": 5_000,
    "properties": 2_000,
    "variants": 2_000,
    "metadata": 2_000,
    "entries": 2_000,
    "samples": 25_000,
    "targets or operations": 5_000,
    "members other than numbers": 40_000,
}
"""Most of what a layer, or a stage, a prim, a property, or a list has."""

HEADER = re.compile(r"#usda[ \t]+(\d+)\.(\d+)[^\n]*")
LATEST = (1, 4)
"""Version of the text format that is read."""

_SPACE = re.compile(r"(?:[ \t\r\n]++|#[^\n]*+|//[^\n]*+|/\*(?s:.*?)\*/)*+")
_COMMENT = re.compile(r"#[^\n]*+|//[^\n]*+|/\*(?s:.*?)\*/")
_GAP = r"\s*+(?:\#[^\n]*+\s*+)*+"
_COMMA = rf"[ \t]*+,{_GAP}"
_PLAIN = r"-?+(?:\d++(?:\.\d*+)?+(?:[eE][-+]?\d++)?+|\.\d++(?:[eE][-+]?\d++)?+|inf|nan)"
_ROW = rf"\({_GAP}{_PLAIN}(?:{_COMMA}{_PLAIN})*+{_GAP}\)"
_ELEMENT = rf"(?:{_PLAIN}|{_ROW}|\({_GAP}{_ROW}(?:{_COMMA}{_ROW})*+{_GAP}\))"
_TOKEN = re.compile(
    r"""
      (?P<bulk>\[(?=[\d\s.,()+\-einfa]{40})GAP(?:ELEMENT(?:COMMA|GAP(?=\])))*+\]?+)
    | (?P<string>\"{3}(?:[^"\\]++|\\(?s:.)|"(?!""))*+\"{3}|'{3}(?:[^'\\]++|\\(?s:.)|'(?!''))*+'{3}
        |"(?!"")(?:[^"\\\n]|\\(?s:.))*+"|'(?!'')(?:[^'\\\n]|\\(?s:.))*+'|""(?!")|''(?!'))
    | (?P<asset>@@@(?s:.*?)@@@(?!@)|@(?!@@)[^@\n]*+@)
    | (?P<path><[^<>\n]*+>)
    | (?P<number>-?(?:\d++(?:\.\d*+)?|\.\d++)(?:[eE][-+]?\d++)?(?![\w.])|-?(?:inf|nan)(?!\w))
    | (?P<name>[^\W\d]\w*+(?:::?\w++)*+(?:\.[^\W\d]\w*+)?+)
    | (?P<mark>[()\[\]{}=,;:.])
    """.replace("ELEMENT", _ELEMENT)
    .replace("COMMA", _COMMA)
    .replace("GAP", _GAP),
    re.VERBOSE,
)
"""Tokens. A long array of numbers is one, up to its end or to the member that is no such thing."""
_ESCAPE = re.compile(r"\\(x[0-9a-fA-F]{1,2}|[0-7]{1,3}|(?s:.))")
_ESCAPED = {"n": "\n", "t": "\t", "r": "\r", "a": "\a", "b": "\b", "f": "\f", "v": "\v", "\n": ""}
_END = "the end of the file"
_LONGEST = {"name": LONGEST_NAME, "path": LONGEST_NAME, "number": LONGEST_NUMBER}


class MalformedLayer(Exception):
    """A text that is no layer, from *span* on."""

    def __init__(self, span: Span, reason: str) -> None:
        super().__init__(reason)
        self.span = span
        self.reason = reason


def header(source: SourceText) -> re.Match[str]:
    """Return the first line of *source*, which names the version; raise MalformedLayer without."""
    if source.bom:
        raise MalformedLayer(Span(0, 0), "a byte order mark stands before '#usda'")
    found = HEADER.match(source.text)
    if found is not None and (int(found[1]), int(found[2])) <= LATEST:
        return found
    reason = (
        f"the file is of a version after {LATEST[0]}.{LATEST[1]}"
        if found is not None
        else "a text layer begins with '#usda 1.0'"
    )
    raise MalformedLayer(Span(0, len(source.text.partition("\n")[0])), reason)


class Scanner:
    """Tokens of *source*, one at a time."""

    def __init__(self, source: SourceText) -> None:
        self.source, self.text = source, source.text
        self.at = self.end = 0
        """Offset of the current token, and of the end of the one before it."""
        self.kind = self.word = ""
        """Kind of the current token, and the token; both empty at the end of the file."""
        self.fresh = True
        """True if a line break stands before the current token."""
        self.stop = 0
        self.depth = self.count = self.prims = self.bodies = self.joints = 0

    def advance(self) -> None:
        """Go to the next token."""
        text = self.text
        self.end = self.stop
        start = _SPACE.match(text, self.stop).end()  # type: ignore[union-attr]
        gap = text[self.stop : start]
        self.fresh = "\n" in (_COMMENT.sub("", gap) if "/*" in gap else gap)
        self.at = start
        found = _TOKEN.match(text, start)
        if found is None:
            if start < len(text):
                self._unknown(start)
            self.kind = self.word = ""
            self.stop = start
            return
        self.kind, self.word, self.stop = found.lastgroup or "", found[0], found.end()
        longest = _LONGEST.get(self.kind)
        if longest is not None and self.stop - start > longest:
            self.refuse(f"a {self.kind} has over {longest} characters")
        if self.kind == "path" and not is_path(self.word[1:-1]):
            raise MalformedLayer(Span(start, self.stop), f"'{self.word}' is no path")

    def _unknown(self, start: int) -> NoReturn:
        """Say what is wrong with a character that begins no token."""
        first = self.text[start]
        reasons = {'"': "a string is not closed", "'": "a string is not closed"}
        reasons |= {"@": "an asset path is not closed", "<": "a path is not closed"}
        if self.text.startswith("/*", start):
            reasons["/"] = "a comment is not closed"
        reason = reasons.get(first, f"unexpected {first!r}")
        raise MalformedLayer(Span(start, start + 1), reason)

    def fail(self, reason: str) -> NoReturn:
        """Say that the current token is not what the grammar has there, for this *reason*."""
        found = self.word.partition("\n")[0][:40] if self.kind else _END
        quoted = f"'{found}'" if self.kind else found
        place = Span(self.at, self.at + len(found) if self.kind else self.at)
        raise MalformedLayer(place, f"{reason}, found {quoted}")

    def expect(self, mark: str, what: str = "") -> None:
        """Go beyond *mark*, which is called *what*."""
        if self.word != mark or self.kind != "mark":
            self.fail(f"expected {what or repr(mark)}")
        self.advance()

    def unbroken(self) -> None:
        """Refuse a line break before the current token, in the middle of a statement."""
        if self.fresh and self.kind:
            where = "a line break stands in the middle of a statement"
            raise MalformedLayer(Span(self.at, self.stop), where)

    def onward(self) -> None:
        """Go to the next token, which stands in the same line."""
        self.advance()
        self.unbroken()

    def separate(self, closing: str, *, block: bool = False) -> None:
        """Go beyond what separates two statements: a line break, or a semicolon.

        A *block* ends in a line break alone.
        """
        if self.kind == "mark" and self.word == ";":
            if self.fresh or block:
                place = "behind a block" if block else "at the start of a line"
                raise MalformedLayer(Span(self.at, self.stop), f"';' stands {place}")
            self.advance()
            return
        if self.kind and not self.fresh and self.word != closing:
            self.fail("expected a line break or ';' behind a statement")

    def enter(self) -> None:
        """Go into a block or a value; the depth is the caller's to take back.

        Raises SourceError for too many, or too deep ones.
        """
        self.depth += 1
        self.count += 1
        if self.depth > MOST_DEEP:
            self.refuse(f"blocks and values are nested more than {MOST_DEEP} deep")
        if self.count > MOST_STATEMENTS:
            self.refuse(f"more than {MOST_STATEMENTS} statements and values")

    def bound(self, count: int, where: str, what: str) -> None:
        """Refuse a *count* of *what*, a key of `MOST`, that is too great."""
        if count > MOST[what]:
            self.refuse(f"{where} has more than {MOST[what]} {what}")

    def refuse(self, cause: str) -> NoReturn:
        """Raise SourceError at the current token for what no scene has."""
        line, column = self.source.position(self.at)
        raise SourceError(self.source.name, cause, line, column)

    def name(self, what: str) -> tuple[str, Span]:
        """Go beyond a string, *what* is to be called so, and return it with its place."""
        if self.kind != "string":
            self.fail(f"expected {what} in quotes")
        text, span = unquoted(self.word), Span(self.at, self.stop)
        if len(text) > LONGEST_NAME:
            self.refuse(f"a name has over {LONGEST_NAME} characters")
        self.advance()
        return text, span

    def follows(self, *words: str) -> bool:
        """Tell whether one of *words* is the token behind the current one."""
        start = _SPACE.match(self.text, self.stop).end()  # type: ignore[union-attr]
        found = _TOKEN.match(self.text, start)
        return found is not None and found[0] in words


def unquoted(token: str) -> str:
    """Return the content of a string, an asset or a path."""
    width = 3 if token[:3] in ('"""', "'''", "@@@") and len(token) > 5 else 1  # noqa: PLR2004
    text = token[width:-width]
    if token[0] in "\"'" and "\\" in text:
        return _ESCAPE.sub(_character, text)
    return text.replace("\\@@@", "@@@") if width > 1 and token[0] == "@" else text


def _character(match: re.Match[str]) -> str:
    said = match[1]
    if said[0] == "x" and len(said) > 1:
        return chr(int(said[1:], 16))
    if said[0] in "01234567":
        return chr(int(said, 8) & 0xFF)
    return _ESCAPED.get(said, said)
