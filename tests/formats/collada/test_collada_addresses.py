"""What addresses in COLLADA lead to: URIs, paths of scoped identifiers, and parameters."""

from __future__ import annotations

import pytest
from reading_collada import model, read

from kinlint.document import Document
from kinlint.formats.collada.addressing import Addressing, Missing
from kinlint.formats.collada.collada_elements import ColladaElement, tree
from kinlint.terms import literal_value

JOINT = (
    '<joint id="elbow_id" sid="elbow" name="elbow"><revolute sid="axis0"><axis>0 1 0</axis>'
    "</revolute></joint>"
)
LINKS = '<link sid="base"><attachment_full joint="{}"><link sid="tip"/></attachment_full></link>'


def ends(read_: Document, name: str) -> list[str]:
    """Return the tags of what the references *name* lead to, or the step that is not found."""
    found = []
    for _, predicate, value in read_.statements:
        if predicate.endswith(f"/reference#{name}>"):
            found.append(value[1:-1].rsplit("/", 1)[-1].partition(";")[0])
        elif predicate.endswith("/source#step>"):
            found.append(f"no {literal_value(value)}")
    return found


@pytest.mark.parametrize(
    ("path", "end"),
    [
        ("arm/elbow_inst", "instance_joint"),
        ("elbow_inst", "instance_joint"),
        ("elbow_id", "elbow"),
        ("arm/elbw", "no elbw"),
        ("leg/elbow_inst", "no leg"),
        ("../elbow_inst", "no .."),
    ],
)
def test_a_joint_is_found_by_its_path(path: str, end: str) -> None:
    """Old files have its sid alone."""
    inside = '<instance_joint url="#elbow_id" sid="elbow_inst"/>', LINKS.format(path)
    assert ends(read(model(*inside, joints=JOINT)), "joint") == [end]


def bound(path: str) -> Document:
    """Return a document in which an axis_info has the *path* of an axis."""
    system = (
        '<library_articulated_systems><articulated_system id="system"><kinematics>'
        '<instance_kinematics_model url="#arm" sid="arm_inst">'
        '<newparam sid="a.b"><SIDREF>system/arm_inst/elbow_inst/axis0</SIDREF></newparam>'
        "</instance_kinematics_model><technique_common>"
        f'<axis_info axis="{path}" sid="info"/>'
        "</technique_common></kinematics></articulated_system></library_articulated_systems>"
    )
    inside = '<instance_joint url="#elbow_id" sid="elbow_inst"/>', LINKS.format("arm/elbow_inst")
    return read(model(*inside, joints=JOINT), system)


@pytest.mark.parametrize(
    ("path", "end"),
    [
        ("arm/elbow_inst/axis0", "revolute"),
        ("system/arm_inst/elbow_inst/axis0", "revolute"),
        ("system/elbow_inst/axis0", "revolute"),
        ("system/a.b", "newparam"),
        ("arm/elbow_inst/axis0.ANGLE", "revolute"),
        ("arm/elbow_inst/axis0(0)", "revolute"),
        ("arm/elbow_inst/axis0.limit", "no axis0.limit"),
        ("arm/elbow_inst/axis1", "no axis1"),
    ],
)
def test_an_axis_is_found_by_way_of_instances(path: str, end: str) -> None:
    """A sid may have points; after the last one a member of the value may stand."""
    assert ends(bound(path), "axis") == [end]


def unfit(read_: Document) -> list[str]:
    """Return what addresses lead to that cannot stand there."""
    gaps = {o for _, p, o in read_.statements if p.endswith("/source#unfit>")}
    said = (t for t in read_.statements if t[0] in gaps and t[1].endswith("/source#tag>"))
    return [literal_value(o) for _, _, o in said]


@pytest.mark.parametrize(
    ("path", "tags"),
    [("arm/elbow_inst", ["instance_joint"]), ("system/a.b", []), ("arm/elbow_inst/axis0", [])],
)
def test_an_address_of_another_kind_is_stated(path: str, tags: list[str]) -> None:
    """A parameter is what it stands for."""
    assert unfit(bound(path)) == tags


