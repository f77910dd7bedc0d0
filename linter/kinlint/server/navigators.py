"""The navigators of the models that were asked about last."""

from __future__ import annotations

from collections.abc import Callable
from typing import TypeVar

from kinlint.navigation.navigator import Navigator
from kinlint.pipeline.analyzer import Examination
from kinlint.server.app import KinlintServer
from kinlint.server.request_context import RequestContext

T = TypeVar("T")
MOST = 4
"""Number of navigators kept."""


class Navigators:
    """Makes the navigator of a view once for each examination. One thread works with it."""

    def __init__(self) -> None:
        self._kept: list[tuple[Examination, Navigator]] = []

    def navigator(self, view: RequestContext) -> Navigator:
        """The navigator of the model of *view*."""
        for examination, navigator in self._kept:
            if examination is view.examination:
                return navigator
        made = Navigator(view.examination, view.rulebook, view.settings.extra_contexts)
        self._kept = [(view.examination, made), *self._kept[: MOST - 1]]
        return made


async def ask_navigator(
    server: KinlintServer, uri: str, question: Callable[[RequestContext, Navigator], T]
) -> T | None:
    """Return the answer of *question* for the text *uri*; None if that is part of no model."""
    return await server.consult(uri, lambda view: question(view, _NAVIGATORS.navigator(view)))


_NAVIGATORS = Navigators()
