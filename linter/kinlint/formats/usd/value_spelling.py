"""Spells values as text layers have them."""

from __future__ import annotations

from kinlint.edits import NotExpressible
from kinlint.terms import NUMERIC, XSD, Term, literal_datatype, literal_value


def spelt(value: Term) -> str:
    """Return *value* as it is written; of strings, what stands between the quotes.

    Raises NotExpressible for a text with characters that would have to be escaped.
    """
    written = literal_value(value)
    if literal_datatype(value) in NUMERIC:
        return f"{float(written):.9g}" if "." in written or "e" in written.lower() else written
    if any(each in written for each in "\"'\\\n@"):
        raise NotExpressible("the text has characters that would have to be escaped")
    return written


def assigned(value: Term) -> str:
    """Return *value* as it stands behind an equals sign."""
    kind = literal_datatype(value)
    bare = kind in NUMERIC or kind == f"{XSD}boolean"
    return spelt(value) if bare else f'"{spelt(value)}"'
