"""Rust source in which every mutant stands behind a switch: one build holds them all.

A mutant is a place and a replacement, as `cargo mutants --list --json` names them. The place is found in the syntax tree,
so that `a + b` becomes an expression which asks `crate::mutant` whether `a - b` is meant. Around what is written stand
comments, `/*<7*/ .. /*>*/` around what only mutant 7 says and `/*[7*/ .. /*]*/` around the whole place whose first
mutant is 7: by these an error of the compiler is brought home to its mutant.
"""

import re
from dataclasses import dataclass, field

import tree_sitter_rust
from tree_sitter import Language, Node, Parser

PARSER = Parser(Language(tree_sitter_rust.language()))
LOGIC = ("&&", "||")
COMPARISONS = ("==", "!=", "<", "<=", ">", ">=")


@dataclass
class Mutant:
    """A change in one place. `number` is what the switch is set to; 0 is none."""

    number: int
    name: str
    file: str
    genre: str
    replacement: str
    start: tuple[int, int]
    end: tuple[int, int]
    field: str = ""

    @classmethod
    def read(cls, number: int, entry: dict) -> "Mutant":
        """From an entry of the list; lines and columns count from 1, columns in characters."""
        start, end = entry["span"]["start"], entry["span"]["end"]
        named = re.search(r"delete field (\w+)", entry["name"])
        return cls(number, entry["name"], entry["file"], entry["genre"], entry["replacement"],
                   (start["line"], start["column"]), (end["line"], end["column"]), named[1] if named else "")

    @property
    def change(self) -> str:
        """What it does, without line and column: this stays when lines are added above it."""
        return re.sub(r"^(\S+?):\d+:\d+: ", r"\1: ", self.name)


@dataclass
class Choices:
    """What earlier rounds of the compiler taught: mutants that are out, functions that have to stay `const`, and by
    place which form of the switch compiles."""

    out: dict[int, str] = field(default_factory=dict)
    constant: set[str] = field(default_factory=set)
    form: dict[int, int] = field(default_factory=dict)


class Source:
    """One file and its mutants."""

    def __init__(self, text: str, mutants: list[Mutant]):
        self.bytes = text.encode()
        self.tree = PARSER.parse(self.bytes)
        self.lines = text.split("\n")
        self.offsets = [0]
        for line in self.lines:
            self.offsets.append(self.offsets[-1] + len(line.encode()) + 1)
        self.places: dict[int, list[Mutant]] = {}
        self.nodes: dict[int, Node] = {}
        self.lost = [m for m in mutants if not self.place(m)]

    def offset(self, at: tuple[int, int]) -> int:
        line, column = at
        return self.offsets[line - 1] + len(self.lines[line - 1][: column - 1].encode())

    def place(self, mutant: Mutant) -> bool:
        """Finds the node that a mutant changes; false where the tree has none, as inside of a macro."""
        start, end = self.offset(mutant.start), self.offset(mutant.end)
        # the place of a field or an arm has the comma behind it
        node = self.tree.root_node.descendant_for_byte_range(
            start, start + 1 if mutant.genre in ("StructField", "MatchArm") else end)
        wanted = {
            "FnValue": ("function_item",),
            "BinaryOperator": ("binary_expression", "compound_assignment_expr"),
            "UnaryOperator": ("unary_expression",),
            "MatchArm": ("match_arm",),
            "MatchArmGuard": ("match_arm",),
            "StructField": ("field_initializer", "shorthand_field_initializer"),
        }.get(mutant.genre, ())
        while node is not None and node.type not in wanted:
            node = node.parent
        if node is None or mutant.genre == "FnValue" and node.child_by_field_name("body") is None:
            return False
        if mutant.genre == "BinaryOperator" and node.child_by_field_name("operator").start_byte != start:
            return False
        if mutant.genre == "StructField" and self.base(node) is None:
            return False
        self.nodes[node.id] = node
        self.places.setdefault(node.id, []).append(mutant)
        return True

    def text(self, node: Node) -> str:
        return self.bytes[node.start_byte : node.end_byte].decode()

    def base(self, initializer: Node) -> str | None:
        """The value that a field has when it is left out: that of the expression after `..`."""
        for sibling in initializer.parent.children:
            if sibling.type == "base_field_initializer":
                text = self.text(sibling)[2:].strip()
                if text == "Default::default()":
                    kind = self.text(initializer.parent.parent.child_by_field_name("name"))
                    return f"<{kind} as Default>::default()"
                return f"({text})"
        return None

    def written(self, choices: Choices) -> str:
        """The source with its switches, as many lines as before."""
        return self.write(self.tree.root_node, choices, False)

    def write(self, node: Node, choices: Choices, constant: bool) -> str:
        if node.type in ("const_item", "static_item"):
            constant = True
        if node.type == "function_item":
            constant = self.is_constant(node) and self.name(node) in choices.constant
        if node.type == "const" and node.parent.type == "function_modifiers":
            function = node.parent.parent
            return "const" if self.name(function) in choices.constant else ""
        mutants = [m for m in self.places.get(node.id, []) if m.number not in choices.out]
        if constant and mutants:
            choices.out.update((m.number, "constant") for m in mutants)
            mutants = []
        parts = {child.id: self.write(child, choices, constant) for child in node.children}
        if mutants:
            return Switch(self, node, mutants, parts, choices).write()
        return self.plain(node, parts)

    def plain(self, node: Node, parts: dict[int, str]) -> str:
        """A node of these parts, with what stands between them."""
        if not node.children:
            return self.text(node)
        at, out = node.start_byte, []
        for child in node.children:
            out += [self.bytes[at : child.start_byte].decode(), parts[child.id]]
            at = child.end_byte
        return "".join([*out, self.bytes[at : node.end_byte].decode()])

    def name(self, function: Node) -> str:
        return self.text(function.child_by_field_name("name"))

    def is_constant(self, function: Node) -> bool:
        return any(c.type == "function_modifiers" and "const" in self.text(c).split() for c in function.children)


