"""Robots made up for the tests of pictures."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from reported import report, unit_finding

from kinlint.finding import Finding
from kinlint.report import Report
from kinlint.rule import Severity
from kinlint.structure import Coupling, Frame, Joint, Link, Origin, Structure, Vector
from kinlint.text import Location, SourceText, Span

TEXT = SourceText("arm.urdf", '<robot name="arm">' + " " * 200 + "</robot>")
HOSTILE = (
    *('"', "a\"b'c", "x[y]{z}(w)", "<script>alert(1)</script>", "</style>", "]]>", "--><b>"),
    *("end", "graph", "subgraph", "click", "style", "a--b", "a-->b", "a|b", "`c`", "%% c", "#35;"),
    *(
        "\\N \\G",
        "&amp; &#60;",
        "größe",
        "机器人",
        "😀",
        "x\u202ey",
        "nul\x00",
        "lone \ud800",
        "l" * 90,
    ),
    *("javascript:alert(1)", "line\nbreak", "tab\there", "\u2028", " "),
)


def place(start: int) -> Location:
    """A place in the text of the arm."""
    return Location(TEXT, Span(start, start + 3))


def chain(*names: str, close: bool = False) -> Structure:
    """Links of these names in a row; if *close*, the last is joined to the first."""
    links = tuple(
        Link(f"urn:l{index}", name, place(index), frames=(Frame(f"urn:f{index}", f"f {name}"),))
        for index, name in enumerate(names)
    )
    joints = [
        Joint(
            f"urn:j{index}",
            f"j {name}",
            "revolute",
            f"urn:l{index}",
            f"urn:l{index + 1}",
            origin=Origin((0.0, 0.1, 1 / 3), (0.0, 0.0, 1.5708)),
            lower=-1.0,
            upper=2.5,
        )
        for index, name in enumerate(names[:-1])
    ]
    if close:
        joints.append(Joint("urn:jx", "closing", "fixed", links[-1].iri, "urn:l0", closes=True))
    couplings = (Coupling("urn:c", "c", "urn:j0", "urn:j1", -2.0, 0.1),) if len(names) > 2 else ()
    owners = {f"<urn:l{index}>": f"urn:l{index}" for index in range(len(names))}
    owners |= {f"<{joint.iri}>": joint.iri for joint in joints} | {"<urn:arm>": "urn:arm"}
    return Structure(
        "urn:arm",
        "arm",
        links,
        tuple(joints),
        couplings,
        ("urn:l0",),
        ("arm.urdf",),
        owners=owners,
    )


def standing(structure: Structure, step: Vector = (0.1, 0.0, 0.3), **changes: object) -> Structure:
    """A robot whose joints are placed one behind the other."""

    def at(number: int) -> Vector:
        x, y, z = step
        return x * number, y * number, z * number

    links = tuple(replace(each, point=at(n)) for n, each in enumerate(structure.links))
    joints = tuple(
        replace(
            each, point=at(n + 1), end=at(n + 1), direction=(0.0, 1.0, 0.0), placed=True, **changes
        )
        for n, each in enumerate(structure.joints)
    )
    return replace(structure, links=links, joints=joints)


def about(iri: str, severity: Severity = Severity.ERROR, **changes: Any) -> Finding:
    """A finding about the part called *iri*."""
    finding = unit_finding(place(1), iri=iri, focus=f"<{iri}>", severity=severity)
    return replace(finding, **changes)


def picture(*findings: Finding, robots: tuple[Structure, ...]) -> Report:
    """A report with *robots* in it."""
    return report(*findings, structures=robots, catalogue="c0ffee")
