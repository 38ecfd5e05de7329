"""The Python half of the cookbook, and of the README, runs as it stands."""

import re
from pathlib import Path

import pytest

ROOT = Path(__file__).parents[2]
COOKBOOK = ROOT / "docs" / "cookbook.md"
RECIPES = re.findall(r"^## (.*?)$.*?```rust\n.*?```\n\n```python\n(.*?)```", COOKBOOK.read_text(), re.DOTALL | re.MULTILINE)


def test_every_recipe_has_both_halves() -> None:
    text = COOKBOOK.read_text()
    assert len(RECIPES) == text.count("\n## ") == text.count("```rust") == text.count("```python")


@pytest.mark.parametrize(("title", "recipe"), RECIPES, ids=[title for title, _ in RECIPES])
def test_recipe(title: str, recipe: str) -> None:
    exec(compile(recipe, f"cookbook: {title}", "exec"), {})


def test_readme() -> None:
    (example,) = re.findall(r"```python\n(.*?)```", (ROOT / "README.md").read_text(), re.DOTALL)
    exec(compile(example, "README.md", "exec"), {})
