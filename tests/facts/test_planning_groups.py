"""What planning groups comprise, and what lies between links, by the tree of the URDF."""

import pytest

from kinlint.engine.lifting import lift
from kinlint.engine.store import Store
from kinlint.facts.computation import facts
from kinlint.facts.dangling_references import nearest
from kinlint.formats.dependencies.joined_documents import join_companions
from kinlint.formats.options import ReadOptions
from kinlint.formats.registry import read
from kinlint.text import SourceText
from kinlint.vocabulary import FACT

SOLID = "<collision><geometry><sphere radius='1'/></geometry></collision>"


def link(name, shape=SOLID):
    return f'<link name="{name}">{shape}</link>'


def joint(name, parent, child, kind="continuous"):
    ends = f'<parent link="{parent}"/><child link="{child}"/>'
    return f'<joint name="{name}" type="{kind}">{ends}</joint>'


ROBOT = f"""<robot name="arm">
  {link("base")}{link("flange", "")}{link("arm")}{link("hand")}
  {link("left")}{link("right")}{link("apart")}
  {joint("fix", "base", "flange", "fixed")}{joint("turn", "flange", "arm")}
  {joint("wrist", "arm", "hand")}{joint("l", "hand", "left")}{joint("r", "hand", "right")}
</robot>"""


def computed(body):
    """The facts about elements of an SRDF with this *body*: subject, property, value."""
    texts = (f'<robot name="arm">{body}</robot>', ROBOT)
    sources = [
        SourceText(f"a.{form}", text) for form, text in zip(("srdf", "urdf"), texts, strict=True)
    ]
    documents = join_companions([read(each, ReadOptions()) for each in sources])
    store = Store()
    store.load(documents)
    lift(store)
    return {
        (local(s), p.removeprefix(f"<{FACT}")[:-1], local(o))
        for s, p, o in facts(store)
        if "a.srdf#/" in s
    }


def local(term):
    return term.partition("#/")[2].rstrip(">") or term.split('"')[1]


def comprised(body, group="arm"):
    """The joints that *group* comprises."""
    return {
        o.removeprefix("joint/")
        for s, p, o in computed(body)
        if s == f"group/{group}" and p == "comprises"
    }


def chain(base, tip):
    return f'<chain base_link="{base}" tip_link="{tip}"/>'


@pytest.mark.parametrize(
    ("members", "joints"),
    [
        ('<joint name="wrist"/>', {"wrist"}),
        ('<link name="hand"/>', {"wrist"}),
        ('<link name="base"/>', {"virtual_joint/floor"}),
        (chain("base", "hand"), {"fix", "turn", "wrist"}),
        (chain("hand", "base"), {"fix", "turn", "wrist"}),
        (chain("left", "right"), {"l", "r"}),
        (chain("base", "base"), set()),
        (chain("base", "apart"), set()),
        (chain("base", "nothing"), set()),
        ('<group name="fingers"/><joint name="turn"/>', {"l", "r", "turn"}),
        ('<group name="arm"/><joint name="turn"/>', {"turn"}),
    ],
)
def test_what_a_group_comprises(members, joints):
    """Joints as listed, those that carry listed links, those on a chain, those of subgroups."""
    floor = '<virtual_joint name="floor" type="fixed" parent_frame="w" child_link="base"/>'
    fingers = '<group name="fingers"><joint name="l"/><joint name="r"/></group>'
    assert comprised(f'{floor}{fingers}<group name="arm">{members}</group>') == joints


@pytest.mark.parametrize(
    ("base", "tip", "count"),
    [("base", "hand", "3"), ("left", "right", "2"), ("base", "base", "0"), ("base", "apart", None)],
)
def test_how_long_a_chain_is(base, tip, count):
    """There is no length where there is no way."""
    found = computed(f'<group name="arm">{chain(base, tip)}</group>')
    assert {o for _, p, o in found if p == "joints"} == ({count} if count else set())


@pytest.mark.parametrize(
    ("one", "other", "between"),
    [
        ("base", "arm", set()),
        ("base", "hand", {"link/arm"}),
        ("left", "right", {"link/hand"}),
        ("hand", "hand", set()),
        ("base", "apart", set()),
    ],
)
def test_what_lies_between_two_links(one, other, between):
    """Links that can collide part two links, others do not."""
    pair = f'<disable_collisions link1="{one}" link2="{other}" reason="Adjacent"/>'
    assert {o for _, p, o in computed(pair) if p == "between"} == between


@pytest.mark.slow
def test_groups_in_a_circle_come_to_an_end():
    """However long the circle."""
    count = 3000
    body = "".join(
        f'<group name="g{i}"><group name="g{(i + 1) % count}"/></group>' for i in range(count)
    )
    assert comprised(f'{body}<group name="arm"><joint name="l"/></group>') == {"l"}


@pytest.mark.parametrize(
    ("name", "known", "expected"),
    [
        ("hnad", ["hand", "band", "arm"], "hand"),
        ("Hand", ["hand"], "hand"),
        ("link_7", ["link_6", "link_8"], None),
        ("lnk_7", ["link_6", "link_7"], "link_7"),
        ("wrist", ["elbow"], None),
        ("a", ["b"], None),
        ("", ["a"], None),
        ("hand", [], None),
    ],
)
def test_what_a_slip_is_for(name, known, expected):
    """One or two letters off, and never a sibling with another number."""
    assert nearest(name, known) == expected
