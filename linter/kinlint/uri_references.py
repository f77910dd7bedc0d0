"""URI references of users, which need not be any: RFC 3986, section 4.1."""

from __future__ import annotations

from urllib.parse import SplitResult, urljoin, urlsplit


def split_uri(written: str) -> SplitResult:
    """Return the parts of a URI reference; all of what is none, such as `http://[`, is a path."""
    try:
        return urlsplit(written)
    except ValueError:
        return SplitResult("", "", written, "", "")


def resolve_uri(base: str, written: str) -> str:
    """Return *written* relative to *base*, or as it is where that cannot be resolved."""
    try:
        return urljoin(base, written)
    except ValueError:
        return written
