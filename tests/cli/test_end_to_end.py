"""The command with everything behind it."""

import io
import json
import re
import subprocess
import sys

import pytest

CONTEXT = (
    '["https://comp-rob2b.github.io/metamodels/geometry/structural-entities.json",'
    ' {"ex": "https://example.org/arm#", "kl": "https://w3id.org/kinlint/ns#"}]'
)
POINT = '"@id": "ex:origin", "@type": ["3D", "Euclidean", "Point"]'
CLEAN = f'{{"@context": {CONTEXT}, {POINT}}}'
DROPPED = f'{{"@context": {CONTEXT},\n {POINT},\n "colour": "red"}}'


def findings(kinlint, *arguments):
    """Places and codes."""
    code, out, _ = kinlint(*arguments, "--output-format", "json")
    return code, [
        (one["filename"], one["location"]["row"], one["location"]["column"], one["code"])
        for one in json.loads(out)
    ]


def test_a_defect_is_found_at_its_place(kinlint, write):
    """In a file, a directory and a glob alike."""
    write("m/arm.json", DROPPED)
    write("m/package.json", "{}")
    expected = (1, [("m/arm.json", 3, 2, "LD001")])

    assert findings(kinlint, "m/arm.json") == expected
    assert findings(kinlint) == expected
    assert findings(kinlint, "m/*.json") == expected


def test_right_models_pass(kinlint, write):
    """With a word of it."""
    write("arm.jsonld", CLEAN)

    assert kinlint("arm.jsonld") == (0, "All checks passed in 1 file.\n", "")


def test_standard_input(kinlint, monkeypatch):
    """Under the name that it is given."""

    class Stdin:
        buffer = io.BytesIO(DROPPED.encode())

    monkeypatch.setattr(sys, "stdin", Stdin())

    assert findings(kinlint, "-", "--stdin-filename", "m/arm.jsonld") == (
        1,
        [("m/arm.jsonld", 3, 2, "LD001")],
    )


SELECTIONS = [
    ([], ["LD001"]),
    (["--ignore", "LD001"], []),
    (["--ignore", "AP5"], []),
    (["--select", "UNI,TOP"], []),
    (["--select", "ALL", "--ignore", "LD", "--extend-select", "dropped-term"], ["LD001"]),
    (["--per-file-ignores", "*.jsonld:LD"], []),
    (["--per-file-ignores", "arm.jsonld#/colour:LD"], []),
    (["--per-file-ignores", "arm.jsonld#/@id:LD"], ["LD001"]),
    (["--per-file-ignores", "<https://example.org/arm#origin>:LD"], []),
]
"""Options, and the codes that are found with them."""


@pytest.mark.parametrize(
    ("engine", "options", "codes"),
    [
        *(("oxigraph", *each) for each in SELECTIONS),
        # Of what the other engine finds, a rule and a place are told apart in the same way.
        *(pytest.param("pyshacl", *SELECTIONS[at], marks=pytest.mark.oracle) for at in (0, 1, 6)),
    ],
)
def test_selection(kinlint, write, engine, options, codes):
    """By every kind of selector and place, whatever the engine."""
    write("arm.jsonld", DROPPED)
    _, found = findings(kinlint, "arm.jsonld", "--engine", engine, *options)

    assert [code for *_, code in found] == codes


def test_severities(kinlint, write):
    """An override decides the exit code."""
    write("arm.jsonld", DROPPED)

    assert kinlint("arm.jsonld", "--info", "LD")[0] == 0
    assert kinlint("arm.jsonld", "--info", "LD", "--error", "LD001")[0] == 1


