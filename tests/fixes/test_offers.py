"""What is offered for a finding, and how far it may be trusted."""

import pytest
from mending import book, mend, offered, repair

from kinlint.formats import incremental_reader
from kinlint.formats.registry import read
from kinlint.rule import Applicability

ARM = """<robot name="arm">
  <link name="base"/>  <!-- stays -->
  <joint name="elbow" type="revolute">
    <limit lower="2.60" upper="-1" effort='1e1'/>
  </joint>
</robot>
"""
LIMITS = {
    "target": "sh:targetObjectsOf urdf:limit",
    "select": """SELECT $this (at:lower AS ?path) ?value ?upper WHERE {
        $this at:lower ?value ; at:upper ?upper . FILTER (?value > ?upper) }""",
}
SWAP = """DELETE { $this at:lower $value ; at:upper ?upper }
    INSERT { $this at:lower ?upper ; at:upper $value } WHERE {}"""


@pytest.fixture
def rules(tmp_path):
    """Makes a rulebook of the rules given."""
    return lambda *rules: book(tmp_path, *rules)


def one(rules, update, **said):
    return rules({**LIMITS, "repairs": [repair(update, **said)]})


def test_a_fix_is_offered_as_edits_a_title_and_an_update(rules):
    """Placeholders of the title are filled, moved numbers keep their spelling."""
    (finding,), refused = offered(one(rules, SWAP, title="Swap '{?value}' and '{?upper}'"), ARM)
    (fix,) = finding.fixes

    assert (fix.title, fix.applicability, fix.why, refused) == (
        "Swap 2.6 and -1",
        Applicability.SAFE,
        "",
        [],
    )
    assert [(edit.location.source[edit.location.span], edit.text) for edit in fix.edits] == [
        ("2.60", "-1"),
        ("-1", "2.60"),
    ]
    assert fix.update.startswith("DELETE DATA {\n  <arm.urdf#/joint/elbow/")


def test_all_other_bytes_stay(rules):
    """Comments, quotes and spaces included."""
    text, report = mend(one(rules, SWAP), ARM)

    assert text == ARM.replace('lower="2.60" upper="-1"', 'lower="-1" upper="2.60"')
    assert (report.findings, len(report.fixed)) == ((), 1)


@pytest.mark.parametrize(
    ("said", "written"),
    [("-0.000001", "-1e-06"), ("1e17", "1e+17"), ("0.00020", "0.0002"), ("12.0", "12")],
)
def test_a_new_number_has_the_fewest_characters(rules, said, written):
    """Stores write zeros for exponents."""
    update = """DELETE {{ $this at:lower ?value ; at:effort ?old }}
        INSERT {{ $this at:lower ?upper ; at:effort ?new }}
        WHERE {{ $this at:effort ?old BIND ({} + 0.0e0 AS ?new) }}"""
    text, _ = mend(one(rules, update.format(said)), ARM)

    assert f"effort='{written}'" in text


def test_an_unsafe_fix_waits_until_it_is_wanted(rules):
    """The author's claim bounds what is done, and says why."""
    unsafe = one(rules, SWAP, claim="unsafe")
    (finding,), _ = offered(unsafe, ARM)

    assert [(fix.applicability, fix.why) for fix in finding.fixes] == [
        (Applicability.UNSAFE, "It is a guess.")
    ]
    assert mend(unsafe, ARM)[0] == ARM
    assert mend(unsafe, ARM, least=Applicability.UNSAFE)[0] != ARM


def test_what_leaves_the_finding_is_refused(rules):
    """A fix that mends nothing is none."""
    useless = one(rules, "DELETE { $this at:effort ?f } WHERE { $this at:effort ?f }")
    (finding,), refused = offered(useless, ARM)

    assert (finding.fixes, refused) == ((), ["the finding would stay"])
    assert mend(useless, ARM)[0] == ARM


