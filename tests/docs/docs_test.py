"""Documents that don't tell the truth are found out."""
import pathlib
import stat
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
import docs  # noqa: E402

# Stands for the program: reads only files that hold "good", derives only on lots and in styles that are in them.
PARTI = """#!/bin/sh
[ "$1" = say ] && { echo "$2"; exit 0; }
grep -q good "$2" || exit 1
[ "$1" = derive ] || exit 0
file="$2"
grep -qF "$4" "$file" || exit 1
[ "$5" = --style ] && { [ "$6" = Brick ] || exit 1; }
exit 0
"""


class Documents(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.parti = pathlib.Path(self.folder.name, "parti")
        self.parti.write_text(PARTI, encoding="utf-8")
        self.parti.chmod(self.parti.stat().st_mode | stat.S_IXUSR)

    def lines(self, text):
        path = pathlib.Path(self.folder.name, "a.md")
        path.write_text(text, encoding="utf-8")
        return [line for line, _ in docs.try_file(path, self.parti)]

    def test_a_shell_line_that_fails_is_found(self):
        self.assertEqual(self.lines("# A\n```sh\nfalse\n```\n"), [2])
        self.assertEqual(self.lines("```sh\nparti say hello\nls assets >list\n```\n```sh\ntest -s list\n```\n"), [])
        self.assertEqual(self.lines("```sh\nfalse | true\n```\n"), [1])
        self.assertEqual(self.lines("```sh\n# exits 1\nfalse\n```\n```sh\n# exits 1\ntrue\n```\n"), [5])

    def test_output_that_differs_is_found(self):
        block = "```sh\nparti say 'hello 12 houses'\n```\n"
        self.assertEqual(self.lines(block + "prints\n```text\nhello … houses\n```\n"), [5])
        self.assertEqual(self.lines(block + "```text\nhello … houses\n```\n"), [])
        self.assertEqual(self.lines(block + "```text\nhello … trees\n```\n"), [4])

    def test_rules_and_drawings_that_are_not_read_are_found(self):
        self.assertEqual(self.lines("```cga\ngood\n```\n```cga\nbad\n```\n"), [4])
        self.assertEqual(self.lines("```pen\nbad\n```\n```pen\ngood\n```\n"), [1])

    def test_whole_rules_are_derived_on_their_lot_and_in_their_styles(self):
        block = "```cga\n// lot: rect(1,2)\n// good\nLot --> A\n```\n"
        self.assertEqual(self.lines(block), [])
        self.assertEqual(self.lines(block.replace("// lot", "// log")), [1], "its lot is rect(20,14)")
        self.assertEqual(self.lines(block.replace("Lot -->", "Mass -->").replace("// lot", "// log")), [], "not whole")
        self.assertEqual(self.lines(block.replace("Lot --> A", "Lot --> A\nstyle Brick\n")), [])
        self.assertEqual(self.lines(block.replace("Lot --> A", "Lot --> A\nstyle Brick\nstyle Other\n")), [1])
        self.assertEqual(self.lines(block.replace("Lot --> A", "@StartRule\nHouse --> A")), [])

    def test_text_that_is_not_json_is_found(self):
        self.assertEqual(self.lines('```json\n{"a": 1}\n{"b": 2}\n```\n```json\n{a}\n```\n'), [5])

    def test_names_and_paths_that_do_not_exist_are_found(self):
        self.assertEqual(self.lines("`base::Camera` and `base::View::Project`, `base/camera.h`, `base/NAME.h`\n"), [])
        self.assertEqual(self.lines("`base::Kamera`\n\n`base/kamera.h`\n`grammar::Camera`\n"), [1, 3, 4])
        self.assertEqual(self.lines("```\n`base::Kamera`\n```\n`base::Kamera`\n"), [4])

    def test_programs_links_and_languages_that_do_not_exist_are_found(self):
        self.assertEqual(self.lines("```console\n./run --build\n./no-such-script\n```\n"), [1])
        self.assertEqual(self.lines("```cobol\nADD 1\n```\n"), [1])
        self.assertEqual(self.lines("see [this](nowhere.md) and [that](https://example.org) and [a](a.md)\n"), [1])
        self.assertEqual(self.lines("```\na picture\n```\n"), [])


if __name__ == "__main__":
    unittest.main()
