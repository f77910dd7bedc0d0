"""Fixes that undo or feed each other, recognised from rounds of changes that find no rest."""

from __future__ import annotations

from collections import Counter
from collections.abc import Hashable, Iterable, Iterator, Sequence
from typing import TypeAlias

from kinlint.fixes.generator import Candidate, FileKind
from kinlint.light_dataclasses import dataclass, field
from kinlint.terms import Term, is_blank

Round: TypeAlias = Sequence[Candidate]
"""The fixes that were made at once."""
Slot: TypeAlias = tuple[str, str, Term]
"""A property of a node: the text of the finding, the node, and the property that a fix writes."""

BARRED = "it and other fixes undo or feed each other"
TWICE = 2
PATIENCE = 3
"""Number of circles after which rules are barred from whole texts, so that there is an end."""


@dataclass
class FixCircles:
    """Fixes that were seen to undo or feed each other, which are not to be made.

    A rule is barred from the properties that its fixes wrote in a circle; where each turn writes
    other ones, such as those of new nodes, from the whole text.
    """

    slots: set[tuple[str, Slot]] = field(default_factory=set)
    """The codes of rules, each with a property that it must not write."""
    kinds: set[FileKind] = field(default_factory=set)
    """The texts in which a rule must not fix anything."""
    codes: set[str] = field(default_factory=set)
    """The codes of the rules that are at odds."""
    _learned: int = 0

    def bars(self, candidate: Candidate) -> bool:
        """Tell whether *candidate* is not to be made."""
        code = candidate.finding.rule.code
        return candidate.kind in self.kinds or any(
            (code, slot) in self.slots for slot in _slots(candidate)
        )

    def learn_cycle(self, rounds: Sequence[Round]) -> None:
        """Bar the fixes of *rounds*, after which the texts are as they were before."""
        self._bar([each for fixes in rounds for each in fixes], by_slot=True)

    def learn_growth(self, rounds: Sequence[Round]) -> None:
        """Bar those fixes of *rounds* after which there is always one more to make.

        They are among the later half: those that write what was written in another round, else
        those of rules that fixed something in several of these rounds.
        """
        late = rounds[len(rounds) // 2 :]
        written = _repeated((slot for each in fixes for slot in _slots(each)) for fixes in rounds)
        again = [each for fixes in late for each in fixes if not written.isdisjoint(_slots(each))]
        if again:
            self._bar(again, by_slot=True)
            return
        kinds = _repeated((each.kind for each in fixes) for fixes in late)
        every = [each for fixes in late for each in fixes]
        self._bar([each for each in every if each.kind in kinds] or every, by_slot=False)

    def _bar(self, fixes: Sequence[Candidate], *, by_slot: bool) -> None:
        """Bar *fixes*, and from whole texts where these properties are barred already."""
        slots = {(each.finding.rule.code, slot) for each in fixes for slot in _slots(each)}
        self._learned += 1
        if by_slot and slots - self.slots and self._learned <= PATIENCE:
            self.slots |= slots
        else:
            self.kinds.update(each.kind for each in fixes)
        self.codes.update(each.finding.rule.code for each in fixes)


def circle_warning(codes: Sequence[str]) -> str:
    """Return the warning about rules, by their *codes*, whose fixes undo or feed each other."""
    if len(codes) == 1:
        return f"fixes of {codes[0]} lead to more of it without end; they were not made"
    names = " and ".join((", ".join(codes[:-1]), codes[-1]))
    return f"fixes of {names} undo or feed each other; they were not made"


def _slots(candidate: Candidate) -> Iterator[Slot]:
    """Yield what *candidate* writes; a node without a name goes by that of the finding."""
    finding = candidate.finding
    for graph, delta in candidate.deltas.items():
        for subject, predicate, _ in (*delta.removed, *delta.added):
            yield graph, finding.iri if is_blank(subject) else subject, predicate


def _repeated(rounds: Iterable[Iterable[Hashable]]) -> set[Hashable]:
    """Return what stands in several of *rounds*."""
    counts = Counter(each for fixes in rounds for each in set(fixes))
    return {each for each, number in counts.items() if number >= TWICE}
