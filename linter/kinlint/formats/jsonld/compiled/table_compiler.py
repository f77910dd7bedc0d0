"""Compiles active contexts to term tables; PyLD says what each word of them means."""

from __future__ import annotations

import re
from collections.abc import Callable, Hashable, Iterator
from contextlib import contextmanager
from typing import Any

from kinlint.formats.json_text.json_values import Key, Object, Text
from kinlint.formats.jsonld.active_context import FAULTS, Context
from kinlint.formats.jsonld.compiled.term_table import (
    Declined,
    Kind,
    Lookup,
    Meaning,
    Scope,
    TermTable,
)
from kinlint.formats.jsonld.expander import Processor
from kinlint.formats.jsonld.expansion_record import ExpansionRecord
from kinlint.formats.jsonld.losses import LossObserver
from kinlint.formats.jsonld.rdf_literals import malformed, value_literal
from kinlint.formats.jsonld.traced_values import Iri, Origin, Reach
from kinlint.light_dataclasses import replace
from kinlint.terms import Term, iri

_KEYWORDS = {
    "@id": Kind.ID,
    "@type": Kind.TYPE,
    "@value": Kind.VALUE,
    "@language": Kind.LANGUAGE,
    "@list": Kind.LIST,
    "@set": Kind.SET,
}
PROPERTY = Kind.PROPERTY
_CONTAINERS: tuple[list[str], ...] = ([], ["@set"], ["@list"])
_SAFE = re.compile(r"(?!//)[A-Za-z0-9_.~/-]*")
_ABSOLUTE = re.compile(r"[A-Za-z][A-Za-z0-9+-.]*:[^\s]*")


