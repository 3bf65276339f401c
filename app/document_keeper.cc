#include "app/document_keeper.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <utility>

#include "app/document_drafts.h"
#include "app/document_record.h"
#include "app/recent_files.h"
#include "app/replacing.h"
#include "app/user_folders.h"

namespace parti::app {
namespace {

Error Vanished(const std::string& path) {
  return {ErrorCode::kFile, fmt::format("{} is gone: deleted, moved, or its disk pulled out", path),
          "put the disk back, or save it as another file: everything is still here"};
}

/// Whether a killed program left requests over, to be executed or laid aside.
bool HasLeftOver(const Document& document) {
  return !document.posted.empty() ||
         std::any_of(document.laid_aside.begin(), document.laid_aside.end(),
                     [](const PostedRequest& request) { return request.begun > 0; });
}

/// Whether this is all that was done where a program was started on a lot and nobody drew.
bool Begins(const std::string& command) {
  return command.starts_with("lot ") || command.starts_with("view ");
}
bool Begins(const DocumentChange& change) {
  return !change.stroke && (change.command.empty() || Begins(change.command));
}
bool Begins(const KeptRequest& request) { return Begins(request.request.command); }

}  // namespace

void ApplyTo(const DocumentChange& change, Document* document) {
  if (change.stroke) {
    document->history.push_back(fmt::format("stroke {}", change.stroke->number));
    document->strokes.push_back(change.stroke);
  }
  if (!change.command.empty()) document->history.push_back(change.command);
  if (!change.state) return;
  const auto place = [&](uint64_t number) { return number - document->span.first; };
  auto& states = document->states;
  // States in a gap were dropped from memory, and later changes drop them here too.
  states.resize(std::max(states.size(), place(change.span.last) + 1), *change.state);
  states[place(change.span.now)] = *change.state;
  states.resize(place(change.span.last) + 1, *change.state);
  states.erase(states.begin(),
               states.begin() + static_cast<std::ptrdiff_t>(place(change.span.first)));
  document->span = change.span;
}

DocumentKeeper::DocumentKeeper(UserFolders folders) : folders_(std::move(folders)) {}

DocumentKeeper::~DocumentKeeper() { Leave(); }

void DocumentKeeper::Leave() {
  const bool goes = is_own_draft_ && only_begun_ && unwritten_.empty() && file_ && file_->IsThere();
  file_.reset();
  if (goes) std::remove(status_.path.c_str());
  is_own_draft_ = false;
  only_begun_ = true;
}

Result<void> DocumentKeeper::MayLeave(bool give_up) const {
  if (give_up) return {};
  if (IsGone()) return tl::unexpected<Error>(Vanished(status_.path));
  if (status_.unwritten == 0) return {};
  return Fail(ErrorCode::kFile,
              fmt::format("{} strokes and commands of this document are not on the disk",
                          status_.unwritten),
              "save it as another file first, or say that they may go");
}

Result<void> DocumentKeeper::New(Document start, bool give_up) {
  if (auto may = MayLeave(give_up); !may) return may;
  Leave();
  unwritten_.clear();
  status_ = {};
  start_ = std::move(start);
  return {};
}

Result<Document> DocumentKeeper::Open(const std::string& path, bool give_up) {
  if (const auto may = MayLeave(give_up); !may) return Fail(may);
  if (file_ && file_->IsAt(path)) {
    unwritten_.clear();
    return file_->Read();
  }
  if (file_ && !file_->IsThere()) file_.reset();  // as in WriteInto
  auto file = DocumentFile::Open(path);
  auto document = file ? file->Read() : OpenDocument(path);
  if (!document) return document;
  if (file && HasLeftOver(*document)) {
    if (const auto taken = file->TakeUpLeftOver(document->posted); !taken) file = Fail(taken);
  }
  GoOnIn(path, std::move(file), *document);
  return document;
}

Document DocumentKeeper::Everything(Document in_memory) {
  Document document = start_;
  if (file_) {
    auto read = file_->Read();
    if (!read) return in_memory;  // what it alone knew is lost with it: how things came to be
    document = std::move(*read);
  }
  for (const DocumentChange& change : unwritten_) ApplyTo(change, &document);
  document.posted.clear();
  return document;
}

Result<void> DocumentKeeper::WriteInto(const std::string& path, Document document) {
  const bool own = file_ && file_->IsAt(path);
  if (auto done = own ? ReplaceDocument(document, path) : SaveDocument(document, path); !done) {
    return done;
  }
  file_.reset();  // before another of the same name is opened: their logs have one name too
  GoOnIn(path, DocumentFile::Open(path), std::move(document));
  return {};
}

/// `document` is what the file holds now.
void DocumentKeeper::GoOnIn(const std::string& path, Result<DocumentFile> file, Document document) {
  Leave();
  unwritten_.clear();
  status_ = DocumentStatus{WholePath(path), !IsDraft(folders_.data, path)};
  if (file) {
    file_ = std::move(*file);
  } else {
    status_.read_only = true;
    status_.trouble = file.error();
    start_ = std::move(document);
  }
  NoteRecentFile(folders_.state, path);
}

Result<void> DocumentKeeper::SaveAs(const std::string& path, Document in_memory, bool replace) {
  const bool own = file_ && file_->IsAt(path);
  if (own && unwritten_.empty()) return {};
  if (!own && !replace) {
    if (auto free = CheckNothingIsAt(path); !free) return free;
  }
  // A draft that another Parti has open, or that is another file by now, is not ours to delete.
  const bool moves = !own && !status_.named && file_ && file_->IsThere();
  const std::string draft = moves ? status_.path : "";
  if (auto done = WriteInto(path, Everything(std::move(in_memory))); !done) return done;
  if (moves) std::remove(draft.c_str());
  return {};
}

Result<void> DocumentKeeper::Rescue(Document in_memory, const std::vector<KeptRequest>& waiting) {
  TryAgain();
  std::vector<KeptRequest> left = waiting;
  const int64_t done = unwritten_.empty() ? acknowledged_ : unwritten_.back().number;
  std::erase_if(left, [&](const KeptRequest& request) { return request.number <= done; });
  const bool missed = status_.trouble && (status_.unwritten > 0 || !left.empty());
  if (!missed && !IsGone()) return {};
  const Document everything = Everything(std::move(in_memory));
  if (everything.states.empty()) return tl::unexpected<Error>(Vanished(status_.path));
  const auto path = NewDraftPath(folders_.data);
  if (!path) return Fail(path);
  const std::string from = status_.path;
  if (auto written = WriteInto(*path, everything); !written) {
    std::remove(path->c_str());
    return written;
  }
  status_.named = false;
  status_.rescued_from = from;
  Acknowledge(done);
  Keep(left);
  return {};
}

Result<void> DocumentKeeper::MakeDraft() {
  const auto path = NewDraftPath(folders_.data);
  if (!path) return Fail(path);
  auto done = SaveDocument(start_, *path);
  auto file = done ? DocumentFile::Open(*path) : Fail(done);
  if (!file) {
    std::remove(path->c_str());
    return Fail(file);
  }
  file_ = std::move(*file);
  status_.path = *path;
  is_own_draft_ = true;
  return {};
}

void DocumentKeeper::BeginLeftOver(int64_t number) {
  if (file_ && unwritten_.empty()) Note(file_->BeginLeftOver(number));
}

void DocumentKeeper::Keep(const std::vector<KeptRequest>& requests) {
  if (status_.read_only) return;
  only_begun_ &= std::all_of(requests.begin(), requests.end(),
                             [](const KeptRequest& request) { return Begins(request); });
  if (!file_ && !status_.named) {
    if (const auto made = MakeDraft(); !made) return Note(made);
  }
  if (file_ && unwritten_.empty()) Note(file_->Keep(requests));
}

Result<void> DocumentKeeper::Write() {
  if (!file_ && !status_.named) {
    if (auto made = MakeDraft(); !made) return made;
  }
  if (!file_ || !file_->IsThere()) return tl::unexpected<Error>(Vanished(status_.path));
  if (auto done = file_->Apply(unwritten_); !done) return done;
  if (!file_->IsThere()) return tl::unexpected<Error>(Vanished(status_.path));
  Acknowledge(unwritten_.back().number);
  unwritten_.clear();
  return {};
}

void DocumentKeeper::Note(const Result<void>& done) {
  status_.trouble = done ? std::nullopt : std::optional(done.error());
  CountUnwritten();
}

/// What a kill left over has numbers up to 0, whenever it is done.
void DocumentKeeper::Acknowledge(int64_t number) {
  acknowledged_ = std::max(acknowledged_, number);
}

void DocumentKeeper::CountUnwritten() {
  const auto is_missed = [&](const DocumentChange& change) {
    // What a kill left over stays in a file that nobody writes, and is done at each opening.
    const bool is_there = status_.read_only && change.number <= 0;
    return !change.IsEmpty() && !change.looks && !is_there;
  };
  status_.unwritten =
      static_cast<uint64_t>(std::count_if(unwritten_.begin(), unwritten_.end(), is_missed));
}

/// States that undo has forgotten since then need not wait for the file.
void DocumentKeeper::DropOldStates() {
  const auto newest = std::find_if(unwritten_.rbegin(), unwritten_.rend(),
                                   [](const DocumentChange& c) { return c.state.has_value(); });
  if (newest == unwritten_.rend()) return;
  for (DocumentChange& change : unwritten_) {
    if (change.state && change.span.now < newest->span.first) change.state.reset();
  }
}

void DocumentKeeper::Apply(std::vector<DocumentChange> changes) {
  const bool nothing = std::all_of(changes.begin(), changes.end(),
                                   [](const DocumentChange& change) { return change.IsEmpty(); });
  if (nothing && unwritten_.empty() && !file_) {
    Acknowledge(changes.back().number);
    return;
  }
  only_begun_ &= std::all_of(changes.begin(), changes.end(),
                             [](const DocumentChange& change) { return Begins(change); });
  std::move(changes.begin(), changes.end(), std::back_inserter(unwritten_));
  if (status_.read_only) {
    CountUnwritten();
  } else {
    Note(Write());
  }
  DropOldStates();
}

/// A draft in which nobody drew may go.
bool DocumentKeeper::IsGone() const {
  return file_ && !file_->IsThere() && !(is_own_draft_ && only_begun_);
}

void DocumentKeeper::TryAgain() {
  if (status_.read_only) return;
  if (!unwritten_.empty()) return Note(Write());
  const bool was_gone = std::exchange(was_gone_, IsGone());
  if (was_gone_ && !was_gone) Note(tl::unexpected<Error>(Vanished(status_.path)));
  if (was_gone && !was_gone_) Note({});
}

void DocumentKeeper::Tidy() {
  if (!file_ || !unwritten_.empty()) return;
  if (const auto done = file_->Tidy(); !done) Note(done);
}

}  // namespace parti::app
