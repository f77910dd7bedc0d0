"""Turtle in a directory is read where it describes what the models there only name."""

from __future__ import annotations

import json

import pytest

from kinlint.project import turtle_parts

GEOMETRY = "https://comp-rob2b.github.io/metamodels/geometry/structural-entities"
MODEL = json.dumps(
    {
        "@context": [f"{GEOMETRY}.json", {"arm": "https://example.org/arm#"}],
        "@graph": [
            {"@id": "arm:tip", "@type": "Frame", "origin": "arm:tip-origin"},
            {"@id": "arm:root-origin", "@type": "Point"},
        ],
    }
)
HEAD = f"@prefix arm: <https://example.org/arm#> . @prefix geom: <{GEOMETRY}#> .\n"
FLAGS = ("--select", "LD006", "--output-format", "concise")


def test_a_part_in_turtle_is_read(kinlint, write) -> None:
    """Nothing dangles then."""
    write("model.json", MODEL)
    assert "arm:tip-origin" in kinlint(".", *FLAGS)[1]

    write("skeleton.ttl", f"{HEAD}arm:tip-origin a geom:Point .")

    assert kinlint(".", *FLAGS)[0] == 0
    assert kinlint("model.json", *FLAGS)[0] == 1


@pytest.mark.parametrize(
    "context",
    [
        [f"{GEOMETRY}.json", {"@base": "https://example.org/arm#"}],
        [f"{GEOMETRY}.json", "./names.json"],
        [f"{GEOMETRY}.json"],
    ],
    ids=["relative names", "prefix in a file beside", "whole IRIs"],
)
def test_names_are_compared_as_the_contexts_expand_them(context, kinlint, write) -> None:
    """However they are written in the model."""
    prefix = {2: "https://example.org/arm#", 1: "https://example.org/arm#"}[len(context)]
    own = "" if isinstance(context[-1], dict) else "arm:" if context[1:] else prefix
    write("names.json", json.dumps({"@context": {"arm": prefix}}))
    node = {"@id": f"{own or prefix}tip", "@type": "Frame", "origin": f"{own or '#'}tip-origin"}
    write("model.json", json.dumps({"@context": context, **node}))
    assert kinlint(".", *FLAGS)[0] == 1

    write("skeleton.ttl", f"{HEAD}arm:tip-origin a geom:Point .")

    assert kinlint(".", *FLAGS)[0] == 0


def test_parts_of_parts_are_read(kinlint, write) -> None:
    """What a part names and does not describe is looked for in its turn."""
    write("model.json", MODEL)
    write("tip.ttl", f"{HEAD}arm:tip-origin a geom:Point . arm:z geom:start arm:z-start .")
    assert "arm:z-start" in kinlint(".", *FLAGS)[1]

    write("start.ttl", f"{HEAD}arm:z-start a geom:Point .")

    assert kinlint(".", *FLAGS)[0] == 0


@pytest.mark.slow
def test_a_part_of_the_project_is_read_for_a_file_of_it(kinlint, write) -> None:
    """With --in-project; its own findings are not reported, unless it is given."""
    write("model.json", MODEL)
    write("skeleton.ttl", f"{HEAD}arm:tip-origin a geom:Point . arm:z geom:start arm:nothing .")

    assert kinlint("--in-project", "model.json", *FLAGS)[0] == 0
    assert "arm:nothing" in kinlint("--in-project", "skeleton.ttl", *FLAGS)[1]
    assert "arm:nothing" in kinlint(".", *FLAGS)[1]


def test_a_broken_part_is_told(kinlint, write) -> None:
    """Turtle that names what dangles, but cannot be read, is no silent loss."""
    write("model.json", MODEL)
    write("broken.ttl", f"{HEAD}arm:tip-origin a")

    code, out, err = kinlint(".", *FLAGS)

    assert code == 2
    assert "broken.ttl" in out + err


def test_other_turtle_is_passed_over(kinlint, write) -> None:
    """Shapes, copies of what is described already, and what cannot be read."""
    write("model.json", MODEL)
    write("copy.ttl", f"{HEAD}arm:root-origin a geom:Point .")
    write("shapes.ttl", f"{HEAD}arm:tip-origin <http://www.w3.org/ns/shacl#name> 'tip' .")
    write("broken.ttl", "arm:lid-origin a")

    code, out, err = kinlint(".", *FLAGS)

    assert code == 1
    assert "1 file" in out
    assert ".ttl" not in out + err


def test_turtle_alone_is_told(kinlint, write) -> None:
    """A directory with nothing but models in Turtle does not pass as clean."""
    write("skeleton.ttl", f"{HEAD}arm:tip-origin a geom:Point .")

    code, _, err = kinlint(".", *FLAGS)

    assert code == 2
    assert "skeleton.ttl was not checked" in err


@pytest.mark.parametrize(("name", "read"), [("tip-origin", 1), ("gripper", 0), ("Frame", 0)])
def test_models_are_read_for_turtle_only_where_they_have_its_names(
    name, read, kinlint, write, monkeypatch
) -> None:
    """A vocabulary beside them costs nothing."""
    seen = []
    parse = turtle_parts._document

    def counted(source, options):
        seen.append(source.name)
        return parse(source, options)

    monkeypatch.setattr(turtle_parts, "_document", counted)
    write("model.json", MODEL)
    write("other.ttl", f"{HEAD}{'geom' if name == 'Frame' else 'arm'}:{name} a geom:Point .")
    kinlint(".", *FLAGS)
    assert seen.count("model.json") == read
