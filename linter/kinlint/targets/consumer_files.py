"""Reads consumers, features and behaviours from the Turtle files of `shapes/targets`."""

from __future__ import annotations

from collections import defaultdict
from collections.abc import Iterator
from functools import cache
from pathlib import Path

import pyoxigraph as ox

from kinlint import resources
from kinlint.rule import SEVERITY_BY_IRI
from kinlint.targets.consumer import (
    Alternative,
    Behaviour,
    Cell,
    Consumer,
    ConsumerTable,
    Feature,
    Parser,
)
from kinlint.targets.version_range import VersionRange, read_version
from kinlint.vocabulary import FEATURE, RDFS, RULE, SH, TARGET

TYPE = "http://www.w3.org/1999/02/22-rdf-syntax-ns#type"


@cache
def consumer_table() -> ConsumerTable:
    """Return what the files of this installation say."""
    return read_consumers(resources.data("shapes") / "targets")


def read_consumers(directory: Path) -> ConsumerTable:
    """Return what the files below *directory* say: one for each consumer, and the vocabulary."""
    return _Reader(sorted(directory.rglob("*.ttl"))).table()


class _Reader:
    """A reader of the statements of *files*."""

    def __init__(self, files: list[Path]) -> None:
        self._said: dict[tuple[str, str], list[str]] = defaultdict(list)
        for file in files:
            for quad in ox.parse(path=file, format=ox.RdfFormat.TURTLE):
                said = str(quad.subject), quad.predicate.value
                self._said[said].append(getattr(quad.object, "value", str(quad.object)))
                if isinstance(quad.object, ox.BlankNode):
                    self._said[said][-1] = str(quad.object)

    def table(self) -> ConsumerTable:
        features = map(self._feature, self._of_class("Feature"))
        self._behaviours = {
            node[1:-1]: self._behaviour(node) for node in self._of_class("Behaviour")
        }
        consumers = map(self._consumer, self._of_class("Consumer"))
        return ConsumerTable(
            {each.name: each for each in sorted(consumers, key=lambda one: one.name)},
            {each.name: each for each in sorted(features, key=lambda one: one.name)},
        )

    def _of_class(self, name: str) -> list[str]:
        wanted = f"{TARGET}{name}"
        return [
            subject
            for (subject, predicate), values in self._said.items()
            if predicate == TYPE and wanted in values
        ]

    def _all(self, node: str, name: str) -> tuple[str, ...]:
        prefix, _, local = name.rpartition(":")
        home = {"rdfs": RDFS, "sh": SH, "": TARGET}[prefix]
        return tuple(self._said.get((node, home + local), ()))

    def _one(self, node: str, name: str) -> str:
        return " ".join(next(iter(self._all(node, name)), "").split())

    def _versions(self, node: str) -> VersionRange:
        return VersionRange(self._one(node, "since"), self._one(node, "until"))

    def _behaviour(self, node: str) -> Behaviour:
        return Behaviour(
            _local(node, TARGET),
            self._one(node, "rdfs:label"),
            self._one(node, "outcome"),
            SEVERITY_BY_IRI.get(self._one(node, "sh:severity")),
            self._one(node, "mark"),
        )

    def _feature(self, node: str) -> Feature:
        ways = sorted(
            (self._one(each, "sh:order"), self._one(each, "rdfs:label"), self._one(each, "feature"))
            for each in self._all(node, "alternative")
        )
        return Feature(
            _local(node, FEATURE),
            self._one(node, "rdfs:label"),
            self._one(node, "rdfs:comment"),
            tuple(Alternative(label, feature.removeprefix(FEATURE)) for _, label, feature in ways),
            narrows=self._one(node, "narrows").removeprefix(FEATURE),
            formats=frozenset(self._all(node, "format")),
            told_by=frozenset(each.removeprefix(RULE) for each in self._all(node, "toldBy")),
            query=next(iter(self._all(node, "sh:select")), ""),
        )

    def _consumer(self, node: str) -> Consumer:
        return Consumer(
            name=_local(node, TARGET),
            label=self._one(node, "rdfs:label"),
            comment=self._one(node, "rdfs:comment"),
            formats=tuple(sorted(self._all(node, "format"))),
            releases=tuple(sorted(self._all(node, "release"), key=read_version)),
            cells=tuple(sorted(self._cells(node), key=_place)),
            parsers=tuple(sorted(self._parsers(node), key=lambda one: _rank(one.versions))),
            members=tuple(sorted(_local(f"<{each}>", TARGET) for each in self._all(node, "has"))),
            links=tuple(sorted(self._all(node, "rdfs:seeAlso"))),
        )

    def _cells(self, node: str) -> Iterator[Cell]:
        for each in self._all(node, "cell"):
            for feature in self._all(each, "feature"):
                yield Cell(
                    feature=feature.removeprefix(FEATURE),
                    behaviour=self._behaviours[self._one(each, "behaviour")],
                    versions=self._versions(each),
                    into=self._one(each, "into"),
                    outcome=self._one(each, "outcome"),
                    measured=tuple(sorted(self._all(each, "measured"), key=read_version)),
                    sources=tuple(sorted(self._all(each, "rdfs:seeAlso"))),
                    comment=self._one(each, "rdfs:comment"),
                    own_severity=SEVERITY_BY_IRI.get(self._one(each, "sh:severity")),
                )

    def _parsers(self, node: str) -> Iterator[Parser]:
        for each in self._all(node, "parser"):
            name = self._one(each, "consumer").removeprefix(TARGET)
            yield Parser(name, self._one(each, "version"), self._versions(each))


def _local(node: str, namespace: str) -> str:
    return node[1:-1].removeprefix(namespace)


def _rank(versions: VersionRange) -> tuple[int, ...]:
    return read_version(versions.since) if versions.since else ()


def _place(cell: Cell) -> tuple[str, tuple[int, ...]]:
    return cell.feature, _rank(cell.versions)
