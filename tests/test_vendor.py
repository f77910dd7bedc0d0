"""A vendor extends the metamodels by a context and a Turtle file, without touching kinlint."""

from __future__ import annotations

import re
import shutil
from pathlib import Path
from textwrap import dedent

import pytest

from kinlint.cli.main import main

pytestmark = [pytest.mark.xdist_group("vendor"), pytest.mark.usefixtures("rules_cache")]
ROOT = Path(__file__).parents[1]
SAMPLE = ROOT / "samples" / "vendor"
FENCE = re.compile(r"^( *)```(\w+)\n(.*?)^\1```", re.DOTALL | re.MULTILINE)
ENGINES = ("oxigraph", pytest.param("pyshacl", marks=pytest.mark.oracle))

FAULTS = [
    ("[ 0.0, 0.0, 0.42 ]", "[ 0.0, 0.42 ]", {"SHACL001"}),
    ('"unit": "M",', "", {"UNI001"}),
    ('"as-seen-by": "tool:root",', "", {"FRM002"}),
    ("[ 0.0, 0.0, 0.42 ]", '[ 0.0, 0.0, "0.42 m" ]', {"LD022", "SHACL001"}),
    ('"unit": "M",', '"unit": "KiloGM",', {"UNI002"}),
    ('"vendor:VectorList"', '"vendor:VectorLists"', {"LD021"}),
]


@pytest.fixture
def model(tmp_path):
    """The sample's files, to be broken."""
    return Path(shutil.copytree(SAMPLE, tmp_path / "vendor"))


def codes(folder, capsys, engine="oxigraph"):
    """The codes of the findings in *folder*, with its own configuration."""
    main([str(folder), "--trust", "--engine", engine, "--output", "concise", "--show", "info"])
    return set(re.findall(r"\[([A-Z]+\d+)\]$", capsys.readouterr().out, re.MULTILINE))


@pytest.mark.slow
@pytest.mark.parametrize("engine", ENGINES)
def test_the_sample_is_clean(engine, capsys):
    """Its context, its shapes and its axioms are applied, and it keeps them."""
    assert codes(SAMPLE, capsys, engine) == set()
    assert main([str(SAMPLE), "--trust"]) == 0


@pytest.mark.parametrize(
    ("fault", "engine"),
    [
        *((fault, "oxigraph") for fault in FAULTS),
        *(pytest.param(FAULTS[n], "pyshacl", marks=pytest.mark.oracle) for n in (0, -1)),
    ],
)
def test_a_broken_variant_is_found(model, fault, engine, capsys):
    """By the vendor's shape, or by a rule that holds because of the vendor's axioms."""
    right, wrong, expected = fault
    file = model / "tool.jsonld"
    text = file.read_text("utf-8")
    assert text.count(right) == 1
    file.write_text(text.replace(right, wrong), "utf-8")

    assert expected <= codes(model, capsys, engine)


def test_without_the_configuration_the_model_says_too_little(capsys):
    """The context is not fetched: that is an error, not a silent loss."""
    main([str(SAMPLE), "--isolated", "--output-format", "concise"])

    assert "LD014" in capsys.readouterr().out


def test_the_vendors_file_is_no_fault_itself(capsys):
    """Linted like a model, shapes and axioms have no finding."""
    assert codes(SAMPLE / "vector-list.ttl", capsys) == set()


@pytest.mark.parametrize(
    ("language", "name"),
    [("json", "vector-list.json"), ("turtle", "vector-list.ttl"), ("toml", "kinlint.toml")],
)
def test_contributing_shows_the_sample(language, name):
    """What CONTRIBUTING shows are the files that these tests run."""
    text = (ROOT / "CONTRIBUTING.md").read_text("utf-8")
    section = text.split("## Extend the metamodels", 1)[1].split("\n## ", 1)[0]
    shown = [dedent(body) for _, tongue, body in FENCE.findall(section) if tongue == language]

    assert len(shown) == 1
    assert (SAMPLE / name).read_text("utf-8").endswith(shown[0])
