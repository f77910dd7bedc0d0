"""Downloads one context, because the user gave its address on the command line."""

from __future__ import annotations

import time
from http.client import HTTPException

from kinlint.errors import UsageError
from kinlint.uri_references import split_uri

SECONDS = 20.0
"""Time that a download may take."""
CHUNK = 1 << 16
ACCEPTED = "application/ld+json, application/json;q=0.9"


def is_address(given: str) -> bool:
    """Tell whether *given* is the address of a page, and not the path of a file."""
    return split_uri(given).scheme.lower() in ("http", "https")


def download(address: str, most: int) -> bytes:
    """Return what is at *address*, at most *most* bytes. Raises `UsageError` if that fails.

    Only HTTP is spoken, also where a server leads elsewhere.
    """
    from urllib import request  # noqa: PLC0415  few runs use the network

    opener = request.OpenerDirector()
    for handler in (
        request.ProxyHandler,
        request.HTTPHandler,
        request.HTTPSHandler,
        request.HTTPRedirectHandler,
        request.HTTPDefaultErrorHandler,
        request.HTTPErrorProcessor,
    ):
        opener.add_handler(handler())
    asked = request.Request(address, headers={"Accept": ACCEPTED})  # noqa: S310  the opener speaks HTTP only
    end, data = time.monotonic() + SECONDS, b""
    try:
        answer = opener.open(asked, timeout=SECONDS)
        if answer is None:
            raise UsageError(f"{address}: leads to something that is not HTTP")
        with answer:
            while chunk := answer.read(CHUNK):
                data += chunk
                if len(data) > most:
                    raise UsageError(f"{address}: more than {most >> 20} MiB")
                if time.monotonic() > end:
                    raise UsageError(f"{address}: takes more than {SECONDS:.0f} seconds")
    except (OSError, HTTPException, ValueError) as error:
        raise UsageError(f"{address}: {getattr(error, 'reason', None) or error}") from None
    return data
