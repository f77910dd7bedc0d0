"""A SPARQL 1.1 endpoint over HTTP: queries, updates, credentials, retries.

Only the standard library, and only addresses that the user named: no proxy answer, no redirection
to another host and no SERVICE leads elsewhere.
"""

from __future__ import annotations

import json
import time
import urllib.request
from argparse import Namespace
from base64 import b64encode
from collections.abc import Iterator, Mapping
from http.client import HTTPException, HTTPMessage
from netrc import NetrcParseError, netrc
from typing import IO, Any
from urllib.error import HTTPError, URLError
from urllib.parse import urlencode, urlsplit

from kinlint import __version__
from kinlint.configuration.user_configuration import known_store
from kinlint.errors import KinlintError, UsageError
from kinlint.light_dataclasses import dataclass, field
from kinlint.terms import Term, blank, iri, literal

AGAIN = frozenset({408, 429, 500, 502, 503, 504})
"""Statuses of HTTP that may be another the next time (RFC 9110, section 15)."""
MOST_BYTES = 256 * 2**20
"""Size of the longest answer that is read."""
LONGEST_PAUSE = 30.0
"""Longest time in seconds to wait for a server that asks to be left alone."""
USER, PASSWORD, TOKEN = (f"KINLINT_ENDPOINT_{name}" for name in ("USER", "PASSWORD", "TOKEN"))
"""Environment variables with the credentials; without them, those of `~/.netrc` hold."""


class EndpointError(KinlintError):
    """A store cannot be reached, or does not answer in time, or not in SPARQL's way."""


class QueryRefused(EndpointError):
    """A store answers, but refuses this query or update."""


class _Solution(dict[str, Term]):
    """A solution of a query, by variable."""

    def __missing__(self, name: str) -> Term:
        raise EndpointError(f"the store gives a solution without ?{name}")


@dataclass(frozen=True)
class Endpoint:
    """A store, as one run uses it."""

    query_url: str
    """The address that takes queries."""
    update_url: str
    """The address that takes updates."""
    timeout: float | None = 120.0
    """Seconds that the store may be silent; None for any time."""
    attempts: int = 5
    """Number of attempts at a request that fails for a reason that may pass."""
    pause: float = 0.5
    """Seconds before the second attempt; doubled before each further one."""
    credentials: str = field(default="", repr=False)
    """The value of the header `Authorization`; empty for none."""

    @classmethod
    def from_options(cls, options: Namespace, environment: Mapping[str, str]) -> Endpoint:
        """Return the endpoint that *options* of the command line name. Raises `UsageError`.

        A name without a slash is one that the user's own configuration gives to an address.
        """
        timeout = options.endpoint_timeout or None
        url, update = options.endpoint, options.update_endpoint
        if "/" not in url and (known := known_store(url, environment)) is not None:
            url, update = known.query, update or known.update
        return cls.from_user(url, update, environment, timeout)

    @classmethod
    def from_user(
        cls, url: str, update_url: str | None, environment: Mapping[str, str], timeout: float | None
    ) -> Endpoint:
        """Return the endpoint at *url*, with the credentials that the user has for it.

        Updates go to *update_url*; without one, to `update` beside a *url* that ends in `query`,
        as servers of Oxigraph have it, else to *url* itself. Raises `UsageError`.
        """
        for each in (url, update_url or url):
            parts = _parts(each)
            if parts.scheme not in {"http", "https"} or not parts.hostname:
                kinds = "an address http(s)://... or a name in your configuration"
                raise UsageError(f"--endpoint: expected {kinds}, got '{each}'")
            if parts.username or parts.password:
                raise UsageError(f"--endpoint: no passwords in addresses: use {USER}, {PASSWORD}")
        beside = url[: -len("query")] + "update" if url.endswith("/query") else url
        return cls(url, update_url or beside, timeout, credentials=_credentials(url, environment))

    def select(self, query: str) -> Iterator[dict[str, Term]]:
        """Yield the solutions of *query*: the tokens of bound variables by name."""
        kind = "application/sparql-results+json"
        answer = self._ask(self.query_url, "query", query, kind)
        try:
            found = json.loads(answer)["results"]["bindings"]
            for given in found:
                yield _Solution((name, _token(each)) for name, each in given.items())
        except (ValueError, KeyError, TypeError, AttributeError, RecursionError):
            begun = " ".join(answer[:60].decode("utf-8", "replace").split())
            cause = f"expected SPARQL results in JSON, got '{begun}'"
            raise EndpointError(f"{self.query_url}: {cause}") from None

    def update(self, text: str) -> None:
        """Make an update, which is made as a whole or not at all where the store keeps to SPARQL.

        It may be made twice, when the answer to the first attempt is lost.
        """
        self._ask(self.update_url, "update", text, "*/*")

    def _ask(self, url: str, kind: str, text: str, accepted: str) -> bytes:
        body = urlencode({kind: text}, errors="replace").encode()
        headers = {"Accept": accepted, "User-Agent": f"kinlint/{__version__}"}
        if self.credentials and _origin(url) == _origin(self.query_url):
            headers["Authorization"] = self.credentials
        asked = urllib.request.Request(url, body, headers)  # noqa: S310  its scheme is checked
        pause = self.pause
        for attempt in range(1, self.attempts + 1):
            try:
                with _opener.open(asked, timeout=self.timeout) as answer:
                    read: bytes = answer.read(MOST_BYTES + 1)
                    if len(read) > MOST_BYTES:
                        raise EndpointError(f"{url}: the answer has more than {MOST_BYTES:,} bytes")
                    return read
            except HTTPError as error:
                if error.code not in AGAIN or attempt == self.attempts:
                    raise _refusal(url, error) from None
                pause = max(pause, _asked_pause(error.headers.get("Retry-After")))
            except (URLError, HTTPException, OSError) as error:
                if attempt == self.attempts:
                    cause = getattr(error, "reason", None) or error
                    raise EndpointError(f"{url}: {cause or type(error).__name__}") from None
            time.sleep(min(pause, LONGEST_PAUSE))
            pause *= 2
        raise AssertionError  # the last attempt returns or raises


