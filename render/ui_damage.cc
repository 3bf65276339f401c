#include "render/ui_damage.h"

#include <algorithm>
#include <bit>
#include <limits>

namespace parti::render {
namespace {

/// FNV-1a, a word at a time: enough to tell a changed panel from an unchanged one.
void Mix(uint32_t word, uint64_t* hash) {
  *hash = (*hash ^ word) * 0x100000001b3ull;
  *hash ^= *hash >> 29;
}

bool IsWhole(const UiMesh& mesh, const UiCommand& command) {
  return command.first_index <= mesh.indices.size() &&
         command.index_count <= mesh.indices.size() - command.first_index &&
         command.index_count % 3 == 0;
}

/// False where a corner is missing or not finite.
bool Add(const UiMesh& mesh, uint32_t index, uint64_t* hash, Vec2f* low, Vec2f* high) {
  if (index >= mesh.vertices.size()) return false;
  const UiVertex& v = mesh.vertices[index];
  for (const float f : {v.px.x, v.px.y, v.uv.x, v.uv.y}) Mix(std::bit_cast<uint32_t>(f), hash);
  Mix(v.rgba, hash);
  *low = glm::min(*low, v.px);
  *high = glm::max(*high, v.px);
  constexpr float kMost = 1e7f;
  return std::abs(v.px.x) <= kMost && std::abs(v.px.y) <= kMost;
}

}  // namespace

std::vector<UiShape> ShapesOf(const UiMesh& mesh, const glm::ivec2& size) {
  std::vector<UiShape> shapes;
  for (const UiCommand& command : mesh.commands) {
    UiShape shape{command, 0xcbf29ce484222325ull, {}};
    shape.command.first_index = 0;
    constexpr float kInf = std::numeric_limits<float>::infinity();
    Vec2f low(kInf), high(-kInf);
    bool good = IsWhole(mesh, command);
    for (uint32_t i = 0; good && i < command.index_count; ++i) {
      good = Add(mesh, mesh.indices[command.first_index + i], &shape.content, &low, &high);
    }
    if (good) shape.pixels = Intersection(PixelsAround(low, high, 1, size), command.clip);
    shapes.push_back(shape);
  }
  return shapes;
}

Damage ChangeBetween(const std::vector<UiShape>& before, const std::vector<UiShape>& after,
                     const glm::ivec2& size) {
  // Panels come and go at any place in the order: walk along both, taking over what is the same.
  Damage change(size);
  size_t b = 0;
  for (const UiShape& shape : after) {
    const auto same = std::find(before.begin() + static_cast<ptrdiff_t>(b), before.end(), shape);
    if (same == before.end()) {
      change.Add(shape.pixels);
      continue;
    }
    const size_t at = static_cast<size_t>(same - before.begin());
    for (; b < at; ++b) change.Add(before[b].pixels);
    ++b;
  }
  for (; b < before.size(); ++b) change.Add(before[b].pixels);
  return change;
}

}  // namespace parti::render
