"""A finding, and its parts: related places, premises, fixes. All of it frozen."""

from __future__ import annotations

import hashlib
from typing import TypeAlias

from kinlint.addresses import is_address, readable
from kinlint.light_dataclasses import dataclass, field, replace
from kinlint.rule import Applicability, Rule, Severity, SeverityFor, SpeaksOf
from kinlint.terms import Term, Triple
from kinlint.text import Location, SourceText, Span

DEPARTURES = "{?departures}"
"""Placeholder at the end of templates for what consumers make of a feature."""

FindingKey: TypeAlias = tuple[str, str, Span, str]
"""The rule, the file, the place and the message of a finding."""


@dataclass(frozen=True, slots=True)
class TextEdit:
    """Replacement of the text at a place."""

    location: Location
    """The place."""
    text: str
    """The new text."""


@dataclass(frozen=True, slots=True)
class Fix:
    """A repair of one finding as text edits."""

    title: str
    """Imperative, placeholders filled in."""
    applicability: Applicability
    """The applicability that the repair claims, lowered to what was proven."""
    edits: tuple[TextEdit, ...]
    """Edits, ascending and without overlap in each text."""
    update: str
    """The change of the graph as a SPARQL Update without variables."""
    why: str = ""
    """Reason why it is not safe, if it is not."""
    removed: tuple[Triple, ...] = ()
    """Triples that the fix deletes."""
    added: tuple[Triple, ...] = ()
    """Triples that the fix inserts."""

    @property
    def sources(self) -> tuple[SourceText, ...]:
        """Return the texts that are changed, without duplicates."""
        return tuple({id(one.location.source): one.location.source for one in self.edits}.values())


@dataclass(frozen=True, slots=True)
class Related:
    """Another place that concerns a finding."""

    location: Location
    """The place."""
    message: str
    """Role of the place; empty for one more of the same kind."""


@dataclass(frozen=True, slots=True)
class Premise:
    """A statement that a finding rests on: asserted at a place, or inferred."""

    statement: str
    """The statement, for people."""
    location: Location | None = None
    """Place of an asserted statement."""
    axiom: str = ""
    """The axiom by which it was inferred, or what it was computed from, in words; empty if
    asserted.
    """
    depth: int = 0
    """0 for a triple that the rule matched; the premises of each follow it, one deeper."""

    @property
    def inferred(self) -> bool:
        """Tell whether the statement was derived rather than written."""
        return bool(self.axiom)

    @property
    def computed(self) -> bool:
        """Tell whether it follows by arithmetic from the statements below it, and by no axiom."""
        return self.axiom.startswith("computed from")


@dataclass(frozen=True, slots=True)
class Finding:
    """A defect at a place."""

    rule: Rule
    """The rule that was violated."""
    severity: Severity
    """Severity here, after configuration."""
    message: str
    """`template` with its `arguments` filled in."""
    location: Location
    """Place of the defect."""
    iri: str
    """The entity concerned: an absolute IRI or a blank node label."""
    focus: Term
    """The focus node (SHACL)."""
    targets: tuple[str, ...] = ()
    """Consumers that its constraint is about; it is dropped unless a run names one of them."""
    severity_for: tuple[SeverityFor, ...] = ()
    """Severities of its constraint for certain consumers or formats."""
    versions: tuple[str, str] = ("", "")
    """Versions of `targets` that it is about: the first, and the first after; empty for no end."""
    feature: str = ""
    """Name of the feature found, which consumers read differently; empty if it is none."""
    speaks_of: SpeaksOf = ""
    """Consumers that it is about: it is dropped unless one of them departs from what is written."""
    departures: str = ""
    """Sentences at the end of `message` about what consumers make of `feature`."""
    path: Term | None = None
    """The property, where the rule names one."""
    value: Term | None = None
    """The value, where the rule names one."""
    template: str = ""
    """Message with placeholders."""
    arguments: tuple[str, ...] = ()
    """Values of the placeholders, abbreviated as in the file."""
    meant: tuple[str, ...] = ()
    """The same, independent of abbreviations."""
    related: tuple[Related, ...] = ()
    """Other places it is about."""
    reason: str = ""
    """One sentence with the numbers that show the defect; empty where the message has them."""
    because: tuple[Premise, ...] = ()
    """Statements that the finding rests on."""
    suppressed: str | None = field(default=None)
    """Reason for the suppression; None if the finding is not suppressed."""
    group: tuple[str, ...] = ()
    """Values shared with the findings grouped with it (`Rule.group_by`)."""
    extent: float = 0.0
    """Size of the number that orders its group (`Rule.worst`)."""
    members: tuple[Finding, ...] = ()
    """The findings grouped in this one."""
    consequences: tuple[Finding, ...] = ()
    """The findings that follow from this one and are not reported on their own."""
    fixes: tuple[Fix, ...] = ()
    """Alternative fixes, the preferred first."""

    def fix(self, least: Applicability) -> Fix | None:
        """Return the first fix of at least applicability *least*: the one that `--fix` makes."""
        return next((each for each in self.fixes if each.applicability >= least), None)

    @property
    def listed_consequences(self) -> tuple[Finding, ...]:
        """Return `consequences`, each with this finding as a related place."""
        cause = Related(self.location, f"this follows from {self.rule.code}: {self.message}")
        return tuple(replace(each, related=(*each.related, cause)) for each in self.consequences)

    @property
    def entity(self) -> str:
        """Return `iri` for people: for an element, the file and the path to it.

        A lifted node is named like an element: `arm.urdf#/link/base/inertia`.
        """
        return readable(self.iri) if is_address(self.iri) else self.iri

    @property
    def fingerprint(self) -> str:
        """Return a hash of rule, entity, path and value, which survives moving and re-indenting.

        The fingerprint of a group is that of the rule and the values in common, whatever its
        members.
        """
        alone = self.iri, self.path or "", *(self.meant or self.arguments)
        what = [self.rule.code, *(self.group if self.rule.group_by else alone)]
        return hashlib.sha256("\x1f".join(what).encode("utf-8", "surrogatepass")).hexdigest()[:32]

    @property
    def key(self) -> FindingKey:
        """Return what equal findings of two analyses of the same texts share."""
        return self.rule.code, self.location.source.name, self.location.span, self.message

    @property
    def identity(self) -> tuple[object, ...]:
        """Return what findings have in common if they say the same of one place."""
        # One line of text may make several nodes.
        about = None if is_address(self.iri) else self.focus
        # What targets make of it was added when it was judged; it says the same of the place.
        message = self.message.removesuffix(self.departures).rstrip()
        # An included file is part of several models, and its elements have an address in each.
        meant = tuple("" if is_address(each) else each for each in self.meant)
        said = self.template.removesuffix(DEPARTURES).rstrip(), meant, message
        where = self.location.source.name, self.location.span
        return self.rule.code, where, said, about

    @property
    def sort_key(self) -> tuple[str, int, int, str, str]:
        """Return the order in which findings are reported: by file, place and code."""
        source, span = self.location.source, self.location.span
        return source.name, span.start, span.end, self.rule.code, self.message
