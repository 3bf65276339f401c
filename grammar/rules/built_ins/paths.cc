// fileName, fileExtension …: parts of the path of a file. No file is looked at.
#include "grammar/rules/built_ins/tables.h"

namespace parti::grammar::built_ins {
namespace {

/// After the last slash.
std::string NameOf(const std::string& path) {
  const size_t slash = path.find_last_of("/\\");
  return slash == std::string::npos ? path : path.substr(slash + 1);
}

constexpr auto kOne = First(kTexts, 1);

constexpr BuiltIn kRows[] = {
    {"fileName", kOne, kText, "the name of a file without its folders: \"a/b.png\" is \"b.png\"",
     [](Values values, const Situation&) -> Value { return NameOf(TextOf(values[0])); }},
    {"fileBasename", kOne, kText, "its name without folders and ending",
     [](Values values, const Situation&) -> Value {
       const std::string name = NameOf(TextOf(values[0]));
       return name.substr(0, name.rfind('.'));
     }},
    {"fileExtension", kOne, kText, "its ending with the dot; \"\" without one",
     [](Values values, const Situation&) -> Value {
       const std::string name = NameOf(TextOf(values[0]));
       const size_t dot = name.rfind('.');
       return dot == std::string::npos ? std::string() : name.substr(dot);
     }},
    {"fileDirectory", kOne, kText, "its folders, with the last slash",
     [](Values values, const Situation&) -> Value {
       const std::string path = TextOf(values[0]);
       return path.substr(0, path.size() - NameOf(path).size());
     }},
};

}  // namespace

std::span<const BuiltIn> Paths() { return kRows; }

}  // namespace parti::grammar::built_ins
