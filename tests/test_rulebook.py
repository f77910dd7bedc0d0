"""The catalogue is compiled once, kept, and told apart by what it was compiled from."""

import json
from pathlib import Path

import pytest

from kinlint import rulebook
from kinlint.errors import RuleInvalid

RULE = Path(__file__).parents[1] / "rules/units/missing-unit.ttl"

SHAPE = """
@prefix ex: <https://example.org/shapes#> .
@prefix sh: <http://www.w3.org/ns/shacl#> .
ex:NamedJoint a sh:NodeShape ;
    sh:targetClass ex:Joint ; sh:nodeKind sh:IRI ; sh:severity sh:Warning .
"""


@pytest.fixture(autouse=True)
def _unshipped(monkeypatch, tmp_path):
    """As in a checkout: no catalogue comes compiled with the program."""
    monkeypatch.setattr(rulebook, "SHIPPED", tmp_path / "nowhere")


def renamed(directory, code, name):
    """A copy of a rule under another *code* and *name*."""
    text = RULE.read_text().replace("UNI001", code).replace("missing-unit", name)
    file = directory / f"{name}.ttl"
    file.write_text(text.replace("<> owl:imports <../../shapes/prefixes.ttl> .", ""))
    return file


def test_a_kept_catalogue_equals_a_compiled_one(tmp_path):
    """Reviving from the cache loses nothing."""
    compiled = rulebook.load(cache=tmp_path)
    revived = rulebook.load(cache=tmp_path)

    assert len(list(tmp_path.iterdir())) == 1
    assert revived == compiled == rulebook.load()


def test_a_damaged_cache_is_compiled_anew(tmp_path):
    """A file cut short by a crash is not believed."""
    rulebook.load(cache=tmp_path)
    (stored,) = tmp_path.iterdir()
    stored.write_text(stored.read_text()[:100])

    assert rulebook.load(cache=tmp_path).by_code["UNI001"].name == "missing-unit"
    assert json.loads(stored.read_text())


def test_a_cache_that_cannot_be_written_is_done_without(tmp_path):
    """A file where the cache directory should be costs time, not the run."""
    occupied = tmp_path / "cache"
    occupied.write_text("")

    assert rulebook.load(cache=occupied).rules


def test_a_cache_does_not_grow_for_ever(tmp_path):
    """Catalogues of other rules are dropped, the oldest first."""
    for number in range(rulebook.KEPT + 2):
        (tmp_path / f"catalogue-{number}.json").write_text("{}")
    rulebook.load(cache=tmp_path)

    assert len(list(tmp_path.iterdir())) == rulebook.KEPT


def test_users_add_rules(tmp_path):
    """A directory of rule files adds to the catalogue."""
    renamed(tmp_path, "ACME001", "unit-left-out")

    assert rulebook.load([tmp_path]).by_code["ACME001"].name == "unit-left-out"


def test_a_built_in_rule_given_again_is_the_same_rule(tmp_path):
    """A copy of a built-in rule stands for it instead of clashing with it."""
    copy = tmp_path / RULE.name
    copy.write_bytes(RULE.read_bytes())
    book = rulebook.load([tmp_path])

    assert book.by_code["UNI001"].path == str(copy)
    assert len(book.rules) == len(rulebook.load([RULE]).rules) == len(rulebook.load().rules)


def test_shapes_without_a_rule_get_one(tmp_path):
    """A user's shape is reported under a code of its own, with the shape's severity."""
    file = tmp_path / "shapes.ttl"
    file.write_text(SHAPE)
    rule = rulebook.load(shapes=[file]).by_code["SHACL001"]

    assert (rule.name, rule.severity.label) == ("named-joint", "warning")


@pytest.mark.parametrize(
    ("code", "name", "cause"),
    [
        ("UNI001", "unit-left-out", "UNI001 is taken by"),
        ("ACME001", "missing-unit", "missing-unit is taken by"),
    ],
)
def test_rules_do_not_share_codes_and_names(tmp_path, code, name, cause):
    """Two rules of one code or name could not be told apart by selectors."""
    renamed(tmp_path, code, name)

    with pytest.raises(RuleInvalid, match=cause):
        rulebook.load([tmp_path])


KL = "@prefix kl: <https://w3id.org/kinlint/ns#> . "
ONE = 'kl:a a kl:Rule ; kl:code "A001" . '
TWO = 'kl:b a kl:Rule ; kl:code "B001" . '
OTHER = '<https://example.org/other> a kl:Rule ; kl:code "A001" . '


@pytest.mark.parametrize(
    ("text", "cause"),
    [
        (KL[:30], "wrong.ttl:1"),
        (KL + "kl:a a kl:Rule .", "has no kl:code"),
        (KL + ONE + TWO, "2 rules in one file"),
        (KL + OTHER, "its file must be other.ttl"),
    ],
)
def test_a_wrong_rule_file_is_refused_with_its_cause(tmp_path, text, cause):
    """The message names the file and what is wrong with it."""
    file = tmp_path / "wrong.ttl"
    file.write_text(text)

    with pytest.raises(RuleInvalid, match=cause):
        rulebook.load([file])


def test_a_missing_rule_directory_is_named(tmp_path):
    """A mistyped path is no empty directory."""
    with pytest.raises(RuleInvalid, match="no such rule or shapes file"):
        rulebook.load([tmp_path / "nowhere"])
