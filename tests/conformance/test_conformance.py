"""What every format promises, tried for each record in `kinlint.formats.records`.

A new format is held to all of this by its record, its schema and the examples of its rules.
"""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from pathlib import Path

import pytest
from specimens import GOAL, KINDS, NOWHERE, ReferenceKind, examples, models
from support.linting import book, codes, document, source

from kinlint import lint as pipeline
from kinlint import resources
from kinlint.addresses import document_of
from kinlint.cli.main import main
from kinlint.configuration.settings import Settings
from kinlint.conversion.coverage import format_coverage
from kinlint.document import Document
from kinlint.engine.lifting import lift
from kinlint.engine.provenance import WORKED_OUT, Provenance, Trace, Written
from kinlint.engine.store import Store
from kinlint.errors import SourceError
from kinlint.file_format import Format
from kinlint.findings.locator import Locator
from kinlint.formats.recognition import recognise
from kinlint.formats.records import FORMATS, LIFTED
from kinlint.navigation.navigator import Navigator
from kinlint.pipeline.analyzer import Analyzer
from kinlint.terms import NUMERIC, Triple, is_blank, literal_datatype, literal_value

WRITTEN = [each for each in FORMATS if each.editor is not None]
formats = pytest.mark.parametrize("form", FORMATS, ids=lambda each: each.name)
robots = pytest.mark.parametrize(
    "form", [each for each in LIFTED if each.describes_robots], ids=lambda each: each.name
)
lifted = pytest.mark.parametrize("form", LIFTED, ids=lambda each: each.name)
written = pytest.mark.parametrize("form", WRITTEN, ids=lambda each: each.name)
references = pytest.mark.parametrize("kind", KINDS, ids=str)


@written
def test_rules_have_examples_in_a_format_that_is_written(form: Format) -> None:
    """Good and bad ones; what follows is tried with them."""
    assert examples(form)
    assert examples(form, good=False)


@formats
def test_a_file_is_recognised_by_the_end_of_its_name(form: Format) -> None:
    """In any case of letters, whatever is in it."""
    for suffix in form.suffixes:
        text = next((text for _, text in examples(form)), "")
        assert recognise(f"robot{suffix.upper()}", text) in {form, *_same_suffix(form)}


def _same_suffix(form: Format) -> list[Format]:
    return [each for each in FORMATS if {*each.suffixes} & {*form.suffixes}]


@written
def test_a_file_is_recognised_by_its_content(form: Format) -> None:
    """Under a name that tells nothing; without a macro, one of macros is what they expand to."""
    names = {form.name, form.lifted_as}
    found = {recognise("robot", text) for _, text in examples(form)}

    assert form in found
    assert {each.name for each in found if each is not None} <= names


@lifted
def test_what_is_not_lifted_has_a_reason(form: Format) -> None:
    """Each element and each attribute of the schema."""
    known = format_coverage(form.name)

    assert [each for each in known.unlifted() if known.reason(*each) is None] == []


@lifted
def test_each_reason_is_needed(form: Format) -> None:
    """What has come to be lifted since has none."""
    known = format_coverage(form.name)
    used = {known.reason(*each) for each in known.unlifted()}

    assert [one for one in known.reasons if one.lifted == "no" and one not in used] == []


@pytest.mark.slow
@lifted
def test_a_lifted_number_is_at_its_place(form: Format) -> None:
    """Read there, it is that number, or its negative."""
    seen = 0
    for triple, trace in _traces(form):
        if trace.sign and len(trace.written) == 1:
            (value,) = map(_number_there, trace.written)
            assert value * trace.sign == float(literal_value(triple[2])), triple
            seen += 1
    assert seen


@pytest.mark.slow
@robots
def test_a_computed_number_leads_to_all_that_it_was_computed_from(form: Format) -> None:
    """Each source is a number or words that the file says there, and none comes twice."""
    worked_out = (resources.data("shapes") / WORKED_OUT).read_text("utf-8")
    sources = several = 0
    for triple, trace in _traces(form):
        sources += len(trace.written)
        for written in trace.written:
            assert _says(written), (triple, written.triple)
        assert len({written.triple for written in trace.written}) == len(trace.written)
        several += len(trace.written) > 1
    assert sources
    assert several or f"\n{form.name}\t" not in worked_out


@pytest.mark.slow
@lifted
def test_what_is_made_of_an_element_is_where_that_is(form: Format) -> None:
    """Also a number that is written nowhere, since the element leaves it out."""
    seen = 0
    for model in models(form):
        store = _lifted(model)
        locator = Locator(model, store)
        for subject, _, _ in _numbers(store, form):
            assert is_blank(subject) or locator.node(subject) is not None, subject
            seen += 1
    assert seen


def _lifted(model: Sequence[Document]) -> Store:
    store = Store()
    store.load(model)
    lift(store)
    return store


def _traces(form: Format) -> Iterator[tuple[Triple, Trace]]:
    """Yield the numbers that are lifted of the examples of *form*, and what they were made of."""
    for model in models(form):
        store = _lifted(model)
        provenance = Provenance(store)
        for triple in _numbers(store, form):
            yield triple, provenance.trace(triple)


