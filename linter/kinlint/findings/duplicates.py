"""When two findings are one."""

from __future__ import annotations

from kinlint.model import Finding

ELEMENT = "urn:kinlint:document:"
"""How addresses in files of elements begin, where one line of text may make several things."""


def identity(finding: Finding) -> tuple[object, ...]:
    """What findings that say the same of one place have in common."""
    where = (finding.location.source.name, finding.location.span)
    about = None if finding.iri.startswith(ELEMENT) else finding.focus
    return finding.rule.code, where, finding.message, about
