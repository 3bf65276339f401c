#include "app/export_obj.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <map>
#include <memory>
#include <unordered_map>
#include <utility>

#include "app/byte_blocks.h"
#include "app/weld.h"
#include "base/text_file.h"

namespace parti::app {
namespace {

/// To the micrometre without trailing zeros, and never "-0".
std::string Number(double value, int decimals) {
  std::string text = fmt::format("{:.{}f}", value, decimals);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string Vector(const char* keyword, const Vec3& v, int decimals) {
  return fmt::format("{} {} {} {}\n", keyword, Number(v.x, decimals), Number(v.y, decimals),
                     Number(v.z, decimals));
}

std::string Word(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return static_cast<unsigned char>(c) <= ' '; }, '_');
  return name;
}

std::string ColorName(uint32_t rgb) { return rgb ? fmt::format("color_{:06X}", rgb) : "plain"; }

/// Materials of one name may differ in what shapes add: the colour is part of the name.
std::string MaterialName(const ModelPart& part) {
  const std::string color = ColorName(part.color_rgb);
  if (!part.material) return color;
  const std::string& name = part.material->name;
  return Word(fmt::format("{}_{}_{:.0f}", name.empty() ? "material" : name, color,
                          100 * part.material->opacity));
}

std::string MaterialText(const ModelPart& part) {
  const grammar::Material* given = part.material.get();
  const bool has_image = given && given->image;
  constexpr uint32_t kPaperWhite = 0xEDEBE6;  // what pictures give shapes without a colour
  const uint32_t rgb = part.color_rgb ? part.color_rgb : has_image ? 0xFFFFFF : kPaperWhite;
  const auto byte = [rgb](int shift) { return Number((rgb >> shift & 255) / 255.0, 4); };
  std::string text =
      fmt::format("newmtl {}\nKd {} {} {}\n", MaterialName(part), byte(16), byte(8), byte(0));
  if (given && given->opacity < 1) text += fmt::format("d {}\n", Number(given->opacity, 4));
  text += "illum 1\n";
  if (has_image) text += fmt::format("map_Kd {}\n", given->image->name);
  return text;
}

/// What parts wear: the text of the material file, and the images that lie beside it.
class Wardrobe {
 public:
  /// Returns the name of the part's material.
  std::string Add(const ModelPart& part) {
    const bool is_plain = part.color_rgb == 0 && !part.material;
    is_dressed_ = is_dressed_ || !is_plain;
    std::string name = MaterialName(part);
    std::string& text = texts_[{part.color_rgb, name}];
    if (text.empty()) text = MaterialText(part);
    if (part.material && part.material->image) {
      materials_.try_emplace(part.material->image->name, part.material);
    }
    return name;
  }

  /// Some part has a colour or a material.
  bool is_dressed() const { return is_dressed_; }

  /// Each material once, by colour and name; "" where nothing is dressed.
  std::string Text() const {
    if (!is_dressed_) return "";
    std::string text = "# Parti\n";
    for (const auto& [key, material] : texts_) text += material;
    return text;
  }

  Result<void> WriteImages(const std::filesystem::path& folder) const {
    for (const auto& [name, material] : materials_) {
      auto good = WriteFile((folder / name).string(), material->image->bytes);
      if (!good) return good;
    }
    return {};
  }

 private:
  std::map<std::pair<uint32_t, std::string>, std::string> texts_;
  /// The first that wears each image.
  std::map<std::string, std::shared_ptr<const grammar::Material>> materials_;
  bool is_dressed_ = false;
};

/// Writes shapes one after the other; OBJ numbers corners and normals through the whole file.
class ObjMaker {
 public:
  /// Those of a group follow each other.
  void Add(const ModelPart& part) {
    const std::string material = wardrobe_.Add(part);
    const WeldedPart& welded = welder_.Weld(part.corners);
    if (welded.triangles.empty()) return;
    if (const std::string group = GroupNameOf(part.symbol); empty() || group != group_) {
      (empty() ? opening_ : text_) += fmt::format("g {}\n", Word(group));
      group_ = group;
    }
    if (material != material_) {
      (empty() ? first_use_ : text_) += fmt::format("usemtl {}\n", material);
    }
    material_ = material;
    Add(welded, part.uvs);
    blocks_.Append(text_.data(), text_.size());
    text_.clear();
  }

