"""An MJCF or SDF for each plain feature of the two formats: a small arm that has it.

Names and numbers are those of the URDFs, so that the same words tell what became of a feature.
"""

from __future__ import annotations

INERTIAL = '<inertial pos="0 0 0.1" mass="2" diaginertia="0.02 0.02 0.02"/>'
BOX = '<geom type="box" size="0.05 0.05 0.1"/>'
HINGE = 'name="elbow" type="hinge" axis="0 0 1"'


def mjcf(
    *more: str,
    joint: str = f'<joint {HINGE} limited="true" range="-1 2"/>',
    inertial: str = INERTIAL,
    shapes: str = BOX,
    angle: str = ' angle="radian"',
    head: str = "",
) -> str:
    """Return an arm of MJCF: a body that stands, one that moves, and one that turns on that."""
    return f"""<mujoco model="arm">
  <compiler{angle}/>
  {head}
  <worldbody>
    <body name="base">
      {INERTIAL}
      <body name="upper" pos="0 0 1">
        {joint}{inertial}{shapes}
        <body name="tip" pos="0 0 0.5">
          <joint name="wrist" type="hinge" axis="0 1 0" limited="true" range="-1 2"/>{INERTIAL}{BOX}
        </body>
      </body>
    </body>
  </worldbody>
  {"".join(more)}
</mujoco>
"""


def geom(kind: str, size: str) -> str:
    """Return an arm whose link has a geom of this *kind*."""
    return mjcf(shapes=f'<geom type="{kind}" {size}/>')


MJCF = {
    "mjcf": mjcf(),
    "mjcf-hinge": mjcf(),
    "mjcf-slide": mjcf(joint='<joint name="elbow" type="slide" axis="0 0 1" range="-1 2"/>'),
    "mjcf-ball": mjcf(joint='<joint name="elbow" type="ball" axis="0 0 1"/>'),
    "mjcf-free": mjcf().replace('<body name="base">', '<body name="base"><freejoint name="root"/>'),
    "mjcf-two-joints": mjcf(
        joint=f'<joint {HINGE}/><joint name="second" type="hinge" axis="1 0 0"/>'
    ),
    "mjcf-welded-body": mjcf(joint=""),
    "range-without-limited": mjcf(joint=f'<joint {HINGE} range="-0.5 0.5"/>'),
    "mjcf-range": mjcf(joint=f'<joint {HINGE} limited="true" range="-0.5 0.5"/>'),
    "mjcf-range-in-degrees": mjcf(
        angle=' angle="degree"', joint=f'<joint {HINGE} limited="true" range="-57.29578 57.29578"/>'
    ),
    "mjcf-default-class": mjcf(
        head='<default><joint limited="true" range="-0.5 0.5"/></default>',
        joint=f"<joint {HINGE}/>",
    ),
    "mjcf-damping": mjcf(joint=f'<joint {HINGE} range="-1 2" damping="0.7"/>'),
    "mjcf-friction": mjcf(joint=f'<joint {HINGE} range="-1 2" frictionloss="0.3"/>'),
    "mjcf-inertial": mjcf(inertial='<inertial pos="0 0 0" mass="2" diaginertia="0.03 0.04 0.05"/>'),
    "mjcf-turned-inertial": mjcf(
        inertial='<inertial pos="0 0 0" quat="1 0 0 1" mass="2" diaginertia="0.03 0.04 0.05"/>'
    ),
    "mjcf-mass-by-geoms": mjcf(
        inertial="", shapes='<geom type="box" size="0.05 0.05 0.1" mass="2"/>'
    ),
    "mjcf-box": geom("box", 'size="0.05 0.05 0.1"'),
    "mjcf-cylinder": geom("cylinder", 'size="0.05 0.1"'),
    "mjcf-sphere": geom("sphere", 'size="0.05"'),
    "mjcf-capsule": geom("capsule", 'size="0.05 0.1"'),
    "mjcf-ellipsoid": geom("ellipsoid", 'size="0.05 0.06 0.07"'),
    "mjcf-mesh": mjcf(
        head='<asset><mesh name="m" file="tetrahedron.obj"/></asset>',
        shapes='<geom type="mesh" mesh="m"/>',
    ),
    "mjcf-several-geoms": mjcf(shapes=BOX * 2),
    "mjcf-motor": mjcf(
        '<actuator><motor name="m" joint="elbow" ctrlrange="-6 6" forcerange="-6 6"/></actuator>'
    ),
    "mjcf-coupled-joints": mjcf(
        '<equality><joint joint1="wrist" joint2="elbow" polycoef="0 0.5 0 0 0"/></equality>'
    ),
    "mjcf-connect": mjcf('<equality><connect body1="tip" anchor="0 0 1"/></equality>'),
    "mjcf-weld": mjcf('<equality><weld body1="tip" body2="base"/></equality>'),
    "mjcf-several-trees": mjcf().replace(
        "  </worldbody>",
        f'<body name="loose"><joint name="swing" type="hinge"/>{INERTIAL}{BOX}</body></worldbody>',
    ),
}

KILOGRAMS = (
    "<inertial><pose>0 0 0.1 0 0 0</pose><mass>2</mass><inertia><ixx>0.02</ixx><iyy>0.02</iyy>"
    "<izz>0.02</izz><ixy>0</ixy><ixz>0</ixz><iyz>0</iyz></inertia></inertial>"
)
LIMIT = "<limit><lower>-1</lower><upper>2</upper><effort>3</effort><velocity>4</velocity></limit>"