def test_what_brings_another_finding_is_not_safe(rules):
    """Linting again decides what an author may claim."""
    without = {
        "target": "sh:targetObjectsOf urdf:limit",
        "select": "SELECT $this WHERE { FILTER NOT EXISTS { $this at:lower ?l } }",
        "repairs": [],
    }
    delete = {
        **LIMITS,
        "repairs": [repair("DELETE { $this at:lower $value } WHERE {}")],
    }
    without["repairs"] = [repair("INSERT { $this at:lower 0e0 } WHERE {}", claim="displayOnly")]
    (finding,), _ = offered(rules(delete, without), ARM)

    assert [(fix.applicability, fix.why) for fix in finding.fixes] == [
        (Applicability.UNSAFE, "it brings TST002 to light")
    ]


def test_what_the_text_does_not_say_cannot_be_taken_back(rules):
    """Facts and conclusions are in no file: the reason is told."""
    inferred = one(rules, "DELETE { ?j a kin:LimitedJoint } WHERE { ?j a kin:LimitedJoint }")
    (finding,), refused = offered(inferred, ARM)
    assert (finding.fixes, refused) == ((), [])

    lifted = one(rules, "INSERT { ?j kin:of-joint ?j } WHERE { ?j kin:lower ?l }")
    (finding,), refused = offered(lifted, ARM)
    assert (finding.fixes, len(refused)) == ((), 1)


def test_alternatives_come_in_their_order(rules):
    """The preferred first, and it is what is made."""
    choice = rules(
        {
            **LIMITS,
            "repairs": [
                repair(SWAP, title="Swap", claim="unsafe", order=2),
                repair(
                    "DELETE { $this at:lower $value } INSERT { $this at:lower ?upper } WHERE {}",
                    title="Lower",
                    claim="unsafe",
                    order=1,
                ),
            ],
        }
    )
    (finding,), _ = offered(choice, ARM)
    text, _ = mend(choice, ARM, least=Applicability.UNSAFE)

    assert [fix.title for fix in finding.fixes] == ["Lower", "Swap"]
    assert 'lower="-1" upper="-1"' in text


def test_many_findings_are_mended_at_once_and_only_those_that_hold(rules):
    """One that fails is told apart from its neighbours in a few trials."""
    joint = '<joint name="j{0}" type="revolute"><limit lower="{0}" upper="-{0}"{1}/></joint>\n'
    joints = "".join(joint.format(n, ' effort="3"' if n == 5 else "") for n in range(1, 12))
    text = f'<robot name="arm">\n{joints}</robot>\n'
    fails = """DELETE { $this at:lower $value ; at:upper ?upper ; at:effort ?effort }
        INSERT { $this at:lower ?upper ; at:upper ?last ; at:effort ?effort }
        WHERE { BIND (IF(EXISTS { $this at:effort 3e0 }, ?upper - 1, $value) AS ?last)
                OPTIONAL { $this at:effort ?effort } }"""
    made, report = mend(one(rules, fails), text)

    assert [finding.arguments for finding in report.findings] != []
    assert len(report.fixed) == 10
    assert made.count('upper="-') == 1


def test_lifted_values_are_mended_where_they_are_written(rules):
    """A rule of composable models mends robots in XML as well."""
    domain = rules(
        {
            "target": "sh:targetSubjectsOf kin:lower",
            "select": """SELECT $this (kin:lower AS ?path) ?value ?upper WHERE {
                $this kin:lower ?value ; kin:upper ?upper . FILTER (?value > ?upper) }""",
            "repairs": [repair(SWAP.replace("at:", "kin:"))],
        }
    )

    assert 'lower="-1" upper="2.60"' in mend(domain, ARM)[0]


def test_functions_of_xpath_are_there(rules):
    """Numbers come out as short as they can be."""
    root = one(
        rules,
        """DELETE { $this at:lower $value } INSERT { $this at:lower ?root }
        WHERE { BIND (- math:sqrt(2.25) AS ?root) }""",
    )

    assert 'lower="-1.5" upper="-1"' in mend(root, ARM)[0]


