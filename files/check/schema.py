"""What is written fits the schema, and the schema and the reader refuse the same forms."""

import copy
import json
import re
import subprocess
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path

from jsonschema import Draft202012Validator

from plain import PROGRAM, check, done

FILES = Path(__file__).parent.parent
schema = json.loads((FILES / "symspline.schema.json").read_text())
Draft202012Validator.check_schema(schema)
validator = Draft202012Validator(schema)
document = json.loads((FILES / "tests/corpus/json/all.json").read_text())

# How an error is told that is about the form, and not about values: with line and column, or in these words.
FORM = re.compile(r":\d+:\d+: |write a text|make a rational spline|is not known|\"format\" is")


def paths(node, at=()):
    yield at
    items = node.items() if isinstance(node, dict) else enumerate(node) if isinstance(node, list) else ()
    for key, child in items:
        yield from paths(child, at + (key,))


def changed(at, change):
    other = copy.deepcopy(document)
    node = other
    for key in at[:-1]:
        node = node[key]
    change(node, at[-1])
    return other


def put(value):
    return lambda node, key: node.__setitem__(key, value)


def changes():
    for at in paths(document):
        if not at:
            continue
        for value in [None, "x", "1/0", "1/3", -1, 0.5, 2.0, 9007199254740993, [], {}]:
            yield at, value, changed(at, put(value))
        yield at, "deleted", changed(at, lambda node, key: node.pop(key))
        if isinstance(at[-1], str):
            yield at, "renamed", changed(at, lambda node, key: node.__setitem__(key + "x", node.pop(key)))
            yield at, "extra", changed(at, lambda node, key: node.__setitem__("extra", 1))


def told(content):
    """Whether the program takes a document, what it says against it, and what it writes."""
    command = [PROGRAM, "convert", "--from", "json", "--to", "json", "-", "-"]
    run = subprocess.run(command, input=json.dumps(content), capture_output=True, text=True)
    return run.returncode == 0, run.stderr, run.stdout


def agree(change):
    at, value, content = change
    fits, (accepted, error, _) = validator.is_valid(content), told(content)
    # What the schema cannot see is about values, not the form.
    check(fits or not accepted, f"the reader takes what the schema refuses: {at}, {value}")
    check(accepted or not fits or not FORM.search(error), f"the schema takes what the reader refuses: {at}, {value}: {error}")
    return fits


accepted, error, written = told(document)
check(accepted and validator.is_valid(document) and validator.is_valid(json.loads(written)), f"the corpus: {error}")
with ThreadPoolExecutor(4) as pool:
    fits = list(pool.map(agree, changes()))
print(f"schema: {sum(fits)} forms fit, {len(fits) - sum(fits)} do not, the reader agrees")
done()
