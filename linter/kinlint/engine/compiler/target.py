"""Targets of shapes, as patterns for the nodes that a shape judges: SHACL 2.1.3."""

from __future__ import annotations

from typing import TYPE_CHECKING

from kinlint.engine.compiler.shacl_terms import SUBCLASS, TYPE
from kinlint.engine.compiler.shape import is_class_shape
from kinlint.engine.constraint import FOCUS
from kinlint.light_dataclasses import dataclass
from kinlint.terms import is_blank

if TYPE_CHECKING:
    from kinlint.engine.compiler.shape import Shape
    from kinlint.terms import Term, Triple


@dataclass(frozen=True)
class Target:
    """Groups that bind a variable to the focus nodes of a shape."""

    all: str
    """The group that binds it to all of them, once each."""
    one: str
    """The group that binds it to one given node."""
    premises: tuple[Triple, ...]
    """The patterns that hold of each, if there is one way only."""
    ways: tuple[Triple, ...]
    """Patterns of which one holds of each, if there are any."""


def target(shape: Shape, root: str) -> Target:
    """Return the targets of *shape*, with the focus node in variable *root*."""
    classes = shape.values("targetClass")
    if is_class_shape(shape.graph, shape.node) and shape.node not in classes:
        classes.append(shape.node)
    nodes = shape.values("targetNode")
    if blank := next((node for node in [*classes, *nodes] if is_blank(node)), None):
        raise shape.graph.invalid(shape.node, f"{blank} is a target without a name")
    kinds: list[tuple[str, str, tuple[Triple, ...]]] = [
        (
            f"{root} {TYPE}/{SUBCLASS}* {kind}",
            f"{{ {root} {TYPE} ?k_c }} LATERAL {{ ?k_c {SUBCLASS}* {kind} }}",
            ((root, TYPE, "?k_c"), ("?k_c", f"{SUBCLASS}*", kind)),
        )
        for kind in classes
    ]
    kinds += [_plain(root, predicate, "?k_t") for predicate in shape.values("targetSubjectsOf")]
    kinds += [_plain("?k_t", predicate, root) for predicate in shape.values("targetObjectsOf")]
    if nodes:
        kinds.append(
            (f"VALUES {root} {{ {' '.join(nodes)} }}", f"FILTER({one_of(root, nodes)})", ())
        )
    union = " UNION ".join(f"{{ {bulk} }}" for bulk, _, _ in kinds)
    single = " UNION ".join(f"{{ {one} }}" for _, one, _ in kinds)
    given = f"VALUES {root} {{ {FOCUS} }}"
    return Target(
        all=f"{{ SELECT DISTINCT {root} WHERE {{ {union} }} }}",
        one=f"{{ SELECT DISTINCT {root} WHERE {{ {{ {given} }} LATERAL {{ {single} }} }} }}",
        premises=kinds[0][2] if len(kinds) == 1 else (),
        ways=()
        if nodes
        else (
            *((root, TYPE, kind) for kind in classes),
            *((root, predicate, "?k_t") for predicate in shape.values("targetSubjectsOf")),
            *(("?k_t", predicate, root) for predicate in shape.values("targetObjectsOf")),
        ),
    )


def one_of(variable: str, terms: list[Term] | tuple[Term, ...]) -> str:
    """Return the condition that *variable* is one of *terms*, as terms rather than as values."""
    return " || ".join(f"sameTerm({variable}, {term})" for term in terms) or "false"


def _plain(s: str, p: str, o: str) -> tuple[str, str, tuple[Triple, ...]]:
    return f"{s} {p} {o}", f"{s} {p} {o}", ((s, p, o),)
