"""Comments that suppress findings, which outlive what xacro does to comments."""

from __future__ import annotations

import re
from collections.abc import Callable

from kinlint.formats.xacro.dom import Comment, Element, Node, Text
from kinlint.formats.xacro.xacro_parser import ParsedXacro

OURS = re.compile(r"\s*kinlint:")
WHOLE_FILE = re.compile(r"\s*kinlint:\s*file-ignore\b")


def comment_remover(stop: Text) -> Callable[[Node], None]:
    """Return a function that removes the comments in front of a node, but not suppressions.

    It does so as xacro does, and puts *stop* behind the node, so that the next one loses none of
    what comes before.
    """

    def remove_previous_comments(node: Node) -> None:
        parent, after, previous = node.parentNode, node.nextSibling, node.previousSibling
        assert parent is not None
        while previous is not None:
            if isinstance(previous, Text) and _is_one_line_end(previous.data):
                previous = previous.previousSibling
            if not isinstance(previous, Comment):
                if after is not None and after is not stop:
                    parent.insertBefore(stop, after)
                return
            comment, previous = previous, previous.previousSibling
            if not OURS.match(comment.data):
                parent.removeChild(comment)

    return remove_previous_comments


def _is_one_line_end(text: str) -> bool:
    return text.isspace() and text.count("\n") <= 1


def inherit(root: Element, parsed: ParsedXacro) -> None:
    """Put into *root*, the only part of *parsed* to be included, what speaks for the whole file."""
    first = root.firstChild
    for node in parsed.before:
        if isinstance(node, Comment) and WHOLE_FILE.match(node.data):
            root.insertBefore(node.cloneNode(), first)
