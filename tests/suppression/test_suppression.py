"""What silences a finding: statements in models, and configuration."""

from dataclasses import replace

import pytest
from suppressing import ARM, DROPPED, LEG, UNIT, applied, document, finding, kl, noted, told

from kinlint.configuration.settings import Choice, FileSettings, Ignore
from kinlint.terms import iri, literal
from kinlint.text import SourceText, Span
from kinlint.vocabulary import KL, RULE, SRC


@pytest.mark.parametrize(
    "value",
    [
        literal("UNI001"),
        literal("missing-unit"),
        literal("UNI"),
        literal("AP5"),
        literal("ALL"),
        iri(f"{RULE}missing-unit"),
        iri(f"{KL}UNI001"),
        iri(f"{KL}AP5"),
    ],
)
def test_a_statement_on_a_node_silences_findings_about_it(value):
    """However it names the rule; findings about other nodes stay."""
    outcome = applied([finding(UNIT), finding(UNIT, LEG)], [document((ARM, kl("ignore"), value))])

    assert told(outcome) == ["-UNI001", "UNI001"]
    assert outcome[0].suppressed == "kl:ignore at arm.jsonld:1"


def test_other_rules_stay():
    """Only the rules that are named are silent."""
    outcome = applied(
        [finding(UNIT), finding(DROPPED)], [document((ARM, kl("ignore"), literal("UNI")))]
    )

    assert told(outcome) == ["-UNI001", "LD001"]


def test_a_statement_in_one_file_silences_findings_in_another():
    """The node is the same wherever something is said of it."""
    outcome = applied(
        [finding(UNIT, name="other.jsonld")], [document((ARM, kl("ignore"), literal("UNI001")))]
    )

    assert told(outcome) == ["-UNI001"]


def test_a_loss_is_about_the_node_that_lost_something():
    """`src:node` leads from what the source layer states to the node."""
    loss = "_:loss"
    given = document((ARM, kl("ignore"), literal("LD001")), (loss, iri(f"{SRC}node"), ARM))

    assert told(applied([finding(DROPPED, loss)], [given])) == ["-LD001"]


def test_a_statement_on_the_name_of_the_graph_covers_the_file():
    """All nodes in this file, no others."""
    graph = iri("https://example.org/skeleton")
    given = document(
        ("_:g", iri("http://www.w3.org/1999/02/22-rdf-syntax-ns#type"), iri(f"{SRC}NamedGraph")),
        ("_:g", iri(f"{SRC}name"), graph),
        (graph, kl("ignore"), literal("UNI001")),
    )
    found = [finding(UNIT), finding(UNIT, LEG), finding(UNIT, LEG, "leg.jsonld")]

    assert told(applied(found, [given])) == ["-UNI001", "-UNI001", "UNI001"]


def test_a_name_that_is_stated_of_something_else_is_no_graph():
    """A document has a `src:name`, too."""
    given = document(
        ("_:d", iri(f"{SRC}name"), ARM),
        (ARM, kl("ignore"), literal("UNI001")),
    )

    assert told(applied([finding(UNIT, LEG)], [given])) == ["UNI001", "LNT001"]


def test_a_reason_is_what_the_finding_is_excused_with():
    """A node with `kl:rule` and `kl:reason`."""
    outcome = applied([finding(UNIT)], [noted(("reason", "a toy"))])

    assert [one.suppressed for one in outcome] == ["a toy"]


def test_a_reason_may_stand_on_the_iri_of_the_rule():
    """`{"@id": "kl:UNI001", "kl:reason": "…"}`."""
    given = document(
        (ARM, kl("ignore"), kl("UNI001")), (kl("UNI001"), kl("reason"), literal("a toy"))
    )

    assert [one.suppressed for one in applied([finding(UNIT)], [given])] == ["a toy"]


def test_one_note_may_name_several_rules():
    """Each is used or unused by itself."""
    given = document(
        (ARM, kl("ignore"), "_:n"),
        ("_:n", kl("rule"), literal("UNI001")),
        ("_:n", kl("rule"), literal("LD001")),
    )
    outcome = applied([finding(UNIT)], [given])

    assert told(outcome) == ["-UNI001", "LNT001"]
    assert outcome[1].location.span == Span(2, 3)


