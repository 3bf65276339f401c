// The rule files that a building is made by, as lines of text that can be typed over, with what is
// wrong at its line. Pure: what lines look like is text_sheet.h's; the language is grammar's.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "app/command.h"
#include "app/panels/rules_text.h"
#include "app/session_snapshot.h"

namespace parti::app::panels {

/// Texts of files that were typed and are not in force: they can't be read, or are being derived.
struct TypedFiles {
  std::vector<grammar::RuleFile> files;    ///< empty: nothing is typed
  std::vector<std::string> asked;          ///< names of those that have been sent as they are
  std::shared_ptr<const RuleSource> over;  ///< what they were typed over
  uint64_t failed_before = 0;              ///< FailedRequest::number when the last was typed

  /// Whether they are to be shown for this model: the texts of its files are still those typed
  /// over, or those typed, whatever has become of its layers.
  bool Waits(const Model& model) const;
  /// Forgets what is in force, and all where other texts are: undo does not bring them back.
  /// cost  compares texts where the model has other files or layers than at the last call.
  void Settle(const Model& model);
};

/// The text of one file.
struct FileLines {
  std::string file;
  bool waits = false;         ///< it was typed in, and is not in force
  bool is_read = true;        ///< it can be read, with all other files as they are
  bool failed = false;        ///< it is read, and the building can't be made by it
  bool can_be_asked = false;  ///< it waits, is read, and nobody is at it: PutInForce
  std::vector<RulesLine> lines;
};

/// The files that are in force, or what is typed over them; none for a building without files.
/// cost  reads all texts while one waits; KnownFiles does so once.
std::vector<FileLines> FilesOf(const SessionSnapshot& session, const TypedFiles& typed);

/// FilesOf for frame after frame.
class KnownFiles {
 public:
  /// Stays as it is until a call with other texts, in force or typed, or another failure.
  const std::vector<FileLines>& Of(const SessionSnapshot& session, const TypedFiles& typed);

 private:
  std::shared_ptr<const RuleSource> source_;
  TypedFiles typed_;
  uint64_t failed_ = 0;
  std::vector<FileLines> files_;
};

/// The command for a text that waits and can be read, by what has become of layers or other files.
SetRuleText PutInForce(const SessionSnapshot& session, const std::string& file, TypedFiles* typed);

/// Types `text` over a line of a file, or after its last where `line` is the number of lines; an
/// empty text takes the line out. What can be read is the command to send; it and what can't be
/// read wait in `*typed` until it is in force.
std::optional<SetRuleText> TypeOver(const SessionSnapshot& session, const std::string& file,
                                    size_t line, const std::string& text, TypedFiles* typed);

}  // namespace parti::app::panels
