#include "grammar/action_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/check.h"
#include "grammar/part_number.h"
#include "grammar/texture_extent.h"

namespace parti::grammar {
namespace {

tl::unexpected<Error> FailAt(const Lexer& lexer, const Token& token, ErrorCode code,
                             std::string message, std::string hint = {}) {
  return tl::unexpected<Error>(lexer.ErrorAt(token, code, std::move(message), std::move(hint)));
}

/// What stands between two commas, before it is known which parameter it is for.
struct Written {
  Token token;
  std::optional<Size> size;  ///< numbers: 3, -3, '0.5, ~1
  bool is_word() const { return !size.has_value(); }
};

Result<Size> ReadSize(Lexer* lexer) {
  Size size;
  if (lexer->Accept('~')) size.kind = Size::Kind::kFloating;
  if (size.kind == Size::Kind::kAbsolute && lexer->Accept('\'')) size.kind = Size::Kind::kRelative;
  const bool negative = lexer->Accept('-');
  if (!lexer->At(Token::Kind::kNumber)) {
    return tl::unexpected<Error>(lexer->Unexpected("a size: 3, '0.5 or ~1"));
  }
  size.value = lexer->Next().number;
  if (negative) size.value = -size.value;
  return size;
}

/// A name, or names joined by dots as in street.front and scope.xy, as one token.
Token DottedName(Lexer ahead) {
  Token name = ahead.Next();
  while (ahead.At('.') && ahead.Touching()) {
    ahead.Next();
    if (!ahead.At(Token::Kind::kName) || !ahead.Touching()) break;
    const Token part = ahead.Next();
    name.text += "." + part.text;
    name.length = part.end() - name.offset;
  }
  return name;
}

Result<Written> ReadWritten(Lexer* lexer) {
  Written written{lexer->Peek(), std::nullopt};
  if (lexer->At(Token::Kind::kName)) {
    written.token = DottedName(*lexer);
    while (lexer->Peek().offset < written.token.end()) lexer->Next();
    return written;
  }
  if (lexer->At(Token::Kind::kText)) {
    lexer->Next();
    return written;
  }
  if (!lexer->At(Token::Kind::kNumber) && !lexer->At('~') && !lexer->At('\'') && !lexer->At('-')) {
    return tl::unexpected<Error>(lexer->Unexpected("an argument"));
  }
  const auto size = ReadSize(lexer);
  if (!size) return Fail(size);
  written.size = *size;
  written.token.length = lexer->previous_end() - written.token.offset;
  return written;
}

Result<std::vector<Written>> ReadArgumentList(Lexer* lexer) {
  std::vector<Written> list;
  const auto open = lexer->Expect('(', "'(' and the operation's arguments");
  if (!open) return Fail(open);
  if (lexer->Accept(')')) return list;
  do {
    auto written = ReadWritten(lexer);
    if (!written) return Fail(written);
    list.push_back(std::move(*written));
  } while (lexer->Accept(','));
  const auto closed = lexer->Expect(')', "',' or ')'");
  if (!closed) return Fail(closed);
  return list;
}

std::optional<Axis> AxisNamed(std::string_view name) {
  for (const Axis axis : {Axis::kX, Axis::kY, Axis::kZ}) {
    if (NameOf(axis) == name) return axis;
  }
  return std::nullopt;
}

std::optional<Argument> ArgumentFrom(const Written& written, const Parameter& parameter) {
  switch (parameter.kind) {
    case ParameterKind::kLength:
    case ParameterKind::kAngle:
    case ParameterKind::kFactor:
      if (!written.size || written.size->kind != Size::Kind::kAbsolute) return std::nullopt;
      return Argument(written.size->value);
    case ParameterKind::kAxis:
      if (!written.is_word()) return std::nullopt;
      if (const auto axis = AxisNamed(written.token.text)) return Argument(*axis);
      return std::nullopt;
    case ParameterKind::kText:
    case ParameterKind::kColor:
      if (!written.is_word()) return std::nullopt;
      return Argument(written.token.text);
    case ParameterKind::kWord:
      if (written.size && TakesNumbers(parameter.words)) {
        return Argument(NumberText(written.size->value));
      }
      if (!written.is_word()) return std::nullopt;
      // The thesis writes comp(face, side) (errata 8).
      return Argument(written.token.text == "face" ? "f" : written.token.text);
    case ParameterKind::kBool:
      if (written.token.kind != Token::Kind::kName) return std::nullopt;
      if (written.token.text == "true") return Argument(true);
      if (written.token.text == "false") return Argument(false);
      return std::nullopt;
    case ParameterKind::kValue:
      return std::nullopt;  // of operations that trees don't have
    case ParameterKind::kSize:
      if (!written.size) return std::nullopt;
      if (written.size->kind == Size::Kind::kFloating && !TakesFloating(parameter)) {
        return std::nullopt;
      }
      return Argument(*written.size);
  }
  return std::nullopt;
}

/// "extrude(distance)"
std::string Usage(const Operation& row) {
  std::vector<std::string_view> names;
  for (const Parameter& parameter : row.parameters) names.push_back(parameter.name);
  return fmt::format("{}({})", row.name, fmt::join(names, ", "));
}

/// Arguments for the row's parameters; `*rest` is how many of the list were used.
Result<std::vector<Argument>> Bind(const Lexer& lexer, const Token& name, const Operation& row,
                                   const std::vector<Written>& list, size_t* used) {
  std::vector<Argument> arguments;
  for (const Parameter& parameter : row.parameters) {
    const Written* written = *used < list.size() ? &list[*used] : nullptr;
    const auto argument = written ? ArgumentFrom(*written, parameter) : std::nullopt;
    if (argument) {
      arguments.push_back(*argument);
      ++*used;
    } else if (!parameter.required) {
      arguments.push_back(parameter.default_value);
    } else if (written != nullptr) {
      return FailAt(lexer, written->token, ErrorCode::kBadArguments,
                    fmt::format("expected {} for the {} of {}", Wanted(parameter.kind),
                                parameter.name, row.name),
                    fmt::format("write {}", Usage(row)));
    } else {
      return FailAt(lexer, name, ErrorCode::kBadArguments,
                    fmt::format("{} lacks its {}", row.name, parameter.name),
                    fmt::format("write {}", Usage(row)));
    }
  }
  return arguments;
}

/// The thesis's form: split(y, 4, ~1) { A | B }, comp(f, side) { A }; names are always there.
Result<std::vector<SuccessorKey>> KeysFrom(const Lexer& lexer, const Operation& row,
                                           const std::vector<Written>& list, size_t used) {
  std::vector<SuccessorKey> keys;
  for (size_t i = used; i < list.size(); ++i) {
    const Written& written = list[i];
    const auto selector =
        written.is_word() ? SelectorNamed(written.token.text) : std::optional<Selector::Kind>();
    if (row.braces == Braces::kSizes && written.size) {
      keys.emplace_back(*written.size);
    } else if (row.braces == Braces::kSelectors && selector) {
      keys.emplace_back(Selector{*selector});
    } else if (row.braces == Braces::kNames && written.is_word()) {
      keys.emplace_back(written.token.text);
    } else {
      return FailAt(
          lexer, written.token, ErrorCode::kBadArguments,
          row.braces == Braces::kNone
              ? fmt::format("{} takes {} argument{}, got {}", row.name, row.parameters.size(),
                            row.parameters.size() == 1 ? "" : "s", list.size())
              : fmt::format("{} does not take this argument", row.name),
          fmt::format("write {}", Usage(row)));
    }
  }
  return keys;
}

/// Reads actions and their braces; holds what recursion needs.
class ActionReader {
 public:
  explicit ActionReader(Lexer* lexer) : lexer_(lexer) {}

