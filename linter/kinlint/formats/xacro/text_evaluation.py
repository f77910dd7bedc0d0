"""Evaluates the `${…}` and `$(…)` in texts, and remembers which part became which."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any, NamedTuple

from kinlint.files.bounded_read import Unreadable
from kinlint.formats.xacro.expansion import Failure, message
from kinlint.formats.xacro.expansion_limits import LimitExceeded, Limits
from kinlint.formats.xacro.expression import evaluate
from kinlint.formats.xacro.substitution import UnknownSubstitution
from kinlint.formats.xacro.xacro_parser import Malformed
from kinlint.light_dataclasses import dataclass

TOKEN = re.compile(
    r"(?P<escape>\$\$+[{(])|\$\{(?P<expression>[^}]*)\}|\$\((?P<substitution>[^)]*)\)"
    r"|(?P<text>[^$]+|\$[^{($]+|\$\Z)"
)
SHOWN = 60


class Part(NamedTuple):
    """A part of the result of an evaluation."""

    start: int
    """Its start in the result."""
    end: int
    """Its end in the result."""
    begin: int
    """Start of what it came from, in the text."""
    stop: int
    """End of what it came from, in the text."""


class Traced(str):
    """The result of evaluating a text with several parts, which it knows."""

    __slots__ = ("parts",)
    parts: tuple[Part, ...]

    def __str__(self) -> str:
        return self


@dataclass
class TextEvaluator:
    """Evaluates texts of one expansion; `substitute` knows what `$(…)` stands for."""

    bounds: Limits
    """Limits of the work that expressions may do."""
    substitute: Callable[[str], str]
    """Returns the value of a `$(…)`."""

    def evaluate(self, text: str, symbols: Any) -> Any:
        """Return the value of *text* with *symbols*; of any type if it is one expression."""
        self.bounds.step()
        if "$" not in text:
            return text
        results: list[Any] = []
        places: list[tuple[int, int]] = []
        at = 0
        while at < len(text):
            match = TOKEN.match(text, at)
            if match is None:
                raise Failure(f"an expression has no end: '{_short(text[at:])}'")
            results.append(self._token(match, symbols))
            places.append((at, match.end()))
            at = match.end()
        if len(results) == 1:
            result = results[0]
            return result[:] if isinstance(result, str) else result
        return self._joined([str(self.bounds.result(each)) for each in results], places)

    def _token(self, match: re.Match[str], symbols: Any) -> Any:
        if match["expression"] is not None:
            return self._expression(match["expression"], symbols)
        if match["substitution"] is not None:
            inside = match["substitution"]
            try:
                return self.substitute(str(self.evaluate(inside, symbols)))
            except (UnknownSubstitution, Failure, LimitExceeded, RecursionError):
                raise
            except Exception as error:  # noqa: BLE001  of any kind
                raise Failure(
                    f"substitution '$({_short(inside)})' has no value: {message(error)}"
                ) from None
        return match[0][1:] if match["escape"] else match[0]

    def _expression(self, expression: str, symbols: Any) -> Any:
        try:
            text = self.evaluate(expression, symbols)
            return evaluate(text, symbols, self.bounds) if isinstance(text, str) else text
        except (Failure, UnknownSubstitution, LimitExceeded, Malformed, RecursionError):
            raise
        except Unreadable as error:
            raise Failure(str(error)) from None
        except Exception as error:  # noqa: BLE001  expressions fail in any way
            shown = _short(expression.strip())
            raise Failure(f"expression '{shown}' has no value: {message(error)}") from None

    def _joined(self, results: list[str], places: list[tuple[int, int]]) -> Traced:
        result = Traced(self.bounds.text("".join(results)))
        parts, at = [], 0
        for each, (begin, stop) in zip(results, places, strict=True):
            parts.append(Part(at, at + len(each), begin, stop))
            at += len(each)
        result.parts = tuple(parts)
        return result


def _short(text: str) -> str:
    text = " ".join(text.split())
    return text if len(text) <= SHOWN else text[: SHOWN - 1] + "…"
