#include "app/export_glb.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <cmath>
#include <cstring>
#include <map>
#include <sstream>
#include <tuple>
#include <utility>

#include "base/text_file.h"

namespace parti::app {
namespace {

using Float3 = std::array<float, 3>;

using Float2 = std::array<float, 2>;

/// A corner of one face: where it lies, where its face looks, and where it is in the image. Corners
/// that agree are shared.
struct Corner {
  Float3 position, normal;
  Float2 uv;
  auto operator<=>(const Corner&) const = default;
};

/// What becomes one primitive: all triangles of a symbol with one material.
struct Surface {
  std::vector<Corner> corners;
  std::vector<uint32_t> indices;
};

/// What tells materials apart: colour, whether both sides are seen, whether there are texture
/// coordinates, and what a material says besides.
using MaterialKey = std::tuple<uint32_t, bool, bool, size_t>;

Float3 Floats(const Vec3& v) {
  // + 0 turns -0 into 0, so that equal corners have equal bytes.
  return {static_cast<float>(v.x) + 0.0f, static_cast<float>(v.y) + 0.0f,
          static_cast<float>(v.z) + 0.0f};
}

void AddTo(const ModelPart& part, Surface* surface) {
  const WeldedPart welded = Weld(part.corners);
  std::map<Corner, uint32_t> shared;  // within a shape only: shapes stay apart
  for (size_t i = 0; i < welded.triangles.size(); ++i) {
    Corner corner{Floats(welded.points[welded.triangles[i]]), Floats(welded.normals[i / 3]), {}};
    if (!part.uvs.empty()) {
      const Vec2 uv = part.uvs[welded.sources[i / 3] * 3 + i % 3];
      corner.uv = {static_cast<float>(uv.x), static_cast<float>(1 - uv.y)};  // from the top down
    }
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
      AddTo(part, &surfaces[KeyOf(part)]);
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
  /// Materials in the order in which they come, so that files do not depend on where they lay.
  MaterialKey KeyOf(const ModelPart& part) {
    size_t number = 0;
    if (part.material) {
      number = numbers_.emplace(part.material, numbers_.size() + 1).first->second;
      if (number > given_.size()) given_.push_back(part.material);
    }
    return {part.color_rgb, !part.closed, !part.uvs.empty(), number};
  }

  tinygltf::Primitive PrimitiveOf(const Surface& surface, const MaterialKey& key) {
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.material = MaterialOf(key);
    primitive.attributes["POSITION"] = AddVectors(surface, &Corner::position, true);
    primitive.attributes["NORMAL"] = AddVectors(surface, &Corner::normal, false);
    if (std::get<2>(key)) primitive.attributes["TEXCOORD_0"] = AddTextureCoordinates(surface);
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

  int AddTextureCoordinates(const Surface& surface) {
    std::vector<Float2> values;
    values.reserve(surface.corners.size());
    for (const Corner& corner : surface.corners) values.push_back(corner.uv);
    const int view =
        AddView(values.data(), values.size() * sizeof(Float2), TINYGLTF_TARGET_ARRAY_BUFFER);
    return AddAccessor(view, values.size(), TINYGLTF_TYPE_VEC2, TINYGLTF_COMPONENT_TYPE_FLOAT);
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
    const auto [color, two_sided, textured, number] = key;
    const grammar::Material* given = number > 0 ? given_[number - 1].get() : nullptr;
    constexpr uint32_t kPaperWhite = 0xEDEBE6;  // what pictures give shapes without a colour
    const bool has_image = textured && given && given->image;
    const uint32_t rgb = color ? color : has_image ? 0xFFFFFF : kPaperWhite;
    const std::string plain = color ? fmt::format("color_{:06X}", rgb) : "plain";
    tinygltf::Material material;
    material.name = fmt::format("{}{}", given && !given->name.empty() ? given->name : plain,
                                two_sided ? "_two_sided" : "");
    material.doubleSided = two_sided;
    auto& surface = material.pbrMetallicRoughness;
    const double opacity = given ? given->opacity : 1;
    surface.baseColorFactor = {LinearFromSrgb(rgb >> 16 & 255), LinearFromSrgb(rgb >> 8 & 255),
                               LinearFromSrgb(rgb & 255), opacity};
    if (opacity < 1) material.alphaMode = "BLEND";
    surface.metallicFactor = given ? given->metallic : 0;
    surface.roughnessFactor = given ? given->roughness : 0.9;
    if (has_image) surface.baseColorTexture.index = TextureOf(given->image);
    model_.materials.push_back(std::move(material));
    return it->second;
  }

  /// The image's bytes lie in the buffer, so that the file stands alone.
  int TextureOf(const std::shared_ptr<const grammar::Image>& image) {
    const auto [it, is_new] = textures_.emplace(image, static_cast<int>(model_.textures.size()));
    if (!is_new) return it->second;
    std::vector<unsigned char>& bytes = model_.buffers[0].data;
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = bytes.size();
    view.byteLength = image->bytes.size();
    bytes.insert(bytes.end(), image->bytes.begin(), image->bytes.end());
    bytes.resize((bytes.size() + 3) / 4 * 4);
    model_.bufferViews.push_back(std::move(view));
    tinygltf::Image made;
    made.name = image->name;
    made.mimeType = image->bytes.starts_with("\x89PNG") ? "image/png" : "image/jpeg";
    made.bufferView = static_cast<int>(model_.bufferViews.size()) - 1;
    model_.images.push_back(std::move(made));
    tinygltf::Texture texture;
    texture.source = static_cast<int>(model_.images.size()) - 1;
    model_.textures.push_back(std::move(texture));
    return it->second;
  }

  tinygltf::Model model_;
  std::map<MaterialKey, int> materials_;
  std::map<std::shared_ptr<const grammar::Material>, size_t> numbers_;
  std::vector<std::shared_ptr<const grammar::Material>> given_;  ///< by number, from 1
  std::map<std::shared_ptr<const grammar::Image>, int> textures_;
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
