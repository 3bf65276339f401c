// resetMaterial(target): color, texture and material taken off again.
// Texture coordinates stay: deleteUV (change_uv.cc) takes those.
#include <array>
#include <utility>

#include "grammar/operations/rows.h"

namespace parti::grammar {
namespace {

constexpr std::string_view kShape = "shape", kGeometry = "geometry", kAll = "all";

void ResetShape(Item* item) {
  item->color_rgb = 0;
  if (!item->paint) return;
  Paint paint = *item->paint;
  paint.material = nullptr;
  item->paint = paint == Paint() ? nullptr : std::make_shared<const Paint>(std::move(paint));
}

void ResetGeometry(Item* item) {
  if (!item->mesh || item->mesh->paints.empty()) return;
  Mesh mesh = *item->mesh;
  for (Paint& paint : mesh.paints) paint.material = nullptr;
  item->mesh = std::make_shared<const Mesh>(std::move(mesh));
}

Result<std::vector<Product>> ApplyReset(const Item& item, const Action& action) {
  const auto& target = std::get<std::string>(action.arguments[0]);
  Item reset = item;
  if (target != kGeometry) ResetShape(&reset);
  if (target != kShape) ResetGeometry(&reset);
  return std::vector<Product>{{std::move(reset), -1}};
}

constexpr std::array<std::string_view, 3> kTargets = {kShape, kGeometry, kAll};

const std::array<Parameter, 1> kParameters = {{{
    .name = "target",
    .kind = ParameterKind::kWord,
    .default_value = std::string(kShape),
    .required = false,
    .doc = "what the shape got by color, texture and set(material.…); what the faces of an asset "
           "have; or both",
    .words = kTargets,
}}};

}  // namespace

constinit const Operation kResetMaterial = {
    .name = "resetMaterial",
    .word = "ResetMaterial",
    .doc =
        "Takes color, texture and material off again; texture coordinates stay. An asset shows "
        "those that its file gives it.",
    .source = "CGA",
    .parameters = kParameters,
    .takes = kSurfaced,
    .gives = kSurfaced,
    .in_place = true,
    .sampled = false,
    .apply = ApplyReset,
};

}  // namespace parti::grammar
