// What the ending of a file's name says of its kind: "house.png" is a picture.
// What is in a file that is read is told by its contents, never by its name.
#pragma once

#include <string>
#include <string_view>

#include "base/error.h"

namespace parti::app {

/// Of documents.
inline constexpr std::string_view kDocumentEnding = ".parti";

/// ".png" of "old.houses/House.PNG": in small letters; "" of a name without a dot.
std::string EndingOf(const std::string& path);

/// For a file of one kind that is to be written: its name has this ending (".png"), or none.
/// errors  kUnknownName  another, which would make the file look like what it is not.
Result<void> CheckEnding(const std::string& path, std::string_view ending);

}  // namespace parti::app
