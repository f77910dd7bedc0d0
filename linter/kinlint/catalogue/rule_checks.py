"""Checks of rule and shapes files before they are compiled: what they name exists."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from kinlint.catalogue.term_checks import Fault, term_faults
from kinlint.catalogue.variable_checks import variable_faults
from kinlint.engine.compiler.shacl_terms import RULE_CLASS, TYPE, sh
from kinlint.engine.compiler.shapes_graph import ShapesFile
from kinlint.errors import RuleInvalid
from kinlint.formats.records import BY_NAME
from kinlint.suggestion import did_you_mean
from kinlint.terms import iri, literal_value
from kinlint.vocabulary import KL, RDFS

FORMATS = ("graph", *BY_NAME)
"""Values of `kl:format`."""
CODE = re.compile(r"[A-Z]{1,8}[0-9]{3}")
"""The form of the code of a rule."""
TARGETS = ("targetClass", "targetSubjectsOf", "targetObjectsOf", "targetNode", "target")
"""Properties of SHACL that say what a shape is about (SHACL 2.1.3)."""
CONSTRAINTS = ("sparql", "property", "node", "not", "and", "or", "xone", "nodeKind", "closed")
"""Properties of SHACL by which a rule has a check; those that the program checks have none."""
CLASS = iri(f"{RDFS}Class")


def check(file: ShapesFile, prefixes: Mapping[str, str]) -> None:
    """Raise `RuleInvalid` if *file* names what does not exist, a line for each fault.

    Its queries may use *prefixes*.
    """
    found = sorted({*term_faults(file, prefixes), *_rule_faults(file)})
    found = found or sorted(set(variable_faults(file, prefixes)))
    if found:
        raise RuleInvalid("\n".join(f"{file.name}:{placed(file, each)}" for each in found))


def placed(file: ShapesFile, fault: Fault) -> str:
    """Return *fault* with its line in *file* before it."""
    line = file.text.count("\n", 0, fault.offset) + 1
    return f"{line}: {fault.text}"


def _rule_faults(file: ShapesFile) -> Iterator[Fault]:
    """Yield what is wrong with the formats, the code and the targets of the rules of *file*."""
    rules = {s for s, p, o in file.triples if (p, o) == (TYPE, RULE_CLASS)}
    aimed = {s for s, p, _ in file.triples if p in set(map(sh, TARGETS))}
    classes = {s for s, p, o in file.triples if (p, o) == (TYPE, CLASS)}
    checked = {s for s, p, _ in file.triples if p in set(map(sh, CONSTRAINTS))}
    if (rules & checked) - aimed - classes:
        ways = ", ".join(f"sh:{each}" for each in TARGETS[:3])
        yield Fault(_place(file, "kl:Rule"), f"the rule has no target: {ways} or sh:targetNode")
    for subject, way, value in file.triples:
        if not value.startswith('"'):
            continue
        text = literal_value(value)
        if way == iri(f"{KL}format") and text not in FORMATS:
            fault = f"kl:format: no format is called '{text}'{did_you_mean(text, FORMATS)}"
            yield Fault(_place(file, f'"{text}"'), fault)
        if subject in rules and way == iri(f"{KL}code") and not CODE.fullmatch(text):
            fault = f"kl:code '{text}' is not one to eight capitals and three digits: ACME001"
            yield Fault(_place(file, f'"{text}"'), fault)


def _place(file: ShapesFile, word: str) -> int:
    """Return the offset of the first *word* in *file*."""
    return max(file.text.find(word), 0)
