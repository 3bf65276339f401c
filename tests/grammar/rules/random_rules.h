// Random rule files as text, which the parser and the checker accept: a rapidcheck generator.
// Rules never refer to themselves or to earlier ones, so that deriving them ends.
#pragma once

#include <fmt/format.h>
#include <rapidcheck.h>

#include <string>
#include <vector>

#include "base/random.h"

namespace parti::grammar::tests {

/// Writes a file with attributes, functions and rules that use each other: the same for a seed.
class RandomRules {
 public:
  explicit RandomRules(uint64_t seed) : random_(seed) {}

  std::string Text() {
    std::string text;
    if (Chance(3)) text += "version \"2019.0\"\n";
    for (int i = 0; i < kAttributes; ++i) {
      if (Chance(2)) text += Annotations();
      text += fmt::format("{} n{} = {}\n", Chance(4) ? "const" : "attr", i, Value(0));
      attributes_ = i + 1;
    }
    text += fmt::format("attr flag = {}\nattr name = {}\n", Truth(0), Words(0));
    has_words_ = true;
    text += fmt::format("area(w, h) = w * h + {}\nhalf = {}\n", Number(0), Value(0));
    has_functions_ = true;
    const int rules = Count(1, 5);
    for (int i = 0; i < rules; ++i) {
      next_rule_ = i + 1;
      rules_ = rules;
      text += Chance(6) ? "@StartRule " : "";
      text += fmt::format("R{}(x) --> {}{}\n", i, Body(0), Chance(5) ? ";" : "");
    }
    next_rule_ = 0;  // Lot has no parameter
    return text + fmt::format("Lot --> R0({})\n", Number(0));
  }

 private:
  static constexpr int kAttributes = 3;
  static constexpr int kDeepest = 3;

  /// From `low`, below `high`.
  int Count(int low, int high) { return low + static_cast<int>(random_.Uniform() * (high - low)); }
  bool Chance(int of) { return Count(0, of) == 0; }
  std::string OneOf(const std::vector<std::string>& texts) {
    return texts[static_cast<size_t>(Count(0, static_cast<int>(texts.size())))];
  }
  std::string Literal() { return OneOf({"0", "1", "2.5", "-3", ".25", "1e3", "0.1", "12"}); }

  std::string Annotations() {
    return OneOf({"@Range(0, 5)\n", "@Range(min=1, stepsize=0.5)\n", "@Group(\"a\", 2) @Order(3) ",
                  "@Hidden @Distance\n", "@Enum(1, 2, -3) @Description(\"\\\"x\\\"\")\n"});
  }

  std::string Number(int depth) {
    if (depth >= kDeepest || Chance(3)) return Chance(2) || attributes_ == 0 ? Literal() : Named();
    const std::string a = Number(depth + 1), b = Number(depth + 1);
    switch (Count(0, has_functions_ ? 9 : 7)) {
      case 0:
        return fmt::format("{} + {}", a, b);
      case 1:
        return fmt::format("({}) * ({})", a, b);
      case 2:
        return fmt::format("{} - ({})", a, b);
      case 3:
        return fmt::format("-({})", a);
      case 4:
        return fmt::format("min({}, {})", a, b);
      case 5:
        return fmt::format("({}) % ({})", a, b);
      case 6:
        return fmt::format("(case {}: {} else: {})", Truth(depth + 1), a, b);
      case 7:
        return fmt::format("area({}, {})", a, b);
      default:
        return "half";
    }
  }

  std::string Named() {
    if (next_rule_ > 0 && Chance(3)) return OneOf({"x", "scope.sy", "split.index"});
    return fmt::format("n{}", Count(0, attributes_));
  }

