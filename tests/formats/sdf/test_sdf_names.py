"""Names in SDF stand for what the scope says, and what they do not stand for is stated."""

import pytest
from reading_sdf import document, gaps, losses, model, paths, said

BODIES = '<link name="base"/><link name="tip"/>'


VISUAL = (
    '<link name="l"><visual name="v"><pose relative_to="nowhere">0 0 0 0 0 0</pose></visual></link>'
)
INERTIAL = VISUAL.replace('visual name="v"', "inertial").replace("visual", "inertial")
CIRCLE = """<frame name="f" attached_to="g"/><frame name="g" attached_to="h"/>
    <frame name="h" attached_to="f"/><frame name="i" attached_to="f"/>"""
POSES = """<link name="l"><pose relative_to="f"/></link>
    <frame name="f"><pose relative_to="l"/></frame>"""


def joint(parent, child, rest=""):
    ends = f"<parent>{parent}</parent><child>{child}</child>"
    return f'<joint name="j" type="fixed">{ends}{rest}</joint>'


@pytest.mark.parametrize(
    ("name", "body"),
    [
        ("tip", "/model/arm/link/tip"),
        ("flange", "/model/arm/link/tip"),
        ("chained", "/model/arm/link/tip"),
        ("hand", "/model/arm/model/hand/link/palm"),
        ("hand::palm", "/model/arm/model/hand/link/palm"),
        ("hand::grip", "/model/arm/model/hand/link/palm"),
        ("hand::finger::nail", "/model/arm/model/hand/model/finger/link/nail"),
        ("other", "/model/arm/link/tip"),
    ],
)
def test_a_joint_joins_the_link_that_a_frame_is_attached_to(name, body):
    """Links, frames, models, joints, and what is in models, all stand for a link in the end."""
    read = model(
        BODIES
        + """<frame name="flange" attached_to="tip"/><frame name="chained" attached_to="flange"/>
        <model name="hand"><link name="palm"/><frame name="grip" attached_to="palm"/>
        <model name="finger"><link name="nail"/></model></model>
        <joint name="other" type="fixed"><parent>base</parent><child>tip</child></joint>"""
        + joint("base", name)
    )
    assert paths(read, said(read, "/model/arm/joint/j", "childBody")) == [body]
    assert gaps(read) == []


def test_the_model_itself_is_attached_to_its_canonical_link():
    first = model(BODIES + joint("tip", "__model__"))
    named = model(BODIES + joint("base", "__model__"), attributes=' canonical_link="tip"')
    nested = model('<model name="hand"><link name="palm"/></model>' + joint("world", "__model__"))
    assert paths(first, said(first, "/model/arm", "attachedTo")) == ["/model/arm/link/base"]
    assert paths(named, said(named, "/model/arm/joint/j", "childBody")) == ["/model/arm/link/tip"]
    assert paths(nested, said(nested, "/model/arm", "attachedTo")) == [
        "/model/arm/model/hand/link/palm"
    ]


def test_the_world_is_a_parent_whether_the_file_has_one_or_not():
    alone = model(BODIES + joint("world", "base"))
    within = document(
        f'<sdf version="1.9"><world name="w"><model name="arm">{BODIES}{joint("world", "base")}'
        "</model></world></sdf>"
    )
    assert paths(alone, said(alone, "/model/arm/joint/j", "parentBody")) == ["/world"]
    assert paths(within, said(within, "/world/w/model/arm/joint/j", "parentBody")) == ["/world/w"]


def test_a_name_of_an_older_version_may_have_the_delimiter_in_it():
    read = model('<link name="a::b"/><link name="c"/>' + joint("c", "a::b"), "1.6")
    assert paths(read, said(read, "/model/arm/joint/j", "childBody")) == [
        "/model/arm/link/a%3A%3Ab"
    ]


@pytest.mark.parametrize(
    ("text", "role", "written", "resembles"),
    [
        (joint("base", "tipp"), "child", "tipp", "tip"),
        (joint("nowhere", "tip"), "parent", "nowhere", None),
        ('<frame name="f" attached_to="tipp"/>', "attached_to", "tipp", "tip"),
        ('<frame name="f"><pose relative_to="nowhere"/></frame>', "relative_to", "nowhere", None),
        (
            joint("base", "tip", '<axis><xyz expressed_in="nowhere">1 0 0</xyz></axis>'),
            "expressed_in",
            "nowhere",
            None,
        ),
        (joint("base", "tip", '<axis><mimic joint="k"/></axis>'), "joint", "k", None),
        (VISUAL, "relative_to", "nowhere", None),
        (INERTIAL, "relative_to", "nowhere", None),
        ('<frame name="f"><pose frame="tipp"/></frame>', "frame", "tipp", "tip"),
    ],
)
def test_a_name_that_stands_for_nothing_is_stated_where_it_is_written(
    text, role, written, resembles
):
    (loss,) = gaps(model(BODIES + text))
    assert (loss["role"], loss["written"], loss["text"]) == (role, written, written)
    assert loss.get("resembles") == resembles


