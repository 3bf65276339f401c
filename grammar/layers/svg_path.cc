#include "grammar/layers/svg_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <utility>

#include "grammar/layers/path_arc.h"

namespace parti::grammar {
namespace {

constexpr double kLargest = 1e6;
constexpr size_t kMostSegments = 10'000;
constexpr std::string_view kCommands = "MLHVCSQTAZmlhvcsqtaz";

bool IsDigit(char c) { return c >= '0' && c <= '9'; }
bool IsBlank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\f'; }
char Capital(char c) { return c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c; }

/// Numbers, flags and commands of path data, one after the other.
class PathScanner {
 public:
  explicit PathScanner(std::string_view text) : text_(text) { SkipBlanks(); }

  bool AtEnd() const { return at_ >= text_.size(); }
  /// Nothing where none is; moves on.
  std::optional<char> Command() {
    if (AtEnd() || kCommands.find(text_[at_]) == std::string_view::npos) return std::nullopt;
    const char command = text_[at_++];
    SkipBlanks();
    return command;
  }

  bool AtNumber() const {
    const char c = CharAt(at_);
    return IsDigit(c) || c == '.' || c == '-' || c == '+';
  }

  Result<double> Number() {
    const size_t end = EndOfNumber();
    const size_t plus = CharAt(at_) == '+' ? 1 : 0;
    double number = 0;
    const auto [stop, error] =
        std::from_chars(text_.data() + at_ + plus, text_.data() + end, number);
    if (error == std::errc::invalid_argument || end == at_ || stop != text_.data() + end) {
      return Unexpected("a number");
    }
    if (error != std::errc() || std::abs(number) > kLargest) {
      return FailAt(ErrorCode::kBadNumber, end - at_, "a number is too large",
                    fmt::format("paths are drawn in the unit square; give up to {:g}", kLargest));
    }
    at_ = end;
    SkipSeparator();
    return number;
  }

  /// 0 or 1, which need nothing after them.
  Result<bool> Flag() {
    const char c = CharAt(at_);
    if (c != '0' && c != '1') return Unexpected("a flag, 0 or 1");
    ++at_;
    SkipSeparator();
    return c == '1';
  }

  tl::unexpected<Error> Unexpected(std::string_view wanted) const {
    const std::string got = AtEnd() ? "the end" : fmt::format("'{}'", Shown());
    return FailAt(ErrorCode::kBadText, 1, fmt::format("expected {}, got {}", wanted, got),
                  "paths are written as in SVG: M0,0 L0,1 L1,1 Z");
  }
  tl::unexpected<Error> FailAt(ErrorCode code, size_t length, std::string_view what,
                               std::string hint) const {
    Error error{code, fmt::format("path, character {}: {}", at_ + 1, what), std::move(hint), {}};
    error.place = PlaceIn(text_, "", at_, length);
    return tl::unexpected<Error>(std::move(error));
  }

 private:
  char CharAt(size_t offset) const { return offset < text_.size() ? text_[offset] : '\0'; }
  std::string_view Shown() const {
    return text_[at_] >= ' ' && text_[at_] < 127 ? text_.substr(at_, 1) : "?";
  }
  void SkipBlanks() {
    while (at_ < text_.size() && IsBlank(text_[at_])) ++at_;
  }
  /// Blanks and at most one comma, after which a number has to follow.
  void SkipSeparator() {
    SkipBlanks();
    if (CharAt(at_) != ',') return;
    size_t after = at_ + 1;
    while (IsBlank(CharAt(after))) ++after;
    const char c = CharAt(after);
    if (IsDigit(c) || c == '.' || c == '-' || c == '+') at_ = after;
  }
  size_t SkipDigits(size_t offset) const {
    while (IsDigit(CharAt(offset))) ++offset;
    return offset;
  }
  /// "1.5.5" is two numbers, "1-2" too.
  size_t EndOfNumber() const {
    size_t end = at_;
    if (CharAt(end) == '-' || CharAt(end) == '+') ++end;
    end = SkipDigits(end);
    if (CharAt(end) == '.') end = SkipDigits(end + 1);
    if (CharAt(end) != 'e' && CharAt(end) != 'E') return end;
    size_t exponent = end + 1;
    if (CharAt(exponent) == '-' || CharAt(exponent) == '+') ++exponent;
    return IsDigit(CharAt(exponent)) ? SkipDigits(exponent) : end;
  }

  std::string_view text_;
  size_t at_ = 0;
};

PathSegment Line(const Vec2& from, const Vec2& to) {
  PathSegment segment;
  segment.points[0] = from;
  segment.points[1] = to;
  return segment;
}

/// Executes the commands; holds the pen.
class PathReader {
 public:
  explicit PathReader(std::string_view text) : scanner_(text) {}

  Result<SvgPath> Read() {
    char before = '\0';
    while (!scanner_.AtEnd()) {
      const PathScanner here = scanner_;
      auto command = scanner_.Command();
      const bool repeats = !command && before != '\0' && Capital(before) != 'Z';
      if (repeats && scanner_.AtNumber()) command = Repeated(before);
      if (!command || (before == '\0' && Capital(*command) != 'M')) {
        return here.Unexpected(before == '\0' ? "M, where the path starts" : "a command");
      }
      if (const auto done = Run(*command); !done) return Fail(done);
      before = *command;
      if (++commands_ > kMostSegments) {
        return scanner_.FailAt(ErrorCode::kLimitReached, 1,
                               fmt::format("more than {} segments", kMostSegments),
                               "draw it with fewer, or with curves");
      }
    }
    Close();
    if (!path_.empty()) return std::move(path_);
    return scanner_.Unexpected("a closed line");
  }

