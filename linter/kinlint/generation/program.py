"""A program for a model: its statements rewritten, framed, arranged and rendered."""

from __future__ import annotations

import json
import os
from collections.abc import Callable, Iterable, Mapping, Sequence
from pathlib import Path
from typing import Any, TypeAlias

from kinlint.addresses import DOCUMENT, document_iri
from kinlint.engine.store import Store
from kinlint.errors import UsageError
from kinlint.facts.fact_context import FactContext
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.files.pathglob import absolute
from kinlint.formats.jsonld.framing import tree
from kinlint.generation.library_rewriting import rewritten
from kinlint.generation.program_statements import FILE, FIXED, NAMED, ModelStatements
from kinlint.resources import data
from kinlint.rule import PROGRAMS, Rule, Severity
from kinlint.terms import Term, Triple, is_iri, literal

Node: TypeAlias = dict[str, Any]
REQUIRED = frozenset((PROGRAMS, "ALG", "FRM", "ID", "INE", "LD", "SRC", "TOP", "UNI"))
"""The families of rules about what the numbers of a program depend on."""
SLOTS = ("first", "second", "out")
"""The poses of operators."""


def rule_files() -> Path:
    """Return the directory of the rules of what programs need."""
    return data("shapes") / "generation" / "rules"


def required_codes(rules: Iterable[Rule]) -> frozenset[str]:
    """Return the codes of those of *rules* whose errors forbid a program, whatever is selected."""
    return frozenset(
        each.code
        for each in rules
        if each.family in REQUIRED
        and each.severity >= Severity.ERROR
        and not (each.optional or each.preview or each.targets)
    )


def abilities(library: str) -> Path:
    """Return the file that says what programs for *library* can do."""
    shapes = data("shapes")
    consumer = shapes / "targets" / f"{library}.ttl"
    return consumer if consumer.exists() else shapes / "generation" / library / "library.ttl"


def rewritten_for(
    library: str, model: Store, names: Callable[[Sequence[Term]], Mapping[Term, str]]
) -> Sequence[Triple]:
    """Return the statements of a program for *model*, which is closed and fit for *library*."""
    numbers = ModelStatements(FactContext(PredicateIndex(model)), names)
    return _portable(rewritten(model, numbers, library), numbers.files)


def framed(statements: Iterable[Triple]) -> Node:
    """Return the tree of *statements* that templates are given.

    Raises `UsageError` where there is neither a chain nor a schedule.
    """
    frame = (data("shapes") / "generation" / "frame.json").read_text(encoding="utf-8")
    found = arranged(tree(statements, json.loads(frame)))
    if not (found["joint"] or found["schedule"]):
        raise UsageError("no joints and no schedule, so there is nothing to generate")
    return found


def _portable(statements: Iterable[Triple], files: Sequence[str]) -> Sequence[Triple]:
    """Return *statements* with *files* named as seen from the directory that all are below.

    So programs are the same wherever they are generated from.
    """
    paths = [absolute(each) for each in files]
    home = os.path.commonpath([each.parent for each in paths])
    places = [each.relative_to(home).as_posix() for each in paths]
    names = {literal(old): literal(new) for old, new in zip(files, places, strict=True)}
    documents = {
        document_iri(old)[1:-1]: document_iri(new)[1:-1]
        for old, new in zip(files, places, strict=True)
    }

    def renamed(node: Term) -> Term:
        place, sharp, rest = node[1:].partition("#")
        return f"{node[0]}{documents.get(place, place)}{sharp}{rest}" if sharp else node

    def renamed_value(predicate: Term, value: Term) -> Term:
        if predicate == FILE:
            return names.get(value, value)
        if predicate == NAMED:
            return renamed(value).replace(f'"{DOCUMENT}', '"', 1)
        return renamed(value) if is_iri(value) else value

    return sorted((renamed(s), p, renamed_value(p, o)) for s, p, o in statements)


def arranged(found: Mapping[str, Any]) -> Node:
    """Return the tree *found* with its parts in order, and what each position moves.

    A joint that follows others has the position that it follows in the end, and the line by which
    it does so.
    """
    program: Node = {
        **found,
        **{
            name: sorted(found.get(name) or (), key=lambda each: each.get("order", each["@id"]))
            for name in ("body", "joint", "pose", "input", "schedule")
        },
    }
    for schedule in program["schedule"]:
        schedule["step"].sort(key=lambda each: each["order"])
        operators = [each["operator"] for each in schedule["step"]]
        used = {each[slot] for each in operators for slot in SLOTS if slot in each}
        schedule["pose"] = [each for each in program["pose"] if each["@id"] in used]
        taken = {each["at"] for each in operators if "at" in each}
        schedule["input"] = [each for each in program["input"] if each["@id"] in taken]
    for body in program["body"]:
        body.setdefault("inertia", None)
    bodies = {each["@id"]: each for each in program["body"]}
    joints = {each["@id"]: each for each in program["joint"]}
    chosen = set(found.get("position") or ())
    program["positions"] = [each for each in program["joint"] if each["@id"] in chosen]
    index = {each["@id"]: number for number, each in enumerate(program["positions"])}
    for joint in program["joint"]:
        joint["parent_name"] = bodies[joint["parent"]]["name"]
        joint["child_name"] = bodies[joint["child"]]["name"]
        joint.setdefault("axis", None)
        leader, joint["factor"], joint["shift"] = joint["@id"], 1.0, 0.0
        if joint["motion"] == FIXED:
            continue
        for _ in joints:
            if (followed := joints[leader].get("leader")) is None:
                break
            joint["shift"] += joint["factor"] * joints[leader]["offset"]
            joint["factor"] *= joints[leader]["multiplier"]
            leader = followed
        joint["index"] = index[leader]
    return program
