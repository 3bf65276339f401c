// A listing of the thesis, derived: what its text says of it can be asked.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "app/rule_source.h"
#include "app/session_state.h"
#include "render/image.h"

namespace parti::tests {

/// How a listing is derived.
struct ListingOptions {
  std::string lot = "rect(8,6)";
  std::string start;
  std::vector<std::string> layers_off = {};
  std::vector<std::pair<std::string, std::string>> attributes = {};
};

class Listing {
 public:
  /// tests/listings/NAME.cga. CHECKs that it derives.
  Listing(const std::string& name, const ListingOptions& options);

  /// Items of the shapes with this symbol, of one type, in the order of the tree.
  std::vector<grammar::Item> Of(std::string_view symbol, grammar::ItemType type) const;
  std::vector<grammar::Item> Volumes(std::string_view symbol) const {
    return Of(symbol, grammar::ItemType::kVolume);
  }
  /// What nothing covers of the planar shape with this symbol, which there is once.
  std::vector<grammar::Item> BackgroundOf(std::string_view symbol) const;
  double BackgroundAreaOf(std::string_view symbol) const;
  /// The planar shape with this symbol, which there is once.
  const grammar::Item& Planar(std::string_view symbol) const;
  /// All that is visible.
  size_t Leaves() const { return tree().Leaves().size(); }

  const grammar::ShapeTree& tree() const { return model_.derived[0]->tree; }
  /// From the street, a little from the left and from above.
  render::Image Picture() const;

 private:
  grammar::ShapeIndex PlanarIndex(std::string_view symbol) const;

  app::Model model_;
};

/// The rectangle that an item takes of a planar shape, in its scope's coordinates.
grammar::Box2 BoxIn(const grammar::Item& planar, const grammar::Item& item);

}  // namespace parti::tests
