"""The rules that a run asks of its documents, and all that these look at."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from kinlint.catalogue.applicability import applicability, applicable, formats
from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.selection import Policies
from kinlint.configuration.settings import Settings
from kinlint.document import Document
from kinlint.engine.constraint import Constraint
from kinlint.file_format import Format
from kinlint.light_dataclasses import dataclass
from kinlint.rule import Repair, Rule


@dataclass(frozen=True)
class RuleSelection:
    """The rules that apply to documents of some names and formats, with their constraints."""

    rulebook: Rulebook
    """The whole catalogue."""
    policies: Policies
    """The settings of each file."""
    asked: Sequence[Rule]
    """The enabled rules."""
    owners: Mapping[str, frozenset[Format]]
    """The formats that each rule of `asked` applies to, by the IRI of the rule."""
    constraints: Sequence[Constraint]
    """The constraints of `owners` for these formats."""
    repairs: Sequence[Repair]
    """The repairs of `owners`, if they are wanted."""

    @classmethod
    def for_documents(
        cls,
        documents: Sequence[Document],
        settings: Settings,
        rulebook: Rulebook,
        *,
        repairing: bool,
    ) -> RuleSelection:
        """Return the selection by *settings* for *documents*, and if *repairing*, for repairs."""
        policies = Policies(settings, rulebook.rules, formats(documents))
        names = [document.source.name for document in documents]
        enabled = policies.enabled(names)
        asked = [
            rule
            for rule in rulebook.rules
            if rule.code in enabled and not (settings.partial and rule.whole_model)
        ]
        owners = applicability(asked, documents)
        targets = policies.has_targets(names)
        constraints = applicable(rulebook.constraints, owners, targets=targets)
        applied = [rule for rule in asked if repairing and rule.iri in owners]
        repairs = [one for rule in applied for one in rule.repairs]
        return cls(rulebook, policies, asked, owners, constraints, repairs)
