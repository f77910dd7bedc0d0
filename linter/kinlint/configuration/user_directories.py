"""Finds the directories that an operating system gives a program and its user."""

from __future__ import annotations

import sys
from collections.abc import Mapping
from pathlib import Path

DIRECTORIES = {
    "settings": {
        "win32": ("APPDATA", "AppData/Roaming"),
        "darwin": ("", "Library/Application Support"),
        "": ("XDG_CONFIG_HOME", ".config"),
    },
    "cache": {
        "win32": ("LOCALAPPDATA", "AppData/Local"),
        "darwin": ("", "Library/Caches"),
        "": ("XDG_CACHE_HOME", ".cache"),
    },
}
"""By purpose and platform, the variable that names the directory, and its usual place at home."""


def user_directory(purpose: str, environment: Mapping[str, str]) -> Path:
    """Return the directory that kinlint has here for *purpose*, `settings` or `cache`.

    It follows the XDG Base Directory Specification, where the platform has no rule of its own.
    """
    places = DIRECTORIES[purpose]
    variable, usual = places.get(sys.platform, places[""])
    return Path(environment.get(variable) or Path.home() / usual) / "kinlint"
