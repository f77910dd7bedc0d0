"""Generates fixes: the repairs of rules, written as edits."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from itertools import pairwise
from pathlib import Path

from kinlint.catalogue.applicability import covers
from kinlint.edits import Edit, NotExpressible, overlap
from kinlint.finding import Finding, Fix
from kinlint.fixes.dry_run import changed_triples
from kinlint.fixes.generator import Candidate, Generator
from kinlint.fixes.placing import place_delta
from kinlint.rule import Applicability, Repair
from kinlint.text import SourceText


class FixGenerator(Generator):
    """Writes the repairs of what an examination found in texts."""

    def candidates(self, findings: Sequence[Finding], least: Applicability) -> list[Candidate]:
        """Return the repairs of *findings* that can be written, of each the preferred first."""
        found = []
        for finding in findings:
            trust = self.policies.trust(finding.location.source.name)
            if finding.rule.repairs and trust.allows_fixes(finding.rule):
                found += [
                    each
                    for each in self._repairs(finding)
                    if trust.applicability(finding.rule, each.repair.applicability) >= least
                ]
        return found

    def batches(self, candidates: Sequence[Candidate]) -> Iterator[list[Candidate]]:
        """Sort *candidates* into batches: the preferred of each finding first.

        Findings that the same edits fix are fixed together.
        """
        left = sorted(candidates, key=lambda each: (each.rank, each.finding.sort_key))
        while left:
            batch, later = list[Candidate](), list[Candidate]()
            taken: dict[Path, list[Edit]] = {}
            fixed = set[int]()
            for each in left:
                clash = id(each.finding) in fixed or any(
                    overlap(edits, taken.get(path, ()))
                    and not set(edits) <= set(taken.get(path, ()))
                    for path, edits in each.edits.items()
                )
                (later if clash else batch).append(each)
                if not clash:
                    fixed.add(id(each.finding))
                    for path, edits in each.edits.items():
                        taken.setdefault(path, []).extend(edits)
            yield batch
            left = later

    def combined(self, batch: Sequence[Candidate]) -> Sequence[Candidate]:
        """Return *batch*, whose edits do not touch each other."""
        return batch

    def weighed(self, finding: Finding, fix: Fix) -> Fix:
        """Return *fix* with the applicability that the settings give it."""
        trust = self.policies.trust(finding.location.source.name)
        return trust.weighed_fix(finding.rule, fix)

    def _repairs(self, finding: Finding) -> Sequence[Candidate]:
        """Return the repairs of *finding* that can be written, the preferred first."""
        found: list[Candidate] = []
        form = self.homes[finding.location.source.name].format
        for rank, repair in enumerate(finding.rule.repairs):
            if not covers(repair.formats, form):
                continue
            try:
                candidate = self._written(finding, repair, rank)
            except NotExpressible as reason:
                self.refused.append((finding, repair, str(reason)))
            else:
                again = any(candidate and candidate.edits == each.edits for each in found)
                found += [candidate] if candidate is not None and not again else []
        return found

    def _written(self, finding: Finding, repair: Repair, rank: int) -> Candidate | None:
        """Return *repair* of *finding* as edits; None where it changes nothing."""
        builder, store = self.examination.builder, self.examination.store
        members = finding.members or (finding,)
        results = [result for each in members for result in builder.results(each)]
        meant = changed_triples(store, repair, results)
        if not meant:
            return None
        where = place_delta(builder.provenance, meant, self.homes[finding.location.source.name])
        edits: dict[Path, dict[Edit, None]] = {}
        sources: dict[Path, SourceText] = {}
        for graph, delta in where.deltas.items():
            document = store.documents[graph]
            made = self.editor(document).edits(delta)
            if not made:
                raise NotExpressible("the text says it already")
            for span, text in made:
                place = document.location(span)
                path = self.writable_path(document, place.source)
                if sources.setdefault(path, place.source).text != place.source.text:
                    raise NotExpressible("the file has changed since it was read")
                edits.setdefault(path, {})[Edit(place.span, text)] = None
        title = builder.filled(repair.title, finding)
        return Candidate(
            finding, repair, title, rank, meant, where.lifted, where.deltas,
            {path: _ordered(own) for path, own in edits.items()}, sources,
        )  # fmt: skip


def _ordered(edits: Iterable[Edit]) -> tuple[Edit, ...]:
    """Sort *edits* of one text; raise `NotExpressible` if its uses are to say different things."""
    ordered = sorted(edits, key=lambda edit: edit.span)
    if any(overlap((one,), (other,)) for one, other in pairwise(ordered)):
        raise NotExpressible("the text stands for several elements, which differ then")
    return tuple(ordered)