def only(mutant: Mutant, text: str) -> str:
    return f"/*<{mutant.number}*/{text}/*>*/"


def on(mutant: Mutant) -> str:
    return f"crate::mutant::is({mutant.number})"


class Switch:
    """One place and the mutants of it that are left."""

    def __init__(self, source: Source, node: Node, mutants: list[Mutant], parts: dict[int, str], choices: Choices):
        self.source, self.node, self.mutants, self.parts = source, node, mutants, parts
        self.choices = choices
        self.numbers = [m.number for m in mutants]
        self.place = source.places[node.id][0].number
        self.form = choices.form.get(self.place, 0)

    def part(self, name: str) -> str:
        return self.parts[self.node.child_by_field_name(name).id]

    def write(self) -> str:
        kind = self.node.type
        if kind == "function_item":
            return self.function()
        text = {"binary_expression": self.binary, "compound_assignment_expr": self.assignment,
                "unary_expression": self.unary, "match_arm": self.arm, "field_initializer": self.initializer,
                "shorthand_field_initializer": self.initializer}[kind]()
        return f"/*[{self.place}*/{text}/*]*/"

    def chosen(self, normal: str, other) -> str:
        """The normal expression first: it settles the type, and errors are those of the others."""
        cases = "".join(f" else if {on(m)} {{ {only(m, other(m))} }}" for m in self.mutants)
        return f"if crate::mutant::off(&{self.numbers}) {{ {normal} }}{cases} else {{ unreachable!() }}"

    def function(self) -> str:
        body = self.node.child_by_field_name("body")
        result = self.node.child_by_field_name("return_type")
        text = self.parts[body.id]
        if result is not None and self.source.text(result).startswith("impl "):
            for m in self.mutants:
                value = f"crate::mutant::Either::Mutant({m.replacement})"
                text = f"{{ if {on(m)} {{ {only(m, value)} }} else {{ crate::mutant::Either::Normal({text}) }} }}"
        else:
            returns = "".join(only(m, f"if {on(m)} {{ return {m.replacement}; }}") for m in self.mutants)
            text = "{" + returns + text[1:]
        return self.source.plain(self.node, {**self.parts, body.id: text})

    def binary(self) -> str:
        left, right = self.part("left"), self.part("right")
        operator = self.source.text(self.node.child_by_field_name("operator"))
        if operator in LOGIC:
            m, *rest = self.mutants
            assert not rest and m.replacement in LOGIC, m.name
            # the right side is asked after a left side that leaves it open; the mutant asks it after the other one
            asked = "!=" if operator == "&&" else "=="
            return f"{{ let mutant_l: bool = {left}; if mutant_l {asked} {on(m)} {{ {right} }} else {{ mutant_l }} }}" \
                .join("()")
        refers = ["&", "", None] if operator in COMPARISONS else ["", None]
        refer = refers[self.form]
        if refer is None:
            return f"({self.chosen(f'({left}) {operator} ({right})', lambda m: f'({left}) {m.replacement} ({right})')})"
        choice = self.chosen(f"mutant_l {operator} mutant_r", lambda m: f"mutant_l {m.replacement} mutant_r")
        return f"(match ({refer}({left}), {refer}({right})) {{ (mutant_l, mutant_r) => {choice} }})"

    def assignment(self) -> str:
        left, right = self.part("left"), self.part("right")
        operator = self.source.text(self.node.child_by_field_name("operator"))
        if self.form == 0:
            choice = self.chosen(f"{left} {operator} mutant_r;", lambda m: f"{left} {m.replacement} mutant_r;")
            return f"(match ({right}) {{ mutant_r => {{ {choice} }} }})"
        return f"({self.chosen(f'{left} {operator} {right};', lambda m: f'{left} {m.replacement} {right};')})"

    def unary(self) -> str:
        operator, operand = self.node.children[0], self.parts[self.node.children[-1].id]
        sign = self.source.text(operator)
        if self.form == 0:
            return f"(match ({operand}) {{ mutant_v => {self.chosen(f'{sign}mutant_v', lambda m: 'mutant_v')} }})"
        return f"({self.chosen(f'{sign}({operand})', lambda m: f'({operand})')})"

    def arm(self) -> str:
        pattern = self.node.child_by_field_name("pattern")
        guard = pattern.child_by_field_name("condition")
        if guard is None:
            return self.source.plain(self.node, {
                **self.parts, pattern.id: "{} if {}".format(self.parts[pattern.id], self.kept("true"))})
        asked = next(child for child in pattern.children if child.type == "if")
        head = self.source.bytes[pattern.start_byte : asked.start_byte].decode()
        condition = self.source.write(guard, self.choices, False)
        return self.source.plain(self.node, {**self.parts, pattern.id: f"{head}if {self.kept(condition)}"})

    def kept(self, condition: str) -> str:
        for m in self.mutants:
            if m.genre == "MatchArmGuard":
                condition = f"({on(m)} || {condition})" if m.replacement == "true" else f"(!{on(m)} && ({condition}))"
        for m in self.mutants:
            if m.genre == "MatchArm":
                condition = f"!{on(m)} && ({condition})"
        return condition

    def initializer(self) -> str:
        base = self.source.base(self.node)
        if self.node.type == "shorthand_field_initializer":
            name = value = self.source.text(self.node)
        else:
            name, value = self.source.text(self.node.child_by_field_name("field")), self.part("value")
        return f"{name}: " + self.chosen(value, lambda m: f"{base}.{name}")
