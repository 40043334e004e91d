#!/usr/bin/env python3
"""Checks that every folder includes and links only what docs/architecture.md allows it.

The page has two tables. The first ("folder | may include") gives each folder the folders that it may include; `a/*`
stands for every folder below a, and a folder may always include itself. The second ("library | known by | may be named
in") gives each outside library the spellings that name it in sources and CMake lists, and the folders that may do so.

usage: layering.py [ROOT]      prints one line a violation (file:line: what), exits with 1 if there is any
"""

import re
import sys
from pathlib import Path

TOP_FOLDERS = ("engine", "kernels", "surface", "io", "pipeline", "tests", "bench")
INCLUDE = re.compile(r'^\s*#\s*include\s*(["<])([^">]+)[">]')
LIBRARY_CALL = re.compile(r"quarry_(?:library|test|bench)\s*\(\s*(\w+)([^)]*)\)")
LINK = re.compile(r"quarry::(\w+)")


def table_rows(text, first_header):
    """The rows below the header line that starts with `| first_header`, as lists of stripped cells."""
    rows, inside = [], False
    for line in text.splitlines():
        cells = [cell.strip() for cell in line.strip().strip("|").split("|")]
        if line.startswith("|") and cells[0] == first_header:
            inside = True
        elif inside and not line.startswith("|"):
            break
        elif inside and not set(line) <= set("|- :"):
            rows.append(cells)
    if not rows:
        raise SystemExit(f"docs/architecture.md has no table whose first column is '{first_header}'")
    return rows


def split_list(cell):
    return [item.strip() for item in cell.split(",") if item.strip() not in ("", "-")]


def covers(entry, folder):
    """Whether a table entry names the folder: itself, one above it, or by `a/*` one below a."""
    if entry.endswith("/*"):
        return folder.startswith(entry[:-1])
    return folder == entry or folder.startswith(entry + "/")


class Rules:
    def __init__(self, page):
        self.allowed = {}
        for folders, targets in table_rows(page, "folder"):
            for folder in split_list(folders):
                self.allowed[folder] = split_list(targets)
        self.libraries = [
            (name, re.findall(r"`([^`]+)`", spellings), split_list(places))
            for name, spellings, places in table_rows(page, "library")
        ]

    def row_of(self, folder):
        """The most specific row for a folder: its own, then the longest that covers it."""
        rows = [row for row in self.allowed if covers(row, folder)]
        return max(rows, key=lambda row: (row == folder, len(row)), default=None)

    def may_include(self, folder, target):
        row = self.row_of(folder)
        return target == folder or any(covers(entry, target) for entry in self.allowed[row])


def strip_comments(text, marker):
    """The text with comments blanked, lines kept. Good enough for sources without the marker inside strings."""
    if marker == "//":
        text = re.sub(r"/\*.*?\*/", lambda found: re.sub(r"[^\n]", " ", found.group()), text, flags=re.S)
    return re.sub(re.escape(marker) + r"[^\n]*", "", text)


def project_files(root, *patterns):
    for top in TOP_FOLDERS:
        for pattern in patterns:
            yield from sorted((root / top).rglob(pattern))


def check_libraries(rules, folder, place, lines):
    for number, line in enumerate(lines, 1):
        for name, spellings, places in rules.libraries:
            if any(s in line for s in spellings) and not any(covers(entry, folder) for entry in places):
                yield f"{place}:{number}: {name} may be named in {', '.join(places)} only: {line.strip()}"


def check_source(rules, root, path):
    place, folder = path.relative_to(root), path.parent.relative_to(root).as_posix()
    if rules.row_of(folder) is None:
        yield f"{place}:1: docs/architecture.md has no row for the folder {folder}"
        return
    lines = strip_comments(path.read_text(encoding="utf-8"), "//").splitlines()
    for number, line in enumerate(lines, 1):
        found = INCLUDE.match(line)
        if not found or found.group(2).split("/")[0] not in TOP_FOLDERS:
            if found and found.group(1) == '"':
                yield f"{place}:{number}: project files are included from the root of the project: {line.strip()}"
            continue
        target = Path(found.group(2)).parent.as_posix()
        if not rules.may_include(folder, target):
            yield f"{place}:{number}: {folder} may not include {target}: {line.strip()}"
    yield from check_libraries(rules, folder, place, lines)


def library_folders(root):
    """Which folder holds each quarry_library; `engine` and the like stand for a whole top folder."""
    folders = {top: top for top in TOP_FOLDERS}
    for path in project_files(root, "CMakeLists.txt"):
        for name, _ in LIBRARY_CALL.findall(strip_comments(path.read_text(encoding="utf-8"), "#")):
            folders[name] = path.parent.relative_to(root).as_posix()
    return folders


def check_lists(rules, root, path, folders):
    place, folder = path.relative_to(root), path.parent.relative_to(root).as_posix()
    text = strip_comments(path.read_text(encoding="utf-8"), "#")
    for call in LIBRARY_CALL.finditer(text):
        for link in LINK.finditer(call.group(2)):
            number = text.count("\n", 0, call.start(2) + link.start()) + 1
            target = folders.get(link.group(1))
            if target is None:
                yield f"{place}:{number}: no folder has the target {link.group()}"
            elif rules.row_of(folder) is None:
                yield f"{place}:{number}: docs/architecture.md has no row for the folder {folder}"
            elif not rules.may_include(folder, target):
                yield f"{place}:{number}: {folder} may not link {link.group()}"
    yield from check_libraries(rules, folder, place, text.splitlines())


def violations(root):
    rules = Rules((root / "docs" / "architecture.md").read_text(encoding="utf-8"))
    folders = library_folders(root)
    for path in project_files(root, "*.hpp", "*.cpp"):
        yield from check_source(rules, root, path)
    for path in project_files(root, "CMakeLists.txt"):
        yield from check_lists(rules, root, path, folders)


def main():
    root = Path(sys.argv[1] if len(sys.argv) > 1 else Path(__file__).parents[2]).resolve()
    found = list(violations(root))
    print("\n".join(found + [f"layering: {len(found)} violations"]))
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
