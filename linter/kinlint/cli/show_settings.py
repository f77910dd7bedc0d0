"""The page of `--show-settings`: what holds for the run, and for each file."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from kinlint.configuration.selection import Policies
from kinlint.configuration.settings import Settings
from kinlint.files.pathname import shown
from kinlint.project.discovery import Input
from kinlint.rule import Rule


def pages(
    settings: Settings, run: Mapping[str, str], rules: Sequence[Rule], inputs: Sequence[Input]
) -> Iterator[str]:
    """The lines of the page; *run* is what else holds for it.

    Files with equal settings share a paragraph.
    """
    yield f"contexts = {settings.contexts}\n"
    for iri, path in settings.extra_contexts.items():
        yield f"extra-contexts <{iri}> = {shown(path)}\n"
    for name, paths in (
        ("extra-contexts", settings.context_directories),
        ("rules", settings.rules),
        ("shapes", settings.shapes),
    ):
        for path in paths:
            yield f"{name} = {shown(path)}\n"
    yield f"engine = {settings.engine}\n"
    yield f"partial = {str(settings.partial).lower()}\n"
    yield f"file-timeout = {settings.file_timeout or 0:g}\n"
    yield from (f"{key} = {value}\n" for key, value in run.items())
    unsafe = "hint" if settings.unsafe_fixes is None else str(settings.unsafe_fixes).lower()
    yield f"unsafe-fixes = {unsafe}\n"
    yield f"cache = {settings.cache or 'none'}\n"
    policies = Policies(settings, rules)
    groups: dict[tuple[str, ...], list[str]] = {}
    for one in inputs:
        groups.setdefault(tuple(_file(one.name, policies)), []).append(one.name)
    for lines, names in groups.items():
        yield "\n"
        yield from (f"{name}\n" for name in names)
        yield from (f"  {line}\n" for line in lines)


def _file(name: str, policies: Policies) -> Iterator[str]:
    settings, policy, trust = (
        policies.settings.for_file(name),
        policies.for_file(name),
        policies.trust(name),
    )
    origins = dict.fromkeys(choice.origin for choice in settings.choices)
    yield f"rules chosen by: {', '.join(origins) or 'default'}"
    yield f"require-reason = {str(settings.require_reason).lower()}"
    if settings.targets:
        yield f"target = {', '.join(settings.targets)}"
    if settings.urdf:
        yield f"urdf = {shown(settings.urdf)}"
    for package, path in dict(settings.packages).items():
        yield f"package {package} = {shown(path)}"
    for argument, value in dict(settings.xacro_args).items():
        yield f"xacro-arg {argument} = {value}"
    for ignore in settings.ignores:
        yield f"ignored by {ignore.origin}, {ignore.key}: {', '.join(ignore.selectors)}"
    for rule in policies.rules:
        severity = policy.severity(rule)
        careful = trust.unsafe.get(rule.code)
        fixes = "" if careful is None else f", fixes {'unsafe' if careful else 'safe'}"
        fixes = fixes if trust.allows_fixes(rule) else ", not fixed"
        yield f"{rule.code} {rule.name}: {severity.label + fixes if severity else 'off'}"
