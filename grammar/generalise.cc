#include "grammar/generalise.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>

#include "grammar/operation.h"
#include "grammar/query_filter.h"
#include "grammar/query_reading.h"

namespace parti::grammar {
namespace {

/// Where a shape stands among its siblings with the same symbol, from 1.
struct Place {
  uint32_t position = 1;
  uint32_t count = 1;
};

Place PlaceOf(const ShapeTree& tree, ShapeIndex shape) {
  const ShapeIndex parent = tree.node(shape).parent;
  if (parent == kNoShape) return {};
  Place place{0, 0};
  for (ShapeIndex s = tree.node(parent).first_child; s != kNoShape; s = tree.node(s).next_sibling) {
    if (tree[s].symbol != tree[shape].symbol) continue;
    ++place.count;
    if (s == shape) place.position = place.count;
  }
  return place;
}

/// What every tapped shape, or what is as far above each, has in common.
struct Level {
  QuerySelector name;           ///< symbol, or operation; empty: neither is common to all
  std::optional<Filter> exact;  ///< the one place among their siblings that all have
  std::vector<Filter> places;   ///< filters of position that all pass, the exact one among them
};

Filter PlainFilter(std::string name) { return {std::move(name), {}, {}, {}}; }

/// The filters of position that say something and that all places pass.
void AddPlaces(const std::vector<Place>& places, Level* level) {
  const auto all = [&](auto test) { return std::all_of(places.begin(), places.end(), test); };
  if (all([](Place p) { return p.count == 1; })) return;
  const uint32_t position = places[0].position;
  std::vector<Filter>* filters = &level->places;
  if (all([&](Place p) { return p.position == position; })) {
    level->exact = position == 1 ? PlainFilter("first") : Filter{"nth", {1.0 * position}, {}, {}};
    filters->push_back(*level->exact);
  }
  const bool last = all([](Place p) { return p.position == p.count; });
  if (last) filters->push_back(PlainFilter("last"));
  const auto at_end = [](Place p) { return p.position == 1 || p.position == p.count; };
  if (all(at_end)) filters->push_back(PlainFilter("ends"));
  if (std::none_of(places.begin(), places.end(), at_end)) {
    filters->push_back(PlainFilter("middle"));
  }
  if (all([&](Place p) { return p.position % 2 == position % 2; })) {
    filters->push_back(PlainFilter(position % 2 == 0 ? "even" : "odd"));
  }
  uint32_t step = 0, first = position;
  for (const Place p : places) {
    step = std::gcd(step, p.position > position ? p.position - position : position - p.position);
    first = std::min(first, p.position);
  }
  if (step > 2) filters->push_back({"nth", {1.0 * first, 1.0 * step}, {}, {}});
}

/// Symbol or operation that all have; nothing where they have neither in common.
std::optional<QuerySelector> NameOfAll(std::span<const ShapeTree* const> trees,
                                       const std::vector<TappedShape>& shapes) {
  const auto symbol_of = [&](const TappedShape& t) {
    return (*trees[t.tree]).Name((*trees[t.tree])[t.shape].symbol);
  };
  const auto operation_of = [&](const TappedShape& t) {
    return (*trees[t.tree])[t.shape].operation;
  };
  QuerySelector selector;
  const auto all = [&](auto value_of) {
    return std::all_of(shapes.begin(), shapes.end(),
                       [&](const TappedShape& t) { return value_of(t) == value_of(shapes[0]); });
  };
  if (all(symbol_of) && !symbol_of(shapes[0]).empty()) {
    selector.symbol = symbol_of(shapes[0]);
  } else if (all(operation_of) && operation_of(shapes[0]) != nullptr) {
    selector.operation = operation_of(shapes[0])->word;
  } else {
    return std::nullopt;
  }
  return selector;
}

/// Faces of volumes are told apart by where they face; their numbers mean nothing to people.
bool AreFaces(std::span<const ShapeTree* const> trees, const std::vector<TappedShape>& shapes) {
  return std::all_of(shapes.begin(), shapes.end(), [&](const TappedShape& t) {
    const Operation* made = (*trees[t.tree])[t.shape].operation;
    return made != nullptr && made->name == "comp";
  });
}

/// The shapes, what is above each, and so on, as far as they have a name in common; shapes first.
std::vector<Level> LevelsOf(std::span<const ShapeTree* const> trees,
                            std::vector<TappedShape> shapes) {
  std::vector<Level> levels;
  while (true) {
    const auto name = NameOfAll(trees, shapes);
    if (!name) return levels;
    Level level{*name, {}, {}};
    std::vector<Place> places;
    for (const TappedShape& t : shapes) places.push_back(PlaceOf(*trees[t.tree], t.shape));
    AddPlaces(places, &level);
    if (AreFaces(trees, shapes)) level.places.clear();
    levels.push_back(std::move(level));
    for (TappedShape& t : shapes) {
      t.shape = trees[t.tree]->node(t.shape).parent;
      if (t.shape == kNoShape) return levels;
    }
  }
}

/// The one direction that all face; "" where they don't.
std::string CommonDirection(std::span<const ShapeTree* const> trees,
                            std::span<const TappedShape> tapped) {
  std::string common;
  for (const TappedShape& t : tapped) {
    const std::string_view direction = DirectionOf((*trees[t.tree])[t.shape].item.facing);
    if (direction.empty() || (!common.empty() && common != direction)) return "";
    common = direction;
  }
  return common;
}

/// A level and the filter of position that it is asked for; none: only its name.
struct Constraint {
  size_t level = 0;
  const Filter* place = nullptr;
};

/// Builds queries from constraints on levels.
class Drafts {
 public:
  Drafts(std::vector<Level> levels, QuerySelector fallback, const GeneraliseParameters& parameters)
      : levels_(std::move(levels)), parameters_(parameters) {
    if (levels_.empty()) levels_.push_back({std::move(fallback), {}, {}});
  }

