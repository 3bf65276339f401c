#include "app/panels/file_text.h"

#include <algorithm>

namespace parti::app::panels {
namespace {

constexpr size_t kIndent = 2;  // blanks a step

/// With their line ends, so that nothing of a text is lost.
std::vector<std::string> Split(const std::string& text) {
  std::vector<std::string> lines;
  for (size_t from = 0; from < text.size();) {
    const size_t end = std::min(text.find('\n', from), text.size() - 1);
    lines.push_back(text.substr(from, end + 1 - from));
    from = end + 1;
  }
  return lines;
}

/// "" and "\n", or "\r\n" where the file has such.
std::string EndOf(const std::string& line) {
  const size_t end = line.find_last_not_of("\r\n");
  return line.substr(end == std::string::npos ? 0 : end + 1);
}

std::string IndentOf(const std::string& line) {
  const size_t first = line.find_first_not_of(" \t");
  return line.substr(0, std::min(first, line.size() - EndOf(line).size()));
}

RulesLine LineOf(const std::string& line) {
  const std::string indent = IndentOf(line), end = EndOf(line);
  RulesLine shown{line.substr(indent.size(), line.size() - indent.size() - end.size()), 0};
  size_t columns = 0;
  for (const char c : indent) columns += c == '\t' ? kIndent : 1;
  shown.depth = static_cast<int>(columns / kIndent);
  for (char& c : shown.text) c = static_cast<unsigned char>(c) < ' ' ? ' ' : c;
  return shown;
}

/// All files, with what is typed over them where it waits.
std::vector<grammar::RuleFile> TextsOf(const Model& model, const TypedFiles& typed) {
  if (!model.ground->source) return {};
  std::vector<grammar::RuleFile> files = model.ground->source->files;
  if (!typed.Waits(model)) return files;
  for (grammar::RuleFile& file : files) {
    for (const grammar::RuleFile& one : typed.files) {
      if (one.name == file.name) file.text = one.text;
    }
  }
  return files;
}

/// What is wrong with one typed file, the others being as they are in force.
std::vector<Error> ErrorsIn(const RuleSource& in_force, const grammar::RuleFile& typed) {
  RuleSource source = in_force;
  for (grammar::RuleFile& file : source.files) {
    if (file.name == typed.name) file.text = typed.text;
  }
  const auto rules = RulesOf(source);
  return rules ? std::vector<Error>() : rules.error();
}

void AddErrors(const std::vector<Error>& errors, FileLines* typed, std::vector<FileLines>* all) {
  typed->is_read = errors.empty();
  for (const Error& error : errors) {
    const auto at = std::find_if(all->begin(), all->end(), [&](const FileLines& file) {
      return error.place && file.file == error.place->file;
    });
    AddNote(error, at == all->end() ? &typed->lines : &at->lines);
  }
}

bool SameTyped(const TypedFiles& a, const TypedFiles& b) {
  return a.over == b.over && a.failed_before == b.failed_before && a.asked == b.asked &&
         std::equal(a.files.begin(), a.files.end(), b.files.begin(), b.files.end(),
                    [](const grammar::RuleFile& one, const grammar::RuleFile& other) {
                      return one.name == other.name && one.text == other.text;
                    });
}

/// What a request has failed with since the last was typed.
const FailedRequest* FailureOf(const SessionSnapshot& session, const TypedFiles& typed) {
  const auto& failed = session.last_error;
  return failed && failed->number > typed.failed_before ? &*failed : nullptr;
}

/// What a derivation of the typed text said, at its line.
void AddFailure(const SessionSnapshot& session, const TypedFiles& typed, FileLines* file) {
  const FailedRequest* failed = FailureOf(session, typed);
  if (!failed || !failed->error.place) return;
  if (failed->error.place->file == file->file) AddNote(failed->error, &file->lines);
}

/// Whether a file is among them, with the same text.
bool IsIn(const std::vector<grammar::RuleFile>& files, const grammar::RuleFile& file) {
  return std::any_of(files.begin(), files.end(), [&](const grammar::RuleFile& one) {
    return one.name == file.name && one.text == file.text;
  });
}

void MarkAsked(const std::string& file, const SessionSnapshot& session, TypedFiles* typed) {
  typed->asked.push_back(file);
  typed->failed_before = session.last_error ? session.last_error->number : 0;
}

}  // namespace

bool TypedFiles::Waits(const Model& model) const {
  const auto& now = model.ground->source;
  if (files.empty() || over == now) return !files.empty();
  if (!over || !now || over->files.size() != now->files.size()) return false;
  const bool ours = std::all_of(now->files.begin(), now->files.end(), [&](const auto& file) {
    return IsIn(over->files, file) || IsIn(files, file);
  });
  return ours && std::any_of(files.begin(), files.end(),
                             [&](const auto& file) { return !IsIn(now->files, file); });
}

void TypedFiles::Settle(const Model& model) {
  if (!Waits(model)) {
    *this = {};
  } else if (over != model.ground->source) {
    over = model.ground->source;
    std::erase_if(files, [&](const auto& file) { return IsIn(over->files, file); });
  }
}

std::vector<FileLines> FilesOf(const SessionSnapshot& session, const TypedFiles& typed) {
  const Model& model = session.state->model;
  std::vector<FileLines> files;
  for (const grammar::RuleFile& file : TextsOf(model, typed)) {
    FileLines& lines = files.emplace_back();
    lines.file = file.name;
    for (const std::string& line : Split(file.text)) lines.lines.push_back(LineOf(line));
  }
  if (!typed.Waits(model)) return files;
  for (const grammar::RuleFile& one : typed.files) {
    const auto file = std::find_if(files.begin(), files.end(),
                                   [&](const FileLines& f) { return f.file == one.name; });
    if (file == files.end()) continue;
    file->waits = true;
    AddErrors(ErrorsIn(*model.ground->source, one), &*file, &files);
    if (!file->is_read) continue;
    AddFailure(session, typed, &*file);
    const bool asked =
        std::find(typed.asked.begin(), typed.asked.end(), one.name) != typed.asked.end();
    file->failed = asked && FailureOf(session, typed);
    file->can_be_asked = !asked || file->failed;
  }
  return files;
}

const std::vector<FileLines>& KnownFiles::Of(const SessionSnapshot& session,
                                             const TypedFiles& typed) {
  const auto& source = session.state->model.ground->source;
  const uint64_t failed = session.last_error ? session.last_error->number : 0;
  if (source != source_ || failed != failed_ || !SameTyped(typed, typed_)) {
    files_ = FilesOf(session, typed);
    source_ = source;
    typed_ = typed;
    failed_ = failed;
  }
  return files_;
}

SetRuleText PutInForce(const SessionSnapshot& session, const std::string& file, TypedFiles* typed) {
  MarkAsked(file, session, typed);
  for (const grammar::RuleFile& one : typed->files) {
    if (one.name == file) return {file, one.text};
  }
  return {file, ""};
}

std::optional<SetRuleText> TypeOver(const SessionSnapshot& session, const std::string& file,
                                    size_t line, const std::string& text, TypedFiles* typed) {
  const Model& model = session.state->model;
  std::vector<grammar::RuleFile> files = TextsOf(model, *typed);
  const auto found =
      std::find_if(files.begin(), files.end(), [&](const auto& one) { return one.name == file; });
  if (found == files.end()) return std::nullopt;
  std::vector<std::string> lines = Split(found->text);
  if (line > lines.size() || (line == lines.size() && text.empty())) return std::nullopt;
  if (line == lines.size()) {
    if (!lines.empty() && EndOf(lines.back()).empty()) lines.back() += '\n';
    lines.push_back(text + '\n');
  } else if (text.empty()) {
    lines.erase(lines.begin() + static_cast<std::ptrdiff_t>(line));
  } else {
    lines[line] = IndentOf(lines[line]) + text + EndOf(lines[line]);
  }
  grammar::RuleFile after{file, ""};
  for (const std::string& one : lines) after.text += one;
  typed->Settle(model);
  typed->over = model.ground->source;
  typed->failed_before = session.last_error ? session.last_error->number : 0;
  std::erase_if(typed->files, [&](const auto& one) { return one.name == file; });
  std::erase(typed->asked, file);
  typed->files.push_back(after);
  if (!ErrorsIn(*model.ground->source, after).empty()) return std::nullopt;
  MarkAsked(file, session, typed);
  return SetRuleText{file, std::move(after.text)};
}

}  // namespace parti::app::panels
