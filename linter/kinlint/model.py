"""What is passed along: rules, findings and their parts. All of it frozen."""

from __future__ import annotations

import hashlib
from collections.abc import Collection
from dataclasses import dataclass, field
from enum import IntEnum
from urllib.parse import unquote

from kinlint.terms import Term
from kinlint.text import Location
from kinlint.vocabulary import DOCUMENT_IRI


class Severity(IntEnum):
    """How bad a finding is; ordered, so that thresholds compare.

    ERROR: refused or silently misread by a consumer, or physically impossible.
    WARNING: consumers disagree, or very likely a slip. INFO: an assumption worth knowing.
    """

    INFO = 1
    WARNING = 2
    ERROR = 3

    @property
    def label(self) -> str:
        """The word for users: `error`, `warning` or `info`."""
        return self.name.lower()


@dataclass(frozen=True, slots=True)
class Example:
    """A pair from a rule file: `bad` with `[|…|]` round what must be flagged, or `good`.

    `beside` are the paths of files in the same directory and below, for rules about them.
    `companions` are files that are read with it, the format and the text of each.
    """

    format: str
    bad: str | None
    good: str | None
    beside: tuple[str, ...] = ()
    companions: tuple[tuple[str, str], ...] = ()


@dataclass(frozen=True, slots=True)
class SeverityFor:
    """What a rule counts as for any of some consumers, in files of any of some formats.

    None named is all there are.
    """

    severity: Severity
    targets: tuple[str, ...] = ()
    formats: tuple[str, ...] = ()

    def holds(self, targets: Collection[str], form: str) -> bool:
        """Whether this is about a file of format *form* that is meant for *targets*."""
        about = not self.targets or not set(self.targets).isdisjoint(targets)
        return about and (not self.formats or form in self.formats)


@dataclass(frozen=True, slots=True)
class Rule:
    """One rule, as its file describes it.

    `antipatterns` are `AP1` to `AP6`, `symptoms` what they look like, such as `AP1.4`.
    `whole_model` marks a rule that can only judge when all files of the model are given.
    `targets` are the consumers that the rule is about: unless a run names one of them, it is
    silent. `severity_for` is what it counts as for some consumers, or in files of some formats.
    `group_by` are the variables whose values make one finding of many places in a file; of
    `file`, all places. `optional` marks a matter of taste: silent unless it is selected.
    """

    iri: str
    code: str
    name: str
    title: str
    why: str
    severity: Severity
    antipatterns: tuple[str, ...] = ()
    symptoms: tuple[str, ...] = ()
    formats: tuple[str, ...] = ()
    links: tuple[str, ...] = ()
    messages: tuple[str, ...] = ()
    examples: tuple[Example, ...] = ()
    since: str = ""
    path: str = ""
    whole_model: bool = False
    targets: tuple[str, ...] = ()
    severity_for: tuple[SeverityFor, ...] = ()
    group_by: tuple[str, ...] = ()
    optional: bool = False

    def counts_as(self, targets: Collection[str] = (), form: str = "") -> Severity | None:
        """What the rule counts as in a file of format *form* for those who mean *targets*.

        What is said of a target comes before what is said of a format alone, and of equals the
        worst counts. None if the rule does not speak.
        """
        if self.targets and set(self.targets).isdisjoint(targets):
            return None
        meant = [each for each in self.severity_for if each.holds(targets, form)]
        special = [each.severity for each in meant if each.targets]
        return max(special or [each.severity for each in meant], default=self.severity)

    def speaks_for(self, targets: Collection[str]) -> bool:
        """Whether the rule says anything of one of *targets* in particular."""
        said = {*self.targets, *(target for each in self.severity_for for target in each.targets)}
        return not said.isdisjoint(targets)

    @property
    def family(self) -> str:
        """The letters of the code: `UNI` of `UNI002`."""
        return self.code.rstrip("0123456789")


@dataclass(frozen=True, slots=True)
class Related:
    """Another place that a finding speaks of, with what stands there.

    No message: the place is one more of what the finding found.
    """

    location: Location
    message: str


@dataclass(frozen=True, slots=True)
class Premise:
    """A statement that a finding rests on, for people: asserted at a place, or inferred.

    `depth` 0 is a triple the rule itself matched; its premises follow it at depth 1, and so on.
    `axiom` says in words by which axiom an inferred statement follows, or what a computed one is
    computed from.
    """

    statement: str
    location: Location | None = None
    axiom: str = ""
    depth: int = 0

    @property
    def inferred(self) -> bool:
        """Whether the statement was derived rather than written."""
        return bool(self.axiom)

    @property
    def computed(self) -> bool:
        """Whether it follows by arithmetic, from what stands below it, and by no axiom."""
        return self.axiom.startswith("computed from")


@dataclass(frozen=True, slots=True)
class Finding:
    """A defect at a place.

    `message` is `template` with its `arguments` filled in. `iri` is the entity concerned, an
    absolute IRI or a blank node label; `path` and `value` are terms where the rule names them.
    `group` is what it has in common with others that are told with it (`Rule.group_by`).
    """

    rule: Rule
    severity: Severity
    message: str
    location: Location
    iri: str
    focus: Term
    path: Term | None = None
    value: Term | None = None
    template: str = ""
    arguments: tuple[str, ...] = ()
    related: tuple[Related, ...] = ()
    because: tuple[Premise, ...] = ()
    suppressed: str | None = field(default=None)
    group: tuple[str, ...] = ()

    @property
    def entity(self) -> str:
        """`iri` for people: of what stands in a file of elements, the file and the way to it.

        What was made of an element is named like an element: `arm.urdf#/link/base/inertia`.
        """
        if not self.iri.startswith(DOCUMENT_IRI):
            return self.iri
        name, mark, path = unquote(self.iri[len(DOCUMENT_IRI) :]).partition("#")
        return f"{name}#/{path.removeprefix('/')}" if mark and path else name

    @property
    def fingerprint(self) -> str:
        """An identity that survives moving and re-indenting: rule, entity, path and value.

        Of a group: rule and what it has in common, whoever is in it.
        """
        alone = self.iri, self.path or "", *self.arguments
        what = [self.rule.code, *(self.group if self.rule.group_by else alone)]
        return hashlib.sha256("\x1f".join(what).encode("utf-8", "surrogatepass")).hexdigest()[:32]

    @property
    def sort_key(self) -> tuple[str, int, int, str, str]:
        """Findings are reported by file, place and code."""
        return (
            self.location.source.name,
            self.location.span.start,
            self.location.span.end,
            self.rule.code,
            self.message,
        )
