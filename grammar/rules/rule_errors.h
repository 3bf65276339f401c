// What is wrong with rule files: collected over parsing and checking, told in one go.
// What counts as wrong is the parser's and the checker's to say.
#pragma once

#include <deque>
#include <map>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "base/error.h"
#include "grammar/rules/rule_set.h"

namespace parti::grammar {

/// The errors of a rule set's files, each with its place, the first kMost of them in the order of
/// the text.
class RuleErrors {
 public:
  static constexpr size_t kMost = 50;

  /// A file that ranges name; returns its number. text and name are kept.
  uint32_t AddFile(std::string name, std::string text);
  const std::deque<RuleFile>& files() const { return files_; }

  /// Nothing where there is an error already: the first one of a place counts.
  void Report(TextRange range, ErrorCode code, std::string message, std::string hint = {});
  /// An error that has its code, message and hint already; the place becomes this one.
  void Report(TextRange range, Error error);
  /// As many as are told: reading may end.
  bool Full() const { return errors_.size() >= kMost; }
  bool empty() const { return errors_.empty() && unknown_.empty(); }

  /// Something that CGA or a later version has and we don't: told once, with the count of its
  /// places. `what` is "operation 'envelope'". What can be skipped may become nothing.
  void ReportUnknown(TextRange range, const std::string& what, std::string hint = {},
                     bool can_be_skipped = true);
  /// Whether a hint for it would be shown: it is new, and there are not too many.
  bool WantsHint(const std::string& what) const {
    return unknown_.size() < kMost && !unknown_.contains(what);
  }
  /// Forgets what was reported as unknown and can be skipped; returns it, a line each.
  std::vector<std::string> SkipUnknown();

  /// All of them, sorted by place, no two at one place.
  std::vector<Error> Take();
  std::vector<RuleFile> TakeFiles();

 private:
  using Place = std::pair<uint32_t, uint32_t>;  ///< file and first byte
  struct Located {
    Error error;
    uint32_t length;
  };
  struct Unknown {
    std::map<Place, uint32_t> places;  ///< and how long they are
    std::string hint;
    bool can_be_skipped = true;
  };
  std::deque<RuleFile> files_;  ///< their texts are looked into: none may move
  std::map<Place, Located> errors_;
  std::map<std::string, Unknown> unknown_;
};

}  // namespace parti::grammar
