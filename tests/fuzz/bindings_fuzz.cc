// Any bytes as a table of bindings: the reader never crashes, and what it reads is written and read
// back the same.
#include <cstddef>
#include <cstdint>
#include <string_view>

#include "base/check.h"
#include "input/binding_table.h"

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  using namespace parti::input;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto table = ReadBindings(text);
  if (!table) {
    parti::FormatError(table.error());
    return 0;
  }
  const auto again = ReadBindings(BindingsText(*table));
  CHECK(again && *again == *table, "what was written is what was read");
  return 0;
}
