"""The stub of the extension module names what is in it, and the package says what it exports."""

from __future__ import annotations

import ast
import importlib.metadata
import re
from pathlib import Path

import pytest
from conftest import PROJECT

import waybreaker as wb
from waybreaker import _core

HOME = Path(wb.__file__).parent


def public(names: "list[str]") -> "set[str]":
    return {name for name in names if not name.startswith("_")}


def test_stub_names_what_is_there() -> None:
    stub = ast.parse((HOME / "_core.pyi").read_text())
    functions = [node.name for node in stub.body if isinstance(node, ast.FunctionDef)]
    classes = [node for node in stub.body if isinstance(node, ast.ClassDef)]
    assert public(functions + [node.name for node in classes]) == public(dir(_core))
    for node in classes:
        if node.name == "InputError":
            continue
        members = [member.name for member in node.body if isinstance(member, ast.FunctionDef)]
        assert public(members) == public(dir(getattr(_core, node.name))), node.name


def test_all_is_there_and_described() -> None:
    assert (HOME / "py.typed").exists()
    for name in wb.__all__:
        member = getattr(wb, name)
        if isinstance(member, type) and name != "InputError" or callable(member) and name in ("plan", "front", "check"):
            assert member.__doc__, name


def test_version() -> None:
    assert wb.__version__ == importlib.metadata.version("waybreaker")
    lists = PROJECT / "CMakeLists.txt"
    if not lists.exists():
        pytest.skip("not in the repository")
    found = re.search(r"project\(waybreaker VERSION ([\d.]+)", lists.read_text())
    assert found and found[1] == wb.__version__
