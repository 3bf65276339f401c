#include "grammar/asset.h"

#include <fmt/format.h>

#include <algorithm>

namespace parti::grammar {
namespace {

constexpr std::string_view kPngStart = "\x89PNG\r\n\x1a\n";
constexpr std::string_view kPngEnd = "IEND\xae\x42\x60\x82";
constexpr std::string_view kJpegStart = "\xff\xd8\xff";
constexpr std::string_view kJpegEnd = "\xff\xd9";

std::string EndingOf(std::string_view name) {
  const size_t dot = name.rfind('.');
  std::string ending(dot == std::string_view::npos ? "" : name.substr(dot));
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
  return ending;
}

}  // namespace

Result<Image> ImageFrom(std::string_view bytes, std::string_view name) {
  const bool png = bytes.starts_with(kPngStart), jpeg = bytes.starts_with(kJpegStart);
  if (!png && !jpeg) {
    return Fail(ErrorCode::kDamagedFile, fmt::format("{} is neither PNG nor JPEG", name),
                "save it as one of them");
  }
  // Some programs append what nobody reads: the end need not be the last.
  if (bytes.rfind(png ? kPngEnd : kJpegEnd) == std::string_view::npos) {
    return Fail(ErrorCode::kDamagedFile, fmt::format("{} is cut short", name), "save it anew");
  }
  const size_t slash = name.rfind('/');
  return Image{std::string(slash == std::string_view::npos ? name : name.substr(slash + 1)),
               std::string(bytes)};
}

Result<Asset> AssetFrom(std::string_view bytes, std::string_view name, const FileReader& files) {
  const std::string ending = EndingOf(name);
  if (ending == ".obj") return AssetFromObj(bytes, name, files);
  if (ending == ".gltf" || ending == ".glb") return AssetFromGltf(bytes, name, files);
  if (ending == ".png" || ending == ".jpg" || ending == ".jpeg") {
    auto image = ImageFrom(bytes, name);
    if (!image) return Fail(image);
    Asset asset;
    asset.image = std::make_shared<const Image>(std::move(*image));
    return asset;
  }
  return Fail(ErrorCode::kUnknownName, fmt::format("'{}' is no asset that is known", name),
              "there are .obj, .gltf, .glb, .png and .jpg");
}

}  // namespace parti::grammar
