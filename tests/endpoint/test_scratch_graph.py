"""A graph in which a store infers, so that it can be asked where rules may find anything."""

import json
import signal
import subprocess
import sys
import threading
from contextlib import suppress
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from urllib.request import Request, urlopen

import pytest
from support.linting import book

from kinlint.cli.main import main
from kinlint.endpoint import scratch, stored_graphs
from kinlint.endpoint.connection import Endpoint, EndpointError, QueryRefused
from kinlint.endpoint.loading import Loader
from kinlint.endpoint.pushing import Asking
from kinlint.endpoint.scratch import scratch_graph
from kinlint.endpoint.source_record import StoredDocument
from kinlint.endpoint.storable import refused
from kinlint.errors import SourceError
from kinlint.formats.options import ReadOptions
from kinlint.formats.records import BY_NAME, GRAPHS
from kinlint.formats.registry import read
from kinlint.rule_testing.example_texts import unmarked
from kinlint.text import SourceText

pytestmark = pytest.mark.slow

SAMPLES = Path(__file__).parents[2] / "samples"
NAME = "urn:kinlint:scratch"
TERM = f"<{NAME}>"
ASKED = ("FRM007", "--scratch-graph", NAME)
FORMATS = [each.name for each in GRAPHS]


def _graphs(store):
    rows = store.select("SELECT DISTINCT ?g { GRAPH ?g { ?s ?p ?o } }")
    return {row["g"] for row in rows}


def _check(url, *select):
    """Check with rules that ask for what is inferred; the exit code."""
    return main(["check", "--isolated", "--endpoint", url, "--select", *select])


def _findings(capsys, url, *arguments):
    capsys.readouterr()
    main(["check", "--isolated", "--output-format=json-lines", "--endpoint", url, *arguments])
    return sorted(capsys.readouterr().out.splitlines())


@pytest.fixture
def composable(store, tmp_path, monkeypatch, rules_cache):
    """Two models in the store, each one graph; the first has a joint without an axis."""
    monkeypatch.chdir(tmp_path)
    for name in (
        "broken/implicit-joint-axis.jsonld",
        "mobile-manipulator/left-arm/dynamics.jsonld",
    ):
        path = Path(Path(name).name)
        path.write_bytes((SAMPLES / name).read_bytes())
        assert main(["load", "--isolated", "--endpoint", store.query_url, str(path)]) == 0
    return store


def _texts():
    """Yield the composable samples, and all bad examples of rules about composable models."""
    for path in sorted(SAMPLES.rglob("*.jsonld")):
        yield SourceText(f"{path.relative_to(SAMPLES).as_posix()}", path.read_text("utf-8"))
    for rule in book().rules:
        for number, each in enumerate(rule.examples):
            if each.format in FORMATS and each.bad is not None and not each.beside:
                suffix = "ttl" if each.format == "turtle" else each.format
                yield SourceText(f"{rule.code}-{number}.{suffix}", unmarked(each.bad)[0])


def _documents():
    for source in _texts():
        with suppress(SourceError):
            document = read(source, ReadOptions())
            yield [StoredDocument(document, refused(document.statements))]


def test_no_rule_misses_a_model_for_what_a_store_infers(store, capsys, rules_cache):
    """Each finding lies in a graph that the store names for its rule, with the graph or without."""
    for _ in Loader(store).load(_documents(), print):
        pass
    found = {}
    for line in _findings(capsys, store.query_url, "--show=info"):
        told = json.loads(line)
        name = f"<urn:kinlint:document:{told['filename']}>"
        found.setdefault(told["code"], set()).add(name)
    assert len(found) > 100
    asked = {}
    for name in (None, TERM):
        plans = {code: _plans(Asking(store, book(), {code}), name) for code in found}
        asked[name] = {code for code, each in plans.items() if all(each.values())}
        with scratch_graph(store, TERM, print) as graph:
            if name is not None:
                graph.infer(book().axioms, str)
            for code in asked[name]:
                graphs = Asking(store, book(), {code}).graphs(plans[code], name)
                assert found[code] <= frozenset().union(*graphs.values()), code
    assert len(asked[None]) > 50
    assert len(asked[TERM] - asked[None]) > 30


def _plans(asking, name):
    return {form: asking.plan(BY_NAME[form], name) for form in FORMATS}


def test_a_store_infers_where_rules_may_find_anything(composable, capsys):
    """The rule asks for a class that no document states; findings are those without the graph."""
    before = _graphs(composable)
    assert _check(composable.query_url, *ASKED, "-v") == 1
    told = capsys.readouterr()
    assert "FRM007: 1 graphs to look at" in told.err
    assert "in 1 of 2 files" in told.out
    found = _findings(capsys, composable.query_url, "--select", *ASKED)
    assert found == _findings(capsys, composable.query_url, "--select", "FRM007")
    assert found
    assert _graphs(composable) == before


def test_nothing_is_written_where_it_is_of_no_use(composable, monkeypatch, capsys):
    """The store can be asked for SRC003 as it is, and by default some rule is about any model."""
    monkeypatch.setattr(Endpoint, "update", lambda *_: pytest.fail("written"))
    for select in ("SRC003", "ALL"):
        _check(composable.query_url, select, "--scratch-graph", NAME)


