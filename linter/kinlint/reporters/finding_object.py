"""A finding as an object for JSON: ruff's fields, and what a graph adds to them.

`fix` is the preferred one of `fixes`; its edits have ruff's fields and the name of their file.
"""

from __future__ import annotations

from typing import Any

from kinlint.errors import SourceError
from kinlint.finding import Finding, Fix, Premise, Related, TextEdit
from kinlint.text import Location, Position


def finding_object(finding: Finding) -> dict[str, Any]:
    """The fields of *finding*. Rows and columns count from one, in code points; ends exclude."""
    rule = finding.rule
    fixes = [_fix(fix) for fix in finding.fixes]
    silenced = {} if finding.suppressed is None else {"suppressed": finding.suppressed}
    return {
        "filename": finding.location.source.name,
        "code": rule.code,
        "name": rule.name,
        "message": finding.message,
        "location": _position(finding.location.start),
        "end_location": _position(finding.location.end),
        "severity": finding.severity.label,
        "url": rule.iri,
        "fix": fixes[0] if fixes else None,
        "fixes": fixes,
        "iri": finding.entity or None,
        "related": [_related(related) for related in finding.related],
        "reason": finding.reason or None,
        "because": [_premise(premise) for premise in finding.because],
        "consequences": [_consequence(each) for each in finding.consequences],
        "taxa": list(rule.antipatterns),
        **silenced,
    }


def error_object(error: SourceError) -> dict[str, Any]:
    """The same fields for a file that cannot be read: it has no code and no rule."""
    place = {"row": error.line or 1, "column": error.column or 1}
    return {
        "filename": error.name,
        "code": None,
        "name": "unreadable-file",
        "message": error.cause,
        "location": place,
        "end_location": place,
        "severity": "error",
        "url": None,
        "fix": None,
        "fixes": [],
        "iri": None,
        "related": [],
        "reason": None,
        "because": [],
        "consequences": [],
        "taxa": [],
    }


def _fix(fix: Fix) -> dict[str, Any]:
    return {
        "applicability": fix.applicability.label,
        "message": fix.title,
        "why": fix.why or None,
        "update": fix.update,
        "edits": [_edit(edit) for edit in fix.edits],
    }


def _edit(edit: TextEdit) -> dict[str, Any]:
    return {"content": edit.text, **_place(edit.location)}


def _position(position: Position) -> dict[str, int]:
    return {"row": position.line, "column": position.column}


def _place(location: Location) -> dict[str, Any]:
    return {
        "filename": location.source.name,
        "location": _position(location.start),
        "end_location": _position(location.end),
    }


def _related(related: Related) -> dict[str, Any]:
    return {**_place(related.location), "message": related.message}


def _consequence(finding: Finding) -> dict[str, Any]:
    """A finding that follows from the one it stands in."""
    said = {"code": finding.rule.code, "message": finding.message}
    return {**said, "severity": finding.severity.label, **_place(finding.location)}


def _premise(premise: Premise) -> dict[str, Any]:
    """A premise that was inferred has an axiom, one that was written has a place."""
    nowhere = {"filename": None, "location": None, "end_location": None}
    return {
        "statement": premise.statement,
        "inferred": premise.inferred,
        "axiom": premise.axiom or None,
        "depth": premise.depth,
        **(nowhere if premise.location is None else _place(premise.location)),
    }
