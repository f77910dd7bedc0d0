"""Mends texts with rules of a test, each of one repair."""

from dataclasses import replace
from pathlib import Path

from support.linting import book as built_in

from kinlint.catalogue import rulebook
from kinlint.catalogue.rule_file import read_rules
from kinlint.configuration.settings import Settings
from kinlint.engine.compiler.shapes_compiler import compile_shapes
from kinlint.fixes.rounds import fix_in_rounds, lint_texts
from kinlint.rule import Applicability
from kinlint.text import SourceText

RULE = """
@prefix at: <https://w3id.org/kinlint/attribute#> .
@prefix dash: <http://datashapes.org/dash#> .
@prefix kl: <https://w3id.org/kinlint/ns#> .
@prefix rdfs: <http://www.w3.org/2000/01/rdf-schema#> .
@prefix rule: <https://w3id.org/kinlint/rules/> .
@prefix sdf: <https://w3id.org/kinlint/sdf#> .
@prefix sh: <http://www.w3.org/ns/shacl#> .
@prefix urdf: <https://w3id.org/kinlint/urdf#> .
@prefix kin: <https://w3id.org/kinlint/kinematics#> .

rule:{name} a kl:Rule, sh:NodeShape ;
    kl:code "{code}" ;
    sh:severity sh:Warning ;
    {target} ;
    sh:sparql [
        sh:message "'{{$this}}' is at fault." ; sh:prefixes kl:prefixes ;
        sh:select '''{select}''' ] ;
    {repairs} .
"""
REPAIR = """dash:suggestionGenerator [
        a dash:SPARQLUpdateSuggestionGenerator ; sh:order {order} ;
        rdfs:label "{title}" ; kl:applicability kl:{claim} ; rdfs:comment "It is a guess." ;
        sh:prefixes kl:prefixes ; sh:update '''{update}''' ]"""
OURS = built_in()


def repair(update, title="Mend it", claim="safe", order=1):
    """A repair as a rule file says it."""
    return REPAIR.format(update=update, title=title, claim=claim, order=order)


def book(directory: Path, *rules):
    """A rulebook of *rules* alone, each a dict of `target`, `select` and `repairs`."""
    files = []
    for number, parts in enumerate(rules, 1):
        file = directory / f"rule-{number}.ttl"
        repairs = " ; ".join(parts["repairs"])
        known = {"name": file.stem, "code": f"TST{number:03}", **parts, "repairs": repairs}
        file.write_text(RULE.format(**known), "utf-8")
        files.append(file)
    read = tuple(rule for file in files for rule in read_rules(file))
    shapes = (next(file for file in OURS.shapes if file.name == rulebook.PREFIXES), *files)
    return replace(OURS, rules=read, constraints=compile_shapes(shapes), shapes=shapes)


def offered(rules, text, name="arm.urdf"):
    """The findings in *text*, with the fixes that are offered, and what is refused."""
    offers = lint_texts([SourceText(name, text)], (), Settings(), rules)
    return offers.report.findings, [why for _, _, why in offers.refused]


def mend(rules, text, name="arm.urdf", least=Applicability.SAFE):
    """*text* after `--fix`, and the report of what is left."""
    made = outcome(rules, text, name, least)
    return made.texts[0].text, made.report


def outcome(rules, text, name="arm.urdf", least=Applicability.UNSAFE):
    """What comes of *text* by all fixes that may be trusted at *least* so far."""
    return fix_in_rounds([SourceText(name, text)], (), Settings(), rules, least)
