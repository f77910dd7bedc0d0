"""Dataclasses that cost little to make; to type checkers, those of the standard library."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from dataclasses import (
        MISSING,
        asdict,
        astuple,
        dataclass,
        field,
        fields,
        is_dataclass,
        replace,
    )
else:
    from kinlint.light_dataclasses.decorator import dataclass, field
    from kinlint.light_dataclasses.fields import MISSING
    from kinlint.light_dataclasses.operations import (
        asdict,
        astuple,
        fields,
        is_dataclass,
        replace,
    )

__all__ = [
    "MISSING",
    "asdict",
    "astuple",
    "dataclass",
    "field",
    "fields",
    "is_dataclass",
    "replace",
]
