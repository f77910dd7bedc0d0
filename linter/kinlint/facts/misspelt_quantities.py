"""Units and kinds of quantity that nothing describes, spelled almost like a known one."""

from __future__ import annotations

from collections.abc import Callable, Collection, Iterator, Mapping
from itertools import chain

from kinlint.facts.fact_statements import fact
from kinlint.facts.metamodel_terms import qudt
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.suggestion import distance
from kinlint.terms import Term, Triple, iri_value, is_iri, literal_value
from kinlint.vocabulary import QUANTITY_KIND, UNIT

SHORTEST = 3
"""Letters that a unit's name has if one slip does not make another unit's name of it."""


def resemblances(scan: PredicateIndex) -> Iterator[Triple]:
    """Yield each undescribed kind or unit with the only known one that is spelled alike.

    A kind differs by one letter: QUDT has kinds that lie two letters apart, such as reluctance and
    reactance. A unit may also be written by its symbol, or in other letters of the same names.
    """
    kinds, units = scan.instances(qudt("QuantityKind")), scan.instances(qudt("Unit"))
    used = _values(scan, "hasQuantityKind")
    yield from _near(used - kinds, _names(kinds, QUANTITY_KIND), QUANTITY_KIND, bool)
    strange = (_values(scan, "unit") | _values(scan, "hasUnit")) - units
    if any(_local(each, UNIT) for each in strange):
        names = _names(units, UNIT)
        for unit, symbols in scan.table(qudt("symbol")).items():
            if unit in units:
                for symbol in symbols:
                    names.setdefault(literal_value(symbol).casefold(), set()).add(unit)
        yield from _near(strange, names, UNIT, _is_word)


def _values(scan: PredicateIndex, name: str) -> set[Term]:
    return set(chain.from_iterable(values for _, values in scan.table(qudt(name)).items()))


def _names(known: Collection[Term], space: str) -> dict[str, set[Term]]:
    """Return what is *known* in the namespace *space*, by its letters."""
    names: dict[str, set[Term]] = {}
    for each in known:
        if _local(each, space):
            names.setdefault(_plain(each, space), set()).add(each)
    return names


def _is_word(name: str) -> bool:
    """Tell whether a unit's name is no compound, and long enough for a slip to make no other."""
    return name.isalpha() and len(name) >= SHORTEST


def _near(
    strange: Collection[Term],
    names: Mapping[str, set[Term]],
    space: str,
    may_slip: Callable[[str], bool],
) -> Iterator[Triple]:
    """Yield each of *strange* that is in *space* with the only one of *names* that is alike.

    A name that *may_slip* may differ by one letter from another such, any other has to be equal.
    """
    wanted = [each for each in sorted(strange) if _local(each, space)]
    shortened: dict[str, list[str]] = {}
    for name in names if wanted else ():
        for each in _shortened(name):
            shortened.setdefault(each, []).append(name)
    for each in wanted:
        plain = _plain(each, space)
        near = names.get(plain, set())
        if not near and may_slip(_local(each, space)):
            alike = {name for part in _shortened(plain) for name in shortened.get(part, ())}
            near = {
                known
                for name in alike
                if may_slip(name) and distance(plain, name, 1) <= 1
                for known in names[name]
            }
        if len(near) == 1:
            yield each, fact("resembles"), next(iter(near))


def _shortened(name: str) -> Iterator[str]:
    """Yield *name* and all that it is without one letter.

    Names one slip apart share one of these.
    """
    yield name
    for at in range(len(name)):
        yield name[:at] + name[at + 1 :]


def _local(term: Term, space: str) -> str:
    """Return the name of *term* in the namespace *space*, else nothing."""
    if not is_iri(term):
        return ""
    before, _, name = iri_value(term).rpartition("/")
    return name if f"{before}/" == space else ""


def _plain(term: Term, space: str) -> str:
    """Return the letters of a name, without case and hyphens."""
    return "".join(filter(str.isalnum, _local(term, space))).casefold()
