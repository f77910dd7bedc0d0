"""Reads what a rule file says about its rule: everything but the check itself."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from textwrap import dedent

from kinlint.catalogue.asked_facts import modules
from kinlint.catalogue.explanation_queries import read_explanations
from kinlint.catalogue.repair_file import prefixes, read_repairs
from kinlint.engine.compiler.query_permissions import check_permissions
from kinlint.engine.compiler.shacl_terms import RULE_CLASS, TYPE, sh
from kinlint.engine.compiler.shapes_graph import ShapesFile, ShapesGraph, parse
from kinlint.errors import RuleInvalid
from kinlint.light_dataclasses import astuple
from kinlint.rule import SEVERITY_BY_IRI, SPEAKS_OF, Example, Rule, Severity, SeverityFor
from kinlint.terms import Term, iri, iri_value, is_iri, is_literal, literal_datatype, literal_value
from kinlint.vocabulary import FEATURE, KL, RDFS, SH

TRUE = {"true", "1"}


def read_rules(file: Path) -> tuple[Rule, ...]:
    """Return the rules that *file* states: one for a rule file, none for plain shapes.

    Raises `RuleInvalid` if it is no Turtle, states several rules, or leaves out what tells a
    rule apart: its code and its name.
    """
    return stated_rules(parse(file))


def stated_rules(file: ShapesFile) -> tuple[Rule, ...]:
    """Return the rules that the parsed *file* states, as `read_rules` does."""
    graph = ShapesGraph((file,))
    check_permissions(graph)
    rules = sorted(graph.referrers(TYPE, RULE_CLASS))
    if len(rules) > 1:
        raise RuleInvalid(f"{file.name}: {len(rules)} rules in one file; a rule file holds one")
    return tuple(_RuleReader(graph, rule, file.name).rule() for rule in rules)


class _RuleReader:
    """A reader of the rule *subject* of the file *name*, which *graph* describes."""

    def __init__(self, graph: ShapesGraph, subject: Term, name: str) -> None:
        self.graph = graph
        self.subject = subject
        self.file = Path(name)

    def values(self, predicate: Term, subject: Term | None = None) -> tuple[str, ...]:
        found = self.graph.values(subject or self.subject, predicate)
        return tuple(sorted(map(_text, found)))

    def value(self, predicate: Term) -> str:
        return next(iter(self.values(predicate)), "")

    def rule(self) -> Rule:
        name = _text(self.subject).rpartition("/")[2]
        code = self.value(kl("code"))
        if not code:
            raise RuleInvalid(f"{self.file}: rule {name} has no kl:code")
        if name != self.file.stem:
            cause = f"the rule is called {name}, so its file must be {name}.ttl"
            raise RuleInvalid(f"{self.file}: {cause}")
        said = {
            _text(text)
            for each in self.graph.subjects()
            for text in self.graph.values(each, sh("message"))
        }
        return Rule(
            iri=_text(self.subject),
            code=code,
            name=name,
            title=self.value(iri(f"{RDFS}label")) or name,
            why=_prose(self.value(iri(f"{RDFS}comment"))),
            severity=self.severity(self.value(sh("severity")) or f"{SH}Violation"),
            antipatterns=tuple(tag.removeprefix(KL) for tag in self.values(kl("antiPattern"))),
            symptoms=self.values(kl("symptom")),
            formats=self.values(kl("format")),
            links=self.values(iri(f"{RDFS}seeAlso")),
            messages=tuple(sorted(said)),
            examples=tuple(self.examples()),
            since=self.value(kl("since")),
            path=str(self.file),
            whole_model=self.value(kl("wholeModel")) in TRUE,
            targets=self.values(kl("target")),
            severity_for=tuple(sorted(self.severity_for(self.subject), key=astuple)),
            group_by=self.values(kl("groupBy")),
            worst=self.value(kl("worst")),
            explains=read_explanations(self.graph, self.subject),
            unparsable=self.value(kl("unparsable")) in TRUE,
            preview=self.value(kl("preview")) in TRUE,
            optional=self.value(kl("optional")) in TRUE,
            also=tuple(sorted(self.also(), reverse=True)),
            also_for=tuple(sorted(set(self.also_for()), key=astuple)),
            repairs=read_repairs(self.graph, self.subject),
            features=tuple(sorted(self.features())),
            speaks_of=SPEAKS_OF.get(self.value(kl("speaksOf")), ""),
            facts=modules(self.graph.files[0], prefixes()),
        )

    def severity(self, said: str) -> Severity:
        if said not in SEVERITY_BY_IRI:
            raise RuleInvalid(f"{self.file}: {said} is not a severity")
        return SEVERITY_BY_IRI[said]

    def also(self) -> set[Severity]:
        """Return what single constraints of the rule count as, where they say so themselves."""
        return {
            self.severity(said)
            for each in self.graph.values(self.subject, sh("sparql"))
            for said in self.values(sh("severity"), each)
        }

    def features(self) -> set[str]:
        """Return the names of the features that the rule and its constraints find."""
        nodes = (self.subject, *self.graph.values(self.subject, sh("sparql")))
        return {
            found.removeprefix(FEATURE)
            for each in nodes
            for found in self.values(kl("feature"), each)
        }

    def also_for(self) -> Iterator[SeverityFor]:
        """Yield the severities of single constraints for certain consumers or formats."""
        for each in self.graph.values(self.subject, sh("sparql")):
            yield from self.severity_for(each)
            if targets := self.values(kl("target"), each):
                own = next(iter(self.values(sh("severity"), each)), self.value(sh("severity")))
                yield SeverityFor(self.severity(own), targets)

    def severity_for(self, node: Term) -> Iterator[SeverityFor]:
        """Yield the severities of *node*, a rule or constraint, by `kl:severityFor`."""
        for each in self.graph.values(node, kl("severityFor")):
            targets, formats = self.values(kl("target"), each), self.values(kl("format"), each)
            said = next(iter(self.values(sh("severity"), each)), "nothing")
            yield SeverityFor(self.severity(said), targets, formats)

    def examples(self) -> list[Example]:
        found = [self.example(each) for each in self.graph.values(self.subject, kl("example"))]
        return sorted(found, key=lambda each: (each.bad or "", each.good or ""))

    def example(self, node: Term) -> Example:
        def literal(which: str) -> Term | None:
            return next(filter(is_literal, self.graph.values(node, kl(which))), None)

        bad, good, fixed, unfixable = map(literal, ("bad", "good", "fixed", "unfixable"))
        written = bad or good
        companions = sorted(filter(is_literal, self.graph.values(node, kl("with"))), key=_text)
        return Example(
            _format(written) if written else "",
            _source(bad),
            _source(good),
            self.values(kl("beside"), node),
            tuple((_format(each), _source(each) or "") for each in companions),
            _source(fixed),
            unfixable is not None and _text(unfixable) in TRUE,
        )


def kl(name: str) -> Term:
    """Return the token of a term of kinlint's vocabulary of rules."""
    return iri(f"{KL}{name}")


def _text(term: Term) -> str:
    """Return what a term says: an IRI, the lexical form of a literal, or a label."""
    if is_iri(term):
        return iri_value(term)
    return literal_value(term) if is_literal(term) else term


def _format(example: Term) -> str:
    return literal_datatype(example).removeprefix(KL)


def _source(example: Term | None) -> str | None:
    return None if example is None else source_of(literal_value(example))


def source_of(literal: str) -> str:
    """Return the text of the example that is written as *literal*, without its indentation."""
    return dedent(literal).strip("\n") + "\n"


def _prose(text: str) -> str:
    return " ".join(text.split())
