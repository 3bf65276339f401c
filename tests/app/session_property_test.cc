// What must hold whatever is done in whatever order: seeded random sessions.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include "app/session_record.h"
#include "base/random.h"
#include "grammar/operation.h"
#include "tests/app/session_driver.h"

namespace parti::app {
namespace {

/// Everything of a state that can be seen, as text; not the camera, which undo leaves alone.
std::string Seen(const SessionState& state) {
  std::string text = grammar::TextOf(state.model.trees());
  for (const Lot& lot : state.model.lots()) text += lot.name + " ";
  for (const ShapeRef& ref : VisibleShapes(state.model)) {
    const grammar::Item& item = ShapeAt(state.model, ref).item;
    text += IdOf(state.model, ref) + fmt::format(":{},{} ", item.scope.size.x, item.scope.size.y);
  }
  for (const NodeProblem& problem : ProblemsOf(state.model)) {
    text += PathText(problem.path) + problem.error.message;
  }
  for (const auto& drawn : state.sketch.strokes) text += fmt::format("+{}", drawn->number);
  for (const auto& drawn : state.sketch.unread) text += fmt::format("-{}", drawn->number);
  if (state.sketch.query) text += "on " + grammar::TextOf(*state.sketch.query);
  if (state.sketch.target) text += "at " + IdOf(state.model, *state.sketch.target);
  for (const auto& line : state.sketch.lines.lines) text += fmt::format("{}", line.world.a.x);
  for (const auto& s : state.sketch.suggestions) text += grammar::TextOf(s.action);
  for (const ShapeRef& ref : state.selection.shapes) text += "tap " + IdOf(state.model, ref);
  for (const auto& c : state.selection.candidates) text += c.reading + grammar::TextOf(c.query);
  for (const NamedView& view : state.views) text += view.name;
  text += fmt::format("hand {}{}", PathText(state.in_hand), state.just_made);
  return text;
}

/// A session led by chance through every command; most are valid, many are not.
class RandomSession : public SessionDriver {
 public:
  explicit RandomSession(uint64_t seed, SessionOptions options = {})
      : SessionDriver(options), random_(seed) {
    Do("view eye 42 17 47 target 10 8.5 7 fov 36 size 1600 1000");
    Do("lot rect(20,14)");
    Do("node .Lot --> extrude(12) Mass");
    Do("node .Mass --> comp(f) { side: Facade | top: Roof }");
  }

  void Step() {
    if (random_.Uniform() < 0.15) {
      const double x = random_.Uniform(1, 19), y = random_.Uniform(1, 11);
      // Fails where it means nothing; it is ink then, and a step all the same.
      static_cast<void>(session.AddStroke(Line({x, 0, 14}, {x, y, 14})));
      return;
    }
    if (const auto command = ParseCommand(Line())) {
      static_cast<void>(session.Execute(*command));
    } else {
      ADD_FAILURE() << command.error().message;
    }
  }

 private:
  using SessionDriver::Line;

  int Below(int n) { return static_cast<int>(random_.Next() % static_cast<uint64_t>(n)); }
  std::string Path() {
    std::string path = fmt::format("0/{}", Below(7));
    if (Below(4) == 0) path += fmt::format("/{}", Below(2));
    return path;
  }
  std::string Symbol() {
    return std::vector<std::string>{"Mass", "Facade", "Roof", "Floor", "A"}[Below(5)];
  }
  std::string Line() {
    switch (Below(22)) {
      case 0:
        return "node ." + Symbol() + " --> split(y) { { ~3: Floor }* }";
      case 1:
        return "node ." + Symbol() + " --> extrude(2) A";
      case 2:
        return "node ." + Symbol() + " --> offset(-0.5) { inside: A | border: Floor }";
      case 3:
        return "take " + Path();
      case 4:
        return "take none";
      case 5:
        return "switch " + Path() + (Below(2) == 0 ? " off" : " on");
      case 6:
        return "move " + Path() + " to " + Path();
      case 7:
        return "delete " + Path();
      case 8:
        return fmt::format("set distance {}", Below(20));
      case 9:
        return "query ." + Symbol();
      case 10:
        return fmt::format("query {}", Below(4));
      case 11:
        return fmt::format("select 0/{}/{}", 1 + Below(3), Below(3));
      case 12:
        return "select 0/0 0/1";
      case 13:
        return "rename-symbol " + Symbol() + " " + Symbol();
      case 14:
        return "name " + Symbol() + " " + Symbol();
      case 15:
        return fmt::format("erase {}", Below(30));
      case 16:
        return fmt::format("pick {}", 1 + Below(2));
      case 17:
        return fmt::format("keep-view v{}", Below(3));
      case 18:
        return fmt::format("{}-view v{}", Below(2) == 0 ? "go" : "drop", Below(3));
      case 19:
        return "undo";
      case 20:
        return "redo";
      default:
        return "clear";
    }
  }

  Random random_;
};

class SessionPropertyTest : public ::testing::TestWithParam<uint64_t> {};

TEST_P(SessionPropertyTest, UndoingAllAndRedoingAllGivesEveryStateAgain) {
  RandomSession session(GetParam());
  for (int i = 0; i < 60; ++i) session.Step();
  while (session.session.Execute(Redo{})) {
  }
  std::vector<std::string> seen = {Seen(session.state())};
  while (session.session.Execute(Undo{})) seen.push_back(Seen(session.state()));
  EXPECT_GT(seen.size(), 10u);
  while (true) {
    EXPECT_EQ(Seen(session.state()), seen.back());
    seen.pop_back();
    if (!session.session.Execute(Redo{})) break;
  }
  EXPECT_TRUE(seen.empty());
}

TEST_P(SessionPropertyTest, AStateIsRestoredFromItsRecordAndUndoFromRecordsAlone) {
  RandomSession session(GetParam());
  // Little memory for states: distant undo derives again.
  SessionOptions poor;
  poor.undo.bytes = 1'500'000;
  RandomSession twin(GetParam(), poor);
  for (int i = 0; i < 60; ++i) {
    session.Step();
    twin.Step();
    const auto restored = Restore(RecordOf(session.state()), {});
    ASSERT_TRUE(restored) << restored.error().message;
    ASSERT_EQ(Seen(*restored), Seen(session.state())) << i;
    ASSERT_EQ(restored->camera, session.state().camera);
    ASSERT_EQ(Seen(twin.state()), Seen(session.state())) << i;
  }
}

TEST_P(SessionPropertyTest, ASessionThatIsBuiltFromItsRecordsGoesOnAlike) {
  RandomSession session(GetParam());
  for (int i = 0; i < 40; ++i) session.Step();
  const Timeline& timeline = session.session.timeline();
  const auto [first, now, last] = timeline.span();
  std::vector<SessionRecord> records;
  for (uint64_t i = first; i <= last; ++i) records.push_back(timeline.step(i).record);
  auto present = Restore(records[now - first], {});
  ASSERT_TRUE(present);
  Session reopened(Timeline(std::move(records), first, now, std::move(*present), {}),
                   session.session.strokes_drawn());
  EXPECT_EQ(Seen(reopened.state()), Seen(session.state()));
  while (session.session.Execute(Undo{})) {
    ASSERT_TRUE(reopened.Execute(Undo{}));
    EXPECT_EQ(Seen(reopened.state()), Seen(session.state()));
  }
  EXPECT_FALSE(reopened.Execute(Undo{}));
}

INSTANTIATE_TEST_SUITE_P(Seeds, SessionPropertyTest, ::testing::Range<uint64_t>(1, 9));

}  // namespace
}  // namespace parti::app
