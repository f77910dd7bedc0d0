"""A rule as its file describes it: severity, examples, repairs. All of it frozen."""

from __future__ import annotations

import re
from collections.abc import Collection, Mapping, Sequence
from enum import IntEnum
from typing import Literal, TypeAlias

from kinlint.light_dataclasses import dataclass
from kinlint.terms import Term, Triple
from kinlint.vocabulary import KL, SH

PLACEHOLDER = re.compile(r"\{[?$](\w+)\}")
"""Placeholder for the value of a variable in a message of a rule; group 1 is its name."""

SpeaksOf: TypeAlias = Literal["", "chosen", "all"]
"""Consumers that a finding may be about: none, the targets of a run, or all that are known."""

KNOWN = "{ # known\n}"
"""Placeholder in the query of a repair for the values that a finding gives its variables."""


class Severity(IntEnum):
    """Severity of a finding; ordered, so that thresholds compare.

    ERROR: refused or misread by a consumer, or physically impossible. WARNING: consumers disagree,
    or very likely a slip. INFO: an assumption worth knowing.
    """

    INFO = 1
    WARNING = 2
    ERROR = 3

    @property
    def label(self) -> str:
        """Return the word for users: `error`, `warning` or `info`."""
        return self.name.lower()


class Applicability(IntEnum):
    """Degree to which a fix may be trusted; ordered, so that thresholds compare.

    SAFE: the meaning stays, and no consumer newly refuses the file. UNSAFE: it takes a decision
    that the author may want to see. DISPLAY: shown only, never written.
    """

    DISPLAY = 1
    UNSAFE = 2
    SAFE = 3

    @property
    def label(self) -> str:
        """Return the word for users: `safe`, `unsafe` or `display-only`."""
        return "display-only" if self is Applicability.DISPLAY else self.name.lower()


PROGRAMS = "GEN"
"""The family of the rules for generated programs; only `kinlint generate` runs them."""

SEVERITY_BY_IRI = {
    f"{SH}Violation": Severity.ERROR,
    f"{SH}Warning": Severity.WARNING,
    f"{SH}Info": Severity.INFO,
}
"""Severities by the IRIs that SHACL has for them."""


SPEAKS_OF: Mapping[str, SpeaksOf] = {f"{KL}chosenTargets": "chosen", f"{KL}allConsumers": "all"}
"""Values of `kl:speaksOf`: the consumers that a finding may be about, by IRI."""


@dataclass(frozen=True, slots=True)
class Example:
    """A pair of texts in a rule file: one with the fault, one without."""

    format: str
    """Name of the format."""
    bad: str | None
    """Text with `[|…|]` around what must be flagged."""
    good: str | None
    """Text that must not be flagged."""
    beside: tuple[str, ...] = ()
    """Paths of empty files in the same directory and below, for rules about files."""
    companions: tuple[tuple[str, str], ...] = ()
    """Files that are read with it: the format and the text of each."""
    fixed: str | None = None
    """Result of the preferred fix of `bad`, where that is not `good`."""
    unfixable: bool = False
    """True if no fix is possible."""


@dataclass(frozen=True, slots=True)
class SeverityFor:
    """Severity of a rule for certain consumers, or in files of certain formats."""

    severity: Severity
    """The severity."""
    targets: tuple[str, ...] = ()
    """Consumers it holds for; none named is all."""
    formats: tuple[str, ...] = ()
    """Formats it holds for; none named is all."""

    def applies(self, targets: Collection[str], form: str) -> bool:
        """Tell whether this severity applies to files of format *form* for *targets*."""
        about = not self.targets or not set(self.targets).isdisjoint(targets)
        return about and (not self.formats or form in self.formats)


