#include "app/export_glb.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <utility>

#include "app/byte_blocks.h"
#include "app/index_table.h"
#include "app/weld.h"
#include "base/text_file.h"

namespace parti::app {
namespace {

using Float3 = std::array<float, 3>;

using Float2 = std::array<float, 2>;

/// What tells surfaces apart within a symbol: colour, whether both sides are seen, whether there
/// are texture coordinates, and what a material says besides.
struct Look {
  uint32_t color_rgb = 0;
  bool two_sided = false, textured = false;
  std::shared_ptr<const grammar::Material> material;
  bool operator==(const Look&) const = default;
};

/// The same with materials by number, so that the order of surfaces does not depend on where
/// materials lie in memory.
using MaterialKey = std::tuple<uint32_t, bool, bool, size_t>;

/// A corner of one face: where it lies, where its face looks, and where it is in the image. Corners
/// that agree are shared, within a shape only: shapes stay apart.
struct Corner {
  Float3 position, normal;
  Float2 uv;
  bool operator==(const Corner&) const = default;
};

/// What becomes one primitive: all triangles of a symbol with one look.
struct Surface {
  Look look;
  size_t corners = 0, indices = 0;
  Float3 low{}, high{};  ///< of the positions
  ByteBlocks position_bytes, normal_bytes, uv_bytes, index_bytes;
};

/// Every triangle with three corners of its own, each with all that it can have.
constexpr size_t kMostTriangleBytes = 3 * (sizeof(uint32_t) + sizeof(Float3) * 2 + sizeof(Float2));

Float3 Floats(const Vec3& v) {
  // + 0 turns -0 into 0, so that equal corners have equal bytes.
  return {static_cast<float>(v.x) + 0.0f, static_cast<float>(v.y) + 0.0f,
          static_cast<float>(v.z) + 0.0f};
}

uint64_t HashOf(const Corner& corner) {
  uint64_t hash = 0;
  const auto mix = [&hash](float a, float b) {
    const uint64_t low = std::bit_cast<uint32_t>(a), high = std::bit_cast<uint32_t>(b);
    hash = IndexTable::Mixed(hash, low | high << 32);
  };
  mix(corner.position[0], corner.position[1]);
  mix(corner.position[2], corner.normal[0]);
  mix(corner.normal[1], corner.normal[2]);
  mix(corner.uv[0] + 0.0f, corner.uv[1] + 0.0f);  // -0 equals 0
  return hash;
}

/// One shape's corners, each once. Keeps its memory for the next shape.
class CornerSharer {
 public:
  /// What it leaves in positions, …, indices stays until the next call.
  void Share(const ModelPart& part, size_t first_number) {
    const WeldedPart& welded = welder_.Weld(part.corners);
    corners.clear();
    indices.clear();
    table_.Reset(welded.triangles.size() / 2);
    for (size_t i = 0; i < welded.triangles.size(); ++i) {
      Corner corner{Floats(welded.points[welded.triangles[i]]), Floats(welded.normals[i / 3]), {}};
      if (!part.uvs.empty()) {
        const Vec2 uv = part.uvs[welded.sources[i / 3] * 3 + i % 3];
        corner.uv = {static_cast<float>(uv.x), static_cast<float>(1 - uv.y)};  // from the top down
      }
      indices.push_back(static_cast<uint32_t>(first_number + NumberOf(corner)));
    }
  }

  std::vector<Corner> corners;
  std::vector<uint32_t> indices;  ///< with those of earlier shapes counted in

 private:
  uint32_t NumberOf(const Corner& corner) {
    const uint64_t hash = HashOf(corner);
    for (uint32_t i = table_.First(hash); i != IndexTable::kNone; i = table_.Next(i)) {
      if (corners[i] == corner) return i;
    }
    corners.push_back(corner);
    table_.Add(hash);
    return static_cast<uint32_t>(corners.size() - 1);
  }

