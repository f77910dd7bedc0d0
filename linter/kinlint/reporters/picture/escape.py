"""Text and attributes of HTML and SVG that mean nothing but themselves, whatever a file says."""

from __future__ import annotations

from html import escape

from kinlint.reporters.display_width import printable


def text(value: str) -> str:
    """*value* between tags or in a quoted attribute: nothing in it is markup.

    Characters that XML forbids, or that reorder what is read, are written as escapes.
    """
    return escape(printable(value), quote=True)


def number(value: float) -> str:
    """A length in pixels, to a tenth."""
    return f"{value:.1f}".removesuffix(".0")


def attributes(**values: str | float | None) -> str:
    """Attributes, each behind a blank; an underscore in a name is a hyphen, one at its end nothing.

    Those that are None are left out.
    """
    return "".join(
        f' {name.rstrip("_").replace("_", "-")}="{_value(value)}"'
        for name, value in values.items()
        if value is not None
    )


def _value(value: str | float) -> str:
    return text(value) if isinstance(value, str) else number(value)


def element(name: str, content: str = "", **values: str | float | None) -> str:
    """An element with *content*, which is markup already."""
    return f"<{name}{attributes(**values)}>{content}</{name}>"


def empty(name: str, **values: str | float | None) -> str:
    """An element of SVG with nothing in it."""
    return f"<{name}{attributes(**values)}/>"
