"""URDF files that grow in one respect."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from benchmarks.growth.growing import Growing, numbered
from benchmarks.urdf_robot import urdf_chain

SPHERE = '<geometry><sphere radius="1"/></geometry>'
MASS = (
    '<inertial><mass value="-1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/>'
    "</inertial>"
)
TRANSMISSION = (
    '<transmission name="t@"><type>transmission_interface/SimpleTransmission</type>'
    '<joint name="j"/><actuator name="a@"/></transmission>'
)
Text = Callable[[int], str]


def robot(*parts: str) -> str:
    """Return a robot with *parts*."""
    return f'<robot name="r">\n{"".join(parts)}</robot>\n'


def joints(ends: Iterable[tuple[object, object]], kind: str = "revolute") -> str:
    """Return a joint for each pair of a parent's and a child's number."""
    moving = '<axis xyz="0 0 1"/><limit lower="-1" upper="1" effort="1" velocity="1"/>'
    return "".join(
        f'<joint name="j{number}" type="{kind}"><origin xyz="0 0 0.1"/><parent link="l{parent}"/>'
        f'<child link="l{child}"/>{"" if kind == "fixed" else moving}</joint>\n'
        for number, (parent, child) in enumerate(ends)
    )


def jointed(ends: Callable[[int], Iterable[tuple[object, object]]], kind: str = "revolute") -> Text:
    """Return the robot whose joints have the *ends* for their number, and all links of these."""

    def text(count: int) -> str:
        pairs = [*ends(count)]
        known = {end: None for pair in pairs for end in pair if isinstance(end, int)}
        return robot("".join(f'<link name="l{n}"/>\n' for n in known), joints(pairs, kind))

    return text


def repeated(line: str) -> Text:
    """Return the robot with numbered copies of *line*."""
    return lambda count: robot('<link name="l"/>\n', numbered(line, count))


def in_links(part: str) -> Text:
    """Return the chain of fixed links each of which has *part*, numbered."""

    def text(count: int) -> str:
        ends = [(number, number + 1) for number in range(count - 1)]
        return robot(numbered(f'<link name="l@">{part}</link>', count), joints(ends, "fixed"))

    return text


def in_link(part: str) -> Text:
    """Return the robot of one link with numbered copies of *part*."""
    return lambda count: robot('<link name="l">\n', numbered(part, count), "</link>\n")


def mimicking(leader: Callable[[int, int], int | None]) -> Text:
    """Return the chain whose joints follow the *leader* for their number and that of all."""
    chain = jointed(_chain)

    def text(count: int) -> str:
        first, *others = chain(count).split("</joint>")
        told = [first]
        for number, other in enumerate(others):
            leading = leader(number, count)
            told.append("" if leading is None else f'<mimic joint="j{leading}"/>')
            told.append(f"</joint>{other}")
        return "".join(told)

    return text


def flat(text: Text) -> Text:
    """Return *text* on a single line."""
    return lambda count: text(count).replace("\n", " ")


def _chain(count: int) -> list[tuple[int, int]]:
    return [(number, number + 1) for number in range(count)]


def _long_names(count: int) -> str:
    names = [f"{'shoulder_' * 25}{number}" for number in range(count)]
    links = "".join(f'<link name="{name}"/>\n' for name in names)
    ends = "".join(
        f'<joint name="{name}" type="fixed"><parent link="{name}"/>'
        f'<child link="{name}_"/></joint>\n'
        for name in names
    )
    return robot(links, ends)


def _letters(count: int) -> str:
    return robot(
        numbered(f'<link name="{"a" * count}@"/>', 20),
        joints((("", f"{'a' * count}-{number}") for number in range(20)), "fixed"),
    )


INPUTS: tuple[tuple[str, Text, int], ...] = (
    ("chain", urdf_chain, 250),
    ("fixed chain", jointed(_chain, "fixed"), 500),
    ("ring", jointed(lambda n: [*_chain(n), (n, 0)]), 250),
    ("star", jointed(lambda n: ((0, k + 1) for k in range(n))), 250),
    ("sink", jointed(lambda n: ((k + 1, 0) for k in range(n))), 150),
    ("roots", repeated('<link name="k@"/>'), 1000),
    ("links of one name", repeated('<link name="l"/>'), 500),
    (
        "joints of one name",
        lambda n: robot(
            numbered('<link name="l@"/>', n + 1),
            joints(_chain(n)).replace('name="j', 'name="j" about="'),
        ),
        150,
    ),
    ("dangling references", jointed(lambda n: ((0, f"missing{k}") for k in range(n))), 250),
    ("dangling references to one", jointed(lambda n: ((0, "missing") for _ in range(n))), 250),
    (
        "dangling references like names that are there",
        jointed(lambda n: [*_chain(n // 2), *((k, f"{k}_") for k in range(n // 2))]),
        250,
    ),
    ("mimic chain", mimicking(lambda k, _: k - 1 if k else None), 250),
    ("mimic ring", mimicking(lambda k, n: (k + 1) % n), 250),
    ("mimic star", mimicking(lambda k, _: 0 if k else None), 250),
    ("undefined materials", in_links(f'<visual>{SPHERE}<material name="m@"/></visual>'), 250),
    ("one undefined material", in_links(f'<visual>{SPHERE}<material name="m"/></visual>'), 250),
    (
        "definitions of one material",
        repeated('<material name="m"><color rgba="1 1 1 0.@"/></material>'),
        500,
    ),
    (
        "missing meshes",
        in_links('<visual><geometry><mesh filename="m@.stl"/></geometry></visual>'),
        250,
    ),
    ("equal collisions", in_link(f"<collision>{SPHERE}</collision>"), 1000),
    (
        "collisions",
        in_link('<collision><geometry><sphere radius="1.@"/></geometry></collision>'),
        1000,
    ),
    ("unknown elements", repeated("<unknown@/>"), 250),
    ("unknown attributes", repeated('<link name="k@" unknown@="1"/>'), 250),
    (
        "attributes of one element",
        lambda n: robot(f'<link name="l" {" ".join(f"""a{k}="1" """ for k in range(n))}/>\n'),
        500,
    ),
    ("on one line", flat(urdf_chain), 250),
    ("on one line, faults", flat(repeated('<link name="k@" unknown="1"/>')), 250),
    ("malformed numbers", lambda n: jointed(_chain)(n).replace('"-1"', '"-1,0"'), 150),
    ("negative masses", in_links(MASS), 100),
    ("malformed comments", repeated("<!-- a -- b -->"), 500),
    ("comments", repeated("<!-- a -->"), 4000),
    ("suppressions", repeated("<!-- kinlint: ignore[SRC] a reason -->\n<unknown@/>"), 150),
    ("gazebo", repeated('<gazebo reference="l"><mu1>@</mu1></gazebo>'), 1000),
    ("gazebo of missing links", repeated('<gazebo reference="m@"><mu1>1</mu1></gazebo>'), 250),
    ("transmissions", repeated(TRANSMISSION), 500),
    ("letters of a name", lambda n: robot(f'<link name="{"a" * n}"/>\n'), 4000),
    ("letters of names", _letters, 500),
    ("long names", _long_names, 100),
    ("never ended", lambda n: '<robot name="r">' + "<link>" * n, 4000),
    ("ampersands", repeated('<link name="a &amp; @"/>'), 500),
    ("pairs that close loops", jointed(lambda n: [*_chain(n), *_chain(n)]), 100),
    (
        "branches that merge",
        jointed(
            lambda n: [
                *((0, k) for k in range(1, n)),
                *((k, n + k) for k in range(1, n)),
                *((k, n + k + 1) for k in range(1, n)),
            ]
        ),
        100,
    ),
    (
        "ros2_control",
        lambda n: robot(
            '<link name="l"/>\n<ros2_control name="c" type="system">\n',
            numbered('<joint name="j@"><command_interface name="position"/></joint>', n),
            "</ros2_control>\n",
        ),
        500,
    ),
)
URDF = tuple(Growing(f"URDF: {title}", "r.urdf", text, count) for title, text, count in INPUTS)
