// parti_draw_house OUT.pen [SEED]: draws the demo anew. The shipped one has seed 1.
#include <fmt/format.h>

#include <cstdlib>

#include "base/text_file.h"
#include "tests/pen/house_plan.h"

int main(int argc, char** argv) {
  if (argc < 2 || argc > 3) {
    fmt::print(stderr, "usage: parti_draw_house OUT.pen [SEED]\n");
    return 2;
  }
  const uint64_t seed = argc == 3 ? std::strtoull(argv[2], nullptr, 10) : 1;
  const auto text = parti::input::WriteDrawing(parti::tests::HouseDrawing(seed));
  const auto written = text ? parti::WriteFile(argv[1], *text) : parti::Fail(text);
  if (written) return 0;
  fmt::print(stderr, "{}\n", parti::FormatError(written.error()));
  return 1;
}
