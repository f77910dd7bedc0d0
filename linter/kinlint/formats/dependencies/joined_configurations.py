"""Joins the documents of YAML files to the robots whose parts they name."""

from __future__ import annotations

import re
from collections.abc import Collection, Iterable, Iterator, Mapping, Sequence
from functools import cached_property

from kinlint.addresses import root_of
from kinlint.document import Document
from kinlint.formats.source_layer import src
from kinlint.formats.srdf.format import SRDF
from kinlint.formats.urdf.format import URDF
from kinlint.formats.xml.references import NameUse, names_in, resolve_references
from kinlint.formats.xml.schema import schema
from kinlint.formats.yaml.format import YAML
from kinlint.light_dataclasses import dataclass, replace
from kinlint.suggestion import nearest, slips
from kinlint.terms import Term, Triple, iri, literal_value
from kinlint.text import Pairing
from kinlint.vocabulary import ATTRIBUTE, SRC

JOINED_TO = iri(f"{SRC}joinedTo")
SHARE = 0.5
"""Share of the names in a file that its robots must have."""
SHORT = 2
"""Most letters of words such as `l` and `fr` that tell sides apart: another one is no slip."""
_COMPUTED = re.compile(r"\$[{(][^})]*(?:[})]|\Z)")
_WRITTEN = re.compile(r"""<(link|joint|group)\s[^<>]*?\bname\s*=\s*(?:"([^"]*)"|'([^']*)')""")
_FRAME = iri(f"{YAML.namespace}frame")
_NAMED = iri(f"{ATTRIBUTE}name")


def join_configurations(documents: Sequence[Document], whole: Collection[str]) -> list[Document]:
    """Return *documents*, in which YAML files lead to the parts of robots that they name.

    Names that no robot has dangle where all the robots that may be meant are *whole*; without a
    pairing all may be. A file of whose names the robots have hardly any is about other robots, and
    leads nowhere.
    """
    robots = {each.source.name: each for each in documents if _kind(each) in (URDF, SRDF)}
    return [
        _Joining(each, list(_meant(each.source.pairing, robots)), whole).joined()
        if each.format == YAML
        else each
        for each in documents
    ]


def _kind(document: Document) -> object:
    lifted = document.format.lifted_as
    return URDF if lifted == URDF.name else SRDF if lifted == SRDF.name else None


def _meant(pairing: Pairing | None, robots: Mapping[str, Document]) -> Iterator[Document]:
    names: Iterable[str] = robots
    if pairing is not None:
        names = (pairing.partner, *pairing.others, *pairing.annotations)
    yield from (robots[name] for name in names if name in robots)


