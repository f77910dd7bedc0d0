"""The page of `kinlint --help`: the commands in the order of use, on one screen."""

from __future__ import annotations

from collections.abc import Mapping

USAGE = """\
usage: kinlint [PATH...] [options]

Lint robot descriptions: URDF, xacro, SRDF, SDF, MJCF, USD, COLLADA, JSON-LD
and Turtle. A PATH is a file, a directory, a quoted glob or - (standard input);
the default is '.'.

Commands (a file of such a name: ./rule):
"""

OPTIONS = """\
Frequent options:
  --select R, --ignore R     choose rules: a code, name, family or anti-pattern
  --show SEVERITY            show findings from error, warning or info up
  --fix, --diff              apply the safe fixes, or print them as a patch
  --output FORMAT[=FILE]     full, concise, json, sarif, github, html, ...
  --package NAME=DIR         set the directory of a ROS package
  --config PATH|KEY=VALUE    use a configuration file, or set a key

Exit code: 0 clean, 1 findings at or above --fail-on, 2 anything else.
All options: kinlint check --help. Of a command: kinlint COMMAND --help.
"""


def page(commands: Mapping[str, tuple[str, str]]) -> str:
    """Return the help of the whole program; *commands* have a module and a description each."""
    width = max(map(len, commands))
    rows = (f"  {name:<{width}}  {what}\n" for name, (_, what) in commands.items())
    return f"{USAGE}{''.join(rows)}\n{OPTIONS}"
