"""The keys of a configuration: what each may hold and what it means.

Every value is checked before it is used; `kinlint config` and the JSON schema tell what is here.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from kinlint import resources
from kinlint.configuration.value_kinds import (
    ONE_OR_MORE,
    SCALAR,
    SECONDS,
    STRING,
    STRINGS,
    SWITCH,
    Kind,
    either,
    one_of,
    table,
)
from kinlint.errors import ConfigError
from kinlint.light_dataclasses import dataclass
from kinlint.suggestion import did_you_mean

OUTPUT_FORMATS = (
    "full",
    "concise",
    "grouped",
    "json",
    "json-lines",
    "sarif",
    "github",
    "gitlab",
    "azure",
    "junit",
    "checkstyle",
    "rdjson",
    "rdjsonl",
    "turtle",
    "earl",
    "markdown",
    "sqlite",
    "html",
)
ENGINES = ("oxigraph", "pyshacl")
THRESHOLDS = ("error", "warning", "info", "none")
SEVERITIES = THRESHOLDS[:-1]
TARGETS = tuple(sorted(each.stem for each in (resources.data("shapes") / "targets").glob("*.ttl")))
"""Names of the consumers of robot descriptions that a model may be meant for."""


@dataclass(frozen=True)
class Key:
    """A key of configuration files."""

    kind: Kind
    """The kind of its values."""
    default: str
    """The default, in words or as TOML."""
    meaning: str
    """The documentation of the key."""
    example: str
    """An example in TOML."""


def check(values: Mapping[str, Any], origin: str) -> Mapping[str, Any]:
    """Return *values* if all keys are known and all values of their kind.

    Raises `ConfigError` that names *origin*, the key and what was expected.
    """
    for key, value in values.items():
        if key not in KEYS:
            raise ConfigError(f"{origin}: unknown key '{key}'{_hint(key, value)}")
        if problem := KEYS[key].kind.problem(value):
            raise ConfigError(f"{origin}: {key}: {problem}")
    return values


def _hint(key: str, value: object) -> str:
    """Return a suggestion for the unknown *key*."""
    if isinstance(value, dict) and (key == "tool" or KEYS.keys() & value.keys()):
        return (
            "; keys of kinlint are at the top level of kinlint.toml, or in [tool.kinlint] of "
            "pyproject.toml"
        )
    return did_you_mean(key, KEYS) or f"; there are {', '.join(KEYS)}"


_CONTEXTS = "a directory or a table of context IRIs and files"
_ARGUMENTS = table(SCALAR, "of arguments and values")

KEYS: Mapping[str, Key] = {
    "extend": Key(
        STRING,
        "none",
        "Another configuration file that this one builds on.",
        'extend = "../kinlint.toml"',
    ),
    "select": Key(
        STRINGS,
        "all but optional and preview rules",
        "Rules to check: codes or beginnings of codes, names, families, anti-patterns (AP1 to AP6)"
        " or ALL.",
        'select = ["ALL"]',
    ),
    "extend-select": Key(
        STRINGS,
        "[]",
        "Rules to check in addition to those selected.",
        'extend-select = ["POR"]',
    ),
    "preview": Key(
        SWITCH,
        "false",
        "Whether preview rules, which may still change, are checked.",
        "preview = true",
    ),
    "ignore": Key(STRINGS, "[]", "Rules not to check.", 'ignore = ["FRM014"]'),
    "severity": Key(
        table(one_of(SEVERITIES), "of rules and severities"),
        "{}",
        "Severities of rules that replace their own.",
        'severity = { LD007 = "info" }',
    ),
    "fixable": Key(
        STRINGS, '["ALL"]', "Rules whose findings may be fixed.", 'fixable = ["UNI", "LD001"]'
    ),
    "unfixable": Key(STRINGS, "[]", "Rules whose findings are not fixed.", 'unfixable = ["LIM"]'),
    "unsafe-fixes": Key(
        SWITCH,
        "not set: unsafe fixes are offered, not applied",
        "Whether unsafe fixes are applied; if false, they are not offered either.",
        "unsafe-fixes = false",
    ),
    "extend-safe-fixes": Key(
        STRINGS,
        "[]",
        "Rules whose unsafe fixes are safe in this project.",
        'extend-safe-fixes = ["UNI001"]',
    ),
    "extend-unsafe-fixes": Key(
        STRINGS,
        "[]",
        "Rules whose safe fixes are unsafe in this project.",
        'extend-unsafe-fixes = ["ID"]',
    ),
    "per-file-ignores": Key(
        table(STRINGS, "of places and rules"),
        "{}",
        "Rules not to check in files (a glob), below a JSON Pointer in files (glob#/pointer), or"
        " about an entity (<IRI>).",
        'per-file-ignores = { "legacy/*.jsonld" = ["UNI"] }',
    ),
    "extend-per-file-ignores": Key(
        table(STRINGS, "of places and rules"),
        "{}",
        "The same, in addition to the configuration that is extended.",
        'extend-per-file-ignores = { "models/arm.jsonld#/@graph/0" = ["LD001"] }',
    ),
    "require-reason": Key(
        SWITCH, "false", "Whether each suppression needs a reason.", "require-reason = true"
    ),
    "exclude": Key(
        STRINGS,
        "hidden and build directories",
        "Files and directories to skip: globs relative to the directory of this file.",
        'exclude = ["third-party"]',
    ),
    "extend-exclude": Key(
        STRINGS,
        "[]",
        "Files and directories to skip in addition to `exclude`.",
        'extend-exclude = ["generated"]',
    ),
    "respect-gitignore": Key(
        SWITCH,
        "true",
        "Whether files that git ignores are skipped in directories.",
        "respect-gitignore = false",
    ),
    "target": Key(
        STRINGS,
        "[]",
        f"Consumers to check for, as NAME or NAME@VERSION: {', '.join(TARGETS)}.",
        'target = ["gazebo", "mujoco@3.3"]',
    ),
    "per-file-target": Key(
        table(STRINGS, "of globs and consumers"),
        "{}",
        "Consumers to check files for (a glob), in addition to `target`.",
        'per-file-target = { "sim/*.urdf" = ["gazebo-sim", "mujoco@3.3"] }',
    ),
    "srdf": Key(
        table(STRING, "of globs and files"),
        "{}",
        "The URDF of SRDF and YAML files, where it is not the one that is found.",
        'srdf = { "config/*.srdf" = "urdf/arm.urdf" }',
    ),
    "fail-on": Key(
        one_of(THRESHOLDS),
        '"warning"',
        "Least severity that makes the exit code 1.",
        'fail-on = "error"',
    ),
    "show": Key(
        one_of(SEVERITIES),
        '"warning", or "info" if fail-on is',
        "Least severity that full, concise and grouped show; other formats report everything.",
        'show = "info"',
    ),
    "output-format": Key(
        one_of(OUTPUT_FORMATS), '"full"', "Format of the report.", 'output-format = "concise"'
    ),
    "baseline": Key(
        STRING,
        "none",
        "Baseline: the file of known findings, which are not reported.",
        'baseline = "kinlint-baseline.json"',
    ),
    "contexts": Key(
        STRING, "the newest", "Release of the comp-rob2b contexts.", 'contexts = "ba7e601"'
    ),
    "extra-contexts": Key(
        either(_CONTEXTS, table(STRING, "of IRIs and files"), ONE_OR_MORE),
        "{}",
        "Your own contexts, as local files: a file for each IRI, or directories.",
        'extra-contexts = { "https://example.org/gripper.json" = "contexts/gripper.json" }',
    ),
    "rules": Key(
        ONE_OR_MORE, "[]", "Your own rule files, or directories of them.", 'rules = ["rules"]'
    ),
    "code-prefix": Key(
        STRING,
        "none",
        "Prefix of the codes of your own rules, for kinlint new: one to eight capitals.",
        'code-prefix = "ACME"',
    ),
    "shapes": Key(ONE_OR_MORE, "[]", "Your own SHACL shapes.", 'shapes = ["shapes/gripper.ttl"]'),
    "partial": Key(
        SWITCH,
        "false",
        "Whether the files are part of a larger model (no missing-part findings).",
        "partial = true",
    ),
    "file-timeout": Key(
        SECONDS,
        "0",
        "Time limit for each file in seconds; a file that takes longer is reported, and the"
        " others are linted. 0 means no limit.",
        "file-timeout = 60",
    ),
    "engine": Key(one_of(ENGINES), '"oxigraph"', "SHACL engine.", 'engine = "pyshacl"'),
    "packages": Key(
        table(STRING, "of packages and directories"),
        "{}",
        "Directories of ROS packages, in addition to those found.",
        'packages = { arm_description = "../arm_description" }',
    ),
    "xacro-args": Key(
        table(
            either("a string or number", _ARGUMENTS, SCALAR),
            "of arguments and values, or of globs and such tables",
        ),
        "{}",
        "Arguments for xacro files: for all, or below a glob for the files that match it.",
        'xacro-args = { prefix = "left_", "right/*.xacro" = { prefix = "right_" } }',
    ),
    "xacro-env": Key(
        STRINGS,
        "[]",
        "Environment variables for $(env) and $(optenv), in addition to those of ROS.",
        'xacro-env = ["ROBOT_MODEL"]',
    ),
}
"""All keys, in the order in which they are told."""
