"""Makes up changes of documents in XML."""

from __future__ import annotations

from random import Random

from kinlint.document import Document
from kinlint.edits import Delta
from kinlint.formats.xml.editing.stated_elements import elements
from kinlint.terms import XSD, Term, Triple, is_iri, literal
from kinlint.vocabulary import ATTRIBUTE, EXTENSION, SRC

NUMBERS = ("0.0E0", "1.0E0", "-1.5707963267948966E0", "1.0E-6", "2.5E1", "1.570", "3")
WORDS = ("a", "b c", "<&>", "it's", 'say "x"', "µ", "", "]]>", "a\nb", "漢")
NAMES = ("lower", "x", "name", "scale", "max_x", "rpy")
TAGS = ("link", "visual", "pose", "mass", "colision", "gz-b")


class Changer:
    """Draws changes of *document* from *random*."""

    def __init__(self, document: Document, random: Random) -> None:
        self.random = random
        self.known = elements(document.statements)
        self.nodes = list(self.known)
        self.said = [
            triple
            for triple in document.statements
            if triple[0] in self.known
            and not is_iri(triple[2])
            and (triple[1].startswith(f"<{ATTRIBUTE}") or triple[1].startswith(f"<{SRC}text"))
        ]
        self._fresh = 0

    def delta(self) -> Delta:
        """One change or several."""
        removed: list[Triple] = []
        added: list[Triple] = []
        kinds = (
            self._value, self._value, self._attribute, self._no_attribute, self._element,
            self._no_element, self._tag, self._move, self._key, self._text,
        )  # fmt: skip
        for _ in range(self.random.choice((1, 1, 1, 2, 3))):
            gone, come = self.random.choice(kinds)()
            removed += gone
            added += come
        both = set(removed) & set(added)
        return Delta(
            tuple(each for each in dict.fromkeys(removed) if each not in both),
            tuple(each for each in dict.fromkeys(added) if each not in both),
        )

    def literal(self, like: Term = "") -> Term:
        """A value, of the kind of *like* if that is given."""
        if like.endswith("double>") or (not like and self.random.random() < 0.5):
            return literal(self.random.choice(NUMBERS), f"{XSD}double")
        return literal(self.random.choice(WORDS))

    def _blank(self) -> Term:
        self._fresh += 1
        return f"_:new{self._fresh}"

    def _value(self) -> tuple[list[Triple], list[Triple]]:
        if not self.said:
            return [], []
        node, predicate, value = triple = self.random.choice(self.said)
        return [triple], [(node, predicate, self.literal(value))]

    def _no_attribute(self) -> tuple[list[Triple], list[Triple]]:
        if not self.said:
            return [], []
        node, predicate, _ = self.random.choice(self.said)
        stem = predicate.rstrip(">").rstrip("123456789").rstrip("-")
        return [each for each in self.said if each[0] == node and each[1].startswith(stem)], []

    def _attribute(self) -> tuple[list[Triple], list[Triple]]:
        node = self.random.choice(self.nodes)
        return [], self._attributes(node)

    def _attributes(self, node: Term) -> list[Triple]:
        name = self.random.choice(NAMES)
        if self.random.random() < 0.3:
            return [
                (node, f"<{ATTRIBUTE}{name}-{number}>", literal("1.0E0", f"{XSD}double"))
                for number in (1, 2, 3)
            ]
        return [(node, f"<{ATTRIBUTE}{name}>", self.literal())]

    def _text(self) -> tuple[list[Triple], list[Triple]]:
        return [], [(self.random.choice(self.nodes), f"<{SRC}text>", self.literal())]

    def _element(self) -> tuple[list[Triple], list[Triple]]:
        return [], self._child(self.random.choice(self.nodes), 0)

    def _child(self, parent: Term, depth: int) -> list[Triple]:
        node = self._blank()
        made = [(parent, f"<{EXTENSION}{self.random.choice(TAGS)}>", node)]
        for _ in range(self.random.randrange(3)):
            made += self._attributes(node)
        if self.random.random() < 0.2:
            made.append((node, f"<{SRC}text>", self.literal()))
        elif depth < 2:
            for _ in range(self.random.randrange(3)):
                made += self._child(node, depth + 1)
        return made

    def _place(self, node: Term) -> Triple:
        element = self.known[node]
        return element.parent, element.predicate, node

    def _no_element(self) -> tuple[list[Triple], list[Triple]]:
        return [self._place(self.random.choice(self.nodes))], []

    def _tag(self) -> tuple[list[Triple], list[Triple]]:
        parent, _, node = place = self._place(self.random.choice(self.nodes))
        return [place], [(parent, f"<{EXTENSION}{self.random.choice(TAGS)}>", node)]

    def _move(self) -> tuple[list[Triple], list[Triple]]:
        _, predicate, node = place = self._place(self.random.choice(self.nodes))
        return [place], [(self.random.choice(self.nodes), predicate, node)]

    def _key(self) -> tuple[list[Triple], list[Triple]]:
        if not self.said:
            return [], []
        node, predicate, value = triple = self.random.choice(self.said)
        if not predicate.startswith(f"<{ATTRIBUTE}"):
            return [], []
        return [triple], [(node, f"<{ATTRIBUTE}{self.random.choice(NAMES)}>", value)]
