// Which ink a canvas shows: strokes that are done, the one being drawn, and where it may go next.
// A value without GL: says what changed and what to draw; drawing it is InkLayer's.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "render/damage.h"
#include "render/ink_pieces.h"

namespace parti::render {

/// A stroke that is done. What has one id never changes.
struct InkStroke {
  uint64_t id = 0;
  std::shared_ptr<const Ink> ink;
};

/// Pieces of one colour, drawn as one.
struct InkGroupPieces {
  Vec4f color;
  std::vector<InkPiece> pieces;
};

/// What has happened since the last time it was asked.
struct InkNews {
  explicit InkNews(const glm::ivec2& size) : changed(size), rebuild(size) {}

  Damage changed;  ///< looks different now
  Damage rebuild;  ///< has to be drawn again from all strokes, after `fresh`
  std::vector<InkGroupPieces> fresh;
  bool tail_changed = false;
};

/// Consecutive strokes of one colour are drawn as one: where they cross, translucent ink is not
/// darker. The stroke being drawn comes last.
class InkStrokes {
 public:
  explicit InkStrokes(const glm::ivec2& size) : size_(size), news_(size) {}

  /// All strokes that are done, in order. Those whose ids were there stay as they are, so that a
  /// stroke which End left is not drawn again. One comparison a stroke before the first that is
  /// other; from there on O(strokes) and what changed.
  void SetStrokes(const std::vector<InkStroke>& strokes);

  /// Begins a stroke; one that is being drawn ends.
  void Begin(uint64_t id, const Vec4f& color);
  /// Goes on with the stroke being drawn; nothing without one. O(samples added).
  void Add(std::span<const Vec2f> points, std::span<const float> widths_px);
  /// Where the stroke may go from its last sample: replaces what was last said; Add takes it away.
  void Predict(std::span<const Vec2f> points, std::span<const float> widths_px);
  /// The stroke being drawn is done; it stays until SetStrokes says otherwise.
  void End();
  /// It never was.
  void Cancel();
  /// Another size of picture; everything is to be drawn again.
  void Resize(const glm::ivec2& size);
  bool drawing() const { return live_ != nullptr; }

  /// Whether anything looks different since TakeNews.
  bool changed() const { return !news_.changed.empty(); }
  /// Returns the news and forgets them.
  InkNews TakeNews();
  /// The tail of the stroke being drawn: its prediction, or the dot that it so far ends in.
  const std::vector<InkPiece>& tail() const { return tail_; }
  /// Colours of groups from first to last.
  std::vector<Vec4f> GroupColors() const;
  /// The pieces that touch rect, group by group, from first to last; the tail is not among them.
  /// O(strokes) and the samples of those that touch it.
  std::vector<InkGroupPieces> PiecesIn(const PixelRect& rect) const;
  /// Where all strokes lie, and those of the last group.
  Damage Extent() const;
  Damage LastGroupExtent() const;

 private:
  struct Held {
    uint64_t id = 0;
    std::shared_ptr<const Ink> ink;
    PixelRect pixels;  // of all its pieces
  };
  /// The done strokes from `first` on are these now; returns where that looks different.
  Damage ReplaceFrom(size_t first, std::span<const InkStroke> strokes);
  void SetTail(std::vector<InkPiece> tail);
  void AddFresh(std::vector<InkPiece> pieces);
  /// What was drawn before is to be drawn again in `pixels`, or everywhere if groups are others.
  void Rebuild(const Damage& pixels, const std::vector<Vec4f>& groups_before);

  glm::ivec2 size_;
  std::vector<Held> strokes_;
  std::shared_ptr<Ink> live_;  ///< of the last stroke while it is drawn, else null
  std::vector<InkPiece> tail_;
  InkNews news_;
};

}  // namespace parti::render
