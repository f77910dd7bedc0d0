"""Makes up changes of graphs."""

from __future__ import annotations

import random

from kinlint.edits import Delta
from kinlint.terms import RDF, RDF_TYPE, Term, Triple, is_blank, literal

EX = "https://example.org/arm#"
XSD = "http://www.w3.org/2001/XMLSchema#"
G = "https://comp-rob2b.github.io/metamodels/geometry/"
COORDINATES = f"{G}coordinates#"
PROPERTIES = [f"<{EX}{name}>" for name in ("note", "raw", "knows", "count", "other")] + [
    f"<{COORDINATES}{name}>" for name in ("x", "of-position", "as-seen-by")
]
TYPES = [f"<{COORDINATES}VectorXYZ>", f"<{EX}T>", f"<{G}structural-entities#Frame>"]
LITERALS = [
    literal("1.0E0", f"{XSD}double"),
    literal("1.570", f"{XSD}double"),
    literal("2", f"{XSD}integer"),
    literal("true", f"{XSD}boolean"),
    literal("0.5", f"{XSD}decimal"),
    literal("text"),
    literal("deutsch", language="de"),
    literal("odd", f"{EX}odd"),
]


FIRST, REST, NIL = f"<{RDF}first>", f"<{RDF}rest>", f"<{RDF}nil>"


class Changer:
    """Draws changes of a graph that leave lists and anonymous nodes whole."""

    def __init__(self, triples: list[Triple], chance: random.Random) -> None:
        self.triples = triples
        self.chance = chance
        self.cells = {s for s, p, _ in triples if p in (FIRST, REST)}
        self.plain = [t for t in triples if t[0] not in self.cells and t[2] not in self.cells]
        self.subjects = list(dict.fromkeys(t[0] for t in self.plain)) or [f"<{EX}new>"]
        self.heads = [t for t in triples if t[0] not in self.cells and t[2] in self.cells]

    def delta(self) -> Delta:
        kinds = [self.values, self.values, self.values, self.node, self.name, self.sequence]
        removed, added = self.chance.choice(kinds)()
        there = set(self.triples).difference(removed)
        added = [triple for triple in dict.fromkeys(added) if triple not in there]
        stays = set(removed).intersection(added)
        return Delta(
            tuple(triple for triple in dict.fromkeys(removed) if triple not in stays),
            tuple(triple for triple in added if triple not in stays),
        )

    def values(self) -> tuple[list[Triple], list[Triple]]:
        chance = self.chance
        loose = [t for t in self.plain if not is_blank(t[2])]
        removed = chance.sample(loose, min(len(loose), chance.choice([0, 1, 1, 2, 3])))
        added: list[Triple] = []
        for subject, prop, _ in removed:
            if chance.random() < 0.6:
                added.append((subject, prop, self.value(prop)))
        for _ in range(chance.choice([0, 0, 1, 2])):
            prop = chance.choice([*PROPERTIES, RDF_TYPE])
            subject = chance.choice([*self.subjects, f"<{EX}new>"])
            added.append((subject, prop, self.value(prop)))
        if chance.random() < 0.1:
            node, new = chance.choice(self.subjects), chance.choice(["_:new", f"<{EX}new>"])
            added.append((node, f"<{EX}knows>", new))
            added.append((new, f"<{EX}note>", chance.choice(LITERALS)))
        return removed, added

    def value(self, prop: Term) -> Term:
        if prop == RDF_TYPE:
            return self.chance.choice(TYPES)
        return self.chance.choice([*(f"<{EX}n{number}>" for number in range(3)), *LITERALS])

    def node(self) -> tuple[list[Triple], list[Triple]]:
        """A node goes with all that is said of it and, often, all that points to it."""
        node = self.chance.choice(self.subjects)
        pointing = self.chance.random() < 0.7 or is_blank(node)
        gone = [t for t in self.triples if t[0] == node or (pointing and t[2] == node)]
        return self.with_lists(gone), []

    def with_lists(self, gone: list[Triple]) -> list[Triple]:
        found = list(gone)
        for _, _, cell in gone:
            while cell in self.cells:
                links = [t for t in self.triples if t[0] == cell]
                found += links
                cell = next(t[2] for t in links if t[1] == REST)  # noqa: PLW2901
        return found

    def name(self) -> tuple[list[Triple], list[Triple]]:
        """A node is called otherwise, or for the first time."""
        node, new = self.chance.choice(self.subjects), f"<{EX}named>"
        gone = [t for t in self.triples if node in (t[0], t[2])]
        return gone, [tuple(new if term == node else term for term in t) for t in gone]  # type: ignore[misc]

    def sequence(self) -> tuple[list[Triple], list[Triple]]:
        """A list gets other elements, cell by cell or all anew."""
        if not self.heads:
            return self.values()
        head = self.chance.choice(self.heads)
        cells = [head[2]]
        rests = {s: o for s, p, o in self.triples if p == REST}
        while rests[cells[-1]] != NIL:
            cells.append(rests[cells[-1]])
        old = [t for t in self.triples if t[0] in cells]
        firsts = {s: o for s, p, o in old if p == FIRST}
        values = [(cell, firsts[cell]) for cell in cells if cell in firsts]
        new = self.fresh(values)
        links = [*(cell for cell, _ in new), NIL]
        after = [(head[0], head[1], links[0])]
        for (cell, item), rest in zip(new, links[1:], strict=True):
            after += [(cell, FIRST, item), (cell, REST, rest)]
        return [head, *old], after

    def fresh(self, values: list[tuple[Term, Term]]) -> list[tuple[Term, Term]]:
        chance = self.chance
        kept = [pair for pair in values if chance.random() < 0.7]
        names = chance.random() < 0.2
        new = [(f"_:c{n}" if names else cell, item) for n, (cell, item) in enumerate(kept)]
        for number in range(chance.choice([0, 1, 2])):
            at = chance.randrange(len(new) + 1)
            new.insert(at, (f"_:new{number}", self.value("")))
        if new and chance.random() < 0.4:
            at = chance.randrange(len(new))
            new[at] = (new[at][0], self.value(""))
        return new
