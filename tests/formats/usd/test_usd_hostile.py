"""Stages written to make a reader slow, large or indiscreet."""

from __future__ import annotations

import time
from pathlib import Path

import pytest
from reading_usd import values
from usd_stages import layer, written

from kinlint.document import Document
from kinlint.errors import SourceError
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import decode, read
from kinlint.formats.usd.usda_parser import parse
from kinlint.formats.usd.usda_scanner import MalformedLayer
from kinlint.text import SourceText


def prim(name: str, *metadata: str, content: str = "") -> str:
    """Return a prim."""
    return "\n".join((f'def "{name}" (', *metadata, ")", "{", content, "}"))


SECONDS = 20
"""CPU time of an answer, beyond which something is followed without end on any machine."""


def answered(path: Path) -> Document | SourceError:
    """Return what reading the stage at *path* ends in, in less than `SECONDS`."""
    start = time.process_time()
    answer: Document | SourceError
    try:
        answer = read(decode(str(path), path.read_bytes()), ReadOptions())
    except SourceError as error:
        answer = error
    assert time.process_time() - start < SECONDS
    return answer


CYCLES = {
    "itself": {"a.usda": layer(prim("a", "references = @a.usda@</a>"))},
    "within": {
        "a.usda": layer(prim("a", "references = </b>") + "\n" + prim("b", "inherits = </a>"))
    },
    "below": {"a.usda": layer(prim("a", content=prim("b", "references = </a>")))},
    "each other": {
        "a.usda": layer(prim("a", "references = @b.usda@</b>")),
        "b.usda": layer(prim("b", "payload = @a.usda@</a>")),
    },
}


@pytest.mark.parametrize("layers", CYCLES.values(), ids=CYCLES)
def test_cycles_are_stated_and_not_followed(layers: dict[str, str], tmp_path: Path) -> None:
    answer = answered(written(tmp_path, layers))

    assert isinstance(answer, Document)
    assert set(values(answer, "reason").values()) == {"it leads back to where it stands"}


def test_layers_that_are_sublayers_of_each_other_are_read_once(tmp_path: Path) -> None:
    layers = {
        f"{name}.usda": layer(prim(name), more="    subLayers = [@a.usda@, @b.usda@]")
        for name in "ab"
    }
    answer = answered(written(tmp_path, layers))

    assert isinstance(answer, Document)
    assert len(values(answer, "defined")) == 2


def laughs(levels: int) -> dict[str, str]:
    """Return a layer in which each prim has ten that refer to the next."""
    prims = [
        prim(
            f"l{n}",
            content="\n".join(prim(f"c{k}", f"references = </l{n + 1}>") for k in range(10)),
        )
        for n in range(levels)
    ]
    return {"a.usda": layer("\n".join([*prims, prim(f"l{levels}")]))}


def test_references_that_multiply_are_refused_where_they_stand(tmp_path: Path) -> None:
    answer = answered(written(tmp_path, laughs(12)))

    assert isinstance(answer, SourceError)
    assert answer.line is not None
    assert answer.cause.startswith("references make more than")


@pytest.mark.parametrize(
    "asset",
    ["/etc/passwd", "../../../../../../etc/passwd", "https://example.org/a.usda", "~/.ssh/id"],
)
def test_what_is_out_of_reach_is_not_read(asset: str, tmp_path: Path) -> None:
    root = written(tmp_path, {"a.usda": layer(prim("a", f"references = @{asset}@"))})
    answer = answered(root)

    assert isinstance(answer, Document)
    assert len(values(answer, "reason")) == 1


def test_long_chains_of_references_end(tmp_path: Path) -> None:
    prims = (prim(f"p{n}", f"references = </p{n + 1}>") for n in range(2_000))
    answer = answered(written(tmp_path, {"a.usda": layer("\n".join(prims))}))

    assert isinstance(answer, SourceError)
    assert answer.cause == "more than 60 arcs lead from one to the next"


def assigned(name: str, item: str, count: int) -> str:
    return f"{name} = [{', '.join([item] * count)}]"


REFUSED = {
    "operations": ("xformOpOrder", assigned("token[] xformOpOrder", '"xformOp:scale"', 6_000)),
    "targets": ("'r' has more than", assigned("rel r", "</a>", 6_000)),
    "properties": ("more than 2000 properties", "\n".join(f"int i{n}" for n in range(2_001))),
    "variants": ("variants", 'variantSet "v" = {' + '"a" {}' * 2_001 + "}"),
    "words": ("more than 40000 members", assigned("token[] t", '""', 40_001)),
    "samples": ("samples", f"float f.timeSamples = {{{'1: 1, ' * 25_001}}}"),
    "joints": ("joints", "\n".join(f'def PhysicsJoint "j{n}" {{}}' for n in range(5_001))),
    "depth": ("nested more than", "int[] i = " + "[" * 300),
    "a number": ("over 1000 characters", f"double d = {'9' * 1_001}"),
    "a path": ("over 4000 characters", f"rel r = </{'a/' * 2_001}a>"),
}


@pytest.mark.parametrize(("cause", "content"), REFUSED.values(), ids=REFUSED)
def test_what_no_scene_has_is_refused_where_it_is(cause: str, content: str, tmp_path: Path) -> None:
    answer = answered(written(tmp_path, {"a.usda": layer(prim("a", content=content))}))

    assert isinstance(answer, SourceError)
    assert cause in answer.cause
    assert answer.line is not None
    assert answer.line > 7


@pytest.mark.parametrize("end", ["x]", "(1, 2 3)]", "}", '"a"]', ""])
def test_arrays_are_broken_at_the_member_that_is(end: str) -> None:
    points = "(1, 2, 3),\n" * 100 + "# a\n(4, 5e-1, -.6),\n" * 50
    text = layer(f'def Mesh "m"\n{{\n    point3f[] points = [{points}{end}\n}}')

    with pytest.raises(MalformedLayer) as raised:
        parse(SourceText("mesh.usda", text))
    assert text.count("\n", 0, raised.value.span.start) >= 208


def test_sublayers_that_lead_back_are_told(tmp_path: Path) -> None:
    layers = {
        f"{name}.usda": layer(prim("p"), more=f"    subLayers = [@{below}.usda@]")
        for name, below in ("ab", "bc", "ca")
    }
    answer = answered(written(tmp_path, layers))

    assert isinstance(answer, Document)
    assert list(values(answer, "reason").values()) == ["it leads back to where it stands"]


def test_more_bodies_than_any_scene_has_are_refused_where_they_begin(tmp_path: Path) -> None:
    body = 'def "b{}" (prepend apiSchemas = ["PhysicsRigidBodyAPI"]) {{}}'
    path = written(tmp_path, {"a.usda": layer("\n".join(map(body.format, range(5_001))))})
    answer = answered(path)

    assert isinstance(answer, SourceError)
    assert answer.cause == "the layer has more than 5000 rigid bodies"
    assert path.read_text(encoding="utf-8").splitlines()[answer.line - 1].startswith('def "b5000"')


def test_bodies_are_found_in_each_other_without_a_look_at_all_pairs(tmp_path: Path) -> None:
    inner = prim("hand", 'prepend apiSchemas = ["PhysicsRigidBodyAPI"]')
    outer = prim("arm", 'prepend apiSchemas = ["PhysicsRigidBodyAPI"]', content=inner)
    answer = answered(written(tmp_path, {"a.usda": layer(outer)}))

    assert isinstance(answer, Document)
    (around,) = values(answer, "aroundBody").values()
    assert around.endswith("/prim/arm")
