// The thread that owns the session: takes strokes, commands and requests about documents in order,
// and publishes what came of them. Drawing and its frames never wait for it.
// What a request does is session.h's; what happens when a document can't be written is
// document_keeper.h's.
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "app/session_options.h"
#include "app/session_snapshot.h"
#include "app/user_folders.h"
#include "app/wake_fd.h"

namespace parti::app {

/// What a session begins with.
struct SessionThreadOptions {
  std::string path = {};  ///< the document to open first; "" for a new one
  UserFolders folders = UserFoldersFromEnvironment();
  SessionOptions session = {};
};

/// Properties  (1) requests take effect in the order in which they were posted;
///             (2) what is acknowledged is in the document's file, and outlives the process;
///             (3) the file always holds the effect of the first n requests since it was opened,
///                 for some n >= the number acknowledged;
///             (4) no request is lost by stopping: what was posted is executed or kept for the next
///                 opening, and written: into a draft where the document can't be.
class SessionThread {
 public:
  /// Starts at once; the document is opened on the new thread. Failures are in the snapshots.
  explicit SessionThread(SessionThreadOptions options = {});
  ~SessionThread();  ///< Stop()
  SessionThread(const SessionThread&) = delete;
  SessionThread& operator=(const SessionThread&) = delete;

  /// Queues a request; returns its number, counted from 1. Any thread; before Stop().
  /// cost  a lock that is only ever held to move a value in or out; no disk, no derivation.
  uint64_t Post(SessionRequest request);

  /// The newest snapshot; never null. Any thread.
  /// cost  a lock that is only ever held to copy a pointer.
  std::shared_ptr<const SessionSnapshot> Newest() const;

  /// Woken by each new snapshot.
  const WakeFd& ready() const;

  /// Finishes what was posted, writes it and closes the document. Idempotent; the last snapshot
  /// stays readable and says whether everything is on the disk, and in which file.
  void Stop();

  /// Stop() for who can't wait: what is not executed within `most` is in the document, and done
  /// when that is opened again (docs/document.md). Requests about documents, all before them, and
  /// what was left over last time are always done. Returns whether the thread has ended. If not,
  /// everything is in the document all the same, and the process may end as it is; ~SessionThread
  /// would wait.
  [[nodiscard]] bool StopWithin(std::chrono::milliseconds most);

 private:
  class Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace parti::app
