"""The script for zsh."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.cli.completion.grammar import Command, Option, Value, Words

HEAD = """\
#compdef kinlint
# Completion of kinlint for zsh. Made by: kinlint generate-shell-completion zsh

_kinlint_rules=({rules})

_kinlint() {{
    local command={first}
    local -a commands=(
{described}
    )
    if ((CURRENT > 2)) && [[ -n ${{(M)commands:#$words[2]:*}} ]]; then
        command=$words[2]
        shift words
        ((CURRENT--))
    elif ((CURRENT == 2)) && [[ $words[2] != -* ]]; then
        _describe -t commands command commands
    fi
    case $command in
"""
END = """\
    esac
}

if [[ $zsh_eval_context[-1] == loadautofunc ]]; then
    _kinlint "$@"
else
    compdef _kinlint kinlint
fi
"""


def script(words: Words) -> str:
    """The script that completes *words*."""
    described = "\n".join(f"        {_quoted(f'{one.name}:{one.text}')}" for one in words.commands)
    rules = " ".join(words.rules)
    head = HEAD.format(rules=rules, first=words.commands[0].name, described=described)
    return "".join([head, *map(_case, words.commands), END])


def _case(command: Command) -> str:
    specs = [spec for option in command.options for spec in _specs(option)]
    if command.rest is not None:
        specs.append(f"*:{_action(command.rest, 'path')}")
    lines = "".join(f" \\\n                {_quoted(spec)}" for spec in specs)
    return f"        {command.name})\n            _arguments -S{lines}\n            ;;\n"


def _specs(option: Option) -> Iterator[str]:
    """Yield the `_arguments` specification of each name of *option*, which may be repeated."""
    text = option.text.replace("[", r"\[").replace("]", r"\]")
    for name in option.names:
        if option.value is None:
            yield f"*{name}[{text}]"
        else:
            mark = "=" if name.startswith("--") else "+"
            yield f"*{name}{mark}[{text}]:{_action(option.value, name.lstrip('-'))}"


def _action(value: Value, name: str) -> str:
    if value.kind in ("files", "folders"):
        return f"{name}:_files{' -/' if value.kind == 'folders' else ''}"
    if value.kind == "anything":
        return f"{name}: "
    words = "$_kinlint_rules" if value.kind == "rules" else " ".join(value.words)
    return f"{name}:_sequence compadd - {words}" if value.several else f"{name}:compadd {words}"


def _quoted(text: str) -> str:
    return "'" + text.replace("'", "'\\''") + "'"
