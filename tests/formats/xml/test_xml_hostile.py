"""Files written to make a reader slow, large or indiscreet."""

from __future__ import annotations

import time

import pytest
from reading_xml import model

from kinlint.document import Document
from kinlint.errors import SourceError
from kinlint.formats.xml import elements, expat_parsing

HEAD, END = "<robot name='a'>", "</robot>"
MANY = 30_000
SECONDS = 20
"""CPU time of an answer, beyond which it grows with more than the size on any machine."""
MANY_ATTRIBUTES = " ".join(f'b{k}=""' for k in range(1001))


def entity(level: int) -> str:
    return f"<!ENTITY l{level} '{f'&l{level - 1};' * 10 if level else 'ha'}'>"


LAUGHS = "".join(map(entity, range(12)))
LONG = "a" * 1000


def answered(text: str) -> Document | SourceError:
    start = time.process_time()
    answer: Document | SourceError
    try:
        answer = model(text)
    except SourceError as error:
        answer = error
    assert time.process_time() - start < SECONDS
    return answer


@pytest.mark.parametrize(
    "text",
    [
        f"<!DOCTYPE robot [{LAUGHS}]>{HEAD}&l11;</robot>",
        f"<!DOCTYPE robot [<!ENTITY a '{'x' * 100_000}'>]>{HEAD}{'&a;' * 100_000}</robot>",
        f"<!DOCTYPE robot [<!ENTITY a SYSTEM 'file:///etc/passwd'>]>{HEAD}&a;</robot>",
        f"{HEAD}{'<a>' * MANY}{'</a>' * MANY}</robot>",
        HEAD + f"<{LONG}>" * 150 + f"</{LONG}>" * 150 + END,
        f"{HEAD}<link name='{'a' * 100_000}'/></robot>",
    ],
    ids=["laughs", "quadratic", "external", "deep", "long tags", "long name"],
)
def test_bombs_are_refused_where_they_stand(text: str) -> None:
    error = answered(text)
    assert isinstance(error, SourceError)
    assert error.line == 1


@pytest.mark.slow
@pytest.mark.parametrize(
    "text",
    [
        HEAD + "<link " + " ".join(f'a{k}=""' for k in range(MANY)) + "/>" + END,
        HEAD + "<link " + 'name="a" ' * MANY + "/>" + END,
        HEAD + "<link " + " ".join(f'xmlns:a{k}="" b{k}:x=""' for k in range(10_000)) + "/>" + END,
        HEAD + "<link/>" * MANY + END,
        HEAD + '<link name="a"/>' * MANY + END,
        HEAD + "<!-- " * MANY,
        HEAD + "<!-- -- -->" * MANY + END,
        HEAD + "<!--" + "-" * MANY * 10 + "-->" + END,
        HEAD + '<a "' * MANY,
        HEAD + "<a '\"" * MANY,
        HEAD + "<" * MANY,
        HEAD + "&" * MANY + END,
        HEAD + "&" * MANY + ";" + END,
        HEAD + "&a" * MANY + ";" + END,
        HEAD + "]]>" * MANY + END,
        HEAD + "<![CDATA[" * MANY,
        HEAD + "x" * 1_000_000 + END,
        HEAD + "<a>x</a>" * MANY + "y" + END,
        HEAD + "<!-- kinlint: ignore[A] -->" * 10_000 + END,
        HEAD + "<!-- kinlint: ignore[" + "A," * MANY + "] -->" + END,
        '<?xml version="0.0"?>' * MANY + "<robot/>",
        "<!-- -->" * MANY,
        "<robot>" * 150 + "\N{ROBOT FACE}" * 100_000,
        "<" + "a" * 1_000_000,
        "\0" * 1_000_000,
    ],
    ids=range(25),
)  # fmt: skip
def test_the_time_grows_with_the_size_alone(text: str) -> None:
    answered(text)


def test_size_is_bounded(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(elements, "MOST_ELEMENTS", 3)
    with pytest.raises(SourceError, match="more than 3 elements") as caught:
        model(f"{HEAD}\n<a/><a/>\n <a/><b/></robot>")
    assert (caught.value.line, caught.value.column) == (3, 2)
    with pytest.raises(SourceError, match="more than 1000 attributes") as caught:
        model(f"{HEAD}\n <a {MANY_ATTRIBUTES}/></robot>")
    assert (caught.value.line, caught.value.column) == (2, 2)
    monkeypatch.setattr(expat_parsing, "MOST_CHARACTERS", 10)
    with pytest.raises(SourceError, match="more than 10 characters"):
        model(f"{HEAD}</robot>")
