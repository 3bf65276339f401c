#include "app/panels/letters.h"

#include <fmt/format.h>
#include <fontconfig/fontconfig.h>
#include <imgui_freetype.h>

#include <array>
#include <cmath>
#include <cstring>

#include "app/panels/theme.h"
#include "base/text_file.h"

namespace parti::app::panels {
namespace {

struct FreePattern {
  void operator()(FcPattern* pattern) const { FcPatternDestroy(pattern); }
};
using Pattern = std::unique_ptr<FcPattern, FreePattern>;

struct FreeConfig {
  void operator()(FcConfig* config) const { FcConfigDestroy(config); }
};
/// What is installed. Our own and not the library's, which it keeps until the program ends.
using Config = std::unique_ptr<FcConfig, FreeConfig>;

constexpr const char* kRemedy = "install the Debian package fonts-inter";

std::string TextIn(FcPattern* pattern, const char* field) {
  FcChar8* text = nullptr;
  if (FcPatternGetString(pattern, field, 0, &text) != FcResultMatch) return {};
  return reinterpret_cast<const char*>(text);
}

/// What fontconfig holds for the nearest to the family in that weight.
Pattern Match(FcConfig* config, const std::string& family, int weight) {
  Pattern wanted(FcPatternCreate());
  const auto* name = reinterpret_cast<const FcChar8*>(family.c_str());
  FcPatternAddString(wanted.get(), FC_FAMILY, name);
  FcPatternAddString(wanted.get(), FC_FAMILY, reinterpret_cast<const FcChar8*>("sans-serif"));
  FcPatternAddString(wanted.get(), FC_LANG, reinterpret_cast<const FcChar8*>("en"));
  FcPatternAddInteger(wanted.get(), FC_WEIGHT, weight);
  FcPatternAddInteger(wanted.get(), FC_SLANT, FC_SLANT_ROMAN);
  FcPatternAddBool(wanted.get(), FC_SCALABLE, FcTrue);
  FcConfigSubstitute(config, wanted.get(), FcMatchPattern);
  FcDefaultSubstitute(wanted.get());
  FcResult result = FcResultNoMatch;
  return Pattern(FcFontMatch(config, wanted.get(), &result));
}

/// The bytes of a font that can be drawn; "" where there is none.
std::string BytesOf(FcPattern* match) {
  const std::string format = TextIn(match, FC_FONTFORMAT);
  if (format != "TrueType" && format != "CFF") return {};
  return ReadFile(TextIn(match, FC_FILE)).value_or("");
}

/// Latin with its accents, Greek for dimensions, punctuation, currencies, arrows, signs.
constexpr std::array<ImWchar, 17> kGlyphs = {0x0020, 0x024f, 0x0370, 0x03ff, 0x1e00, 0x1eff,
                                             0x2010, 0x2044, 0x2070, 0x20bf, 0x2190, 0x2199,
                                             0x2200, 0x2265, 0x25a0, 0x25cf, 0};

ImFont* Add(ImFontAtlas* atlas, const std::string& bytes, double size_em_px) {
  ImFontConfig config;
  config.FontDataOwnedByAtlas = false;
  config.OversampleH = 1;
  config.PixelSnapH = true;
  // Sizes are of the line here, from the highest to the lowest letter: 1.21 em in Inter.
  const auto line_px = static_cast<float>(std::round(size_em_px * 1.21));
  // The atlas does not write into bytes that it doesn't own.
  return atlas->AddFontFromMemoryTTF(const_cast<char*>(bytes.data()),
                                     static_cast<int>(bytes.size()), line_px, &config,
                                     kGlyphs.data());
}

std::shared_ptr<const render::Image> PictureOf(ImFontAtlas* atlas) {
  unsigned char* pixels = nullptr;
  int width = 0, height = 0;
  atlas->GetTexDataAsRGBA32(&pixels, &width, &height);
  auto image = std::make_shared<render::Image>();
  image->width = width;
  image->height = height;
  image->pixels.assign(
      pixels, pixels + size_t{4} * static_cast<size_t>(width) * static_cast<size_t>(height));
  return image;
}

}  // namespace

Result<FontFiles> FindFont(const std::string& family) {
  const Config config(FcInitLoadConfigAndFonts());
  if (!config) return Fail(ErrorCode::kGraphics, "fontconfig does not start", kRemedy);
  const Pattern regular = Match(config.get(), family, FC_WEIGHT_REGULAR);
  if (!regular) return Fail(ErrorCode::kGraphics, "no font is installed", kRemedy);
  FontFiles files{TextIn(regular.get(), FC_FAMILY), BytesOf(regular.get()), {}};
  if (files.regular.empty()) {
    return Fail(ErrorCode::kGraphics,
                fmt::format("the font {} can't be used", TextIn(regular.get(), FC_FILE)), kRemedy);
  }
  const Pattern strong = Match(config.get(), files.family, FC_WEIGHT_DEMIBOLD);
  if (strong) files.strong = BytesOf(strong.get());
  if (files.strong.empty()) files.strong = files.regular;
  return files;
}

Result<Letters> DrawLetters(const FontFiles& files, double scale) {
  Letters letters;
  letters.atlas = std::make_unique<ImFontAtlas>();
  ImFontAtlas* atlas = letters.atlas.get();
  atlas->FontBuilderIO = ImGuiFreeType::GetBuilderForFreeType();
  atlas->FontBuilderFlags = ImGuiFreeTypeBuilderFlags_LightHinting;
  atlas->Flags |= ImFontAtlasFlags_NoMouseCursors;
  atlas->TexDesiredWidth = scale > 1.5 ? 2048 : 1024;
  letters.body = Add(atlas, files.regular, kMeasures.body * scale);
  letters.small = Add(atlas, files.regular, kMeasures.small * scale);
  letters.strong = Add(atlas, files.strong, kMeasures.body * scale);
  if (!letters.body || !letters.small || !letters.strong || !atlas->Build()) {
    return Fail(ErrorCode::kGraphics, fmt::format("the font {} can't be drawn", files.family),
                kRemedy);
  }
  letters.picture = PictureOf(atlas);
  atlas->ClearInputData();
  return letters;
}

}  // namespace parti::app::panels
