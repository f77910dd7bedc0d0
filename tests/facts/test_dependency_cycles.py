"""What leads back to itself is told once for each, however long its circle is."""

from __future__ import annotations

import pytest
from support.linting import document

from kinlint.engine.lifting import lift
from kinlint.engine.store import Store
from kinlint.facts.computation import facts


def back(*texts: tuple[str, str]) -> dict[str, str]:
    """The names of what leads back to itself, each with that of the first on the circle."""
    store = Store()
    store.load([document(text, name) for name, text in texts])
    lift(store)
    return {
        s.rpartition("/")[2][:-1]: o.rpartition("/")[2][:-1]
        for s, p, o in facts(store)
        if p.endswith("#leads-back-to>")
    }


def joint(name: str, leader: str = "") -> str:
    mimic = f'<mimic joint="{leader}"/>' if leader else ""
    return f'<joint name="{name}" type="continuous">{mimic}</joint>'


def test_joints_that_follow_each_other() -> None:
    joints = joint("d", "b"), joint("b", "c"), joint("c", "a"), joint("a", "b"), joint("free")
    robot = f'<robot name="r">{"".join(joints)}{joint("own", "own")}</robot>'
    assert back(("r.urdf", robot)) == {"a": "a", "b": "a", "c": "a", "own": "own"}


def test_groups_that_are_parts_of_each_other() -> None:
    groups = {"a": "b", "b": "c", "c": "b", "d": "e", "e": "f"}
    text = "".join(f'<group name="{k}"><group name="{v}"/></group>' for k, v in groups.items())
    assert back(("r.srdf", f'<robot name="r">{text}</robot>')) == {"b": "b", "c": "b"}


@pytest.mark.slow
def test_a_long_circle_is_found_without_walking_it_for_each() -> None:
    count = 3_000
    joints = "".join(joint(f"j{i}", f"j{(i + 1) % count}") for i in range(count))
    found = back(("r.urdf", f'<robot name="r">{joints}</robot>'))
    assert len(found) == count
    assert set(found.values()) == {"j0"}
