"""The JSON schema of configurations, for editors: made of the keys, as everything about them."""

from __future__ import annotations

from typing import Any

from kinlint.configuration.keys import KEYS
from kinlint.vocabulary import KINLINT

DIALECT = "https://json-schema.org/draft/2020-12/schema"
NAME = "kinlint.schema.json"


def schema() -> dict[str, Any]:
    """The schema of `kinlint.toml`, and of `[tool.kinlint]` in `pyproject.toml`."""
    return {
        "$schema": DIALECT,
        "$id": f"{KINLINT}{NAME}",
        "title": "kinlint",
        "description": "The configuration of kinlint, a linter for robot descriptions.",
        "type": "object",
        "properties": {
            name: {
                **key.kind.schema,
                "description": f"{key.meaning} Default: {key.default}.",
                "x-taplo": {"docs": {"main": f"{key.meaning}\n\n```toml\n{key.example}\n```"}},
            }
            for name, key in KEYS.items()
        },
        "additionalProperties": False,
    }
