"""Findings and reports made up for the tests of reporters."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from hypothesis import strategies as st

from kinlint.finding import Finding, Fix, Premise, Related, TextEdit
from kinlint.report import Report
from kinlint.reporters.terminal_style import Style
from kinlint.rule import Applicability, Example, Rule, Severity
from kinlint.text import Location, SourceText, Span

INERTIA = Rule(
    iri="https://w3id.org/kinlint/rules/inertia-seen-by-foreign-frame",
    code="INE007",
    name="inertia-seen-by-foreign-frame",
    title="inertia is seen by a frame of another body",
    why="""
        An inertia is a matrix of numbers,
        and numbers need a frame.

        A frame that moves against the body makes them wrong.
        """,
    severity=Severity.ERROR,
    antipatterns=("AP3",),
    formats=("jsonld",),
    links=("https://example.org/inertia",),
    messages=("Inertia '{?this}' is seen by frame '{?value}' of another body.",),
    examples=(
        Example(
            "jsonld",
            bad='\n    {\n      "as-seen-by": [|"rob:link1-root"|]\n    }\n',
            good='{ "as-seen-by": "rob:link2-root" }',
        ),
    ),
    since="0.1.0",
    path="/anywhere/rules/inertia/inertia-seen-by-foreign-frame.ttl",
)
UNIT = Rule(
    iri="https://w3id.org/kinlint/rules/unit-quantity-mismatch",
    code="UNI002",
    name="unit-quantity-mismatch",
    title="unit does not fit its quantity",
    why="Numbers are misread.",
    severity=Severity.WARNING,
    antipatterns=("AP5", "AP6"),
    formats=("jsonld",),
    messages=("Unit '{?value}' does not fit.",),
)
RULES = (INERTIA, UNIT)

PLAIN = Style()

DYNAMICS = SourceText(
    "models/dynamics.jsonld",
    """{
  "@graph": [
    {
      "@id": "rob:link2-inertia",
      "of-body": "rob:link2",
      "reference-point": "rob:link2-root-origin",
      "as-seen-by": "rob:link1-root",
      "unit": "M"
    }
  ]
}
""",
)
SKELETON = SourceText(
    "models/skeleton.jsonld",
    '{ "@graph": [\n  { "@id": "rob:link1-root", "of-body": "rob:link1" }\n] }\n',
)


def at(source: SourceText, token: str) -> Location:
    """The first place of *token* in *source*."""
    start = source.text.index(token)
    return Location(source, Span(start, start + len(token)))


def unit_finding(location: Location, value: str = "M", **changes: Any) -> Finding:
    """A finding of the rule about units."""
    finding = Finding(
        rule=UNIT,
        severity=UNIT.severity,
        message=f"Unit '{value}' does not fit.",
        location=location,
        iri="https://example.org/robot#length",
        focus="<https://example.org/robot#length>",
        template=UNIT.messages[0],
        arguments=(value,),
    )
    return replace(finding, **changes)


def here(text: str, start: int = 0, end: int = 0, name: str = "model.jsonld") -> Location:
    """A span of a text."""
    return Location(SourceText(name, text), Span(start, end))


INERTIA_FINDING = Finding(
    rule=INERTIA,
    severity=Severity.ERROR,
    message="Inertia 'rob:link2-inertia' is seen by frame 'rob:link1-root' of another body.",
    location=at(DYNAMICS, '"rob:link1-root"'),
    iri="https://example.org/robot#link2-inertia",
    focus="<https://example.org/robot#link2-inertia>",
    template=INERTIA.messages[0],
    arguments=("rob:link2-inertia", "rob:link1-root"),
    related=(
        Related(at(DYNAMICS, '"rob:link2"'), "but the inertia belongs to rob:link2"),
        Related(at(SKELETON, '"rob:link1"'), "fixed to rob:link1 here"),
    ),
    because=(
        Premise("link2-inertia of-body link2", at(DYNAMICS, '"rob:link2"')),
        Premise("link1-root a Frame", axiom="what has an origin is a Frame"),
        Premise("link1-root of-body link1", at(SKELETON, '"rob:link1"'), depth=1),
    ),
)
UNIT_FINDING = unit_finding(at(DYNAMICS, '"M"'))


def edit(source: SourceText, token: str, text: str) -> TextEdit:
    """*text* in the place of *token*."""
    return TextEdit(at(source, token), text)


def fix(*edits: TextEdit, **changes: Any) -> Fix:
    """A fix that makes *edits*; safe, unless *changes* say otherwise."""
    made = Fix("Express it in frame 'rob:link2-root'", Applicability.SAFE, edits, "DELETE WHERE {}")
    return replace(made, **changes)


SAFE = fix(edit(DYNAMICS, '"rob:link1-root"', '"rob:link2-root"'))
UNSAFE = replace(SAFE, applicability=Applicability.UNSAFE, why="The numbers stay as they are.")
DISPLAY = replace(SAFE, applicability=Applicability.DISPLAY, why="Nobody knows.")


def report(*findings: Finding, **fields: Any) -> Report:
    """A report of *findings* in order."""
    names = {finding.location.source.name: None for finding in findings}
    fields = {"files": tuple(names), "rules": RULES, "root": "/work", "version": "1.2.3"} | fields
    return Report(findings=tuple(sorted(findings, key=lambda one: one.sort_key)), **fields)


BOTH = report(INERTIA_FINDING, UNIT_FINDING, triples=1204, applied=2, seconds=0.42)

characters = st.sampled_from("aZ0 \"{}[]()\\%:,'\t\n\r😀𝒳漢é\u0301\u200b\u202e\x1b\x00\u2028\ufeff")
texts = st.lists(characters, max_size=60).map("".join)
names = st.sampled_from(
    ["a.jsonld", "b c/ü#%?.jsonld", "../up/x.jsonld", "/abs/x.jsonld", "a:b.jsonld", "<stdin>"]
)
messages = st.lists(characters, max_size=20).map("".join)


@st.composite
def locations(draw: st.DrawFn) -> Location:
    """Any span of any text, in one of two sources of each name."""
    text = draw(texts) + draw(st.sampled_from(["", "\r\n", "x" * 500, '{"a":"😀"},' * 60]))
    start = draw(st.integers(0, len(text)))
    end = draw(st.integers(start, min(len(text), start + 40)))
    source = SourceText(draw(names), text, bom=draw(st.booleans()))
    return Location(source, Span(start, end))


@st.composite
def edits_in(draw: st.DrawFn, source: SourceText) -> tuple[TextEdit, ...]:
    """Any edits of *source* in order; none touches another or parts a CR from its LF."""
    text = source.text
    whole = [at for at in range(len(text) + 1) if text[max(0, at - 1) : at + 1] != "\r\n"]
    offsets = sorted(draw(st.lists(st.sampled_from(whole), min_size=2, max_size=6)))
    edits: list[TextEdit] = []
    for start, end in zip(offsets[::2], offsets[1::2], strict=False):
        if not edits or start > edits[-1].location.span.end:
            edits.append(TextEdit(Location(source, Span(start, end)), draw(messages)))
    return tuple(edits)


@st.composite
def fixes_in(draw: st.DrawFn, source: SourceText) -> Fix:
    """Any fix that changes *source*."""
    terms = st.sampled_from(
        ["<https://example.org/a>", "<https://example.org/a b>", "_:b 0", '"é"']
    )
    triples = st.lists(st.tuples(terms, st.just("<https://example.org/p>"), terms), max_size=2)
    return fix(
        *draw(edits_in(source)),
        title=draw(messages),
        applicability=draw(st.sampled_from(Applicability)),
        why=draw(messages),
        removed=tuple(one for one in draw(triples) if not one[0].startswith('"')),
        added=tuple(one for one in draw(triples) if not one[0].startswith('"')),
    )


@st.composite
def findings(draw: st.DrawFn) -> Finding:
    """Any finding, with related places and premises."""
    location = draw(locations())
    others = st.builds(Related, st.just(location) | locations(), messages)
    premises = st.builds(
        Premise,
        messages,
        st.none() | locations(),
        st.sampled_from(["", "an axiom"]),
        st.integers(0, 3),
    )
    value = draw(messages)
    return unit_finding(
        location,
        value,
        template=draw(st.sampled_from([UNIT.messages[0], "", "Unit '{?value}' is {0}."])),
        severity=draw(st.sampled_from(Severity)),
        iri=draw(st.sampled_from(["https://example.org/a", "_:b0"])),
        related=tuple(draw(st.lists(others, max_size=3))),
        because=tuple(draw(st.lists(premises, max_size=4))),
    )


@st.composite
def reports(draw: st.DrawFn) -> Report:
    """Any report; each name stands for one source only."""
    found = draw(st.lists(findings(), max_size=4))
    sources: dict[str, SourceText] = {}

    def same(location: Location) -> Location:
        source = sources.setdefault(location.source.name, location.source)
        size = len(source.text)
        start, end = location.span
        return Location(source, Span(min(start, size), min(end, size)))

    settled = [
        replace(
            finding,
            location=same(finding.location),
            related=tuple(replace(one, location=same(one.location)) for one in finding.related),
            because=tuple(
                replace(one, location=one.location and same(one.location))
                for one in finding.because
            ),
        )
        for finding in found
    ]
    return report(
        *(
            replace(one, fixes=tuple(draw(st.lists(fixes_in(one.location.source), max_size=2))))
            for one in settled
        )
    )
