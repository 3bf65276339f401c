// A document as a drawing: replayed, it is the same building.
#include "app/document_report.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "app/replay.h"
#include "base/text_file.h"
#include "tests/app/killed_session.h"
#include "tests/support/program.h"

namespace parti::app {
namespace {

using ::testing::HasSubstr;
using ::testing::IsEmpty;

Session Played(const input::Drawing& drawing) {
  Session session;
  ReplayReport report;
  const auto played = Replay(drawing, &session, &report);
  EXPECT_TRUE(played) << FormatError(played.error());
  EXPECT_THAT(report.unread, IsEmpty());
  return session;
}

/// A session that has done all requests; each stroke begins at 0 s, as after a restart.
Session Done(const std::vector<SessionRequest>& requests) {
  Session session;
  for (const SessionRequest& request : requests) {
    if (const auto* command = std::get_if<Command>(&request)) {
      EXPECT_TRUE(session.Execute(*command));
      continue;
    }
    Stroke stroke = std::get<Stroke>(request);
    const double begins = std::floor(stroke.front().t_s);
    for (StrokeSample& sample : stroke) sample.t_s -= begins;
    EXPECT_TRUE(session.AddStroke(stroke));
  }
  return session;
}

TEST(DocumentReportTest, TheHouseReplayedFromItsDocumentIsTheSameHouse) {
  std::vector<SessionRequest> requests = tests::HouseRequests();
  for (const char* line : {"undo", "undo", "redo", "redo"})
    requests.emplace_back(*ParseCommand(line));
  const Session session = Done(requests);
  const auto drawing = DrawingOf(DocumentOf(session));
  ASSERT_TRUE(drawing) << FormatError(drawing.error());
  const auto text = input::WriteDrawing(*drawing);
  ASSERT_TRUE(text) << FormatError(text.error());
  const auto reading = input::ReadDrawing(*text);
  ASSERT_FALSE(reading.damage);
  const Session again = Played(reading.drawing);
  EXPECT_EQ(grammar::TextOf(again.state().model.trees()),
            grammar::TextOf(session.state().model.trees()));
  EXPECT_EQ(DocumentOf(again).history, DocumentOf(session).history);
}

TEST(DocumentReportTest, TheCommandWritesADrawingThatCanBeReplayed) {
  const std::string folder = tests::TestFolder();
  const std::string house = folder + "/house.parti", pen = folder + "/house.pen";
  ASSERT_TRUE(SaveDocument(DocumentOf(Done(tests::HouseRequests())), house));
  EXPECT_EQ(tests::RunParti({"report", house, pen}).status, 0);
  const auto run = tests::RunParti({"replay", pen, "--json"});
  EXPECT_EQ(run.status, 0) << run.errors;
  EXPECT_THAT(run.output, HasSubstr("\"nodes\":13"));
}

TEST(DocumentReportTest, WhatIsEmptyOrMissingIsSaid) {
  EXPECT_THAT(DrawingOf(DocumentOf(Session())).error().message, HasSubstr("nothing has been done"));
  Document document = DocumentOf(Session());
  document.history = {"stroke 4"};
  EXPECT_THAT(DrawingOf(document).error().message, HasSubstr("stroke 4 is missing"));
  const auto run = tests::RunParti({"report", "missing.parti", "out.pen"});
  EXPECT_EQ(run.status, 1);
  EXPECT_THAT(run.errors, HasSubstr("missing.parti"));
}

}  // namespace
}  // namespace parti::app
