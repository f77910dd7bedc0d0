"""Identity of findings: when two of them are the same."""

from __future__ import annotations

from kinlint.addresses import is_address
from kinlint.finding import DEPARTURES, Finding


def identity(finding: Finding) -> tuple[object, ...]:
    """Return a key that findings have in common if they say the same of one place."""
    where = (finding.location.source.name, finding.location.span)
    # One line of text may make several nodes.
    about = None if is_address(finding.iri) else finding.focus
    # What targets make of it was added when it was judged; it says the same of the place.
    message = finding.message.removesuffix(finding.departures).rstrip()
    said = finding.template.removesuffix(DEPARTURES).rstrip(), finding.meant, message
    return finding.rule.code, where, said, about
