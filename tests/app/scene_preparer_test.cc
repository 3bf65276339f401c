#include "app/scene_preparer.h"

#include <gtest/gtest.h>
#include <poll.h>

namespace parti::app {
namespace {

std::shared_ptr<const SessionState> StateOn(const std::string& lot) {
  auto state = std::make_shared<SessionState>();
  auto lots = ParseLots(lot);
  EXPECT_TRUE(lots);
  auto model = BuiltOn(std::move(*lots), {});
  EXPECT_TRUE(model);
  state->model = std::move(*model);
  return state;
}

/// The scene of this state, once it is made.
PreparedScene Await(const ScenePreparer& preparer,
                    const std::shared_ptr<const SessionState>& state) {
  for (auto newest = preparer.newest();; newest = preparer.newest()) {
    if (newest && newest->state == state) return *newest;
    pollfd readable{preparer.ready().fd(), POLLIN, 0};
    EXPECT_EQ(poll(&readable, 1, 10'000), 1) << "no scene within 10 s";
    preparer.ready().Clear();
  }
}

TEST(ScenePreparerTest, AModelBecomesAScene) {
  ScenePreparer preparer;
  EXPECT_FALSE(preparer.newest());
  const auto state = StateOn("rect(20,14)");
  preparer.Ask(state);
  const PreparedScene made = Await(preparer, state);
  ASSERT_EQ(made.scene->faces.size(), 1u);
  EXPECT_EQ(made.scene->faces[0].id, 1u);
}

TEST(ScenePreparerTest, TheSameModelKeepsItsScene) {
  ScenePreparer preparer;
  const auto state = StateOn("rect(20,14)");
  preparer.Ask(state);
  const auto scene = Await(preparer, state).scene;
  const auto looked_elsewhere = std::make_shared<SessionState>(*state);
  preparer.Ask(looked_elsewhere);
  EXPECT_EQ(Await(preparer, looked_elsewhere).scene, scene);
  const auto other = StateOn("rect(9,9)");
  preparer.Ask(other);
  EXPECT_NE(Await(preparer, other).scene, scene);
}

TEST(ScenePreparerTest, TheNewestOfManyWins) {
  ScenePreparer preparer;
  std::shared_ptr<const SessionState> last;
  for (int i = 1; i <= 50; ++i) {
    last = StateOn("rect(20," + std::to_string(i) + ")");
    preparer.Ask(last);
  }
  Await(preparer, last);
  EXPECT_FALSE(preparer.busy());
}

}  // namespace
}  // namespace parti::app
