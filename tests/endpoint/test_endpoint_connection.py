"""How a store is spoken to: patience, credentials, and nobody else."""

import os
import sys
import threading
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer

import pytest

from kinlint.cli.main import main
from kinlint.configuration.user_configuration import user_file
from kinlint.endpoint.connection import Endpoint, EndpointError, QueryRefused

ROW = b'{"x": {"type": "uri", "value": "urn:a"}}'
ROWS = b'{"head": {"vars": ["x"]}, "results": {"bindings": [%s]}}' % ROW


class Server(ThreadingHTTPServer):
    """Answers with the statuses and headers that it is given, one after the other, then well."""

    def __init__(self, *planned):
        super().__init__(("127.0.0.1", 0), Handler)
        self.planned, self.asked, self.rows = list(planned), [], ROWS
        self.url = f"http://127.0.0.1:{self.server_port}/sparql"
        threading.Thread(target=self.serve_forever, daemon=True).start()


class Handler(BaseHTTPRequestHandler):
    def do_POST(self):
        body = self.rfile.read(int(self.headers["Content-Length"]))
        self.server.asked.append((dict(self.headers), body))
        status, headers = self.server.planned.pop(0) if self.server.planned else (200, {})
        self.send_response(status)
        for name, value in headers.items():
            self.send_header(name, value)
        self.end_headers()
        self.wfile.write(self.server.rows if status == 200 else b"no such function\nat line 1")

    def log_message(self, *_):
        pass


@pytest.fixture
def serving():
    servers = []

    def serve(*planned):
        servers.append(Server(*planned))
        return servers[-1]

    yield serve
    for each in servers:
        each.shutdown()
        each.server_close()


def _endpoint(url, environment=None):
    made = Endpoint.from_user(url, None, environment or {"NETRC": "/nowhere"}, 60)
    return Endpoint(made.query_url, made.update_url, 60, 4, 0.001, made.credentials)


@pytest.mark.slow
def test_a_busy_store_is_asked_again(serving):
    server = serving((503, {"Retry-After": "0"}), (429, {}), (500, {}))
    assert list(_endpoint(server.url).select("SELECT ?x {}")) == [{"x": "<urn:a>"}]
    assert len(server.asked) == 4


@pytest.mark.slow
def test_a_store_that_stays_busy_is_given_up(serving):
    server = serving(*[(503, {})] * 9)
    with pytest.raises(EndpointError, match="503"):
        list(_endpoint(server.url).select("SELECT ?x {}"))
    assert len(server.asked) == 4


@pytest.mark.slow
def test_a_refused_query_is_asked_once_and_says_why(serving):
    server = serving((400, {}))
    with pytest.raises(QueryRefused, match=r"400.*no such function"):
        list(_endpoint(server.url).select("SELECT ?x {}"))
    assert len(server.asked) == 1


@pytest.mark.slow
@pytest.mark.parametrize(
    ("answer", "cause"),
    [
        (b"<html>Log in</html>", "got '<html>Log in</html>'"),
        (ROWS[:-9], "expected SPARQL results in JSON"),
        (b"[" * 100_000, "expected SPARQL results in JSON"),
        (ROWS, "a solution without ?g"),
        (ROWS.replace(b'"x"', b'"g"').replace(b"urn:a", b"a> {"), "is no IRI"),
        (ROWS + b" " * 10**6, "more than 1,000,000 bytes"),
    ],
)
def test_wrong_answers_are_one_line(answer, cause, serving, capsys, monkeypatch):
    monkeypatch.setattr("kinlint.endpoint.connection.MOST_BYTES", 10**6)
    server = serving()
    server.rows = answer
    assert main(["check", "--isolated", "--endpoint", server.url]) == 2
    told = capsys.readouterr().err
    assert cause in told
    assert told.count("\n") == 1


