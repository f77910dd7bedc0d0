"""The triple patterns that a block of SPARQL abbreviates."""

from __future__ import annotations

from itertools import accumulate, count
from typing import NamedTuple

from kinlint.sparql.ast import Clause, Element, Group, Triples, Union
from kinlint.sparql.tokens import NotSparql, is_variable
from kinlint.terms import RDF, RDF_TYPE, XSD, Term, Triple, literal, literal_value

_FIRST, _REST, _NIL = f"<{RDF}first>", f"<{RDF}rest>", f"<{RDF}nil>"
_MODIFIERS = ("*", "+", "?")


class Pattern(NamedTuple):
    """A triple pattern."""

    subject: str
    """A term or variable."""
    path: tuple[str, ...]
    """A predicate, a variable or the tokens of a path."""
    object: str
    """A term or variable."""

    @property
    def text(self) -> str:
        """The pattern in SPARQL."""
        return f"{self.subject} {' '.join(self.path)} {self.object}"

    @property
    def variables(self) -> set[str]:
        """The variables of the pattern."""
        return {term for term in (self.subject, *self.path, self.object) if is_variable(term)}

    @property
    def closes(self) -> bool:
        """True if the path follows edges any number of times."""
        return "*" in self.path or "+" in self.path


def patterns(tokens: tuple[str, ...], names: count[int]) -> list[Pattern]:
    """Return the patterns of a triples block.

    Blank nodes become variables, and paths that are sequences become patterns of their steps: the
    solutions are the same, but for how often each occurs.
    """
    reader = _Reader(tokens, names)
    while reader.at < len(tokens):
        if not reader.skip("."):
            reader.subject()
    return [step for found in reader.found for step in _steps(found, names)]


def template(tokens: tuple[str, ...], *, lists: bool = False) -> list[Triple]:
    """Return the triples of a CONSTRUCT, INSERT or DELETE template, in the order of the text.

    Terms are N-Triples tokens, variables with `?`, blank nodes without a label numbered `_:0`,
    `_:1`, …; what is said of one comes after what leads to it. With *lists*, an object in
    parentheses is one term, `( ?x ?y )`; without, it is spelled out as rdf:first and rdf:rest.
    """
    reader = _Template(tokens, count())
    reader.lists = lists
    while reader.at < len(tokens):
        if not reader.skip("."):
            reader.subject()
    if path := next((path for _, path, _ in reader.found if len(path) > 1), None):
        raise NotSparql(f"'{' '.join(path)}' is a path, which a template cannot have")
    return [(s, RDF_TYPE if p == "a" else p, o) for s, (p,), o in reader.found]


def literal_token(term: str) -> str:
    """Return a term of SPARQL as an N-Triples token: numbers and booleans written out."""
    if term in ("true", "false"):
        return f'"{term}"^^<{XSD}boolean>'
    if term[0] not in "+-.0123456789":
        return term
    kind = "double" if "e" in term.lower() else "decimal" if "." in term else "integer"
    return f'"{term}"^^<{XSD}{kind}>'


def normalised(term: str) -> Term:
    """Return a term of SPARQL as an N-Triples token: numbers, booleans and strings as there."""
    if term[0] not in "\"'":
        return literal_token(term)
    quotes = term[:3] if term[:3] in ('"""', "'''") else term[0]
    end = term.rindex(quotes)
    tail = term[end + len(quotes) :]
    value = literal_value(f'"{term[len(quotes) : end]}"')
    return literal(value, tail[3:-1], "") if tail.startswith("^^") else literal(value, "", tail[1:])


def premises(found: list[Pattern]) -> tuple[Triple, ...]:
    """Return *found* as triples of tokens; paths of one predicate lose their parentheses."""
    return tuple(
        (literal_token(s), "".join(path) if len(path) > 1 else path[0], literal_token(o))
        for s, path, o in found
    )


def _steps(pattern: Pattern, names: count[int]) -> list[Pattern]:
    path = _bare(pattern.path)
    parts = _split(path, "/") if len(_split(path, "|")) == 1 else [path]
    if len(parts) > 1:
        found: list[Pattern] = []
        node = pattern.subject
        for at, part in enumerate(parts):
            end = pattern.object if at == len(parts) - 1 else f"?k_{next(names)}"
            found += _steps(Pattern(node, part, end), names)
            node = end
        return found
    if path[0] == "^" and len(_split(path, "|")) == 1:
        return _steps(Pattern(pattern.object, path[1:], pattern.subject), names)[::-1]
    return [Pattern(pattern.subject, path, pattern.object)]