def test_suppressions_can_be_ignored():
    """`--ignore-suppressions`: everything is reported, and nothing of them."""
    given = document((ARM, kl("ignore"), literal("UNI001")), (ARM, kl("ignore"), literal("ZZZ")))

    assert told(applied([finding(UNIT)], [given], ignore_suppressions=True)) == ["UNI001"]


def _configured(**place):
    return FileSettings(ignores=(Ignore(("UNI",), "the key", "kinlint.toml", **place),))


def test_configuration_silences_a_file():
    """`per-file-ignores`, which the settings of the file hold."""
    found = [finding(UNIT), finding(DROPPED), finding(UNIT, name="leg.jsonld")]
    outcome = applied(found, [], files={"arm.jsonld": _configured()})

    assert told(outcome) == ["-UNI001", "LD001", "UNI001"]
    assert outcome[0].suppressed == "ignored by kinlint.toml: the key"


def test_configuration_silences_an_entity():
    """By its IRI."""
    default = _configured(iri="https://example.org/arm")

    assert told(applied([finding(UNIT), finding(UNIT, LEG)], [], default=default)) == [
        "-UNI001",
        "UNI001",
    ]


def test_configuration_silences_what_lies_below_a_pointer():
    """A finding lies there if all of its place does."""
    text = '{"a": [1, {"b": 2}], "c": 3}'
    default = _configured(pointer="/a/1")
    two, three = text.index("2"), text.index("3")
    places = [Span(two, two + 1), Span(three, three + 1), Span(0, len(text))]
    found = [finding(UNIT, text=text, span=span) for span in places]

    assert told(applied(found, [], default=default)) == ["-UNI001", "UNI001", "UNI001"]


@pytest.mark.parametrize("text", ["# no JSON", "{}"])
def test_a_pointer_to_nowhere_silences_nothing(text):
    """Other files match the same pattern and are made otherwise."""
    found = [finding(UNIT, text=text, span=Span(0, 1))]

    assert told(applied(found, [], default=_configured(pointer="/a/1"))) == ["UNI001"]


def test_the_reason_in_the_model_comes_before_configuration():
    """What is silenced twice keeps the first excuse."""
    outcome = applied([finding(UNIT)], [noted(("reason", "a toy"))], default=_configured())

    assert [one.suppressed for one in outcome] == ["a toy"]


def test_findings_are_kept_as_they_are():
    """Silencing adds why, and changes nothing else."""
    one = finding(UNIT)
    outcome = applied([one], [document((ARM, kl("ignore"), literal("UNI001")))])

    assert replace(outcome[0], suppressed=None) == one


CONFIG = SourceText("kinlint.toml", 'per-file-ignores = {"the key" = ["UNI", "LD"]}')


def _placed(**place):
    """An entry of a configuration file, about two families of rules."""
    entry = Ignore(("UNI", "LD"), "the key", "kinlint.toml", place=(CONFIG, Span(20, 29)), **place)
    return FileSettings(ignores=(entry,))


@pytest.mark.parametrize("place", [{"iri": ARM[1:-1]}, {"pointer": "/a"}])
def test_what_configuration_silences_in_vain_is_reported(place):
    """Where it says so, for each selector that silenced nothing."""
    text = '{"a": "01234567890"}'
    found = [finding(UNIT, text=text, span=Span(7, 9))]
    outcome = applied(found, [document(text=text)], default=_placed(**place))

    assert told(outcome) == ["-UNI001", "LNT001"]
    assert outcome[1].message == "The suppression of 'LD' for 'the key' silences nothing."
    assert outcome[1].location.source[outcome[1].location.span] == '"the key"'
    assert outcome[1].location.source.name == "kinlint.toml"


def test_what_configuration_silences_in_files_need_not_be_in_all():
    """Nor anything if only a part was read, if the rules did not speak, or without a file."""
    entity = {"iri": ARM[1:-1]}
    silent = replace(_placed(**entity), choices=(Choice(ignore=("UNI", "LD")),))
    given = [document()]

    assert told(applied([], given, default=_placed(**entity))) == ["LNT001", "LNT001"]
    assert told(applied([], given, default=_placed())) == []
    assert told(applied([], given, default=_placed(**entity), partial=True)) == []
    assert told(applied([], given, default=_placed(**entity), complete=False)) == []
    assert told(applied([], given, default=silent)) == []
    assert told(applied([], given, default=_configured(**entity))) == []
    assert told(applied([], given, files={"leg.jsonld": _placed(**entity)})) == []
