"""The stubs, the documentation and the package say what is there."""

import ast
import pathlib
import re

import pytest
from conftest import PROJECT

import cirque

FOLDER = pathlib.Path(cirque.__file__).parent


def test_the_stubs_name_what_the_package_has():
    stubs = ast.parse((FOLDER / "__init__.pyi").read_text())
    named = {node.name for node in stubs.body if hasattr(node, "name")}
    assert set(cirque.__all__) <= named
    assert (FOLDER / "py.typed").exists()


def test_everything_is_explained():
    for name in cirque.__all__:
        assert getattr(cirque, name).__doc__, name


def test_options_are_those_of_the_tables():
    names = [option["name"] for option in cirque.options()]
    assert len(names) == len(set(names))
    assert {"domain", "cones", "epsilon", "centre", "refine_map", "fill_holes"} <= set(names)
    of_disk = {option["name"] for option in cirque.options("disk")}
    assert "centre" in of_disk and "cones" not in of_disk
    with pytest.raises(cirque.InvalidInputError):
        cirque.options("dusk")


def test_the_page_of_the_documentation_runs(tmp_path, monkeypatch):
    monkeypatch.chdir(tmp_path)
    page = (PROJECT / "framework/docs/python.md").read_text()
    blocks = re.findall(r"```python\n(.*?)```", page, re.S)
    assert len(blocks) >= 8
    names = {}
    for number, block in enumerate(blocks):
        exec(compile(block, f"python.md, block {number}", "exec"), names)
