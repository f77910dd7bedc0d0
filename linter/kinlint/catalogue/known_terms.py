"""The terms that rules may use: those of formats, rules, SHACL, facts and the metamodels."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from functools import cache

from kinlint import resources
from kinlint.facts.computation import computed
from kinlint.formats.records import FORMATS, LIFTED
from kinlint.formats.xml.schema import schema
from kinlint.light_dataclasses import dataclass
from kinlint.suggestion import did_you_mean, slips
from kinlint.vocabulary import (
    ATTRIBUTE,
    DASH,
    FACT,
    KIN,
    KL,
    METAMODELS,
    REFERENCE,
    SH,
    SRC,
    UNIT,
)

_RULE_TERMS = """
    AP1 AP2 AP3 AP4 AP5 AP6 Rule allConsumers antiPattern applicability bad because beside
    chosenTargets code column counts displayOnly example explains feature file fixed format good
    groupBy ignore line optional passesOver prefixes preview reason reportedBy rule safe
    severityFor since speaksOf suppression symptom target unfixable unparsable unsafe until
    wholeModel with worst
"""
RULE_TERMS = frozenset(_RULE_TERMS.split())
"""Names of `kl:`, the vocabulary of rules, suppressions and reports, besides those of formats."""

_SHACL_TERMS = """
    AbstractResult BlankNode BlankNodeOrIRI BlankNodeOrLiteral ConstraintComponent Function IRI
    IRIOrLiteral Info JSConstraint JSExecutable JSFunction JSLibrary JSRule JSTarget JSTargetType
    JSValidator Literal NodeKind NodeShape Parameter Parameterizable PrefixDeclaration PropertyGroup
    PropertyShape ResultAnnotation Rule SPARQLAskExecutable SPARQLAskValidator SPARQLConstraint
    SPARQLConstructExecutable SPARQLExecutable SPARQLFunction SPARQLRule SPARQLSelectExecutable
    SPARQLSelectValidator SPARQLTarget SPARQLTargetType SPARQLUpdateExecutable Severity Shape Target
    TargetType TripleRule ValidationReport ValidationResult Validator Violation Warning
    alternativePath and annotationProperty annotationValue annotationVarName ask class closed
    condition conforms construct datatype deactivated declare defaultValue description detail
    disjoint entailment equals expression filterShape flags focusNode group hasValue
    ignoredProperties in intersection inversePath js jsFunctionName jsLibrary jsLibraryURL
    labelTemplate languageIn lessThan lessThanOrEquals maxCount maxExclusive maxInclusive maxLength
    message minCount minExclusive minInclusive minLength name namespace node nodeKind nodeValidator
    nodes not object oneOrMorePath optional or order parameter path pattern predicate prefix
    prefixes property propertyValidator qualifiedMaxCount qualifiedMinCount qualifiedValueShape
    qualifiedValueShapesDisjoint result resultAnnotation resultMessage resultPath resultSeverity
    returnType rule select severity shapesGraph shapesGraphWellFormed sourceConstraint
    sourceConstraintComponent sourceShape sparql subject suggestedShapesGraph target targetClass
    targetNode targetObjectsOf targetSubjectsOf this union uniqueLang update validator value xone
    zeroOrMorePath zeroOrOnePath
"""
SHACL_TERMS = frozenset(_SHACL_TERMS.split())
"""Names of SHACL and its Advanced Features, but for components: https://www.w3.org/ns/shacl.ttl."""

_DASH_TERMS = """
    SPARQLUpdateSuggestionGenerator ScriptSuggestionGenerator SuggestionGenerator
    propertySuggestionGenerator suggestionGenerator
"""
DASH_TERMS = frozenset(_DASH_TERMS.split())
"""Names of DASH about repairs; the others are not listed: https://datashapes.org/dash."""

_SOURCE_TERMS = """
    Comment MissingPart drawn-qw end filesIn inertiaUnknown member momentsFrom momentsIn ordinal
    release strippedPath
"""
SOURCE_TERMS = frozenset(_SOURCE_TERMS.split())
"""Names of what readers state and neither rules nor shapes ask for."""

COMPONENT = "ConstraintComponent"
"""The end of the names of SHACL's constraint components."""


