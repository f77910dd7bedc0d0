"""Addresses: the IRIs of documents, of the elements in them, and of what is lifted from elements.

    urn:kinlint:document:arm.urdf                        a document, and the graph of what it states
    urn:kinlint:document:arm.urdf#                       its root element
    urn:kinlint:document:arm.urdf#/link/base/visual;2    an element: tag and name, tag and order
    urn:kinlint:document:arm.urdf#link/base/frame        a node that is lifted from an element

The path of an element has, for each element on the way to it, its tag, its name if it has one, and
its order if another one has the same path. Elements may stand in elements of the same kind, named
or not: which steps of a path are names follows only from the kinds that always have one. In formats
whose names hold at any depth, elements of these kinds without a name have an empty one.
"""

from __future__ import annotations

from collections.abc import Collection, Container, Iterable, Iterator
from functools import lru_cache
from urllib.parse import quote, unquote

from kinlint.terms import Term, iri

DOCUMENT = "urn:kinlint:document:"
_TERM = f"<{DOCUMENT}"


def document_iri(name: str) -> Term:
    """Return the IRI of the document called *name*, which is also the graph of what it states."""
    return iri(DOCUMENT + quote(name, safe="/.-_~", errors="replace"))


def is_address(node: str) -> bool:
    """Tell whether *node*, an IRI with or without its brackets, is an address."""
    return node.startswith((_TERM, DOCUMENT))


def document_of(node: Term) -> Term:
    """Return the graph of the document that *node* would belong to, by its IRI."""
    at = node.find("#")
    return f"{node[:at]}>" if at >= 0 else node


def root_of(node: Term) -> Term:
    """Return the root element of the document that *node* belongs to."""
    return f"{document_of(node)[:-1]}#>"


def split(address: str) -> tuple[str, str]:
    """Return the quoted name of the file and the quoted path of an *address* without brackets."""
    file, _, path = address.removeprefix(DOCUMENT).partition("#")
    return file, path


def without_file(address: str) -> str:
    """Return *address*, without brackets, less the name of the file, which may be moved."""
    return f"{DOCUMENT}{address.partition('#')[2]}"


def abbreviated(text: str) -> str:
    """Return *text*, a term of N-Triples, less what all addresses begin with."""
    return text.replace(_TERM, "<", 1)


def readable(address: str) -> str:
    """Return *address*, without brackets, as people read it: `arm.urdf#/link/base/inertia`.

    What is lifted from an element is called like an element.
    """
    file, path = map(unquote, split(address))
    return f"{file}#/{path.removeprefix('/')}" if path else file


_quoted = lru_cache(maxsize=100_000)(lambda name: quote(name, safe=""))


def child_address(parent: str, tag: str, name: str | None) -> str:
    """Return the address, without brackets, of a child of the element at *parent*."""
    return f"{parent}/{tag}/{_quoted(name)}" if name else f"{parent}/{tag}"


def repeated_address(address: str, order: int) -> str:
    """Return the address of the element that is number *order* of those that *address* fits."""
    return f"{address};{order}"


def child(parent: Term, tag: str, name: str = "") -> Term:
    """Return the first child of the element *parent* that has this *tag* and *name*."""
    return f"<{child_address(parent[1:-1], tag, name)}>"


def sibling(node: Term, tag: str, name: str) -> Term:
    """Return what has this *tag* and *name* beside *node*, which has a name, too."""
    above = node.rpartition("/")[0]
    return f"{above[: _last(above)]}{tag}/{_quoted(name)}>"


def is_repeated(node: Term) -> bool:
    """Tell whether *node* is an element that is not the first of its kind and name."""
    return unordered(node[:-1]) != node[:-1]


def lifted(element: Term) -> Term:
    """Return the node of the composable model that *element* is lifted to."""
    return element.replace("#/", "#", 1)


def element_of(node: Term) -> Term:
    """Return the element that stands at the path of *node*, which is lifted from it."""
    if "#/" in node or node.endswith("#>"):
        return node
    return node.replace("#", "#/", 1)


def lifted_at(node: Term, path: str) -> Term:
    """Return the node that is lifted from the element at *path* of the document of *node*."""
    return f"{document_of(node)[:-1]}#{path}>"


def namespaces(scope: str, tags: Iterable[str]) -> Iterator[str]:
    """Return how the addresses begin of what is named in the element at *scope*.

    First of all that is in it and of what is lifted from that, then of the elements with *tags*.
    """
    own = lifted(scope)
    spaces = f"{scope}/", own if own.endswith("#") else f"{own}/"
    yield from spaces
    for space in spaces:
        yield from (f"{space}{tag}/" for tag in tags)


def enclosing(node: Term) -> Iterator[Term]:
    """Yield *node* and the nodes in which it lies by its path, innermost first, not the root."""
    address = node[:-1]
    start = address.find("#") + 1
    while len(address) > start:
        yield f"{address}>"
        address = address[: max(address.rfind("/"), start)]


def is_element(node: Term) -> bool:
    """Tell whether *node* is the address of an element other than the root of its document."""
    return "#/" in node


def way_out(element: Term, elements: Container[Term]) -> Iterator[tuple[str, str, str]]:
    """Yield tag, name and order of *element* and those of *elements* that it stands in.

    The innermost comes first, the root is left out; what an element does not have is empty.
    """
    inner = element
    for outer in (*(each for each in enclosing(element) if each in elements), root_of(element)):
        if outer != inner:
            step = inner[len(outer.rstrip(">")) + 1 : -1]
            path = unordered(step)
            tag, _, name = path.partition("/")
            yield tag, unquote(name), "" if name else step[len(path) + 1 :]
            inner = outer


def is_within(node: Term, element: Term) -> bool:
    """Tell whether *node* lies in *element*, by their paths."""
    return node.startswith(f"{element[:-1]}/")


def local_name(node: Term) -> str:
    """Return the last step of an IRI: of an element with a name, its name."""
    return unquote(node[_last(node) : -1])


def last_tag(element: Term) -> str:
    """Return the tag of an element with a name, or of what is lifted from it; else nothing."""
    above = element[: _last(element) - 1]
    return unordered(above[_last(above) :]) if "#" in above else ""


def steps(path: str, kinds: Collection[str]) -> Iterator[tuple[str, str]]:
    """Yield the tag and the name of each element on a quoted *path*; elements of *kinds* have one.

    Others have none, or it comes as a step of its own. A name may be empty, but for an order, which
    then comes with the tag.
    """
    parts = iter(path.removeprefix("/").split("/"))
    for tag in parts:
        name = next(parts, "") if tag in kinds else ""
        yield (f"{tag}{name}", "") if name.startswith(";") else (tag, name)


def short_path(path: str, kinds: Collection[str]) -> str:
    """Return *path* without the tags of elements of *kinds*, which are known by name."""
    return "/".join(name or tag for tag, name in steps(path, kinds))


def owner_path(path: str, kinds: Collection[str]) -> str:
    """Return the part of *path* that leads to the last element of *kinds* on it."""
    path = path.removeprefix("/")
    at = end = 0
    for tag, name in steps(path, kinds):
        at += len(tag) + 1
        if name:
            end = at = at + len(name) + 1
        elif path[at : at + 1] == "/":  # behind an empty name
            at += 1
    return path[: max(end - 1, 0)]


def _last(node: Term) -> int:
    """Return where the last step of *node* begins."""
    return max(node.rfind("#"), node.rfind("/")) + 1


def unordered(address: str) -> str:
    """Return *address* less the order at its end."""
    start, mark, order = address.rpartition(";")
    return start if mark and order.isdecimal() else address
