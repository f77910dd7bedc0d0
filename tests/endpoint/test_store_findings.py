"""Findings in models of a store: those of the files that were loaded, one by one."""

import json
import sqlite3
from contextlib import closing
from pathlib import Path

import pytest
from data import locate_data

from kinlint.catalogue import rulebook
from kinlint.cli.main import main
from kinlint.endpoint import stored_graphs
from kinlint.endpoint.pushing import Asking
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import decode, read

SAMPLES = Path(__file__).parents[2] / "samples"
SUFFIXES = ("urdf", "sdf", "srdf", "xml", "xacro", "dae", "usda", "jsonld")
FOREIGN = "broken/axis-not-one-line.jsonld"
ROBOTS = 500


@pytest.fixture(autouse=True)
def _at_samples(monkeypatch, rules_cache):
    monkeypatch.chdir(SAMPLES)


def _findings(capsys, *arguments):
    """The findings of a run, without fixes, which only files have."""
    capsys.readouterr()
    main(["check", "--isolated", "-n", "--output-format=json-lines", *arguments])
    lines = map(json.loads, capsys.readouterr().out.splitlines())
    bare = ({**one, "fix": None, "fixes": []} for one in lines)
    return sorted(json.dumps(one, sort_keys=True) for one in bare)


def _load(store, *paths):
    assert main(["load", "--isolated", "--endpoint", store.query_url, *paths]) == 0


def _stored(capsys, store, *arguments):
    return _findings(capsys, "--endpoint", store.query_url, *arguments)


@pytest.mark.slow
@pytest.mark.parametrize(
    "paths",
    [
        ["broken/dangling-reference.jsonld", "broken/dropped-term.jsonld"],
        ["broken/chain-and-members.srdf"],
        ["broken/closed-loop-lost.sdf", "broken/continuous-with-limits.urdf"],
    ],
    ids=lambda paths: paths[0],
)
def test_findings_are_those_of_the_files(store, capsys, paths):
    """Rule, message, place, premises and related places, also of an SRDF with its URDF beside."""
    _load(store, *paths)
    found = _findings(capsys, *paths)
    assert found
    assert _stored(capsys, store) == found


@pytest.mark.slow
@pytest.mark.parametrize("suffix", SUFFIXES)
def test_every_sample_has_the_findings_of_the_file(store, capsys, suffix):
    """All samples of a format, as one run over the files has them."""
    paths = sorted(str(each.relative_to(SAMPLES)) for each in SAMPLES.rglob(f"*.{suffix}"))
    while main(["load", "--isolated", "--endpoint", store.query_url, *paths]) != 0:
        told = capsys.readouterr().err  # of broken samples that cannot be read at all
        paths = [each for each in paths if f"error: {each}" not in told]
        store.update("DROP ALL")
    found = _findings(capsys, *paths)
    assert found
    assert _stored(capsys, store) == found


def _asked(store, code, suffix):
    form = "usd" if suffix == "usda" else suffix
    return Asking(store, rulebook.load(), {code}).concerned([form])[form]


@pytest.mark.slow
@pytest.mark.parametrize("suffix", ["urdf", "sdf", "usda"])
def test_rules_that_the_store_is_asked_for_miss_nothing(store, capsys, suffix):
    """Each model in which such a rule finds something is among those that the store names."""
    for path in sorted((SAMPLES / "broken").glob(f"*.{suffix}")):
        main(["load", "--isolated", "--endpoint", store.query_url, f"broken/{path.name}"])
    pushed = {
        rule.code: graphs
        for rule in rulebook.load().rules
        if (graphs := _asked(store, rule.code, suffix)) is not None
    }
    found = _stored(capsys, store, "--select", ",".join(pushed))
    for each in map(json.loads, found):
        graphs = pushed[each["code"]]
        assert any(name.endswith(f":{each['filename']}>") for name in graphs), each
    assert found


@pytest.mark.slow
def test_a_rule_about_what_is_written_streams_only_what_it_concerns(
    store, capsys, tmp_path, monkeypatch
):
    """The store is asked once, for all models; the others are counted, and not read."""
    monkeypatch.chdir(tmp_path)
    for name, part in (("good", ""), ("bad", "<lnik/>")):
        Path(f"{name}.urdf").write_text(f'<robot name="{name}"><link name="a"/>{part}</robot>')
        _load(store, f"{name}.urdf")
    assert _asked(store, "SRC003", "urdf") == {"<urn:kinlint:document:bad.urdf>"}
    assert _asked(store, "TOP001", "urdf") is None
    begun = []
    asking = Asking(store, rulebook.load(), {"SRC003", "SRC002"}, begin=begun.append)
    asking.concerned(["urdf"])
    assert sorted(begun) == ["SRC002", "SRC003"]
    chosen = _findings(capsys, "bad.urdf", "good.urdf", "--select", "SRC003")
    assert _stored(capsys, store, "--select", "SRC003") == chosen
    main(["check", "--isolated", "--endpoint", store.query_url, "--select", "SRC003"])
    assert "in 1 of 2 files" in capsys.readouterr().out
    main(["check", "--isolated", "--endpoint", store.query_url, "--select", "SRC002"])
    assert capsys.readouterr().out == "All checks passed in 2 files.\n"


@pytest.mark.slow
def test_public_robots_have_the_findings_of_the_files(store, capsys):
    """Five hundred robots that others made, URDF and SDF."""
    home = locate_data("robots")
    robots = sorted(
        (*home.rglob("*.urdf"), *home.rglob("*.sdf")), key=lambda one: one.stat().st_size
    )
    paths = list(map(str, robots[:ROBOTS]))
    assert main(["load", "--isolated", "--endpoint", store.query_url, *paths]) in {0, 2}
    assert _stored(capsys, store) == [
        each for each in _findings(capsys, *paths) if json.loads(each)["code"]
    ]