def test_a_name_is_not_looked_for_outside_of_its_model():
    read = model(
        BODIES + '<model name="hand"><link name="palm"/>' + joint("tip", "palm") + "</model>"
    )
    assert [loss["written"] for loss in gaps(read)] == ["tip"]


def test_a_pose_that_an_include_replaces_names_nothing(tmp_path):
    """The frame that an include places is in its model, and that of its pose is beside it."""
    hand = '<model name="hand"><pose relative_to="gone"/><link name="palm"/></model>'
    (tmp_path / "hand.sdf").write_text(f'<sdf version="1.9">{hand}</sdf>', "utf-8")
    include = "<include><uri>{}</uri><pose{}/><placement_frame>{}</placement_frame></include>"

    def missing(attributes, frame):
        text = include.format("hand.sdf", attributes, frame)
        body = f'<sdf version="1.9"><model name="arm">{BODIES}{text}</model></sdf>'
        return [gap["written"] for gap in gaps(document(body, str(tmp_path / "arm.sdf")))]

    assert missing("", "palm") == []
    assert missing(' relative_to="tip"', "tip") == ["tip"]
    assert missing(' relative_to="palm"', "palm") == ["palm"]


def test_names_in_a_file_that_is_not_read_are_taken_on_trust():
    """What could be in there is neither found nor missed; what could not is missed."""
    include = "<include><uri>https://example.org/hand</uri>{}</include>"
    named = model(BODIES + include.format("<name>hand</name>") + joint("base", "hand::palm"))
    unnamed = model(BODIES + include.format("") + joint("base", "anything::palm"))
    other = model(BODIES + include.format("<name>hand</name>") + joint("base", "arm2::palm"))
    assert gaps(named) == gaps(unnamed) == []
    assert len(gaps(other)) == 1


@pytest.mark.parametrize(
    ("text", "role", "first", "others"),
    [
        ('<frame name="f" attached_to="f"/>', "attached_to", "f", 0),
        (
            CIRCLE,
            "attached_to",
            "g",
            2,
        ),
        ('<link name="l"><pose relative_to="l"/></link>', "relative_to", "l", 0),
        (
            POSES,
            "relative_to",
            "f",
            1,
        ),
        (joint("base", "j"), "child", "j", 0),
    ],
)
def test_references_in_a_circle_are_stated_once(text, role, first, others):
    read = model(BODIES + text)
    (loss,) = losses(read, "CircularReference")
    assert (loss["role"], loss["written"]) == (role, first)
    assert sum(p.endswith("#member>") for _, p, _ in read.statements) == others


def test_a_long_chain_of_frames_is_followed_to_its_end():
    """No recursion, and each frame once."""
    frames = "".join(f'<frame name="f{i + 1}" attached_to="f{i}"/>' for i in range(3000))
    read = model(BODIES + '<frame name="f0" attached_to="tip"/>' + frames)
    assert paths(read, said(read, "/model/arm/frame/f3000", "attachedTo")) == [
        "/model/arm/link/tip"
    ]


def test_states_of_a_world_have_no_scope():
    read = document(
        '<sdf version="1.9"><world name="w"><model name="arm"><link name="base"/></model>'
        '<state world_name="w"><model name="arm"><link name="base"/></model></state></world></sdf>'
    )
    assert said(read, "/world/w/model/arm/link/base", "scope")
    assert not said(read, "/world/w/state/model/arm/link/base", "scope")


def test_what_stands_beside_the_first_model_is_stated():
    read = document(
        '<sdf version="1.9"><model name="a"><link name="l"/></model>'
        '<light name="b" type="point"/></sdf>'
    )
    assert paths(read, said(read, "/light/b", "leftOutFor")) == ["/model/a"]


def test_the_names_of_an_actor_are_its_own() -> None:
    """Its links are in no scope, and neither are those of a recorded state."""
    man = (
        '<actor name="man"><link name="arm"/><link name="hand"/><joint name="wrist" type="fixed">'
        "<parent>arm</parent><child>hand</child></joint></actor>"
    )
    recorded = document(f'<sdf version="1.9"><world name="lab">{man}</world></sdf>')
    assert not [triple for triple in recorded.statements if triple[1].endswith("#dangling>")]
