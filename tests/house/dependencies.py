"""Holds the directions of dependency: cli -> everything, readers and devices -> core, emulators ->
nothing of ours. Reads the #include lines of every room and names each one that points the wrong way.

usage: dependencies.py ROOT        exit 0: all point the right way, 1: some do not, 2: no such house
"""

import re
import sys
from pathlib import Path

# Room: the rooms its files may include. A file belongs to the first room whose path begins its own.
ROOMS = {
    "core": ("core",),
    "scenes/readers": ("core", "scenes/readers"),
    "devices": ("core", "devices"),
    "emulators": ("emulators",),
    "cli": ("core", "scenes/readers", "devices", "emulators", "cli"),
}
# Core opens no files and prints nothing; the rest of the libraries print nothing.
BANNED_HEADERS = {
    "core": {"iostream", "fstream", "cstdio", "stdio.h", "unistd.h", "fcntl.h"},
    "scenes/readers": {"iostream"},
    "devices": {"iostream"},
    "emulators": {"iostream"},
}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^">]+)[">]')
SOURCES = {".h", ".cpp", ".inc"}


def is_under(path, room):
    return path == room or path.startswith(room + "/")


def complaint(room, bracket, included, is_test):
    """Why this include may not stand in the room, or None."""
    if any(is_under(included, known) for known in ROOMS):
        if not any(is_under(included, allowed) for allowed in ROOMS[room]):
            return f"{room} may not depend on {included}"
        return None
    if bracket == '"':
        return f'"{included}" is not included by its path from the root'
    if not is_test and included in BANNED_HEADERS.get(room, ()):
        return f"{room} may not use <{included}>"
    return None


def violations(root):
    """(file, line, why) for every include that points the wrong way."""
    for room in ROOMS:
        for path in sorted((root / room).rglob("*")):
            if path.suffix not in SOURCES:
                continue
            is_test = path.stem.endswith("_test")
            for number, line in enumerate(path.read_text(errors="replace").splitlines(), 1):
                match = INCLUDE.match(line)
                why = match and complaint(room, match[1], match[2], is_test)
                if why:
                    yield path.relative_to(root), number, why


def main(arguments):
    if len(arguments) != 1 or not (Path(arguments[0]) / "core").is_dir():
        print(__doc__, file=sys.stderr)
        return 2
    found = list(violations(Path(arguments[0])))
    for path, line, why in found:
        print(f"{path}:{line}: error: {why}", file=sys.stderr)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
