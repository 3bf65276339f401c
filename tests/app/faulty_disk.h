// A disk that fails on demand, below SQLite: full, broken, or unable to flush.
// Everything else goes to the real file system.
#pragma once

namespace parti::tests {

/// While one exists, every database that is opened lies on it. Not for several threads to make.
class FaultyDisk {
 public:
  enum class Fault { kNone, kFull, kWriteFails, kFlushFails };

  FaultyDisk();
  ~FaultyDisk();
  FaultyDisk(const FaultyDisk&) = delete;
  FaultyDisk& operator=(const FaultyDisk&) = delete;

  /// After `more` further writes and flushes that work, every one fails, until kNone is set.
  void Break(Fault fault, int more = 0);
  void Repair() { Break(Fault::kNone); }

  /// Writes and flushes since the last Break.
  int operations() const;
};

}  // namespace parti::tests