  Welder welder_;
  IndexTable table_;  ///< of corners
};

struct LookHash {
  size_t operator()(const Look& look) const {
    const auto material = reinterpret_cast<uintptr_t>(look.material.get());
    const uint64_t rest = uint64_t{look.color_rgb} << 2 | look.two_sided << 1 | look.textured;
    return IndexTable::Mixed(IndexTable::Mixed(0, material), rest);
  }
};

/// The surfaces of a symbol, in the order of their first parts.
struct Group {
  std::string name;
  std::vector<Surface> surfaces;
  std::unordered_map<Look, size_t, LookHash> numbers;  ///< of surfaces
};

/// Sorts parts into symbols and surfaces, in the order in which they come.
class SurfaceGatherer {
 public:
  /// `keeps`: else bytes are only counted.
  SurfaceGatherer(size_t most_bytes, bool keeps) : most_bytes_(most_bytes), keeps_(keeps) {}

  /// False: more than fits.
  bool Add(const ModelPart& part) {
    Surface& surface = SurfaceFor(part);
    sharer_.Share(part, surface.corners);
    const size_t corners = sharer_.corners.size(), indices = sharer_.indices.size();
    bytes_ += indices * sizeof(uint32_t) +
              corners * (2 * sizeof(Float3) + (surface.look.textured ? sizeof(Float2) : 0));
    if (bytes_ > most_bytes_) return false;
    if (keeps_) Keep(&surface);
    surface.corners += corners;
    surface.indices += indices;
    return true;
  }

  std::vector<Group> groups;

 private:
  Surface& SurfaceFor(const ModelPart& part) {
    const auto [it, is_new] = numbers_.emplace(GroupNameOf(part.symbol), groups.size());
    if (is_new) groups.emplace_back().name = it->first;
    Group& group = groups[it->second];
    const Look look{part.color_rgb, !part.closed, !part.uvs.empty(), part.material};
    const auto [found, is_new_look] = group.numbers.emplace(look, group.surfaces.size());
    if (is_new_look) group.surfaces.emplace_back().look = look;
    return group.surfaces[found->second];
  }

  void Keep(Surface* surface) {
    if (surface->corners == 0 && !sharer_.corners.empty()) {
      surface->low = surface->high = sharer_.corners[0].position;
    }
    KeepOne(&Corner::position, &surface->position_bytes);
    KeepOne(&Corner::normal, &surface->normal_bytes);
    if (surface->look.textured) KeepOne(&Corner::uv, &surface->uv_bytes);
    surface->index_bytes.Append(sharer_.indices.data(), sharer_.indices.size() * sizeof(uint32_t));
    for (const Corner& corner : sharer_.corners) {
      for (size_t i = 0; i < 3; ++i) {
        surface->low[i] = std::min(surface->low[i], corner.position[i]);
        surface->high[i] = std::max(surface->high[i], corner.position[i]);
      }
    }
  }

  template <typename Value>
  void KeepOne(Value Corner::*member, ByteBlocks* bytes) {
    std::vector<float>& values = values_;
    values.clear();
    for (const Corner& corner : sharer_.corners) {
      values.insert(values.end(), (corner.*member).begin(), (corner.*member).end());
    }
    bytes->Append(values.data(), values.size() * sizeof(float));
  }