@pytest.mark.slow
def test_suppression_in_a_model(kinlint, write):
    """By a triple; a superfluous one is found."""
    ignoring = DROPPED.replace('"colour"', '"kl:ignore": "LD001", "colour"')
    write("arm.jsonld", ignoring)
    write("leg.jsonld", ignoring.replace("ex:origin", "ex:leg").replace(', "colour": "red"', ""))

    assert findings(kinlint, "arm.jsonld") == (0, [])
    assert findings(kinlint, ".") == (1, [("leg.jsonld", 3, 15, "LNT001")])
    assert findings(kinlint, "arm.jsonld", "--ignore-suppressions")[1][0][3] == "LD001"
    assert "kl:ignore at arm.jsonld:3" in kinlint("arm.jsonld", "--show-suppressed")[1]


@pytest.mark.parametrize(
    ("data", "cause"),
    [
        (b"", "empty"),
        (DROPPED[:200].encode(), "cut off"),
        (b'{"@id": "\xf6"}', "not UTF-8"),
        (CLEAN.encode("utf-16"), "UTF-16"),
        (b"\x00\x00", "NUL"),
        (b"robot", "not JSON"),
        (b"[" * 100_000, "levels deep"),
        (b'{"@id": 5}', "not JSON-LD"),
    ],
)
def test_what_cannot_be_read_is_told_and_the_rest_is_linted(kinlint, write, here, data, cause):
    """One line with file, place and cause; exit code 2."""
    (here / "broken.jsonld").write_bytes(data)
    write("arm.jsonld", DROPPED)
    code, out, err = kinlint("broken.jsonld", "arm.jsonld", "--output-format", "concise", "-q")
    lines = out.splitlines()

    assert (code, err) == (2, "")
    assert [line.split(":")[0] for line in lines] == ["arm.jsonld", "broken.jsonld"]
    assert lines[1].split(":")[1].isdigit()
    assert cause in lines[1]


def test_a_file_without_known_vocabulary_is_told(kinlint, write):
    """It never passes in silence."""
    write("x.jsonld", '{"@id": "https://example.org/x", "https://example.org/p": 1}')

    assert "x.jsonld: 0 rules applied" in kinlint("x.jsonld")[1]


def test_yaml_that_names_no_part_of_a_robot_is_told_if_it_was_named(kinlint, write):
    """Most YAML files below a directory are of something else."""
    write("x.yaml", "camera: {rate: 30}\n")
    write("y.yaml", "controller: {joints: [elbow]}\n")

    code, out, _ = kinlint("x.yaml", "--output-format", "concise")
    assert code == 0
    assert out.splitlines() == [
        "x.yaml: 0 rules applied: it names no joint, link, frame or planning group",
        "Nothing was checked: no rule applies.",
    ]
    assert kinlint("x.yaml", "y.yaml")[1].startswith("x.yaml: 0 rules applied")
    assert "applied" not in kinlint("y.yaml")[1]
    assert "applied" not in kinlint(".")[1]


@pytest.mark.slow
def test_rules_of_ones_own_are_rules(kinlint, write):
    """They are selected, explained and tested as the built-in ones."""
    write(
        "mine/pink-origin.ttl",
        """
        @prefix geom: <https://comp-rob2b.github.io/metamodels/geometry/structural-entities#> .
        @prefix kl: <https://w3id.org/kinlint/ns#> .
        @prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
        @prefix rule: <https://w3id.org/kinlint/rules/> .
        @prefix sh: <http://www.w3.org/ns/shacl#> .
        rule:pink-origin a kl:Rule, sh:NodeShape ;
            kl:code "ACME001" ; rdfs:label "pink origin" ; rdfs:comment "Pink is for legs." ;
            kl:antiPattern kl:AP5 ; kl:format "jsonld" ; sh:severity sh:Warning ;
            sh:targetClass geom:Point ;
            sh:property [ sh:path <https://example.org/arm#colour> ; sh:maxCount 0 ;
                          sh:message "This origin is pink." ] .
        """,
    )
    write("arm.jsonld", DROPPED.replace("colour", "ex:colour"))

    assert findings(kinlint, "arm.jsonld") == (0, [])
    assert findings(kinlint, "arm.jsonld", "--rules", "mine")[1][0][3] == "ACME001"
    assert findings(kinlint, "arm.jsonld", "--rules", "mine", "--ignore", "ACME") == (0, [])
    assert "unknown rule selector" in kinlint("arm.jsonld", "--ignore", "ACME001")[2]
    assert kinlint("rule", "pink-origin", "--rules", "mine")[1].startswith("ACME001 ")
    code, out, _ = kinlint("test-rules", "mine")
    assert (code, "ACME001 pink-origin: it has no example" in out) == (1, True)