@dataclass(frozen=True, slots=False)
class _Joining:
    """A YAML file, and the files of the robots that it may be about."""

    document: Document
    """The YAML file."""
    robots: Sequence[Document]
    """The files of the robots, URDF and SRDF."""
    whole: Collection[str]
    """Names of files that were read to the end."""

    def joined(self) -> Document:
        """Return the document with what leads to the parts of robots."""
        uses = {use.element: use for use in names_in(self.document)}
        found: dict[Term, Sequence[Triple]] = {}
        missing: dict[Term, list[Triple]] = {}
        for robot in self.robots:
            space = (URDF if _kind(robot) == URDF else SRDF).namespace
            home = root_of(robot.graph), robot.map.nodes
            for use in uses.values():
                if any(target != space for target, _ in use.reference.targets):
                    continue
                told = [triple for triple, _ in self._resolved(use, home)]
                if any(triple[1] == src("dangling") for triple in told):
                    missing.setdefault(use.element, told)
                elif told:
                    found.setdefault(use.element, told)
        lost = [uses[element] for element in missing if element not in found]
        dangling = list(self._dangling(lost, {uses[each].text for each in found}))
        if not found and not dangling:
            return self.document
        first = next(
            (each for each in self.robots if each.source.name in self.whole), self.robots[0]
        )
        leading = [(root_of(self.document.graph), JOINED_TO, root_of(first.graph))]
        leading += [triple for told in found.values() for triple in told]
        leading += [triple for use in dangling for triple in missing[use.element]]
        statements = (*self.document.statements, *dict.fromkeys(leading))
        return replace(self.document, statements=statements)

    def _resolved(
        self, use: NameUse, home: tuple[Term, Collection[Term]]
    ) -> list[tuple[Triple, Triple]]:
        nodes = self.document.map.nodes
        return [*resolve_references([use], schema(YAML.name), nodes, home)]

    def _dangling(self, lost: Sequence[NameUse], known: Collection[str]) -> Iterator[NameUse]:
        """Yield those of *lost* that the robots should have, which have the names *known*.

        A name that a part of a macro may make, where other arguments are given, is none of these,
        and a frame only if it is a slip for the name of a link.
        """
        strict = [each for each in lost if each.element not in self._frames]
        if not self._speaks_of_them(strict, known):
            strict = []
        for use in lost:
            tag = use.reference.targets[0][1]
            if not self._all_whole(tag):
                continue
            if use.element in self._frames:
                if any(_is_slip(use.text, name) for name in self._names[tag]):
                    yield use
            elif use in strict and not any(each.fullmatch(use.text) for each in self._made[tag]):
                yield use

    def _speaks_of_them(self, lost: Sequence[NameUse], known: Collection[str]) -> bool:
        """Tell whether the file is about these robots, by the names that they lack and have."""
        pairing = self.document.source.pairing
        if pairing is not None and pairing.stated and pairing.certain:
            return True
        names = {each.text for each in lost}
        near = all(self._is_near(use, known) for use in lost)
        return near or len(known) >= SHARE * len({*known, *names})

    def _is_near(self, use: NameUse, known: Collection[str]) -> bool:
        """Tell whether *use* resembles a name of the robots that is not *known*, or is a slip."""
        names = self._names[use.reference.targets[0][1]]
        slip = any(_is_slip(use.text, name) for name in names)
        return slip or nearest(use.text, names - {*known}) is not None

    @cached_property
    def _frames(self) -> frozenset[Term]:
        return frozenset(o for _, p, o in self.document.statements if p == _FRAME)

    @cached_property
    def _names(self) -> Mapping[str, set[str]]:
        """The names that robots have, by the tags of what has them."""
        found: dict[str, set[str]] = {"link": set(), "joint": set(), "group": set()}
        for robot in self.robots:
            heads = {tag: f"{root_of(robot.graph)[:-1]}/{tag}/" for tag in found}
            for element, place, value in robot.statements:
                if place == _NAMED:
                    for tag, head in heads.items():
                        if element.startswith(head) and "/" not in element[len(head) :]:
                            found[tag].add(literal_value(value))
        return found

    def _all_whole(self, tag: str) -> bool:
        """Tell whether all robots that may have what has *tag* were read to the end."""
        kind = SRDF if tag == "group" else URDF
        own = [each.source.name for each in self.robots if _kind(each) == kind]
        return bool(own) and all(name in self.whole for name in own)

    @cached_property
    def _made(self) -> Mapping[str, Sequence[re.Pattern[str]]]:
        """Patterns of the names that macros of the robots may make, by tag."""
        found: dict[str, list[re.Pattern[str]]] = {tag: [] for tag in self._names}
        for source in (source for robot in self.robots for source in robot.sources):
            for tag, one, other in _WRITTEN.findall(source.text):
                parts = _COMPUTED.split(one or other)
                if len(parts) > 1 and any(parts):
                    found[tag].append(re.compile(".*".join(map(re.escape, parts))))
        return found


def _is_slip(name: str, known: str) -> bool:
    """Tell whether *name* is a slip for the *known* one, and not the name of another side."""
    count = slips(name.casefold(), known.casefold())
    if count is None or count > max(1, len(name) // 4):
        return False
    one, other = name.split("_"), known.split("_")
    if len(one) != len(other):
        return True
    pairs = [(a, b) for a, b in zip(one, other, strict=True) if a != b]
    return any(len(a) > SHORT or len(b) > SHORT for a, b in pairs)
