"""Identity of findings: when two of them are the same."""

from __future__ import annotations

from kinlint.addresses import is_address
from kinlint.finding import Finding


def identity(finding: Finding) -> tuple[object, ...]:
    """Return a key that findings have in common if they say the same of one place."""
    where = (finding.location.source.name, finding.location.span)
    # One line of text may make several nodes.
    about = None if is_address(finding.iri) else finding.focus
    said = finding.template, finding.meant, finding.message
    return finding.rule.code, where, said, about
