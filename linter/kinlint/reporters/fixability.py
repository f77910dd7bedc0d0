"""Fixability of findings: signs and counts."""

from __future__ import annotations

from collections.abc import Iterable
from typing import NamedTuple

from kinlint.finding import Finding
from kinlint.rule import Applicability

FIXABLE, WITH_CARE, PARTLY = "[*]", "[*!]", "[-]"
"""Signs: fixed by `--fix`; fixed with `--unsafe-fixes`; some of them fixed."""


class Fixable(NamedTuple):
    """Number of findings that `--fix` fixes, and how many more `--fix --unsafe-fixes` would."""

    now: int
    """Number of findings that `--fix` fixes."""
    with_care: int
    """Number of further findings that `--fix --unsafe-fixes` fixes."""


def sign(finding: Finding, *, unsafe: bool | None = None) -> str:
    """The sign of *finding*; nothing if it has no fix that is ever written.

    *unsafe* tells that unsafe fixes count like safe ones.
    """
    fix = finding.fix(Applicability.UNSAFE)
    if fix is None:
        return ""
    least = Applicability.UNSAFE if unsafe else Applicability.SAFE
    return FIXABLE if finding.fix(least) else WITH_CARE


def fixable(findings: Iterable[Finding], *, unsafe: bool | None = None) -> Fixable:
    """Count the *findings* that can be fixed."""
    signs = [sign(finding, unsafe=unsafe) for finding in findings]
    return Fixable(signs.count(FIXABLE), signs.count(WITH_CARE))
