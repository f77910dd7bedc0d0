"""What is passed along: rules, findings and their parts. All of it frozen."""

from __future__ import annotations

import hashlib
from dataclasses import dataclass, field
from enum import IntEnum

from kinlint.terms import Term
from kinlint.text import Position, SourceText, Span


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
    """A pair from a rule file: `bad` with `[|…|]` round what must be flagged, or `good`."""

    format: str
    bad: str | None
    good: str | None


@dataclass(frozen=True, slots=True)
class Rule:
    """One rule, as its file describes it.

    `antipatterns` are `AP1` to `AP6`, `symptoms` what they look like, such as `AP1.4`.
    `whole_model` marks a rule that can only judge when all files of the model are given.
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

    @property
    def family(self) -> str:
        """The letters of the code: `UNI` of `UNI002`."""
        return self.code.rstrip("0123456789")


@dataclass(frozen=True, slots=True)
class Location:
    """A span of a source; `start` and `end` are for those who print."""

    source: SourceText
    span: Span

    @property
    def start(self) -> Position:
        """Line and column of the first character."""
        return self.source.position(self.span.start)

    @property
    def end(self) -> Position:
        """Line and column just after the last character."""
        return self.source.position(self.span.end)


@dataclass(frozen=True, slots=True)
class Related:
    """Another place that a finding speaks of, with what stands there."""

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

    @property
    def fingerprint(self) -> str:
        """An identity that survives moving and re-indenting: rule, entity, path and value."""
        what = [self.rule.code, self.iri, self.path or "", *self.arguments]
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