class _SameOrigin(urllib.request.HTTPRedirectHandler):
    """Follows redirections only where they lead to the same host and port."""

    def redirect_request(  # noqa: PLR0913, PLR0917  of the standard library
        self,
        req: urllib.request.Request,
        fp: IO[bytes],
        code: int,
        msg: str,
        headers: HTTPMessage,
        newurl: str,
    ) -> urllib.request.Request | None:
        if _origin(newurl) != _origin(req.full_url):
            raise EndpointError(f"{req.full_url}: leads to {newurl}; name that address instead")
        return super().redirect_request(req, fp, code, msg, headers, newurl)


_opener = urllib.request.build_opener(_SameOrigin)


def _parts(url: str) -> Any:
    try:
        return urlsplit(url)
    except ValueError as error:
        raise UsageError(f"--endpoint: '{url}': {error}") from None


def _origin(url: str) -> tuple[str, str]:
    return urlsplit(url)[:2]


def _credentials(url: str, environment: Mapping[str, str]) -> str:
    """Return what authorises requests to *url*: by the environment, else by `.netrc`."""
    if token := environment.get(TOKEN):
        return f"Bearer {token}"
    user, password = environment.get(USER), environment.get(PASSWORD, "")
    if not user:
        try:
            known = netrc(environment.get("NETRC")).authenticators(_parts(url).hostname)
        except (OSError, NetrcParseError):
            known = None
        if known is None:
            return ""
        user, _, password = known
    return "Basic " + b64encode(f"{user}:{password}".encode()).decode()


def _refusal(url: str, error: HTTPError) -> EndpointError:
    told = error.read(2000).decode("utf-8", "replace").strip()
    cause = f"{error.code} {error.reason}" + (f": {told.splitlines()[0][:300]}" if told else "")
    unanswered = {401, 403, 404, *AGAIN} - {500}  # 500 is how Virtuoso refuses, too
    kind = EndpointError if error.code in unanswered else QueryRefused
    return kind(f"{url}: {cause}")


def _asked_pause(said: str | None) -> float:
    """Return the seconds that the header `Retry-After` asks for; 0 without one, or for a date."""
    return float(said) if said and said.isdecimal() else 0.0


def _token(value: Mapping[str, str]) -> Term:
    """Return the token of a term in SPARQL 1.1 Query Results JSON."""
    match value["type"]:
        case "uri":
            return iri(value["value"])
        case "bnode":
            return blank(value["value"])
        case _:
            return literal(value["value"], value.get("datatype", ""), value.get("xml:lang", ""))
