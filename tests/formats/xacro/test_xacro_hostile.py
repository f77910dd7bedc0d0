"""Files that would run code, read what is none of their business, or never end."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
import xacro
from expanding import document, failure, names, project, robot

CODE = {
    "class": "${().__class__.__bases__[0].__subclasses__()}",
    "class in a comprehension": "${[c for c in ().__class__.__bases__]}",
    "class in a lambda": "${(lambda: (1).__class__)()}",
    "format": "${'{0.__class__}'.format(1)}",
    "format with a map": "${'{x.__class__}'.format_map(dict(x=1))}",
    "f-string": "${f'{(1).__class__}'}",
    "import": "${__import__('os').getpid()}",
    "open": "${open('/etc/passwd').read()}",
    "eval": "$(eval open('/etc/passwd').read())",
    "eval of import": "$(eval __import__('os').getpid())",
    "getattr": "${getattr(1, 'real')}",
    "type of a type": "${python.type(python.type(1))}",
    "type of a function": "${python.type(lambda: 0)}",
    "globals of a function": "${load_yaml.__globals__}",
    "frame of a generator": "${(x for x in [1]).gi_frame}",
    "vars": "${python.vars()}",
    "walrus": "${(x := 1)}",
    "YAML that is none": "${load_yaml('/etc/passwd')}",
    "YAML of a device": "${load_yaml('/dev/zero')}",
}


@pytest.mark.parametrize("expression", CODE.values(), ids=CODE.keys())
def test_code_is_not_run(tmp_path: Path, expression: str) -> None:
    value = expression.replace("<", "&lt;").replace('"', "&quot;")
    reason, place = failure(document(project(tmp_path, main=robot(f'<link name="{value}"/>'))))
    assert place.startswith("main.xacro:2:13")
    assert "root:" not in reason


ENDLESS = {
    "power": "${9**9**9}",
    "powers of powers": "${2**200**200}",
    "shift": "${1 << 10**10}",
    "repetition": "${'a'*10**9}",
    "list": "${[0]*10**9}",
    "range": "${sum(python.range(10**12))}",
    "comprehension": "${[x for x in range(90000) for y in range(90000)]}",
    "factorial": "${factorial(10**8)}",
    "binomial": "${comb(10**9, 10**8)}",
    "width": "${'%1000000000d' % 1}",
    "width from outside": "${'%*d' % (1000000000, 1)}",
    "digits": "${round(5, -10**9)}",
    "nested lists": "${(lambda f: f(f, [1], 60))(lambda f, x, n: f(f, [x, x], n-1) if n else x)}",
    "recursion": "${(lambda f: f(f))(lambda f: f(f))}",
    "parentheses": "${" + "(" * 1500 + ")" * 1500 + "}",
    "operators": "${" + "-" * 3000 + "1}",
    "long": "${" + "1+" * 4000 + "1}",
    "joined": "${','.join(['a'*1000000]*1000)}",
    "replaced": "${('a'*1000000).replace('a', 'a'*1000000)}",
    "sum of lists": "${python.sum([[1]]*100000, [])}",
    "hash of long tuples": "${[python.hash(t) for t in [python.tuple(range(900))]*90000]}",
    "hash of what is shared": "${(lambda f: f(f, (1,), 60))"
    "(lambda f, x, n: f(f, (x, x), n-1) if n else python.hash(x))}",
    "long tuples in sets": "${[python.set([python.tuple(range(900))]) for i in range(9000)]}",
    "set of equal hashes": "${len(python.set([i*(2**61-1) for i in range(20000)]))}",
    "union of equal hashes": "${len(python.set([1]).union([i*(2**61-1) for i in range(20000)]))}",
    "table of equal hashes": "${len(dict([[i*(2**61-1), 1] for i in range(20000)]))}",
    "unions": "${[python.set(range(1900)) | python.set(range(1900)) for i in range(90000)]}",
    "lcm of many": "${math.lcm(*range(1, 90000))}",
    "lcm of a few large": "${math.lcm(*[2**250-i for i in range(1, 9000)])}",
    "format with a table": "${'%(a)s' * 100000 % dict(a='b'*100000)}",
    "format of long texts": "${'%s'*1000 % python.tuple(['a'*100000]*1000)}",
    "format of what is shared": "${'%r' % [[0]*90000]*90}",
    "zip": "${python.list(python.zip(*[range(90000)]*3000))}",
    "any": "${python.any([[0]*9000 == [0]*9000 for i in range(90000)])}",
    "in": "${[(1,2) in [(1,3)]*90000 for i in range(90000)]}",
    "comparisons": "${[[0]*90000 == [0]*90000 for i in range(90000)]}",
    "smallest by a lambda": "${min(range(90000), key=lambda x: len([0]*90000))}",
    "greatest by hash": "${max([python.tuple(range(9000))]*90, key=python.hash)*90000}",
    "sorted by text": "${sorted([python.list(range(90))]*9000, key=str)*90000}",
    "texts of lists": "${[str([0]*90000) for i in range(9000)]}",
    "count": "${[([0]*90000).count(1) for i in range(90000)]}",
    "split": "${[('a '*400000).split() for i in range(90)]}",
    "upper case": "${[('a'*1000000).upper() for i in range(900)]}",
    "slices": "${[([0]*90000)[1:] for i in range(90000)]}",
    "exact sums": "${[math.fsum([0.1]*90000) for i in range(9000)]}",
    "many pieces": "$ " * 100000,
}


@pytest.mark.slow
@pytest.mark.parametrize("expression", ENDLESS.values(), ids=ENDLESS.keys())
def test_what_never_ends_ends(tmp_path: Path, expression: str) -> None:
    value = expression.replace("<", "&lt;")
    found = document(project(tmp_path, main=robot(f'<link name="{value}"/>')))
    if expression != ENDLESS["many pieces"]:
        assert failure(found)[1].startswith("main.xacro:2:13")


def test_a_macro_that_calls_itself(tmp_path: Path) -> None:
    main = robot(
        '<xacro:macro name="m" params="n"><xacro:m n="${n+1}"/></xacro:macro>', '<xacro:m n="0"/>'
    )
    reason, place = failure(document(project(tmp_path, main=main)))
    assert reason == "macro 'm' calls itself without end"
    assert place == "main.xacro:2:35 xacro:m"


def test_a_macro_that_calls_itself_twice(tmp_path: Path) -> None:
    main = robot('<xacro:macro name="m"><xacro:m/><xacro:m/><link/></xacro:macro>', "<xacro:m/>")
    assert "without end" in failure(document(project(tmp_path, main=main)))[0]


@pytest.mark.slow
def test_macros_that_double(tmp_path: Path) -> None:
    macros = [
        f'<xacro:macro name="m{n}"><xacro:m{n + 1}/><xacro:m{n + 1}/></xacro:macro>'
        for n in range(40)
    ]
    main = robot(*macros, '<xacro:macro name="m40"><link name="x"/></xacro:macro>', "<xacro:m0/>")
    reason, _ = failure(document(project(tmp_path, main=main)))
    assert "far more elements than any robot has" in reason


def test_properties_that_double(tmp_path: Path) -> None:
    doubling = [
        f'<xacro:property name="p{n}" value="${{p{n + 1}}}${{p{n + 1}}}"/>' for n in range(60)
    ]
    main = robot(*doubling, '<xacro:property name="p60" value="abc"/>', '<link name="${p0}"/>')
    reason, _ = failure(document(project(tmp_path, main=main)))
    assert "text" in reason


def test_properties_that_define_each_other(tmp_path: Path) -> None:
    main = robot(
        '<xacro:property name="a" value="${b}"/>',
        '<xacro:property name="b" value="${a}"/>',
        '<link name="${a}"/>',
    )
    reason, place = failure(document(project(tmp_path, main=main)))
    assert "a -> b -> a" in reason
    assert place.startswith("main.xacro:4:13")


def test_files_that_include_each_other(tmp_path: Path) -> None:
    path = project(
        tmp_path,
        main=robot('<xacro:include filename="other.xacro"/>'),
        other=robot('<xacro:include filename="main.xacro"/>'),
    )
    reason, place = failure(document(path))
    assert reason == "'main.xacro' includes itself"
    assert place == "other.xacro:2:26 main.xacro"


@pytest.mark.parametrize(
    "name", ["/dev/zero", "/dev/stdin", "/proc/self/environ", "/etc/passwd", "..", "\0"]
)
def test_what_is_no_model_is_not_included(tmp_path: Path, name: str) -> None:
    name = name.replace("\0", "${'a\\0b'}")
    reason, _ = failure(
        document(project(tmp_path, main=robot(f'<xacro:include filename="{name}"/>')))
    )
    assert "root:" not in reason


@pytest.mark.parametrize("suffix", ["xacro", "yaml"])
def test_hidden_files_are_private(tmp_path: Path, suffix: str) -> None:
    (tmp_path / ".secrets").mkdir()
    (tmp_path / ".secrets" / f"a.{suffix}").write_text("<a/>" if suffix == "xacro" else "a: 1")
    (tmp_path / f"link.{suffix}").symlink_to(tmp_path / ".secrets" / f"a.{suffix}")
    for name in (f".secrets/a.{suffix}", f"link.{suffix}"):
        use = f"${{load_yaml('{name}')}}" if suffix == "yaml" else name
        main = robot(f'<xacro:include filename="{use}"/>')
        reason, _ = failure(document(project(tmp_path, main=main)))
        assert reason.endswith("is none of the files that a robot is made of")


@pytest.mark.skipif(not hasattr(os, "mkfifo"), reason="no pipes here")
def test_a_pipe_is_not_waited_for(tmp_path: Path) -> None:
    os.mkfifo(tmp_path / "pipe.xacro")
    reason, _ = failure(
        document(project(tmp_path, main=robot('<xacro:include filename="pipe.xacro"/>')))
    )
    assert reason.endswith("is not a file")


def test_wildcards_do_not_search_the_disk(tmp_path: Path) -> None:
    main = robot('<xacro:include filename="/*/*/*/*/*/*/*/*"/>')
    assert "wildcards" in failure(document(project(tmp_path, main=main)))[0]


YAML = {
    "contains a huge list": "a: &a [1,1,1,1,1,1,1,1,1]\n"
    + "".join(
        f"{chr(98 + n)}: &{chr(98 + n)} [{','.join(['*' + chr(97 + n)] * 9)}]\n" for n in range(12)
    ),
    "merges more than 10000 entries": "a: &a {"
    + ",".join(f"k{n}: 1" for n in range(1200))
    + "}\nb: {<<: ["
    + ",".join(["*a"] * 9)
    + "]}\n",
    "could not determine a constructor": "a: !!python/object/apply:os.getpid []\n",
    "refer to each other without end": "[" * 5000,
    "has more than 128 KiB": "a: 1\n" * 300_000,
    "has a number of more than 400 characters": "a: " + "1:" * 60_000 + "1\n",
    "takes far longer": "a: &a {"
    + ",".join(f"k{n}: 1" for n in range(5000))
    + "}\n"
    + "".join(f"b{n}: {{<<: *a}}\n" for n in range(3000)),
}


@pytest.mark.slow
@pytest.mark.parametrize("cause", YAML)
def test_hostile_yaml(tmp_path: Path, cause: str) -> None:
    """It is refused, and said why, at the place that asks for it."""
    (tmp_path / "table.yaml").write_text(YAML[cause])
    main = robot(
        '<xacro:property name="t" value="${load_yaml(\'table.yaml\')}"/>', '<link name="${t}"/>'
    )
    reason, place = failure(document(project(tmp_path, main=main)))
    assert cause in reason
    assert place == "main.xacro:3:13 ${t}"


def test_entities_and_depth(tmp_path: Path) -> None:
    bomb = '<!DOCTYPE r [<!ENTITY a "aaaa"><!ENTITY b "&a;&a;">]>' + robot('<link name="&b;"/>')
    deep = robot("<a>" * 100_000 + "</a>" * 100_000)
    for text in (bomb, deep):
        found = document(project(tmp_path, main=text))
        assert not names(found)


def test_the_package_is_left_as_it_was(tmp_path: Path) -> None:
    before = dict(vars(xacro))
    document(project(tmp_path, main=robot('<link name="${1/0}"/>')))
    assert dict(vars(xacro)) == before
