"""A feature of URDF is found in files of versions that do not have it, and in no others."""

import pytest
from support.linting import codes

FEATURES = {
    "capsule": ("SRC008", "1.1", '<collision><geometry><capsule radius="0.1" length="0.3"/>'),
    "quaternion": (
        "SRC008",
        "1.1",
        '<collision><origin quat_xyzw="1 0 0 0"/><geometry><box size="1 1 1"/>',
    ),
}
LIMITS = {
    "jerk": ("SRC008", "1.2", 'lower="-1" upper="1" effort="5" velocity="1" jerk="9"'),
    "acceleration": (
        "SRC008",
        "1.2",
        'lower="-1" upper="1" effort="5" velocity="1" acceleration="9"',
    ),
    "no effort": ("LIM005", "1.2", 'lower="-1" upper="1" velocity="1"'),
    "no velocity": ("LIM005", "1.2", 'lower="-1" upper="1" effort="5"'),
}
VERSIONS = ["", "1.0", "1.1", "1.2"]


def robot(version, name):
    """A robot of *version* that uses the feature called *name*."""
    shape = FEATURES[name][2] + "</geometry></collision>" if name in FEATURES else ""
    limit = LIMITS[name][2] if name in LIMITS else 'lower="-1" upper="1" effort="5" velocity="1"'
    said = f' version="{version}"' if version else ""
    return f"""<robot name="arm"{said}>
      <link name="base">{shape}</link>
      <link name="tip"/>
      <joint name="elbow" type="revolute">
        <parent link="base"/>
        <child link="tip"/>
        <axis xyz="0 0 1"/>
        <limit {limit}/>
      </joint>
    </robot>"""


@pytest.mark.slow
@pytest.mark.parametrize("version", VERSIONS)
@pytest.mark.parametrize("name", [*FEATURES, *LIMITS])
def test_a_feature_is_found_below_the_version_that_brought_it(version, name):
    """No version is 1.0."""
    code, since, _ = {**FEATURES, **LIMITS}[name]

    assert (code in codes(robot(version, name))) == ((version or "1.0") < since)


@pytest.mark.parametrize("version", VERSIONS)
def test_versions_that_readers_take_are_no_finding(version):
    """URDF has had three so far."""
    assert not set(codes(robot(version, None))) & {"SRC008", "SRC009"}