class TableCompiler:
    """Compiles the contexts of one file.

    Whatever would be told of a word, or of a context, makes PyLD expand the object it is in.
    """

    def __init__(self, processor: Processor) -> None:
        self._processor: Any = processor
        self._base = processor.options["base"]
        self._around = Origin(Object(0), None, None)
        self._lookups: dict[Hashable, Lookup] = {}
        self._abbreviations: dict[int, Any] = {}
        self._scopes: dict[tuple[int, int | None], Scope] = {}
        self._kept: list[Context] = []

    def scope(self, outer: Context, key: str) -> Scope:
        """Return the scope of the objects under *key* of an object with the context *outer*."""
        processor = self._processor
        with self._unnoticed():
            reverted = processor.entering(outer, key)
            scoped = processor.get_context_value(outer, key, "@context")
            kept = outer
            for propagate in ({"propagate": True}, {}) if scoped is not None else ():
                kept = processor._process_context(  # noqa: SLF001
                    kept, scoped, processor.options, override_protected=True, **propagate
                )
        return self._scope(reverted, kept if "previousContext" in kept else None)

    def _scope(self, context: Context, unreverted: Context | None) -> Scope:
        about = (id(context), None if unreverted is None else id(unreverted))
        if about not in self._scopes:
            self._kept += (context, unreverted)
            inside = None if unreverted is None else lambda: self._scope(unreverted, None)
            self._scopes[about] = Scope(
                _type_keys(context),
                self._lookup(context, "kinds", lambda key: self._kind(context, key)),
                lambda types: self._table(context, types),
                inside,
            )
        return self._scopes[about]

    def _table(self, context: Context, types: tuple[str, ...]) -> TermTable:
        processor, active = self._processor, context
        with self._unnoticed():
            for name in sorted(types):
                scoped = processor.get_context_value(context, name, "@context")
                if scoped is not None and scoped is not False:
                    active = processor._process_context(  # noqa: SLF001
                        active, scoped, processor.options, propagate=False
                    )
        if _type_keys(active) != _type_keys(context):
            raise Declined("a type that redefines the key of types")
        self._kept.append(active)
        return TermTable(
            self._lookup(active, "keys", lambda key: self._meaning(active, key)),
            types,
            self._terms(context, "type", vocab=True),
            self._terms(active, "value", vocab=False),
            self._lookup(context, "datatypes", lambda name: self._datatype(context, name)),
        )

    def _lookup(self, context: Context, role: str, meaning: Callable[[str], Any]) -> Lookup:
        about = (id(context), role)
        if about not in self._lookups:
            self._kept.append(context)
            self._lookups[about] = Lookup(meaning)
        return self._lookups[about]

    def _terms(self, context: Context, role: str, *, vocab: bool) -> Lookup:
        """Return the terms that strings mean as IRIs.

        Without *vocab* they depend on prefixes and base alone, which most contexts have in common.
        """
        about = (id(context), role) if vocab else (self._prefixes(context), role)
        if about not in self._lookups:
            self._kept.append(context)
            self._lookups[about] = Lookup(self._term(context, role, vocab=vocab))
        return self._lookups[about]

    def _prefixes(self, context: Context) -> Any:
        """Return what gives relative and compact IRIs their meaning under *context*."""
        if id(context) not in self._abbreviations:
            self._kept.append(context)
            found = frozenset(
                (prefix, mapping["@id"])
                for prefix, mapping in context["mappings"].items()
                if mapping and mapping["_prefix"]
            )
            self._abbreviations[id(context)] = (found, "@base" in context, context.get("@base"))
        return self._abbreviations[id(context)]

    def _term(self, context: Context, role: str, *, vocab: bool) -> Callable[[str], Term | None]:
        mappings = context["mappings"] if vocab else {}
        prefixes = {
            prefix: namespace
            for prefix, namespace in self._prefixes(context)[0]
            if prefix != "_" and _is_sound(namespace)
        }

        def term(written: str) -> Term | None:
            prefix, colon, rest = written.partition(":")
            namespace = prefixes.get(prefix)
            if namespace and colon and _SAFE.fullmatch(rest) and written not in mappings:
                return f"<{namespace}{rest}>"
            found = self._iri(context, written, role, vocab=vocab)
            return None if found is None or not _ABSOLUTE.fullmatch(found) else iri(found)

        return term

    def _datatype(self, context: Context, written: str) -> str | None:
        found = self._iri(context, written, "datatype", vocab=True)
        return found if found is not None and _ABSOLUTE.fullmatch(found) else None

    def _iri(self, context: Context, written: str, role: str, *, vocab: bool) -> str | None:
        """Return the IRI that *written* means; None if anything is to be told of it."""
        found = self._expanded(context, _at_nowhere(Text, written), vocab=vocab)
        return found if found is not None and _is_silent(found, role) else None

    def _expanded(self, context: Context, token: Text, *, vocab: bool) -> Any:
        with self._unnoticed():
            base = None if isinstance(token, Key) else self._base
            return self._processor._expand_iri(context, token, base=base, vocab=vocab)  # noqa: SLF001

    def _kind(self, context: Context, key: str) -> Kind:
        return _KEYWORDS.get(self._expanded(context, _at_nowhere(Key, key), vocab=True), PROPERTY)

    def _meaning(self, active: Context, key: str) -> Meaning | None:
        found = self._expanded(active, _at_nowhere(Key, key), vocab=True)
        kind = _KEYWORDS.get(found)
        if kind is not None:
            return Meaning(kind)
        mapping = active["mappings"].get(key) or {}
        if not isinstance(found, Iri) or not _is_silent(found, "property"):
            return None
        if mapping.get("reverse") or mapping.get("@type") == "@json":
            return None
        container = mapping.get("@container") or []
        if container not in _CONTAINERS or not _ABSOLUTE.fullmatch(found) or malformed(found):
            return None
        inner = active
        if mapping.get("@context") is not None:
            with self._unnoticed():
                inner = self._processor._process_context(  # noqa: SLF001
                    active, mapping["@context"], self._processor.options,
                    propagate=True, override_protected=True,
                )  # fmt: skip
            own = inner["mappings"].get(key) or {}
            if {**own, "@context": 0} != {**mapping, "@context": 0}:
                return None
            self._kept.append(inner)
        made = Meaning(Kind.PROPERTY, iri(found), listed=container == ["@list"])
        coercion = mapping.get("@type")
        if coercion in ("@id", "@vocab"):
            made.words = self._terms(inner, "value", vocab=coercion == "@vocab")
        else:
            made.words = Lookup(lambda value: self._literal(inner, key, value))
        made.numbers = Lookup(lambda spelled: self._literal(inner, key, _number(spelled)))
        made.scoped = lambda: self.scope(inner, key)
        return made

    def _literal(self, context: Context, key: str, value: Any) -> Term | None:
        with self._unnoticed():
            item = self._processor._expand_value(context, key, value, self._processor.options)  # noqa: SLF001
            return value_literal(item) if isinstance(item, dict) and "@value" in item else None

    @contextmanager
    def _unnoticed(self) -> Iterator[None]:
        """Work for the sake of the tables.

        Raises Declined if anything fails, or is noted wherever it is met: so are the terms of
        scoped contexts in the file.
        """
        processor = self._processor
        record, trail, site = processor.record, processor.trail, processor.site
        aside = processor.record = ExpansionRecord()
        processor.trail = [self._around, self._around]
        try:
            yield
            self._keep(record, aside)
        except FAULTS as fault:
            raise Declined("a context that is not valid") from fault
        finally:
            processor.record, processor.trail, processor.site = record, trail, site

    def _keep(self, record: ExpansionRecord, aside: ExpansionRecord) -> None:
        """Keep what is noted of a context wherever it is used first, and refuse all the rest."""
        for start, datatype in aside.unprefixed.items():
            record.unprefixed.setdefault(start, datatype)
        if replace(aside, unprefixed={}) != ExpansionRecord():
            raise Declined("something is told of a context or a word")


def _number(spelled: str) -> bool | int | float:
    """Return the number or truth value that Python spells like that."""
    if spelled in ("True", "False"):
        return spelled == "True"
    return int(spelled) if spelled.lstrip("-").isdigit() else float(spelled)


def _type_keys(context: Context) -> tuple[str, ...]:
    """Return the keys that mean `@type` under *context*."""
    mappings = context["mappings"].items()
    return ("@type", *sorted(key for key, each in mappings if each and each["@id"] == "@type"))


def _at_nowhere(kind: Any, written: str) -> Any:
    token = kind(written)
    token.start = token.end = 0
    if kind is Key:
        token.value_start = token.value_end = 0
    return token


def _is_sound(namespace: str) -> bool:
    return _ABSOLUTE.fullmatch(namespace) is not None and not malformed(namespace)


def _is_silent(found: Any, role: str) -> bool:
    """Tell whether the observer of losses says nothing of the IRI *found* as a *role*."""
    if not isinstance(found, Iri) or found.resolution.reach is Reach.BLANK:
        return False
    watch = LossObserver()
    if role == "type":
        watch.type(found, None, None)
    else:
        watch.seen(found, role, None)
    return not (watch.losses or watch.types or watch.values or watch.identifiers)