@dataclass(frozen=True)
class Names:
    """The names that a namespace has."""

    what: str
    """Beginning of the message about a name that it lacks: "no format has an attribute"."""
    names: frozenset[str]
    """The names."""
    all: bool = True
    """False if the namespace has more names, so that only a slip for one of these is a fault."""

    def fault(self, prefix: str, name: str) -> str | None:
        """Return what is wrong with *name*, written with *prefix*; None if it is one of the names.

        An attribute of several numbers has a property for each, with the number at its end.
        """
        stem, dash, number = name.rpartition("-")
        numbered = dash and number.isdecimal() and stem in self.names
        if name in self.names or numbered or name.endswith(COMPONENT):
            return None
        if not self.all and not any(slips(name, each) for each in self.names):
            return None
        hint = did_you_mean(name, self.names).replace("'", f"'{prefix}:", 1)
        return f"{prefix}:{name}: {self.what} '{name}'{hint}"


@cache
def names_in(namespace: str) -> Names | None:
    """Return the names in *namespace*; None if kinlint does not know all of them."""
    if namespace.startswith((KIN, METAMODELS)):
        found = frozenset(_ontology(namespace))
        return Names("the metamodels have no term", found) if found else None
    own: dict[str, Callable[[], tuple[str, Iterable[str]]]] = {
        KL: lambda: (
            "no term of rules is called",
            RULE_TERMS | {each.name for each in FORMATS},
        ),
        SH: lambda: ("SHACL has no term", SHACL_TERMS),
        DASH: lambda: ("DASH has no term", DASH_TERMS),
        FACT: lambda: ("no fact is called", computed(for_repairs=True)),
        SRC: lambda: ("no reader states", SOURCE_TERMS | _in_use(r"\bsrc:([\w-]+)", "")),
        UNIT: lambda: ("the table of units has no", _in_use(r"^unit:(\S+)", "units")),
        ATTRIBUTE: lambda: ("no format has an attribute", _attributes()),
        REFERENCE: lambda: ("no format has a reference", _references()),
    }
    if namespace in own:
        what, names = own[namespace]()
        return Names(what, frozenset(names), all=namespace not in (DASH, SRC))
    for form in LIFTED:
        if form.namespace == namespace:
            return Names(f"{form.title} has no element", frozenset(schema(form.name).types))
    return None


def _in_use(pattern: str, folder: str) -> frozenset[str]:
    """Return what *pattern* finds in *folder* of the shapes; without one, in shapes and rules."""
    name, shapes = re.compile(pattern, re.MULTILINE), resources.data("shapes")
    folders = (shapes / folder,) if folder else (shapes, resources.data("rules"))
    paths = [path for each in folders for path in each.rglob("*.[rt][qt]*")]
    return frozenset(found for path in paths for found in name.findall(path.read_text("utf-8")))


def attributes_of(namespace: str) -> frozenset[str]:
    """Return the names of the attributes of elements in *namespace*; none if it is no format's."""
    return frozenset(_attributes(namespace))


def _attributes(namespace: str | None = None) -> Iterator[str]:
    for form in LIFTED:
        if namespace in (None, form.namespace):
            for types in schema(form.name).types.values():
                for each in types:
                    yield from each.attributes


def _references() -> Iterator[str]:
    for form in LIFTED:
        for types in schema(form.name).types.values():
            for each in types:
                for predicate in (
                    *(one.predicate for one in each.references.values()),
                    *(one.predicate for one in each.addresses.values()),
                ):
                    yield predicate[1:-1].removeprefix(REFERENCE)


@cache
def _ontology_terms() -> frozenset[str]:
    """Return the IRIs that the axioms of `shapes/ontology` name."""
    import pyoxigraph as ox  # noqa: PLC0415  a native module

    found = set[str]()
    for path in sorted((resources.data("shapes") / "ontology").glob("*.ttl")):
        for quad in ox.parse(path=path, format=ox.RdfFormat.TURTLE, base_iri="urn:ontology"):
            terms = (quad.subject, quad.predicate, quad.object)
            found.update(each.value for each in terms if isinstance(each, ox.NamedNode))
    return frozenset(found)


def _ontology(namespace: str) -> Iterator[str]:
    return (
        each.removeprefix(namespace) for each in _ontology_terms() if each.startswith(namespace)
    )
