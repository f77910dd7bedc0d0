"""Oxigraph's server on the loopback interface, for as long as it is needed."""

import shutil
import socket
import subprocess
import sys
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from kinlint.endpoint.connection import Endpoint, EndpointError


def program() -> str | None:
    """The path of the server; None if it is not installed."""
    beside = Path(sys.executable).with_name("oxigraph")
    return str(beside) if beside.exists() else shutil.which("oxigraph")


@contextmanager
def served(server: str, *options: str) -> Iterator[str]:
    """The address of an empty store, in memory unless *options* of the server say otherwise."""
    while True:
        port = _free_port()  # somebody else may take it before the server does
        process = subprocess.Popen(
            [server, "serve", "--bind", f"127.0.0.1:{port}", *options],
            stdout=subprocess.DEVNULL,
            stderr=subprocess.DEVNULL,
        )
        try:
            url = f"http://127.0.0.1:{port}/query"
            if _answers(process, url):
                yield url
                return
        finally:
            process.kill()
            process.wait()


VIRTUOSO = """[Database]
DatabaseFile={0}/v.db
ErrorLogFile={0}/v.log
LockFile={0}/v.lck
TransactionFile={0}/v.trx
xa_persistent_file={0}/v.pxa
[TempDatabase]
DatabaseFile={0}/t.db
TransactionFile={0}/t.trx
[Parameters]
ServerPort=127.0.0.1:{1}
[HTTPServer]
ServerPort=127.0.0.1:{2}
[SPARQL]
ResultSetMaxRows=1000000
"""
ALLOWED = "GRANT SPARQL_UPDATE TO \"SPARQL\"; DB.DBA.RDF_DEFAULT_USER_PERMS_SET('nobody', 7);"


@contextmanager
def virtuoso(directory: Path) -> Iterator[str]:
    """The address of an empty store of Virtuoso in *directory*, which anybody may change."""
    sql, http = _free_port(), _free_port()
    settings = directory / "virtuoso.ini"
    settings.write_text(VIRTUOSO.format(directory, sql, http))
    process = subprocess.Popen(
        ["virtuoso-t", "+foreground", "+configfile", str(settings)],
        stdout=subprocess.DEVNULL,
        stderr=subprocess.DEVNULL,
    )
    try:
        url = f"http://127.0.0.1:{http}/sparql"
        assert _answers(process, url)
        allowing = ["isql-vt", f"127.0.0.1:{sql}", "dba", "dba", f"exec={ALLOWED}"]
        subprocess.run(allowing, check=True, stdout=subprocess.DEVNULL)
        yield url
    finally:
        process.kill()
        process.wait()


def _answers(process: subprocess.Popen, url: str) -> bool:
    while process.poll() is None:
        try:
            list(Endpoint(url, url, attempts=1).select("SELECT ?x { }"))
        except EndpointError:
            time.sleep(0.05)
        else:
            return True
    return False


def _free_port() -> int:
    with socket.socket() as probe:
        probe.bind(("127.0.0.1", 0))
        return probe.getsockname()[1]
