"""Puts together, in the order of the text, what a file loses on its way into the graph."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.formats.json_text.values import Key, Object
from kinlint.formats.jsonld.drift import OtherRelease
from kinlint.formats.jsonld.losses import Detail, Loss, LossWatch, said
from kinlint.formats.jsonld.marks import Iri, Origin, Resolution
from kinlint.formats.jsonld.record import Record, Stray
from kinlint.formats.jsonld.triples import Triples
from kinlint.formats.options import ReadOptions
from kinlint.formats.source_layer import SourceLayer
from kinlint.terms import Term, iri, literal, literal_value
from kinlint.vocabulary import METAMODELS

LOOKED_UP = 1_000
"""How many lost words are compared with the terms of their contexts."""


class LossReport:
    """All losses of one file; *origins* tell which object of the text describes which node."""

    def __init__(
        self, record: Record, watch: LossWatch, triples: Triples, options: ReadOptions
    ) -> None:
        self._record = record
        self._watch = watch
        self._triples = triples
        self._options = options
        self._releases: list[OtherRelease] | None = None
        self._near: dict[tuple[int, str], str | None] = {}

    def losses(self, repeats: list[Object], origins: dict[int, Origin]) -> list[Loss]:
        """The losses in the order of the text."""
        found = [*self._watch.losses, *self._watch.references(), *self._watch.nests()]
        found += [
            *self._types(),
            *self._dropped(),
            *self._strays(),
            *self._contexts(),
            *self._shadows(),
        ]
        for repeated in repeats:
            origin = origins.get(id(repeated))
            found += _duplicates(repeated, self._triples.named(origin) if origin else None)
        return sorted(found, key=_place)

    def state_uses(self, layer: SourceLayer) -> None:
        """Which context documents the file names, and which release of them was read."""
        for _, token in sorted(self._record.uses.items()):
            ours = token.startswith(METAMODELS)
            release = literal(self._options.contexts.release) if ours else None
            details = (("context", literal(token)), ("release", release))
            layer.uses(layer.about("ContextUse", token.span, *details), token.span)

    def _others(self) -> list[OtherRelease]:
        if self._releases is None:
            current = self._options.contexts.release
            names = self._options.releases if self._record.uses else ()
            self._releases = [OtherRelease(r, self._options) for r in names if r != current]
        return self._releases

    def _dropped(self) -> list[Loss]:
        losses = []
        for drop in self._record.drops.values():
            blind = drop.resolution.blind
            kind = "UnreadKey" if blind else "DroppedKey"
            node = self._triples.named(drop.origin)
            loss = Loss(kind, drop.key.span, node, said(key=drop.key))
            if not blind:
                loss = loss.with_details(self._resembles(drop.resolution, drop.key))
                loss = loss.with_details(
                    Detail("mappedInRelease", literal(other.release))
                    for other in self._others()
                    if other.maps_key(drop.key, drop.origin)
                )
            losses.append(loss)
        return losses

    def _resembled_type(self, written: Iri) -> Iterator[Detail]:
        for term in self._resembles(written.resolution, written.token):
            meaning = written.resolution.terms[literal_value(term.value)]
            yield Detail("resembles", iri(meaning["@id"]))

    def _resembles(self, resolution: Resolution, written: str) -> Iterator[Detail]:
        """The term that *written* resembles, as long as few words have been looked up."""
        key = id(resolution.terms), str(written)
        if key not in self._near and len(self._near) < LOOKED_UP:
            self._near[key] = resolution.nearest(written)
        if near := self._near.get(key):
            yield Detail("resembles", literal(near))

    def _strays(self) -> list[Loss]:
        losses = [
            Loss(
                stray.kind,
                stray.span,
                self._triples.named(stray.origin) if stray.origin else None,
                said(written=stray.written, reason=stray.reason, **_in(stray)),
            )
            for stray in self._record.strays.values()
        ]
        for datatype in self._record.unprefixed.values():
            details = said(prefix=datatype.partition(":")[0], written=datatype)
            losses.append(Loss("UndefinedPrefix", datatype.span, None, details))
        return losses

    def _types(self) -> list[Loss]:
        return [
            lost.loss.with_details(
                Detail("mappedInRelease", literal(other.release))
                for other in self._others()
                if lost.origin and other.maps_type(lost.written.token, lost.origin)
            ).with_details(self._resembled_type(lost.written))
            for lost in self._watch.types
        ]

    def _contexts(self) -> list[Loss]:
        losses = []
        for problem in self._record.problems.values():
            details = said(reason=problem.reason)
            if problem.context is not None:
                details = (*said(context=problem.context), *details)
            losses.append(Loss(problem.kind, problem.span, None, details))
        return losses

    def _shadows(self) -> list[Loss]:
        losses = []
        for shadow, token in self._record.shadow_uses.items():
            names = said(term=shadow.term, context=shadow.context, shadowed=shadow.shadowed)
            now, before = iri(shadow.iri), iri(shadow.shadowed_iri)
            iris = (Detail("iri", now), Detail("shadowedIri", before))
            losses.append(Loss("ShadowedTerm", token.span, None, (*names, *iris)))
        return losses


def _duplicates(repeated: Object, node: Term | None) -> list[Loss]:
    """Every occurrence of a key but the first."""
    seen: set[str] = set()
    losses = []
    tokens = [member.key for member in repeated.overwritten or ()]
    again = set(tokens)
    tokens += [key for key in repeated if isinstance(key, Key) and key in again]
    for key in sorted(tokens, key=lambda token: token.start):
        if key in seen:
            losses.append(Loss("DuplicateKey", key.span, node, said(key=key)))
        seen.add(key)
    return losses


def _in(stray: Stray) -> dict[str, str]:
    return {} if stray.key is None else {"key": stray.key}


def _place(loss: Loss) -> tuple[int, int, str]:
    return (*loss.span, loss.kind)