@pytest.mark.parametrize("error", [KeyboardInterrupt, EndpointError("lost"), SystemExit(143)])
def test_the_graph_is_removed_after_an_interruption(error, composable, monkeypatch):
    before = _graphs(composable)

    def interrupted(*_):
        assert TERM in _graphs(composable)
        raise error

    monkeypatch.setattr("kinlint.endpoint.pushing._matches", interrupted)
    with suppress(SystemExit):
        _check(composable.query_url, *ASKED)
    assert _graphs(composable) == before


class Forwarding(BaseHTTPRequestHandler):
    """Sends all to a store; sends a signal to a process when the store has begun to infer."""

    def do_POST(self):
        body = self.rfile.read(int(self.headers["Content-Length"]))
        kept = {name: self.headers[name] for name in ("Accept", "Content-Type")}
        if b"INSERT" in body and b"WHERE" in body and self.server.process is not None:
            self.server.process.send_signal(self.server.number)
            self.server.process = None
        asked = Request(self.server.store + self.path, body, kept)  # noqa: S310  the store
        with urlopen(asked) as answer:  # noqa: S310
            told = answer.read()
        self.send_response(200)
        self.send_header("Content-Length", str(len(told)))
        self.end_headers()
        with suppress(OSError):
            self.wfile.write(told)

    def log_message(self, *_):
        pass


@pytest.mark.skipif(sys.platform == "win32", reason="signals end processes there")
@pytest.mark.parametrize("name", ["SIGINT", "SIGTERM", "SIGHUP", "SIGKILL"])
def test_the_graph_is_removed_where_a_signal_ends_the_run(name, composable, capsys):
    """One that cannot be caught leaves it; the next run says so and removes it."""
    before = _graphs(composable)
    with ThreadingHTTPServer(("127.0.0.1", 0), Forwarding) as server:
        server.store = composable.query_url.removesuffix("/query")
        server.number = getattr(signal, name)
        server.process = None
        threading.Thread(target=server.serve_forever, daemon=True).start()
        url = f"http://127.0.0.1:{server.server_port}/query"
        command = ["check", "--isolated", "--endpoint", url, "--select", *ASKED]
        process = subprocess.Popen(
            [sys.executable, "-m", "kinlint", *command], stderr=subprocess.PIPE, text=True
        )
        server.process = process
        _, told = process.communicate()
        server.shutdown()
    killed = name == "SIGKILL"
    assert "Traceback" not in told
    assert process.returncode not in {0, 1, 2}
    assert (TERM in _graphs(composable)) == killed
    assert _check(composable.query_url, *ASKED) == 1
    left = f"kinlint: --scratch-graph: {TERM} of a run that did not end is removed\n"
    assert capsys.readouterr().err == (left if killed else "")
    assert _graphs(composable) == before


def test_a_graph_of_somebody_is_no_scratch_graph(composable, capsys):
    composable.update(f"INSERT DATA {{ GRAPH {TERM} {{ <a:a> <a:b> 1 }} }}")
    assert _check(composable.query_url, *ASKED) == 2
    assert "name one that is new" in capsys.readouterr().err
    assert TERM in _graphs(composable)


def test_what_a_killed_run_left_is_no_model(composable, capsys):
    before = _findings(capsys, composable.query_url)
    left = f"{TERM} a {stored_graphs.SCRATCH} . <a:b> a <a:c>"
    composable.update(f"INSERT DATA {{ GRAPH {TERM} {{ {left} }} }}")
    assert _findings(capsys, composable.query_url) == before


def test_where_another_run_takes_the_graph_all_models_are_read(composable, monkeypatch, capsys):
    before = _graphs(composable)
    infer = scratch.ScratchGraph.infer

    def taken(self, axioms, begin):
        infer(self, axioms, begin)
        scratch.ScratchGraph(self.endpoint, self.name, '"x"', self.interruptions).begin()
        return 0

    monkeypatch.setattr(scratch.ScratchGraph, "infer", taken)
    assert _check(composable.query_url, *ASKED) == 1
    assert "another run has taken it, so all composable" in capsys.readouterr().err
    assert _graphs(composable) == before | {TERM}


def test_a_store_that_does_not_infer_is_told_and_all_models_are_read(
    composable, monkeypatch, capsys
):
    before = _graphs(composable)
    update = Endpoint.update

    def refusing(self, text):
        if "WHERE" in text:
            raise QueryRefused("no")
        update(self, text)

    monkeypatch.setattr(Endpoint, "update", refusing)
    assert _check(composable.query_url, *ASKED) == 1
    assert "the store does not infer: no, so all composable" in capsys.readouterr().err
    assert _graphs(composable) == before


def test_a_store_that_takes_no_updates_is_one_line(composable, monkeypatch, capsys):
    def refusing(*_):
        raise EndpointError("http://a/update: 403 Forbidden")

    monkeypatch.setattr(Endpoint, "update", refusing)
    assert _check(composable.query_url, *ASKED) == 2
    told = capsys.readouterr().err
    assert told == "kinlint: error: --scratch-graph: http://a/update: 403 Forbidden\n"
