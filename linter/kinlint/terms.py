"""RDF terms as N-Triples tokens.

A term is the `str` that N-Triples would write for it: `<https://…>`, `_:b0`,
`"0.1"^^<http://www.w3.org/2001/XMLSchema#double>`. Tokens compare by identity of spelling,
hash fast and need no library, so a run that only lints never imports one for them.
"""

from __future__ import annotations

from typing import TypeAlias

Term: TypeAlias = str
Triple: TypeAlias = tuple[Term, Term, Term]

XSD = "http://www.w3.org/2001/XMLSchema#"
RDF = "http://www.w3.org/1999/02/22-rdf-syntax-ns#"
RDF_TYPE: Term = f"<{RDF}type>"
NUMERIC = frozenset(f"{XSD}{name}" for name in ("double", "float", "decimal", "integer"))
"""The datatypes that SPARQL calculates with."""

_ESCAPES = str.maketrans(
    {"\\": "\\\\", '"': '\\"', "\n": "\\n", "\r": "\\r", "\t": "\\t", "\b": "\\b", "\f": "\\f"}
)


def iri(value: str) -> Term:
    """Return the token of an IRI."""
    return f"<{value}>"


def blank(label: str) -> Term:
    """Return the token of a blank node."""
    return f"_:{label}"


def literal(value: str, datatype: str = "", language: str = "") -> Term:
    """Return the token of a literal; no *datatype* and no *language* is an `xsd:string`."""
    text = '"' + value.translate(_ESCAPES) + '"'
    if language:
        return f"{text}@{language}"
    if datatype and datatype != f"{XSD}string":
        return f"{text}^^<{datatype}>"
    return text


def is_iri(term: Term) -> bool:
    """Tell whether *term* is an IRI."""
    return term.startswith("<")


def is_blank(term: Term) -> bool:
    """Tell whether *term* is a blank node."""
    return term.startswith("_:")


def is_literal(term: Term) -> bool:
    """Tell whether *term* is a literal."""
    return term.startswith('"')


def iri_value(term: Term) -> str:
    """Return the IRI inside an IRI token."""
    return term[1:-1]


def literal_value(term: Term) -> str:
    """Return the lexical form of a literal token, unescaped; nothing for any other term."""
    if not term.startswith('"'):
        return ""
    text = term[1 : term.rindex('"')]
    if "\\" not in text:
        return text
    return _unescape(text)


def literal_datatype(term: Term) -> str:
    """Return the datatype IRI of a literal token; nothing for any other term."""
    if not is_literal(term):
        return ""
    tail = term[term.rindex('"') + 1 :]
    if tail.startswith("^^"):
        return tail[3:-1]
    return f"{RDF}langString" if tail.startswith("@") else f"{XSD}string"


def _unescape(text: str) -> str:
    plain = {"n": "\n", "r": "\r", "t": "\t", "b": "\b", "f": "\f"}
    out: list[str] = []
    at = 0
    while at < len(text):
        char = text[at]
        if char != "\\":
            out.append(char)
            at += 1
        elif text[at + 1] in "uU":
            width = 4 if text[at + 1] == "u" else 8
            out.append(chr(int(text[at + 2 : at + 2 + width], 16)))
            at += 2 + width
        else:
            out.append(plain.get(text[at + 1], text[at + 1]))
            at += 2
    return "".join(out)
