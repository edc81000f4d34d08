"""Validates scene files, and the ```yaml blocks of Markdown pages, against the JSON Schema.

Usage: validate.py SCHEMA FILE...   Exit status 1 if any file does not follow the schema, or if
there is nothing to validate.
"""
import json
import re
import sys

import jsonschema
import yaml


def documents(name):
    """(where, text) of each scene in a file."""
    with open(name, encoding="utf-8") as file:
        text = file.read()
    if not name.endswith(".md"):
        return [(name, text)]
    blocks = re.finditer(r"^```yaml\n(.*?)^```", text, re.M | re.S)
    return [(f"{name}:{text.count(chr(10), 0, b.start()) + 1}", b.group(1)) for b in blocks]


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        schema = json.load(file)
    jsonschema.Draft7Validator.check_schema(schema)
    validator = jsonschema.Draft7Validator(schema)
    count = failures = 0
    for name in sys.argv[2:]:
        found = documents(name)
        if not found:
            print(f"{name}: no scene in it")
            failures += 1
        for where, text in found:
            count += 1
            for error in validator.iter_errors(yaml.safe_load(text)):
                print(f"{where}: {'/'.join(map(str, error.absolute_path))}: {error.message[:300]}")
                failures += 1
    print(f"{count} scenes, {failures} errors")
    return 1 if failures or not count else 0


sys.exit(main())
