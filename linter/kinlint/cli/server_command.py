"""`kinlint server`: tells editors of robots while they are written."""

from __future__ import annotations

from collections.abc import Sequence

from kinlint.cli.argument_parser import Parser, count

DESCRIPTION = """\
Start a language server (LSP) for editors, on standard input and output."""


def parser() -> Parser:
    """The parser of `kinlint server`."""
    made = Parser(prog="kinlint server", description=DESCRIPTION, usage="kinlint server [options]")
    add = made.add_argument
    add("--stdio", action="store_true", help="use standard input and output (default)")
    add("--tcp", type=count, metavar="PORT", help="listen on this local port instead")
    return made


def run(arguments: Sequence[str]) -> int:
    """Serve until the client leaves; 0 if it said so before."""
    options = parser().read(arguments)
    from kinlint.server.transport import on_port, on_standard_streams  # noqa: PLC0415  slow to import

    return on_standard_streams() if options.tcp is None else on_port(options.tcp)
