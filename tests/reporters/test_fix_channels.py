"""A fix is the same wherever it comes out: in the file, in SARIF, in JSON, in a patch."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path
from typing import Any

import pytest
from sarif_reader import by_specification, by_viewer, results
from support.linting import book

from kinlint.cli.main import main
from kinlint.edits import Edit, applied
from kinlint.formats.registry import decode
from kinlint.rule import Rule
from kinlint.text import SourceText, Span

pytestmark = pytest.mark.slow

BROKEN = Path(__file__).parents[2] / "samples" / "broken"


def samples() -> list[tuple[Path, Rule]]:
    """The broken samples whose rule knows how to mend them."""
    files = [file for file in sorted(BROKEN.iterdir()) if file.suffix != ".expected"]
    rules = [one for one in book().rules if one.repairs]
    return [(file, one) for one in rules for file in files if file.stem == one.name]


def by_edits(source: SourceText, edits: list[dict[str, Any]]) -> str:
    """The text after *edits* by rows and columns."""

    def offset(place: dict[str, int]) -> int:
        return source.line_starts[place["row"] - 1] + place["column"] - 1

    spans = (Span(offset(one["location"]), offset(one["end_location"])) for one in edits)
    return applied(
        source.text, [Edit(s, one["content"]) for s, one in zip(spans, edits, strict=True)]
    )


def by_lines(text: str, suggestion: dict[str, Any]) -> str:
    """The text after a suggestion of whole lines, as one applies it who knows only LF."""
    lines = text.split("\n")
    first, last = (suggestion["range"][end]["line"] for end in ("start", "end"))
    return "\n".join([*lines[: first - 1], *suggestion["text"].split("\n"), *lines[last:]])


@pytest.mark.usefixtures("rules_cache")
@pytest.mark.parametrize(
    ("file", "rule"),
    [pytest.param(*one, id=f"{one[1].code}-{one[0].suffix[1:]}") for one in samples()],
)
def test_a_fix_is_the_same_in_every_channel(
    file: Path, rule: Rule, tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys: Any
) -> None:
    """The preferred fix of each finding in a sample; the only one is what is written."""
    monkeypatch.chdir(tmp_path)
    shutil.copytree(BROKEN, tmp_path, dirs_exist_ok=True)
    source = decode(file.name, file.read_bytes())
    base = ["--isolated", "--select", rule.code, "--unsafe-fixes", "--exit-zero", file.name]

    copies = ["--sarif-output=s.json", "--rdjson-output=r.json", "--json-output=j.json", "-s"]
    assert main([*base, *copies]) == 0
    found = [one for one in json.loads(Path("j.json").read_bytes()) if _made(one["fix"])]
    texts = [by_edits(source, one["fix"]["edits"]) for one in found]
    logged = [one for one in results(json.loads(Path("s.json").read_bytes())) if "fixes" in one]
    for text, result in zip(texts, logged, strict=True):
        (change,) = result["fixes"][0]["artifactChanges"]
        assert by_specification(source, change) == by_viewer(source, change) == text
    diagnostics = json.loads(Path("r.json").read_bytes())["diagnostics"]
    suggested = [one for each in diagnostics for one in each.get("suggestions", ())]
    if len(suggested) == len(texts):
        assert [by_lines(source.text, one) for one in suggested] == texts

    assert main([*base, "--diff", "--quiet"]) in {0, 1}
    patch = capsys.readouterr().out.encode()
    assert main([*base, "--fix", "--silent"]) == 0
    written = decode(file.name, Path(file.name).read_bytes()).text
    if len(texts) == 1:
        assert texts == [written]
    if patch and shutil.which("patch"):
        shutil.copy(file, file.name)
        subprocess.run(["patch", "--binary", "--quiet", "-p0"], input=patch, check=True)
        assert decode(file.name, Path(file.name).read_bytes()).text == written


def _made(fix: dict[str, Any] | None) -> bool:
    """Whether there is a fix that is more than shown."""
    return fix is not None and fix["applicability"] != "display-only"
