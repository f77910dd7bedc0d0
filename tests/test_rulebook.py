"""The catalogue is compiled once, kept, and told apart by what it was compiled from."""

from pathlib import Path

import pytest
from support.linting import findings

from kinlint.catalogue import rule_compiler, rulebook
from kinlint.catalogue.compiled_store import KEPT
from kinlint.engine import lifting
from kinlint.engine.compiler.shapes_compiler import compile_shapes
from kinlint.engine.store import Store
from kinlint.errors import RuleInvalid
from kinlint.formats.records import LIFTED

pytestmark = pytest.mark.xdist_group("rulebook")

RULE = Path(__file__).parents[1] / "rules/units/missing-unit.ttl"

SHAPE = """
@prefix ex: <https://example.org/shapes#> .
@prefix sh: <http://www.w3.org/ns/shacl#> .
ex:NamedJoint a sh:NodeShape ;
    sh:targetClass ex:Joint ; sh:nodeKind sh:IRI ; sh:severity sh:Warning .
"""


@pytest.fixture
def unshipped(monkeypatch, tmp_path):
    """As in a checkout: no catalogue comes compiled with the program."""
    monkeypatch.setattr(rulebook, "SHIPPED", tmp_path / "nowhere")


def renamed(directory, code, name):
    """A copy of a rule under another *code* and *name*."""
    text = RULE.read_text().replace("UNI001", code).replace("missing-unit", name)
    file = directory / f"{name}.ttl"
    file.write_text(text.replace("<> owl:imports <../../shapes/prefixes.ttl> .", ""))
    return file


@pytest.mark.slow
@pytest.mark.usefixtures("unshipped")
def test_a_kept_catalogue_equals_a_compiled_one(tmp_path):
    """Reviving from the cache loses nothing."""
    compiled = rulebook.load(cache=tmp_path)
    revived = rulebook.load(cache=tmp_path)

    assert len(list(tmp_path.glob("catalogue-*"))) == 1
    assert (compiled.recalled, revived.recalled) == (False, True)
    assert revived == compiled


@pytest.mark.slow
@pytest.mark.usefixtures("unshipped")
def test_a_kept_catalogue_has_the_lifting_queries(tmp_path, monkeypatch):
    """So that no query is parsed by who lints with it, and those are what files come to."""
    parsed = {form.name: lifting.queries(form.name) for form in LIFTED}
    rulebook.load(cache=tmp_path)
    monkeypatch.setattr(rulebook, "RECALLED", recalled := {})
    monkeypatch.setattr(lifting, "RECALLED", recalled)
    monkeypatch.setattr(lifting, "_compile", None)
    lifting.queries.cache_clear()
    rulebook.load(cache=tmp_path)

    for form, queries in parsed.items():
        found = lifting.queries(form)
        assert list(map(spelled, found)) == list(map(spelled, queries)) != []
    lifting.queries.cache_clear()


def spelled(query):
    """What *query* has, and what it stores."""
    return query.format, query.name, query.made, query.makes, query.where, query.update()


@pytest.fixture
def compiled(monkeypatch):
    """Which files were compiled, by name, in groups of those that were compiled together."""
    groups = []

    def compile_graph(graph):
        groups.append([Path(file.name).name for file in graph.files[1:]])
        return compile_one(graph)

    compile_one = rule_compiler.compile_graph
    monkeypatch.setattr(rule_compiler, "compile_graph", compile_graph)
    return groups


@pytest.mark.slow
def test_only_what_changed_is_compiled(tmp_path, compiled):
    """Of the rules that a cache has, those of another set of rules are taken."""
    file = renamed(tmp_path, "ACME001", "unit-left-out")
    assert not rulebook.load([file], cache=tmp_path / "cache").recalled
    file.write_text(file.read_text().replace("ACME001", "ACME002"))
    book = rulebook.load([file], cache=tmp_path / "cache")

    assert compiled == [[file.name]] * 2
    assert book == rulebook.load([file])
    assert rulebook.load([file], cache=tmp_path / "cache").recalled
    assert "ACME002" in book.by_code


RULE_PREFIX = "https://w3id.org/kinlint/rules/"
REFERRING = f"""
@prefix ex: <https://example.org/shapes#> .
@prefix sh: <http://www.w3.org/ns/shacl#> .
@prefix rule: <{RULE_PREFIX}> .
"""
OTHER_SHAPE = "ex:Long a sh:NodeShape ; sh:property [ sh:path ex:length ; sh:minInclusive 1 ] ."


