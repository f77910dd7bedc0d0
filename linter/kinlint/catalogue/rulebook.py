"""The catalogue ready to run: rules, compiled constraints and axioms, cached between runs."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterable, Iterator, Sequence
from functools import cache as memoised
from functools import cached_property
from pathlib import Path
from typing import Any, NamedTuple

from kinlint import __version__, resources
from kinlint.catalogue.compiled_store import CompiledCatalogue, newest
from kinlint.catalogue.deferred import heads
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
    shapes: tuple[Path, ...]
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
    files, extra, ontology, others, lifting, inputs = _parts(installation, rules, shapes)
    code = installation.digest("compiler", cache, _code)
    if rules or shapes:
        digest = _digest(inputs, code)
    else:
        digest = installation.digest("catalogue", cache, lambda: _digest(inputs, code))
    name = f"catalogue-{digest}.jsonl"
    places = [SHIPPED, *([cache] if cache is not None else [])]
    kept = (CompiledCatalogue.from_file(place / name) for place in places)
    compiled = next(filter(None, kept), None)
    homes = {file.stem: str(file) for file in (*extra[::-1], *reversed(files))}
    recalled = compiled is not None
    if compiled is None:
        if cache is not None and (rules or shapes):
            load(cache=cache)
        units = _compile((*files, *extra), (ontology, others), lifting, places, code)
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
        vocabulary=(*ontology, *others),
        shapes=(ours / PREFIXES, *files, *extra),
        digest=digest,
        recalled=recalled,
        installation=installation,
    )


class _Parts(NamedTuple):
    """The files of a catalogue."""

    files: tuple[Path, ...]
    """Rules."""
    extra: tuple[Path, ...]
    """Plain shapes."""
    ontology: tuple[Path, ...]
    """Vocabulary of kinlint's own."""
    others: tuple[Path, ...]
    """Further vocabulary: the files that are not kinlint's own."""
    lifting: tuple[Path, ...]
    """Lifting queries."""
    inputs: tuple[Path, ...]
    """All files that decide what the catalogue is."""


def _parts(installation: Installation, rules: Sequence[Path], shapes: Sequence[Path]) -> _Parts:
    ours = resources.data("shapes")
    shipped = installation.paths_below(resources.data("rules"), ".ttl")
    given = tuple(_rule_files(rules))
    files = (*_others(shipped, given), *given)
    extra = tuple(_existing(shapes))
    own = (installation.paths_below(ours / name, ".ttl") for name in ("ontology", "units"))
    ontology = tuple(file for files in own for file in files)
    others = (*_others(given, shipped), *extra)
    lifting = tuple(installation.paths_below(ours / "lifting", ".rq"))
    inputs = (ours / PREFIXES, *ontology, *files, *extra, *lifting)
    return _Parts(files, extra, ontology, others, lifting, inputs)


def built_in() -> tuple[str, int]:
    """Return the digest of the built-in catalogue, and the number of its rules."""
    parts = _parts(Installation(), (), ())
    return _digest(parts.inputs, _code()), len(parts.files)


def _compile(
    files: Sequence[Path],
    vocabulary: tuple[Sequence[Path], Sequence[Path]],
    lifting: Sequence[Path],
    places: Iterable[Path],
    code: str,
) -> dict[str, Any]:
    """Return *files*, *vocabulary* and the queries *lifting* compiled by *code*.

    What the catalogues in *places* have is taken from there.
    """
    from kinlint.catalogue.rule_compiler import Units  # noqa: PLC0415

    stored = [each for place in places for each in newest(place)[:ASKED]]
    kept = filter(None, map(CompiledCatalogue.from_file, stored))
    known = (unit for each in kept for unit in each.units(code))
    units = Units(known, code, resources.data("shapes") / PREFIXES)
    made = units.compiled(files)
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
        "axioms": units.axioms(*vocabulary),
        "lifting": units.lifting(lifting),
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


def _others(files: Iterable[Path], given: Sequence[Path]) -> Iterator[Path]:
    """Yield those *files* that are not *given* as well, by the same path or as a copy."""
    named = {file.name: file for file in given}
    for file in files:
        twin = named.get(file.name)
        if twin is None or twin.read_bytes() != file.read_bytes():
            yield file


def _existing(given: Iterable[Path]) -> Iterator[Path]:
    for path in given:
        if not path.exists():
            raise RuleInvalid(f"{path}: no such rule or shapes file")
        yield path


def _digest(inputs: Iterable[Path], code: str) -> str:
    """Return what decides the compiled catalogue: the files, and the *code* that compiles them."""
    digest = hashlib.sha256(code.encode())
    for file in inputs:
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
