"""Numbers that no `xsd:double` can hold, which readers of RDF take for infinity without a word."""

from __future__ import annotations

import re
from math import isinf

from kinlint.terms import XSD, Term, literal_value

TOO_LARGE = "it is too large for a double"
"""Message about such a number."""
_DECIMAL = re.compile(r"\s*[-+]?(?:\d++(?:\.\d*)?|\.\d+)(?:[eE][-+]?\d+)?\s*", re.ASCII)
_DOUBLE = f"^^<{XSD}double>"


def exceeds_doubles(written: str) -> bool:
    """Tell whether *written* is a number larger than all doubles."""
    return _DECIMAL.fullmatch(written) is not None and isinf(float(written))


def is_too_large(term: Term) -> bool:
    """Tell whether *term* is a literal for such a number."""
    return term.endswith(_DOUBLE) and exceeds_doubles(literal_value(term))