def shape(inner: str, name: str = "shape") -> str:
    """Return a collision called *name* of the geometry *inner*."""
    return f'<collision name="{name}"><geometry>{inner}</geometry></collision>'


SOLID = shape("<box><size>0.1 0.1 0.2</size></box>")


def sdf(  # noqa: PLR0913
    *more: str,
    kind: str = "revolute",
    axis: str = f"<axis><xyz>0 0 1</xyz>{LIMIT}</axis>",
    inertial: str = KILOGRAMS,
    shapes: str = SOLID,
    hold: str = "",
    tip: str = "",
) -> str:
    """Return an arm of SDF: a link that stands, one that moves, and one that turns on that."""
    return f"""<sdf version="1.11">
  <model name="arm">
    <link name="base">{KILOGRAMS}</link>{hold}
    <link name="upper"><pose>0 0 1 0 0 0</pose>{inertial}{shapes}</link>
    <joint name="elbow" type="{kind}"><parent>base</parent><child>upper</child>{axis}</joint>
    <link name="tip"><pose>0 0 1.5 0 0 0</pose>{KILOGRAMS}{SOLID}</link>
    <joint name="wrist" type="revolute"><parent>upper</parent><child>tip</child>
      <axis><xyz>0 1 0</xyz>{tip}{LIMIT}</axis></joint>
    {"".join(more)}
  </model>
</sdf>
"""


def around(inner: str) -> str:
    """Return an axis along z with *inner*."""
    return f"<axis><xyz>0 0 1</xyz>{inner}</axis>"


def bounds(lower: float, upper: float, more: str = "") -> str:
    """Return an axis along z with limits."""
    return around(f"<limit><lower>{lower}</lower><upper>{upper}</upper>{more}</limit>")


def dynamics(inner: str) -> str:
    """Return an arm whose joint has *inner* as dynamics."""
    return sdf(axis=around(f"{LIMIT}<dynamics>{inner}</dynamics>"))


MOMENTS = "<mass>2</mass><inertia><ixx>0.03</ixx><iyy>0.04</iyy><izz>0.05</izz></inertia>"

SDF = {
    "sdf": sdf(),
    "sdf-revolute-joint": sdf(),
    "sdf-prismatic-joint": sdf(kind="prismatic"),
    "sdf-continuous-joint": sdf(kind="continuous", axis=around("")),
    "sdf-ball-joint": sdf(kind="ball", axis=""),
    "sdf-universal-joint": sdf(
        kind="universal", axis="<axis><xyz>1 0 0</xyz></axis><axis2><xyz>0 1 0</xyz></axis2>"
    ),
    "sdf-screw-joint": sdf(
        kind="screw", axis=f"{around('')}<screw_thread_pitch>0.1</screw_thread_pitch>"
    ),
    "sdf-fixed-joint": sdf(kind="fixed", axis=""),
    "sdf-joint-to-world": sdf(
        hold='<joint name="hold" type="fixed"><parent>world</parent><child>base</child></joint>'
    ),
    "sdf-static-with-joints": sdf("<static>true</static>"),
    "sdf-position-limits": sdf(axis=bounds(-0.5, 0.5)),
    "sdf-effort-limit": sdf(axis=bounds(-1, 2, "<effort>6</effort>")),
    "sdf-velocity-limit": sdf(axis=bounds(-1, 2, "<velocity>5</velocity>")),
    "sdf-damping": dynamics("<damping>0.7</damping>"),
    "sdf-friction": dynamics("<friction>0.3</friction>"),
    "sdf-inertia": sdf(inertial=f"<inertial>{MOMENTS}</inertial>"),
    "sdf-turned-inertial": sdf(
        inertial=f"<inertial><pose>0 0 0 0 0 1.5707963</pose>{MOMENTS}</inertial>"
    ),
    "sdf-link-without-inertial": sdf(inertial=""),
    "sdf-box": sdf(),
    "sdf-cylinder": sdf(
        shapes=shape("<cylinder><radius>0.05</radius><length>0.2</length></cylinder>")
    ),
    "sdf-sphere": sdf(shapes=shape("<sphere><radius>0.05</radius></sphere>")),
    "sdf-capsule": sdf(
        shapes=shape("<capsule><radius>0.05</radius><length>0.2</length></capsule>")
    ),
    "sdf-ellipsoid": sdf(shapes=shape("<ellipsoid><radii>0.05 0.06 0.07</radii></ellipsoid>")),
    "sdf-obj-mesh": sdf(shapes=shape("<mesh><uri>tetrahedron.obj</uri></mesh>")),
    "sdf-stl-mesh": sdf(shapes=shape("<mesh><uri>tetrahedron.stl</uri></mesh>")),
    "sdf-several-collisions": sdf(
        shapes=SOLID + shape("<sphere><radius>0.05</radius></sphere>", "other")
    ),
    "sdf-mimic": sdf(tip='<mimic joint="elbow"><multiplier>0.5</multiplier></mimic>'),
    "sdf-pose-relative-to": sdf().replace(
        "<pose>0 0 1.5 0 0 0</pose>", '<pose relative_to="upper">0 0 0.5 0 0 0</pose>'
    ),
}
