#include "render/marks.h"

#include <algorithm>
#include <cmath>

#include "render/bounds.h"

namespace parti::render {
namespace {

constexpr float kLeastDash_px = 0.5f;

void AppendDashes(const InkPiece& line, float dash_px, float* along,
                  std::vector<InkPiece>* dashes) {
  const float length = glm::distance(line.a, line.b);
  const float period = 2 * dash_px;
  const Vec2f direction = length > 0 ? (line.b - line.a) / length : Vec2f(0);
  float begin = std::floor(*along / period) * period - *along;
  for (; begin < length; begin += period) {
    const float from = std::max(begin, 0.0f), to = std::min(begin + dash_px, length);
    if (to <= from) continue;
    dashes->push_back({line.a + direction * from, line.a + direction * to, line.radii});
  }
  *along = std::fmod(*along + length, period);
}

/// The part of a line that can touch the picture, so that dashes of far ends are not counted out.
bool CutAtPicture(const glm::ivec2& size, float margin, InkPiece* line, float* skipped) {
  float from = 0, to = 1;
  const Vec2f step = line->b - line->a;
  for (int axis = 0; axis < 2; ++axis) {
    const float low = -margin, high = static_cast<float>(size[axis]) + margin;
    if (step[axis] == 0) {
      if (line->a[axis] < low || line->a[axis] > high) return false;
      continue;
    }
    const float at_low = (low - line->a[axis]) / step[axis];
    const float at_high = (high - line->a[axis]) / step[axis];
    from = std::max(from, std::min(at_low, at_high));
    to = std::min(to, std::max(at_low, at_high));
  }
  if (from > to) return false;
  const Vec2f a = line->a;
  line->a = a + step * from;
  line->b = a + step * to;
  *skipped = from * glm::length(step);
  return true;
}

}  // namespace

std::vector<InkPiece> PiecesOf(const Mark& mark, const glm::ivec2& size) {
  const Ink ink{mark.points, std::vector<float>(mark.points.size(), mark.width_px), mark.color};
  std::vector<InkPiece> lines;
  if (!(mark.width_px > 0)) return lines;
  AppendPieces(ink, 0, &lines);
  std::vector<InkPiece> pieces;
  float along = 0;
  for (InkPiece line : lines) {
    const float length = glm::distance(line.a, line.b);
    float skipped = 0;
    if (CutAtPicture(size, line.radii.x + 2, &line, &skipped)) {
      float here = along + skipped;
      if (mark.dash_px >= kLeastDash_px) {
        AppendDashes(line, mark.dash_px, &here, &pieces);
      } else {
        pieces.push_back(line);
      }
    }
    along += length;
  }
  return pieces;
}

std::vector<MarkGroup> GroupsOf(const std::vector<Mark>& marks, const glm::ivec2& size) {
  std::vector<MarkGroup> groups;
  for (const Mark& mark : marks) {
    const std::vector<InkPiece> pieces = PiecesOf(mark, size);
    if (pieces.empty()) continue;
    if (groups.empty() || groups.back().color != mark.color) {
      groups.push_back({mark.color, {}, Damage(size)});
    }
    groups.back().pieces.insert(groups.back().pieces.end(), pieces.begin(), pieces.end());
    for (const InkPiece& piece : pieces) groups.back().pixels.Add(PixelsOf(piece, size));
  }
  return groups;
}

Damage ChangeBetween(const std::vector<Mark>& before, const std::vector<Mark>& after,
                     const glm::ivec2& size) {
  // Equal beginnings and ends look the same; what lies between is drawn again.
  const size_t shorter = std::min(before.size(), after.size());
  size_t first = 0, last = 0;
  while (first < shorter && before[first] == after[first]) ++first;
  while (last < shorter - first &&
         before[before.size() - 1 - last] == after[after.size() - 1 - last]) {
    ++last;
  }
  Damage change(size);
  for (const std::vector<Mark>* marks : {&before, &after}) {
    for (size_t i = first; i + last < marks->size(); ++i) {
      for (const InkPiece& piece : PiecesOf((*marks)[i], size)) change.Add(PixelsOf(piece, size));
    }
  }
  return change;
}

}  // namespace parti::render
