#include "tests/pen/pen_model.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace parti::tests {
namespace {

constexpr Vec2 kTablet{280, 175};

std::vector<PenEvent> Line(uint64_t seed, const PenModelParameters& parameters = {}) {
  Random random(seed);
  return DrawStroke({{50, 80}, {150, 80}}, kTablet, 1.0, parameters, &random);
}

std::vector<PenEvent> InContact(const std::vector<PenEvent>& events) {
  std::vector<PenEvent> contact;
  bool down = false;
  for (const PenEvent& e : events) {
    if (e.kind == PenEvent::Kind::kDown) down = true;
    if (e.kind == PenEvent::Kind::kUp) down = false;
    if (down) contact.push_back(e);
  }
  return contact;
}

TEST(PenModelTest, TheSameSeedDrawsTheSameStroke) {
  EXPECT_EQ(Line(7), Line(7));
  EXPECT_NE(Line(7), Line(8));
}

TEST(PenModelTest, AStrokeComesIntoAndGoesOutOfProximity) {
  const auto events = Line(1);
  EXPECT_EQ(events.front().kind, PenEvent::Kind::kProximityIn);
  EXPECT_EQ(events.back().kind, PenEvent::Kind::kProximityOut);
  const auto count = [&](PenEvent::Kind kind) {
    return std::count_if(events.begin(), events.end(), [&](auto& e) { return e.kind == kind; });
  };
  EXPECT_EQ(count(PenEvent::Kind::kDown), 1);
  EXPECT_EQ(count(PenEvent::Kind::kUp), 1);
}

TEST(PenModelTest, TimesNeverRunBackwardsAndReportsComeAt200Hz) {
  const auto contact = InContact(Line(3));
  for (size_t i = 1; i < contact.size(); ++i) EXPECT_GT(contact[i].t_s, contact[i - 1].t_s);
  const double mean = (contact.back().t_s - contact.front().t_s) / (contact.size() - 1);
  EXPECT_NEAR(mean, 0.005, 1e-4);
}

TEST(PenModelTest, TheLineGoesWhereItWasAimed) {
  PenModelParameters steady;
  steady.hook_probability = 0;
  for (uint64_t seed = 0; seed < 50; ++seed) {
    const auto contact = InContact(Line(seed, steady));
    EXPECT_LT(glm::distance(contact.front().position_mm, Vec2(50, 80)), 2.5) << seed;
    EXPECT_LT(glm::distance(contact.back().position_mm, Vec2(150, 80)), 4) << seed;
  }
}

TEST(PenModelTest, SpeedIsBellShaped) {
  const auto contact = InContact(Line(5));
  const size_t n = contact.size();
  const auto speed = [&](size_t i) {  // over four reports, against the grid's rounding
    return glm::distance(contact[i + 4].position_mm, contact[i].position_mm);
  };
  size_t fastest = 0;
  for (size_t i = 0; i + 4 < n; ++i) {
    if (speed(i) > speed(fastest)) fastest = i;
  }
  EXPECT_GT(fastest, n / 5);
  EXPECT_LT(fastest, 4 * n / 5);
  EXPECT_GT(speed(fastest), 4 * speed(0));
  EXPECT_GT(speed(fastest), 4 * speed(n - 5));
}

TEST(PenModelTest, CornersAreSlow) {
  Random random(4);
  PenModelParameters steady;
  steady.hook_probability = 0;
  const auto contact =
      InContact(DrawStroke({{50, 50}, {150, 50}, {150, 120}}, kTablet, 0, steady, &random));
  const auto corner = std::min_element(contact.begin(), contact.end(), [](auto& a, auto& b) {
    return glm::distance(a.position_mm, Vec2(150, 50)) <
           glm::distance(b.position_mm, Vec2(150, 50));
  });
  const auto at = static_cast<size_t>(corner - contact.begin());
  const auto step = [&](size_t i) {
    return glm::distance(contact[i + 4].position_mm, contact[i - 4].position_mm);
  };
  double before = 0, after = 0;
  for (size_t i = 4; i + 4 < contact.size(); ++i) {
    (i < at ? before : after) = std::max(i < at ? before : after, step(i));
  }
  EXPECT_LT(step(at), 0.5 * before);
  EXPECT_LT(step(at), 0.5 * after);
}

TEST(PenModelTest, EverythingLiesOnTheTablet) {
  Random random(1);
  const auto events = DrawStroke({{0, 0}, {280, 175}}, kTablet, 0, {}, &random);
  for (const PenEvent& e : events) {
    EXPECT_GE(e.position_mm.x, 0);
    EXPECT_LE(e.position_mm.x, kTablet.x);
    EXPECT_GE(e.position_mm.y, 0);
    EXPECT_LE(e.position_mm.y, kTablet.y);
    EXPECT_GE(*e.pressure, 0);
    EXPECT_LE(*e.pressure, 1);
  }
}

}  // namespace
}  // namespace parti::tests
