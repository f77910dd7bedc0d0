"""Kinds of facts: what each is computed by, and what it follows from."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping
from typing import NamedTuple

from kinlint.facts.fact_context import FactContext
from kinlint.terms import Term, Triple

LABELLED = 4
"""The number of facts in the label of a kind."""


class FactKind(NamedTuple):
    """Facts of one kind, which are computed together."""

    module: str
    """The module of this package that computes them."""
    needs: Mapping[str, tuple[Term, ...]]
    """The properties and classes by which they are asked for, each with those it follows from.

    What is said of elements of files is there unasked, and so is what holds of any node.
    """
    found: Callable[[FactContext], Iterator[Triple]]
    """Function that computes them."""
    parts: tuple[str, ...]
    """The parts of scans that this takes; what a part of `FactContext` is made of comes with it."""
    details: tuple[str, ...] = ()
    """Further properties of their nodes."""
    by_name: bool = False
    """True if rules that look at any property are not about these."""

    @property
    def label(self) -> str:
        """Return the module and the first of the facts."""
        return f"{self.module}: {', '.join([*self.needs][:LABELLED])}"
