"""Both engines find the same in models that nobody wrote, and what they find can be shown."""

from __future__ import annotations

import json
from collections import Counter
from contextlib import suppress
from functools import cache

import pytest
import xml_mutations
from model_mutations import mutant, values
from support.linting import book, document
from test_engines_agree import BROKEN, CHECKOUT, ONTOLOGY, SHAPES, UNITS, closed, reported

from kinlint import resources
from kinlint.configuration.settings import Settings
from kinlint.engine.compiler.shapes_compiler import compile_shapes
from kinlint.engine.evaluate import check
from kinlint.engine.reference.shacl import check_store
from kinlint.errors import SourceError
from kinlint.findings.finding_builder import findings
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import decode, read

pytestmark = pytest.mark.oracle

TRIES = 8
RULES = {file.stem: file for file in sorted(resources.data("rules").rglob("*.ttl"))}

XML = sorted(
    file
    for suffix in ("urdf", "xacro", "srdf", "sdf")
    for file in (CHECKOUT / "samples" / "broken").glob(f"*.{suffix}")
    if file.stem in RULES
)


@cache
def pool():
    return values([json.loads(file.read_text()) for file in BROKEN])


def mutants(file):
    """Some mutants of a sample that can be read, always the same."""
    for seed in range(TRIES):
        text, _ = mutant(file.read_text(), pool(), f"{file.stem} {seed}")
        with suppress(SourceError):
            source = decode("mutant.jsonld", text.encode("utf-8", "surrogatepass"))
            yield read(source, ReadOptions.from_settings(Settings()))


def found(results):
    """What matters of *results*; which of two constraints that say the same found it does not."""
    counted = Counter()
    for (constraint, *rest), count in reported(results).items():
        counted[constraint.owner, constraint.messages, *rest] += count
    return counted


@pytest.mark.parametrize("file", BROKEN, ids=lambda file: file.stem)
def test_both_engines_find_the_same_in_a_mutant(file):
    """By the rule that the sample is of, which the first mutant that is tried still breaks."""
    shapes = [SHAPES / "prefixes.ttl", RULES[file.stem]]
    rule = compile_shapes(shapes)
    for model in mutants(file):
        store = closed([model], [*ONTOLOGY, *UNITS])
        results = list(check(store, rule))
        if results:
            break

    assert results, "no mutant breaks the rule"
    assert found(results) == found(check_store(store, shapes, rule))
    told = findings(results, [model], store, book())
    assert all(each.location.span.end > 0 for each in told)
    assert max(Counter((each.location.span, each.message) for each in told).values()) == 1


def broken_trees(file):
    """*file* as it is and a mutant of it if that can be read, always the same."""
    for seed in range(2):
        text = file.read_text()
        text = xml_mutations.mutant(text, f"{file.stem} {seed}") if seed else text
        with suppress(SourceError):
            yield document(text.encode(), str(file))


@pytest.mark.parametrize("file", XML, ids=lambda file: file.name)
def test_both_engines_find_the_same_in_a_mutant_of_a_tree(file):
    """By the rule that the sample is of; a single model, though the rule may speak of several."""
    shapes = [SHAPES / "prefixes.ttl", RULES[file.stem]]
    rule = compile_shapes(shapes)
    for model in broken_trees(file):
        store = closed([model], [*ONTOLOGY, *UNITS])
        results = list(check(store, rule))
        assert found(results) == found(check_store(store, shapes, rule))
        told = findings(results, [model], store, book())
        assert all(each.location.span.end > 0 for each in told)
