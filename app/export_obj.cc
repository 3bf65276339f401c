#include "app/export_obj.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <map>
#include <set>
#include <unordered_map>
#include <utility>

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

/// Writes shapes one after the other; OBJ numbers corners and normals through the whole file.
class ObjMaker {
 public:
  void AddGroup(const SymbolGroup& group, const ModelMesh& mesh, bool with_materials) {
    bool named = false;
    for (const size_t i : group.parts) {
      const WeldedPart& part = welder_.Weld(mesh.parts[i].corners);
      if (part.triangles.empty()) continue;
      if (!named) text_ += fmt::format("g {}\n", Word(group.name));
      named = true;
      const std::string material = MaterialName(mesh.parts[i]);
      if (with_materials && material != material_) text_ += fmt::format("usemtl {}\n", material);
      material_ = material;
      Add(part, mesh.parts[i].uvs);
    }
  }
  const std::string& text() const { return text_; }
  bool empty() const { return points_ == 0; }

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

  Welder welder_;
  std::string text_, material_;
  size_t points_ = 0;
  std::unordered_map<std::string, size_t> normals_, uvs_;
};

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

/// Each material once, by colour and name; "" where no shape has a colour or material.
std::string MaterialsOf(const ModelMesh& mesh) {
  std::map<std::pair<uint32_t, std::string>, std::string> texts;
  bool dressed = false;
  for (const ModelPart& part : mesh.parts) {
    texts.try_emplace({part.color_rgb, MaterialName(part)}, MaterialText(part));
    dressed = dressed || part.color_rgb != 0 || part.material;
  }
  if (!dressed) return "";
  std::string text = "# Parti\n";
  for (const auto& [key, material] : texts) text += material;
  return text;
}

/// The images that materials name, beside the file.
Result<void> WriteImages(const ModelMesh& mesh, const std::filesystem::path& folder) {
  std::set<std::string> written;
  for (const ModelPart& part : mesh.parts) {
    if (!part.material || !part.material->image) continue;
    const grammar::Image& image = *part.material->image;
    if (!written.insert(image.name).second) continue;
    if (auto good = WriteFile((folder / image.name).string(), image.bytes); !good) return good;
  }
  return {};
}

}  // namespace

Result<ObjText> ObjTextOf(const ModelMesh& mesh, const std::string& mtl_name) {
  ObjText text;
  text.mtl = MaterialsOf(mesh);
  ObjMaker maker;
  for (const SymbolGroup& group : GroupBySymbol(mesh)) {
    maker.AddGroup(group, mesh, !text.mtl.empty());
  }
  if (maker.empty()) {
    return Fail(ErrorCode::kNothingMade, "there is nothing to export",
                "the model has no visible shape with an area");
  }
  text.obj = "# Parti: metres, y up\n";
  if (!text.mtl.empty()) text.obj += fmt::format("mtllib {}\n", mtl_name);
  text.obj += maker.text();
  return text;
}

Result<void> ExportObj(const ModelMesh& mesh, const std::string& path) {
  const std::filesystem::path mtl = std::filesystem::path(path).replace_extension(".mtl");
  Result<ObjText> text = ObjTextOf(mesh, mtl.filename().string());
  if (!text) {
    text.error().message = path + ": " + text.error().message;
    return Fail(text);
  }
  if (!text->mtl.empty()) {
    if (auto written = WriteFile(mtl.string(), text->mtl); !written) return written;
    if (auto written = WriteImages(mesh, mtl.parent_path()); !written) return written;
  }
  return WriteFile(path, text->obj);
}

}  // namespace parti::app
