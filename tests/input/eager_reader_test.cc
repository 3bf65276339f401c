#include "input/eager_reader.h"

#include <fcntl.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <thread>

namespace parti::input {
namespace {

constexpr int kPatience_ms = 20'000;  // a busy machine

/// A device that keeps 4096 bytes: each becomes the code of a key.
class Keys {
 public:
  Keys() {
    EXPECT_EQ(::pipe2(ends_.data(), O_NONBLOCK | O_CLOEXEC), 0);
    EXPECT_EQ(::fcntl(ends_[1], F_SETPIPE_SZ, 4096), 4096);
  }
  ~Keys() {
    for (const int end : ends_) ::close(end);
  }
  Keys(const Keys&) = delete;
  Keys& operator=(const Keys&) = delete;

  int fd() const { return ends_[0]; }

  Result<std::vector<InputEvent>> Read() const {
    std::array<uint8_t, 100> bytes{};
    std::vector<InputEvent> events;
    const ssize_t count = ::read(ends_[0], bytes.data(), bytes.size());
    for (ssize_t i = 0; i < count; ++i) {
      if (bytes[i] == kBroken) return Fail(ErrorCode::kDevice, "broken");
      KeyEvent key;
      key.code = bytes[i];
      events.emplace_back(key);
    }
    return events;
  }

  /// Whether it could keep it.
  bool Send(uint8_t code) const { return ::write(ends_[1], &code, 1) == 1; }

  static constexpr uint8_t kBroken = 255;

 private:
  std::array<int, 2> ends_{};
};

bool Readable(int fd, int wait_ms) {
  pollfd waiting{fd, POLLIN, 0};
  return ::poll(&waiting, 1, wait_ms) == 1;
}

TEST(EagerReader, TakesWhatTheDeviceWouldHaveDroppedWhileNobodyAsks) {
  const Keys keys;
  EagerReader reader(keys.fd(), [&] { return keys.Read(); });
  constexpr size_t kMany = 20'000;
  for (size_t i = 0; i < kMany; ++i) {
    while (!keys.Send(static_cast<uint8_t>(i % 200))) {
      std::this_thread::sleep_for(std::chrono::milliseconds(1));  // until the reader makes room
    }
  }
  std::vector<InputEvent> all;
  while (all.size() < kMany) {
    ASSERT_TRUE(Readable(reader.fd(), kPatience_ms)) << all.size();
    const auto events = reader.Take();
    ASSERT_TRUE(events);
    all.insert(all.end(), events->begin(), events->end());
  }
  ASSERT_EQ(all.size(), kMany);
  for (size_t i = 0; i < kMany; ++i) EXPECT_EQ(std::get<KeyEvent>(all[i]).code, i % 200);
  EXPECT_FALSE(Readable(reader.fd(), 0));
}

TEST(EagerReader, TakeAlsoReadsWhatHasOnlyJustCome) {
  const Keys keys;
  EagerReader reader(keys.fd(), [&] { return keys.Read(); });
  for (uint8_t code = 0; code < 100; ++code) {
    ASSERT_TRUE(keys.Send(code));
    const auto events = reader.Take();
    ASSERT_TRUE(events);
    ASSERT_EQ(events->size(), 1u);
    EXPECT_EQ(std::get<KeyEvent>(events->front()).code, code);
  }
}

TEST(EagerReader, NothingIsReadWhileWorkIsDoneAlone) {
  const Keys keys;
  std::atomic<int> reads = 0;
  EagerReader reader(keys.fd(), [&] {
    ++reads;
    return keys.Read();
  });
  reader.Alone([&] {
    const int before = reads;
    ASSERT_TRUE(keys.Send(1));
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    EXPECT_EQ(reads, before);
  });
  EXPECT_TRUE(Readable(reader.fd(), kPatience_ms));
}

TEST(EagerReader, FailureComesAfterWhatWasReadAndIsTheEnd) {
  const Keys keys;
  EagerReader reader(keys.fd(), [&] { return keys.Read(); });
  ASSERT_TRUE(keys.Send(7));
  ASSERT_TRUE(Readable(reader.fd(), kPatience_ms));
  ASSERT_TRUE(keys.Send(Keys::kBroken));
  const auto first = reader.Take();
  ASSERT_TRUE(first);
  EXPECT_EQ(first->size(), 1u);
  EXPECT_TRUE(Readable(reader.fd(), 0));
  for (int i = 0; i < 2; ++i) {
    const auto failed = reader.Take();
    ASSERT_FALSE(failed);
    EXPECT_EQ(failed.error().code, ErrorCode::kDevice);
  }
}

}  // namespace
}  // namespace parti::input