@pytest.mark.slow
def test_credentials_come_from_the_environment_or_netrc(serving, tmp_path):
    server = serving()
    netrc = tmp_path / "netrc"
    netrc.write_text("machine 127.0.0.1 login me password secret")
    netrc.chmod(0o600)
    user = {"KINLINT_ENDPOINT_USER": "me", "KINLINT_ENDPOINT_PASSWORD": "secret"}
    for environment, expected in (
        ({"KINLINT_ENDPOINT_TOKEN": "abc"}, "Bearer abc"),
        (user, "Basic bWU6c2VjcmV0"),
        ({"NETRC": str(netrc)}, "Basic bWU6c2VjcmV0"),
        ({"NETRC": "/nowhere"}, None),
    ):
        list(_endpoint(server.url, environment).select("SELECT ?x {}"))
        assert server.asked[-1][0].get("Authorization") == expected


@pytest.mark.slow
def test_nothing_is_sent_to_another_host(serving):
    other = serving()
    server = serving((302, {"Location": other.url}))
    with pytest.raises(EndpointError, match="leads to"):
        list(_endpoint(server.url, {"KINLINT_ENDPOINT_TOKEN": "abc"}).select("SELECT ?x {}"))
    assert not other.asked


def test_other_addresses_are_refused(capsys):
    assert main(["check", "--isolated", "--endpoint", "ftp://127.0.0.1/"]) == 2
    assert "expected an address http(s)://" in capsys.readouterr().err


def test_no_file_of_a_project_names_an_endpoint(tmp_path, monkeypatch, capsys):
    """It is no key of a configuration."""
    monkeypatch.chdir(tmp_path)
    (tmp_path / "kinlint.toml").write_text('endpoint = "http://127.0.0.1:9/"')
    (tmp_path / "a.urdf").write_text('<robot name="a"><link name="b"/></robot>')
    assert main(["a.urdf"]) == 2
    assert "endpoint" in capsys.readouterr().err


@pytest.mark.slow
def test_the_user_may_give_names_to_stores(serving, tmp_path, monkeypatch, capsys):
    """No file of a project may: its keys are unknown there, and a name alone reaches nobody."""
    server = serving()
    monkeypatch.setenv("XDG_CONFIG_HOME", str(tmp_path))
    monkeypatch.setenv("APPDATA", str(tmp_path))
    monkeypatch.chdir(tmp_path)
    user = user_file(os.environ) if sys.platform != "darwin" else None
    if user is None:
        pytest.skip("the user's configuration lies below the home directory there")
    user.parent.mkdir()
    project = tmp_path / "kinlint.toml"
    project.write_text(f'endpoint = "{server.url}"')
    assert main(["check"]) == 2
    project.write_text(f'[endpoints]\nplant = "{server.url}"')
    assert main(["check", "--endpoint", "plant"]) == 2
    assert server.asked == []
    assert "a name in your configuration, got 'plant'" in capsys.readouterr().err

    project.unlink()
    for said in (
        f'plant = "{server.url}"',
        f'plant = {{ query = "{server.url}", update = "http://b" }}',
    ):
        user.write_text(f"[endpoints]\n{said}")
        main(["check", "--endpoint", "plant"])
        assert server.asked
        server.asked.clear()
    user.write_text("[endpoints]\nplant = 3")
    assert main(["check", "--endpoint", "plant"]) == 2


@pytest.mark.slow
@pytest.mark.parametrize(
    "query",
    [
        "SELECT $this WHERE { SERVICE <http://127.0.0.1:1/> { $this a ?x } }",
        "LOAD <http://127.0.0.1:1/>",
        "INSERT DATA { <a:a> <a:a> <a:a> }",
        "SELECT $this FROM <http://127.0.0.1:1/> WHERE { $this a ?x }",
    ],
)
def test_rules_of_users_neither_change_nor_leave_the_store(query, store, tmp_path, capsys):
    store.update("INSERT DATA { GRAPH <a:g> { <a:b> a <a:c> } }")
    shapes = tmp_path / "shapes.ttl"
    shapes.write_text(
        "@prefix sh: <http://www.w3.org/ns/shacl#> .\n"
        f'<a:s> a sh:NodeShape ; sh:targetClass <a:c> ; sh:sparql [ sh:select "{query}" ] .'
    )

    told = ["check", "--isolated", "--endpoint", store.query_url, "--shapes", str(shapes)]
    assert main(told) == 2
    assert "shapes.ttl" in capsys.readouterr().err
    assert len(list(store.select("SELECT ?s { GRAPH ?g { ?s ?p ?o } }"))) == 1
