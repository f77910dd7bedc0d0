"""The catalogue ready to run: rules, compiled constraints and axioms, cached between runs."""

from __future__ import annotations

import hashlib
import os
import re
from collections.abc import Iterable, Iterator, Sequence
from functools import cache as memoised
from functools import cached_property
from pathlib import Path
from typing import Any

from kinlint import __version__, resources
from kinlint.catalogue.compiled_store import CompiledCatalogue, newest
from kinlint.catalogue.deferred import Deferred, heads
from kinlint.engine.axioms import Axiom
from kinlint.engine.compiled_lifting import RECALLED
from kinlint.engine.constraint import Constraint
from kinlint.errors import RuleInvalid
from kinlint.installation import Installation
from kinlint.light_dataclasses import asdict, dataclass, field
from kinlint.rule import SEVERITY_BY_IRI, Rule, Severity
from kinlint.terms import RDF_TYPE, Term, is_blank, is_iri
from kinlint.vocabulary import FACT, SRC

PREFIXES = "prefixes.ttl"
SHIPPED = Path(__file__).parent / "compiled"
"""The directory of a wheel with the compiled built-in catalogue; a checkout has none."""

ASKED = 2
"""The number of catalogues of a cache, the newest, that are asked for units of another set."""
CODE = ("rule.py", "terms.py", "vocabulary.py", "facts/fact_kinds.py", "formats/records.py")
"""Modules outside the packages that compile which decide what is compiled, too."""
OWN = (f"<{SRC}", f"<{FACT}")
"""The beginnings of terms by which kinlint itself describes a model."""


@dataclass(frozen=True)
class Rulebook:
    """The rules of a run, with all that is compiled of them and of the vocabulary."""

    rules: tuple[Rule, ...]
    """Rules, sorted by code."""
    constraints: Sequence[Constraint]
    """The constraints of all rules and shapes."""
    axioms: tuple[Axiom, ...]
    """The axioms of the vocabulary, in order of evaluation."""
    vocabulary: tuple[Path, ...]
    """The Turtle files that are loaded with the data."""
    shapes: Sequence[Path]
    """All files that hold constraints, with the prefixes that their queries use."""
    digest: str = ""
    """The digest of all that was compiled; empty where nothing was."""
    recalled: bool = field(default=False, compare=False)
    """Nothing had to be compiled."""
    installation: Installation = field(default_factory=Installation, compare=False, repr=False)
    """The files of kinlint when the rules were loaded."""

    @cached_property
    def terms(self) -> frozenset[Term]:
        """The classes and properties that constraints match."""
        patterns = (pattern for each in self.constraints for pattern in each.premises)
        terms = {term for pattern in patterns for term in pattern if is_iri(term)}
        return frozenset(term for term in terms if term != RDF_TYPE and not term.startswith(OWN))

    @cached_property
    def by_iri(self) -> dict[str, Rule]:
        """Rules by IRI, as constraints name their owner."""
        return {rule.iri: rule for rule in self.rules}

    @cached_property
    def by_code(self) -> dict[str, Rule]:
        """Rules by code."""
        return {rule.code: rule for rule in self.rules}

    @cached_property
    def by_name(self) -> dict[str, Rule]:
        """Rules by name."""
        return {rule.name: rule for rule in self.rules}

    def constraints_of(self, owner: str) -> tuple[Constraint, ...]:
        """Return the constraints of the rule with the IRI *owner*; no other is decoded."""
        numbered = enumerate(heads(self.constraints))
        return tuple(self.constraints[index] for index, head in numbered if head.owner == owner)