WHEELS = """<robot name="cart">
  <link name="left"/>
  <link name="right"/>
</robot>
"""
LINKS = {"target": "sh:targetObjectsOf urdf:link"}
UNJOINED = (
    """SELECT $this WHERE { ?robot urdf:link $this FILTER NOT EXISTS { ?robot urdf:joint ?any } }"""
)


def test_new_elements_come_once_and_as_the_rule_writes_them(rules):
    """However many solutions there are, and whatever parsers make of the template."""
    joined = rules(
        {
            "target": "sh:targetObjectsOf urdf:robot",
            "select": UNJOINED.replace("?robot", "$this").replace("link $this", "link ?link"),
            "repairs": [
                repair("""INSERT { $this urdf:joint _:joint . _:joint at:name "axle" ;
                    urdf:parent _:p ; urdf:child _:c . _:p at:link "left" . _:c at:link "right" }
                    WHERE { $this urdf:link ?any }""")
            ],
        }
    )
    added = """  <joint name="axle">
    <parent link="left"/>
    <child link="right"/>
  </joint>
"""
    assert mend(joined, WHEELS)[0] == WHEELS.replace("</robot>", f"{added}</robot>")


def test_what_several_findings_ask_for_is_written_once(rules):
    """And holds for all of them."""
    joined = rules(
        {
            **LINKS,
            "select": UNJOINED,
            "repairs": [
                repair("""INSERT { ?robot urdf:joint _:joint . _:joint at:name "axle" }
                    WHERE { ?robot urdf:link $this }""")
            ],
        }
    )
    findings, refused = offered(joined, WHEELS)

    assert ([len(each.fixes) for each in findings], refused) == ([1, 1], [])
    assert mend(joined, WHEELS)[0].count("<joint") == 1


def test_the_title_for_several_places_speaks_of_the_first(rules):
    """As the message does."""
    grouped = rules(
        {
            "target": 'kl:groupBy "file" ; sh:targetObjectsOf urdf:link',
            "select": """SELECT $this (at:name AS ?path) ?value WHERE {
                $this at:name ?value FILTER (! STRENDS(?value, "_link")) }""",
            "repairs": [
                repair(
                    """DELETE { $this at:name ?value } INSERT { $this at:name ?new }
                    WHERE { $this at:name ?value BIND (CONCAT(?value, "_link") AS ?new) }""",
                    title="Call '{?value}' a link",
                )
            ],
        }
    )
    (finding,), _ = offered(grouped, WHEELS)

    assert [fix.title for fix in finding.fixes] == ["Call 'left' a link"]
    assert mend(grouped, WHEELS)[0].count("_link") == 2


def test_no_text_is_read_again_that_was_read_just_now(rules, monkeypatch):
    """The trial of a fix that is made then has read what is left."""
    texts = []

    def counted(source, options):
        texts.append(source.text)
        return read(source, options)

    monkeypatch.setattr(incremental_reader, "read", counted)
    text, report = mend(one(rules, SWAP), ARM)

    assert (texts, len(report.fixed), report.findings) == ([ARM, text], 1, ())


def test_a_number_that_moves_keeps_its_spelling_in_json(rules):
    """Although JSON-LD reads it as a double like any other."""
    swap = rules(
        {
            "target": "sh:targetSubjectsOf kin:lower",
            "select": """SELECT $this (kin:lower AS ?path) ?value ?upper WHERE {
                $this kin:lower ?value ; kin:upper ?upper . FILTER (?value > ?upper) }""",
            "repairs": [repair(SWAP.replace("at:", "kin:"))],
        }
    )
    text = """{ "@context": "https://w3id.org/kinlint/composable.json",
        "@id": "https://example.org/arm#limit", "@type": "JointPositionLimit",
        "lower": 0.0400, "upper": -1e-2 }"""

    made = mend(swap, text, "arm.jsonld")[0]
    assert made == text.replace("0.0400", "?").replace("-1e-2", "0.0400").replace("?", "-1e-2")