  /// Name, arguments and braces, without the symbol that may follow.
  Result<Action> Read() {
    const Token name = lexer_->Peek();
    const auto row = ReadName();
    if (!row) return Fail(row);
    const auto list = ReadArgumentList(lexer_);
    if (!list) return Fail(list);
    Action action;
    action.operation = *row;
    size_t used = 0;
    auto arguments = Bind(*lexer_, name, **row, *list, &used);
    if (!arguments) return Fail(arguments);
    action.arguments = std::move(*arguments);
    const auto keys = KeysFrom(*lexer_, **row, *list, used);
    if (!keys) return Fail(keys);
    if ((*row)->braces == Braces::kNames && keys->empty()) {
      return FailAt(*lexer_, name, ErrorCode::kBadArguments,
                    fmt::format("{} lacks the names of what it makes", name.text),
                    R"(write layers("floors", "door") { Floors | Door })");
    }
    if ((*row)->braces != Braces::kNone) {
      const auto braces = ReadBraces(*keys, &action);
      if (!braces) return Fail(braces);
    }
    if (const auto checked = Check(action); !checked) {
      return tl::unexpected<Error>(
          lexer_->Located(checked.error(), name.offset, lexer_->previous_end()));
    }
    return action;
  }

 private:
  Result<const Operation*> ReadName() {
    if (!lexer_->At(Token::Kind::kName)) {
      return tl::unexpected<Error>(lexer_->Unexpected("an operation"));
    }
    const Token name = lexer_->Next();
    if (name.text == kRepeatName) {
      return FailAt(*lexer_, name, ErrorCode::kUnknownName, "repeat is written as a split",
                    "split(y) { ~3: Floor }*");
    }
    auto row = OperationNamed(name.text);
    if (row && (*row)->notes) {
      return FailAt(*lexer_, name, ErrorCode::kBadArguments,
                    fmt::format("{} stands in rules only", name.text),
                    "what a tree selects is told by parti query");
    }
    if (row) return row;
    Error error = lexer_->Located(row.error(), name.offset, name.end());
    if (!lexer_->At('(')) {
      error.hint = name.text == kNil
                       ? "NIL stands in braces, in the place of a symbol"
                       : fmt::format("to give a symbol to a shape write symbol(\"{}\")", name.text);
    }
    return tl::unexpected<Error>(std::move(error));
  }

