"""Losses of a file in RDF, in the order of the text, and comparison with other releases."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping, Sequence

from kinlint.formats.json_text.json_values import Key, Object, Text
from kinlint.formats.jsonld.expansion_record import (
    DroppedKey,
    ExpansionRecord,
    ShadowedTerm,
    StrayValue,
)
from kinlint.formats.jsonld.losses import Detail, Loss, LossObserver, text_details, unless
from kinlint.formats.jsonld.release_comparison import OtherRelease, ReleaseComparison
from kinlint.formats.jsonld.resemblance import nearest_property
from kinlint.formats.jsonld.term_definitions import definitions, mentioned, strings
from kinlint.formats.jsonld.traced_values import Iri, Origin
from kinlint.formats.jsonld.triples import Triples
from kinlint.formats.source_layer import SourceLayer
from kinlint.terms import Term, iri, literal
from kinlint.text import Span
from kinlint.vocabulary import METAMODELS


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
        beside: dict[int, list[Text]] = {}
        for drop in self._record.drops.values():
            beside.setdefault(id(drop.origin.element), []).append(drop.key)
        for drop in self._record.drops.values():
            kind = "UnreadKey" if drop.resolution.unless else "DroppedKey"
            node = self._triples.named(drop.origin)
            lost = beside[id(drop.origin.element)]
            details = (
                *text_details(key=drop.key),
                *unless(drop.resolution),
                *mentioned(drop),
                *self._explained(drop, lost),
            )
            losses.append(Loss(kind, drop.key.span, node, details))
        return losses

    def _explained(self, drop: DroppedKey, lost: Sequence[Text]) -> Iterator[Detail]:
        """Yield what the key may have been: elsewhere, on other nodes, or in another spelling.

        *lost* are all keys that its object loses.
        """
        key, origin = drop.key, drop.origin
        elsewhere = {
            other.release: found
            for other in self._others()
            if (found := other.key_iri(key, origin)) is not None
        }
        yield from _mapped(elsewhere)
        terms, meant = drop.resolution.terms, frozenset(elsewhere.values())
        has = [each for name in ("@type", "type") for each in strings(origin.element.get(name))]
        types = self._compared.scopes.types(key, terms, lost, meant, has)
        for each in types:
            yield Detail("knownOn", iri(each))
        if types or elsewhere:
            return
        near = self._compared.nearest_property(drop)
        if near is not None and not any(
            near == nearest_property(each, terms, ()) for each in lost if each is not key
        ):
            yield Detail("resembles", literal(near))

    def _resembled_type(self, written: Iri) -> Iterator[Detail]:
        if (near := self._compared.nearest_class(written)) is not None:
            yield Detail("resembles", iri(written.resolution.terms[near]["@id"]))

    def missing_context(self, whole: Span, misnamed: Key | None) -> list[Loss]:
        """Return that the text has no context, if it needs one; *misnamed* is read as one."""
        if misnamed is not None:
            return [Loss("MissingContext", misnamed.span, None, text_details(key=misnamed))]
        if not self._record.drops and not self._watch.types:
            return []
        return [Loss("MissingContext", Span(whole.start, whole.start + 1))]

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
                _mapped(
                    {
                        other.release: found
                        for other in self._others()
                        if lost.origin
                        and (found := other.type_iri(lost.written.token, lost.origin))
                    }
                )
            ).with_details(self._resembled_type(lost.written))
            for lost in self._watch.types
        ]

    def contexts(self) -> list[Loss]:
        """Return the contexts that are missing or broken."""
        losses = []
        for problem in self._record.problems.values():
            unresolved = problem.kind == "UnresolvedContext"
            said = {
                "context": problem.context, "reason": problem.reason, "resembles": problem.meant,
                "knownBelow": unresolved and self._compared.contexts_below(problem.context or ""),
            }  # fmt: skip
            details = text_details(**{name: text for name, text in said.items() if text})
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


def _mapped(meanings: Mapping[str, str]) -> Iterator[Detail]:
    """Yield what a word means in other releases, by these."""
    for release in meanings:
        yield Detail("mappedInRelease", literal(release))
    for meant in dict.fromkeys(meanings.values()):
        yield Detail("mappedTo", iri(meant))


def _in(stray: StrayValue) -> dict[str, str]:
    return {} if stray.key is None else {"key": stray.key}