def _bare(path: tuple[str, ...]) -> tuple[str, ...]:
    """Return *path* without parentheses round all of it, and `a` spelled out."""
    while path[0] == "(" and path[-1] == ")" and _is_balanced(path[1:-1]):
        path = path[1:-1]
    return tuple(RDF_TYPE if word == "a" else word for word in path)


def _is_balanced(path: tuple[str, ...]) -> bool:
    depths = list(accumulate((word == "(") - (word == ")") for word in path))
    return min(depths) >= 0


def _split(path: tuple[str, ...], operator: str) -> list[tuple[str, ...]]:
    parts: list[list[str]] = [[]]
    depth = 0
    for word in path:
        depth += (word == "(") - (word == ")")
        if word == operator and not depth:
            parts.append([])
        else:
            parts[-1].append(word)
    return [tuple(part) for part in parts]


class _Reader:
    def __init__(self, tokens: tuple[str, ...], names: count[int]) -> None:
        self.tokens = tokens
        self.names = names
        self.at = 0
        self.found: list[Pattern] = []

    @property
    def next(self) -> str:
        return self.tokens[self.at] if self.at < len(self.tokens) else ""

    def take(self) -> str:
        word = self.next
        if not word:
            raise NotSparql("a triple pattern is cut short")
        self.at += 1
        return word

    def skip(self, word: str) -> bool:
        if self.next == word:
            self.at += 1
            return True
        return False

    def fresh(self) -> str:
        return f"?k_{next(self.names)}"

    def subject(self) -> None:
        described = self.next in ("[", "(")
        node = self.node()
        if not (described and self.next in ("", ".")):
            self.properties(node)

    def properties(self, subject: str) -> None:
        while self.next not in ("", ".", "]"):
            path = self.path()
            while True:
                self.state(subject, path)
                if not self.skip(","):
                    break
            while self.skip(";"):
                pass

    def state(self, subject: str, path: tuple[str, ...]) -> None:
        self.found.append(Pattern(subject, path, self.node()))

    def path(self) -> tuple[str, ...]:
        start = self.at
        if is_variable(self.next):
            return (self.take(),)
        self.step()
        while self.next in ("|", "/"):
            self.take()
            self.step()
        return self.tokens[start : self.at]

    def step(self) -> None:
        while self.next in ("^", "!"):
            self.take()
        if self.take() == "(":
            depth = 1
            while depth:
                word = self.take()
                depth += (word == "(") - (word == ")")
        if self.next in _MODIFIERS:
            self.take()

    def node(self) -> str:
        word = self.take()
        if word == "[":
            node = self.fresh()
            self.properties(node)
            self.take()
            return node
        if word == "(":
            return self.collection()
        if word.startswith("_:"):
            return "?k_b_" + "".join(c if c.isalnum() else f"_{ord(c)}_" for c in word[2:])
        if word[0] in "\"'":
            if self.next.startswith("@"):
                return word + self.take()
            if self.skip("^^"):
                return f"{word}^^{self.take()}"
        return word

    def collection(self) -> str:
        members: list[str] = []
        while self.next != ")":
            members.append(self.node())
        self.take()
        if not members:
            return _NIL
        cells = [self.fresh() for _ in members]
        for cell, member, rest in zip(cells, members, [*cells[1:], _NIL], strict=True):
            self.found += [Pattern(cell, (_FIRST,), member), Pattern(cell, (_REST,), rest)]
        return cells[0]


class _Template(_Reader):
    """Reads a template, in which blank nodes are no variables and literals are values."""

    lists = False

    def state(self, subject: str, path: tuple[str, ...]) -> None:
        at = len(self.found)
        self.found.insert(at, Pattern(subject, path, self.node()))

    def fresh(self) -> str:
        return f"_:{next(self.names)}"

    def node(self) -> str:
        if self.next.startswith("_:"):
            return self.take()
        return normalised(super().node())

    def collection(self) -> str:
        if not self.lists:
            return super().collection()
        members: list[str] = []
        while self.next != ")":
            members.append(self.node())
        self.take()
        return f"( {' '.join(members)} )"


def spelled_out(group: Group, names: count[int]) -> Group:
    """Return *group* with sequences of steps, outside of filters, as patterns of their own."""
    found: list[Element] = []
    for each in group.elements:
        if isinstance(each, Triples):
            text = " . ".join(pattern.text for pattern in patterns(each.tokens, names))
            found.append(Triples(tuple(f"{text} .".split(" "))))
        elif isinstance(each, Union):
            found.append(Union(tuple(spelled_out(branch, names) for branch in each.branches)))
        elif isinstance(each, Clause) and each.head[0].upper() == "OPTIONAL":
            found.append(Clause(each.head, spelled_out(each.group, names)))
        else:
            found.append(each)
    return Group(tuple(found))
