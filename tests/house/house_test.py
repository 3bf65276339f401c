"""Plants one violation of each rule in a small tree, and near misses, and wants exactly the former."""
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).parent))
from header import undocumented  # noqa: E402
from house import problems  # noqa: E402

OPENING = "// What it is for.\n// What it is not for.\n#pragma once\n"


class PlantedViolations(unittest.TestCase):
    def found(self, files):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            for name, text in files.items():
                (root / name).parent.mkdir(parents=True, exist_ok=True)
                (root / name).write_text(text, encoding="utf-8")
            return [(str(path), line) for path, line, _ in problems(root)]

    def test_an_include_against_the_arrows_is_found(self):
        source = "// Opening.\n#include <app/x>\n"
        self.assertEqual(self.found({
            "grammar/a.cc": source + '#include "sketch/x.h"\n',
            "sketch/b.cc": source + '#include "grammar/x.h"\n#include "render/x.h"\n',
            "base/c.cc": source + '#include "input/x.h"\n',
            "render/d.cc": source + '#include "app/x.h"\n',
            "app/e.cc": source + '#include "tests/support/x.h"\n#include "sketch/x.h"\n',
            "tests/f_test.cc": source + '#include "app/x.h"\n',
        }), [("app/e.cc", 3), ("base/c.cc", 3), ("grammar/a.cc", 3), ("render/d.cc", 3), ("sketch/b.cc", 4)])

    def test_an_include_that_is_not_named_from_the_root_is_found(self):
        self.assertEqual(self.found({"base/a.cc": '// Opening.\n#include "a.h"\n#include "../b/c.h"\n'}),
                         [("base/a.cc", 2), ("base/a.cc", 3)])

    def test_a_header_without_its_opening_lines_is_found(self):
        self.assertEqual(self.found({"base/a.h": "#pragma once\n", "base/b.h": "// One line.\n#pragma once\n",
                                     "base/c.h": OPENING, "base/c.cc": '#include "base/c.h"\n',
                                     "app/main.cc": "int main() {}\n"}),
                         [("app/main.cc", 1), ("base/a.h", 1), ("base/b.h", 1)])

    def test_unfinished_words_are_found_wherever_they_stand(self):
        word = "TO" + "DO"
        self.assertEqual(self.found({"docs/a.md": f"Fine.\n{word}: more\nmethodology, stubborn, XXXL\n",
                                     "run": "# FIX" + "ME\n", "render/b.cc": "// A st" + "ub.\n"}),
                         [("docs/a.md", 2), ("render/b.cc", 1), ("run", 1)])

    def test_a_path_of_one_machine_is_found(self):
        home = "/ho" + "me/"
        self.assertEqual(self.found({"docs/a.md": f"see {home}me/x\nsee docs{home}x, /usr/share, /dev/full\n"}),
                         [("docs/a.md", 1)])

    def test_pictures_and_fuzz_inputs_are_passed_over(self):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "tests/fuzz/corpus/a").mkdir(parents=True)
            (root / "tests/fuzz/corpus/a/1").write_text("XX" + "X", encoding="utf-8")
            (root / "docs").mkdir()
            (root / "docs/house.png").write_bytes(b"\x89PNG\r\n\x1a\n\xff")
            self.assertEqual(list(problems(root)), [])


class UndocumentedDeclarations(unittest.TestCase):
    def names(self, text):
        return [name for _, name in undocumented(OPENING + "namespace parti {\n" + text + "\n}  // namespace\n")]

    def test_functions_and_types_without_comment_are_named(self):
        self.assertEqual(self.names("int F(int a);\n\nstruct S {\n  int a = G(1);\n};\n\nenum class E { kA };\n"),
                         ["F", "S", "E"])
        self.assertEqual(self.names("Result<std::vector<int>> Long(const A& a,\n     const B& b = {});\n"), ["Long"])
        self.assertEqual(self.names("template <typename T>\nT Max(T a,\n      T b) {\n  return a;\n}\n"), ["Max"])

    def test_a_comment_covers_its_paragraph_and_no_more(self):
        self.assertEqual(self.names("/// Both.\nint F();\nint G();\nint T();  // trailing\n\nint H();\n"), ["H"])
        self.assertEqual(self.names("/// S.\nstruct S {\n  int F();\n};\n"), ["F"])

    def test_what_speaks_for_itself_needs_none(self):
        self.assertEqual(self.names("struct Forward;\nusing A = B<C(D)>;\n\n/// S.\nclass S {\n public:\n"
                                    "  S(int a);\n  ~S();\n  int a() const { return a_; }\n  bool operator==(S);\n"
                                    "  enum class Kind { kA };\n  void Draw() override;\n"
                                    " private:\n  int Hidden();\n  int a_;\n};\n"), [])

    def test_variables_are_not_functions(self):
        self.assertEqual(self.names('inline constexpr double kA = Half(2);\nA b{C(1), D("(")};\n'), [])

    def test_macros_are_passed_over(self):
        self.assertEqual(self.names("#define F(x) \\\n  int G(x) { \\\n  }\n"), [])


if __name__ == "__main__":
    unittest.main()
