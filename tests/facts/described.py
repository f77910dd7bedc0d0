"""What is computed from robots that are written in URDF, for tests."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from support.linting import book, document

from kinlint.engine.closure import close
from kinlint.engine.lifting import lift
from kinlint.engine.store import Store
from kinlint.facts.computation import facts
from kinlint.terms import is_literal, literal_value
from kinlint.vocabulary import FACT

BOX = '<collision><geometry><box size="{}"/></geometry></collision>'


def store_of(*parts: str) -> Store:
    """A closed store of one robot with *parts*."""
    return closed({"arm.urdf": f'<robot name="arm" version="1.2">{"".join(parts)}</robot>'})


def closed(texts: Mapping[str, str]) -> Store:
    """A store of all *texts* by file name, lifted and closed under the axioms."""
    store = Store()
    store.load([document(text, name) for name, text in texts.items()])
    store.load_vocabulary(book().vocabulary)
    lift(store)
    close(store, book().axioms)
    return store


def found(name: str, *parts: str) -> list[tuple[str, Any]]:
    """The facts called *name* of a robot: subject and value, by their addresses, in order."""
    return sorted(
        (_local(s), float(literal_value(o)) if '"^^' in o else _local(o))
        for s, p, o in facts(store_of(*parts))
        if p == f"<{FACT}{name}>"
    )


def amended(kind: str, *parts: str) -> dict[str, float]:
    """What could be written instead of the entries of the only inertia of a robot."""
    told = {(s, p): o for s, p, o in facts(store_of(*parts))}
    kinds = f"urn:kinlint:fact:{kind}:"
    return {
        _local(entry): float(literal_value(told[node, f"<{FACT}amended>"]))
        for (node, p), entry in told.items()
        if p == f"<{FACT}entry>" and kinds in node
    }


def _local(term: str) -> str:
    return literal_value(term) if is_literal(term) else term.partition("#")[2][:-1].lstrip("/")


def link(name: str, *inner: str) -> str:
    """A link."""
    return f'<link name="{name}">{"".join(inner)}</link>'


def joint(name: str, parent: str, child: str, kind: str = "continuous", *inner: str) -> str:
    """A joint between two links."""
    ends = f'<parent link="{parent}"/><child link="{child}"/>'
    return f'<joint name="{name}" type="{kind}">{ends}{"".join(inner)}</joint>'


def inertial(mass: float = 1.0, moment: float = 0.01, other: float | None = None) -> str:
    """An inertia with moments *moment*, the last of which may be another."""
    last = moment if other is None else other
    return (
        f'<inertial><mass value="{mass}"/><inertia ixx="{moment}" ixy="0" ixz="0" '
        f'iyy="{moment}" iyz="0" izz="{last}"/></inertial>'
    )
