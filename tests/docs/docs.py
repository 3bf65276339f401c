#!/usr/bin/env python3
"""What the documents say is done: every block of README.md, ARCHITECTURE.md and docs/*.md is tried.

Usage: docs.py PARTI [FILE…]     PARTI: the built program. Exit status 1 when a block does not hold.

  ```sh       run by bash in an empty folder per document, `parti` on the PATH, assets/ beside it,
              each block after the ones above it; it must exit 0. `# exits 1` on its first line: 1.
  ```text     directly after it: what it printed; … stands for anything
  ```cga      rules or selection-action trees (docs/language.md): parti must read them, and where they are
              whole, with trees or a rule for Lot or with @StartRule, derive them in each of their styles on
              the lot in their first line, `// lot: rect(12,8)`, or else on rect(20,14)
  ```pen      a drawing: parti must replay it
  ```json     one JSON value, or one a line
  ```console  for reading only (it installs, builds, or needs a device), but programs of this
              repository that it names must exist
Blocks without a language are pictures. Links must lead to files, `folder/path` to what is there (NAME
stands for any), and `folder::Name` to a word in a header of that folder.
"""
import json
import os
import pathlib
import re
import subprocess
import sys
import tempfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
BLOCK = re.compile(r"^```(\w*)[^\n]*\n(.*?)^```$", re.MULTILINE | re.DOTALL)
WHOLE = re.compile(r"^(?:tree\b|Lot\s*(?:-->|->|→)|@StartRule\b)", re.MULTILINE)
STYLE = re.compile(r"^style (\w+)", re.MULTILINE)
LOT = re.compile(r"// lot: (.*)")
LINK = re.compile(r"\]\(([^)#\s]+)[^)]*\)")
SCRIPT = re.compile(r"(?:^|[\s;&|])\./([\w./-]+)")
FOLDERS = "app|base|grammar|input|render|sketch"
PATH = re.compile(rf"`((?:{FOLDERS}|assets|cmake|docs|tests|\.ci)/[\w./-]*)")
NAME = re.compile(rf"`({FOLDERS})::([\w:]+)")
SECONDS = 300


def blank(block):
    """As many empty lines as the block has."""
    return "\n" * block.group().count("\n")


class Document:
    """One file, tried in one temporary folder."""

    def __init__(self, path, parti, folder):
        self.path, self.parti, self.folder = path, parti, pathlib.Path(folder)
        self.printed = None
        (self.folder / "assets").symlink_to(ROOT / "assets")
        self.environment = {**os.environ, "PATH": f"{parti.parent}:{os.environ['PATH']}", "LC_ALL": "C.UTF-8"}

    def run(self, arguments):
        return subprocess.run(arguments, cwd=self.folder, env=self.environment, text=True, timeout=SECONDS,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
                              check=False)

    def try_sh(self, text):
        wanted = 1 if text.startswith("# exits 1\n") else 0
        done = self.run(["bash", "-euo", "pipefail", "-c", text])
        self.printed = done.stdout
        return "" if done.returncode == wanted else f"exit status {done.returncode}\n{done.stdout}"

    def try_text(self, text):
        if self.printed is None:
            return "no sh block stands before this output"
        pattern = ".*".join(re.escape(part) for part in text.strip().split("…"))
        holds = re.fullmatch(pattern, self.printed.strip(), re.DOTALL)
        return "" if holds else f"it printed\n{self.printed}"

    def try_cga(self, text):
        (self.folder / "block.cga").write_text(text, encoding="utf-8")
        lot = LOT.match(text)
        tries = [["check", "block.cga"]]
        if WHOLE.search(text):
            derive = ["derive", "block.cga", "--lot", lot[1] if lot else "rect(20,14)"]
            tries += [derive + ["--export", "read.cga"], *(derive + ["--style", name] for name in STYLE.findall(text))]
        for arguments in tries:
            done = self.run([str(self.parti), *arguments])
            if done.returncode:
                return f"parti {' '.join(arguments)}: exit status {done.returncode}\n{done.stdout}"
        return ""

    def try_pen(self, text):
        (self.folder / "block.pen").write_text(text, encoding="utf-8")
        done = self.run([str(self.parti), "replay", "block.pen", "--json"])
        return "" if done.returncode == 0 else f"exit status {done.returncode}\n{done.stdout}"

    def try_json(self, text):
        try:
            json.loads(text)
        except json.JSONDecodeError:
            for line in text.strip().splitlines():
                json.loads(line)
        return ""

    def try_console(self, text):
        missing = [name for name in SCRIPT.findall(text) if not os.access(ROOT / name, os.X_OK)]
        return f"no such program: {missing}" if missing else ""

    def try_block(self, language, text):
        try:
            attempt = getattr(self, f"try_{language}", None)
            return attempt(text) if attempt else f"a block of an unknown language: {language}"
        except (ValueError, subprocess.TimeoutExpired) as error:
            return str(error)

    def problems(self):
        """(line, what) for each block and link that does not hold."""
        text = self.path.read_text(encoding="utf-8")
        end = 0
        for block in BLOCK.finditer(text):
            language, code = block.groups()
            if text[end:block.start()].strip():
                self.printed = None
            problem = self.try_block(language, code) if language else ""
            if problem:
                yield text.count("\n", 0, block.start()) + 1, problem.strip()
            end = block.end()
        for number, line in enumerate(BLOCK.sub(blank, text).splitlines(), 1):
            yield from ((number, problem) for problem in self.line_problems(line))

    def line_problems(self, line):
        """What one line of prose names and is not there."""
        for link in LINK.findall(line):
            if "://" not in link and not (self.path.parent / link).exists():
                yield f"a link to nowhere: {link}"
        for name in PATH.findall(line):
            if not next(ROOT.glob(name.rstrip("/").replace("NAME", "*")), None):
                yield f"no such file: {name}"
        for folder, name in NAME.findall(line):
            words = re.compile(r".*".join(rf"\b{part}\b" for part in name.split("::")), re.DOTALL)
            if not any(words.search(header.read_text(encoding="utf-8")) for header in (ROOT / folder).rglob("*.h")):
                yield f"no such name: {folder}::{name}"


def uncited_errata():
    """Errata that the source cites by number, and docs/errata.md does not have."""
    listed = set(re.findall(r"^(\d+a?)\.", (ROOT / "docs/errata.md").read_text(encoding="utf-8"), re.MULTILINE))
    for source in sorted(path for folder in FOLDERS.split("|") for path in (ROOT / folder).rglob("*.[hc]*")):
        for cited in re.findall(r"\berrata ((?:\d+a?(?:, | and | to )?)+)", source.read_text(encoding="utf-8")):
            for number in re.findall(r"\d+a?", cited):
                if number not in listed:
                    yield f"{source.relative_to(ROOT)} cites errata {number}, which docs/errata.md does not have"


def try_file(path, parti):
    with tempfile.TemporaryDirectory() as folder:
        return list(Document(path, parti, folder).problems())


def main():
    parti = pathlib.Path(sys.argv[1]).resolve()
    files = [pathlib.Path(name) for name in sys.argv[2:]]
    files = files or [ROOT / "README.md", ROOT / "ARCHITECTURE.md", *sorted((ROOT / "docs").glob("*.md"))]
    failed = 0
    for path in files:
        for line, problem in try_file(path, parti):
            failed += 1
            print(f"{os.path.relpath(path, ROOT)}:{line}: {problem}")
    for problem in uncited_errata():
        failed += 1
        print(problem)
    print(f"docs: {len(files)} documents, {failed} problems")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
