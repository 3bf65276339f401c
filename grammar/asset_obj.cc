// Wavefront OBJ and its materials (MTL). Read by hand: the usual loaders take a damaged number for
// 0 and a missing material for none, and say nothing.
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <map>
#include <utility>

#include "grammar/asset_mesh.h"

namespace parti::grammar {
namespace {

constexpr std::string_view kBlanks = " \t\r";

/// A line of a text, word by word.
class Words {
 public:
  explicit Words(std::string_view line) : rest_(line) {}

  std::string_view Next() {
    const size_t start = rest_.find_first_not_of(kBlanks);
    if (start == std::string_view::npos) return {};
    const size_t end = std::min(rest_.find_first_of(kBlanks, start), rest_.size());
    const std::string_view word = rest_.substr(start, end - start);
    rest_.remove_prefix(end);
    return word;
  }
  /// What is left, blanks around it not counted: names may hold blanks.
  std::string_view Rest() const {
    const size_t start = rest_.find_first_not_of(kBlanks);
    if (start == std::string_view::npos) return {};
    return rest_.substr(start, rest_.find_last_not_of(kBlanks) + 1 - start);
  }

 private:
  std::string_view rest_;
};

std::optional<double> NumberFrom(std::string_view word) {
  double value = 0;
  const char* const end = word.data() + word.size();
  const auto [at, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc() || at != end || !std::isfinite(value)) return std::nullopt;
  return value;
}

/// Calls act(line, words after the first, first word) for every line; stops at a failure.
template <typename Act>
Result<void> ForLines(std::string_view text, std::string_view name, const Act& act) {
  for (size_t from = 0; from < text.size();) {
    const size_t end = std::min(text.find('\n', from), text.size());
    std::string_view line = text.substr(from, end - from);
    if (const size_t comment = line.find('#'); comment != std::string_view::npos) {
      line = line.substr(0, comment);
    }
    Words words(line);
    const std::string_view keyword = words.Next();
    if (auto good = act(keyword, words); !good) {
      Error error = good.error();
      if (!error.place) error.place = PlaceIn(text, name, from, std::max<size_t>(line.size(), 1));
      return tl::unexpected<Error>(std::move(error));
    }
    from = end + 1;
  }
  return {};
}

Result<Vec3> ReadNumbers(Words* words, int count, std::string_view what) {
  Vec3 numbers(0, 0, 0);
  for (int i = 0; i < count; ++i) {
    const std::string_view word = words->Next();
    const auto number = NumberFrom(word);
    if (!number) {
      return Fail(ErrorCode::kDamagedFile,
                  word.empty() ? fmt::format("{} lacks a number", what)
                               : fmt::format("'{}' is no number of {}", word, what),
                  "export the model anew");
    }
    numbers[i] = *number;
  }
  return numbers;
}

using Materials = std::map<std::string, std::shared_ptr<const Material>, std::less<>>;

uint32_t Packed(const Vec3& rgb) {
  uint32_t packed = 0;
  for (int i = 0; i < 3; ++i) {
    packed = packed << 8 | static_cast<uint32_t>(std::lround(glm::clamp(rgb[i], 0.0, 1.0) * 255));
  }
  return std::max(packed, 1u);
}

/// The file of a map statement: the last word, options before it.
std::string_view FileOf(Words words) {
  std::string_view file, last;
  if (!words.Rest().starts_with('-')) return words.Rest();
  while (!(last = words.Next()).empty()) file = last;
  return file;
}

class MaterialReader {
 public:
  MaterialReader(const FileReader& files, Materials* materials)
      : files_(files), materials_(materials) {}

  Result<void> Read(std::string_view text, std::string_view name) {
    auto read = ForLines(text, name, [this](std::string_view keyword, Words words) {
      return ReadLine(keyword, words);
    });
    Keep();
    return read;
  }

 private:
  Result<void> ReadLine(std::string_view keyword, Words words) {
    if (keyword == "newmtl") {
      Keep();
      at_ = Material();
      at_.name = words.Rest();
    } else if (keyword == "Kd") {
      const auto rgb = ReadNumbers(&words, 3, "a color");
      if (!rgb) return Fail(rgb);
      at_.color_rgb = Packed(*rgb);
    } else if (keyword == "d" || keyword == "Tr") {
      const auto part = ReadNumbers(&words, 1, "an opacity");
      if (!part) return Fail(part);
      at_.opacity = glm::clamp(keyword == "d" ? part->x : 1 - part->x, 0.0, 1.0);
    } else if (keyword == "map_Kd") {
      return ReadImage(FileOf(words));
    }
    return {};
  }