  Result<void> ReadBraces(const std::vector<SuccessorKey>& keys, Action* action) {
    const Token open = lexer_->Peek();
    auto successors = ReadSuccessors(*action->operation, !keys.empty());
    if (!successors) return Fail(successors);
    action->successors = std::move(*successors);
    if (!keys.empty()) {
      if (keys.size() != action->successors.size()) {
        return FailAt(*lexer_, open, ErrorCode::kBadArguments,
                      fmt::format("{} has {} alternatives in braces for {} in parentheses",
                                  action->operation->name, action->successors.size(), keys.size()));
      }
      for (size_t i = 0; i < keys.size(); ++i) action->successors[i].key = keys[i];
    }
    if (!AtStar()) return {};
    const Token star = lexer_->Next();
    if (action->operation->name == kSegmentName) {
      Successor group;
      group.repeat = std::move(action->successors);
      action->successors = {std::move(group)};
      return {};
    }
    const Operation* repeat = FindOperation(kRepeatName);
    if (action->operation->name != kSplitName || repeat == nullptr) {
      return FailAt(*lexer_, star, ErrorCode::kBadText,
                    fmt::format("{} can't be repeated", action->operation->name),
                    "only the braces of split and segment are");
    }
    action->operation = repeat;
    return {};
  }

  /// A star after braces repeats them, unless the next node's query starts with it.
  bool AtStar() const {
    if (!lexer_->At('*')) return false;
    Lexer ahead = *lexer_;
    ahead.Next();
    const bool part = ahead.At('.') || ahead.At('#') || ahead.At(':');
    return !(part && ahead.Touching()) && !ahead.At('>') && !ahead.At('/') && !ahead.At('~') &&
           !ahead.At(Token::Kind::kArrow);
  }

  Result<std::vector<Successor>> ReadSuccessors(const Operation& row, bool keyed) {
    if (++depth_ > kDeepestBraces) {
      return FailAt(*lexer_, lexer_->Peek(), ErrorCode::kLimitReached,
                    fmt::format("braces are nested more than {} deep here", kDeepestBraces));
    }
    const auto open = lexer_->Expect('{', fmt::format("'{{' and what {} makes", row.name));
    if (!open) return Fail(open);
    std::vector<Successor> successors;
    // A name is written in the parentheses, and what stands in the braces may be nothing.
    if (!lexer_->At('}') || row.braces == Braces::kNames) {
      do {
        auto successor = ReadSuccessor(row, keyed);
        if (!successor) return Fail(successor);
        successors.push_back(std::move(*successor));
      } while (lexer_->Accept('|'));
    }
    const auto closed = lexer_->Expect('}', "'|' or '}'");
    if (!closed) return Fail(closed);
    --depth_;
    return successors;
  }

  Result<Successor> ReadSuccessor(const Operation& row, bool keyed) {
    Successor successor;
    if (lexer_->At('{')) {
      auto group = ReadSuccessors(row, keyed);
      if (!group) return Fail(group);
      const auto star = lexer_->Expect('*', "'*' after braces in braces");
      if (!star) return Fail(star);
      successor.repeat = std::move(*group);
      return successor;
    }
    if (!keyed) {
      auto key = row.braces == Braces::kSizes ? ReadSizeKey() : ReadSelectorKey();
      if (!key) return Fail(key);
      successor.key = std::move(*key);
    }
    const auto rest = ReadAfterKey(&successor);
    if (!rest) return Fail(rest);
    return successor;
  }

