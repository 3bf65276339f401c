// A session under test: commands as text, lines drawn by a steady hand, rules as text.
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "app/session.h"

namespace parti::app {

/// Fixtures derive from this or own one.
class SessionDriver {
 public:
  explicit SessionDriver(SessionOptions options = {}) : session(options) {}

  /// A command that must succeed.
  void Do(const std::string& line) {
    const auto command = ParseCommand(line);
    ASSERT_TRUE(command) << line << ": " << command.error().message;
    const auto done = session.Execute(*command);
    ASSERT_TRUE(done) << line << ": " << done.error().message;
  }

  /// A command that must fail, and change nothing.
  Error Refused(const std::string& line) {
    const auto command = ParseCommand(line);
    EXPECT_TRUE(command) << line << ": " << command.error().message;
    const std::string before = Rules();
    const Timeline::Span span = session.timeline().span();
    const size_t history = session.history().size();
    const auto done = session.Execute(*command);
    EXPECT_FALSE(done) << line;
    EXPECT_EQ(Rules(), before) << line;
    EXPECT_TRUE(session.timeline().span() == span) << line;
    EXPECT_EQ(session.history().size(), history) << line;
    return done ? Error{ErrorCode::kNothingMade, ""} : done.error();
  }

  /// A line of the world in the session's view: 40 samples, 10 ms apart, slow at its ends.
  Stroke Line(const Vec3& a, const Vec3& b) const {
    const View view(session.state().camera);
    const Vec2 from = *view.Project(a), to = *view.Project(b);
    Stroke stroke;
    for (int i = 0; i < 40; ++i) {
      const double s = 0.5 - 0.5 * std::cos(kPi * i / 39);
      stroke.push_back({from + (to - from) * s, 0.01 * i});
    }
    return stroke;
  }

  void Draw(const Vec3& a, const Vec3& b) {
    const auto read = session.AddStroke(Line(a, b));
    ASSERT_TRUE(read) << read.error().message;
  }

  std::string Rules() const { return grammar::TextOf(session.state().model.trees()); }
  const SessionState& state() const { return session.state(); }
  /// How many shapes a query selects on the first lot.
  size_t Count(std::string_view query) const {
    return grammar::ProductOf(*grammar::ParseQuery(query), state().model.derived.at(0)->tree)
        ->size();
  }

  Session session;
};

}  // namespace parti::app
