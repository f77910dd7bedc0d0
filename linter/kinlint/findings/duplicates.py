"""When two findings are one."""

from __future__ import annotations

from kinlint.addresses import is_address
from kinlint.finding import Finding


def identity(finding: Finding) -> tuple[object, ...]:
    """What findings that say the same of one place have in common."""
    where = (finding.location.source.name, finding.location.span)
    # One line of text may make several nodes.
    about = None if is_address(finding.iri) else finding.focus
    said = finding.template, finding.meant, finding.message
    return finding.rule.code, where, said, about
