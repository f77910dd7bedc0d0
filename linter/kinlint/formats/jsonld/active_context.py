"""Active contexts: processed once each, and as far as they can be when one is broken."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import Any, TypeAlias

from kinlint.files.bounded_read import Unreadable
from kinlint.formats.json_text.json_values import Array, Key, Object, Text
from kinlint.formats.jsonld.context_cache import ContextCache, unplaced
from kinlint.formats.jsonld.context_resolver import Resolved, Resolver
from kinlint.formats.jsonld.expansion_record import ContextProblem, ExpansionRecord, ShadowedTerm
from kinlint.formats.jsonld.local_contexts import SELF, LocalContexts, LocalResolver
from kinlint.formats.jsonld.pyld import JsonLdError, frozendict
from kinlint.formats.jsonld.uri_schemes import REGISTERED
from kinlint.text import Span

Context: TypeAlias = Any
_Process: TypeAlias = Callable[[Context, Any], Context]

# PyLD lets all of these escape from contexts that are merely wrong.
FAULTS = (JsonLdError, LookupError, TypeError, ValueError, AttributeError, RecursionError)

_SALVAGED_TERMS = 200

UNREAD = "_unread"
"""Key of an active context for the name of a context that could not be read."""
INLINE = "the context of this file"
"""Stands for the name of a context that is written where it is used."""


class _Lenient(dict[str, Any]):
    """An active context in which a setting can be withdrawn that was never made."""

    def __delitem__(self, name: str) -> None:
        self.pop(name, None)


class ActiveContexts:
    """The part of a processor that combines contexts.

    A context that is unknown or invalid is recorded at its place, and what is left of it takes
    its place, marked `UNREAD`; with *strict* it raises as the specification demands. `site` is
    the place of the `@context` at work.
    """

    record: ExpansionRecord

    def __init__(self, memory: ContextCache, local: LocalContexts | None, *, strict: bool) -> None:
        self.strict = strict
        self.memory = memory
        self.local = local
        self.resolver: Resolver | LocalResolver = memory.resolver
        if local is not None:
            self.resolver = LocalResolver(local, memory.resolver)
        self.site: Span | None = None
        # Results with their problem, and the keys' objects, which must live as long as their ids.
        self._known: dict[Any, tuple[Context, ContextProblem | None, Any]] = {}
        self._chain: list[str] = []
        """IRIs of the context files at work, each named in the one before."""

    def _clone_active_context(self, active_ctx: Context) -> Context:
        clone = _Lenient(super()._clone_active_context(active_ctx))  # type: ignore[misc]
        if UNREAD in active_ctx:
            clone[UNREAD] = active_ctx[UNREAD]
        return clone

    def _process_context(
        self, active_ctx: Context, local_ctx: Any, options: Any, **flags: Any
    ) -> Context:
        def process(active: Context, local: Any) -> Context:
            return parent(active, local, options, **flags)

        parent = super()._process_context  # type: ignore[misc]
        # A context under construction is being validated: it will be processed again when used.
        if type(active_ctx) is not frozendict:
            return process(active_ctx, local_ctx)
        local = local_ctx
        if isinstance(local, Mapping) and isinstance(local.get("@context"), list):
            local = local["@context"]
        if not isinstance(local, list):
            return self._entry(active_ctx, local, process, options, flags)
        if any(isinstance(entry, Mapping) and "@propagate" in entry for entry in local[1:]):
            return self._entry(active_ctx, local, process, options, flags)
        owners: dict[str, str] = {}
        loaded = set[str]()
        for entry, site in _entries(local):
            self.site = site or self.site
            self._note_repetition(entry, loaded)
            result = self._entry(active_ctx, entry, process, options, flags)
            if isinstance(entry, Text) and len(local) > 1:
                self._compare(active_ctx, result, entry, options, owners)
            active_ctx = result
        return active_ctx

    def _note_repetition(self, entry: Any, loaded: set[str]) -> None:
        """Record *entry* of an array if it is among the contexts *loaded* by the array before."""
        if entry is None:
            loaded.clear()
        elif isinstance(entry, Text):
            if entry in loaded:
                self.record.problem(ContextProblem("RepeatedContext", entry, "", entry.span))
            loaded.add(entry)

    def _entry(
        self, active: Context, entry: Any, process: _Process, options: Any, flags: dict[str, Any]
    ) -> Context:
        self.record.use(entry)
        if self.local is not None and (iri := self.local.named(entry)) is not None:
            return self._from_file(active, entry, iri, options, flags)
        name = str(entry) if isinstance(entry, str) else id(entry)
        about = (id(active), name, flags.get("override_protected"), flags.get("propagate", True))
        known = self._known.get(about)
        if known is None:
            shared = self.memory.key(active, entry)
            key = shared and (*shared, *about[2:])
            result = self.memory.get(key) if shared else None
            problem: ContextProblem | None = None
            if result is not None:
                self._define(entry, active, result)
                return result
            result, problem = self._processed(
                active, entry, process, options, shared=shared is not None
            )
            if key and not problem:
                self.memory.keep(key, result, entry)
            else:
                self._known[about] = (result, problem, (active, entry))
        else:
            result, problem, _ = known
        self._define(entry, active, result)
        if problem:
            self.record.problem(problem._replace(span=self._place(entry, problem.span)))
        return result

    def _from_file(
        self, active: Context, entry: Any, iri: str, options: Any, flags: dict[str, Any]
    ) -> Context:
        """Return *active* with the context in the file of *iri*, as if it stood here."""
        assert self.local is not None
        site = self._place(entry, self.site or Span(0, 0))
        kind, why = "InvalidContext", SELF
        try:
            if iri not in self._chain:
                self._chain.append(iri)
                try:
                    context = self.local.context(iri)
                    return self._process_context(active, context, options, **flags)
                finally:
                    self._chain.pop()
                    self.site = site
        except Unreadable as error:
            kind, why = "UnresolvedContext", str(error)
        self.record.problem(ContextProblem(kind, self.local.written(entry), why, site))
        return uncertain(active, self.local.written(entry))

    def _define(self, entry: Any, active: Context, result: Context) -> None:
        if isinstance(entry, Object):
            self.record.define(entry, active["mappings"], result["mappings"])

    def _place(self, entry: Any, otherwise: Span) -> Span:
        return entry.span if isinstance(entry, Text) else otherwise

    def _processed(
        self, active: Context, entry: Any, process: _Process, options: Any, *, shared: bool
    ) -> tuple[Context, ContextProblem | None]:
        span = getattr(entry, "span", None) or self.site or Span(0, 0)
        iri = str(entry) if isinstance(entry, str) else None
        try:
            if not self.strict and isinstance(entry, Object) and "@context" in entry:
                raise JsonLdError("'@context' is not allowed in a context", "jsonld.SyntaxError")
            given = unplaced(entry) if shared else entry
            found = self.resolver.resolve(active, given, options["base"])
            documents = [context.document for context in found]
            result = _frozen(process(active, documents[0] if len(documents) == 1 else documents))
        except FAULTS as fault:
            if self.strict:
                raise
            problem = ContextProblem("InvalidContext", iri, _reason(fault), span)
            return self._salvaged(active, entry, process, problem)
        missing = next((context.missing for context in found if context.missing), None)
        if isinstance(entry, Object):
            self._datatypes(entry, result)
        if missing:
            problem = ContextProblem("UnresolvedContext", iri, missing, span)
            return uncertain(result, iri or INLINE), problem
        if meant := next((context.meant for context in found if context.meant), None):
            return result, ContextProblem("MisnamedContext", iri, "", span, meant)
        return result, None

    def _datatypes(self, entry: Object, result: Context) -> None:
        """Note datatypes in a context of the file that no prefix makes an IRI."""
        for term, definition in entry.items():
            written = definition.get("@type") if isinstance(definition, Mapping) else None
            mapping = result["mappings"].get(term)
            if isinstance(written, Text) and mapping and mapping.get("@type") == written:
                scheme, colon, rest = written.partition(":")
                named = scheme in ("", "_") or scheme.lower() in REGISTERED
                if colon and not named and not rest.startswith("//"):
                    self.record.undefine(written)

    def _salvaged(
        self, active: Context, entry: Any, process: _Process, problem: ContextProblem
    ) -> tuple[Context, ContextProblem]:
        """Extend *active* by the terms that can be defined, and return the first problem."""
        try:
            found: list[Resolved] = self.resolver.resolve(active, entry, "")
        except FAULTS:
            return uncertain(active, problem.context or INLINE), problem
        for context in found:
            document = context.document
            if not isinstance(document, Mapping) or len(document) > _SALVAGED_TERMS:
                continue
            good: dict[str, Any] = {}
            waiting = dict(document)
            grown = True
            while grown and waiting:
                grown = False
                for term in list(waiting):
                    try:
                        attempt = {**good, term: waiting[term]}
                        trial = process(active, attempt)
                    except FAULTS:
                        continue
                    good, salvaged, grown = attempt, trial, True
                    del waiting[term]
            active = salvaged if good else active
            bad = next(iter(waiting), None)
            if isinstance(bad, Key):
                problem = problem._replace(span=bad.value_span)
        return uncertain(active, problem.context or INLINE), problem

    def _compare(
        self, before: Context, after: Context, entry: Text, options: Any, owners: dict[str, str]
    ) -> None:
        """Note the terms of earlier documents that the document *entry* redefines."""
        try:
            found = self.resolver.resolve(before, entry, options["base"])
        except FAULTS:
            return
        terms = [term for c in found if isinstance(c.document, Mapping) for term in c.document]
        for term in terms:
            if term in owners:
                old = (before["mappings"].get(term) or {}).get("@id")
                new = (after["mappings"].get(term) or {}).get("@id")
                if old and new and old != new:
                    self.record.redefine(
                        ShadowedTerm(str(term), str(entry), owners[term], new, old)
                    )
            owners[str(term)] = str(entry)


def _entries(array: list[Any]) -> Iterator[tuple[Any, Span | None]]:
    """Yield the contexts in an array and in arrays within it, each with its place."""
    for index, entry in enumerate(array):
        if isinstance(entry, list):
            yield from _entries(entry)
        else:
            yield entry, array.element_span(index) if isinstance(array, Array) else None


def _frozen(context: Context) -> Context:
    # PyLD gives every context but a mere clone an identifier, and wants to find one.
    return context if "_uuid" in context else frozendict({**context, "_uuid": ""})


def uncertain(context: Context, name: str) -> Context:
    """Return *context*, in which the context called *name* could not be read."""
    return frozendict({**context, UNREAD: context.get(UNREAD, name)})


def _reason(fault: BaseException) -> str:
    while fault.__cause__ is not None:
        fault = fault.__cause__
    if isinstance(fault, RecursionError):
        return "it refers to itself without end"
    if not isinstance(fault, JsonLdError):
        return "it cannot be processed"
    term = (fault.details or {}).get("term")
    return f"{complaint(fault)} (term '{term}')" if term else complaint(fault)


def complaint(error: JsonLdError) -> str:
    """Return PyLD's error message as the rest of a sentence."""
    text = str(error.args[0]).removeprefix("Invalid JSON-LD syntax; ").rstrip(".").replace('"', "")
    return text[:1].lower() + text[1:]