def test_parameters_are_found_outwards_and_in_what_is_instanced() -> None:
    scene = (
        '<library_kinematics_scenes><kinematics_scene id="kscene">'
        '<instance_kinematics_model url="#arm" sid="arm_inst"><newparam sid="model">'
        "<SIDREF>kscene/arm_inst</SIDREF></newparam></instance_kinematics_model>"
        "</kinematics_scene></library_kinematics_scenes><library_visual_scenes>"
        '<visual_scene id="v"><node id="body"/></visual_scene></library_visual_scenes>'
        '<scene><instance_kinematics_scene url="#kscene"><bind_kinematics_model node="body">'
        "<param>{}</param></bind_kinematics_model></instance_kinematics_scene></scene>"
    )
    assert ends(read(model(), scene.format("model")), "param") == ["newparam"]
    assert ends(read(model(), scene.format("mdel")), "param") == ["no mdel"]


def test_uris_of_other_documents_are_not_judged() -> None:
    found = read(model('<instance_joint url="file.dae#elbow" sid="elbow_inst"/>'))
    assert ends(found, "url") == []


def test_an_instance_of_itself_ends() -> None:
    """Nothing is found below it for ever."""
    nodes = (
        '<library_nodes><node id="a"><instance_node url="#b"/></node><node id="b">'
        '<instance_node url="#a"/></node></library_nodes>'
        '<scene><instance_kinematics_scene url="#none"><bind_kinematics_model node="a/c/d"/>'
        "</instance_kinematics_scene></scene>"
    )
    assert ends(read(nodes), "node") == ["no none", "no c"]


@pytest.mark.parametrize(("profile", "found"), [("OpenRAVE", ["no hand"]), ("other", [])])
def test_techniques_of_unknown_profiles_are_opaque(profile: str, found: list[str]) -> None:
    extra = (
        '<library_articulated_systems><articulated_system id="system"><extra type="manipulator">'
        f'<technique profile="{profile}"><frame_tip link="arm/hand"/></technique></extra>'
        "</articulated_system></library_articulated_systems>"
    )
    assert ends(read(model(), extra), "link") == found


def test_numbers_of_meshes_are_not_stated() -> None:
    """However many there are, or elements that hold them."""
    faces = "<p>0 1 2</p>" * 1_000
    mesh = (
        '<library_geometries><geometry id="g"><mesh><source id="s"><float_array id="f" count="9">'
        f"{'1 ' * 10_000}</float_array><technique_common><accessor source='#f'/>"
        f"</technique_common></source><polygons><input source='#s'/>{faces}</polygons></mesh>"
        "</geometry></library_geometries>"
    )
    found = read(mesh)
    assert len(found.statements) < 60
    assert ends(found, "source") == ["float_array", "source"]


@pytest.mark.slow
def test_a_ring_of_instances_is_not_searched_anew_from_each_of_its_nodes() -> None:
    """The last searches take the first element of the document, and find what is there."""
    count = 2000
    nodes = "".join(
        f'<node id="n{each}"><translate sid="s{each}">0 0 0</translate>'
        f'<instance_node url="#n{(each + 1) % count}"/></node>'
        for each in range(count)
    )
    read_ = read(f"<library_nodes>{nodes}</library_nodes>")
    root = tree(read_.graph, read_.statements)
    assert root is not None
    addressing = Addressing(root)
    elements = 1 + sum(1 for _ in root.below())
    found = [addressing.by_path(f"n{each}/s{(each + 1000) % count}", root) for each in range(count)]
    sids = [each.text("sid") if isinstance(each, ColladaElement) else "" for each in found]
    assert sids == [f"s{(each + 1000) % count}" for each in range(count)]
    assert 0 < addressing.searched < 50 * elements


def test_what_no_element_has_is_not_searched_for() -> None:
    read_ = read(model('<link sid="base"/>'))
    root = tree(read_.graph, read_.statements)
    assert root is not None
    addressing = Addressing(root)
    assert isinstance(addressing.by_path("arm/elbow", root), Missing)
    assert addressing.searched == 0
