"""Compile rule files one by one: each by itself, or together with those that it refers to."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence
from functools import cache
from hashlib import sha256
from pathlib import Path
from typing import Any, TypeAlias

from kinlint.catalogue.repair_file import prefixes as shared_prefixes
from kinlint.catalogue.rule_checks import check
from kinlint.catalogue.rule_file import stated_rules
from kinlint.engine.compiler.shacl_terms import IMPORTS, SUBCLASS, TYPE, sh
from kinlint.engine.compiler.shapes_compiler import compile_graph
from kinlint.engine.compiler.shapes_graph import FIRST, REST, ShapesFile, ShapesGraph, labels, parse
from kinlint.engine.lifting import compiled_queries
from kinlint.engine.ontology import compile_axioms
from kinlint.light_dataclasses import asdict, dataclass, replace
from kinlint.terms import RDF, Term, is_iri
from kinlint.vocabulary import OWL, RDFS, SH

Unit: TypeAlias = dict[str, Any]
"""A compiled file as JSON: its key, its links, its rules and its constraints."""
SHACL, UNTOLD = f"<{SH}", (f"<{SH}", f"<{RDF}")
"""The beginning of SHACL's terms, and those of terms by which no file refers to another."""
AXIOMATIC = {f"<{RDFS}{name}>" for name in ("subClassOf", "subPropertyOf", "domain", "range")}
SCHEMA = (f"<{OWL}", f"<{RDFS}")


@dataclass(frozen=True)
class Links:
    """The ways in which a file may refer to others."""

    defined: frozenset[Term]
    """IRIs that it says something of that the compiler reads: shapes, prefixes, parameters."""
    mentioned: frozenset[Term]
    """IRIs that its shapes may mean what another file defines by."""


def links(file: ShapesFile) -> Links:
    """Return the ways in which *file* may refer to others, and they to it."""
    parameters = {o for _, p, o in file.triples if p == sh("parameter")}
    defined = {
        s
        for s, p, o in file.triples
        if p.startswith(SHACL) or p in (IMPORTS, SUBCLASS) or (p == TYPE and o.startswith(SHACL))
    }
    defined |= {o for s, p, o in file.triples if p == sh("path") and s in parameters}
    mentioned = {term for _, p, o in file.triples for term in (p, o)}
    return Links(
        frozenset(filter(is_iri, defined)),
        frozenset(each for each in mentioned if is_iri(each) and not each.startswith(UNTOLD)),
    )


class Units:
    """Files as compiled, one by one."""

    def __init__(self, known: Iterable[Unit], code: str, prefixes: Path) -> None:
        """Begin with the *known*; *code* stands for what compiles, *prefixes* are in each unit."""
        self._known = {each["key"]: each for each in known}
        self._base = f"{code} {prefixes.read_text('utf-8')}".encode()
        self._prefixes = prefixes

    def compiled(self, files: Sequence[Path]) -> list[Unit]:
        """Return the units of *files*, in their order. Raises `RuleInvalid`.

        A file that refers to others, or they to it, is in one unit with them.
        """
        stems = labels([self._prefixes, *files])
        keys = {file: self._key(file, label) for file, label in zip(files, stems[1:], strict=True)}
        texts = dict(zip((self._prefixes, *files), stems, strict=True))

        @cache
        def read(file: Path) -> ShapesFile:
            return parse(file, texts[file])

        def links_of(file: Path) -> Links:
            unit = self._known.get(keys[file])
            return Links(*map(frozenset, unit["links"])) if unit else links(read(file))

        told = {file: links_of(file) for file in files}
        found = []
        for group in _groups(told):
            key = "-".join(keys[file] for file in group)
            if key not in self._known:
                shapes = [read(file) for file in group]
                self._known[key] = _unit(key, told[group[0]], read(self._prefixes), shapes)
            found.append(self._known[key])
        return found

    def axioms(self, ontology: Sequence[Path], others: Iterable[Path]) -> Unit:
        """Return the axioms of *ontology* and of what *others* say in the terms of one."""
        files = [*ontology, *(file for file in others if _has_axioms(parse(file)))]
        key = "-".join(["axioms", *(self._key(file, file.name) for file in files)])
        if key not in self._known:
            made = [axiom.to_json() for axiom in compile_axioms(files)]
            self._known[key] = {"key": key, "axioms": made}
        return self._known[key]

    def lifting(self, files: Iterable[Path]) -> Unit:
        """Return the lifting queries, whose *files* these are, as JSON by format."""
        own = "-".join(self._key(file, f"{file.parent.name}/{file.name}") for file in files)
        key = f"lifting-{sha256(own.encode()).hexdigest()[:24]}"
        if key not in self._known:
            self._known[key] = {"key": key, "queries": compiled_queries()}
        return self._known[key]

    def _key(self, file: Path, label: str) -> str:
        return sha256(b"\0".join((self._base, label.encode(), file.read_bytes()))).hexdigest()[:24]


def _unit(key: str, links: Links, prefixes: ShapesFile, files: Sequence[ShapesFile]) -> Unit:
    """Return *files* compiled. Raises `RuleInvalid`."""
    for file in files:
        check(file, shared_prefixes())
    rules = [rule for file in files for rule in stated_rules(file)]
    return {
        "key": key,
        "links": [sorted(links.defined), sorted(links.mentioned)],
        "rules": [asdict(replace(rule, path="")) for rule in rules],
        "constraints": [each.to_json() for each in compile_graph(ShapesGraph((prefixes, *files)))],
    }


def _groups(told: Mapping[Path, Links]) -> Iterator[tuple[Path, ...]]:
    """Yield the files of *told* that are linked, in groups, in the order of their first ones."""
    definers: dict[Term, list[Path]] = {}
    for file, each in told.items():
        for term in each.defined:
            definers.setdefault(term, []).append(file)
    joined: dict[Path, set[Path]] = {file: set() for file in told}
    for file, each in told.items():
        for term in (each.defined | each.mentioned) & definers.keys():
            for other in definers[term]:
                joined[file].add(other)
                joined[other].add(file)
    done: set[Path] = set()
    for file in told:
        group, waiting = set[Path](), [file]
        while waiting:
            if (one := waiting.pop()) not in group:
                group.add(one)
                waiting += joined[one]
        if file not in done:
            done |= group
            yield tuple(each for each in told if each in group)


def _has_axioms(file: ShapesFile) -> bool:
    """Return whether *file* says anything that axioms are made of."""
    return any(
        (p.startswith(f"<{OWL}") and p != IMPORTS)
        or p in AXIOMATIC
        or (p == TYPE and o.startswith(SCHEMA) and not o.endswith("#Ontology>"))
        or (p in (FIRST, REST) and is_iri(s))
        for s, p, o in file.triples
    )
