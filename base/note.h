// Notes: what is no failure, and still surely not meant. They are Errors that nobody fails with.
// Their text is made as errors' is, in error.cc.
#pragma once

#include <string>

#include "base/error.h"

namespace parti {

/// As FormatError, with "note" in place of "error".
std::string FormatNote(const Error& note);

}  // namespace parti
