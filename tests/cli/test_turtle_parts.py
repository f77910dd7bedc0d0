"""Turtle in a directory is read where it describes what the models there only name."""

from __future__ import annotations

import json

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


def test_other_turtle_is_passed_over(kinlint, write) -> None:
    """Shapes, copies of what is described already, and what cannot be read."""
    write("model.json", MODEL)
    write("copy.ttl", f"{HEAD}arm:root-origin a geom:Point .")
    write("shapes.ttl", f"{HEAD}arm:tip-origin <http://www.w3.org/ns/shacl#name> 'tip' .")
    write("broken.ttl", "arm:tip-origin a")

    code, out, err = kinlint(".", *FLAGS)

    assert code == 1
    assert "1 file" in out
    assert ".ttl" not in out + err
