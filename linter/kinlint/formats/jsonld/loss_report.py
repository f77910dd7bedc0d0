"""Losses of a file in RDF, in the order of the text, and comparison with other releases."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from typing import Any

from kinlint.formats.json_text.json_values import Key, Object, Text
from kinlint.formats.jsonld.active_context import FAULTS, Context
from kinlint.formats.jsonld.context_cache import ContextCache
from kinlint.formats.jsonld.expander import Processor
from kinlint.formats.jsonld.expansion_record import ExpansionRecord, ShadowedTerm, StrayValue
from kinlint.formats.jsonld.local_contexts import LocalContexts
from kinlint.formats.jsonld.losses import Detail, Loss, LossObserver, text_details
from kinlint.formats.jsonld.term_definitions import definitions, mentioned
from kinlint.formats.jsonld.traced_values import Iri, Origin, Resolution
from kinlint.formats.jsonld.triples import Triples
from kinlint.formats.options import ReadOptions
from kinlint.formats.source_layer import SourceLayer
from kinlint.terms import Term, iri, literal, literal_value
from kinlint.text import Span
from kinlint.vocabulary import METAMODELS

_MAPPED = re.compile(r"([A-Za-z][A-Za-z0-9+-.]*|_):[^\s]*$|@[a-z]+$")


class OtherRelease:
    """The contexts in force at the objects of a file, had it been read under *release*."""

    def __init__(self, release: str, options: ReadOptions, local: LocalContexts) -> None:
        self.release = release
        memory = ContextCache.from_options(options, release)
        self._processor = Processor(memory, options.base, local)
        self._at: dict[Origin, tuple[Context, Context]] = {}

    def maps_key(self, key: Text, origin: Origin) -> bool:
        """Tell whether the release maps *key* on the node of *origin*."""
        return self._means(self._contexts(origin)[0], key, None)

    def maps_type(self, name: Text, origin: Origin) -> bool:
        """Tell whether *name* is a type in the release."""
        return self._means(self._contexts(origin)[1], name, None)

    def _means(self, context: Context, name: str, base: str | None) -> bool:
        found = self._processor._expand_iri(context, str(name), base, vocab=True)  # noqa: SLF001
        return isinstance(found, str) and _MAPPED.match(found) is not None

    def _contexts(self, origin: Origin) -> tuple[Context, Context]:
        """Return the active context for the keys of *origin*, and the one for its types."""
        if origin not in self._at:
            processor = self._processor
            if origin.parent is None:
                outer = processor._get_initial_context(processor.options)  # noqa: SLF001
            else:
                outer = self._contexts(origin.parent)[0]
            self._at[origin] = self._inner(outer, origin)
        return self._at[origin]

    def _inner(self, outer: Context, origin: Origin) -> tuple[Context, Context]:
        """Return the contexts after those of an object.

        Steps 3 and 7 to 11 of the expansion algorithm.
        """
        processor: Any = self._processor
        try:
            outer = processor.entering(outer, origin.prop)
            processor.trail.append(origin)
            keys, _, types = processor._prepare_nested_context(  # noqa: SLF001
                outer, origin.element, processor.options
            )
            processor.trail.pop()
        except FAULTS:
            return outer, outer
        return keys, types


LOOKED_UP = 1_000
"""Number of lost words that are compared with the terms of their contexts."""


class ReleaseComparison:
    """Comparison of lost words with the terms of their contexts, and of other releases."""

    def __init__(self, options: ReadOptions, local: LocalContexts) -> None:
        self._options = options
        self._local = local
        self._releases: list[OtherRelease] | None = None
        self._near: dict[tuple[int, str], str | None] = {}

    @property
    def looked_up(self) -> int:
        """Return the number of words compared so far."""
        return len(self._near)

    def others(self, *, named: bool) -> list[OtherRelease]:
        """Return the other releases, if a context is *named* that they might have."""
        if self._releases is None:
            current = self._options.contexts.release
            names = self._options.releases if named else ()
            self._releases = [
                OtherRelease(each, self._options, self._local) for each in names if each != current
            ]
        return self._releases

    def resembles(self, resolution: Resolution, written: str) -> Iterator[Detail]:
        """Yield the term that *written* resembles, as long as few words have been looked up."""
        key = id(resolution.terms), str(written)
        if key not in self._near and len(self._near) < LOOKED_UP:
            self._near[key] = resolution.nearest(written)
        if near := self._near.get(key):
            yield Detail("resembles", literal(near))


class LossReport:
    """All losses of one file, or of a part of one that *compared* knows more of."""

    def __init__(
        self,
        record: ExpansionRecord,
        watch: LossObserver,
        triples: Triples,
        compared: ReleaseComparison,
    ) -> None:
        self._record = record
        self._watch = watch
        self._triples = triples
        self._compared = compared

    def losses(self, repeats: Iterable[Object], origins: Mapping[int, Origin]) -> list[Loss]:
        """Return the losses in the order of the text.

        *origins* are of the objects that are *repeats*.
        """
        found = [*self._watch.losses, *self._watch.references(), *self._watch.nests()]
        found += [
            *self.types(),
            *self.dropped(),
            *self.strays(),
            *self.contexts(),
            *shadowed((each, token.span) for each, token in self._record.shadow_uses.items()),
            *self.duplicates(repeats, origins),
        ]
        return sorted(found, key=sort_key)

    def _others(self) -> list[OtherRelease]:
        return self._compared.others(named=bool(self._record.uses))

    def dropped(self) -> list[Loss]:
        """Return the keys without a meaning."""
        losses = []
        for drop in self._record.drops.values():
            blind = drop.resolution.blind
            kind = "UnreadKey" if blind else "DroppedKey"
            node = self._triples.named(drop.origin)
            details = (*text_details(key=drop.key), *mentioned(drop))
            loss = Loss(kind, drop.key.span, node, details)
            if not blind:
                loss = loss.with_details(self._compared.resembles(drop.resolution, drop.key))
                loss = loss.with_details(
                    Detail("mappedInRelease", literal(other.release))
                    for other in self._others()
                    if other.maps_key(drop.key, drop.origin)
                )
            losses.append(loss)
        return losses

    def _resembled_type(self, written: Iri) -> Iterator[Detail]:
        for term in self._compared.resembles(written.resolution, written.token):
            meaning = written.resolution.terms[literal_value(term.value)]
            yield Detail("resembles", iri(meaning["@id"]))

    def strays(self) -> list[Loss]:
        """Return the values without effect, and the datatypes without a prefix."""
        losses = [
            Loss(
                stray.kind,
                stray.span,
                self._triples.named(stray.origin) if stray.origin else None,
                text_details(written=stray.written, reason=stray.reason, **_in(stray)),
            )
            for stray in self._record.strays.values()
        ]
        for datatype in self._record.unprefixed.values():
            details = text_details(prefix=datatype.partition(":")[0], written=datatype)
            losses.append(Loss("UndefinedPrefix", datatype.span, None, details))
        return losses

    def types(self) -> list[Loss]:
        """Return the types that are relative IRIs."""
        return [
            lost.loss.with_details(
                Detail("mappedInRelease", literal(other.release))
                for other in self._others()
                if lost.origin and other.maps_type(lost.written.token, lost.origin)
            ).with_details(self._resembled_type(lost.written))
            for lost in self._watch.types
        ]

    def contexts(self) -> list[Loss]:
        """Return the contexts that are missing or broken."""
        losses = []
        for problem in self._record.problems.values():
            details = text_details(reason=problem.reason)
            if problem.context is not None:
                details = (*text_details(context=problem.context), *details)
            losses.append(Loss(problem.kind, problem.span, None, details))
        return [*losses, *definitions(self._record, self._triples)]

    def duplicates(self, repeats: Iterable[Object], origins: Mapping[int, Origin]) -> list[Loss]:
        """Return the keys that stand in an object before."""
        losses: list[Loss] = []
        for repeated in repeats:
            origin = origins.get(id(repeated))
            losses += _duplicates(repeated, self._triples.named(origin) if origin else None)
        return losses


def shadowed(uses: Iterable[tuple[ShadowedTerm, Span]]) -> list[Loss]:
    """Return the terms whose meaning differs from an earlier context, at their first places."""
    losses = []
    for shadow, span in uses:
        names = text_details(term=shadow.term, context=shadow.context, shadowed=shadow.shadowed)
        now, before = iri(shadow.iri), iri(shadow.shadowed_iri)
        iris = (Detail("iri", now), Detail("shadowedIri", before))
        losses.append(Loss("ShadowedTerm", span, None, (*names, *iris)))
    return losses


def state_uses(layer: SourceLayer, uses: Iterable[tuple[Span, str]], release: str) -> None:
    """State which contexts the file uses, and where; metamodel contexts are of *release*."""
    for span, name in sorted(uses):
        version = literal(release) if name.startswith(METAMODELS) else None
        details = (("context", literal(name)), ("release", version))
        layer.state_context_use(layer.add_node("ContextUse", span, *details), span)


def state_losses(layer: SourceLayer, losses: Iterable[Loss]) -> None:
    """State the losses of the file, in this order."""
    for loss in losses:
        details = [(detail.name, detail.value) for detail in loss.details]
        layer.add_node(loss.kind, loss.span, (loss.relation, loss.node), *details)


def sort_key(loss: Loss) -> tuple[int, int, str]:
    """Return the sort key of losses."""
    return (*loss.span, loss.kind)


def _duplicates(repeated: Object, node: Term | None) -> list[Loss]:
    """Return the losses of repeated keys: every occurrence but the first."""
    seen: set[str] = set()
    losses = []
    tokens = [member.key for member in repeated.overwritten or ()]
    again = set(tokens)
    tokens += [key for key in repeated if isinstance(key, Key) and key in again]
    for key in sorted(tokens, key=lambda token: token.start):
        if key in seen:
            losses.append(Loss("DuplicateKey", key.span, node, text_details(key=key)))
        seen.add(key)
    return losses


def _in(stray: StrayValue) -> dict[str, str]:
    return {} if stray.key is None else {"key": stray.key}