  std::string Truth(int depth) {
    if (depth >= kDeepest || Chance(3)) return has_words_ && Chance(3) ? "flag" : "true";
    switch (Count(0, 4)) {
      case 0:
        return fmt::format("{} <= {}", Number(depth + 1), Number(depth + 1));
      case 1:
        return fmt::format("({} && !({}))", Truth(depth + 1), Truth(depth + 1));
      case 2:
        return fmt::format("({} || {})", Truth(depth + 1), Truth(depth + 1));
      default:
        return fmt::format("{} == {}", Words(depth + 1), Words(depth + 1));
    }
  }

  std::string Words(int depth) {
    if (depth >= kDeepest || Chance(2)) {
      return has_words_ && Chance(3) ? "name" : OneOf({"\"a\"", "\"\\n\""});
    }
    return fmt::format("{} + ({})", Words(depth + 1), Number(depth + 1));
  }

  std::string Value(int depth) {
    if (Chance(4))
      return fmt::format("case {}: {} else: {}", Truth(0), Value(depth + 1), Number(0));
    if (Chance(5)) return fmt::format("25%: {} 70%: {} else: {}", Number(0), Number(0), Number(0));
    return Number(depth);
  }

  std::string Body(int depth) {
    if (depth < kDeepest && Chance(5)) {
      return fmt::format("case {}: {} else: {}", Truth(1), Chosen(depth), Chosen(depth));
    }
    if (depth < kDeepest && Chance(6)) {
      // Within a case the chance needs an else of its own.
      return fmt::format("20%: {} 80%: {}{}", Chosen(depth), Chosen(depth),
                         depth == 0 ? "" : " else: NIL");
    }
    std::string text;
    for (int i = Count(0, 4); i > 0; --i) text += Step(depth) + " ";
    return text;
  }

  std::string Chosen(int depth) {
    const std::string body = Body(depth + 1);
    return body.empty() ? "[ ]" : body;
  }

  std::string Step(int depth) {
    switch (Count(0, depth < kDeepest ? 9 : 6)) {
      case 0:
        return fmt::format("extrude({})", Chance(2) ? "3" : Named());
      case 1:
        return "color(\"#a0b0c0\")";
      case 2:
        return fmt::format("tag({})", Chance(2) ? "\"t\"" : "\"t\" + name");
      case 3:
        return fmt::format("[ {} ]", Symbol());
      case 4:
        return fmt::format("set(flag, {})", Truth(1));
      case 5:
        return Symbol();
      case 6:
        return fmt::format("split({}) {}{}", OneOf({"x", "\"y\"", "Z"}), Braces(depth + 1),
                           Chance(2) ? "*" : "");
      case 7:
        return fmt::format("comp(f) {{ side: {} | 0: {} }}", Body(depth + 1), Symbol());
      default:
        return fmt::format("split(x, 2, ~{}) {{ {} | {} }}", Literal(), Symbol(), Body(kDeepest));
    }
  }

  std::string Symbol() {
    if (next_rule_ < rules_ && Chance(2)) {
      return fmt::format("R{}({})", Count(next_rule_, rules_), Number(1));
    }
    return OneOf({"NIL", "Wall", "Glass", "ε"});
  }

  std::string Braces(int depth) {
    std::string text;
    for (int i = Count(1, 4); i > 0; --i) {
      if (!text.empty()) text += " | ";
      if (depth < kDeepest && Chance(4)) {
        text += Braces(depth + 1) + "*";
      } else {
        text += fmt::format("{}{}: {}", OneOf({"", "~", "'"}), Size(), Body(depth + 1));
      }
    }
    return "{ " + text + " }";
  }

  std::string Size() { return Chance(2) ? "1.5" : Number(1); }

  Random random_;
  int attributes_ = 0, next_rule_ = 0, rules_ = 0;
  bool has_words_ = false, has_functions_ = false;
};

inline rc::Gen<std::string> AnyRules() {
  return rc::gen::map(rc::gen::noShrink(rc::gen::resize(100, rc::gen::arbitrary<uint64_t>())),
                      [](uint64_t seed) { return RandomRules(seed).Text(); });
}

}  // namespace parti::grammar::tests
