#include "app/export_glb.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <cmath>
#include <cstring>
#include <map>
#include <sstream>
#include <utility>

#include "base/text_file.h"

namespace parti::app {
namespace {

using Float3 = std::array<float, 3>;

/// A corner of one face: where it lies and where its face looks. Corners that agree are shared.
struct Corner {
  Float3 position, normal;
  auto operator<=>(const Corner&) const = default;
};

/// What becomes one primitive: all triangles of a symbol with one material.
struct Surface {
  std::vector<Corner> corners;
  std::vector<uint32_t> indices;
};

/// Colour, and whether it is seen from both sides.
using MaterialKey = std::pair<uint32_t, bool>;

Float3 Floats(const Vec3& v) {
  // + 0 turns -0 into 0, so that equal corners have equal bytes.
  return {static_cast<float>(v.x) + 0.0f, static_cast<float>(v.y) + 0.0f,
          static_cast<float>(v.z) + 0.0f};
}

void AddTo(const ModelPart& part, Surface* surface) {
  const WeldedPart welded = Weld(part.corners);
  std::map<Corner, uint32_t> shared;  // within a shape only: shapes stay apart
  for (size_t i = 0; i < welded.triangles.size(); ++i) {
    const Corner corner{Floats(welded.points[welded.triangles[i]]), Floats(welded.normals[i / 3])};
    const auto [it, is_new] =
        shared.emplace(corner, static_cast<uint32_t>(surface->corners.size()));
    if (is_new) surface->corners.push_back(corner);
    surface->indices.push_back(it->second);
  }
}

double LinearFromSrgb(uint32_t byte) {
  const double c = byte / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

/// Fills a tinygltf::Model; everything lies in one buffer.
class GltfMaker {
 public:
  GltfMaker() {
    model_.asset.version = "2.0";
    model_.asset.generator = "Parti";
    model_.buffers.emplace_back();
    model_.scenes.emplace_back();
    model_.defaultScene = 0;
  }

  void Add(const SymbolGroup& group, const ModelMesh& mesh) {
    std::map<MaterialKey, Surface> surfaces;
    for (const size_t i : group.parts) {
      const ModelPart& part = mesh.parts[i];
      AddTo(part, &surfaces[{part.color_rgb, !part.closed}]);
    }
    tinygltf::Mesh made;
    made.name = group.name;
    for (const auto& [key, surface] : surfaces) {
      if (!surface.indices.empty()) made.primitives.push_back(PrimitiveOf(surface, key));
    }
    if (made.primitives.empty()) return;
    tinygltf::Node node;
    node.name = group.name;
    node.mesh = static_cast<int>(model_.meshes.size());
    model_.scenes[0].nodes.push_back(static_cast<int>(model_.nodes.size()));
    model_.nodes.push_back(std::move(node));
    model_.meshes.push_back(std::move(made));
  }

  const tinygltf::Model& model() const { return model_; }
  size_t bytes() const { return model_.buffers[0].data.size(); }

 private:
  tinygltf::Primitive PrimitiveOf(const Surface& surface, const MaterialKey& key) {
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.material = MaterialOf(key);
    primitive.attributes["POSITION"] = AddVectors(surface, &Corner::position, true);
    primitive.attributes["NORMAL"] = AddVectors(surface, &Corner::normal, false);
    const int view = AddView(surface.indices.data(), surface.indices.size() * sizeof(uint32_t),
                             TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    primitive.indices = AddAccessor(view, surface.indices.size(), TINYGLTF_TYPE_SCALAR,
                                    TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT);
    return primitive;
  }

  int AddVectors(const Surface& surface, Float3 Corner::*member, bool with_bounds) {
    std::vector<Float3> values;
    values.reserve(surface.corners.size());
    for (const Corner& corner : surface.corners) values.push_back(corner.*member);
    const int view =
        AddView(values.data(), values.size() * sizeof(Float3), TINYGLTF_TARGET_ARRAY_BUFFER);
    const int index =
        AddAccessor(view, values.size(), TINYGLTF_TYPE_VEC3, TINYGLTF_COMPONENT_TYPE_FLOAT);
    if (with_bounds) SetBounds(values, &model_.accessors.back());
    return index;
  }

  static void SetBounds(const std::vector<Float3>& values, tinygltf::Accessor* accessor) {
    Float3 low = values[0], high = values[0];
    for (const Float3& value : values) {
      for (int i = 0; i < 3; ++i) {
        low[i] = std::min(low[i], value[i]);
        high[i] = std::max(high[i], value[i]);
      }
    }
    accessor->minValues.assign(low.begin(), low.end());
    accessor->maxValues.assign(high.begin(), high.end());
  }

  int AddView(const void* data, size_t size, int target) {
    std::vector<unsigned char>& bytes = model_.buffers[0].data;
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = bytes.size();  // of floats and uint32s only, so always a multiple of 4
    view.byteLength = size;
    view.target = target;
    bytes.resize(bytes.size() + size);
    std::memcpy(bytes.data() + view.byteOffset, data, size);
    model_.bufferViews.push_back(view);
    return static_cast<int>(model_.bufferViews.size()) - 1;
  }

  int AddAccessor(int view, size_t count, int type, int component) {
    tinygltf::Accessor accessor;
    accessor.bufferView = view;
    accessor.byteOffset = 0;
    accessor.componentType = component;
    accessor.count = count;
    accessor.type = type;
    model_.accessors.push_back(std::move(accessor));
    return static_cast<int>(model_.accessors.size()) - 1;
  }

  int MaterialOf(const MaterialKey& key) {
    const auto [it, is_new] = materials_.emplace(key, static_cast<int>(model_.materials.size()));
    if (!is_new) return it->second;
    constexpr uint32_t kPaperWhite = 0xEDEBE6;  // what pictures give shapes without a colour
    const uint32_t rgb = key.first ? key.first : kPaperWhite;
    tinygltf::Material material;
    material.name = fmt::format("{}{}", key.first ? fmt::format("color_{:06X}", rgb) : "plain",
                                key.second ? "_two_sided" : "");
    material.doubleSided = key.second;
    auto& surface = material.pbrMetallicRoughness;
    surface.baseColorFactor = {LinearFromSrgb(rgb >> 16 & 255), LinearFromSrgb(rgb >> 8 & 255),
                               LinearFromSrgb(rgb & 255), 1};
    surface.metallicFactor = 0;
    surface.roughnessFactor = 0.9;
    model_.materials.push_back(std::move(material));
    return it->second;
  }

  tinygltf::Model model_;
  std::map<MaterialKey, int> materials_;
};

}  // namespace

Result<std::string> GltfBytes(const ModelMesh& mesh, GltfForm form) {
  constexpr size_t kMostBytes = 0xf0000000;  // 32-bit lengths, with room for the JSON
  GltfMaker maker;
  for (const SymbolGroup& group : GroupBySymbol(mesh)) {
    maker.Add(group, mesh);
    if (maker.bytes() > kMostBytes) {
      return Fail(ErrorCode::kLimitReached, "the model is too large for glTF (4 GB)",
                  "export fewer lots at a time");
    }
  }
  if (maker.model().meshes.empty()) {
    return Fail(ErrorCode::kNothingMade, "there is nothing to export",
                "the model has no visible shape with an area");
  }
  std::ostringstream out;
  const bool binary = form == GltfForm::kBinary;
  if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&maker.model(), out, !binary, binary)) {
    return Fail(ErrorCode::kFile, "the glTF writer failed");
  }
  return std::move(out).str();
}

Result<void> ExportGltf(const ModelMesh& mesh, GltfForm form, const std::string& path) {
  const Result<std::string> bytes = GltfBytes(mesh, form);
  if (bytes) return WriteFile(path, *bytes);
  Error error = bytes.error();
  error.message = path + ": " + error.message;
  return tl::unexpected(error);
}

}  // namespace parti::app
