// Result and Error: how every expected failure travels (bad text, no fit, device gone).
// All codes are named here, so that a caller can tell failures apart without reading messages.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <tl/expected.hpp>
#include <vector>

namespace parti {

/// What kind of failure; what a caller may tell apart.
enum class ErrorCode {
  kBadText,             ///< text that does not parse; `place` says where
  kBadNumber,           ///< not finite, or outside what its use allows
  kBadArguments,        ///< an operation got what its table row does not take
  kUnknownName,         ///< an operation, filter, symbol, option … that does not exist
  kWrongItemType,       ///< an operation that this kind of item can't take
  kDegenerateGeometry,  ///< zero size, fewer than 3 corners, no area
  kSelfIntersecting,    ///< a polygon that crosses itself
  kNotPlanar,           ///< corners too far from a common plane
  kNothingMade,         ///< the work went well and left nothing
  kNoFit,               ///< no operation, line or target fits a sketch
  kTooShort,            ///< a stroke with too few samples to mean anything
  kBehindEye,           ///< a point that the camera can't see
  kGrazingView,         ///< a plane seen edge on
  kLimitReached,        ///< depth, shapes or time
  kFile,                ///< a file that can't be read or written
  kDamagedFile,         ///< a file that is truncated or inconsistent
  kDevice,              ///< a device that is missing, gone or not permitted
  kGraphics,            ///< no way to draw, or a shader that fails
};

/// Where in a text something stands. line and column count from 1; column in bytes; length >= 1.
struct SourcePlace {
  std::string file;  ///< as the user named it; "" when the text has no file
  int line = 1;
  int column = 1;
  int length = 1;
  std::string line_text;  ///< the whole line, for the caret
};

/// One expected failure, complete enough to be shown to a person.
struct Error {
  ErrorCode code;
  std::string message;                    ///< what is wrong; lower case, no final stop
  std::string hint = {};                  ///< the remedy; may be empty
  std::optional<SourcePlace> place = {};  ///< set where text was read
};

template <typename T>
using Result = tl::expected<T, Error>;

/// Shorthand for returning a failure: `return Fail(ErrorCode::kBadNumber, "…", "…");`
inline tl::unexpected<Error> Fail(ErrorCode code, std::string message, std::string hint = {}) {
  return tl::unexpected<Error>(Error{code, std::move(message), std::move(hint), std::nullopt});
}

/// Passes another call's failure on: `if (!mesh) return Fail(mesh);`
template <typename T>
tl::unexpected<Error> Fail(const Result<T>& failed) {
  return tl::unexpected<Error>(failed.error());
}

/// The text shown to a person, without a final newline. Long lines are cut around the caret, which
/// stands under the character (UTF-8, tabs) that is meant; control characters show as "?".
///   FILE:LINE:COLUMN: error: message        parti: error: message
///      12 |   the line                        hint: the remedy
///         |       ^~~  hint: the remedy
std::string FormatError(const Error& error);

/// The place of byte `offset` in `text` (clamped to its end).
SourcePlace PlaceIn(std::string_view text, std::string_view file, size_t offset, size_t length = 1);

/// The candidate nearest to `word` by edit distance, if near enough to be meant (at most a third of
/// the longer word's length, at least 1, and something in common); capitals don't count. The first
/// of equally near ones. For "did you mean" hints.
std::optional<std::string> DidYouMean(std::string_view word,
                                      const std::vector<std::string>& candidates);

}  // namespace parti