def _numbers(store: Store, form: Format) -> list[Triple]:
    """Return the triples with numbers that were lifted of files of *form*."""
    query = "SELECT ?s ?p ?o WHERE { ?s ?p ?o FILTER (isNumeric(?o)) }"
    own = {graph for graph, each in store.documents.items() if each.format.lifted_as == form.name}
    rows = ((row["s"], row["p"], row["o"]) for row in store.rows(query))
    return [
        row
        for row in rows
        if store.is_lifted(row) and (is_blank(row[0]) or document_of(row[0]) in own)
    ]


def _text_there(written: Written) -> str:
    location = written.document.location(written.document.map.triples[written.triple])
    return location.source[location.span]


def _number_there(written: Written) -> float:
    return float(_text_there(written))


def _says(written: Written) -> bool:
    """Tell whether the text at the place of a triple is the value of that triple."""
    text, value = _text_there(written), written.triple[2]
    if literal_datatype(value) in NUMERIC:
        return float(text) == float(literal_value(value))
    return text.strip("\"' \n") == literal_value(value).strip()


@references
def test_a_reference_leads_to_what_it_names(kind: ReferenceKind, tmp_path: Path) -> None:
    """In the text, and for who asks for the definition or hovers."""
    files = kind.texts()
    paths = {name: str(tmp_path / name) for name in files}
    sources = [source(text, paths[name]) for name, text in files.items()]
    examination = Analyzer(Settings(), book(), repeated=True).examine(sources)
    navigator = Navigator(examination, book(), {})
    name, offset = kind.place()

    places = navigator.definitions(paths[name], offset)
    shown = navigator.hover(paths[name], offset)

    assert [each.source.text[each.span.start : each.span.end].strip("\"'") for each in places] == [
        GOAL
    ]
    assert shown is not None
    assert shown.markdown


@references
def test_a_reference_to_nothing_dangles(kind: ReferenceKind) -> None:
    """It leads to nothing that is there."""
    sources = [source(text, name) for name, text in kind.texts(NOWHERE).items()]
    model, *_ = pipeline.examine(sources, [], Settings(), book()).documents
    there = {subject for subject, _, _ in model.statements}
    carriers = {s for s, _, o in model.statements if o == f'"{NOWHERE}"'}

    assert carriers
    for subject, predicate, end in model.statements:
        if predicate == kind.reference.predicate and (subject in carriers or NOWHERE in end):
            assert end not in there


def _changed(form: Format, folder: Path, *words: str) -> tuple[str, str, Path]:
    """Return the first example in which a command changes what it is asked for, and the code.

    The file has the text that the command left.
    """
    file = folder / f"arm{form.suffixes[0]}"
    for rule, text in examples(form, good=False):
        if rule.optional or rule.targets or ("--fix" in words and not rule.repairs):
            continue
        if codes(text, file.name).count(rule.code) != 1:
            continue
        file.write_text(text, "utf-8")
        main([str(file), "--isolated", "--select", rule.code, "-q", *words])
        if file.read_text("utf-8") != text:
            return rule.code, text, file
    raise AssertionError(words)


@pytest.mark.slow
@written
def test_a_suppression_silences_what_it_is_written_for(form: Format, tmp_path, rules_cache) -> None:
    """And the file has the same findings as before otherwise."""
    code, text, file = _changed(form, tmp_path, "--add-ignore", "known")
    before, after = codes(text, file.name), codes(file.read_text("utf-8"), file.name)

    assert after == [each for each in before if each != code]


@pytest.mark.slow
@written
def test_a_fix_mends_and_is_made_once(form: Format, tmp_path, rules_cache) -> None:
    """The finding goes, and a second time there is nothing to change."""
    words = ("--fix", "--unsafe-fixes")
    code, _, file = _changed(form, tmp_path, *words)
    once = file.read_text("utf-8")
    main([str(file), "--isolated", "--select", code, "-q", *words])

    assert code not in codes(once, file.name)
    assert file.read_text("utf-8") == once


HOSTILE = {
    "nothing": lambda _: b"",
    "a byte": lambda _: b"\xff",
    "zeros": lambda _: b"\0" * 1_000,
    "half": lambda data: data[: len(data) // 2],
    "twice": lambda data: data * 2,
    "no UTF-8": lambda data: data[:40] + b"\xc3\x28" + data[40:],
    "another encoding": lambda data: data.decode().encode("utf-16"),
    "a long line": lambda data: data.replace(b"\n", b" ") + b" " * 100_000,
    "shuffled": lambda data: bytes(random.Random(1).sample(data, len(data))),  # noqa: S311
    "deep": lambda _: b"<a>" * 10_000,
    "deep JSON": lambda _: b"[" * 100_000,
}


@formats
@pytest.mark.parametrize("kind", HOSTILE)
def test_a_hostile_file_is_read_or_refused(form: Format, kind: str) -> None:
    """With a document, or an error that names the file and says why."""
    text = next((text for _, text in examples(form)), "<a:b> <a:c> <a:d> .\n")
    cause, read = "", None
    try:
        read = document(HOSTILE[kind](text.encode()), f"arm{form.suffixes[0]}")
    except SourceError as refused:
        cause = refused.cause
    assert bool(cause) is (read is None)
