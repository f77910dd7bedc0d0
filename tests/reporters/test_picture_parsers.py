"""Pictures in the languages of others, read by those: Graphviz, and Mermaid where Node has it."""

from __future__ import annotations

import json
import os
import shutil
import subprocess
from html import unescape
from pathlib import Path

import pytest
from drawn import HOSTILE, about, chain, picture

from kinlint.reporters.display_width import printable
from kinlint.reporters.picture.formats import pieces
from kinlint.reporters.terminal_style import Style

ROBOTS = (chain(*HOSTILE, close=True), chain("a", "b", "c"))
MODULES = os.environ.get("KINLINT_TESTS_NODE_MODULES", "")
"""A directory node_modules that has mermaid and jsdom."""
PARSE = """
import { readFileSync } from "fs";
const { JSDOM } = await import(process.argv[3] + "/jsdom/lib/api.js");
const dom = new JSDOM("<!DOCTYPE html><body></body>");
globalThis.window = dom.window; globalThis.document = dom.window.document;
const { default: mermaid } = await import(process.argv[3] + "/mermaid/dist/mermaid.core.mjs");
const text = readFileSync(process.argv[2], "utf8");
await mermaid.parse(text);
const made = await mermaid.mermaidAPI.getDiagramFromText(text);
const named = [...made.db.getVertices().values()].map((each) => each.text);
console.log(JSON.stringify({ named, edges: made.db.getEdges().length }));
"""


def written(directory: Path, form: str, *, unicode: bool) -> Path:
    made = picture(about("urn:l1"), about("urn:arm"), robots=ROBOTS)
    file = directory / f"robot.{form}"
    file.write_text("".join(pieces(made, form, Style(unicode=unicode), frames=True)), "utf-8")
    return file


@pytest.mark.skipif(shutil.which("dot") is None, reason="Graphviz is not installed")
@pytest.mark.parametrize("unicode", [True, False])
def test_graphviz_draws_them(tmp_path: Path, *, unicode: bool) -> None:
    file = written(tmp_path, "dot", unicode=unicode)
    done = subprocess.run(["dot", "-Tplain", file], capture_output=True, check=False, timeout=60)
    assert (done.returncode, done.stderr) == (0, b"")
    nodes = [line for line in done.stdout.decode().splitlines() if line.startswith("node")]
    parts = sum(len(each.links) * 2 + len(each.joints) for each in ROBOTS)
    assert len(nodes) == parts


@pytest.mark.skipif(not MODULES, reason="KINLINT_TESTS_NODE_MODULES has no mermaid")
@pytest.mark.parametrize("unicode", [True, False])
def test_mermaid_reads_them(tmp_path: Path, *, unicode: bool) -> None:
    file = written(tmp_path, "mermaid", unicode=unicode)
    script = tmp_path / "parse.mjs"
    script.write_text(PARSE, "utf-8")
    command = ["node", script, file, Path(MODULES).resolve()]
    done = subprocess.run(command, capture_output=True, check=False, timeout=120)
    assert done.returncode == 0, done.stderr.decode()
    found = json.loads(done.stdout)
    parts = sum(len(each.links) * 2 + len(each.joints) for each in ROBOTS)
    assert len(found["named"]) == parts + len(ROBOTS)
    texts = (name.replace("ﬂ°°", "&#").replace("¶ß", ";") for name in found["named"])
    read = {unescape(text).partition("<br>")[0] for text in texts}
    assert {printable(name) for name in HOSTILE if len(name) < 60 and name.strip()} <= read
