// parti_facades ANNOTATIONS.jsonl FOLDER: a rule file for each annotated façade, ready for
// `parti derive`, and sheet.png with a picture of each.
#include <fmt/format.h>

#include <cstdlib>
#include <filesystem>

#include "app/picture.h"
#include "base/text_file.h"
#include "tests/facades/contact_sheet.h"
#include "tests/facades/derived_facade.h"

namespace parti::tests {
namespace {

constexpr Vec2 kPicture_px{480, 480};
constexpr int kColumns = 9;

/// A little from the side, so that depth is seen.
Camera ViewOf(const AnnotatedFacade& facade) {
  const Vec3 middle(facade.size_m.x / 2, facade.size_m.y / 2, 0);
  const double far = 1.35 * std::max(facade.size_m.x, facade.size_m.y);
  Camera camera;
  camera.eye = middle + Vec3(-0.45, 0.12, 1.0) * far;
  camera.target = middle;
  camera.width_px = kPicture_px.x;
  camera.height_px = kPicture_px.y;
  return camera;
}

int Fail(const Error& error) {
  fmt::print(stderr, "{}\n", FormatError(error));
  return EXIT_FAILURE;
}

int Run(const std::string& data, const std::string& folder) {
  const auto facades = ReadAnnotatedFacades(data);
  if (!facades) return Fail(facades.error());
  std::filesystem::create_directories(folder);
  std::vector<render::Image> pictures;
  for (const AnnotatedFacade& facade : *facades) {
    const std::string rules = RulesOf(facade), path = fmt::format("{}/{}.cga", folder, facade.id);
    if (const auto written = WriteFile(path, rules); !written) return Fail(written.error());
    app::SessionState state;
    state.model = ModelOf(facade, rules);
    state.camera = ViewOf(facade);
    auto picture = app::PictureOf(state);
    if (!picture) return Fail(picture.error());
    pictures.push_back(std::move(*picture));
    fmt::print("parti derive {} --start Lot --lot \"{}\" --stats\n", path, LotOf(facade));
  }
  const auto sheet = render::WritePng(ContactSheet(pictures, kColumns), folder + "/sheet.png");
  return sheet ? EXIT_SUCCESS : Fail(sheet.error());
}

}  // namespace
}  // namespace parti::tests

int main(int argc, char** argv) {
  if (argc != 3) {
    fmt::print(stderr, "usage: parti_facades ANNOTATIONS.jsonl FOLDER\n");
    return 2;
  }
  return parti::tests::Run(argv[1], argv[2]);
}
