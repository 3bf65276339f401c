#include "grammar/query_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "grammar/operation.h"
#include "grammar/query_filter.h"

namespace parti::grammar {
namespace {

constexpr std::string_view kSelectorHint =
    "a selector is Operation.symbol#tag:filter, of which any part may be missing, or *";

/// Passes an error on with the place [from, end of what was read).
tl::unexpected<Error> FailAt(const Lexer& lexer, Error error, size_t from) {
  return tl::unexpected<Error>(lexer.Located(std::move(error), from, lexer.previous_end()));
}

Result<std::string> ReadName(Lexer* lexer, std::string_view wanted) {
  if (lexer->At(Token::Kind::kName) || lexer->At(Token::Kind::kText)) return lexer->Next().text;
  return tl::unexpected<Error>(lexer->Unexpected(wanted));
}

Result<double> ReadNumber(Lexer* lexer) {
  const bool negative = lexer->Accept('-');
  if (!lexer->At(Token::Kind::kNumber)) {
    return tl::unexpected<Error>(lexer->Unexpected("a number"));
  }
  const double number = lexer->Next().number;
  return negative ? -number : number;
}

Result<void> ReadNumbers(Lexer* lexer, std::vector<double>* numbers) {
  do {
    const auto number = ReadNumber(lexer);
    if (!number) return Fail(number);
    numbers->push_back(*number);
  } while (lexer->Accept(','));
  return {};
}

Result<void> Close(Lexer* lexer, std::string_view wanted) {
  const auto closed = lexer->Expect(')', wanted);
  if (!closed) return Fail(closed);
  return {};
}

Result<void> ReadInnerQuery(Lexer* lexer, Filter* filter, int depth) {
  auto query = ReadQuery(lexer, depth + 1);
  if (!query) return Fail(query);
  filter->queries.push_back(std::move(*query));
  return {};
}

/// sphere(…), (query), or a query without parentheses of its own.
Result<void> ReadVolume(Lexer* lexer, Filter* filter, int depth) {
  if (lexer->Accept('(')) {
    const auto query = ReadInnerQuery(lexer, filter, depth);
    return query ? Close(lexer, "')'") : query;
  }
  Lexer ahead = *lexer;
  const Token name = ahead.Next();
  if (name.kind != Token::Kind::kName || !ahead.At('(')) {
    return ReadInnerQuery(lexer, filter, depth);
  }
  if (NumbersOfVolume(name.text) == 0) {
    const auto meant = DidYouMean(name.text, {"sphere", "box", "cylinder"});
    return tl::unexpected<Error>(lexer->ErrorAt(
        name, ErrorCode::kUnknownName, fmt::format("there is no volume '{}'", name.text),
        meant ? fmt::format("did you mean '{}'?", *meant)
              : "sphere(x,y,z,r), box(x,y,z,w,h,d), cylinder(x,y,z,r,h) or (query)"));
  }
  filter->volume = name.text;
  ahead.Next();
  *lexer = ahead;
  const auto numbers = ReadNumbers(lexer, &filter->numbers);
  return numbers ? Close(lexer, "',' or ')'") : numbers;
}

Result<void> ReadArguments(Lexer* lexer, FilterArguments arguments, Filter* filter, int depth) {
  if (arguments == FilterArguments::kVolume) return ReadVolume(lexer, filter, depth);
  if (arguments == FilterArguments::kOneOrTwoCounts || arguments == FilterArguments::kArea) {
    return ReadNumbers(lexer, &filter->numbers);
  }
  const auto query = ReadInnerQuery(lexer, filter, depth);
  if (!query || arguments == FilterArguments::kQuery) return query;
  const auto comma = lexer->Expect(',', "',' and a distance in metres");
  if (!comma) return Fail(comma);
  return ReadNumbers(lexer, &filter->numbers);
}

/// After ':'.
Result<Filter> ReadFilter(Lexer* lexer, int depth) {
  const Token name = lexer->Peek();
  Filter filter;
  auto text = ReadName(lexer, "a filter's name after ':'");
  if (!text) return Fail(text);
  filter.name = std::move(*text);
  const auto row = FilterNamed(filter.name);
  if (!row) return FailAt(*lexer, row.error(), name.offset);
  const FilterArguments arguments = (*row)->arguments;
  if (arguments == FilterArguments::kNone) {
    if (lexer->At('(') && lexer->Touching()) {
      return tl::unexpected<Error>(
          lexer->ErrorAt(lexer->Peek(), ErrorCode::kBadArguments,
                         fmt::format("the filter '{}' takes no arguments", filter.name)));
    }
    return filter;
  }
  const auto open = lexer->Expect('(', fmt::format("'(' and the arguments of '{}'", filter.name));
  if (!open) return Fail(open);
  if (const auto read = ReadArguments(lexer, arguments, &filter, depth); !read) return Fail(read);
  if (const auto closed = Close(lexer, "')'"); !closed) return Fail(closed);
  const auto checked = CheckFilter(filter);
  if (!checked) return FailAt(*lexer, checked.error(), name.offset);
  return filter;
}

Result<std::string> ReadOperationWord(Lexer* lexer) {
  const Token token = lexer->Next();
  std::vector<std::string> words;
  for (const Operation& row : Operations()) words.emplace_back(row.word);
  if (std::find(words.begin(), words.end(), token.text) != words.end()) return token.text;
  const auto meant = DidYouMean(token.text, words);
  return tl::unexpected<Error>(lexer->ErrorAt(
      token, ErrorCode::kUnknownName, fmt::format("there is no operation '{}'", token.text),
      meant ? fmt::format("did you mean '{}'?", *meant)
            : fmt::format("a symbol is written with a dot: .{}", token.text)));
}

/// Symbol, tags and filters, as far as they touch; the first part need not touch what is before it.
Result<void> ReadParts(Lexer* lexer, QuerySelector* selector, size_t start, int depth) {
  const auto at_part = [&](char mark) {
    return lexer->At(mark) && (lexer->Touching() || lexer->previous_end() == start);
  };
  if (at_part('.')) {
    lexer->Next();
    auto symbol = ReadName(lexer, "a symbol after '.'");
    if (!symbol) return Fail(symbol);
    selector->symbol = std::move(*symbol);
  }
  while (at_part('#')) {
    lexer->Next();
    auto tag = ReadName(lexer, "a tag after '#'");
    if (!tag) return Fail(tag);
    selector->tags.push_back(std::move(*tag));
  }
  while (at_part(':')) {
    lexer->Next();
    auto filter = ReadFilter(lexer, depth);
    if (!filter) return Fail(filter);
    selector->filters.push_back(std::move(*filter));
  }
  if (!at_part('.') && !at_part('#')) return {};
  return tl::unexpected<Error>(lexer->ErrorAt(
      lexer->Peek(), ErrorCode::kBadText, fmt::format("'{}' can't stand here", lexer->Peek().mark),
      "the order is Operation.symbol#tag:filter, with at most one symbol"));
}

Result<QuerySelector> ReadSelector(Lexer* lexer, int depth) {
  QuerySelector selector;
  if (!AtQuery(*lexer)) {
    Error error = lexer->Unexpected("a selector");
    if (error.hint.empty()) error.hint = kSelectorHint;
    return tl::unexpected<Error>(std::move(error));
  }
  const size_t start = lexer->previous_end();
  if (lexer->At(Token::Kind::kName)) {
    auto word = ReadOperationWord(lexer);
    if (!word) return Fail(word);
    selector.operation = std::move(*word);
  } else {
    lexer->Accept('*');
  }
  const auto parts = ReadParts(lexer, &selector, start, depth);
  if (!parts) return Fail(parts);
  return selector;
}

std::optional<Query::Relation> AcceptRelation(Lexer* lexer) {
  using Relation = Query::Relation;
  for (const Relation r : {Relation::kDescendants, Relation::kChildren, Relation::kSiblings}) {
    if (lexer->Accept(static_cast<char>(r))) return r;
  }
  return std::nullopt;
}

std::string TextOf(const Filter& filter) {
  std::string text = ":" + NameText(filter.name);
  if (filter.numbers.empty() && filter.queries.empty()) return text;
  std::vector<std::string> arguments;
  const FilterRow* row = FindFilter(filter.name);
  const bool volume = row != nullptr && row->arguments == FilterArguments::kVolume;
  for (const Query& query : filter.queries) {
    arguments.push_back(volume ? "(" + grammar::TextOf(query) + ")" : grammar::TextOf(query));
  }
  for (const double number : filter.numbers) arguments.push_back(NumberText(number));
  std::string list = fmt::format("({})", fmt::join(arguments, ", "));
  return text + (filter.volume.empty() ? list : fmt::format("({}{})", filter.volume, list));
}

std::string TextOf(const QuerySelector& selector) {
  std::string text = selector.operation;
  if (!selector.symbol.empty()) text += "." + NameText(selector.symbol);
  for (const std::string& tag : selector.tags) text += "#" + NameText(tag);
  for (const Filter& filter : selector.filters) text += TextOf(filter);
  return text.empty() ? "*" : text;
}

}  // namespace

// Not defaulted: clang 16 crashes on a default that recurses through std::vector.
bool Filter::operator==(const Filter& other) const {
  return name == other.name && numbers == other.numbers && volume == other.volume &&
         queries == other.queries;
}

bool AtQuery(const Lexer& lexer) {
  return lexer.At('.') || lexer.At('#') || lexer.At(':') || lexer.At('*') ||
         lexer.At(Token::Kind::kName);
}

Result<Query> ReadQuery(Lexer* lexer, int depth) {
  if (depth > kDeepestQuery) {
    return tl::unexpected<Error>(
        lexer->ErrorAt(lexer->Peek(), ErrorCode::kLimitReached,
                       fmt::format("queries are nested more than {} deep here", kDeepestQuery)));
  }
  Query query;
  while (true) {
    auto selector = ReadSelector(lexer, depth);
    if (!selector) return Fail(selector);
    query.selectors.push_back(std::move(*selector));
    const auto relation = AcceptRelation(lexer);
    if (!relation) return query;
    query.relations.push_back(*relation);
  }
}

Result<Query> ParseQuery(std::string_view text, std::string_view file) {
  Lexer lexer(text, file);
  auto query = ReadQuery(&lexer);
  if (!query || lexer.At(Token::Kind::kEnd)) return query;
  Error error = lexer.Unexpected("'>', '/', '~' or the end of the query");
  if (error.hint.empty() && AtQuery(lexer)) {
    error.hint =
        "the parts of one selector stand without blanks; between selectors stands > / or ~";
  }
  return tl::unexpected<Error>(std::move(error));
}

std::string TextOf(const Query& query) {
  std::string text;
  for (size_t i = 0; i < query.selectors.size(); ++i) {
    if (i > 0) text += fmt::format(" {} ", static_cast<char>(query.relations[i - 1]));
    text += TextOf(query.selectors[i]);
  }
  return text;
}

}  // namespace parti::grammar
