#include "render/ink_strokes.h"

#include <algorithm>
#include <iterator>
#include <unordered_map>

namespace parti::render {
namespace {

PixelRect AllPixelsOf(const std::vector<InkPiece>& pieces, const glm::ivec2& size) {
  PixelRect all;
  for (const InkPiece& piece : pieces) all = Union(all, PixelsOf(piece, size));
  return all;
}

std::vector<InkPiece> PiecesOf(const Ink& ink) {
  std::vector<InkPiece> pieces;
  AppendPieces(ink, 0, &pieces);
  return pieces;
}

void Append(std::span<const Vec2f> points, std::span<const float> widths_px, Ink* ink) {
  for (size_t i = 0; i < points.size(); ++i) {
    ink->points.push_back(points[i]);
    ink->widths_px.push_back(i < widths_px.size() ? widths_px[i] : 1.0f);
  }
}

}  // namespace

void InkStrokes::SetStrokes(const std::vector<InkStroke>& strokes) {
  const size_t done = strokes_.size() - (live_ ? 1 : 0);
  size_t same = 0;
  while (same < std::min(done, strokes.size()) && strokes[same].ink &&
         strokes_[same].id == strokes[same].id) {
    ++same;
  }
  if (same == done && same == strokes.size()) return;
  const std::vector<Vec4f> groups = GroupColors();
  Held live;
  if (live_) {
    live = strokes_.back();
    strokes_.pop_back();
  }
  const Damage remade = ReplaceFrom(same, std::span(strokes).subspan(same));
  if (live_) strokes_.push_back(live);
  Rebuild(remade, groups);
}

Damage InkStrokes::ReplaceFrom(size_t first, std::span<const InkStroke> strokes) {
  const auto from = strokes_.begin() + static_cast<ptrdiff_t>(first);
  std::vector<Held> before(std::make_move_iterator(from), std::make_move_iterator(strokes_.end()));
  strokes_.resize(first);
  std::unordered_map<uint64_t, size_t> known;
  for (size_t i = 0; i < before.size(); ++i) known.emplace(before[i].id, i);
  Damage remade(size_);
  size_t next_known = 0;
  for (const InkStroke& stroke : strokes) {
    if (!stroke.ink) continue;
    const auto found = known.find(stroke.id);
    if (found == known.end()) {
      strokes_.push_back({stroke.id, stroke.ink, AllPixelsOf(PiecesOf(*stroke.ink), size_)});
      remade.Add(strokes_.back().pixels);
      continue;
    }
    strokes_.push_back(std::move(before[found->second]));
    if (found->second < next_known) remade.Add(strokes_.back().pixels);  // changed its place
    next_known = std::max(next_known, found->second + 1);
    known.erase(found);
  }
  for (const auto& [id, gone] : known) remade.Add(before[gone].pixels);
  return remade;
}

void InkStrokes::Begin(uint64_t id, const Vec4f& color) {
  End();
  live_ = std::make_shared<Ink>();
  live_->color = color;
  strokes_.push_back({id, live_, {}});
}

void InkStrokes::Add(std::span<const Vec2f> points, std::span<const float> widths_px) {
  if (!live_ || points.empty()) return;
  const size_t from = live_->points.size();
  Append(points, widths_px, live_.get());
  std::vector<InkPiece> pieces;
  AppendPieces(*live_, from, &pieces);
  std::vector<InkPiece> tail;
  if (EndsInDot(*live_)) {
    tail.push_back(pieces.back());
    pieces.pop_back();
  }
  SetTail(std::move(tail));
  AddFresh(std::move(pieces));
}

void InkStrokes::Predict(std::span<const Vec2f> points, std::span<const float> widths_px) {
  if (!live_ || live_->points.empty()) return;
  Ink ahead{{live_->points.back()}, {live_->widths_px.back()}, live_->color};
  Append(points, widths_px, &ahead);
  std::vector<InkPiece> pieces;
  AppendPieces(ahead, points.empty() && !EndsInDot(*live_) ? 1 : 0, &pieces);
  SetTail(std::move(pieces));
}

void InkStrokes::End() {
  if (!live_) return;
  SetTail({});
  if (EndsInDot(*live_)) {
    const size_t last = live_->points.size() - 1;
    std::vector<InkPiece> dot;
    AppendPieces(*live_, last, &dot);
    AddFresh({dot.back()});
  }
  live_.reset();
}

void InkStrokes::Cancel() {
  if (!live_) return;
  SetTail({});
  const std::vector<Vec4f> groups = GroupColors();
  Damage remade(size_);
  remade.Add(strokes_.back().pixels);
  strokes_.pop_back();
  live_.reset();
  Rebuild(remade, groups);
}

void InkStrokes::Resize(const glm::ivec2& size) {
  size_ = size;
  for (Held& stroke : strokes_) stroke.pixels = AllPixelsOf(PiecesOf(*stroke.ink), size_);
  news_ = InkNews(size);
  news_.changed.AddAll();
  news_.rebuild.AddAll();
  news_.tail_changed = true;
}

void InkStrokes::AddFresh(std::vector<InkPiece> pieces) {
  if (pieces.empty()) return;
  for (const InkPiece& piece : pieces) {
    const PixelRect pixels = PixelsOf(piece, size_);
    news_.changed.Add(pixels);
    strokes_.back().pixels = Union(strokes_.back().pixels, pixels);
  }
  const Vec4f& color = strokes_.back().ink->color;
  if (news_.fresh.empty() || news_.fresh.back().color != color) news_.fresh.push_back({color, {}});
  std::vector<InkPiece>& fresh = news_.fresh.back().pieces;
  fresh.insert(fresh.end(), pieces.begin(), pieces.end());
}

void InkStrokes::SetTail(std::vector<InkPiece> tail) {
  if (tail == tail_) return;
  for (const InkPiece& piece : tail_) news_.changed.Add(PixelsOf(piece, size_));
  for (const InkPiece& piece : tail) news_.changed.Add(PixelsOf(piece, size_));
  tail_ = std::move(tail);
  news_.tail_changed = true;
}

void InkStrokes::Rebuild(const Damage& pixels, const std::vector<Vec4f>& groups_before) {
  news_.rebuild.Add(pixels);
  // Strokes that were drawn as two groups and now are one, or the reverse, lie in other textures.
  if (GroupColors() != groups_before) news_.rebuild.AddAll();
  news_.changed.Add(news_.rebuild);
}

InkNews InkStrokes::TakeNews() { return std::exchange(news_, InkNews(size_)); }

std::vector<Vec4f> InkStrokes::GroupColors() const {
  std::vector<Vec4f> colors;
  for (const Held& stroke : strokes_) {
    if (IsEmpty(stroke.pixels)) continue;
    if (colors.empty() || colors.back() != stroke.ink->color) colors.push_back(stroke.ink->color);
  }
  return colors;
}

std::vector<InkGroupPieces> InkStrokes::PiecesIn(const PixelRect& rect) const {
  std::vector<InkGroupPieces> groups;
  for (const Held& stroke : strokes_) {
    if (IsEmpty(stroke.pixels)) continue;
    const Vec4f& color = stroke.ink->color;
    if (groups.empty() || groups.back().color != color) groups.push_back({color, {}});
    if (IsEmpty(Intersection(stroke.pixels, rect))) continue;
    std::vector<InkPiece> pieces = PiecesOf(*stroke.ink);
    // Its last dot belongs to the tail while it is drawn.
    if (stroke.ink == live_ && EndsInDot(*live_)) pieces.pop_back();
    std::copy_if(pieces.begin(), pieces.end(), std::back_inserter(groups.back().pieces),
                 [&](const InkPiece& piece) {
                   return !IsEmpty(Intersection(PixelsOf(piece, size_), rect));
                 });
  }
  return groups;
}

Damage InkStrokes::Extent() const {
  Damage extent(size_);
  for (const Held& stroke : strokes_) extent.Add(stroke.pixels);
  return extent;
}

Damage InkStrokes::LastGroupExtent() const {
  Damage extent(size_);
  const std::vector<Vec4f> colors = GroupColors();
  for (auto stroke = strokes_.rbegin(); stroke != strokes_.rend(); ++stroke) {
    if (IsEmpty(stroke->pixels)) continue;
    if (stroke->ink->color != colors.back()) break;
    extent.Add(stroke->pixels);
  }
  return extent;
}

}  // namespace parti::render
