"""The W3C SHACL test suite: its manifests, and a comparison of validation reports."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path
from typing import NamedTuple

import pyoxigraph as ox

from kinlint.engine.compiler.shapes_graph import ShapesGraph, read
from kinlint.engine.result import Result
from kinlint.terms import RDF_TYPE, Term, Triple, iri_value, literal_value
from kinlint.vocabulary import SH

MF = "http://www.w3.org/2001/sw/DataAccess/tests/test-manifest#"
SHT = "http://www.w3.org/ns/shacl-test#"


class Report(NamedTuple):
    """One validation result, as far as the suite compares it."""

    focus: Term
    path: Term | None
    value: Term | None
    shape: Term
    component: str
    severity: str


@dataclass(frozen=True)
class Case:
    """One test of the suite: two files, and the report or the failure that is right."""

    name: str
    file: Path

    @cached_property
    def manifest(self) -> ShapesGraph:
        return read([self.file])

    @cached_property
    def test(self) -> Term:
        return self.manifest.referrers(RDF_TYPE, f"<{SHT}Validate>")[0]

    def _file(self, name: str) -> Path:
        (action,) = self.manifest.values(self.test, f"<{MF}action>")
        (file,) = self.manifest.values(action, f"<{SHT}{name}>")
        return Path(iri_value(file).removeprefix("file://"))

    @property
    def shapes(self) -> Path:
        return self._file("shapesGraph")

    @property
    def data(self) -> tuple[Triple, ...]:
        return read([self._file("dataGraph")]).files[0].triples

    @property
    def fails(self) -> bool:
        return self._result == f"<{SHT}Failure>"

    @property
    def _result(self) -> Term:
        (result,) = self.manifest.values(self.test, f"<{MF}result>")
        return result

    @property
    def expected(self) -> Counter[Report]:
        return Counter(self._report(each) for each in self._results)

    @property
    def messages(self) -> set[str]:
        """The texts of all messages that the expected report names."""
        return {
            literal_value(message)
            for each in self._results
            for message in self.manifest.values(each, f"<{SH}resultMessage>")
        }

    @property
    def _results(self) -> list[Term]:
        return self.manifest.values(self._result, f"<{SH}result>")

    def _report(self, node: Term) -> Report:
        def one(name: str) -> Term | None:
            return self.manifest.one(node, f"<{SH}{name}>")

        path = one("resultPath")
        return self._plain(
            Report(
                focus=one("focusNode") or "",
                path=None if path is None or path.startswith("_:") else path,
                value=one("value"),
                shape=one("sourceShape") or "",
                component=iri_value(one("sourceConstraintComponent") or ""),
                severity=iri_value(one("resultSeverity") or ""),
            )
        )

    def reported(self, results: Iterable[Result]) -> Counter[Report]:
        """*results* in the form of `expected`."""
        return Counter(
            self._plain(
                Report(
                    focus=each.focus,
                    path=each.path,
                    value=each.value,
                    shape=each.constraint.shape,
                    component=each.constraint.component,
                    severity=each.constraint.severity,
                )
            )
            for each in results
        )

    def _plain(self, report: Report) -> Report:
        """*report* without labels of blank nodes that stand in another file."""
        same = self.file == self.shapes
        terms = [normal(term) if term else None for term in report[:4]]
        if not same:
            terms = ["_:" if term and term.startswith("_:") else term for term in terms]
        focus, path, value, shape = terms
        return Report(focus or "", path, value, shape or "", *report[4:])


def normal(term: Term) -> Term:
    """*term* as a store gives it back."""
    if not term.startswith('"'):
        return term
    store = ox.Store()
    store.load(f"<any:> <any:> {term} .".encode(), ox.RdfFormat.N_TRIPLES)
    return str(next(iter(store)).object)


def cases(suite: Path) -> list[Case]:
    """Every test of *suite*, by its path below it."""
    files = sorted(suite.rglob("*.ttl"))
    return [
        Case(str(file.relative_to(suite).with_suffix("")), file)
        for file in files
        if file.name != "manifest.ttl" and "sht:Validate" in file.read_text("utf-8")
    ]
