#include "grammar/rules/rule_errors.h"

#include <fmt/format.h>

#include <iterator>
#include <utility>

namespace parti::grammar {
namespace {

std::string Counted(const std::string& what, size_t count) {
  return count == 1 ? what : fmt::format("{}, {} places", what, count);
}

}  // namespace

uint32_t RuleErrors::AddFile(std::string name, std::string text) {
  files_.push_back({std::move(name), std::move(text)});
  return static_cast<uint32_t>(files_.size() - 1);
}

void RuleErrors::Report(TextRange range, ErrorCode code, std::string message, std::string hint) {
  Report(range, Error{code, std::move(message), std::move(hint)});
}

void RuleErrors::Report(TextRange range, Error error) {
  if (Full()) return;
  const uint32_t length = range.to > range.from ? range.to - range.from : 1;
  errors_.try_emplace({range.file, range.from}, Located{std::move(error), length});
}

void RuleErrors::ReportUnknown(TextRange range, const std::string& what, std::string hint,
                               bool can_be_skipped) {
  Unknown& unknown = unknown_[what];
  unknown.can_be_skipped = can_be_skipped;
  unknown.places.try_emplace({range.file, range.from}, range.to - range.from);
  if (unknown.hint.empty()) unknown.hint = std::move(hint);
}

std::vector<std::string> RuleErrors::SkipUnknown() {
  std::vector<std::string> skipped;
  for (const auto& [what, unknown] : unknown_) {
    if (unknown.can_be_skipped) skipped.push_back(Counted(what, unknown.places.size()));
  }
  std::erase_if(unknown_, [](const auto& entry) { return entry.second.can_be_skipped; });
  return skipped;
}

std::vector<Error> RuleErrors::Take() {
  for (auto& [what, unknown] : unknown_) {
    const auto& [place, length] = *unknown.places.begin();
    const std::string message = fmt::format("there is no {}", Counted(what, unknown.places.size()));
    errors_.try_emplace(place,
                        Located{{ErrorCode::kUnknownName, message, unknown.hint, {}}, length});
  }
  std::vector<Error> taken;
  for (auto& [place, located] : errors_) {
    if (taken.size() == kMost) break;
    const RuleFile& file = files_.at(place.first);
    located.error.place = PlaceIn(file.text, file.name, place.second, located.length);
    taken.push_back(std::move(located.error));
  }
  return taken;
}

std::vector<RuleFile> RuleErrors::TakeFiles() {
  return {std::make_move_iterator(files_.begin()), std::make_move_iterator(files_.end())};
}

}  // namespace parti::grammar