@pytest.mark.slow
@pytest.mark.parametrize(
    ("first", "second", "together"),
    [
        ("ex:S sh:targetClass ex:Leg ; sh:node ex:Long .", OTHER_SHAPE, {"a.ttl", "b.ttl"}),
        ("ex:S sh:targetClass ex:Leg ; sh:not ( ex:Long ) .", OTHER_SHAPE, {"a.ttl", "b.ttl"}),
        (
            "ex:S sh:targetClass ex:Leg ; ex:least 1 .",
            "ex:C sh:parameter [ sh:path ex:least ] .",
            {"a.ttl", "b.ttl"},
        ),
        ("ex:S sh:targetClass ex:Leg .", "ex:S sh:nodeKind sh:IRI .", {"a.ttl", "b.ttl"}),
        (
            "ex:S a ex:Kind , sh:NodeShape .",
            "ex:Kind <http://www.w3.org/2000/01/rdf-schema#subClassOf> ex:Other .",
            {"a.ttl", "b.ttl"},
        ),
        ("ex:S sh:targetClass ex:Leg .", "ex:T sh:targetClass ex:Leg .", {"a.ttl"}),
        ("rule:missing-unit sh:deactivated true .", "", {"a.ttl", "missing-unit.ttl"}),
    ],
)
def test_files_that_refer_to_each_other_are_compiled_together(
    tmp_path, compiled, first, second, together
):
    """And mean what they mean together, whatever the cache has of each."""
    files = [tmp_path / "a.ttl", tmp_path / "b.ttl"]
    for file, text in zip(files, (first, second), strict=True):
        file.write_text(REFERRING + text)
    rulebook.load(shapes=files[1:], cache=tmp_path / "cache")
    compiled.clear()
    book = rulebook.load(shapes=files, cache=tmp_path / "cache")

    assert together in [set(group) for group in compiled]
    changed = {RULE_PREFIX + Path(name).stem for name in together}
    ours = {each for each in rulebook.load().constraints if each.owner not in changed}
    assert set(book.constraints) == ours | set(compile_shapes([book.shapes[0], *files]))


@pytest.mark.slow
def test_axioms_are_compiled_where_a_file_has_some(tmp_path, monkeypatch):
    """Rules that say nothing of the kind leave those of the ontology as they are."""
    asked = []
    monkeypatch.setattr(rule_compiler, "compile_axioms", lambda files: asked.append(files) or ())
    file = renamed(tmp_path, "ACME001", "unit-left-out")
    rulebook.load([file], cache=tmp_path / "cache")
    assert asked == []

    file.write_text(file.read_text() + RULE_WITH_AXIOM)
    rulebook.load([file], cache=tmp_path / "cache")
    assert [files[-1] for files in asked] == [file]


@pytest.mark.slow
def test_what_another_version_kept_is_passed_over(tmp_path):
    """Whatever it has in it."""
    (tmp_path / "catalogue-0.jsonl").write_text('{"rules": []}')
    file = renamed(tmp_path, "ACME001", "unit-left-out")

    assert "ACME001" in rulebook.load([file], cache=tmp_path).by_code


@pytest.mark.slow
def test_a_damaged_cache_is_compiled_anew(tmp_path):
    """A file cut short by a crash is not believed, nor one with a byte that has changed."""
    file = renamed(tmp_path, "ACME001", "unit-left-out")
    rulebook.load([file], cache=tmp_path)
    (stored,) = tmp_path.glob("catalogue-*")
    whole = stored.read_bytes()
    middle = len(whole) // 2
    for damaged in (whole[:100], whole[:-1], whole[:middle] + b"#" + whole[middle + 1 :]):
        stored.write_bytes(damaged)

        found = rulebook.load([file], cache=tmp_path).by_code
        assert found["ACME001"].name == "unit-left-out"
        assert stored.read_bytes() == whole


@pytest.mark.slow
def test_a_cache_that_cannot_be_written_is_done_without(tmp_path):
    """A file where the cache directory should be costs time, not the run."""
    occupied = tmp_path / "cache"
    occupied.write_text("")

    file = renamed(tmp_path, "ACME001", "unit-left-out")
    assert rulebook.load([file], cache=occupied).by_code["ACME001"]


@pytest.mark.slow
def test_a_cache_does_not_grow_for_ever(tmp_path):
    """Catalogues of other rules are dropped, the oldest first."""
    for number in range(KEPT + 2):
        (tmp_path / f"catalogue-{number}.jsonl").write_text("{}")
    rulebook.load([renamed(tmp_path, "ACME001", "unit-left-out")], cache=tmp_path)

    assert len(list(tmp_path.glob("catalogue-*"))) == KEPT


@pytest.mark.slow
def test_users_add_rules(tmp_path):
    """A directory of rule files adds to the catalogue."""
    renamed(tmp_path, "ACME001", "unit-left-out")

    assert rulebook.load([tmp_path]).by_code["ACME001"].name == "unit-left-out"


@pytest.mark.slow
def test_a_built_in_rule_given_again_is_the_same_rule(tmp_path):
    """A copy of a built-in rule stands for it instead of clashing with it."""
    copy = tmp_path / RULE.name
    copy.write_bytes(RULE.read_bytes())
    book = rulebook.load([tmp_path])

    assert book.by_code["UNI001"].path == str(copy)
    assert len(book.rules) == len(rulebook.load([RULE]).rules) == len(rulebook.load().rules)


