"""Finds the public declarations of a C++ header that have no comment.

A type needs its comment directly above it or on its first line; a type within a type is spoken for
by the outer one. Functions may share a comment: it covers the declarations that follow it without a
blank line. Constructors, operators, overrides and functions whose whole body stands on their line
need none. This reads our own layout (clang-format's), not all of C++.
"""
import re

TYPE = re.compile(r"\b(?:class|struct|union|enum(?:\s+class)?)\s+(\w+)[^()]*$")
FUNCTION = re.compile(r"([~\w]+)\s*\(")
NEEDS_NONE = re.compile(r"^(?:using|friend|typedef|static_assert|extern template|return)\b|\boperator\b"
                        r"|\boverride\b|=\s*(?:default|delete)\b")


class Line:
    """One line, its code and its comment told apart."""

    def __init__(self, text):
        text = re.sub(r'"(?:\\.|[^"\\])*"|\'(?:\\.|[^\'\\])+\'', '""', text)
        code, slashes, _ = text.partition("//")
        self.code = "" if code.lstrip().startswith("#") else code.strip()
        self.comment = bool(slashes)
        self.directive = code.lstrip().startswith("#")
        self.continued = text.rstrip().endswith("\\")


def lines_of(text):
    lines = [Line(line) for line in text.splitlines()]
    for before, line in zip(lines, lines[1:]):
        if before.directive and before.continued:
            line.code, line.directive = "", True
    return lines


def shares_a_comment(lines, start):
    """A comment stands above line `start` in the same paragraph of the same scope."""
    for line in reversed(lines[:start]):
        if line.comment:
            return True
        if not line.code or line.code.endswith("{") or line.code.endswith(":"):
            return False
    return False


class Scanner:
    """Walks the statements of a header, with the scopes they stand in."""

    def __init__(self, text):
        self.lines = lines_of(text)
        self.scopes = [{"kind": "namespace", "public": True, "name": ""}]
        self.bare = []  # (line number from 1, name)
        self.statement, self.start, self.ends_with = "", 0, ""

    def judge(self, end):
        """Notes the statement that ends on line `end` when it declares something without comment."""
        text = re.sub(r"<[^<>()]*(?:<[^<>]*>[^<>()]*)*>", "", self.statement)
        text = re.sub(r"\b(?:public|private|protected)\s*:(?!:)|\[\[.*?\]\]|\btemplate\b", "", text).strip()
        scope = self.scopes[-1]
        if not text or not scope["public"] or NEEDS_NONE.search(text):
            return
        commented = any(line.comment for line in self.lines[self.start:end + 1])
        kind = TYPE.search(text)
        if kind and scope["kind"] == "type":
            return
        if kind:
            above = self.start > 0 and self.lines[self.start - 1].comment
            if not (above or commented or text.endswith(kind.group(1)) and self.ends_with == ";"):
                self.bare.append((self.start + 1, kind.group(1)))
            return
        function = FUNCTION.search(text)
        if not function or "=" in text[:function.start()] or function.group(1).strip("~") == scope["name"]:
            return
        whole = self.ends_with == "{" and self.lines[end].code.endswith("}")
        if not (whole or commented or shares_a_comment(self.lines, self.start)):
            self.bare.append((self.start + 1, function.group(1)))

    def open(self):
        text = self.statement
        if re.search(r"\bnamespace\b|\bextern\s+\"", text):
            scope = {"kind": "namespace", "public": True, "name": ""}
        elif re.search(r"\b(?:class|struct|union)\s+\w+[^()=]*$", text) and "enum" not in text:
            name = TYPE.search(text)
            public = self.scopes[-1]["public"] and not re.search(r"\bclass\b", text)
            scope = {"kind": "type", "public": public, "name": name.group(1) if name else ""}
        else:
            scope = {"kind": "body", "public": False, "name": ""}
        self.scopes.append(scope)

    def take(self, char, number, depth):
        """One character of code outside parentheses that ends or continues a statement."""
        if char in ";{" and depth == 0:
            self.ends_with = char
            self.judge(number)
            if char == "{":
                self.open()
            self.statement = ""
        elif char == "}" and depth == 0:
            if len(self.scopes) > 1:
                self.scopes.pop()
            self.statement = ""
        else:
            if not self.statement.strip():
                self.start = number
            self.statement += char

    def run(self):
        depth = 0
        for number, line in enumerate(self.lines):
            access = re.match(r"(public|private|protected)\s*:(?!:)", line.code)
            if access and self.scopes[-1]["kind"] == "type":
                self.scopes[-1]["public"] = access.group(1) == "public"
                continue
            for char in line.code + " ":
                depth += (char == "(") - (char == ")")
                self.take(char, number, depth)
        return self.bare


def undocumented(text):
    """(line, name) of each public declaration in `text` that no comment covers."""
    return Scanner(text).run()
