"""Puts the compiled catalogue into the wheel, so that no installation compiles it again."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface


class CatalogueHook(BuildHookInterface):  # type: ignore[type-arg]
    """The build hook that `pyproject.toml` names."""

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Compile the rules of this tree; an editable installation compiles its own."""
        if version == "editable":
            return
        sys.path.insert(0, str(Path(self.root) / "linter"))
        from kinlint.catalogue import rulebook  # noqa: PLC0415
        from kinlint.catalogue.compiled_store import STORED  # noqa: PLC0415

        compiled = Path(self.directory) / rulebook.SHIPPED.name
        rulebook.load(cache=compiled)
        for file in compiled.glob(STORED[0]):
            build_data["force_include"][str(file)] = (
                f"kinlint/catalogue/{compiled.name}/{file.name}"
            )
