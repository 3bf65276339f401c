#!/usr/bin/env python3
"""The house guards itself: include arrows, headers with contracts, no unfinished words, no machine's paths.

Usage: house.py [ROOT]     Prints FILE:LINE: what is wrong; exit status 1 when anything is.
The arrows are those of ARCHITECTURE.md. Layout and naming are clang-format's and clang-tidy's business.
"""
import pathlib
import re
import sys

from header import undocumented

ARROWS = {
    "base": {"base"},
    "input": {"input", "base"},
    "grammar": {"grammar", "base"},
    "sketch": {"sketch", "grammar", "base"},
    "render": {"render", "base"},
    "app": {"app", "render", "sketch", "grammar", "input", "base"},
    "tests": {"tests", "app", "render", "sketch", "grammar", "input", "base"},
}
FOLDERS = [*ARROWS, "assets", "cmake", "docs", ".ci"]
NOT_OURS = {"LICENSE", ".git", "compile_commands.json"}
INCLUDE = re.compile(r'^\s*#\s*include\s+"([^"]+)"')
# In pieces, so that this file does not break its own rules.
UNFINISHED = re.compile(r"\b(?:TO" r"DO|FIX" r"ME|XX" r"X|HA" r"CK|[Ss]tub(?:bed|s)?)\b")
MACHINE_PATH = re.compile(r"(?<![\w.$}/])/(?:home|root|work|farm|Users|tmp|mnt|media)/(?=\w)")
OPENING_LINES = range(2, 8)  # what for; source; what not. A test's helper may do with one.


def arrow_problems(path, lines):
    """Includes that ARROWS does not allow; `path` is relative to the root."""
    for number, line in enumerate(lines, 1):
        included = INCLUDE.match(line)
        if not included:
            continue
        folder = included.group(1).split("/")[0]
        if folder not in ARROWS or "/" not in included.group(1):
            yield number, f'include "{included.group(1)}" is not named from the root'
        elif folder not in ARROWS[path.parts[0]]:
            yield number, f"{path.parts[0]} must not include {folder} (see ARCHITECTURE.md)"


def opening_problems(path, root, lines):
    """A header opens with 2-7 lines of comment, a source without a header with at least one."""
    opening = next((i for i, line in enumerate(lines) if not line.startswith("//")), len(lines))
    in_tests = path.parts[0] == "tests"
    if path.suffix == ".h" and opening not in OPENING_LINES and not (in_tests and opening == 1):
        yield 1, f"the header opens with {opening} lines of comment, not 2 to 7 (what for, source, what not)"
    alone = path.suffix == ".cc" and not (root / path).with_suffix(".h").exists()
    if alone and not in_tests and opening == 0:
        yield 1, "a source without a header opens with a comment that says what it is for"


def word_problems(lines):
    for number, line in enumerate(lines, 1):
        unfinished = UNFINISHED.search(line)
        if unfinished:
            yield number, f"unfinished: {unfinished.group()}"
        if MACHINE_PATH.search(line):
            yield number, "a path of one machine"


def problems(root):
    """(path, line, what) for everything that breaks a rule under `root`, in order of path."""
    files = [p for f in FOLDERS for p in (root / f).rglob("*") if p.is_file()]
    files += [p for p in root.iterdir() if p.is_file() and p.name not in NOT_OURS]
    for file in sorted(files):
        path = file.relative_to(root)
        if "corpus" in path.parts or "__pycache__" in path.parts:
            continue
        try:
            text = file.read_text(encoding="utf-8")
        except UnicodeDecodeError:
            continue  # a picture
        lines = text.splitlines()
        found = list(word_problems(lines))
        if path.suffix in (".h", ".cc") and path.parts[0] in ARROWS:
            found += arrow_problems(path, lines)
            found += opening_problems(path, root, lines)
        if path.suffix == ".h" and path.parts[0] != "tests":
            found += [(n, f"{name} has no comment") for n, name in undocumented(text)]
        yield from ((path, number, what) for number, what in sorted(found))


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parents[2]).resolve()
    found = list(problems(root))
    for path, number, what in found:
        print(f"{path}:{number}: {what}")
    print(f"house: {len(found)} problems")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
