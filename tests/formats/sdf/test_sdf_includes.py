"""Included files are read as if they were written where they are included, and stay themselves."""

import os

import pytest
from reading_sdf import file, gaps, losses, numbers, paths, said

from kinlint.formats.options import ReadOptions
from kinlint.formats.sdf import reader
from kinlint.missing_files import references
from kinlint.terms import iri, is_literal, literal_value
from kinlint.vocabulary import SRC

MISSING = iri(f"{SRC}MissingFile")
HAND = """<sdf version="1.9">
  <model name="hand">
    <pose>0 0 1 0 0 0</pose>
    <link name="palm"><pose>0 1 0 0 0 0</pose></link>
    <frame name="mount" attached_to="palm"/>
    <joint name="clamp" type="fixed"><parent>palm</parent><child>nowhere</child></joint>
  </model>
</sdf>"""
ARM = '<sdf version="1.9"><model name="arm"><link name="base"/>{}{}</model></sdf>'
JOINT = '<joint name="j" type="fixed"><parent>base</parent><child>{}</child></joint>'


@pytest.fixture
def folder(tmp_path):
    (tmp_path / "hand").mkdir()
    (tmp_path / "hand" / "model.sdf").write_text(HAND)
    return tmp_path


def arm(folder, include, child):
    (folder / "arm.sdf").write_text(ARM.format(include, JOINT.format(child)))
    return file(folder / "arm.sdf")


def test_names_reach_into_the_included_model(folder):
    read = arm(folder, "<include><uri>hand</uri></include>", "hand::palm")
    (body,) = paths(read, said(read, "/model/arm/joint/j", "childBody"))
    assert body == "/model/arm/include/sdf/model/hand/link/palm"
    assert numbers(read, "/model/arm/joint/j", "parent-", "x", "y", "z") == [0, 1, 1]


@pytest.mark.parametrize(
    ("more", "child", "at"),
    [
        ("<name>tool</name>", "tool::palm", [0, 1, 1]),
        ("<name>tool</name><pose>0 0 5 0 0 0</pose>", "tool::palm", [0, 1, 5]),
        ("<pose>0 0 5 0 0 0</pose><placement_frame>mount</placement_frame>", "hand", [0, 0, 5]),
    ],
)
def test_an_include_may_name_and_place_what_it_includes(folder, more, child, at):
    read = arm(folder, f"<include><uri>hand/</uri>{more}</include>", child)
    where = numbers(read, "/model/arm/joint/j", "parent-", "x", "y", "z")
    if child == "hand":
        assert where == [0, -1, 5]
    else:
        assert where == at


def test_a_merged_model_gives_its_names_to_the_model_that_includes_it(folder):
    read = arm(folder, '<include merge="true"><uri>hand</uri></include>', "palm")
    (body,) = paths(read, said(read, "/model/arm/joint/j", "childBody"))
    assert body.endswith("/link/palm")
    assert numbers(read, "/model/arm/joint/j", "parent-", "z") == [1]


def test_a_file_that_is_included_twice_is_two_models(folder):
    twice = "<include><uri>hand</uri><name>{}</name></include>"
    read = arm(folder, twice.format("a") + twice.format("b"), "b::palm")
    (body,) = paths(read, said(read, "/model/arm/joint/j", "childBody"))
    assert body == "/model/arm/include;2/sdf/model/hand/link/palm"
    found = gaps(read)
    assert [loss["text"] for loss in found] == ["nowhere", "nowhere"]
    assert len({loss["node"] for loss in found}) == 2
    assert all(loss["file"].endswith("model.sdf") for loss in found)


def test_every_literal_is_where_its_place_says(folder):
    """In the included file as in the one that includes it."""
    twice = "<include><uri>hand</uri><name>{}</name></include>"
    read = arm(folder, twice.format("a") + twice.format("b"), "b::palm")
    checked = {source.name: 0 for source in read.sources}
    for triple in read.statements:
        if not is_literal(triple[2]) or "attribute#" not in triple[1]:
            continue
        place = read.location(read.map.triples[triple])
        assert place.source[place.span] == literal_value(triple[2])
        checked[place.source.name] += 1
    assert min(checked.values()) > 0


def test_every_node_has_a_place(folder):
    read = arm(folder, "<include><uri>hand</uri></include>", "hand::palm")
    for node in read.map.nodes:
        assert read.location(read.map.nodes[node].best).span.end >= 0
    for triple in read.statements:
        assert read.map.triples[triple].start >= 0


def test_files_include_files(folder):
    (folder / "cell.sdf").write_text(
        '<sdf version="1.9"><world name="w"><include><uri>arm.sdf</uri></include></world></sdf>'
    )
    arm(folder, "<include><uri>hand</uri></include>", "hand::palm")
    read = file(folder / "cell.sdf")
    assert [source.name.rpartition("/")[2] for source in read.sources] == [
        "cell.sdf",
        "arm.sdf",
        "model.sdf",
    ]
    inner = "/world/w/include/sdf/model/arm"
    assert paths(read, said(read, f"{inner}/joint/j", "childBody")) == [
        f"{inner}/include/sdf/model/hand/link/palm"
    ]