@dataclass(frozen=True, slots=True)
class Repair:
    """A repair of a rule: a SPARQL Update, taken apart when the rule is compiled."""

    title: str
    """Imperative with `{?variable}` placeholders."""
    applicability: Applicability
    """The most that the author claims."""
    update: str
    """The update as written, with its prefixes."""
    query: str
    """SELECT for `variables`, in which `KNOWN` is replaced by the values of the finding."""
    variables: tuple[str, ...]
    """Names of the variables in the update."""
    removed: tuple[Triple, ...]
    """Templates of triples to delete: N-Triples tokens and `?variables`."""
    added: tuple[Triple, ...]
    """Templates of triples to insert; blank nodes stand for new ones."""
    terms: tuple[Term, ...] = ()
    """IRIs that the update mentions."""
    assigned: tuple[str, ...] = ()
    """Names of the variables that the query binds itself, by AS or VALUES."""
    why: str = ""
    """Reason why it is not safe."""
    formats: tuple[str, ...] = ()
    """Formats it applies to; none named is all of the rule."""
    order: float = 0.0
    """Rank among the repairs of the rule."""


@dataclass(frozen=True, slots=True)
class Rule:
    """A rule, as its file describes it."""

    iri: str
    """IRI of the rule."""
    code: str
    """Code, such as `UNI002`."""
    name: str
    """Name in kebab case, which is that of its file."""
    title: str
    """The fault in a few words."""
    why: str
    """The reason why it matters: what breaks."""
    severity: Severity
    """Default severity."""
    antipatterns: tuple[str, ...] = ()
    """Anti-patterns it witnesses, `AP1` to `AP6`."""
    symptoms: tuple[str, ...] = ()
    """Symptoms of anti-patterns it witnesses, such as `AP1.4`."""
    formats: tuple[str, ...] = ()
    """Names of the formats it applies to."""
    links: tuple[str, ...] = ()
    """Web addresses to read on."""
    messages: tuple[str, ...] = ()
    """Templates of its messages."""
    examples: Sequence[Example] = ()
    """Its examples."""
    since: str = ""
    """Version that brought it, such as `0.2.0`; empty for the first."""
    path: str = ""
    """Path of its file."""
    whole_model: bool = False
    """True if the rule can only judge when all files of the model are given."""
    targets: tuple[str, ...] = ()
    """Consumers it is about; it is off unless a run names one of them."""
    severity_for: tuple[SeverityFor, ...] = ()
    """Severities for certain consumers or formats."""
    group_by: tuple[str, ...] = ()
    """Variables whose values make one finding of many places in a file; `file` groups all of a
    file.
    """
    worst: str = ""
    """Variable whose greatest value makes a finding the one that its group shows; empty if none."""
    explains: tuple[str, ...] = ()
    """Queries for what a finding of it makes uncertain, so that other findings follow from it."""
    unparsable: bool = False
    """True if a finding means that its file cannot be parsed, so that the exit code is 2."""
    preview: bool = False
    """True if the rule is not settled: it is off unless previews are on or it is named."""
    optional: bool = False
    """True if the rule is off unless selected."""
    repairs: Sequence[Repair] = ()
    """Its repairs, the preferred first."""
    also: tuple[Severity, ...] = ()
    """Severities of single constraints that differ from `severity`."""
    also_for: tuple[SeverityFor, ...] = ()
    """Severities of single constraints for certain consumers or formats."""
    features: tuple[str, ...] = ()
    """Names of the features of descriptions that it finds, which consumers read differently."""
    speaks_of: SpeaksOf = ""
    """Consumers whose departures from what is written it reports: those of the run, or of all."""
    facts: tuple[tuple[str, str], ...] = ()
    """Names of the facts that it asks for, each with the module that computes it."""

    def severity_for_targets(
        self, targets: Collection[str] = (), form: str = ""
    ) -> Severity | None:
        """Return the severity in a file of format *form* for *targets*; None if the rule is off.

        A severity for a target precedes one for a format alone, and of equals the worst counts.
        """
        if self.targets and set(self.targets).isdisjoint(targets):
            return None
        if self.speaks_of == "chosen" and not targets:
            return None
        meant = [each for each in self.severity_for if each.applies(targets, form)]
        special = [each.severity for each in meant if each.targets]
        return max(special or [each.severity for each in meant], default=self.severity)

    def concerns(self, targets: Collection[str]) -> bool:
        """Tell whether the rule is about one of *targets* in particular."""
        every = (*self.severity_for, *self.also_for)
        said = {*self.targets, *(target for each in every for target in each.targets)}
        return not said.isdisjoint(targets)

    @property
    def family(self) -> str:
        """Return the letters of the code: `UNI` of `UNI002`."""
        return self.code.rstrip("0123456789")
