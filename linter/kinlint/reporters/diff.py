"""Unified diffs of whole texts, as `patch` and `git apply` read them."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.reporters.display_width import printable
from kinlint.reporters.terminal_style import Ink, Style

NO_LINE_END = "\\ No newline at end of file"
_INKS: dict[str, Ink] = {"-": "removed", "+": "added", "@": "place"}


def unified_diff(
    source_name: str, before: str, after: str, style: Style | None = None
) -> Iterator[str]:
    """The diff that makes *after* of *before*, line by line; nothing if they are equal.

    Lines end in LF; a CR before it belongs to the line. Without colour they are as they stand in
    the files, so that the diff is a patch; in colour, for terminals, control characters are
    escaped.
    """
    from difflib import unified_diff  # noqa: PLC0415  few runs make diffs

    style = style or Style()
    name = printable(source_name, unicode=style.unicode)
    name += "\t" * (" " in name)
    # Behind a blank, `patch` takes the rest of a name for a time, unless a tab ends the name.
    for number, line in enumerate(unified_diff(_lines(before), _lines(after), name, name)):
        sign, text = line[0], line[1:].removesuffix("\n")
        if style.color:
            ink: Ink | None = _INKS.get(sign) if number > 1 else "strong"
            text = sign + printable(text.removesuffix("\r"), unicode=style.unicode)
            yield f"{style.ink(text, ink) if ink else text}\n"
        else:
            yield f"{sign}{text}\n"
        if not line.endswith("\n"):
            yield f"{NO_LINE_END}\n"


def _lines(text: str) -> list[str]:
    """The lines of *text* with the LF that ends each; the last may have none."""
    *whole, last = text.split("\n")
    return [*(f"{line}\n" for line in whole), *([last] if last else [])]
