"""What is passed along: rules, findings and their parts. All of it frozen."""

from __future__ import annotations

import hashlib
import re
from collections.abc import Collection
from dataclasses import dataclass, field
from enum import IntEnum

from kinlint.addresses import is_address, readable
from kinlint.terms import Term, Triple
from kinlint.text import Location, SourceText

PLACEHOLDER = re.compile(r"\{[?$](\w+)\}")
"""Where a message of a rule has the value of a variable, and the name of that."""


class Severity(IntEnum):
    """How bad a finding is; ordered, so that thresholds compare.

    ERROR: refused or misread by a consumer, or physically impossible. WARNING: consumers disagree,
    or very likely a slip. INFO: an assumption worth knowing.
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
    `companions` are files that are read with it, the format and the text of each. `fixed` is what
    the preferred fix makes of `bad`, where that is not `good`; `unfixable` tells that none can.
    """

    format: str
    bad: str | None
    good: str | None
    beside: tuple[str, ...] = ()
    companions: tuple[tuple[str, str], ...] = ()
    fixed: str | None = None
    unfixable: bool = False


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


class Applicability(IntEnum):
    """How far a fix may be trusted.

    SAFE: the meaning stays, and no consumer newly refuses the file. UNSAFE: it takes a decision
    that the author may want to see. DISPLAY: shown only, never written.
    """

    DISPLAY = 1
    UNSAFE = 2
    SAFE = 3

    @property
    def label(self) -> str:
        """The word for users: `safe`, `unsafe` or `display-only`."""
        return "display-only" if self is Applicability.DISPLAY else self.name.lower()


KNOWN = "{ # known\n}"
"""Where the query of a repair is told what a finding has for its variables."""


@dataclass(frozen=True, slots=True)
class Repair:
    """How a rule mends what it finds: a SPARQL Update, taken apart when the catalogue is compiled.

    `title` is an imperative with `{?variable}` placeholders, `applicability` what the author claims
    at most and `why` the reason that it is no more. `formats` are those it can be said in; none
    named is all of the rule. `update` is the text of the author, with prefixes. `query` selects
    `variables`, once `KNOWN` gives way to what is known of them; `removed` and `added` are the
    templates that are filled with each solution, in N-Triples tokens, `?variables` and blank nodes.
    `terms` are the IRIs that it speaks of.
    """

    title: str
    applicability: Applicability
    update: str
    query: str
    variables: tuple[str, ...]
    removed: tuple[Triple, ...]
    added: tuple[Triple, ...]
    terms: tuple[Term, ...] = ()
    why: str = ""
    formats: tuple[str, ...] = ()
    order: float = 0.0


@dataclass(frozen=True, slots=True)
class TextEdit:
    """What stands at a place gives way to `text`."""

    location: Location
    text: str


@dataclass(frozen=True, slots=True)
class Fix:
    """A repair of one finding, as edits of texts, ascending and without overlap in each.

    `title` has its placeholders filled in. `update` is the change of the graph as a SPARQL Update
    without variables, `removed` and `added` are its triples. `applicability` is what the repair
    claims and the proof allows; `why` tells why it is not safe, if it is not.
    """

    title: str
    applicability: Applicability
    edits: tuple[TextEdit, ...]
    update: str
    why: str = ""
    removed: tuple[Triple, ...] = ()
    added: tuple[Triple, ...] = ()

    @property
    def sources(self) -> tuple[SourceText, ...]:
        """The texts that are changed, each once."""
        return tuple({id(one.location.source): one.location.source for one in self.edits}.values())


@dataclass(frozen=True, slots=True)
class Rule:
    """One rule, as its file describes it.

    `antipatterns` are `AP1` to `AP6`, `symptoms` what they look like, such as `AP1.4`.
    `whole_model` marks a rule that can only judge when all files of the model are given.
    `targets` are the consumers that the rule is about: unless a run names one of them, it is
    silent. `repairs` are the ways to mend it, the preferred first. `severity_for` is what it
    counts as for some consumers, or in files of some formats.
    `group_by` are the variables whose values make one finding of many places in a file; of
    `file`, all places. `optional` marks a matter of taste: silent unless it is selected.
    `also` are severities that single constraints have in place of `severity`.
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
    repairs: tuple[Repair, ...] = ()
    also: tuple[Severity, ...] = ()

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

    `message` is `template` with its `arguments` filled in; `meant` is what they stand for, however
    the file or its neighbours abbreviate that. `iri` is the entity concerned, an absolute IRI or a
    blank node label; `path` and `value` are terms where the rule names them.
    `group` is what it has in common with others that are told with it (`Rule.group_by`).
    `members` are those told as this one, if they are several. `fixes` are alternatives, the
    preferred first.
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
    meant: tuple[str, ...] = ()
    related: tuple[Related, ...] = ()
    because: tuple[Premise, ...] = ()
    suppressed: str | None = field(default=None)
    group: tuple[str, ...] = ()
    members: tuple[Finding, ...] = ()
    fixes: tuple[Fix, ...] = ()

    def fix(self, least: Applicability) -> Fix | None:
        """The first of the fixes that may be trusted at least so far: what `--fix` makes."""
        return next((each for each in self.fixes if each.applicability >= least), None)

    @property
    def entity(self) -> str:
        """`iri` for people: of what stands in a file of elements, the file and the way to it.

        What was made of an element is named like an element: `arm.urdf#/link/base/inertia`.
        """
        return readable(self.iri) if is_address(self.iri) else self.iri

    @property
    def fingerprint(self) -> str:
        """An identity that survives moving and re-indenting: rule, entity, path and value.

        Of a group: rule and what it has in common, whoever is in it.
        """
        alone = self.iri, self.path or "", *(self.meant or self.arguments)
        what = [self.rule.code, *(self.group if self.rule.group_by else alone)]
        return hashlib.sha256("\x1f".join(what).encode("utf-8", "surrogatepass")).hexdigest()[:32]

    @property
    def sort_key(self) -> tuple[str, int, int, str, str]:
        """Findings are reported by file, place and code."""
        source, span = self.location.source, self.location.span
        return source.name, span.start, span.end, self.rule.code, self.message
