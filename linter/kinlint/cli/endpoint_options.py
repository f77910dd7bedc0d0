"""The options about a triple store, of all commands that know one."""

from __future__ import annotations

import os
from argparse import Namespace
from typing import TYPE_CHECKING

from kinlint.cli.argument_parser import Parser, non_empty, seconds

if TYPE_CHECKING:
    from kinlint.endpoint.connection import Endpoint

TIMEOUT = 120.0
"""Seconds that a store may be silent by default."""


def add_connection_options(made: Parser, title: str) -> None:
    """Add the options for the address of a store, as a group with this *title*."""
    add = made.add_argument_group(title).add_argument
    add("--endpoint", type=non_empty, metavar="URL", help="SPARQL 1.1 endpoint of the store")
    add(
        "--update-endpoint",
        type=non_empty,
        metavar="URL",
        help="where updates go (default: .../update for .../query, else the endpoint)",
    )
    add(
        "--endpoint-timeout",
        type=seconds,
        metavar="SECONDS",
        default=TIMEOUT,
        help="how long the store may be silent (default: 120)",
    )


def endpoint(options: Namespace) -> Endpoint:
    """Return the store that *options* name, with the user's credentials."""
    from kinlint.endpoint.connection import Endpoint  # noqa: PLC0415  few runs ask a store

    return Endpoint.from_user(
        options.endpoint, options.update_endpoint, os.environ, options.endpoint_timeout or TIMEOUT
    )
