"""The rules that the configuration of the project in the working directory names."""

from __future__ import annotations

import os
import sys
from pathlib import Path

from kinlint.configuration.config_file import Config, Configs
from kinlint.configuration.project_trust import ProjectTrust, untrusted_message
from kinlint.errors import UsageError


def project_config(*, trust: bool) -> Config:
    """Return the configuration that holds in the working directory, without what is not trusted."""
    return found_config(trust=trust) or Config("defaults")


def found_config(*, trust: bool) -> Config | None:
    """Return that configuration, None if there is none; raises `ConfigError`."""
    trusted = ProjectTrust.from_user(os.environ, everything=trust)
    return Configs(None, trusted.restricted, trusted.may_extend).nearest(Path.cwd())


def project_rules(*, trust: bool, required: bool = False) -> list[Path]:
    """Return the rule files of the project.

    If it is not trusted there are none, and a line on stderr says so; raises `UsageError` instead
    if they are *required*.
    """
    config = project_config(trust=trust)
    if "rules" in config.untrusted:
        if required:
            raise UsageError(untrusted_message(config))
        sys.stderr.write(f"kinlint: warning: {untrusted_message(config)}\n")
    return list(config.rules or ())
