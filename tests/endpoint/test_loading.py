"""Loading: file by file, past what cannot be loaded, in memory that does not grow."""

from pathlib import Path

import pytest

from kinlint.cli.main import main
from kinlint.endpoint import loading
from kinlint.endpoint.connection import Endpoint, EndpointError, QueryRefused
from kinlint.endpoint.stored_graphs import FILE
from kinlint.formats import registry
from kinlint.terms import literal_value

NAMES = ("one", "two", "three", "four", "five")


@pytest.fixture
def robots(tmp_path, monkeypatch, rules_cache):
    """Makes the working directory one of five robots."""
    monkeypatch.chdir(tmp_path)
    for name in NAMES:
        Path(f"{name}.urdf").write_text(f'<robot name="{name}"><link name="a"/></robot>')


@pytest.fixture
def failing(monkeypatch):
    """Has updates fail that contain a text."""

    def fail(text, kind):
        made = Endpoint.update

        def update(self, said):
            if text in said:
                raise kind("the store: no")
            made(self, said)

        monkeypatch.setattr(Endpoint, "update", update)

    return fail


def _load(store, *paths):
    return main(["load", "--isolated", "--endpoint", store.query_url, *(paths or ["."])])


def _loaded(store):
    rows = store.select(f"SELECT ?file {{ GRAPH ?g {{ ?g {FILE} ?file }} }}")
    return {literal_value(row["file"]) for row in rows}


def test_what_the_store_refuses_is_named_and_the_others_are_loaded(robots, store, failing, capsys):
    failing('"two.urdf"', QueryRefused)
    assert _load(store) == 2
    said = capsys.readouterr()
    assert said.err == "kinlint: error: two.urdf: the store: no\n"
    assert said.out.startswith("Loaded 4 documents; the store is at revision ")
    assert _loaded(store) == {f"{each}.urdf" for each in NAMES} - {"two.urdf"}


def test_what_cannot_be_read_is_named_and_the_others_are_loaded(robots, store, monkeypatch, capsys):
    """A link to nothing, and one at which the reader itself fails."""
    read = registry.read

    def failing(source, options):
        if source.name == "four.urdf":
            raise ValueError("unforeseen")
        return read(source, options)

    monkeypatch.setattr(registry, "read", failing)
    try:
        Path("gone.urdf").symlink_to("nowhere")
    except OSError:
        pytest.skip("no links here")
    assert _load(store) == 2
    gone, four = capsys.readouterr().err.splitlines()
    assert gone == "kinlint: error: gone.urdf: a link to nothing"
    assert four.startswith("kinlint: error: four.urdf: error in kinlint itself: ValueError")
    assert _loaded(store) == {f"{each}.urdf" for each in NAMES} - {"four.urdf"}


def test_a_store_that_refuses_all_is_one_line(robots, store, failing, capsys):
    failing("", QueryRefused)
    assert _load(store) == 2
    assert capsys.readouterr().err == "kinlint: error: the store: no (loaded 0 documents before)\n"


def test_a_store_that_is_gone_ends_the_run(robots, store, failing, monkeypatch, capsys):
    monkeypatch.setattr(loading, "MOST_LETTERS", 1)
    failing('"two.urdf"', EndpointError)
    assert _load(store, *(f"{each}.urdf" for each in NAMES)) == 2
    assert capsys.readouterr().err == "kinlint: error: the store: no (loaded 1 document before)\n"
    assert _loaded(store) == {"one.urdf"}


def test_a_file_is_read_when_it_is_loaded(robots, store, monkeypatch):
    """No more documents are kept than make one update."""
    numbers, names = [], []
    read, update = registry.read, Endpoint.update

    def reading(source, options):
        names.append(source.name)
        return read(source, options)

    def updating(self, text):
        update(self, text)
        numbers.append(len(names))

    monkeypatch.setattr(loading, "MOST_LETTERS", 1)
    monkeypatch.setattr(registry, "read", reading)
    monkeypatch.setattr(Endpoint, "update", updating)
    assert _load(store) == 0
    assert numbers == [2, 3, 4, 5, 5]
