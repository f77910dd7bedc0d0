"""Serial chains of any length as URDF, without a fault."""

from __future__ import annotations

from collections.abc import Iterator


def urdf_chain(joints: int) -> str:
    """The text of a chain of *joints* revolute joints between *joints* + 1 links."""
    lines = ['<?xml version="1.0"?>', '<robot name="arm">', *_links(joints), *_joints(joints)]
    return "\n".join([*lines, "</robot>", ""])


def _links(joints: int) -> Iterator[str]:
    yield '  <link name="base"/>'
    for number in range(1, joints + 1):
        mass = 2.0 - number / (2 * joints)
        shape = '<box size="0.1 0.12 0.2"/>'
        inertia = f'ixx="{0.00453333 * mass:.6f}" iyy="{0.00416667 * mass:.6f}"'
        yield f'  <link name="link{number}">'
        yield "    <inertial>"
        yield '      <origin xyz="0 0 0.1" rpy="0 0 0"/>'
        yield f'      <mass value="{mass:.4f}"/>'
        yield f'      <inertia {inertia} izz="{0.00203333 * mass:.6f}" ixy="0" ixz="0" iyz="0"/>'
        yield "    </inertial>"
        for part in ("visual", "collision"):
            yield f'    <{part} name="link{number}-{part}">'
            yield '      <origin xyz="0 0 0.1" rpy="0 0 0"/>'
            yield f"      <geometry>{shape}</geometry>"
            yield f"    </{part}>"
        yield "  </link>"


def _joints(joints: int) -> Iterator[str]:
    for number in range(1, joints + 1):
        parent = f"link{number - 1}" if number > 1 else "base"
        effort = 80.0 - 30 * number / joints
        yield f'  <joint name="joint{number}" type="revolute">'
        yield f'    <origin xyz="0 0 {0.2 if number > 1 else 0.05}" rpy="0 0 0"/>'
        yield f'    <parent link="{parent}"/>'
        yield f'    <child link="link{number}"/>'
        yield f'    <axis xyz="{"0 0 1" if number % 2 else "0 1 0"}"/>'
        yield f'    <limit lower="-2.5" upper="2.5" effort="{effort:.2f}" velocity="3.1"/>'
        yield "  </joint>"