  Result<SuccessorKey> ReadSizeKey() {
    const auto size = ReadSize(lexer_);
    if (!size) return Fail(size);
    const auto colon = lexer_->Expect(':', "':' after the size");
    if (!colon) return Fail(colon);
    return SuccessorKey(*size);
  }

  Result<SuccessorKey> ReadSelectorKey() {
    Selector selector;
    Token token = lexer_->Peek();
    if (token.kind == Token::Kind::kName) {
      token = DottedName(*lexer_);
      const auto kind = SelectorNamed(token.text);
      if (!kind) return UnknownSelector(token);
      selector.kind = *kind;
    } else if (token.kind == Token::Kind::kNumber) {
      constexpr double kMost = 1e6;
      if (token.number > kMost || token.number != std::floor(token.number)) {
        return FailAt(*lexer_, token, ErrorCode::kBadNumber,
                      "the number of a face is a whole number from 0");
      }
      selector = {Selector::Kind::kIndex, static_cast<int>(token.number)};
    } else {
      return tl::unexpected<Error>(lexer_->Unexpected("a selector: side, top, 0 …"));
    }
    while (lexer_->Peek().offset < token.end()) lexer_->Next();
    const auto colon = lexer_->Expect(':', "':' after the selector");
    if (!colon) return Fail(colon);
    return SuccessorKey(selector);
  }

  Result<SuccessorKey> UnknownSelector(const Token& token) {
    const std::vector<std::string_view> known = SelectorNames();
    const std::vector<std::string> names(known.begin(), known.end());
    const auto meant = DidYouMean(token.text, names);
    return FailAt(*lexer_, token, ErrorCode::kUnknownName,
                  fmt::format("there is no selector '{}'", token.text),
                  meant ? fmt::format("did you mean '{}'?", *meant)
                        : fmt::format("{}", fmt::join(names, ", ")));
  }

  /// Operations in place, then a symbol, both of which may be missing.
  Result<void> ReadAfterKey(Successor* successor) {
    while (lexer_->At(Token::Kind::kName)) {
      Lexer ahead = *lexer_;
      ahead.Next();
      if (!ahead.At('(')) break;
      const Token name = lexer_->Peek();
      auto action = Read();
      if (!action) return Fail(action);
      if (!action->operation->in_place) {
        return FailAt(*lexer_, name, ErrorCode::kBadArguments,
                      fmt::format("{} makes shapes and can't stand before a symbol", name.text),
                      "give it a node of its own");
      }
      successor->actions.push_back(std::move(*action));
    }
    const Token at = lexer_->Peek();
    successor->deferred = lexer_->Accept('@');
    if (lexer_->At(Token::Kind::kName) || lexer_->At(Token::Kind::kText)) {
      successor->symbol = lexer_->Next().text;
    }
    if (!successor->deferred || (!successor->symbol.empty() && successor->symbol != kNil))
      return {};
    return FailAt(*lexer_, at, ErrorCode::kBadText, "'@' defers nothing here", "write @Symbol");
  }

  Lexer* lexer_;
  int depth_ = 0;
};

/// A name after an action is its symbol, unless the next node's query starts with it.
bool AtSymbol(const Lexer& lexer) {
  if (lexer.At(Token::Kind::kText)) return true;
  if (!lexer.At(Token::Kind::kName) || lexer.AtWord(kOff)) return false;
  Lexer ahead = lexer;
  ahead.Next();
  const bool part = ahead.At('.') || ahead.At('#') || ahead.At(':');
  return !(part && ahead.Touching()) && !ahead.At('>') && !ahead.At('/') && !ahead.At('~') &&
         !ahead.At('(') && !ahead.At(Token::Kind::kArrow);
}

}  // namespace

Result<Action> ReadAction(Lexer* lexer) {
  auto action = ActionReader(lexer).Read();
  if (!action || action->operation->braces != Braces::kNone || !AtSymbol(*lexer)) return action;
  const Token symbol = lexer->Next();
  action->symbol = symbol.text;
  if (symbol.text != kNil || !action->operation->in_place) return action;
  return FailAt(*lexer, symbol, ErrorCode::kBadText,
                fmt::format("NIL makes nothing, and {} makes nothing either: it changes the shape",
                            action->operation->name));
}

Result<Action> ParseAction(std::string_view text, std::string_view file) {
  Lexer lexer(text, file);
  auto action = ReadAction(&lexer);
  if (!action || lexer.At(Token::Kind::kEnd)) return action;
  return tl::unexpected<Error>(lexer.Unexpected("the end of the action"));
}

}  // namespace parti::grammar
