#include "tests/listings/listing.h"

#include <algorithm>
#include <limits>

#include "app/picture.h"
#include "app/scene_from_model.h"
#include "base/check.h"
#include "tests/support/data.h"

namespace parti::tests {

using grammar::Item;
using grammar::ItemType;
using grammar::ShapeIndex;

namespace {

app::Model ModelOf(const std::string& name, const ListingOptions& options) {
  auto source = std::make_shared<app::RuleSource>();
  source->settings.start = options.start;
  source->settings.attributes = options.attributes;
  source->layers.off = options.layers_off;
  const auto rules = app::ReadRules(SourceFile("tests/listings/" + name + ".cga"), source.get());
  CHECK(rules.has_value(), rules ? std::string() : FormatError(rules.error().front()));
  auto lots = app::ParseLots(options.lot);
  CHECK(lots.has_value(), lots ? std::string() : FormatError(lots.error()));
  const auto ground = app::GroundOf(std::move(*lots), source, *rules);
  CHECK(ground.has_value(), ground ? std::string() : FormatError(ground.error()));
  auto model = app::Derived(*ground, std::make_shared<const grammar::Trees>(), nullptr);
  CHECK(model.has_value(), "without trees nothing can fail");
  return std::move(*model);
}

}  // namespace

Listing::Listing(const std::string& name, const ListingOptions& options)
    : model_(ModelOf(name, options)) {}

std::vector<Item> Listing::Of(std::string_view symbol, ItemType type) const {
  std::vector<Item> found;
  for (ShapeIndex i = 0; i < tree().size(); ++i) {
    const auto& shape = tree()[i];
    if (shape.item.type == type && tree().Name(shape.symbol) == symbol) found.push_back(shape.item);
  }
  return found;
}

ShapeIndex Listing::PlanarIndex(std::string_view symbol) const {
  ShapeIndex found = grammar::kNoShape;
  for (ShapeIndex i = 0; i < tree().size(); ++i) {
    if (tree()[i].item.type != ItemType::kPlanar || tree().Name(tree()[i].symbol) != symbol)
      continue;
    CHECK(found == grammar::kNoShape, "there is one");
    found = i;
  }
  CHECK(found != grammar::kNoShape, "there is one");
  return found;
}

const Item& Listing::Planar(std::string_view symbol) const {
  return tree()[PlanarIndex(symbol)].item;
}

std::vector<Item> Listing::BackgroundOf(std::string_view symbol) const {
  const auto tag = tree().Find("background");
  std::vector<Item> background;
  for (ShapeIndex i = tree().node(PlanarIndex(symbol)).first_child; i != grammar::kNoShape;
       i = tree().node(i).next_sibling) {
    const auto& tags = tree()[i].tags;
    if (std::find(tags.begin(), tags.end(), tag) != tags.end())
      background.push_back(tree()[i].item);
  }
  return background;
}

double Listing::BackgroundAreaOf(std::string_view symbol) const {
  double area = 0;
  for (const Item& item : BackgroundOf(symbol)) area += AreaOf(item);
  return area;
}

render::Image Listing::Picture() const {
  app::SessionState state;
  state.model = model_;
  state.camera = app::AutoViewOf(model_, Vec2(900, 700));
  const Vec3 sight = state.camera.eye - state.camera.target;
  const double far = glm::length(sight);
  state.camera.eye = state.camera.target + glm::normalize(Vec3(-0.42, 0.16, 1)) * far;
  auto picture = app::PictureOf(state);
  CHECK(picture.has_value(), picture ? std::string() : FormatError(picture.error()));
  return std::move(*picture);
}

grammar::Box2 BoxIn(const Item& planar, const Item& item) {
  constexpr double kFar = std::numeric_limits<double>::infinity();
  grammar::Box2 box{Vec2(kFar, kFar), Vec2(-kFar, -kFar)};
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 of(corner & 1 ? 1 : 0, corner & 2 ? 1 : 0, corner & 4 ? 1 : 0);
    const Vec2 at(planar.scope.ToLocal(item.scope.ToWorld(of * item.scope.size)));
    box.low = glm::min(box.low, at);
    box.high = glm::max(box.high, at);
  }
  return box;
}

}  // namespace parti::tests