 private:
  /// What further numbers after a command mean: after M, lines.
  static char Repeated(char command) {
    if (command == 'M') return 'L';
    return command == 'm' ? 'l' : command;
  }

  Result<void> Run(char command) {
    relative_ = command >= 'a';
    const char kind = Capital(command);
    Result<void> done;
    switch (kind) {
      case 'Z':
        Close();
        break;
      case 'M':
        done = Move();
        break;
      case 'L':
      case 'H':
      case 'V':
        done = LineTo(kind);
        break;
      case 'A':
        done = ArcTo();
        break;
      default:
        done = CurveTo(kind);
    }
    previous_ = kind;
    return done;
  }

  Result<Vec2> Point() {
    const auto x = scanner_.Number();
    if (!x) return Fail(x);
    const auto y = scanner_.Number();
    if (!y) return Fail(y);
    return Vec2(*x, *y) + (relative_ ? pen_ : Vec2(0, 0));
  }

  Result<void> Move() {
    Close();
    const auto to = Point();
    if (!to) return Fail(to);
    pen_ = start_ = *to;
    return {};
  }

  Result<void> LineTo(char kind) {
    Vec2 to = pen_;
    if (kind == 'L') {
      const auto point = Point();
      if (!point) return Fail(point);
      to = *point;
    } else {
      const auto number = scanner_.Number();
      if (!number) return Fail(number);
      double& coordinate = kind == 'H' ? to.x : to.y;
      coordinate = *number + (relative_ ? coordinate : 0);
    }
    Add(Line(pen_, to));
    return {};
  }

  /// C, S, Q and T; S and T mirror the control point of a curve of their kind before them.
  Result<void> CurveTo(char kind) {
    const bool cubic = kind == 'C' || kind == 'S';
    const bool smooth = kind == 'S' || kind == 'T';
    const bool follows =
        cubic ? previous_ == 'C' || previous_ == 'S' : previous_ == 'Q' || previous_ == 'T';
    PathSegment curve;
    curve.kind = cubic ? PathSegment::Kind::kCubic : PathSegment::Kind::kQuadratic;
    curve.points[0] = pen_;
    const size_t last = cubic ? 3 : 2;
    size_t i = 1;
    if (smooth) curve.points[i++] = follows ? pen_ * 2.0 - control_ : pen_;
    for (; i <= last; ++i) {
      const auto point = Point();
      if (!point) return Fail(point);
      curve.points[i] = *point;
    }
    control_ = curve.points[last - 1];
    Add(curve);
    return {};
  }

  Result<void> ArcTo() {
    double numbers[3];
    for (double& number : numbers) {
      const auto read = scanner_.Number();
      if (!read) return Fail(read);
      number = *read;
    }
    const auto large = scanner_.Flag();
    if (!large) return Fail(large);
    const auto sweep = scanner_.Flag();
    if (!sweep) return Fail(sweep);
    const auto to = Point();
    if (!to) return Fail(to);
    const ArcForm form{Vec2(numbers[0], numbers[1]), numbers[2], *large, *sweep};
    Add(ArcBetween(pen_, *to, form).value_or(Line(pen_, *to)));
    return {};
  }

  void Add(const PathSegment& segment) {
    if (segment.kind != PathSegment::Kind::kLine || segment.end() != pen_) loop_.push_back(segment);
    pen_ = segment.end();
  }

  void Close() {
    if (!loop_.empty()) {
      Add(Line(pen_, start_));
      path_.push_back(std::move(loop_));
      loop_.clear();
    }
    pen_ = start_;
  }

  PathScanner scanner_;
  bool relative_ = false;
  char previous_ = '\0';  ///< the command before, as a capital
  size_t commands_ = 0;
  Vec2 pen_{0, 0}, start_{0, 0};
  Vec2 control_{0, 0};  ///< the last one of the last curve
  std::vector<PathSegment> loop_;
  SvgPath path_;
};

}  // namespace

Vec2 PathSegment::At(double t) const {
  if (t <= 0) return start();
  if (t >= 1) return end();
  const double s = 1 - t;
  const auto& p = points;
  switch (kind) {
    case Kind::kLine:
      return p[0] * s + p[1] * t;
    case Kind::kQuadratic:
      return p[0] * (s * s) + p[1] * (2 * s * t) + p[2] * (t * t);
    case Kind::kCubic:
      return p[0] * (s * s * s) + p[1] * (3 * s * s * t) + p[2] * (3 * s * t * t) +
             p[3] * (t * t * t);
    case Kind::kArc:
      break;
  }
  const double angle = from + by * t;
  const Vec2 on = Vec2(std::cos(angle), std::sin(angle)) * radii;
  const double cosine = std::cos(turned), sine = std::sin(turned);
  return p[2] + Vec2(cosine * on.x - sine * on.y, sine * on.x + cosine * on.y);
}

Result<SvgPath> ParseSvgPath(std::string_view text) { return PathReader(text).Read(); }

}  // namespace parti::grammar