def load(
    rules: Sequence[Path] = (), shapes: Sequence[Path] = (), cache: Path | None = None
) -> Rulebook:
    """Return the built-in catalogue with the rule files below *rules* and the SHACL files *shapes*.

    What these files say besides is vocabulary too: axioms are compiled with those of the ontology,
    and everything else is there for queries. Nothing that they import is read.

    *cache* is a directory for compiled catalogues; None keeps none. Files that one of them has
    compiled already are not compiled again: the built-in ones are kept first, whatever a mistake in
    another file then ends. Raises `RuleInvalid`.
    """
    ours = resources.data("shapes")
    installation = Installation()
    parts = _parts(installation, rules, shapes)
    code = installation.digest("compiler", cache, _code)
    if rules or shapes:
        digest = _digest(parts, code)
    else:
        digest = installation.digest("catalogue", cache, lambda: _digest(parts, code))
    name = f"catalogue-{digest}.jsonl"
    places = [SHIPPED, *([cache] if cache is not None else [])]
    kept = (CompiledCatalogue.from_file(place / name) for place in places)
    compiled = next(filter(None, kept), None)
    constrained = (*parts.files, *parts.extra)
    homes = {_stem(file): file for file in (*parts.extra[::-1], *reversed(parts.files))}
    recalled = compiled is not None
    if compiled is None:
        if cache is not None and (rules or shapes):
            load(cache=cache)
        units = _compile(parts, places, code)
        compiled = CompiledCatalogue.from_units(units, code)
    found = compiled.rules(homes)
    if not recalled:
        _distinct(found)
        if cache is not None:
            compiled.keep(cache / name)
    RECALLED.update(compiled.queries)
    return Rulebook(
        rules=tuple(sorted(found, key=lambda rule: rule.code)),
        constraints=compiled.constraints,
        axioms=compiled.axioms,
        vocabulary=(*map(Path, parts.ontology), *map(Path, parts.others)),
        shapes=Deferred(lambda: (ours / PREFIXES, *map(Path, constrained))),
        digest=digest,
        recalled=recalled,
        installation=installation,
    )


@dataclass(frozen=True)
class _Parts:
    """The paths of the files of a catalogue."""

    files: tuple[str, ...]
    """Rules."""
    extra: tuple[str, ...]
    """Plain shapes."""
    ontology: tuple[str, ...]
    """Vocabulary of kinlint's own."""
    others: tuple[str, ...]
    """Further vocabulary: the files that are not kinlint's own."""
    lifting: tuple[str, ...]
    """Lifting queries."""

    @property
    def inputs(self) -> Iterator[Path]:
        """All files that decide what the catalogue is."""
        yield resources.data("shapes") / PREFIXES
        yield from map(Path, (*self.ontology, *self.files, *self.extra, *self.lifting))


def _parts(installation: Installation, rules: Sequence[Path], shapes: Sequence[Path]) -> _Parts:
    ours = resources.data("shapes")
    shipped = installation.paths_below(resources.data("rules"), ".ttl")
    given = tuple(map(str, _rule_files(rules)))
    extra = tuple(map(str, _existing(shapes)))
    own = (installation.paths_below(ours / name, ".ttl") for name in ("ontology", "units"))
    return _Parts(
        files=(*_others(shipped, given), *given),
        extra=extra,
        ontology=tuple(file for files in own for file in files),
        others=(*_others(given, shipped), *extra),
        lifting=tuple(installation.paths_below(ours / "lifting", ".rq")),
    )


def built_in() -> tuple[str, int]:
    """Return the digest of the built-in catalogue, and the number of its rules."""
    parts = _parts(Installation(), (), ())
    return _digest(parts, _code()), len(parts.files)


def _compile(parts: _Parts, places: Iterable[Path], code: str) -> dict[str, Any]:
    """Return *parts* compiled by *code*, or as the catalogues in *places* have them."""
    from kinlint.catalogue.rule_compiler import Units  # noqa: PLC0415

    stored = [each for place in places for each in newest(place)[:ASKED]]
    kept = filter(None, map(CompiledCatalogue.from_file, stored))
    known = (unit for each in kept for unit in each.units(code))
    units = Units(known, code, resources.data("shapes") / PREFIXES)
    made = units.compiled([*map(Path, parts.files), *map(Path, parts.extra)])
    constraints = [Constraint.from_json(each) for unit in made for each in unit["constraints"]]
    owners = {rule["iri"] for unit in made for rule in unit["rules"]}
    found = {each.owner: number for number, each in reversed([*enumerate(constraints)])}
    strangers = sorted(
        found.keys() - owners, key=lambda owner: (found[owner] if is_blank(owner) else -1, owner)
    )
    shapes = [_shape_rule(number, owner, constraints) for number, owner in enumerate(strangers, 1)]
    return {
        "units": made,
        "shapes": {"rules": [asdict(each) for each in shapes]},
        "axioms": units.axioms([*map(Path, parts.ontology)], map(Path, parts.others)),
        "lifting": units.lifting([*map(Path, parts.lifting)]),
    }


