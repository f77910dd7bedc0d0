"""The W3C JSON-LD 1.1 suites, run through PyLD as it is and through our reader."""

from __future__ import annotations

import json
import re
import warnings
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from data import locate_data
from pyld import jsonld

from kinlint.formats.blank_nodes import BlankNodes
from kinlint.formats.json_text.json_parser import parse
from kinlint.formats.jsonld.context_cache import ContextCache
from kinlint.formats.jsonld.expander import Processor
from kinlint.formats.jsonld.triples import Quads, Triples
from kinlint.text import SourceText

BASE = "https://w3c.github.io/json-ld-api/tests/"


def _file(name: str) -> Path:
    return locate_data("w3c", "json-ld-tests") / name.removeprefix(BASE)


class SuiteContexts:
    """Serves the suite's own files as contexts."""

    release = ""

    def __init__(self) -> None:
        self.memory: dict[Any, Any] = {}

    def document(self, iri: str) -> Any:
        path = _file(iri)
        found = iri.startswith(BASE) and path.is_file()
        return json.loads(path.read_text("utf-8")) if found else None

    def at_release(self, release: str) -> SuiteContexts:
        return self


@dataclass(frozen=True)
class W3CTest:
    suite: str
    id: str
    entry: Mapping[str, Any]

    @property
    def option(self) -> Mapping[str, Any]:
        return self.entry.get("option", {})

    @property
    def source(self) -> SourceText:
        path = _file(self.entry["input"])
        return SourceText(self.id, path.read_bytes().decode("utf-8"))

    @property
    def base(self) -> str:
        return self.option.get("base", BASE + self.entry["input"])

    @property
    def context(self) -> Any:
        named = self.option.get("expandContext")
        return json.loads(_file(named).read_text("utf-8"))["@context"] if named else None

    def expected(self) -> Any:
        text = _file(self.entry["expect"]).read_text("utf-8")
        return json.loads(text) if self.suite == "expand" else text

    def judge(self, run: Any) -> str:
        """Empty if *run* behaves as the suite demands, otherwise what it does instead."""
        code = self.entry.get("expectErrorCode")
        try:
            with warnings.catch_warnings():
                warnings.simplefilter("ignore", SyntaxWarning)
                result = run(self)
        except jsonld.JsonLdError as error:
            root: BaseException = error
            codes = {error.code}
            while root.__cause__ is not None:
                root = root.__cause__
                codes.add(getattr(root, "code", None))
            return "" if code in codes else f"raises {error.code!r}"
        except Exception as error:  # noqa: BLE001  whatever it does is its result
            return f"raises {type(error).__name__}"
        if code is not None:
            return f"does not raise {code!r}"
        if "expect" not in self.entry:
            return ""
        try:
            return "" if _same(self.suite, result, self.expected()) else "another result"
        except jsonld.JsonLdError:
            return "no N-Quads"


def w3c_tests() -> Iterator[W3CTest]:
    """All tests for a JSON-LD 1.1 processor."""
    for suite in ("expand", "toRdf"):
        manifest = json.loads(_file(f"{suite}-manifest.jsonld").read_text("utf-8"))
        for entry in manifest["sequence"]:
            if entry.get("option", {}).get("specVersion") != "json-ld-1.0":
                yield W3CTest(suite, entry["@id"], entry)


def run_pyld(test: W3CTest) -> Any:
    """What PyLD makes of a test without us."""

    def load(url: str, _options: Any) -> dict[str, Any]:
        document = SuiteContexts().document(url)
        return {"contextUrl": None, "documentUrl": url, "document": document, "contentType": ""}

    options = {"base": test.base, "documentLoader": load}
    options["contextResolver"] = jsonld.ContextResolver({}, load)
    for name in ("processingMode", "rdfDirection", "produceGeneralizedRdf"):
        if name in test.option:
            options[name] = test.option[name]
    if test.context is not None:
        options["expandContext"] = test.context
    document = json.loads(test.source.text)
    if test.suite == "expand":
        return jsonld.expand(document, options)
    return jsonld.to_rdf(document, {**options, "format": "application/n-quads"})


def run_ours(test: W3CTest, *, strict: bool = True) -> Any:
    """What our reader makes of it, positions riding along."""
    parsed = parse(test.source)
    mode = test.option.get("processingMode", "json-ld-1.1").removeprefix("json-ld-")
    processor = Processor(
        ContextCache(SuiteContexts(), strict=strict), test.base, strict=strict, mode=mode
    )
    expanded = processor.expand_document(parsed, test.context)
    if test.suite == "expand":
        return expanded
    quads = Quads()
    triples = Triples(
        BlankNodes(test.id),
        quads=quads,
        direction=test.option.get("rdfDirection"),
        generalized=test.option.get("produceGeneralizedRdf", False),
    )
    triples.add(expanded, parsed.span)
    return "".join(" ".join(term for term in quad if term) + " .\n" for quad in quads)


def _same(suite: str, one: Any, other: Any) -> bool:
    return _canonical(one) == _canonical(other) if suite == "toRdf" else _equal(one, other)


def _canonical(nquads: str) -> str:
    # PyLD reads no blank predicates; any one of them is as good as another.
    nquads = re.sub(r"^(\S+) _:\S+ ", r"\1 <blank:predicate> ", nquads, flags=re.MULTILINE)
    options = {"algorithm": "URDNA2015", "inputFormat": "application/n-quads"}
    return jsonld.normalize(nquads, {**options, "format": "application/n-quads"})


def _equal(one: Any, other: Any, *, ordered: bool = False) -> bool:
    """Equality of expanded forms: the order of arrays matters in lists alone."""
    if isinstance(one, dict) and isinstance(other, dict):
        return one.keys() == other.keys() and all(
            _equal(one[key], other[key], ordered=key == "@list") for key in one
        )
    if not isinstance(one, list) or not isinstance(other, list):
        return isinstance(one, bool) == isinstance(other, bool) and bool(one == other)
    if len(one) != len(other):
        return False
    if ordered:
        return all(_equal(a, b) for a, b in zip(one, other, strict=True))
    rest = list(other)
    for item in one:
        at = next((i for i, candidate in enumerate(rest) if _equal(item, candidate)), None)
        if at is None:
            return False
        del rest[at]
    return True
