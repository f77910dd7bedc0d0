"""The script for bash, from 3.2 on."""

from __future__ import annotations

from collections.abc import Iterator

from kinlint.cli.completion.grammar import Command, Value, Words

HEAD = """\
# Completion of kinlint for bash. Made by: kinlint generate-shell-completion bash

_kinlint_rules='{rules}'

# What begins with the text after the last comma of $1, of the words $2.
_kinlint_listed() {{
    local before=""
    [[ $1 == *,* ]] && before=${{1%,*}},
    COMPREPLY=($(compgen -P "$before" -W "$2" -- "${{1##*,}}"))
    compopt -o nospace 2>/dev/null
}}

# Names of files, or with -d of directories, whatever is in them.
_kinlint_files() {{
    local name
    while IFS= read -r name; do COMPREPLY+=("$name"); done < <(compgen "$1" -- "$2")
    compopt -o filenames 2>/dev/null
}}

_kinlint() {{
    local cur=${{COMP_WORDS[COMP_CWORD]}} prev=${{COMP_WORDS[COMP_CWORD-1]}} command={first} word
    COMPREPLY=()
    # The shell takes "--option=value" apart.
    if [[ $cur == = ]]; then
        cur=""
    elif [[ $prev == = ]]; then
        prev=${{COMP_WORDS[COMP_CWORD-2]}}
    fi
    if ((COMP_CWORD > 1)); then
        case ${{COMP_WORDS[1]}} in
            {names}) command=${{COMP_WORDS[1]}} ;;
        esac
    fi
    case $command:$prev in
"""
MIDDLE = """\
    esac
    if [[ $cur == -* ]]; then
        case $command in
"""
TAIL = """\
        esac
        return
    fi
    if ((COMP_CWORD == 1)); then
        COMPREPLY=($(compgen -W '{words}' -- "$cur"))
    fi
    case $command in
"""
END = """\
    esac
}

complete -F _kinlint kinlint
"""


def script(words: Words) -> str:
    """The script that completes *words*."""
    names = [command.name for command in words.commands]
    first = words.commands[0].name
    head = HEAD.format(rules=" ".join(words.rules), first=first, names="|".join(names))
    return "".join(
        [
            head,
            *_values(words),
            MIDDLE,
            *map(_options, words.commands),
            TAIL.format(words=" ".join(names)),
            *(_rest(command) for command in words.commands if command.rest is not None),
            END,
        ]
    )


def _values(words: Words) -> Iterator[str]:
    """A case for each option that takes a value."""
    for command in words.commands:
        for option in command.options:
            if option.value is not None:
                names = "|".join(f"{command.name}:{name}" for name in option.names)
                yield f"        {names}) {_replied(option.value)}; return ;;\n"


def _options(command: Command) -> str:
    names = " ".join(name for option in command.options for name in option.names)
    return f"""            {command.name}) COMPREPLY=($(compgen -W '{names}' -- "$cur")) ;;\n"""


def _rest(command: Command) -> str:
    assert command.rest is not None
    return f"        {command.name}) {_replied(command.rest)} ;;\n"


def _replied(value: Value) -> str:
    """Return the shell code that adds the completions of *value* to the replies."""
    if value.kind in ("files", "folders"):
        return f'_kinlint_files {"-d" if value.kind == "folders" else "-f"} "$cur"'
    if value.kind == "anything":
        return ":"
    words = '"$_kinlint_rules"' if value.kind == "rules" else f"'{' '.join(value.words)}'"
    if value.several:
        return f'_kinlint_listed "$cur" {words}'
    return f'COMPREPLY+=($(compgen -W {words} -- "$cur"))'
