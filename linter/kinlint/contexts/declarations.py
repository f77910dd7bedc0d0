"""The terms that the bundled contexts define, as Turtle that rules can ask."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

from kinlint.contexts.context_dsl import expand_context
from kinlint.contexts.context_library import COMMUNITY, RELEASES, bundled_source
from kinlint.light_dataclasses import dataclass, field
from kinlint.resources import data
from kinlint.vocabulary import KIN, KINLINT, METAMODELS, RDFS

PATH = "ontology/declarations.ttl"
"""Path of the declarations below shapes/."""

HEAD = """\
# The terms of all bundled contexts: what a property takes (kin:values, kin:container), and which
# releases know a term; of further metamodels, their classes and what they add to these namespaces.
# Made by `python -m kinlint.contexts.declarations`, not edited by hand.
"""
VALUES = {
    "@id": "Reference",
    "@vocab": "Term",
    "number": "Number",
    "text": "Text",
    "xsd:string": "Text",
    "xsd:double": "Number",
    "xsd:decimal": "Number",
    "xsd:integer": "Number",
}


@dataclass
class Declaration:
    """The declaration of one term in the contexts."""

    documents: list[str] = field(default_factory=list)
    """Contexts that declare it."""
    releases: list[str] = field(default_factory=list)
    """Releases that have it."""
    values: set[str] = field(default_factory=set)
    """Types that its values are coerced to; none for a class."""
    containers: set[str] = field(default_factory=set)
    """Containers of its values; none for a class."""


def declarations() -> str:
    """All bundled contexts' terms as one Turtle document, sorted."""
    prefixes = _prefixes()
    lines = [HEAD]
    lines += [f"@prefix {name}: <{namespace}> .\n" for namespace, name in prefixes.items()]
    for base, names in ((METAMODELS, RELEASES), (KINLINT, ("kinlint",))):
        lines.append(f"\n@base <{base}> .\n")
        found = _declared(names)
        lines += sorted(set(_namespaces(names)))
        lines += sorted(_line(iri, found[iri], prefixes) for iri in found)
    for name in COMMUNITY:
        base = bundled_source(name)["base"]
        lines.append(f"\n@base <{base}> .\n")
        found = _declared((name,))
        # Of their own terms rules ask for the classes only.
        theirs = {
            iri: term
            for iri, term in found.items()
            if iri.startswith(METAMODELS) or (iri.startswith(base) and not term.containers)
        }
        lines += sorted(_line(iri, term, prefixes) for iri, term in theirs.items())
    return "".join(lines)


def _namespaces(names: tuple[str, ...]) -> Iterator[str]:
    for release in map(bundled_source, names):
        for path, document in release["documents"].items():
            own = expand_context(release["base"], path, document)[document["prefixes"].split()[0]]
            yield f'<{path}.json> kin:namespace "{own}" .\n'


def _declared(names: tuple[str, ...]) -> dict[str, Declaration]:
    found: dict[str, Declaration] = {}
    for name in names:
        release = bundled_source(name)
        for path, document in release["documents"].items():
            for _, iri, line in terms(release["base"], path, document):
                term = found.setdefault(iri, Declaration())
                term.documents += {path} - {*term.documents}
                term.releases += {name} & {*RELEASES} - {*term.releases}
                if line is not None:
                    term.values.update(_values(line, stated=name not in COMMUNITY))
                    term.containers.add("@list" if "@list" in line.split() else "")
    return found


def terms(
    base: str, path: str, document: Mapping[str, Any]
) -> Iterator[tuple[str, str, str | None]]:
    """Each term with its IRI and its line of the notation; None for one that is no property."""
    local = expand_context(base, path, document)
    classes = document.get("classes", "")
    groups = {classes: {}} if isinstance(classes, str) else classes
    properties = [(document.get("properties", {}), local)]
    for names, scoped in groups.items():
        for name in (each.partition("=")[0] for each in names.split()):
            yield name, _iri(local, local[name]), None
            if scoped:
                properties.append((scoped, local[name]["@context"]))
    for lines, scope in properties:
        for names, line in lines.items():
            for name in names.split():
                yield name, _iri(local, scope[name]), line
                inner = scope[name].get("@context", {})
                members = (inner[member] for member in inner if member != "@base")
                yield from (
                    (member, _iri(local, member), None) for member in members if "//" not in member
                )


def _iri(local: Mapping[str, Any], definition: str | Mapping[str, Any]) -> str:
    compact: str = definition if isinstance(definition, str) else definition["@id"]
    prefix, _, name = compact.partition(":")
    return f"{local[prefix]}{name}" if prefix in local else compact


def _values(line: str, *, stated: bool) -> Iterator[str]:
    """Yield what a property takes; what is not *stated* is a number only if the line says so."""
    words = line.partition("one of ")[0].split()
    found = next((VALUES[word] for word in words if word in VALUES), "Number" if stated else None)
    yield from [found] if found else []


def _line(iri: str, term: Declaration, prefixes: Mapping[str, str]) -> str:
    namespace, name = re.fullmatch(r"(.*[#/])(.*)", iri).groups()  # type: ignore[union-attr]
    defined = " , ".join(f"<{path}.json>" for path in term.documents)
    subject = f"{prefixes[namespace]}:{name}" if namespace in prefixes else f"<{iri}>"
    said = [f"{subject} rdfs:isDefinedBy {defined}"]
    if len(term.values) == 1:
        said.append(f"kin:values kin:{min(term.values)}")
    if term.containers == {"@list"}:
        said.append("kin:container kin:List")
    if term.releases:
        said.append("kin:inRelease " + " , ".join(f'"{release}"' for release in term.releases))
    return " ; ".join(said) + " .\n"


def _prefixes() -> dict[str, str]:
    """The prefixes of rules that declarations need, by namespace."""
    text = (data("shapes") / "prefixes.ttl").read_text(encoding="utf-8")
    pairs = re.findall(r'sh:prefix "([^"]+)" ; sh:namespace "([^"]+)"', text)
    ours = (METAMODELS, KIN, RDFS, "http://qudt.org/schema/", "http://qudt.org/vocab/quantitykind/")
    return {namespace: name for name, namespace in pairs if namespace.startswith(ours)}


def main() -> None:
    """Write the declarations, or to the file that the command line names."""
    place = Path(sys.argv[1]) if len(sys.argv) > 1 else data("shapes") / PATH
    place.write_text(declarations(), encoding="utf-8")


if __name__ == "__main__":
    main()