  /// Constraints by descending level; the last selector is that of the shapes themselves.
  Query Of(const std::vector<Constraint>& constraints, const std::string& direction) const {
    Query query;
    const auto add = [&](const Constraint& c) {
      if (!query.selectors.empty()) query.relations.push_back(Query::Relation::kDescendants);
      query.selectors.push_back(levels_[c.level].name);
      if (c.place != nullptr) query.selectors.back().filters.push_back(*c.place);
    };
    for (const Constraint& c : constraints) add(c);
    if (constraints.empty() || constraints.back().level != 0) add({});
    if (!direction.empty()) query.selectors.back().filters.push_back(PlainFilter(direction));
    return query;
  }

  /// Every level by its exact place, and by name where it has none: the whole path.
  Query Path() const {
    Query query;
    for (size_t i = levels_.size(); i-- > 0;) {
      if (!query.selectors.empty()) query.relations.push_back(Query::Relation::kChildren);
      query.selectors.push_back(levels_[i].name);
      if (levels_[i].exact) query.selectors.back().filters.push_back(*levels_[i].exact);
    }
    return query;
  }

  /// No constraint, one, and where `pairs` two of different levels; directions are added by the
  /// caller.
  std::vector<std::vector<Constraint>> All(bool pairs) const {
    std::vector<std::vector<Constraint>> all = {{}};
    std::vector<Constraint> single;
    int positioned = 0;
    for (size_t i = 0; i < levels_.size(); ++i) {
      if (i > 0) all.push_back({{i, nullptr}});  // in the same part
      if (levels_[i].places.empty() || positioned == parameters_.most_levels) continue;
      ++positioned;
      for (const Filter& place : levels_[i].places) single.push_back({i, &place});
    }
    for (const Constraint& c : single) all.push_back({c});
    if (!pairs) return all;
    for (const Constraint& lower : single) {
      for (const Constraint& upper : single) {
        if (upper.level > lower.level) all.push_back({upper, lower});
      }
    }
    return all;
  }

 private:
  std::vector<Level> levels_;
  GeneraliseParameters parameters_;
};

size_t PartsOf(const Query& query) {
  size_t parts = 0;
  for (const QuerySelector& s : query.selectors) {
    parts += (s.symbol.empty() ? 0 : 1) + (s.operation.empty() ? 0 : 2);
    for (const Filter& filter : s.filters) parts += 1 + filter.numbers.size();
  }
  return std::max<size_t>(parts, 1);
}

using Products = std::vector<std::vector<ShapeIndex>>;  // one per tree

/// What the query selects, if that is all that was tapped and perhaps more.
std::optional<Products> ProductsOf(const Query& query, std::span<const ShapeTree* const> trees,
                                   std::span<const TappedShape> tapped) {
  Products products;
  for (const ShapeTree* tree : trees) {
    auto product = ProductOf(query, *tree);
    if (!product) return std::nullopt;
    products.push_back(std::move(*product));
  }
  for (const TappedShape& t : tapped) {
    const auto& product = products[t.tree];
    if (!std::binary_search(product.begin(), product.end(), t.shape)) return std::nullopt;
  }
  return products;
}

/// FNV-1a over everything selected: equal selections have equal keys.
uint64_t KeyOf(const Products& products) {
  uint64_t key = 14695981039346656037ull;
  const auto mix = [&](uint64_t value) { key = (key ^ value) * 1099511628211ull; };
  for (const auto& product : products) {
    mix(product.size());
    for (const ShapeIndex shape : product) mix(shape);
  }
  return key;
}

/// Tries queries, cheapest first where two select the same.
class Candidates {
 public:
  Candidates(std::span<const ShapeTree* const> trees, std::vector<TappedShape> tapped,
             const GeneraliseParameters& parameters)
      : trees_(trees), tapped_(std::move(tapped)), parameters_(parameters) {}

