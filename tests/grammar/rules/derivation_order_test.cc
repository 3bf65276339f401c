// The driver derives scene by scene; Listing 4.9 has one queue for everything. On random grammars
// both come to the same shapes.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>

#include "tests/grammar/rules/derived_by_rules.h"
#include "tests/grammar/rules/literal_queue.h"

namespace parti::grammar {
namespace {

/// Rules A0 … A7, each using later ones only, so that every grammar ends.
class RandomGrammar {
 public:
  std::string Text() {
    std::string text = "Lot --> extrude(6) comp(f) { top: A0 | vertical: A0 }\n";
    for (int i = 0; i < kRules; ++i) text += "A" + std::to_string(i) + " --> " + Body(i) + "\n";
    return text;
  }

 private:
  static constexpr int kRules = 8;

  int Pick(int count) { return *rc::gen::inRange(0, count); }

  std::string Symbol(int after) {
    const int next = after + 1 + Pick(4);
    return next < kRules ? "A" + std::to_string(next) : "End";
  }

  std::string Sizes(int rule) {
    return "{ ~1: " + Successor(rule) + " | 0." + std::to_string(3 + Pick(6)) + ": " +
           Successor(rule) + " | ~2: " + Successor(rule) + " }";
  }

  std::string Successor(int rule) {
    constexpr const char* kBefore[] = {"", "", "NIL", "set_property(\"fixed_geometry\", false) ",
                                       "tag(\"t\") "};
    const std::string before = kBefore[Pick(5)];
    return before == "NIL" ? before : before + Symbol(rule);
  }

  std::string Body(int rule) {
    const std::string axis = Pick(2) == 0 ? "x" : "y";
    switch (Pick(7)) {
      case 0:
        return "split(" + axis + ") " + Sizes(rule);
      case 1:
        return "layers(\"a\", \"b\") { segment(x) " + Sizes(rule) + " | segment(y) " + Sizes(rule) +
               " }";
      case 2:
        return "vectorial(\"M0,0 L0,0.5 C0,1 1,1 1,0.5 L1,0Z\", 8) extrude(0.1) " + Symbol(rule);
      case 3:
        return "50%: " + Symbol(rule) + " else: color(\"#ff0000\") " + Symbol(rule);
      case 4:
        return "color(\"#00ff00\") End";
      default:
        return "segment(" + axis + ") " + Sizes(rule);
    }
  }
};

/// What there is to see, in an order that numbers of shapes have no part in.
std::vector<std::string> Seen(const ShapeTree& tree) {
  std::vector<std::string> shapes;
  for (const ShapeIndex i : tree.Leaves()) {
    const Scope& s = tree[i].item.scope;
    shapes.push_back(fmt::format("{} {} {},{},{} {},{},{} {}", tree.IdOf(i),
                                 tree.Name(tree[i].symbol), s.origin.x, s.origin.y, s.origin.z,
                                 s.size.x, s.size.y, s.size.z, tree[i].item.color_rgb));
  }
  std::sort(shapes.begin(), shapes.end());
  return shapes;
}

RC_GTEST_PROP(DerivationOrder, SceneBySceneIsTheListingsQueue, ()) {
  const RuleSet rules = RulesFrom(RandomGrammar().Text());
  RuleSettings settings;
  settings.seed = static_cast<uint64_t>(*rc::gen::inRange(0, 1000));
  settings.limits.shapes = 5000;
  const Item lot = LotOf(20, 10)[0].item;
  const auto ours =
      DeriveRules(rules, settings, {&lot, 1}, {1, nullptr, nullptr, nullptr, nullptr});
  const auto listing = DeriveByQueue(rules, settings, lot);
  // A type that neither form can take, or a shape too many, ends both.
  const bool nothing = !ours && ours.error().code == ErrorCode::kNothingMade;
  if (nothing) return;
  RC_ASSERT(ours.has_value() == listing.has_value());
  if (ours) RC_ASSERT(Seen(ours->front()) == Seen(*listing));
}

}  // namespace
}  // namespace parti::grammar
