"""Writes into rule files what their rules make of their examples: marks, and fixed texts."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from contextlib import suppress
from pathlib import Path

from kinlint.catalogue.rule_file import source_of
from kinlint.catalogue.rulebook import Rulebook
from kinlint.errors import SourceError
from kinlint.finding import Finding
from kinlint.rule import Example, Rule
from kinlint.rule_testing.example_texts import FORMATS, beside, source, unmarked
from kinlint.rule_testing.rule_conformance import alone, found

_LONG = re.compile(r'("""|\'\'\')(?P<text>[^\\]*?)\1')
"""A long string of Turtle without escapes, in which what is said is what is written."""


def updated(path: Path, rules: Iterable[Rule], rulebook: Rulebook) -> str:
    """Return the text of the rule file at *path* with examples as its *rules* find and fix them.

    An example in which a rule finds nothing, or which is written with escapes, stays as it is.
    """
    new = {old: text for rule in rules for old, text in _changes(rule, rulebook)}
    text = path.read_text("utf-8-sig")
    return _LONG.sub(lambda match: _replaced(match, new), text) if new else text


def _changes(rule: Rule, rulebook: Rulebook) -> Iterator[tuple[str, str]]:
    """Yield texts of examples of *rule* that are to change, with what they become."""
    for example, findings, made in _outcomes(rule, rulebook):
        if example.bad is not None and findings:
            yield example.bad, marked(unmarked(example.bad)[0], findings)
            if example.fixed is not None and made is not None:
                yield example.fixed, made


def _outcomes(
    rule: Rule, rulebook: Rulebook
) -> Iterator[tuple[Example, list[Finding], str | None]]:
    """Yield each bad example of *rule* that can be read, its findings, and what repairs make of it.

    That is None where nothing is changed.
    """
    from kinlint.rule_testing.repair_examples import fixed  # noqa: PLC0415  few rules have repairs

    only, settings = alone(rule, rulebook, "oxigraph")
    for example in rule.examples:
        if example.bad is None or example.format not in FORMATS:
            continue
        with beside(example) as home, suppress(SourceError):
            texts = source(example, unmarked(example.bad)[0], home)
            made = fixed(texts, settings, only) if rule.repairs else texts[0].text
            changed = made if made != texts[0].text else None
            yield example, found(rule, rulebook, texts), changed


def marked(text: str, findings: Sequence[Finding]) -> str:
    """Return *text* with `[|…|]` around the places of *findings*; nested ones are left out."""
    spans = sorted({each.location.span for each in findings}, key=lambda span: span.start)
    parts, at = list[str](), 0
    for span in spans:
        if span.start >= at:
            parts += [text[at : span.start], f"[|{text[span.start : span.end]}|]"]
            at = span.end
    return "".join([*parts, text[at:]])


def _replaced(match: re.Match[str], new: Mapping[str, str]) -> str:
    """Return the string *match* with its new text, indented as the old one."""
    written = match["text"]
    wanted = new.get(source_of(written))
    if wanted is None:
        return match[0]
    first = next(line for line in written.splitlines() if line.strip())
    own = next(line for line in source_of(written).splitlines() if line.strip())
    indent = first.removesuffix(own)
    head = "\n" * (len(written) - len(written.lstrip("\n")))
    tail = re.search(r"\n?[ \t]*\Z", written)
    lines = (f"{indent}{line}" if line.strip() else line for line in wanted.splitlines())
    end = tail[0] if tail else ""
    return "".join([match[1], head, "\n".join(lines), end, match[1]])
