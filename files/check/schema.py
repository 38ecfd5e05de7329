"""What is written fits the schema, and the schema and the reader refuse the same forms."""

import copy
import json
import os
import subprocess
import sys
import tempfile

from jsonschema import Draft202012Validator

CONVERT, HERE = sys.argv[1], os.path.dirname(os.path.abspath(__file__))
with open(os.path.join(HERE, "..", "symspline.schema.json")) as file:
    schema = json.load(file)
Draft202012Validator.check_schema(schema)
validator = Draft202012Validator(schema)
with open(os.path.join(HERE, "..", "tests", "corpus", "json", "all.json")) as file:
    document = json.load(file)


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
        for value in [None, True, "x", "1/0", "1/3", -1, 0.5, 2.0, 1e300, 9007199254740993, [], {}, [[]]]:
            yield at, value, changed(at, put(value))
        yield at, "deleted", changed(at, lambda node, key: node.pop(key))
        if isinstance(at[-1], str):
            yield at, "renamed", changed(at, lambda node, key: node.__setitem__(key + "x", node.pop(key)))
            yield at, "extra", changed(at, lambda node, key: node.__setitem__("extra", 1))


with tempfile.TemporaryDirectory() as folder:
    path, out = os.path.join(folder, "a.json"), os.path.join(folder, "b.json")

    def told(content):
        with open(path, "w") as file:
            json.dump(content, file)
        run = subprocess.run([CONVERT, path, out], capture_output=True, text=True)
        return run.returncode == 0, run.stderr

    accepted, _ = told(document)
    with open(out) as file:
        written = json.load(file)
    assert accepted and not list(validator.iter_errors(written)) and not list(validator.iter_errors(document))
    count = {True: 0, False: 0}
    for at, value, content in changes():
        fits = validator.is_valid(content)
        accepted, error = told(content)
        # What the schema cannot see is about values, not the form: the error is not one of syntax.
        is_value = not accepted and "Syntax" not in error
        assert accepted <= fits, ("the reader takes what the schema refuses", at, value)
        assert fits <= (accepted or is_value), ("the schema takes a form that the reader refuses", at, value, error)
        count[fits] += 1
print(f"schema: {count[True]} forms fit, {count[False]} do not, the reader agrees")
