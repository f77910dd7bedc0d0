"""The beginning of a rule file: all that a rule says, with what its author has to fill in."""

from __future__ import annotations

from collections.abc import Iterator
from string import Template

MARK = "TODO:"
"""The mark of what is to be filled in; no rule is done that has it."""

_RULE = Template('''\
@prefix kc:   <https://comp-rob2b.github.io/metamodels/kinematic-chain/structural-entities#> .
@prefix kl:   <https://w3id.org/kinlint/ns#> .
@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
@prefix rule: <https://w3id.org/kinlint/rules/> .
@prefix sh:   <http://www.w3.org/ns/shacl#> .

rule:$name a kl:Rule, sh:NodeShape ;
    kl:code "$code" ;
    rdfs:label "TODO: the fault in a few words, lower case" ;
    rdfs:comment """
        TODO: what breaks, in the robot, the simulator or the controller, in two sentences or more.
        """ ;
    kl:format $formats ;
    rdfs:seeAlso <https://example.org/> ;  # TODO: what the rule rests on

    sh:severity sh:Warning ;
    sh:targetClass kc:Joint ;  # TODO: what it is about
    sh:sparql [
        sh:message "TODO: what is wrong with '{$$this}'." ;
        sh:select """
            SELECT $$this WHERE {
                # TODO: what a joint is like that has the fault
                FILTER (false)
            }
            """ ] ;

    # [|...|] stands round what is to be flagged.
    kl:example [
        kl:bad """
$bad"""^^kl:$format ;
        kl:good """
$good"""^^kl:$format ] .
''')
_JSON_LD = Template("""\
            {
              "@context": ["https://w3id.org/kinlint/composable.json", {"ex": "https://example.org/arm#"}],
              "@id": $id,
              "@type": "Joint"
            }""")
_URDF = Template("""\
            <robot name="arm">
              <link name="base"/>
              <link name="arm"/>
              <joint name=$id type="fixed">
                <parent link="base"/>
                <child link="arm"/>
              </joint>
            </robot>""")
EXAMPLES = {
    "jsonld": ('"graph"', _JSON_LD, '"ex:TODO: the fault"', '"ex:elbow"'),
    "urdf": ('"urdf"', _URDF, '"TODO: the fault"', '"elbow"'),
}
"""For each format of examples: those of the rule, a text, and what it has for bad and good."""


def scaffold(name: str, code: str, form: str) -> str:
    """Return the text of a file for the rule *name* with examples in the format *form*."""
    formats, example, bad, good = EXAMPLES[form]
    return _RULE.substitute(
        name=name,
        code=code,
        formats=formats,
        format=form,
        bad=example.substitute(id=f"[|{bad}|]"),
        good=example.substitute(id=good),
    )


def unfilled(text: str) -> Iterator[tuple[int, str]]:
    """Yield the lines of *text*, counted from one, that wait for being filled in."""
    for number, line in enumerate(text.splitlines(), 1):
        if MARK in line:
            yield number, line.strip()
