"""Robots that a command compares: the files of one side, read one by one."""

from __future__ import annotations

import os
from argparse import Namespace
from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path

from kinlint.catalogue import rulebook
from kinlint.catalogue.applicability import axioms_for
from kinlint.cli.model_inputs import find_inputs
from kinlint.document import Document
from kinlint.engine.required_terms import behind
from kinlint.errors import SourceError, UsageError
from kinlint.facts.comparison.comparison import COMPOSED
from kinlint.facts.comparison.extraction import RobotExtraction
from kinlint.facts.comparison.part_changes import Side
from kinlint.facts.fact_context import FactContext
from kinlint.facts.inputs import DESCRIPTIONS
from kinlint.facts.predicate_index import PredicateIndex
from kinlint.files.pathname import printable
from kinlint.files.revision import Repository
from kinlint.findings.locator import Locator
from kinlint.formats.dependencies.companions import pair
from kinlint.formats.dependencies.joined_documents import join_companions
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import read
from kinlint.formats.unread_text import malformed_values, refuse_unread
from kinlint.light_dataclasses import dataclass, replace
from kinlint.pipeline.run import Run
from kinlint.pipeline.stage_inputs import Demand, Inputs
from kinlint.pipeline.stages import run_stages
from kinlint.project.discovery import Input
from kinlint.project.layers import cache_directory
from kinlint.project.reading import read_models
from kinlint.project.revision_checkout import checkout
from kinlint.terms import Term
from kinlint.text import Location


@dataclass(frozen=True)
class Place:
    """File or directory to compare, maybe as it was at a revision."""

    path: Path
    """Path where it can be read now."""
    shown: str
    """Name for people: the argument."""
    is_given: bool = True
    """False for the copy of a revision, whose path nobody knows."""

    def name(self, name: str) -> str:
        """Return the name for people of the file that is called *name* where it is read."""
        if self.is_given:
            return name
        if not self.path.is_dir():
            return self.shown if Path(name) == self.path else Path(name).name
        inner = os.path.relpath(name, self.path)
        return f"{self.shown.rstrip('/')}/{inner}"


@contextmanager
def located(argument: str) -> Iterator[Place]:
    """Yield where *argument* is: a path, or `REVISION:PATH` of git, which is checked out aside.

    Raises UsageError where there is neither.
    """
    revision, colon, inner = argument.partition(":")
    if os.path.lexists(argument) or not colon or not revision:
        yield Place(Path(argument), argument)
        return
    repository = Repository.from_directory(Path.cwd())
    with checkout(repository.revision(revision)) as root:
        here = Path.cwd().resolve().relative_to(repository.top)
        tries = [root / here / inner, root / inner]
        path = next((each for each in tries if each.exists()), None)
        if path is None:
            raise UsageError(f"'{printable(inner)}' is not in revision '{printable(revision)}'")
        yield Place(Path(os.path.normpath(path)), argument, is_given=False)


class RobotReader:
    """Reader of the robots at a place."""

    def __init__(self, place: Place, options: Namespace) -> None:
        self.place = place
        self.options = Namespace(**{**vars(options), "paths": [str(place.path)]})
        self.found, self.settings = find_inputs(self.options)
        for error in self.found.errors:
            raise error
        cache = cache_directory(os.environ, options.cache_dir)
        self.book = rulebook.load(self.settings.rules, self.settings.shapes, cache)

    def inputs(self) -> Mapping[str, Input]:
        """Return the files by their paths within the place."""
        return {
            os.path.relpath(each.path or each.name, self.place.path): each
            for each in self.found.inputs
        }

    def robot(self, one: Input) -> Side | None:
        """Return the robot that a file describes; None if it describes none."""
        sources, errors = read_models([one], self.settings)
        for error in errors:
            raise error
        reading = ReadOptions.from_settings(self.settings)
        texts = pair(sources, self.settings)
        documents = join_companions([read(each, reading) for each in texts], self.settings.partner)
        refuse_unread(documents)
        store = run_stages(
            "closure",
            Run(self.book.vocabulary, self.book.axioms),
            Inputs(documents, documents),
            self._demand(documents),
        )
        context = FactContext(PredicateIndex(store))
        bodies, joints = context.mechanism.described, context.mechanism.joints
        if not bodies and not joints:
            return None
        own = documents[0].format
        form = own.lifted_as if own.is_tree else COMPOSED
        robot = RobotExtraction(context.robot_parts(context.scan)).robot(form, bodies, joints)
        locator = Locator(documents, store)

        def place(node: Term) -> Location | None:
            return self._renamed(locator.node(node))

        misread = [
            each._replace(place=self._moved(each.place))
            for document in documents
            for each in malformed_values(document)
        ]
        return Side(self.place.name(one.name), robot, own, place, misread)

    def only(self) -> Side:
        """Return the robot of the only file. Raises `SourceError` if it describes none."""
        found = self.robot(self.found.inputs[0]) if self.found.inputs else None
        if found is None:
            raise SourceError(self.place.shown, "it describes no link and no joint")
        return found

    def _demand(self, documents: Sequence[Document]) -> Demand:
        terms = frozenset(DESCRIPTIONS)
        axioms = self.book.axioms
        return Demand(
            terms=terms,
            lifted=behind(axioms, terms),
            axioms=axioms_for(documents, axioms, terms),
        )

    def _renamed(self, location: Location | None) -> Location | None:
        return None if location is None else self._moved(location)

    def _moved(self, location: Location) -> Location:
        if self.place.is_given:
            return location
        name = self.place.name(location.source.name)
        return replace(location, source=replace(location.source, name=name))
