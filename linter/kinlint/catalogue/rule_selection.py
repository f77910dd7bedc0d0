"""What a run asks of its documents: rules, and all that these look at."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

from kinlint.catalogue.applicability import applicability, applicable, formats
from kinlint.catalogue.rulebook import Rulebook
from kinlint.configuration.selection import Policies
from kinlint.configuration.settings import Settings
from kinlint.document import Document
from kinlint.engine.constraint import Constraint
from kinlint.file_format import Format
from kinlint.rule import Repair, Rule


@dataclass(frozen=True)
class RuleSelection:
    """What a run asks of documents of some names and formats.

    `asked` are the rules that speak of any of them, `owners` those by IRI that do of their formats,
    with these formats; `repairs` are theirs, if they are wanted.
    """

    rulebook: Rulebook
    policies: Policies
    asked: Sequence[Rule]
    owners: Mapping[str, frozenset[Format]]
    constraints: Sequence[Constraint]
    repairs: Sequence[Repair]

    @classmethod
    def for_documents(
        cls,
        documents: Sequence[Document],
        settings: Settings,
        rulebook: Rulebook,
        *,
        repairing: bool,
    ) -> RuleSelection:
        """What *settings* ask of *documents*, and if *repairing*, for repairs."""
        policies = Policies(settings, rulebook.rules, formats(documents))
        enabled = policies.enabled(document.source.name for document in documents)
        asked = [
            rule
            for rule in rulebook.rules
            if rule.code in enabled and not (settings.partial and rule.whole_model)
        ]
        owners = applicability(asked, documents)
        constraints = applicable(rulebook.constraints, owners)
        repairs = [one for rule in asked if rule.iri in owners for one in rule.repairs if repairing]
        return cls(rulebook, policies, asked, owners, constraints, repairs)
