#include "render/ink_pieces.h"

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <limits>

namespace parti::render {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN();

std::vector<InkPiece> AllPieces(const Ink& ink) {
  std::vector<InkPiece> pieces;
  AppendPieces(ink, 0, &pieces);
  return pieces;
}

RC_GTEST_PROP(InkPieceProperties, Property1_SampleBySampleGivesTheSamePiecesAsAllAtOnce, ()) {
  Ink ink;
  std::vector<InkPiece> grown;
  for (int n = *rc::gen::inRange(1, 20); n > 0; --n) {
    const size_t from = ink.points.size();
    for (int batch = *rc::gen::inRange(1, 4); batch > 0; --batch) {
      const float x = *rc::gen::inRange(0, 3) ? static_cast<float>(ink.points.size()) : kNan;
      ink.points.emplace_back(x, 1);
      ink.widths_px.push_back(2);
    }
    AppendPieces(ink, from, &grown);
    if (EndsInDot(ink)) grown.pop_back();
  }
  std::vector<InkPiece> all = AllPieces(ink);
  if (EndsInDot(ink)) all.pop_back();
  RC_ASSERT(grown == all);
}

TEST(InkPieces, ALoneSampleIsADotAndTwoMakeALine) {
  Ink ink{{{3, 4}}, {2}, {}};
  EXPECT_EQ(AllPieces(ink), (std::vector<InkPiece>{{{3, 4}, {3, 4}, {1, 1}}}));
  EXPECT_TRUE(EndsInDot(ink));
  ink.points.emplace_back(5, 4);
  EXPECT_EQ(AllPieces(ink), (std::vector<InkPiece>{{{3, 4}, {5, 4}, {1, 0.5f}}}));
  EXPECT_FALSE(EndsInDot(ink));
  EXPECT_FALSE(EndsInDot({}));
}

TEST(InkPieces, WidthsAreMadeDrawable) {
  const Ink ink{{{0, 0}, {1, 0}, {2, 0}, {3, 0}}, {kNan, -5, 1e30f}, {}};
  const std::vector<InkPiece> pieces = AllPieces(ink);
  ASSERT_EQ(pieces.size(), 3u);
  EXPECT_EQ(pieces[0].radii, Vec2f(0.5f, 0));
  EXPECT_EQ(pieces[2].radii, Vec2f(kWidestInk_px / 2, 0.5f));
}

TEST(InkPieces, PixelsOfAPieceReachOnePixelBeyondItsInk) {
  EXPECT_EQ(PixelsOf({{10, 10}, {20, 10}, {2, 1}}, {100, 100}), (PixelRect{7, 7, 16, 6}));
  EXPECT_EQ(PixelsOf({{0, 0}, {1e7f, 0}, {1, 1}}, {100, 50}), (PixelRect{0, 0, 100, 2}));
}

}  // namespace
}  // namespace parti::render
