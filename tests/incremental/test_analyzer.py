"""An incremental examination answers what one from the beginning does."""

from __future__ import annotations

from pathlib import Path

import pytest
from data import locate_data
from incremental.answers import agree, answer
from incremental.random_edits import versions
from support import linting

from kinlint import lint
from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.settings import Choice, FileSettings, Ignore, Settings
from kinlint.pipeline.analyzer import Analyzer, Cancelled
from kinlint.text import SourceText, Span

pytestmark = pytest.mark.slow

ROOT = Path(__file__).resolve().parents[2]
SAMPLES = sorted(
    file
    for file in (ROOT / "samples").glob("*/*")
    if file.suffix in {".jsonld", ".urdf", ".sdf", ".srdf", ".xacro", ".ttl", ".json"}
)
FEW = SAMPLES[::6]
STEPS = 5
DEEP = 8

ARM = """{
  "@context": ["https://w3id.org/kinlint/composable.json", {"ex": "https://example.org/arm#"}],
  "@graph": [
    { "@id": "ex:base", "@type": "Frame" },
    { "@id": "ex:tool", "@type": "Frame" },
    { "@id": "ex:pose", "@type": "Pose", "of": "ex:tool", "with-respect-to": "ex:base" },
    { "@id": "ex:pose-coord", "@type": ["PoseCoordinate", "VectorXYZ"], "of": "ex:pose",
      "as-seen-by": "ex:base", "unit": "M", "x": 0.1, "y": 0.2, "z": 0.3 }
  ]
}"""


@pytest.fixture(scope="module")
def book() -> Rulebook:
    return linting.book()


@pytest.mark.parametrize("file", FEW, ids=lambda file: f"{file.parent.name}/{file.name}")
def test_edits_of_samples(file, book):
    """Whatever somebody does to a sample, the answer is that of a run from the beginning."""
    settings, name = Settings(), str(file)
    incremental = Analyzer(settings, book, repeated=True)
    number = SAMPLES.index(file)
    other = SAMPLES[(number + 1) % len(SAMPLES)].read_text("utf-8")
    for text in versions(file.read_text("utf-8"), [other], number, STEPS):
        agree(incremental, [SourceText(name, text)], settings, book)


@pytest.mark.parametrize("turn", range(6))
@pytest.mark.parametrize("form", ["jsonld", "urdf", "sdf"])
def test_edits_of_real_files(form, turn, book):
    """The same of files that others wrote, together with a second one, and with repairs."""
    folder = locate_data() if form == "jsonld" else locate_data("robots")
    files = sorted(each for each in folder.rglob(f"*.{form}") if each.stat().st_size < 30_000)
    file, beside = (files[(turn * 37 + step) % len(files)] for step in (0, 11))
    settings = Settings()
    incremental = Analyzer(settings, book, repeated=True)
    second = SourceText(str(beside), beside.read_text("utf-8", "replace"))
    for text in versions(file.read_text("utf-8", "replace"), [], turn, DEEP):
        sources = [SourceText(str(file), text), second] if file != beside else [second]
        agree(incremental, sources, settings, book, repairing=turn % 2 == 1)


def test_what_is_broken_and_mended(book):
    """While a file cannot be read nothing is found in it, and afterwards all that was before."""
    settings = Settings()
    incremental = Analyzer(settings, book, repeated=True)
    for text in (ARM, ARM.replace('"x": 0.1', '"x": 0.'), ARM.replace(": 0.1", ": 0.11"), ARM):
        agree(incremental, [SourceText("arm.jsonld", text)], settings, book)


def test_files_that_come_and_go(book):
    """Files may be added, may be companions, and may leave."""
    settings = Settings()
    incremental = Analyzer(settings, book, repeated=True)
    arm, base = SourceText("arm.jsonld", ARM), SourceText("b.jsonld", ARM.replace("tool", "hand"))
    companion = SourceText("b.jsonld", base.text, companion=True)
    for sources in ([arm], [arm, base], [base, arm], [arm, companion], [], [base], [arm, arm]):
        agree(incremental, sources, settings, book)


def test_the_same_number_spelled_twice(book):
    """Two spellings of one number are one statement: what is left of them still is said."""
    settings = Settings()
    incremental = Analyzer(settings, book, repeated=True)
    for numbers in ("0.1", "[0.1, 0.10]", "0.10", "[1.0e-1, 0.1]", "[0.1, 0.2]"):
        text = ARM.replace('"x": 0.1', f'"x": {numbers}')
        agree(incremental, [SourceText("arm.jsonld", text)], settings, book)


def test_words_that_are_new(book):
    """Rules that a new word brings into play are asked, too; what was lifted stays as it is."""
    settings = Settings()
    incremental = Analyzer(settings, book, trying=True)
    model = """<mujoco><compiler{}/><worldbody><body name="arm" euler="0 0 1">
        <joint name="turn" {}/><geom size="1" mass="1"/></body></worldbody></mujoco>"""
    stores = set()
    for words in (("", ""), (' eulerseq="xyy"', ""), (' eulerseq="zzz"', 'axis="0 0 0"')):
        texts = [SourceText("arm.xml", model.format(*words))]
        agree(incremental, texts, settings, book)
        stores.add(id(incremental.examine(texts).store))
    assert len(stores) == 1


def test_only_the_order_changes(book):
    """What is listed first is told first, even if nothing else is said than before."""
    settings = Settings()
    incremental = Analyzer(settings, book, repeated=True)
    text = (ROOT / "samples/broken/disconnected-chain.jsonld").read_text("utf-8")
    lines = text.splitlines(keepends=True)
    for turned in (lines, lines[:3] + lines[3:-2][::-1] + lines[-2:], lines):
        agree(incremental, [SourceText("chain.jsonld", "".join(turned))], settings, book)


def test_settings_count(book):
    """Selection, ignores and partial models are as in a run from the beginning."""
    place = (SourceText("kinlint.toml", "x"), Span(0, 1))
    ignore = Ignore(("FRM",), "x", "kinlint.toml", iri="https://example.org/arm#pose", place=place)
    own = FileSettings(choices=(Choice(select=("ALL",), ignore=("UNI",)),), ignores=(ignore,))
    for settings in (Settings(default=own), Settings(default=own, partial=True)):
        incremental = Analyzer(settings, book, repeated=True)
        for text in (ARM, ARM.replace("ex:pose-coord", "ex:coord"), ARM.replace("ex:tool", "ex:t")):
            agree(incremental, [SourceText("arm.jsonld", text)], settings, book)


@pytest.mark.parametrize("patience", [0, 1, 2, 5, 12])
def test_cancelled(patience, book):
    """Given up at any point, it goes on from there and answers the same."""
    settings = Settings()
    incremental = Analyzer(settings, book, repeated=True)
    texts = [ARM, ARM.replace("0.1", "0.4"), ARM.replace('"M"', '"RAD"'), ARM]
    for text in texts:
        left = iter(range(patience))
        source = SourceText("arm.jsonld", text)
        with pytest.raises(Cancelled):
            incremental.examine([source], cancelled=lambda left=left: next(left, None) is None)
    for text in texts:
        agree(incremental, [SourceText("arm.jsonld", text)], settings, book)


def test_engines_that_cannot_follow_answer_too(book):
    """pySHACL judges from the beginning each time."""
    settings = Settings(engine="pyshacl", default=FileSettings((Choice(select=("FRM",)),)))
    incremental = Analyzer(settings, book, repeated=True)
    source = SourceText("arm.jsonld", ARM)
    assert answer(incremental.examine([source])) == answer(
        lint.examine([source], [], settings, book)
    )
