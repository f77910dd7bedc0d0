"""Compiles shapes files into constraints."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import count
from typing import TYPE_CHECKING

from kinlint.engine.compiler.deferral import Deferred
from kinlint.engine.compiler.oxigraph_probe import try_out
from kinlint.engine.compiler.query_dependencies import sweeps
from kinlint.engine.compiler.query_permissions import check_permissions
from kinlint.engine.compiler.shacl_terms import sh
from kinlint.engine.compiler.shape import Shape, target_shapes
from kinlint.engine.compiler.shapes_graph import ShapesGraph, Source, read
from kinlint.engine.compiler.target import Target, target
from kinlint.engine.compiler.target_narrowing import implying_premises, narrowed
from kinlint.engine.compiler.term_usage import query_terms
from kinlint.engine.compiler.violations import properties, top_frame, violations
from kinlint.engine.constraint import FOCUS, Constraint
from kinlint.light_dataclasses import dataclass, replace
from kinlint.sparql.patterns import literal_token

if TYPE_CHECKING:
    from kinlint.engine.compiler.shape_scope import ShapeScope, Violation
    from kinlint.terms import Triple

ROOT = "?root"


def compile_shapes(files: Sequence[Source]) -> tuple[Constraint, ...]:
    """Return the constraints of all shapes with targets in *files*, which may refer to each other.

    A constraint belongs to the only rule of the file that describes its shape, or else of the file
    with the target. Raises `RuleInvalid` for files that are no Turtle, shapes that are ill-formed
    and queries that SHACL forbids.
    """
    return compile_graph(read(files))


def compile_graph(graph: ShapesGraph) -> tuple[Constraint, ...]:
    """Return the constraints of all shapes with targets in *graph*, as `compile_shapes` does."""
    check_permissions(graph)
    found: list[Constraint] = []
    for shape in target_shapes(graph):
        if not shape.deactivated:
            found += _Walk(shape).constraints(shape, ())
    return tuple(found)


@dataclass
class _Walk:
    """The way from a shape with targets down through `sh:property`."""

    root: Shape
    """The shape with targets."""

    def constraints(self, shape: Shape, above: tuple[Shape, ...]) -> Iterator[Constraint]:
        nodes = tuple(each.node for each in above)
        names = count(1)
        scope = top_frame(shape, names, nodes)
        found = list(violations(scope))
        # pySHACL's results tell shape and component, so a component is deferred as a whole.
        reasons = {each.component: each.deferred for each in found if each.deferred}
        for violation in found:
            whole = replace(violation, deferred=reasons.get(violation.component))
            yield self._constraint(scope, whole, above)
        for inner in properties(shape):
            if inner.node in (*nodes, shape.node):
                yield self._deferred(inner, "the shape refers to itself")
            else:
                yield from self.constraints(inner, (*above, shape))

    def _constraint(
        self, scope: ShapeScope, violation: Violation, above: tuple[Shape, ...]
    ) -> Constraint:
        shape = scope.shape
        advanced = shape.graph.values(self.root.node, sh("target"))
        reason = "sh:target is not part of SHACL" if advanced else violation.deferred
        messages = violation.messages
        if not violation.own_messages:
            messages = shape.messages or messages
        common = Constraint(
            owner=self._owner(shape),
            shape=shape.node,
            component=violation.component,
            severity=violation.severity or shape.severity,
            messages=messages,
            because=violation.because,
            path=shape.path.predicate or None if shape.path else None,
            deferred=reason,
            formats=violation.formats,
            consumers=violation.consumers,
            severity_for=violation.severity_for,
            feature=violation.feature,
            speaks_of=violation.speaks_of,
        )
        if reason is not None:
            return common
        return _compiled(common, scope, violation, _chain(self.root, scope, above))

    def _deferred(self, shape: Shape, reason: str) -> Constraint:
        return Constraint(
            owner=self._owner(shape),
            shape=shape.node,
            component=sh("PropertyConstraintComponent")[1:-1],
            severity=shape.severity,
            deferred=reason,
        )

    def _owner(self, shape: Shape) -> str:
        own = shape.owner
        return own if own not in (shape.node, shape.node[1:-1]) else self.root.owner


@dataclass(frozen=True)
class _Chain:
    """Groups that bind the focus node, starting from the target in variable `root`."""

    root: str
    """The variable of the nodes that the target selects."""
    target: Target
    """The target of the first shape."""
    groups: tuple[str, ...]
    """Groups that are evaluated one inside the other."""
    premises: tuple[Triple, ...]
    """Patterns that every solution matches."""


def _chain(root: Shape, scope: ShapeScope, above: tuple[Shape, ...]) -> _Chain:
    steps = [shape for shape in above if shape.path]
    nodes = [ROOT, *(f"?k_up{at}" for at in range(1, len(steps))), "?this"]
    nodes = nodes if steps else ["?this"]
    groups, premises = [], []
    for shape, start, end in zip(steps, nodes, nodes[1:], strict=False):
        assert shape.path is not None
        groups.append(shape.path.pattern(start, end, scope.names))
        premises += shape.path.steps(start, end, scope.names)
    targets = target(root, nodes[0])
    return _Chain(nodes[0], targets, tuple(groups), (*targets.premises, *premises))


def _compiled(
    common: Constraint, scope: ShapeScope, violation: Violation, chain: _Chain
) -> Constraint:
    shown = [chain.root if chain.root == ROOT else f"({chain.root} AS {ROOT})"]
    shown.append("?this")
    if violation.at_value:
        shown.append(f"({scope.value} AS ?value)")
    shown += [name for name in violation.shown if name not in ("?this", ROOT)]

    def query(*start: str) -> str:
        outer = "".join(f"{{ {group} }} LATERAL " for group in (*start, *chain.groups))
        return f"SELECT {' '.join(shown)} WHERE {{ {outer}{violation.body} }}"

    premises: list[Triple] = [*chain.premises]
    if violation.at_value and scope.value in violation.body and scope.shape.path:
        premises += scope.shape.path.steps("?this", "?value", count(3000))
    premises += violation.premises
    own = () if chain.groups or scope.shape.path else violation.premises
    everywhere = query(narrowed(chain.target, own).all)
    if violation.without_focus and implying_premises(chain.target, own):
        everywhere = query()
    try:
        try_out(everywhere)
        try_out(query(chain.target.one).replace(FOCUS, "<any:>"))
    except Deferred as reason:
        return replace(common, deferred=str(reason))
    compiled = replace(
        common,
        select=everywhere,
        single=query(chain.target.one),
        premises=tuple((literal_token(s), p, literal_token(o)) for s, p, o in premises),
        targets=chain.target.ways,
    )
    return replace(compiled, needs=query_terms(compiled), sweeps=sweeps(everywhere))