  Result<void> ReadImage(std::string_view file) {
    const auto bytes = files_(std::string(file));
    if (!bytes) return Fail(bytes);
    auto image = ImageFrom(*bytes, file);
    if (!image) return Fail(image);
    at_.image = std::make_shared<const Image>(std::move(*image));
    return {};
  }

  void Keep() {
    if (!at_.name.empty()) (*materials_)[at_.name] = std::make_shared<const Material>(at_);
  }

  const FileReader& files_;
  Materials* materials_;
  Material at_;
};

class ObjReader {
 public:
  ObjReader(std::string_view name, const FileReader& files) : name_(name), files_(files) {}

  Result<Asset> Read(std::string_view text) {
    const auto read = ForLines(text, name_, [this](std::string_view keyword, Words words) {
      return ReadLine(keyword, words);
    });
    if (!read) return Fail(read);
    return mesh_.Finish(name_);
  }

 private:
  Result<void> ReadLine(std::string_view keyword, Words words) {
    if (keyword == "v") return AddNumbers(&words, 3, "a corner", &points_);
    if (keyword == "vt") return AddNumbers(&words, 2, "a texture coordinate", &uvs_);
    if (keyword == "f") return AddFace(&words);
    if (keyword == "mtllib") return ReadMaterials(words.Rest());
    if (keyword == "usemtl") return UseMaterial(words.Rest());
    return {};  // groups, normals, lines and what else there is
  }

  static Result<void> AddNumbers(Words* words, int count, std::string_view what,
                                 std::vector<Vec3>* list) {
    const auto numbers = ReadNumbers(words, count, what);
    if (!numbers) return Fail(numbers);
    list->push_back(*numbers);
    return {};
  }

  Result<void> ReadMaterials(std::string_view file) {
    const auto text = files_(std::string(file));
    if (!text) return Fail(text);
    return MaterialReader(files_, &materials_).Read(*text, file);
  }

  Result<void> UseMaterial(std::string_view material) {
    const auto found = materials_.find(material);
    if (found != materials_.end()) {
      material_ = found->second;
      return {};
    }
    // A name alone tells materials apart, too.
    Material named;
    named.name = material;
    material_ = std::make_shared<const Material>(std::move(named));
    materials_.emplace(material, material_);
    return {};
  }

  /// One-based, or counted back from the last where negative. npos: "" is none.
  Result<size_t> IndexFrom(std::string_view word, size_t count, std::string_view what) const {
    int64_t number = 0;
    const char* const end = word.data() + word.size();
    const auto [at, error] = std::from_chars(word.data(), end, number);
    const int64_t index = number < 0 ? static_cast<int64_t>(count) + number : number - 1;
    if (error == std::errc() && at == end && index >= 0 && index < static_cast<int64_t>(count)) {
      return static_cast<size_t>(index);
    }
    return Fail(ErrorCode::kDamagedFile,
                fmt::format("a face has {} '{}'; there are {} so far", what, word, count),
                "export the model anew");
  }

  Result<void> AddFace(Words* words) {
    std::vector<AssetMesh::Corner> face;
    bool has_uv = true;
    for (std::string_view word; !(word = words->Next()).empty();) {
      const size_t slash = std::min(word.find('/'), word.size());
      const size_t second = std::min(word.find('/', slash + 1), word.size());
      const auto point = IndexFrom(word.substr(0, slash), points_.size(), "corner");
      if (!point) return Fail(point);
      AssetMesh::Corner corner{points_[*point]};
      if (second > slash + 1) {
        const auto uv =
            IndexFrom(word.substr(slash + 1, second - slash - 1), uvs_.size(), "coordinate");
        if (!uv) return Fail(uv);
        corner.uv = Vec2(uvs_[*uv]);
      } else {
        has_uv = false;
      }
      face.push_back(corner);
    }
    if (face.size() < 3) {
      return Fail(ErrorCode::kDamagedFile, fmt::format("a face of {} corners", face.size()),
                  "export the model anew");
    }
    mesh_.Add(face, material_, has_uv);
    if (mesh_.faces() <= kMostAssetFaces) return {};
    return Fail(ErrorCode::kLimitReached, fmt::format("more than {} faces", kMostAssetFaces),
                "reduce the model before it is inserted");
  }

  std::string_view name_;
  const FileReader& files_;
  std::vector<Vec3> points_, uvs_;
  Materials materials_;
  std::shared_ptr<const Material> material_;
  AssetMesh mesh_;
};

}  // namespace

Result<Asset> AssetFromObj(std::string_view text, std::string_view name, const FileReader& files) {
  return ObjReader(name, files).Read(text);
}

}  // namespace parti::grammar