@pytest.mark.parametrize("uri", ["arm.sdf", "./hand/../arm.sdf"])
def test_a_file_that_includes_itself_is_stated_and_ends(folder, uri):
    read = arm(folder, f"<include><uri>{uri}</uri></include>", "base")
    (loss,) = losses(read, "CircularInclude")
    assert loss["text"] == uri


def test_files_that_include_each_other_are_stated_and_end(folder):
    (folder / "hand" / "model.sdf").write_text(
        '<sdf version="1.9"><model name="hand">'
        "<include><uri>../arm.sdf</uri></include></model></sdf>"
    )
    read = arm(folder, "<include><uri>hand</uri></include>", "base")
    (loss,) = losses(read, "CircularInclude")
    assert loss["file"].endswith("model.sdf")


@pytest.mark.slow
def test_files_that_include_others_many_times_over_end(folder):
    """Each of twenty includes the next one twice."""
    for i in range(20):
        below = f"<include><uri>f{i + 1}.sdf</uri></include>" * 2
        (folder / f"f{i}.sdf").write_text(
            f'<sdf version="1.9"><model name="m"><link name="l"/>{below}</model></sdf>'
        )
    read = file(folder / "f0.sdf")
    assert "too many" in losses(read, "UnresolvedInclude")[0]["reason"]


@pytest.mark.parametrize(
    ("uri", "reason"),
    [
        ("https://example.org/hand", "network"),
        ("nowhere", "no such file"),
        ("model://nowhere-at-all", "no such file"),
        ("empty", "model.config"),
        ("notes.sdf", "is not SDF"),
        ("broken.sdf", "cannot be read"),
    ],
)
def test_what_is_not_read_is_stated_with_the_reason(folder, uri, reason):
    (folder / "empty").mkdir()
    (folder / "notes.sdf").write_text("<robot/>")
    (folder / "broken.sdf").write_bytes(b"\xff\xfe\x00\xd8")
    read = arm(folder, f"<include><uri>{uri}</uri></include>", "base")
    (loss,) = losses(read, "UnresolvedInclude")
    assert loss["text"] == uri
    assert reason in loss["reason"]


def test_models_are_found_where_the_environment_says(folder, monkeypatch):
    models = folder / "models"
    (models / "grip").mkdir(parents=True)
    (models / "grip" / "model.config").write_text(
        '<model><!-- <sdf version="1.9">no.sdf</sdf> --><sdf version="1.4">old.sdf</sdf>'
        '<sdf version="1.9">new.sdf</sdf><sdf version="9.9">later.sdf</sdf></model>'
    )
    (models / "grip" / "new.sdf").write_text(HAND)
    monkeypatch.setenv("GZ_SIM_RESOURCE_PATH", str(models))
    for uri in ("model://grip", "grip"):
        read = arm(folder, f"<include><uri>{uri}</uri></include>", "hand::palm")
        assert read.sources[1].name.endswith("new.sdf")


def test_a_manifest_may_name_a_file_that_is_not_there(folder):
    (folder / "hand" / "model.config").write_text('<model><sdf version="1.9">x.sdf</sdf></model>')
    read = arm(folder, "<include><uri>hand</uri></include>", "base")
    assert "x.sdf" in losses(read, "UnresolvedInclude")[0]["reason"]


@pytest.mark.parametrize("uri", ["/dev/zero", "file:///dev/zero", "pipe", "/dev/stdin"])
def test_what_never_ends_is_not_included(folder, uri):
    os.mkfifo(folder / "pipe")
    (folder / "arm.sdf").write_text(ARM.format(f"<include><uri>{uri}</uri></include>", ""))
    (loss,) = losses(file(folder / "arm.sdf"), "UnresolvedInclude")
    assert loss["written"] == uri
    refused = "is outside of the project" if "/dev" in uri else "is not a file"
    assert refused in loss["reason"]


def test_what_is_included_is_bounded_in_all(folder, monkeypatch):
    monkeypatch.setattr(reader, "MOST_STATED", 20)
    names = "".join(f"<include><name>n{i}</name><uri>hand</uri></include>" for i in range(4))
    (folder / "arm.sdf").write_text(ARM.format(names, ""))
    found = losses(file(folder / "arm.sdf"), "UnresolvedInclude")
    assert [each["reason"] for each in found] == ["the included files are too large"] * 3


def test_the_files_of_an_included_model_are_beside_it(folder):
    """A path is meant from the file in which it stands, whoever includes that."""
    mesh = "<visual name='{0}'><geometry><mesh><uri>{0}.dae</uri></mesh></geometry></visual>"
    links = f"<link name='palm'>{mesh.format('here')}{mesh.format('gone')}</link>"
    hand = folder / "hand"
    (hand / "model.sdf").write_text(f"<sdf version='1.9'><model name='hand'>{links}</model></sdf>")
    (hand / "here.dae").touch()
    (hand / "other.dae").touch()
    (folder / "gone.dae").touch()
    text = "<sdf version='1.9'><world name='lab'><include><uri>hand</uri></include></world></sdf>"
    (folder / "lab.sdf").write_text(text)
    lab = file(folder / "lab.sdf")
    packages = ReadOptions().packages_of
    missing = [s for s, _, o in references([lab], packages) if o == MISSING]
    assert len(missing) == 1
    assert "/gone/" in missing[0]
