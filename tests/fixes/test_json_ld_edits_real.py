"""Random changes of real models and of the samples."""

from __future__ import annotations

import random
from pathlib import Path

import pytest
from data import locate_data
from editing_json_ld import OPTIONS, canonical, changed, check_edits, domain
from random_triples import Changer

from kinlint.edits import NotExpressible, applied
from kinlint.errors import SourceError
from kinlint.formats.jsonld.editing.editor import Editor
from kinlint.formats.jsonld.reader import read
from kinlint.text import SourceText

pytestmark = pytest.mark.corpus

SAMPLES = Path(__file__).parents[2] / "samples"


def check(path: Path, count: int) -> tuple[int, int]:
    """How many of *count* changes could be written, each checked, and how many could not."""
    text = path.read_text(encoding="utf-8")
    try:
        before = read(SourceText(path.name, text), OPTIONS)
    except SourceError:
        return 0, 0
    editor, chance, said, not_said = Editor(before, OPTIONS), random.Random(path.name), 0, 0  # noqa: S311
    triples = domain(before)
    for _ in range(count):
        delta = Changer(triples, chance).delta()
        try:
            edits = editor.edits(delta)
        except NotExpressible:
            not_said += 1
            continue
        check_edits(text, edits)
        after = applied(text, edits)
        now = domain(read(SourceText(path.name, after), OPTIONS))
        assert canonical(now) == canonical(changed(triples, delta)), (path, delta)
        said += 1
    return said, not_said


def all_of(paths: list[Path], count: int) -> float:
    """The share of changes that could be written."""
    found = [check(path, count) for path in paths]
    said, not_said = (sum(numbers) for numbers in zip(*found, strict=True))
    return said / (said + not_said)


@pytest.mark.parametrize("kind", ["one-dof", "seven-axis", "delta", "algorithms", "broken"])
def test_most_changes_of_the_samples_can_be_written(kind: str) -> None:
    assert all_of(sorted((SAMPLES / kind).rglob("*.jsonld")), 2) > 0.6


def test_most_changes_of_real_models_can_be_written() -> None:
    top = locate_data("comp-rob2b")
    metamodels = top / "metamodels"
    models = [path for path in top.rglob("*.json") if not path.is_relative_to(metamodels)]
    assert all_of(sorted(models), 2) > 0.6


def test_what_is_written_into_the_documents_of_the_test_suite_is_what_was_to_be_said() -> None:
    suite = locate_data("w3c", "json-ld-tests", "toRdf")
    # The oracle cannot read control characters, which some of these have.
    documents = [path for path in suite.glob("*-in.jsonld") if not path.name.startswith("nt")]
    assert all_of(sorted(documents), 1) > 0.5