@pytest.mark.slow
def test_shapes_without_a_rule_get_one(tmp_path):
    """A user's shape is reported under a code of its own, with the shape's severity."""
    file = tmp_path / "shapes.ttl"
    file.write_text(SHAPE)
    rule = rulebook.load(shapes=[file]).by_code["SHACL001"]

    assert (rule.name, rule.severity.label) == ("named-joint", "warning")


@pytest.mark.slow
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


@pytest.mark.slow
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


@pytest.mark.slow
@pytest.mark.usefixtures("unshipped")
def test_what_is_compiled_before_a_mistake_is_kept(tmp_path, compiled):
    """Whoever writes a rule waits for the built-in ones once."""
    file = tmp_path / "wrong.ttl"
    file.write_text(KL + "kl:a a kl:Rule .")
    for built_in in (True, False):
        compiled.clear()
        with pytest.raises(RuleInvalid, match=r"has no kl:code"):
            rulebook.load([file], cache=tmp_path / "cache")
        assert bool([names for names in compiled if names != [file.name]]) is built_in


def test_a_missing_rule_directory_is_named(tmp_path):
    """A mistyped path is no empty directory."""
    with pytest.raises(RuleInvalid, match="no such rule or shapes file"):
        rulebook.load([tmp_path / "nowhere"])


VENDOR = """
@prefix ex: <https://example.org/shapes#> .
@prefix owl: <http://www.w3.org/2002/07/owl#> .
@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
@prefix sh: <http://www.w3.org/ns/shacl#> .
<> owl:imports <https://example.org/never-fetched> .
ex:Servo rdfs:subClassOf [ owl:onProperty ex:drives ; owl:allValuesFrom ex:Driven ] .
ex:Driven rdfs:subClassOf ex:Moving ; ex:maker "ACME" .
ex:MovingShape a sh:NodeShape ; sh:targetClass ex:Moving ; sh:property [
    sh:path ex:speed ; sh:minCount 1 ; sh:message "What moves has a speed." ] .
"""

MODEL = """
@prefix ex: <https://example.org/shapes#> .
@prefix arm: <https://example.org/arm#> .
arm:servo a ex:Servo ;
    ex:drives arm:elbow , arm:wrist .
arm:elbow ex:speed 1 .
arm:wrist ex:weight 2 .
"""

RULE_WITH_AXIOM = """
@prefix kc: <https://comp-rob2b.github.io/metamodels/kinematic-chain/structural-entities#> .
@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
<https://example.org/shapes#Servo> rdfs:subClassOf kc:Joint .
"""


def found(book, text, engine="oxigraph", *, code="SHACL001"):
    """The lines at which the rule *code* complains about a Turtle model."""
    every = findings(text, "m.ttl", rules=book, engine=engine)
    return [(each.location.start.line, each.message) for each in every if each.rule.code == code]


@pytest.mark.slow
@pytest.mark.parametrize("engine", ["oxigraph", "pyshacl"])
def test_axioms_of_a_users_file_hold(tmp_path, engine):
    """A shape applies to what is of its class only by the axioms beside it, in both engines."""
    file = tmp_path / "vendor.ttl"
    file.write_text(VENDOR)
    book = rulebook.load(shapes=[file], cache=tmp_path)

    message = "'ex:speed' of 'arm:wrist': what moves has a speed (shape MovingShape)."
    assert found(book, MODEL, engine) == [(7, message)]
    assert rulebook.load(shapes=[file], cache=tmp_path) == book


@pytest.mark.slow
def test_a_users_file_is_data_for_queries(tmp_path):
    """What it says of its terms can be asked, once."""
    file = tmp_path / "vendor.ttl"
    file.write_text(VENDOR)
    book = rulebook.load(shapes=[file])
    store = Store()
    store.load_vocabulary(book.vocabulary)

    makers = 'SELECT ?x WHERE { ?x <https://example.org/shapes#maker> "ACME" }'
    assert [*store.rows(makers)] == [{"x": "<https://example.org/shapes#Driven>"}]


@pytest.mark.slow
def test_axioms_of_a_users_rule_file_hold(tmp_path):
    """They stand beside the rule, and concern the built-in rules as well."""
    file = renamed(tmp_path, "ACME001", "unit-left-out")
    file.write_text(file.read_text() + RULE_WITH_AXIOM)

    assert found(rulebook.load([file]), MODEL, code="TOP005")
    assert not found(rulebook.load(), MODEL, code="TOP005")


@pytest.mark.slow
def test_built_in_rules_are_no_vocabulary(tmp_path):
    """Neither those of the catalogue nor copies of them are loaded with each model."""
    copy = tmp_path / RULE.name
    copy.write_bytes(RULE.read_bytes())

    assert rulebook.load([copy]).vocabulary == rulebook.load().vocabulary
