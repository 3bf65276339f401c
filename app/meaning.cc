#include "app/meaning.h"

#include <fmt/format.h>

#include "app/crease_lines.h"
#include "grammar/operation.h"

namespace parti::app {

Result<Meaning> MeaningOf(const SessionState& state, size_t number) {
  const Sketch& sketch = state.sketch;
  if (number >= sketch.suggestions.size() || !sketch.target) {
    return Fail(ErrorCode::kUnknownName, fmt::format("there is no suggestion {}", number + 1),
                fmt::format("this sketch has {} suggestion{}", sketch.suggestions.size(),
                            sketch.suggestions.size() == 1 ? "" : "s"));
  }
  const grammar::Item& item = ShapeAt(state.model, *sketch.target).item;
  const grammar::Action& action = sketch.suggestions[number].action;
  Meaning meaning;
  for (const auto& line : sketch::Settled(sketch.lines, item, action).lines) {
    meaning.lines.emplace_back(line.world);
  }
  const auto products = grammar::Apply(action, item);
  if (!products) return Fail(products);
  for (const grammar::Product& product : *products) {
    const std::vector<Segment3> own = grammar::EdgesOf(product.item);
    meaning.edges.insert(meaning.edges.end(), own.begin(), own.end());
  }
  meaning.edges = WithoutOverlaps(meaning.edges);
  return meaning;
}

std::vector<Segment3> OutlineOf(const Model& model, const ShapeRef& ref) {
  return grammar::EdgesOf(ShapeAt(model, ref).item);
}

}  // namespace parti::app