  /// `keep`: it is among the best in any case.
  void Try(Query query, bool keep = false) {
    const auto products = ProductsOf(query, trees_, tapped_);
    if (!products) return;
    size_t count = 0;
    for (const auto& product : *products) count += product.size();
    const auto n = static_cast<double>(tapped_.size());
    const double evidence = n - 1 + parameters_.first_tap;
    const double cost = evidence * std::log2(static_cast<double>(count) / n) +
                        parameters_.bits_per_part * static_cast<double>(PartsOf(query));
    const uint64_t key = KeyOf(*products);
    for (Found& other : found_) {
      if (other.key != key) continue;
      if (cost < other.candidate.cost) other.candidate = {std::move(query), "", count, cost};
      other.keep |= keep;
      return;
    }
    found_.push_back({key, keep, {std::move(query), "", count, cost}});
  }

  bool empty() const { return found_.empty(); }

  /// The cheapest, and in any case the narrowest and those to keep.
  std::vector<QueryCandidate> Best() && {
    const auto narrower = [](const Found& a, const Found& b) {
      return a.candidate.count < b.candidate.count;
    };
    if (!found_.empty()) std::min_element(found_.begin(), found_.end(), narrower)->keep = true;
    const auto by = [](const auto& key) {
      return [key](const Found& a, const Found& b) { return key(a) < key(b); };
    };
    const auto cost = [](const Found& f) { return f.candidate.cost; };
    std::stable_sort(found_.begin(), found_.end(),
                     by([&](const Found& f) { return std::pair(!f.keep, cost(f)); }));
    const auto most = static_cast<size_t>(parameters_.most);
    if (found_.size() > most) found_.erase(found_.begin() + parameters_.most, found_.end());
    std::stable_sort(found_.begin(), found_.end(), by(cost));
    std::vector<QueryCandidate> best;
    for (Found& found : found_) {
      best.push_back(std::move(found.candidate));
      best.back().reading = ReadingOf(best.back().query);
    }
    return best;
  }

 private:
  struct Found {
    uint64_t key = 0;
    bool keep = false;
    QueryCandidate candidate;
  };
  std::span<const ShapeTree* const> trees_;
  std::vector<TappedShape> tapped_;
  GeneraliseParameters parameters_;
  std::vector<Found> found_;
};

/// In the order of the trees, each once: the order of tapping does not matter.
std::vector<TappedShape> Sorted(std::span<const TappedShape> tapped) {
  std::vector<TappedShape> sorted(tapped.begin(), tapped.end());
  std::sort(sorted.begin(), sorted.end(), [](const TappedShape& a, const TappedShape& b) {
    return std::pair(a.tree, a.shape) < std::pair(b.tree, b.shape);
  });
  sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
  return sorted;
}

}  // namespace

std::vector<QueryCandidate> Generalise(std::span<const ShapeTree* const> trees,
                                       std::span<const TappedShape> tapped,
                                       const GeneraliseParameters& parameters) {
  if (tapped.empty()) return {};
  const std::vector<TappedShape> shapes = Sorted(tapped);
  const std::string direction = CommonDirection(trees, shapes);
  QuerySelector visible;
  visible.filters.push_back(PlainFilter("leaf"));
  const Drafts drafts(LevelsOf(trees, shapes), visible, parameters);

  Candidates candidates(trees, shapes, parameters);
  for (const auto& constraints : drafts.All(shapes.size() > 1)) {
    const bool plain = constraints.empty();  // its kind, and those that face the same way
    candidates.Try(drafts.Of(constraints, ""), plain);
    if (!direction.empty()) candidates.Try(drafts.Of(constraints, direction), plain);
  }
  candidates.Try(drafts.Path());
  if (const Operation* made = (*trees[shapes[0].tree])[shapes[0].shape].operation) {
    QuerySelector by_operation;
    by_operation.operation = made->word;
    candidates.Try({{by_operation}, {}});
  }
  if (candidates.empty()) candidates.Try({{QuerySelector()}, {}});  // nothing in common
  return std::move(candidates).Best();
}

}  // namespace parti::grammar
