"""The SARIF log of a run: one run, one tool, deterministic.

It holds no times, no identifiers made up on the spot and no absolute paths unless the report has
its call (`--sarif-invocation`), so that equal findings make equal logs on every machine.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

from kinlint.report import Report
from kinlint.reporters.json_escape import json_text
from kinlint.reporters.sarif.artifact_location import Artifacts
from kinlint.reporters.sarif.rule_descriptors import TAXONOMY, Catalogue, taxonomy
from kinlint.reporters.sarif.run_details import called, embedded, identity
from kinlint.reporters.sarif.sarif_result import Results
from kinlint.reporters.sarif.version_control import provenance, repository_top
from kinlint.reporters.terminal_style import Style
from kinlint.vocabulary import KINLINT

SCHEMA = "https://json.schemastore.org/sarif-2.1.0.json"


def render(report: Report, style: Style) -> Iterator[str]:
    """The log as JSON."""
    yield json_text(log(report), style) + "\n"


def log(report: Report) -> dict[str, Any]:
    """The `sarifLog` object."""
    catalogue = Catalogue(report.findings)
    top = repository_top(report.root)
    artifacts = Artifacts(report.root, top)
    results = Results(artifacts, catalogue)
    silenced = len(report.unsuppressed) < len(report.findings)
    found = [results.result(finding, silenced=silenced) for finding in report.findings]
    if report.baseline is not None:
        # Nothing that was known before is among them, and either all results say so or none does.
        found = [{**result, "baselineState": "new"} for result in found]
    unparsed = any(finding.rule.unparsable for finding in report.unsuppressed)
    invocation: dict[str, Any] = {"executionSuccessful": not (report.errors or unparsed)}
    if report.errors:
        notifications = [results.notification(error) for error in report.errors]
        invocation["toolExecutionNotifications"] = notifications
    if report.invocation is not None:
        invocation |= called(report.invocation, report.root)
    texts = list(embedded(report, artifacts)) if report.embedded else ()
    run: dict[str, Any] = {
        "tool": {
            "driver": {
                "name": "kinlint",
                "version": report.version,
                "semanticVersion": report.version,
                "informationUri": KINLINT,
                "supportedTaxonomies": [{"name": TAXONOMY, "index": 0}],
                "rules": catalogue.descriptors(),
            }
        },
        "invocations": [invocation],
        "originalUriBaseIds": artifacts.bases(),
        "columnKind": "utf16CodeUnits",
        "newlineSequences": ["\r\n", "\n", "\r"],
        "results": found,
        "taxonomies": [taxonomy()],
    }
    if texts:
        run["artifacts"] = texts
    if report.invocation is not None:
        run["automationDetails"] = identity()
    origin = None if top is None or artifacts.outside else provenance(top)
    if origin is not None:
        run["versionControlProvenance"] = [origin]
    return {"$schema": SCHEMA, "version": "2.1.0", "runs": [run]}