@pytest.mark.slow
def test_a_user_rule_that_is_no_turtle(kinlint, write):
    """One line, exit code 2."""
    write("mine/x.ttl", "this is no Turtle")
    write("arm.jsonld", CLEAN)
    code, out, err = kinlint("arm.jsonld", "--rules", "mine")

    assert (code, out, err.count("\n")) == (2, "", 1)
    assert "x.ttl" in err


@pytest.mark.slow
def test_a_compiled_run_imports_no_slow_library(kinlint, write, here):
    """Neither rdflib nor pyshacl nor owlrl nor rich."""
    write("arm.jsonld", DROPPED)
    kinlint("arm.jsonld")
    program = (
        "import sys; from kinlint.cli.main import main; code = main(['arm.jsonld', '-s']);"
        "TIMING = 'kinlint.reporters.time_profile';"
        "print(code, *{'rdflib', 'pyshacl', 'owlrl', 'rich', 'tomllib', TIMING} & set(sys.modules))"
    )
    done = subprocess.run(
        [sys.executable, "-c", program], check=False, capture_output=True, text=True, cwd=here
    )

    assert (done.stdout, done.stderr) == ("1\n", "")


def test_statistics_tell_where_time_went_if_asked(kinlint, write):
    """Each phase once, in order, and a total that is their sum; only with `-v`."""
    write("arm.jsonld", DROPPED)
    _, _, err = kinlint("arm.jsonld", "--statistics", "-v")
    rows = [line.split() for line in err.splitlines() if line.endswith("%")]
    spent = {row[0]: float(row[1].replace(",", "")) for row in rows}

    assert [*spent][:5] == ["rules", "imports", "decoding", "recalling", "reading"]
    assert [*spent][5:9] == ["loading", "lifting", "closure", "facts"]
    assert [*spent][9:] == ["checking", "locating", "fixing", "reporting", "total"]
    assert abs(2 * spent["total"] - sum(spent.values())) < 1
    assert "%" not in kinlint("arm.jsonld", "--statistics")[2]
    assert "slowest" not in err


@pytest.mark.slow
def test_statistics_list_the_slowest_rules_facts_and_lifting_queries(kinlint, write):
    """With `-vv`: the slowest first, a last line for all others; shares of a kind add up."""
    write("arm.urdf", '<robot name="arm"><link name="base"/><link name="tip"/></robot>')
    _, _, err = kinlint("arm.urdf", "--statistics", "-vv", "--jobs", "2")
    _, *kinds = err.split("\nslowest ")
    found = {}
    for text in kinds:
        title, *lines = text.splitlines()
        rows = [line.rsplit(None, 3) for line in lines if line.endswith("%")]
        found[title] = [(name, float(took)) for name, took, _, _ in rows]

    assert set(found) == {"lifting queries:", "facts:", "rules:"}
    for rows in found.values():
        *slowest, (last, _) = rows
        assert len(rows) <= 11
        assert slowest == sorted(slowest, key=lambda row: -row[1])
        assert last.endswith(" others") == (len(rows) == 11)
    names = {title: {name for name, _ in rows[:-1]} for title, rows in found.items()}
    assert all(name.startswith("urdf/") for name in names["lifting queries:"])
    assert all(re.fullmatch(r"[A-Z]+[0-9]{3}", name) for name in names["rules:"])
