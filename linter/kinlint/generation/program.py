"""A program for a model: its statements rewritten, framed, arranged and rendered."""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping, Sequence
from pathlib import Path
from typing import Any, TypeAlias

from kinlint.engine.store import Store
from kinlint.errors import UsageError
from kinlint.facts.fact_context import FactContext
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.formats.jsonld.framing import tree
from kinlint.generation.library_rewriting import rewritten
from kinlint.generation.program_statements import FIXED, ModelStatements
from kinlint.generation.rendering import render
from kinlint.resources import data
from kinlint.terms import Term

Node: TypeAlias = dict[str, Any]
SLOTS = ("first", "second", "out")
"""The poses of operators."""


def constraints(library: str) -> tuple[Path, ...]:
    """Return the SHACL files that say what a program for *library* needs, and what it can do."""
    shapes = data("shapes")
    consumer = shapes / "targets" / f"{library}.ttl"
    own = consumer if consumer.exists() else shapes / "generation" / library / "shapes.ttl"
    return shapes / "generation" / "model.ttl", own


def generate(
    model: Store,
    names: Callable[[Sequence[Term]], Mapping[Term, str]],
    library: str,
    templates: Path | None = None,
) -> Mapping[str, str]:
    """Return the files of a program for *model*, which is closed and fit for *library*, by name.

    Raises `UsageError` where there is neither a chain nor a schedule.
    """
    numbers = ModelStatements(FactContext(PredicateIndex(model)), names)
    quads = rewritten(model, numbers, library)
    frame = (data("shapes") / "generation" / "frame.json").read_text(encoding="utf-8")
    found = arranged(tree(quads, json.loads(frame)))
    if not found["joint"]:
        raise UsageError("no joints, so there is nothing to generate")
    return render(found, library, templates)


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
        for _ in joints:
            if (followed := joints[leader].get("leader")) is None:
                break
            joint["shift"] += joint["factor"] * joints[leader]["offset"]
            joint["factor"] *= joints[leader]["multiplier"]
            leader = followed
        if joint["motion"] != FIXED:
            joint["index"] = index[leader]
    return program
