// The thread that writes: what is asked of it comes back after what it has to tell.
#include "app/document_thread.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

#include "tests/support/program.h"

namespace parti::app {
namespace {

TEST(DocumentThreadTest, WhatItIsAskedToDoIsDoneWhenItsNewsAreOut) {
  const std::string folder = tests::TestFolder();
  std::atomic<bool> named = false;
  DocumentThread thread({folder + "/data", folder + "/state"},
                        [&named](const DocumentStatus& status, int64_t) {
                          std::this_thread::sleep_for(std::chrono::milliseconds(20));
                          named = status.named;
                        });
  const Session session;
  const auto saved = thread.Run([&](DocumentKeeper& keeper) {
    return keeper.New(DocumentOf(session), false).and_then([&] {
      return keeper.SaveAs(folder + "/house.parti", DocumentOf(session), false);
    });
  });
  EXPECT_TRUE(named);
  ASSERT_TRUE(saved) << FormatError(saved.error());
}

}  // namespace
}  // namespace parti::app
