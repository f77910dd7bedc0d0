"""The layout and the words of the package, as CONTRIBUTING promises them."""

import ast
import re
from collections import Counter
from pathlib import Path

import pytest

import kinlint

PACKAGE = Path(kinlint.__file__).parent
MODULES = sorted(PACKAGE.rglob("*.py"))
PER_FORMAT = {"editor", "format", "reader", "schema"}
"""Basenames of what each format has one of."""
VAGUE = {"common", "helpers", "manager", "managers", "misc", "util", "utils"}
LONGEST = 300
MEDIAN = 100
HEADLESS = re.compile(
    r"(What|Whether|Where|How|Which|Who|When|Those|That|So (many|much|far))\b", re.IGNORECASE
)
"""First words of a docstring that names neither an action nor a thing."""


def lines(module: Path) -> int:
    return module.read_text("utf-8").count("\n")


def docstrings(module: Path):
    for node in ast.walk(ast.parse(module.read_text("utf-8"))):
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef, ast.AsyncFunctionDef)):
            body = node.body
            texts = [
                each.value
                for each in body
                if isinstance(each, ast.Expr) and isinstance(each.value, ast.Constant)
            ]
            yield from ((text.lineno, text.value) for text in texts if isinstance(text.value, str))


def test_modules_tell_themselves_apart_by_their_names():
    names = Counter(each.stem for each in MODULES if not each.stem.startswith("__"))
    assert [name for name, number in names.items() if number > 1 and name not in PER_FORMAT] == []
    assert VAGUE.isdisjoint(names)


def test_modules_are_short():
    sizes = sorted(map(lines, MODULES))
    assert [each.name for each in MODULES if lines(each) > LONGEST] == []
    assert sizes[len(sizes) // 2] < MEDIAN


@pytest.mark.parametrize(
    "package", sorted({each.relative_to(PACKAGE).parts[0] for each in MODULES})
)
def test_docstrings_begin_with_a_verb_or_a_noun(package):
    modules = [each for each in MODULES if each.relative_to(PACKAGE).parts[0] == package]
    headless = [
        f"{module.relative_to(PACKAGE)}:{line}: {text.splitlines()[0]}"
        for module in modules
        for line, text in docstrings(module)
        if HEADLESS.match(text)
    ]
    assert headless == []


RECORDS = ("NamedTuple", "TypedDict", "Protocol")


def is_record(node: ast.ClassDef) -> bool:
    """Tell whether the fields of a class are its interface."""
    decorators = (ast.unparse(each) for each in node.decorator_list)
    bases = (ast.unparse(each).partition("[")[0] for each in node.bases)
    return any("dataclass" in each for each in decorators) or not {*bases}.isdisjoint(RECORDS)


def undocumented(module: Path):
    """The public fields in *module* without a text below them."""
    for node in ast.walk(ast.parse(module.read_text("utf-8"))):
        if not isinstance(node, ast.ClassDef) or not is_record(node):
            continue
        for each, below in zip(node.body, [*node.body[1:], None], strict=True):
            if not isinstance(each, ast.AnnAssign) or each.target.id.startswith("_"):
                continue
            if not (isinstance(below, ast.Expr) and isinstance(below.value, ast.Constant)):
                yield f"{node.name}.{each.target.id}"


@pytest.mark.slow
def test_fields_are_documented_one_by_one():
    found = {module.relative_to(PACKAGE).as_posix(): [*undocumented(module)] for module in MODULES}
    assert {name: fields for name, fields in found.items() if fields} == {}
