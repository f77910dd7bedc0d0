"""The section of a rule's page about its fixes, with their applicability."""

from __future__ import annotations

import re
from typing import Any

from kinlint.rule import PLACEHOLDER, Applicability, Repair, Rule

_PLACEHOLDER = re.compile(f"'?{PLACEHOLDER.pattern}'?")
_TRUST = {
    Applicability.SAFE: "safe, so `--fix` makes it",
    Applicability.UNSAFE: "unsafe, so only `--fix --unsafe-fixes` makes it",
    Applicability.DISPLAY: "shown, but never made",
}
"""At most: a fix is made if the proof allows it, too."""


def heading(repair: Repair) -> str:
    """The title, for which formats, how far it may be trusted, and why no further."""
    title = _PLACEHOLDER.sub("...", repair.title)
    formats = f" in {' and '.join(repair.formats)}" if repair.formats else ""
    why = f" {' '.join(repair.why.split())}" if repair.why else ""
    return f"{title}{formats} ({_TRUST[repair.applicability]}).{why}"


def highest_applicability(rule: Rule) -> str:
    """Return the label of the highest applicability of the repairs; "" if there are none."""
    levels = [each.applicability for each in rule.repairs]
    return max(levels).label if levels else ""


def repair_object(repair: Repair) -> dict[str, Any]:
    """The repair as an object for JSON."""
    return {
        "title": repair.title,
        "applicability": repair.applicability.label,
        "why": " ".join(repair.why.split()) or None,
        "formats": list(repair.formats),
        "update": repair.update,
    }
