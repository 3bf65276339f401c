// Real data for tests: $PARTI_DATA, else ../shared/data beside the project.
// None of it is part of the project; our own fixtures lie under tests/ and assets/.
#pragma once

#include <string>

namespace parti::tests {

/// Path of a data file such as "strokes/unistrokes-dev.jsonl"; "" where the folder is missing.
/// With CI=true a missing folder is a test failure, otherwise the caller skips with
/// PARTI_NEED_DATA.
std::string DataFile(const std::string& name);

/// Path of a file of the project itself.
std::string SourceFile(const std::string& name);

}  // namespace parti::tests

/// In a test: a variable with the file's path, or a skip that says why.
#define PARTI_NEED_DATA(variable, name)                                                       \
  const std::string variable = ::parti::tests::DataFile(name);                                \
  if ((variable).empty()) {                                                                   \
    GTEST_SKIP() << "no " << (name) << ": set PARTI_DATA, or put shared/ beside the project"; \
  }
