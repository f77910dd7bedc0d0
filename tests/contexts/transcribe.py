"""Write the facts of published contexts in the notation of shapes/contexts.

    python tests/contexts/transcribe.py BASE DIRECTORY > shapes/contexts/NAME.json

Which term means which IRI, coerced how, is all that is taken from the documents below DIRECTORY,
which are published below BASE. Remarks, order and layout are not.
"""

from __future__ import annotations

import json
import re
import sys
from collections import defaultdict
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import Any

XSD = "http://www.w3.org/2001/XMLSchema#"
LONGEST = 90
"""Length of a group of names with the same definition."""


def transcribe(base: str, directory: Path) -> dict[str, Any]:
    """Return all documents below *directory* in the notation."""
    paths = sorted(directory.rglob("*.json"))
    documents = {}
    for path in paths:
        context = json.loads(path.read_text(encoding="utf-8"))["@context"]
        name = path.relative_to(directory).with_suffix("").as_posix()
        documents[name] = _document(base, name, context)
    return {"base": base, "documents": documents}


def _document(base: str, path: str, context: Mapping[str, Any]) -> dict[str, Any]:
    prefixes = {term: iri for term, iri in context.items() if isinstance(iri, str) and "://" in iri}
    own = next((p for p, iri in prefixes.items() if iri == f"{base}{path}#"), None)
    own = own or _most_used(context, prefixes)
    others = {term: iri for term, iri in prefixes.items() if term not in (own, "xsd")}
    made: dict[str, Any] = {"version": context["@version"]} if "@version" in context else {}
    made["prefixes"] = f"{own} xsd" if prefixes.get("xsd") == XSD else own
    if prefixes[own] != f"{base}{path}#":
        made["namespace"] = prefixes[own].removeprefix(base)
    if others:
        made["others"] = others
    classes: dict[str, list[str]] = defaultdict(list)
    properties: dict[str, list[str]] = defaultdict(list)
    for term, definition in context.items():
        if term[:1] == "@" or term in prefixes:
            continue
        if _is_class(definition):
            classes[json.dumps(_scoped(own, definition))].append(_named(own, term, definition))
        else:
            properties[_line(own, term, definition)].append(term)
    groups = {names: json.loads(inner) for inner, all_ in classes.items() for names in _lines(all_)}
    if groups:
        made["classes"] = groups if any(groups.values()) else _single(groups)
    if properties:
        made["properties"] = {n: line for line, all_ in properties.items() for n in _lines(all_)}
    return made


def _single(groups: Mapping[str, Any]) -> Any:
    return next(iter(groups)) if len(groups) == 1 else dict(groups)


def _most_used(context: Mapping[str, Any], prefixes: Mapping[str, str]) -> str:
    text = json.dumps({term: each for term, each in context.items() if term not in prefixes})
    return max((p for p in prefixes if p != "xsd"), key=lambda p: text.count(f'"{p}:'))


def _is_class(definition: Any) -> bool:
    """Tell whether a term looks like a class: a name with a capital, without coercion."""
    if isinstance(definition, str):
        return bool(re.match(r"[A-Z0-9]", definition.rpartition(":")[2]))
    plain = definition.keys() <= {"@id", "@context"}
    return plain and bool(re.match(r"[A-Z0-9]", definition["@id"].rpartition(":")[2]))


def _named(own: str, term: str, definition: Any) -> str:
    iri = definition if isinstance(definition, str) else definition["@id"]
    return term if iri == f"{own}:{term}" else f"{term}={iri.removeprefix(f'{own}:')}"


def _scoped(own: str, definition: Any) -> dict[str, str]:
    inner = definition.get("@context", {}) if isinstance(definition, dict) else {}
    found: dict[str, list[str]] = defaultdict(list)
    for term, each in inner.items():
        found[_line(own, term, each)].append(term)
    return {names: line for line, all_ in found.items() for names in _lines(all_)}


def _line(own: str, term: str, definition: Any) -> str:
    """Return the line of words for the property *term*."""
    whole = {"@id": definition} if isinstance(definition, str) else definition
    words = []
    if (coercion := whole.get("@type")) is not None:
        words.append(coercion)
    if (container := whole.get("@container")) is not None:
        words.append(container)
    if (name := whole["@id"].removeprefix(f"{own}:")) != term:
        words += ["as", name]
    inner = dict(whole.get("@context", {}))
    if (base := inner.pop("@base", None)) is not None:
        words += ["from", base]
    if inner:
        words.append("one of")
        words += [
            member if iri == f"{own}:{member}" else f"{member}={iri.removeprefix(f'{own}:')}"
            for member, iri in inner.items()
        ]
    return " ".join(words)


def _lines(names: list[str]) -> Iterator[str]:
    """Yield *names* in groups that are not too long."""
    group: list[str] = []
    for name in names:
        if group and len(" ".join([*group, name])) > LONGEST:
            yield " ".join(group)
            group = []
        group.append(name)
    if group:
        yield " ".join(group)


if __name__ == "__main__":
    base, directory = sys.argv[1:]
    sys.stdout.write(json.dumps(transcribe(base, Path(directory)), indent=2) + "\n")
