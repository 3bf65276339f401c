// What the session thread takes and what it publishes, as values.
// Who executes and who writes is session_thread.h's; what a state holds is session_state.h's.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <variant>

#include "app/command.h"
#include "app/session_state.h"
#include "base/error.h"
#include "base/stroke.h"

namespace parti::app {

/// What a person asks of documents. Refused where something would be lost.
struct DocumentRequest {
  enum class Kind : uint8_t {
    kNew,              ///< an empty one, a draft until it is saved as something; path unused
    kOpen,             ///< the document at path
    kSaveAs,           ///< everything into path, and from then on there
    kExport,           ///< the model into path, by its ending; the document stays as it is
    kRecordForReport,  ///< the whole session as a drawing (.pen) into path
  };
  Kind kind = Kind::kNew;
  std::string path = {};
  /// kNew, kOpen: go on even where the open document has changes that could not be written.
  bool give_up = false;
  /// The others: a file that is there may go. The open document's own need not be asked about.
  bool replace = false;
  bool operator==(const DocumentRequest&) const = default;
};

/// A finished stroke in pixels of the view, a command, or something about documents.
using SessionRequest = std::variant<Stroke, Command, DocumentRequest>;

/// Whether a request need not be executed because of the one right after it: a view that another
/// view follows at once was never seen, so nothing is lost.
bool IsMoot(const SessionRequest& request, const SessionRequest& next);

/// How the open document is doing; what a title line and a warning show.
struct DocumentStatus {
  std::string path = {};   ///< of its file; "" before the first stroke or command of a new one
  bool named = false;      ///< false: a draft, in the user's data folder
  bool read_only = false;  ///< nothing is written into the file; `trouble` says why
  /// Why strokes and commands don't reach the file, with the remedy. All of them are in memory;
  /// saving as something else writes them. Absent: all is well.
  std::optional<Error> trouble = {};
  uint64_t unwritten = 0;  ///< strokes and commands that are in memory only; those that look aside
  /// The file that could not be written when the program ended: `path` is a draft of everything.
  std::string rescued_from = {};

  bool operator==(const DocumentStatus& o) const {
    return path == o.path && named == o.named && read_only == o.read_only &&
           unwritten == o.unwritten && rescued_from == o.rescued_from &&
           trouble.has_value() == o.trouble.has_value() &&
           (!trouble || trouble->message == o.trouble->message);
  }
};

/// A request that failed, and why; it changed nothing, except that a stroke stays as ink.
struct FailedRequest {
  uint64_t number = 0;  ///< 0: opening the document that the program was started with
  Error error;
  bool mended = false;  ///< one after it has been done, and more than looked: nobody need read it
  /// Where it would have left behind what is not on the disk: the same, and that it may go.
  std::optional<DocumentRequest> giving_up = {};
};

/// What the session thread knows at one moment. Snapshots are never changed: keep them at will.
struct SessionSnapshot {
  std::shared_ptr<const SessionState> state;  ///< never null
  DocumentStatus document;
  /// Requests up to this number have been executed; `state` is what came of them.
  uint64_t executed = 0;
  /// Requests up to this number are on the disk or have been refused: they outlive a power cut.
  /// Lags behind `executed` by a moment; stands still while the document is in trouble.
  uint64_t acknowledged = 0;
  std::optional<FailedRequest> last_error = {};  ///< of the newest request that failed
  bool can_undo = false, can_redo = false;
  bool busy = false;       ///< a request takes longer than a moment
  std::string doing = {};  ///< what takes its time: "writing house.glb"; "" for nothing to tell
};

}  // namespace parti::app
