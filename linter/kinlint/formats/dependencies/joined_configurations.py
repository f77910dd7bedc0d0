"""Joins the documents of YAML files to the robots whose joints they name."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence

from kinlint.addresses import root_of
from kinlint.document import Document
from kinlint.formats.source_layer import src
from kinlint.formats.urdf.format import URDF
from kinlint.formats.xml.references import NameUse, names_in, resolve_references
from kinlint.formats.xml.schema import schema
from kinlint.formats.yaml.format import YAML
from kinlint.light_dataclasses import replace
from kinlint.suggestion import nearest
from kinlint.terms import Term, Triple, iri, literal_value
from kinlint.vocabulary import ATTRIBUTE, SRC

JOINED_TO = iri(f"{SRC}joinedTo")
SHARE = 0.5
"""Share of the names in a file that its robots must have."""
_COMPUTED = re.compile(r"\$[{(][^})]*[})]")
_NAME = re.compile(r"<joint\b[^>]*?\sname\s*=\s*[\"']([^\"']*\$[^\"']*)[\"']")


def join_configurations(
    documents: Sequence[Document], whole: Collection[str], meant: Mapping[str, Sequence[str]]
) -> list[Document]:
    """Return *documents*, in which YAML files lead to the joints that they name.

    Names that no robot has dangle where all the robots that may be *meant*, by the name of the
    file, are *whole*; without an entry all robots may be. A file of whose names the robots have
    hardly any is about other robots, and leads nowhere.
    """
    robots = {each.source.name: each for each in documents if each.format.lifted_as == URDF.name}
    return [
        _joined(each, [robots[name] for name in names if name in robots], whole)
        if each.format == YAML and (names := meant.get(each.source.name, tuple(robots)))
        else each
        for each in documents
    ]


def _joined(document: Document, robots: Sequence[Document], whole: Collection[str]) -> Document:
    uses = {use.element: use for use in names_in(document)}
    found: dict[Term, Sequence[Triple]] = {}
    missing: dict[Term, list[Triple]] = {}
    for robot in robots:
        home = root_of(robot.graph), robot.map.nodes
        for use in uses.values():
            told = [triple for triple, _ in _resolved(use, document, home)]
            if any(triple[1] == src("dangling") for triple in told):
                missing.setdefault(use.element, told)
            elif told:
                found.setdefault(use.element, told)
    lost = [uses[element] for element in missing if element not in found]
    if not found and not lost:
        return document
    sure = all(each.source.name in whole for each in robots)
    dangling = _dangling(lost, [*found], uses, robots) if sure else ()
    if found or dangling:
        first = next(each for each in robots if each.source.name in whole or found)
        leading = [(root_of(document.graph), JOINED_TO, root_of(first.graph))]
        leading += [triple for told in found.values() for triple in told]
        leading += [triple for use in dangling for triple in missing[use.element]]
        return replace(document, statements=(*document.statements, *dict.fromkeys(leading)))
    return document


def _resolved(
    use: NameUse, document: Document, home: tuple[Term, Collection[Term]]
) -> list[tuple[Triple, Triple]]:
    return [*resolve_references([use], schema(YAML.name), document.map.nodes, home)]


def _dangling(
    lost: Sequence[NameUse],
    found: Sequence[Term],
    uses: Mapping[Term, NameUse],
    robots: Sequence[Document],
) -> Sequence[NameUse]:
    """Return those of *lost* that the *robots* should have.

    A name that a part of a macro may make, where other arguments are given, is none of these.
    """
    known = {uses[each].text for each in found}
    names = {each.text for each in lost}
    joints = {name for each in robots for name in _joints(each)}
    if len(known) < SHARE * len(known | names) and any(
        nearest(name, joints - known) is None for name in names
    ):
        return ()
    patterns = [
        re.compile(".*".join(map(re.escape, _COMPUTED.split(written))))
        for robot in robots
        for source in robot.sources
        for written in _NAME.findall(source.text)
        if _COMPUTED.sub("", written)
    ]
    return [use for use in lost if not any(each.fullmatch(use.text) for each in patterns)]


def _joints(robot: Document) -> list[str]:
    head = f"{root_of(robot.graph)[:-1]}/joint/"
    named = iri(f"{ATTRIBUTE}name")
    return [
        literal_value(value)
        for element, place, value in robot.statements
        if place == named and element.startswith(head)
    ]