def _shape_rule(number: int, owner: str, constraints: Iterable[Constraint]) -> Rule:
    """Return a rule that stands for a user's shape, which says nothing of codes and reasons."""
    own = [each for each in constraints if each.owner == owner]
    local = re.split(r"[#/:]", owner.rstrip("#/"))[-1]
    name = re.sub(r"[^a-z0-9]+", "-", re.sub(r"(?<=[a-z0-9])(?=[A-Z])", "-", local).lower())
    return Rule(
        iri=owner,
        code=f"SHACL{number:03}",
        name=name.strip("-") or f"shape-{number}",
        title=f"violation of shape {local}",
        why=f"The SHACL shape {owner} was given with the run and does not hold.",
        severity=max(SEVERITY_BY_IRI.get(each.severity, Severity.ERROR) for each in own),
        links=(owner,) if "://" in owner else (),
        messages=tuple(sorted({text for each in own for text in each.messages})),
    )


def _distinct(rules: Iterable[Rule]) -> None:
    seen: dict[str, Rule] = {}
    for rule in rules:
        for identity in (rule.code, rule.name):
            other = seen.setdefault(identity, rule)
            if other is not rule:
                raise RuleInvalid(f"{rule.path}: {identity} is taken by {other.path}")


def _turtle(directory: Path) -> list[Path]:
    return sorted(directory.rglob("*.ttl"))


def _rule_files(given: Iterable[Path]) -> Iterator[Path]:
    for path in _existing(given):
        yield from _turtle(path) if path.is_dir() else [path]


def _others(files: Sequence[str], given: Sequence[str]) -> Iterator[str]:
    """Yield those *files* that are not *given* as well, by the same path or as a copy."""
    if not given:
        yield from files
        return
    named = {os.path.basename(file): file for file in given}  # noqa: PTH119  texts
    for file in files:
        twin = named.get(os.path.basename(file))  # noqa: PTH119
        if twin is None or Path(twin).read_bytes() != Path(file).read_bytes():
            yield file


def _stem(path: str) -> str:
    """Return the name of the file *path* without its suffix."""
    return os.path.splitext(os.path.basename(path))[0]  # noqa: PTH119, PTH122  texts


def _existing(given: Iterable[Path]) -> Iterator[Path]:
    for path in given:
        if not path.exists():
            raise RuleInvalid(f"{path}: no such rule or shapes file")
        yield path


def _digest(parts: _Parts, code: str) -> str:
    """Return what decides the compiled catalogue: *parts*, and the *code* that compiles them."""
    digest = hashlib.sha256(code.encode())
    for file in parts.inputs:
        name = f"{file.parent.name}/{file.name}" if file.suffix == ".rq" else file.name
        digest.update(f"\0{name}\0".encode())
        digest.update(file.read_bytes())
    return digest.hexdigest()[:24]


@memoised
def _code() -> str:
    """Return what stands for the code that compiles rules and says what they are."""
    package = Path(__file__).parents[1]
    folders = ("catalogue/*.py", "engine/**/*.py", "sparql/*.py")
    extra = (package / name for name in CODE)
    files = [each for pattern in folders for each in package.glob(pattern)]
    digest = hashlib.sha256(__version__.encode())
    for file in sorted([*files, *extra]):
        digest.update(f"\0{file.name}\0".encode())
        digest.update(file.read_bytes())
    return digest.hexdigest()[:24]
