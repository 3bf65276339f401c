// kill -9 at random moments: the document opens, and holds every command that was acknowledged.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <random>

#include "app/document.h"
#include "tests/app/killed_session.h"
#include "tests/support/data.h"
#include "tests/support/program.h"

namespace parti::app {
namespace {

namespace fs = std::filesystem;
using std::chrono::microseconds;
using ::testing::AnyOf;
using ::testing::SizeIs;
using tests::KilledSession;

/// What a document holds after each number of requests.
struct Expected {
  std::vector<std::string> history;  ///< n entries
  std::vector<std::string> rules;    ///< n + 1 texts
};

Expected ExpectedOf(const std::vector<SessionRequest>& requests) {
  Session session;
  Expected expected;
  expected.rules.push_back(grammar::TextOf(session.state().model.trees()));
  for (const SessionRequest& request : requests) {
    if (const auto* stroke = std::get_if<Stroke>(&request)) {
      static_cast<void>(session.AddStroke(*stroke));
    } else {
      static_cast<void>(session.Execute(std::get<Command>(request)));
    }
    expected.rules.push_back(grammar::TextOf(session.state().model.trees()));
  }
  expected.history = DocumentOf(session).history;
  return expected;
}

class DocumentKillTest : public ::testing::Test {
 protected:
  DocumentKillTest() : folder_(tests::TestFolder()), path_(folder_ + "/house.parti") {
    options_.folders = {folder_ + "/data", folder_ + "/state"};
    options_.path = path_;
  }

  /// The file holds the first n requests for some n >= acknowledged, and what was kept of the next.
  static void ExpectPrefix(const Document& document, const Expected& expected,
                           const std::vector<SessionRequest>& requests, uint64_t acknowledged) {
    const size_t n = document.history.size();
    ASSERT_GE(n, acknowledged);
    ASSERT_LE(n + document.posted.size(), expected.history.size());
    for (size_t i = 0; i < n; ++i) ASSERT_EQ(document.history[i], expected.history[i]) << i;
    EXPECT_EQ(grammar::TextOf(*PresentOf(document).rules), expected.rules[n]);
    for (size_t i = 0; i < document.posted.size(); ++i) {
      const auto* stroke = std::get_if<Stroke>(&requests[n + i]);
      EXPECT_EQ(document.posted[i].command, stroke ? "" : expected.history[n + i]);
      if (stroke) {
        EXPECT_EQ(document.posted[i].stroke, *stroke);
      }
    }
    EXPECT_TRUE(SessionOf(document, {}));
  }
  microseconds Moment(int most) {
    return microseconds(std::uniform_int_distribution<int>(0, most)(random_));
  }
  uint64_t Number(size_t most) { return std::uniform_int_distribution<uint64_t>(0, most)(random_); }

