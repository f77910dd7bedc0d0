"""Remarks about rules of users, and faults of their examples that a test cannot find."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

from kinlint import resources
from kinlint.catalogue.repair_file import prefixes
from kinlint.catalogue.rule_checks import placed
from kinlint.catalogue.variable_checks import unused_variables
from kinlint.document import Document
from kinlint.engine.compiler.shapes_graph import parse
from kinlint.rule import Rule
from kinlint.terms import RDF_TYPE, iri, literal_value
from kinlint.vocabulary import SRC

REASON, MALFORMED = iri(f"{SRC}reason"), iri(f"{SRC}MalformedText")
"""Terms of a place where a text is not well-formed XML."""


class Remark(str):
    """Something that a rule of kinlint's own has to have, and that others do well to have."""

    __slots__ = ()


def is_built_in(rule: Rule) -> bool:
    """Tell whether *rule* is of kinlint's own catalogue."""
    return Path(rule.path).resolve().is_relative_to(resources.data("rules").resolve())


def unused(rule: Rule) -> Iterator[str]:
    """Yield variables of the queries of *rule* that get a value and are not used."""
    file = parse(Path(rule.path))
    for fault in unused_variables(file, prefixes()):
        yield f"line {placed(file, fault)}"


def malformed(document: Document) -> str | None:
    """Return where and why *document* is not well-formed XML; None if it is, or is no XML."""
    for node, way, value in document.statements:
        if way == RDF_TYPE and value == MALFORMED:
            start = document.location(document.map.nodes[node].best).start
            reasons = (o for s, p, o in document.statements if (s, p) == (node, REASON))
            reason = "; ".join(map(literal_value, reasons))
            return f"it is not well-formed in its line {start.line}: {reason}"
    return None
