"""usage: /usr/bin/python3 python_reference.py: the reference of the Python package as Markdown, by griffe.

Of what `waybreaker` exports: signatures, types and docstrings, read without importing it. What an exported thing has no
docstring for, and every name that begins with an underscore, is left out.
"""

from __future__ import annotations

import re
import sys
from html import escape
from pathlib import Path

from griffe.dataclasses import ParameterKind
from griffe.loader import GriffeLoader

SOURCE = Path(__file__).resolve().parent.parent / "python"


class Reference:
    def __init__(self) -> None:
        loader = GriffeLoader(search_paths=[SOURCE])
        self.package = loader.load_module("waybreaker")
        loader.resolve_aliases()
        self.exported = sorted(self.package.exports - {"__version__"})

    def markdown(self) -> str:
        by_kind = {"function": [], "class": [], "attribute": []}
        for name in self.exported:
            by_kind[self.package.members[name].kind.value].append(name)
        lines = [
            "# Python reference",
            "",
            "Made from the docstrings of the package. [Python](/python) has examples.",
            "",
            *self.words(self.package.docstring),
        ]
        for title, kind in (("Functions", "function"), ("Classes", "class"), ("Types", "attribute")):
            lines += [f"## {title}", ""]
            for name in by_kind[kind]:
                lines += self.thing(name, self.package.members[name])
        return "\n".join(lines)

    def thing(self, name: str, thing) -> list[str]:
        lines = [f"### `{name}` {{#{name}}}", ""]
        if thing.kind.value == "function":
            return [*lines, *self.signature(name, thing), *self.words(thing.docstring)]
        if thing.kind.value == "attribute":
            return [*lines, *code(f"{name} = {thing.value}"), *self.words(thing.docstring)]
        if thing.bases:
            lines += [f"A {', '.join(f'`{base}`' for base in thing.bases)}.", ""]
        lines += self.words(thing.docstring)
        return lines + self.fields(thing) + self.methods(thing)

    def fields(self, owner) -> list[str]:
        """Members and properties, one a row."""
        is_data = "dataclass" in owner.labels
        rows = []
        for name, member in owner.members.items():
            if name.startswith("_") or member.kind.value != "attribute":
                continue
            if member.docstring or is_data:
                usual = f"`{member.value}`" if is_data and member.value else ""
                rows.append([f"`{name}`", type_of(member), usual, " ".join(self.words(member.docstring)).strip()])
        return table(["member", "type", "default", ""], rows)

    def methods(self, owner) -> list[str]:
        lines = []
        for name, member in owner.members.items():
            if member.kind.value != "function" or not member.docstring or name == "__init__":
                continue
            lines += [f"#### `{owner.name}.{name}` {{#{owner.name}-{name}}}", ""]
            lines += [*self.signature(f"{owner.name}.{name}", member), *self.words(member.docstring)]
        return lines

    def signature(self, name: str, function) -> list[str]:
        parts = []
        keyword_only = False
        for parameter in function.parameters:
            if parameter.name == "self":
                continue
            if parameter.kind is ParameterKind.keyword_only and not keyword_only:
                keyword_only = True
                parts.append("*")
            stars = {ParameterKind.var_positional: "*", ParameterKind.var_keyword: "**"}.get(parameter.kind, "")
            text = f"{stars}{parameter.name}: {parameter.annotation}"
            parts.append(text if parameter.default is None or stars else f"{text} = {parameter.default}")
        line = f"{name}({', '.join(parts)}) -> {function.returns}"
        if len(line) > 80:
            line = f"{name}(\n" + "".join(f"    {part},\n" for part in parts) + f") -> {function.returns}"
        return code(line)

    def words(self, docstring) -> list[str]:
        if docstring is None:
            return []
        lines, example = [], []
        for line in docstring.value.splitlines():
            if line.startswith((">>>", "...")) or (example and line):
                example.append(line)
                continue
            if example:
                lines += [*code("\n".join(example), "pycon"), ""]
                example = []
            lines.append(self.linked(line))
        if example:
            lines += code("\n".join(example), "pycon")
        return [*lines, ""]

    def linked(self, line: str) -> str:
        """``code`` and :role:`target` of reStructuredText as Markdown."""
        def link(found: re.Match[str]) -> str:
            target = found[1]
            first, _, rest = target.partition(".")
            if first not in self.exported:
                return f"`{target}`"
            member = self.package.members[first].members.get(rest)
            has_heading = member is not None and member.kind.value == "function"
            return f"[`{target}`](#{first}{'-' + rest if has_heading else ''})"

        pieces = re.split(r"(``.+?``|:\w+:`.+?`|`.+?`)", line)
        return "".join(
            re.sub(r"^:\w+:`(.+)`$", link, piece) if piece.startswith(":")
            else f"`{piece.strip('`')}`" if piece.startswith("`")
            else escape(piece, quote=False)
            for piece in pieces
        )


def type_of(member) -> str:
    """Empty where only a value is written down."""
    return f"`{member.annotation}`" if member.annotation else ""


def table(head: list[str], rows: list[list[str]]) -> list[str]:
    """Without the columns that are empty."""
    if not rows:
        return []
    full = [column for column in range(len(head)) if any(row[column] for row in rows)]
    lines = ["| " + " | ".join(row[column].replace("|", "\\|") for column in full) + " |" for row in [head, *rows]]
    return [lines[0], "|---" * len(full) + "|", *lines[1:], ""]


def code(text: str, language: str = "python") -> list[str]:
    return [f"```{language}", text, "```", ""]


if __name__ == "__main__":
    if len(sys.argv) > 1:
        sys.exit(__doc__)
    print(Reference().markdown())
