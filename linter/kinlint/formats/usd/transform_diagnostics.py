"""Operations of transforms that are written and not in force, or listed and not written."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from kinlint.formats.source_layer import SourceLayer
from kinlint.formats.usd.layer_opinions import Opinions, specs
from kinlint.formats.usd.prim_schemas import base_types, prim_schemas
from kinlint.formats.usd.usda_syntax import Prim, Property, Value
from kinlint.terms import Term, literal
from kinlint.text import Span

ORDER = "xformOpOrder"
PREFIX = "xformOp:"
INVERSE = "!invert!"
RESET = "!resetXformStack!"
PLACED = "Xformable"


def state_unread_operations(
    root: Prim, node_of: Mapping[Prim, Term], opinions: Mapping[str, Opinions], layer: SourceLayer
) -> None:
    """State the operations in the layer *root*, whose prims have the nodes *node_of*.

    An order that stands beside operations is in force for them. Without one, nothing is told of a
    prim to which other layers, classes or references may give one.
    """
    ordered = {path for path, prim in specs(root) if _order(prim) is not None}
    classes = tuple(f"/{each.name}" for each in root.children if each.specifier == "class")
    for path, prim in specs(root):
        known = opinions[path]
        whole = known.whole and not path.startswith(classes)
        for kind, name, span in _deviations(
            prim, known.type_name, whole=whole, ordered=path in ordered
        ):
            said = ("node", node_of[prim]), ("attribute", literal(name))
            layer.add_node(kind, span, *said)


def _deviations(
    prim: Prim, type_name: str, *, whole: bool, ordered: bool
) -> Iterator[tuple[str, str, Span]]:
    """Yield kind, operation and place of what *prim* says of its transform in vain.

    *whole*: nothing else contributes to the prim. *ordered*: the layer has an order for it.
    """
    operations, order = list(_operations(prim)), _order(prim)
    if operations and _has_no_place(type_name, whole=whole):
        yield "UnplacedTransform", operations[0].name, operations[0].name_span
    elif order is not None:
        listed = {each.text.removeprefix(INVERSE) for each in order}
        for each in operations:
            if each.name not in listed:
                yield "UnreadOperation", each.name, each.name_span
        yield from _misplaced(order)
        names = {RESET, *(each.name for each in operations)}
        for item in order if whole else ():
            if item.text.removeprefix(INVERSE) not in names:
                yield "MissingOperation", item.text, item.content
    elif whole and not ordered:
        for each in operations:
            yield "UnreadOperation", each.name, each.name_span


def _misplaced(order: Iterable[Value]) -> Iterator[tuple[str, str, Span]]:
    """Yield kind, operation and place of what is listed twice, and of a reset that is not first."""
    before = set[str]()
    for item in order:
        if item.text == RESET and before:
            yield "LateReset", item.text, item.content
        elif item.text in before:
            yield "RepeatedOperation", item.text, item.content
        before.add(item.text)


def _has_no_place(type_name: str, *, whole: bool) -> bool:
    """Tell whether a prim of the type *type_name* has no transform."""
    if type_name:
        return type_name in prim_schemas() and PLACED not in base_types(type_name)
    return whole


def _operations(prim: Prim) -> Iterator[Property]:
    return (each for each in prim.properties if each.name.startswith(PREFIX))


def _order(prim: Prim) -> list[Value] | None:
    """Return the operations that *prim* lists; None if it lists none."""
    found = [e for e in prim.properties if e.name == ORDER and e.value is not None]
    value = found[-1].value if found else None
    if value is None:
        return None
    return [each for each in value.scalars() if each.kind == "string"]
