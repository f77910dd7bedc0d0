"""What is examined when, without an editor."""

import pytest
from robots import GOOD, LEG

from kinlint.server import session
from kinlint.server.buffers import Buffer
from kinlint.server.client_settings import ClientSettings
from kinlint.server.frozen_state import FrozenState
from kinlint.server.workspace import Workspace

SRDF = '<robot name="leg"><group name="all"><link name="toe"/></group></robot>'


@pytest.fixture
def here(tmp_path, rules_cache, monkeypatch):
    monkeypatch.chdir(tmp_path)
    (tmp_path / "leg.urdf").write_text(LEG, "utf-8")
    (tmp_path / "leg.srdf").write_text(SRDF, "utf-8")
    (tmp_path / "arm.urdf").write_text(GOOD.replace('"leg"', '"arm"'), "utf-8")
    return tmp_path


@pytest.fixture
def library(rules_cache):
    return Workspace(rules_cache, "utf-16", related=True)


def moment(here, generation, *texts, **more):
    opened = [Buffer.from_text((here / name).as_uri(), generation, text) for name, text in texts]
    buffers = {one.path: one for one in opened}
    return FrozenState(generation, 1, buffers, (here,), ClientSettings(), **more)


def codes(step):
    return {
        path.name: [item.code for item in told.items]
        for path, told in step.found.items()
        if told.items
    }


def never():
    return False


@pytest.mark.slow
def test_only_models_with_open_files_are_examined(here, library):
    """And when all is known there is nothing to do."""
    (here / "leg.srdf").unlink()
    now = moment(here, 1, ("leg.urdf", LEG))

    first, second = library.step(now, never), library.step(now, never)

    assert codes(first) == {"leg.urdf": ["LIM001"]}
    assert [one.name for one in first.found] == ["leg.urdf"]
    assert (first.done, second.done) == (False, True)
    assert {here / "leg.urdf"} == second.fresh
    assert {here / "leg.urdf", here / "arm.urdf"} == {path for key in second.models for path in key}


@pytest.mark.slow
def test_open_files_of_a_large_model_come_first(here, library, monkeypatch):
    """They alone, as a part of a model; then all files."""
    monkeypatch.setattr(session, "LARGE", 0)
    monkeypatch.setattr(session, "MUCH", 1)
    now = moment(here, 1, ("leg.urdf", LEG))

    first, second, third = (library.step(now, never) for _ in range(3))

    assert codes(first) == {"leg.urdf": ["LIM001"]}
    assert [one.name for one in first.found] == ["leg.urdf"]
    assert codes(second).keys() == {"leg.urdf", "leg.srdf"}
    assert third.done


@pytest.mark.slow
def test_what_nobody_has_open_is_forgotten_until_it_is_asked_for(here, library):
    """What was told of it was told."""
    now = moment(here, 1, everything=True)
    steps = [library.step(now, never)]
    while not steps[-1].done:
        steps.append(library.step(now, never))
    assert any("LIM001" in codes(step).get("leg.urdf", ()) for step in steps)

    with pytest.raises(Exception, match=r"^$"):
        library.consult(here / "leg.urdf", None, lambda view: view.findings, never)
    library.step(moment(here, 1, wanted=frozenset([here / "leg.urdf"])), never)
    found = library.consult(here / "leg.urdf", None, lambda view: view.findings, never)

    assert "LIM001" in {one.rule.code for one in found}


def test_a_cancelled_step_finds_nothing(here, library):
    """And is made again."""
    now = moment(here, 1, ("leg.urdf", LEG))

    assert not library.step(now, lambda: True).found
    assert codes(library.step(now, never))


def test_a_fault_is_told_and_ends_nothing(here, library, monkeypatch):
    """A rule, or a reader, that breaks."""

    class Broken:
        def __init__(self, *_, **_more):
            raise ZeroDivisionError

    with monkeypatch.context() as patch:
        patch.setattr(session, "Analyzer", Broken)
        step = library.step(moment(here, 1, ("leg.urdf", LEG)), never)
        assert "ZeroDivisionError" in step.faults[0]
        assert library.step(moment(here, 1, ("leg.urdf", LEG)), never).done
    assert codes(library.step(moment(here, 2, ("leg.urdf", LEG + "\n")), never))
