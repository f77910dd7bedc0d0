"""Values of the wrong form are told exactly where usd-core rejects the layer."""

from __future__ import annotations

import pytest
from reading_usd import read, values

Sdf = pytest.importorskip("pxr.Sdf")

STATEMENTS = """
    token x = Z | token x = 3 | token x = @a@ | token x = ["a"] | token x = </a> | token x = None
    string x = foo | string x = 'a' | string[] x = "a" | string[] x = ["a", 1] | token[] x = []
    asset x = foo | asset x = "a" | asset x = @a@ | asset[] x = [@a@, foo]
    float x = (1) | float x = [3] | float x = True | float x = 3 | float[] x = 3 | float[] x = [3]
    float3 x = [1, 2, 3] | float3 x = (1, 2) | float3 x = (1, 2, (3)) | float3 x = (1, 2, 3)
    float3[] x = (1, 2, 3) | float3[] x = [(1, 2, 3), (1, 2)] | quatf x = ((1, 0, 0), 0)
    matrix2d x = (1, 2, 3, 4) | matrix2d x = [(1, 2), (3, 4)] | matrix2d x = ((1, 2), (3, 4))
    bool x = maybe | bool x = yes | bool x = "true" | bool x = [1] | bool x = 0 | int x = "1"
    rel x = [</a>, "b"] | rel x = [</a>]
"""
METADATA = """
    kind = component | kind = "component" | active = maybe | active = 0 | hidden = [1]
    doc = foo | doc = "foo" | displayName = 3 | assetInfo = "x" | customData = { string a = 1 }
    customData = { string a = "1" } | variants = { string v = 3 } | inherits = "a" | inherits = </a>
    apiSchemas = "A" | apiSchemas = [A] | apiSchemas = ["A"] | prepend apiSchemas = None
    references = "a" | references = @a@ | references = [@a@, </b>] | variantSets = v
"""
LAYERS = """
    upAxis = Z | upAxis = "Z" | metersPerUnit = "1" | metersPerUnit = [1] | metersPerUnit = 1
    defaultPrim = r | subLayers = @a@ | subLayers = ["a"] | customLayerData = 3
"""


def _each(text: str) -> list[str]:
    return [each.strip() for line in text.split("\n") for each in line.split("|") if each.strip()]


def _statement(text: str) -> str:
    return next(each.strip() for each in text.splitlines() if each.startswith("    "))


CASES = [
    *(f'#usda 1.0\ndef Xform "r"\n{{\n    {each}\n}}\n' for each in _each(STATEMENTS)),
    *(f'#usda 1.0\ndef Xform "r" (\n    {each}\n)\n{{\n}}\n' for each in _each(METADATA)),
    *(f"#usda 1.0\n(\n    {each}\n)\n" for each in _each(LAYERS)),
]


@pytest.mark.parametrize("text", CASES, ids=_statement)
def test_forms_are_those_of_usd_core(text):
    try:
        accepted = Sdf.Layer.CreateAnonymous(".usda").ImportFromString(text)
    except Exception:  # noqa: BLE001  the type of error is that of another library
        accepted = False

    assert bool(values(read(text, ""), "expected")) is not accepted