  size_t most_bytes_, bytes_ = 0;
  bool keeps_;
  CornerSharer sharer_;
  std::vector<float> values_;
  std::unordered_map<std::string, size_t> numbers_;  ///< of groups, by name
};

tl::unexpected<Error> TooLarge() {
  return Fail(ErrorCode::kLimitReached, "the model is too large for glTF (4 GB)",
              "export fewer lots at a time, or shapes with fewer faces");
}

double LinearFromSrgb(uint32_t byte) {
  const double c = byte / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

/// Fills a tinygltf::Model, and beside it the one buffer in which everything lies.
class GltfMaker {
 public:
  GltfMaker() {
    model_.asset.version = "2.0";
    model_.asset.generator = "Parti";
    model_.scenes.emplace_back();
    model_.defaultScene = 0;
  }

  /// Takes the surfaces' bytes.
  void Add(Group* group) {
    std::map<MaterialKey, Surface*> surfaces;
    for (Surface& surface : group->surfaces) surfaces.emplace(KeyOf(surface.look), &surface);
    tinygltf::Mesh made;
    made.name = group->name;
    for (const auto& [key, surface] : surfaces) {
      if (surface->indices > 0) made.primitives.push_back(PrimitiveOf(surface, key));
    }
    if (made.primitives.empty()) return;
    tinygltf::Node node;
    node.name = group->name;
    node.mesh = static_cast<int>(model_.meshes.size());
    model_.scenes[0].nodes.push_back(static_cast<int>(model_.nodes.size()));
    model_.nodes.push_back(std::move(node));
    model_.meshes.push_back(std::move(made));
  }

  tinygltf::Model& model() { return model_; }
  ByteBlocks& bytes() { return bytes_; }

 private:
  /// Materials in the order in which they come, so that files do not depend on where they lay.
  MaterialKey KeyOf(const Look& look) {
    size_t number = 0;
    if (look.material) {
      number = numbers_.emplace(look.material, numbers_.size() + 1).first->second;
      if (number > given_.size()) given_.push_back(look.material);
    }
    return {look.color_rgb, look.two_sided, look.textured, number};
  }

  tinygltf::Primitive PrimitiveOf(Surface* surface, const MaterialKey& key) {
    tinygltf::Primitive primitive;
    primitive.mode = TINYGLTF_MODE_TRIANGLES;
    primitive.material = MaterialOf(key);
    const size_t corners = surface->corners;
    primitive.attributes["POSITION"] =
        AddFloats(std::move(surface->position_bytes), corners, TINYGLTF_TYPE_VEC3);
    tinygltf::Accessor& positions = model_.accessors.back();
    positions.minValues.assign(surface->low.begin(), surface->low.end());
    positions.maxValues.assign(surface->high.begin(), surface->high.end());
    primitive.attributes["NORMAL"] =
        AddFloats(std::move(surface->normal_bytes), corners, TINYGLTF_TYPE_VEC3);
    if (surface->look.textured) {
      primitive.attributes["TEXCOORD_0"] =
          AddFloats(std::move(surface->uv_bytes), corners, TINYGLTF_TYPE_VEC2);
    }
    const int view = AddView(std::move(surface->index_bytes), TINYGLTF_TARGET_ELEMENT_ARRAY_BUFFER);
    primitive.indices = AddAccessor(view, surface->indices, TINYGLTF_TYPE_SCALAR,
                                    TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT);
    return primitive;
  }

  int AddFloats(ByteBlocks bytes, size_t count, int type) {
    const int view = AddView(std::move(bytes), TINYGLTF_TARGET_ARRAY_BUFFER);
    return AddAccessor(view, count, type, TINYGLTF_COMPONENT_TYPE_FLOAT);
  }

  int AddView(ByteBlocks bytes, int target) {
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = bytes_.size();  // of floats and uint32s only, so always a multiple of 4
    view.byteLength = bytes.size();
    view.target = target;
    bytes_.Append(std::move(bytes));
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
    tinygltf::BufferView view;
    view.buffer = 0;
    view.byteOffset = bytes_.size();
    view.byteLength = image->bytes.size();
    bytes_.Append(image->bytes.data(), image->bytes.size());
    constexpr std::array<char, 3> kPadding{};
    bytes_.Append(kPadding.data(), (4 - bytes_.size() % 4) % 4);
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
  ByteBlocks bytes_;
  std::map<MaterialKey, int> materials_;
  std::map<std::shared_ptr<const grammar::Material>, size_t> numbers_;
  std::vector<std::shared_ptr<const grammar::Material>> given_;  ///< by number, from 1
  std::map<std::shared_ptr<const grammar::Image>, int> textures_;
};

Result<std::string> JsonOf(const tinygltf::Model& model, bool pretty) {
  std::ostringstream out;
  if (!tinygltf::TinyGLTF().WriteGltfSceneToStream(&model, out, pretty, false)) {
    return Fail(ErrorCode::kFile, "the glTF writer failed");
  }
  return std::move(out).str();
}

void AppendWord(uint32_t word, std::string* text) {
  for (int shift = 0; shift < 32; shift += 8) *text += static_cast<char>(word >> shift & 255);
}

/// tinygltf would hold the buffer three times. It writes the JSON; what that says of the buffer and
/// the frame around both (glTF 2.0, 4.4) are put in here.
Result<std::string> BinaryOf(const tinygltf::Model& model, ByteBlocks* buffer) {
  const Result<std::string> written = JsonOf(model, false);
  if (!written) return written;
  nlohmann::json whole = nlohmann::json::parse(*written);
  whole["buffers"] = nlohmann::json::array({{{"byteLength", buffer->size()}}});
  std::string json = whole.dump();
  json.resize((json.size() + 3) / 4 * 4, ' ');
  constexpr size_t kHeader = 12, kChunkHeader = 8;
  const size_t size = kHeader + kChunkHeader + json.size() + kChunkHeader + buffer->size();
  if (size > std::numeric_limits<uint32_t>::max()) return TooLarge();
  std::string bytes;
  bytes.reserve(size);
  bytes += "glTF";
  AppendWord(2, &bytes);
  AppendWord(static_cast<uint32_t>(size), &bytes);
  AppendWord(static_cast<uint32_t>(json.size()), &bytes);
  bytes += "JSON";
  bytes += json;
  AppendWord(static_cast<uint32_t>(buffer->size()), &bytes);
  bytes += std::string_view("BIN\0", 4);
  buffer->MoveTo(&bytes);
  return bytes;
}

Result<std::string> TextOf(tinygltf::Model* model, ByteBlocks* buffer) {
  std::string bytes;
  bytes.reserve(buffer->size());
  buffer->MoveTo(&bytes);
  model->buffers.emplace_back().data.assign(bytes.begin(), bytes.end());
  bytes = std::string();
  return JsonOf(*model, true);
}

/// True where all parts have been taken.
bool Gather(const ModelParts& parts, SurfaceGatherer* gatherer) {
  bool fits = true;
  parts.visit([&](const ModelPart& part) { return fits = gatherer->Add(part); });
  return fits;
}

}  // namespace

Result<std::string> GltfBytes(const ModelParts& parts, GltfForm form, size_t most_bytes) {
  if (parts.most_triangles > most_bytes / kMostTriangleBytes) {
    SurfaceGatherer counter(most_bytes, false);
    if (!Gather(parts, &counter)) return TooLarge();
  }
  SurfaceGatherer gatherer(most_bytes, true);
  if (!Gather(parts, &gatherer)) return TooLarge();
  GltfMaker maker;
  for (Group& group : gatherer.groups) {
    maker.Add(&group);
    if (maker.bytes().size() > most_bytes) return TooLarge();  // with the images
  }
  if (maker.model().meshes.empty()) {
    return Fail(ErrorCode::kNothingMade, "there is nothing to export",
                "the model has no visible shape with an area");
  }
  return form == GltfForm::kBinary ? BinaryOf(maker.model(), &maker.bytes())
                                   : TextOf(&maker.model(), &maker.bytes());
}

Result<std::string> GltfBytes(const ModelMesh& mesh, GltfForm form, size_t most_bytes) {
  return GltfBytes(PartsOf(mesh), form, most_bytes);
}

Result<void> ExportGltf(const ModelParts& parts, GltfForm form, const std::string& path,
                        size_t most_bytes) {
  const Result<std::string> bytes = GltfBytes(parts, form, most_bytes);
  if (bytes) return WriteFile(path, *bytes);
  Error error = bytes.error();
  error.message = path + ": " + error.message;
  return tl::unexpected(error);
}

}  // namespace parti::app
