"""The template of the message of a result: of the query, the constraint, or the shape itself."""

from __future__ import annotations

import re

from kinlint.engine.result import Result
from kinlint.rule import Rule

CONSTRAINT = "ConstraintComponent"
SHAPE = "SHACL"
"""Beginning of the codes of rules that stand for shapes of users."""


def template_of(result: Result, rule: Rule) -> str:
    """Return the message of *result* with placeholders.

    Where a user's shape says it, this names the property, the node and the shape.
    """
    template = result.message or next(iter(result.constraint.messages), "") or _said(result, rule)
    known = rule.path or not rule.code.startswith(SHAPE)
    return template if known else _of_shape(template, result, rule)


def _of_shape(template: str, result: Result, rule: Rule) -> str:
    """Return *template*, of a user's shape, with the property, the node and the shape."""
    if "{$this}" in template or "{?this}" in template:
        return template
    about = "'{?path}' of '{$this}'" if result.path is not None else "'{$this}'"
    said = template.removesuffix(".")
    said = said[:1].lower() + said[1:] if said[1:2].islower() or said[1:2] == " " else said
    return f"{about}: {said} (shape {rule.title.rpartition(' ')[2]})."


def _said(result: Result, rule: Rule) -> str:
    """Return the message for a shape without one."""
    broken = re.split(r"[#/]", result.constraint.component)[-1].removesuffix(CONSTRAINT)
    what = "'{?value}' of '{$this}'" if result.value not in (None, result.focus) else "'{$this}'"
    return f"{what} breaks {broken} of shape {rule.name}."
