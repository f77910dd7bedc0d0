"""Settings for MuJoCo in a URDF, held to what MuJoCo makes of them."""

import struct

import pytest
from support.linting import codes

ROBOT = (
    '<robot name="r"><mujoco>{}</mujoco><link name="base"/><link name="arm"><inertial>'
    '<mass value="1"/><inertia ixx="0.01" ixy="0" ixz="0" iyy="0.01" iyz="0" izz="0.01"/>'
    "</inertial></link>"
    '<joint name="j" type="revolute"><parent link="base"/><child link="arm"/><axis xyz="0 0 1"/>'
    '<limit lower="-1" upper="1" effort="1" velocity="1"/></joint></robot>'
)
CORNERS = ((0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1))
FACES = ((0, 2, 1), (0, 1, 3), (0, 3, 2), (1, 2, 3))
TETRAHEDRON = struct.pack("<80xI", len(FACES)) + b"".join(
    struct.pack("<12x9f2x", *(each for corner in face for each in CORNERS[corner]))
    for face in FACES
)
READ = (
    '<compiler discardvisual="false" balanceinertia="true" fusestatic="false" strippath="true"/>',
    '<compiler angle="radian" meshdir="meshes" boundmass="0.1" settotalmass="2"/>',
    '<option timestep="0.01" gravity="0 0 -1"><flag gravity="disable"/></option>',
    '<size nuserdata="3"/>',
)
WRONG = {
    '<compiler discardvisuals="false"/>': ["SRC005"],
    '<compiler fusestatic="yes"/>': ["SRC012"],
    '<option timestep="fast"/>': ["SRC007"],
    "<compiler/><compiler/>": ["SRC006"],
    "<asset/>": ["SRC003"],
    '<compiler angle="degree"/>': ["UNI030"],
}
REFUSED = {'<compiler fusestatic="yes"/>', '<option timestep="fast"/>', "<compiler/><compiler/>"}


@pytest.mark.parametrize("settings", READ)
def test_what_mujoco_reads_is_right(settings):
    assert codes(ROBOT.format(settings), "arm.urdf") == []


@pytest.mark.parametrize(("settings", "expected"), WRONG.items())
def test_what_mujoco_refuses_or_passes_over_is_told(settings, expected):
    assert codes(ROBOT.format(settings), "arm.urdf") == expected


@pytest.mark.external
@pytest.mark.parametrize("settings", [*READ, *WRONG])
def test_mujoco_does_so(settings):
    """It refuses bad values and repeated elements, and reads all angles in radians."""
    mujoco = pytest.importorskip("mujoco", reason="the wheel of MuJoCo is not installed")
    if settings in REFUSED:
        with pytest.raises(ValueError, match=r"invalid keyword|bad format|repeated element"):
            mujoco.MjModel.from_xml_string(ROBOT.format(settings))
        return
    model = mujoco.MjModel.from_xml_string(ROBOT.format(settings))
    assert list(model.jnt_range[0]) == [-1.0, 1.0]
    if "flag" in settings:
        assert model.opt.gravity[2] == -1.0
        assert model.opt.disableflags
    if "settotalmass" in settings:
        assert model.body_mass.sum() == pytest.approx(2.0)


@pytest.mark.parametrize(
    ("settings", "expected"),
    [
        ('strippath="true"', ["POR014"]),
        ('strippath="true" meshdir="meshes"', []),
        ('strippath="true" meshdir="meshes" discardvisual="false"', ["POR014"]),
        ('strippath="true" meshdir="elsewhere"', ["POR014"]),
        ('meshdir="."', []),
    ],
)
def test_meshes_are_where_the_settings_say(tmp_path, settings, expected):
    """Those that are only seen are left out unless `discardvisual` is false."""
    shapes = (
        '<visual><geometry><mesh filename="seen.stl"/></geometry></visual>'
        '<collision><geometry><mesh filename="meshes/solid.stl"/></geometry></collision>'
    )
    robot = ROBOT.format(f"<compiler {settings}/>").replace('<link name="base"/>', (
        f'<link name="base">{shapes}</link>'
    ))  # fmt: skip
    (tmp_path / "meshes").mkdir()
    for name in ("seen.stl", "meshes/solid.stl"):
        (tmp_path / name).write_bytes(TETRAHEDRON)
    path = tmp_path / "arm.urdf"
    path.write_text(robot, "utf-8")
    assert codes(robot, str(path)) == expected
    mujoco = pytest.importorskip("mujoco", reason="the wheel of MuJoCo is not installed")
    if expected:
        with pytest.raises(ValueError, match="Error opening file"):
            mujoco.MjModel.from_xml_path(str(path))
    else:
        assert mujoco.MjModel.from_xml_path(str(path)).nmesh == 1
