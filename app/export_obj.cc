#include "app/export_obj.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <set>
#include <unordered_map>

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

std::string MaterialName(uint32_t rgb) { return rgb ? fmt::format("color_{:06X}", rgb) : "plain"; }

/// Writes shapes one after the other; OBJ numbers corners and normals through the whole file.
class ObjMaker {
 public:
  void AddGroup(const SymbolGroup& group, const ModelMesh& mesh, bool with_materials) {
    bool named = false;
    for (const size_t i : group.parts) {
      const WeldedPart part = Weld(mesh.parts[i].corners);
      if (part.triangles.empty()) continue;
      if (!named) text_ += fmt::format("g {}\n", Word(group.name));
      named = true;
      const std::string material = MaterialName(mesh.parts[i].color_rgb);
      if (with_materials && material != material_) text_ += fmt::format("usemtl {}\n", material);
      material_ = material;
      Add(part);
    }
  }
  const std::string& text() const { return text_; }
  bool empty() const { return points_ == 0; }

 private:
  void Add(const WeldedPart& part) {
    for (const Vec3& p : part.points) text_ += Vector("v", p, 6);
    for (size_t i = 0; i < part.triangles.size(); i += 3) {
      const size_t normal = NormalNumber(part.normals[i / 3]);
      const auto corner = [&](size_t k) { return points_ + part.triangles[i + k] + 1; };
      fmt::format_to(std::back_inserter(text_), "f {}//{} {}//{} {}//{}\n", corner(0), normal,
                     corner(1), normal, corner(2), normal);
    }
    points_ += part.points.size();
  }

  size_t NormalNumber(const Vec3& normal) {
    const std::string line = Vector("vn", normal, 6);
    const auto [it, is_new] = normals_.emplace(line, normals_.size() + 1);
    if (is_new) text_ += line;
    return it->second;
  }

  std::string text_, material_;
  size_t points_ = 0;
  std::unordered_map<std::string, size_t> normals_;
};

std::string MaterialsOf(const ModelMesh& mesh) {
  std::set<uint32_t> colors;
  for (const ModelPart& part : mesh.parts) colors.insert(part.color_rgb);
  if (colors.empty() || *colors.rbegin() == 0) return "";
  std::string text = "# Parti\n";
  for (const uint32_t color : colors) {
    const uint32_t rgb = color ? color : 0xEDEBE6;  // what pictures give shapes without a colour
    const auto part = [rgb](int shift) { return Number((rgb >> shift & 255) / 255.0, 4); };
    text += fmt::format("newmtl {}\nKd {} {} {}\nillum 1\n", MaterialName(color), part(16), part(8),
                        part(0));
  }
  return text;
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
  }
  return WriteFile(path, text->obj);
}

}  // namespace parti::app
