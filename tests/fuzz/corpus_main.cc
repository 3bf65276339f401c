// Stands in for libFuzzer under other compilers: runs each file given as an argument once, and each
// input of those that end in .pack (pack.py).
#include <cstdint>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size);

namespace {

void Try(std::string_view input) {
  // A copy of its own: reading past its end shows under the sanitizers.
  const std::vector<uint8_t> bytes(input.begin(), input.end());
  LLVMFuzzerTestOneInput(bytes.data(), bytes.size());
}

/// False: not a pack.
bool TryPack(std::string_view pack) {
  while (!pack.empty()) {
    const size_t line = pack.find('\n');
    if (line == 0 || line > 9) return false;
    size_t length = 0;
    for (const char digit : pack.substr(0, line)) {
      if (digit < '0' || digit > '9') return false;
      length = length * 10 + static_cast<size_t>(digit - '0');
    }
    pack.remove_prefix(line + 1);
    if (length > pack.size()) return false;
    Try(pack.substr(0, length));
    pack.remove_prefix(length);
  }
  return true;
}

bool TryFile(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) return false;
  const std::string bytes(std::istreambuf_iterator<char>(in), {});
  if (path.ends_with(".pack")) return TryPack(bytes);
  Try(bytes);
  return true;
}

}  // namespace

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) {
    if (TryFile(argv[i])) continue;
    std::fprintf(stderr, "can't read %s\n", argv[i]);
    return 1;
  }
  return argc > 1 ? 0 : 2;
}