  bool empty() const { return points_ == 0; }
  const Wardrobe& wardrobe() const { return wardrobe_; }

  /// The file, once. Whether there are materials is known in the end: where there are none, "plain"
  /// was the only one, and is not named.
  std::string Take(const std::string& mtl_name) {
    std::string obj = "# Parti: metres, y up\n";
    if (wardrobe_.is_dressed()) obj += fmt::format("mtllib {}\n", mtl_name);
    obj += opening_;
    if (wardrobe_.is_dressed()) obj += first_use_;
    obj.reserve(obj.size() + blocks_.size());
    blocks_.MoveTo(&obj);
    return obj;
  }

 private:
  void Add(const WeldedPart& part, const std::vector<Vec2>& uvs) {
    for (const Vec3& p : part.points) text_ += Vector("v", p, 6);
    for (size_t i = 0; i < part.triangles.size(); i += 3) {
      const size_t normal = NormalNumber(part.normals[i / 3]);
      size_t uv[3] = {0, 0, 0};
      for (size_t k = 0; k < 3 && !uvs.empty(); ++k) {
        uv[k] = UvNumber(uvs[part.sources[i / 3] * 3 + k]);
      }
      text_ += "f";
      for (size_t k = 0; k < 3; ++k) {
        fmt::format_to(std::back_inserter(text_), " {}/{}/{}", points_ + part.triangles[i + k] + 1,
                       uvs.empty() ? std::string() : std::to_string(uv[k]), normal);
      }
      text_ += "\n";
    }
    points_ += part.points.size();
  }

  size_t UvNumber(const Vec2& uv) {
    const std::string line = fmt::format("vt {} {}\n", Number(uv.x, 6), Number(uv.y, 6));
    const auto [it, is_new] = uvs_.emplace(line, uvs_.size() + 1);
    if (is_new) text_ += line;
    return it->second;
  }

  size_t NormalNumber(const Vec3& normal) {
    const std::string line = Vector("vn", normal, 6);
    const auto [it, is_new] = normals_.emplace(line, normals_.size() + 1);
    if (is_new) text_ += line;
    return it->second;
  }

  Wardrobe wardrobe_;
  Welder welder_;
  ByteBlocks blocks_;
  std::string opening_, first_use_;  ///< "g …" and "usemtl …" of the first part
  std::string text_;                 ///< of one part
  std::string group_, material_;
  size_t points_ = 0;
  std::unordered_map<std::string, size_t> normals_, uvs_;
};

/// errors  kNothingMade.
Result<void> AddAll(const ModelParts& parts, ObjMaker* maker) {
  parts.visit_groups([maker](const ModelPart& part) {
    maker->Add(part);
    return true;
  });
  if (!maker->empty()) return {};
  return Fail(ErrorCode::kNothingMade, "there is nothing to export",
              "the model has no visible shape with an area");
}

}  // namespace

Result<ObjText> ObjTextOf(const ModelParts& parts, const std::string& mtl_name) {
  ObjMaker maker;
  if (const auto added = AddAll(parts, &maker); !added) return Fail(added);
  return ObjText{maker.Take(mtl_name), maker.wardrobe().Text()};
}

Result<ObjText> ObjTextOf(const ModelMesh& mesh, const std::string& mtl_name) {
  return ObjTextOf(PartsOf(mesh), mtl_name);
}

Result<void> ExportObj(const ModelParts& parts, const std::string& path) {
  const std::filesystem::path mtl = std::filesystem::path(path).replace_extension(".mtl");
  ObjMaker maker;
  if (auto added = AddAll(parts, &maker); !added) {
    added.error().message = path + ": " + added.error().message;
    return added;
  }
  if (maker.wardrobe().is_dressed()) {
    auto written = WriteFile(mtl.string(), maker.wardrobe().Text());
    if (!written) return written;
    if (written = maker.wardrobe().WriteImages(mtl.parent_path()); !written) return written;
  }
  return WriteFile(path, maker.Take(mtl.filename().string()));
}

Result<void> ExportObj(const ModelMesh& mesh, const std::string& path) {
  return ExportObj(PartsOf(mesh), path);
}

}  // namespace parti::app