@pytest.mark.slow
def test_a_document_is_replaced_as_a_whole(store, capsys, tmp_path, monkeypatch):
    """What the new text does not say any more is gone, with its findings and places."""
    monkeypatch.chdir(tmp_path)
    robot = Path("arm.urdf")
    robot.write_text('<robot name="arm">\n<link name="base"/><lnik/><jiont/></robot>')
    _load(store, str(robot))
    before = _stored(capsys, store)
    robot.write_text('<robot name="arm">\n\n<link name="base"/><lnik/></robot>')
    _load(store, str(robot))
    after = _stored(capsys, store)
    assert len(after) < len(before)
    assert after == _findings(capsys, str(robot))


def test_a_database_has_the_findings_that_are_printed(store, capsys, tmp_path, monkeypatch):
    """With their related places, written model by model."""
    monkeypatch.chdir(tmp_path)
    for name in ("one", "two"):
        text = f'<robot name="{name}"><link name="a"/><link name="a"/><lnik/></robot>'
        Path(f"{name}.urdf").write_text(text)
    _load(store, "one.urdf", "two.urdf")
    found = [json.loads(each) for each in _stored(capsys, store, "--output", "sqlite=all.db")]
    with closing(sqlite3.connect("all.db")) as made:
        rows = made.execute("SELECT file, code, line, message FROM finding").fetchall()
        (related,) = made.execute("SELECT count(*) FROM related").fetchone()
        assert made.execute("SELECT name FROM file").fetchall() == [("one.urdf",), ("two.urdf",)]
    told = [(one["filename"], one["code"], one["location"]["row"], one["message"]) for one in found]
    assert sorted(rows) == sorted(told)
    assert related == sum(len(one["related"]) for one in found) > 0


@pytest.mark.slow
def test_what_is_deleted_in_the_store_is_not_judged(store, capsys, tmp_path, monkeypatch):
    """The graph decides what is true, the record of the text only where it was written."""
    monkeypatch.chdir(tmp_path)
    Path("arm.urdf").write_text('<robot name="arm"><link name="base"/><lnik/></robot>')
    _load(store, "arm.urdf")
    assert _stored(capsys, store)
    graph = "<urn:kinlint:document:arm.urdf>"
    store.update(
        f"DELETE {{ GRAPH {graph} {{ ?s ?p ?o }} }} WHERE {{ GRAPH {graph} {{ ?s ?p ?o }}"
        ' FILTER(CONTAINS(STR(?s), "lnik") || CONTAINS(STR(?o), "lnik")) }'
    )
    assert not _stored(capsys, store)


@pytest.mark.slow
def test_graphs_of_others_are_judged_by_what_they_state(store, capsys, tmp_path, monkeypatch):
    """Their findings stand at graph, IRI and property, in the lines of its N-Triples."""
    monkeypatch.chdir(tmp_path)
    source = decode("arm.jsonld", (SAMPLES / FOREIGN).read_bytes())
    lines = "".join("{} {} {} .\n".format(*each) for each in read(source, ReadOptions()).statements)
    store.update(f"INSERT DATA {{ GRAPH <https://example.org/plant> {{ {lines} }} }}")
    found = list(map(json.loads, _stored(capsys, store)))
    assert found
    assert {each["filename"] for each in found} == {"https://example.org/plant"}
    assert all(each["iri"] for each in found)


@pytest.mark.slow
def test_only_what_changed_since_is_checked(store, capsys, tmp_path, monkeypatch):
    """By the revision that loading tells, or by time."""
    monkeypatch.chdir(tmp_path)
    for name in ("one", "two"):
        Path(f"{name}.urdf").write_text(f'<robot name="{name}"><link name="a"/><lnik/></robot>')
        _load(store, f"{name}.urdf")
    names = {json.loads(each)["filename"] for each in _stored(capsys, store, "--since", "1")}
    assert names == {"two.urdf"}
    assert not _stored(capsys, store, "--since", "2")
    for time in ("2999-01-01T00:00:00Z", "2999-01-01"):
        assert not _stored(capsys, store, "--since", time)
    assert len(_stored(capsys, store, "--since", "2000-01-01")) > 1
    assert len(_stored(capsys, store, "--since", "2000-01-01T00:00:00Z")) > 1


def test_only_named_graphs_are_checked(store, capsys, tmp_path, monkeypatch):
    """`--graph` takes the names of graphs; a name of none is an error."""
    monkeypatch.chdir(tmp_path)
    for name in ("one", "two"):
        Path(f"{name}.urdf").write_text(f'<robot name="{name}"><link name="a"/><lnik/></robot>')
    _load(store, "one.urdf", "two.urdf")
    found = _stored(capsys, store, "--graph", "urn:kinlint:document:two.urdf")
    assert {json.loads(each)["filename"] for each in found} == {"two.urdf"}
    for name, cause in (("urn:nobody", "has no graph <urn:nobody>"), ("a>b", "got 'a>b'")):
        assert main(["check", "--endpoint", store.query_url, "--graph", name]) == 2
        assert cause in capsys.readouterr().err


@pytest.mark.slow
def test_long_answers_come_in_pages(store, capsys, tmp_path, monkeypatch):
    """More graphs than fit on a page, and more statements."""
    monkeypatch.chdir(tmp_path)
    monkeypatch.setattr(stored_graphs, "PAGE", 3)
    names = [f"r{number}.urdf" for number in range(7)]
    for name in names:
        Path(name).write_text(f'<robot name="{name}"><link name="a"/><lnik/></robot>')
    _load(store, *names)
    assert _stored(capsys, store, "--jobs", "1") == _findings(capsys, *names)
