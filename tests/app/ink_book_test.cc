#include "app/ink_book.h"

#include <gtest/gtest.h>

namespace parti::app {
namespace {

Stroke Line(double y) { return {{{0, y}, 0.1}, {{50, y}, 0.2}, {{100, y}, 0.3}}; }

SessionState WithStrokes(const std::vector<Stroke>& strokes) {
  SessionState state;
  for (const Stroke& stroke : strokes) {
    const auto number = static_cast<uint32_t>(state.sketch.strokes.size());
    state.sketch.strokes.push_back(
        std::make_shared<const DrawnStroke>(DrawnStroke{stroke, state.camera, number}));
  }
  return state;
}

TEST(InkBookTest, APostedStrokeKeepsItsIdWhenTheSessionHasIt) {
  InkBook book;
  const uint64_t id = book.NewId();
  book.Posted(id, 1, Line(10));
  const SessionState before = WithStrokes({});
  auto shown = book.Shown(before, before.camera, 0);
  ASSERT_EQ(shown.size(), 1u);
  EXPECT_EQ(shown[0].id, id);
  const auto ink = shown[0].ink;
  const SessionState after = WithStrokes({Line(10)});
  shown = book.Shown(after, after.camera, 1);
  ASSERT_EQ(shown.size(), 1u);
  EXPECT_EQ(shown[0].id, id);
  EXPECT_EQ(shown[0].ink, ink);
}

TEST(InkBookTest, AStrokeThatBecameSomethingIsGone) {
  InkBook book;
  book.Posted(book.NewId(), 1, Line(10));
  const SessionState state = WithStrokes({});
  EXPECT_TRUE(book.Shown(state, state.camera, 1).empty());
  EXPECT_TRUE(book.Shown(state, state.camera, 0).empty()) << "it does not come back";
}

TEST(InkBookTest, StrokesOfAnotherViewAreNotShown) {
  InkBook book;
  const SessionState state = WithStrokes({Line(10)});
  Camera elsewhere = state.camera;
  elsewhere.eye.x += 1;
  EXPECT_TRUE(book.Shown(state, elsewhere, 0).empty());
  EXPECT_EQ(book.Shown(state, state.camera, 0).size(), 1u);
}

TEST(InkBookTest, UnreadStrokesAreShownInTheOrderDrawn) {
  InkBook book;
  SessionState state = WithStrokes({Line(10), Line(20)});
  auto unread = *state.sketch.strokes[0];
  unread.number = 7;
  state.sketch.unread.emplace_back(std::make_shared<const DrawnStroke>(unread));
  EXPECT_EQ(book.Shown(state, state.camera, 0).size(), 3u);
}

TEST(InkBookTest, TheEraserTouchesWhatItPasses) {
  const SessionState state = WithStrokes({Line(10), Line(60), Line(200)});
  const auto touched = [&](const Vec2& a, const Vec2& b) {
    return InkBook::Touched(state, state.camera, a, b, 5);
  };
  EXPECT_EQ(touched({50, 0}, {50, 100}), (std::vector<uint32_t>{0, 1}))
      << "crossed between samples";
  EXPECT_EQ(touched({25, 64}, {26, 64}), (std::vector<uint32_t>{1})) << "near, between samples";
  EXPECT_TRUE(touched({50, 100}, {50, 150}).empty());
}

TEST(InkBookTest, HiddenStrokesComeBack) {
  InkBook book;
  const SessionState state = WithStrokes({Line(10), Line(60)});
  book.Hide({1});
  EXPECT_EQ(book.Shown(state, state.camera, 0).size(), 1u);
  book.Unhide();
  EXPECT_EQ(book.Shown(state, state.camera, 0).size(), 2u);
}

}  // namespace
}  // namespace parti::app
