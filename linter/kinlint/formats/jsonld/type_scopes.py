"""The types whose nodes have a key that others have not: type-scoped contexts, inverted."""

from __future__ import annotations

import re
from collections import Counter, defaultdict
from collections.abc import Collection, Mapping, Sequence
from typing import Any, NamedTuple

from kinlint.formats.jsonld.resemblance import Terms, is_class
from kinlint.light_dataclasses import dataclass, field

FEW = 3
"""Number of types among which an author sees the one that is missing."""
_WORD = re.compile(r"[A-Z][a-z]+")


class ScopedKey(NamedTuple):
    """A key as nodes of one type have it."""

    type: str
    """IRI of the type."""
    iri: str
    """IRI that the key means on its nodes."""


@dataclass
class TypeScopes:
    """Type-scoped keys of active contexts."""

    _known: dict[int, tuple[Terms, Mapping[str, Sequence[ScopedKey]]]] = field(default_factory=dict)

    def types(
        self,
        key: str,
        terms: Terms,
        beside: Collection[str],
        meant: Collection[str],
        has: Collection[str],
    ) -> list[str]:
        """Return the IRIs of the few types in *terms* on which *key* would not be lost.

        They are those that save most of the keys *beside* it, too, and if these are many, go by
        the first word of their names with the types that the node *has*. *meant* are the IRIs that
        other releases give to the key here, if any do: a type that gives it another is no remedy.
        """
        scopes = self._scopes(terms)
        fit = [each for each in scopes.get(key, ()) if not meant or each.iri in meant]
        saved = Counter(each.type for other in beside for each in scopes.get(other, ()))
        most = max((saved[each.type] for each in fit), default=0)
        best = sorted({each.type for each in fit if saved[each.type] == most})
        if len(best) > FEW:
            words = {_first_word(each) for each in has}
            best = [each for each in best if _first_word(each) in words]
        return best if len(best) <= FEW else []

    def _scopes(self, terms: Terms) -> Mapping[str, Sequence[ScopedKey]]:
        if id(terms) not in self._known:
            self._known[id(terms)] = terms, _inverted(terms)
        return self._known[id(terms)][1]


def _first_word(name: str) -> str:
    """Return `Pose` of `PoseCoordinate`, be it a term or an IRI."""
    local = re.split(r"[#/:]", name)[-1]
    match = _WORD.match(local)
    return match[0] if match else local


def _inverted(terms: Terms) -> Mapping[str, Sequence[ScopedKey]]:
    found: dict[str, list[ScopedKey]] = defaultdict(list)
    for term, meaning in terms.items():
        inner = meaning.get("@context") if meaning else None
        if isinstance(inner, Mapping) and is_class(term, meaning):
            for key, definition in inner.items():
                if key[:1] != "@" and (iri := _iri(definition, inner, terms)):
                    found[key].append(ScopedKey(meaning["@id"], iri))
    return found


def _iri(definition: Any, inner: Mapping[str, Any], terms: Terms) -> str | None:
    """Return the IRI of a *definition* in the scoped context *inner*; None if it has none."""
    compact = definition.get("@id") if isinstance(definition, Mapping) else definition
    if not isinstance(compact, str):
        return None
    prefix, colon, rest = compact.partition(":")
    own = inner.get(prefix)
    base = own if isinstance(own, str) else (terms.get(prefix) or {}).get("@id")
    return f"{base}{rest}" if colon and base and rest[:2] != "//" else compact