  std::string folder_, path_;
  SessionThreadOptions options_;
  std::mt19937 random_{20261122};  // NOLINT(cert-msc51-cpp): the same moments in every run
};

TEST_F(DocumentKillTest, TwoHundredKillsLoseNothingThatWasAcknowledged) {
  auto requests = tests::HouseRequests();
  requests.resize(18);  // up to the windows: strokes, picks, names, a view; quick enough for 200
  const Expected expected = ExpectedOf(requests);
  uint64_t partly = 0;
  for (int kill = 0; kill < 200; ++kill) {
    SCOPED_TRACE(kill);
    ASSERT_TRUE(SaveDocument(DocumentOf(Session()), path_));
    KilledSession session(options_, requests);
    session.WaitFor(Number(requests.size() - 1));
    const uint64_t acknowledged = session.KillAfter(Moment(2000));
    const auto document = OpenDocument(path_);
    ASSERT_TRUE(document) << FormatError(document.error());
    ExpectPrefix(*document, expected, requests, acknowledged);
    if (HasFatalFailure()) return;
    if (acknowledged < requests.size()) ++partly;
  }
  EXPECT_GE(partly, 50u) << "most kills are meant to come in the middle";
}

TEST_F(DocumentKillTest, KilledAgainAndAgainItEndsWithTheSameHouse) {
  const auto requests = tests::HouseRequests();
  const Expected expected = ExpectedOf(requests);
  ASSERT_TRUE(SaveDocument(DocumentOf(Session()), path_));
  for (int kill = 0; kill < 60; ++kill) {
    const auto document = OpenDocument(path_);
    ASSERT_TRUE(document) << FormatError(document.error());
    const size_t known = document->history.size() + document->posted.size();
    const std::vector<SessionRequest> rest(requests.begin() + static_cast<std::ptrdiff_t>(known),
                                           requests.end());
    KilledSession session(options_, rest);
    if (rest.empty() || kill > 25) session.WaitFor(rest.size());
    session.KillAfter(Moment(60000));
    if (document->history.size() == requests.size()) break;
  }
  const auto document = OpenDocument(path_);
  ASSERT_TRUE(document);
  EXPECT_EQ(document->history, expected.history);
  EXPECT_EQ(grammar::TextOf(*PresentOf(*document).rules), expected.rules.back());
}

TEST_F(DocumentKillTest, KilledWhileSavingAsTheOldOrTheNewFileIsWhole) {
  std::vector<SessionRequest> requests = {*ParseCommand("lot rect(20,14)")};
  for (int i = 0; i < 12; ++i) {
    const char* other = i % 2 == 0 ? "/a.parti" : "/b.parti";
    requests.emplace_back(DocumentRequest{
        .kind = DocumentRequest::Kind::kSaveAs, .path = folder_ + other, .replace = true});
    requests.emplace_back(*ParseCommand("node .Lot --> extrude(12) Mass"));
  }
  ASSERT_TRUE(SaveDocument(DocumentOf(Session()), path_));
  for (int kill = 0; kill < 20; ++kill) {
    for (const char* name : {"/a.parti", "/b.parti"}) fs::remove(folder_ + name);
    ASSERT_TRUE(SaveDocument(DocumentOf(Session()), path_));
    KilledSession session(options_, requests);
    session.WaitFor(Number(requests.size() - 1));
    const uint64_t acknowledged = session.KillAfter(Moment(4000));
    size_t most = 0;
    for (const char* name : {"/a.parti", "/b.parti", "/house.parti"}) {
      if (!fs::exists(folder_ + name)) continue;
      const auto document = OpenDocument(folder_ + name);
      ASSERT_TRUE(document) << name << FormatError(document.error());
      most = std::max(most, document->history.size());
    }
    EXPECT_GE(most, (acknowledged + 1) / 2) << "every second request is a command";
  }
}

TEST_F(DocumentKillTest, KilledWhileAnOldDocumentIsBroughtToTheNewFormatItIsOneOrTheOther) {
  const std::string old = tests::SourceFile("tests/app/documents/format_1.parti");
  int migrated = 0;
  for (int kill = 0; kill < 40; ++kill) {
    for (const char* rest : {"", "-wal", "-shm", "-journal"}) fs::remove(path_ + rest);
    fs::copy_file(old, path_);
    KilledSession session(options_, {*ParseCommand("take none")});
    session.KillAfter(Moment(12000));
    const auto document = OpenDocument(path_);
    ASSERT_TRUE(document) << FormatError(document.error());
    EXPECT_THAT(document->history.size(), AnyOf(7u, 8u));
    EXPECT_THAT(document->strokes, SizeIs(3));
    EXPECT_THAT(grammar::TextOf(*PresentOf(*document).rules), ::testing::HasSubstr("extrude(19)"));
    if (document->history.size() == 8) ++migrated;
  }
  EXPECT_LT(migrated, 40) << "some kills are meant to come before it is done";
}

}  // namespace
}  // namespace parti::app
