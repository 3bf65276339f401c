#include "app/trial.h"

#include <gtest/gtest.h>
#include <poll.h>

#include "app/session.h"

namespace parti::app {
namespace {

std::shared_ptr<const SessionState> Extruded() {
  Session session;
  EXPECT_TRUE(session.Execute(*ParseCommand("lot rect(20,14)")));
  EXPECT_TRUE(session.Execute(*ParseCommand("node .Lot --> extrude(9) Mass")));
  return std::make_shared<const SessionState>(session.state());
}

std::string RulesOf(const SessionState& state) { return grammar::TextOf(state.model.trees()); }

TEST(TrialTest, ANumberIsTriedWithoutChangingTheState) {
  const auto state = Extruded();
  const auto tried = TriedOut({state, {"distance", 12}});
  EXPECT_NE(RulesOf(*tried).find("extrude(12)"), std::string::npos);
  EXPECT_NE(RulesOf(*state).find("extrude(9)"), std::string::npos);
}

TEST(TrialTest, WhatCantBeLeavesTheState) {
  const auto state = Extruded();
  EXPECT_EQ(TriedOut({state, {"no such dial", 12}}), state);
}

TEST(TrialTest, NothingIsShownOnceTheNumberIsLetGo) {
  const auto state = Extruded();
  Trials trials;
  EXPECT_TRUE(trials.Set(SetNumber{"distance", 12}, state));
  EXPECT_FALSE(trials.Set(SetNumber{"distance", 12}, state)) << "the same";
  pollfd ready{trials.ready().fd(), POLLIN, 0};
  ASSERT_EQ(poll(&ready, 1, 10'000), 1);
  const auto tried = trials.TakeNewest();
  ASSERT_NE(tried, nullptr);
  EXPECT_NE(RulesOf(*tried).find("extrude(12)"), std::string::npos);
  EXPECT_TRUE(trials.Set(std::nullopt, state));
  EXPECT_FALSE(trials.going_on());
  EXPECT_EQ(trials.TakeNewest(), nullptr);
}

}  // namespace
}  // namespace parti::app
