// glTF 2.0: the triangles, base colours and first texture coordinates of its default scene.
// tinygltf reads the structure and the buffers; every index of them is checked here.
#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <utility>

#include "grammar/asset_mesh.h"

namespace parti::grammar {
namespace {

constexpr int kDeepestNode = 64;

tl::unexpected<Error> Damaged(std::string_view what) {
  return Fail(ErrorCode::kDamagedFile, std::string(what), "export the model anew");
}

template <typename T>
const T* Find(const std::vector<T>& list, int index) {
  const bool inside = index >= 0 && static_cast<size_t>(index) < list.size();
  return inside ? &list[static_cast<size_t>(index)] : nullptr;
}

/// The numbers of an accessor, one row an element.
class Numbers {
 public:
  static Result<Numbers> From(const tinygltf::Model& model, int index, int components) {
    const auto* accessor = Find(model.accessors, index);
    if (accessor == nullptr) return Damaged("an accessor that isn't there");
    if (accessor->sparse.isSparse || accessor->bufferView < 0) {
      return Damaged("a sparse accessor, which is not read");
    }
    const auto* view = Find(model.bufferViews, accessor->bufferView);
    const auto* buffer = view ? Find(model.buffers, view->buffer) : nullptr;
    const int width = tinygltf::GetComponentSizeInBytes(
        static_cast<uint32_t>(std::max(0, accessor->componentType)));
    const int count =
        tinygltf::GetNumComponentsInType(static_cast<uint32_t>(std::max(0, accessor->type)));
    if (buffer == nullptr || width <= 0 || count != components) {
      return Damaged("an accessor of a kind that its use does not allow");
    }
    Numbers numbers;
    numbers.count_ = accessor->count;
    numbers.type_ = accessor->componentType;
    numbers.normalized_ = accessor->normalized;
    numbers.width_ = static_cast<size_t>(width);
    const size_t element = numbers.width_ * static_cast<size_t>(components);
    numbers.stride_ = view->byteStride > 0 ? view->byteStride : element;
    const size_t length = buffer->data.size();
    const bool starts = view->byteOffset <= length && accessor->byteOffset <= length &&
                        view->byteOffset + accessor->byteOffset <= length;
    const size_t room = starts ? length - view->byteOffset - accessor->byteOffset : 0;
    const bool fits =
        numbers.count_ == 0 ||
        (room >= element && (numbers.count_ - 1) <= (room - element) / numbers.stride_);
    if (!starts || !fits) return Damaged("an accessor that reaches beyond its buffer");
    numbers.data_ = buffer->data.data() + view->byteOffset + accessor->byteOffset;
    return numbers;
  }

  size_t count() const { return count_; }

  double At(size_t element, size_t component) const {
    const unsigned char* at = data_ + element * stride_ + component * width_;
    switch (type_) {
      case TINYGLTF_COMPONENT_TYPE_FLOAT:
        return Value<float>(at);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
        return Value<uint8_t>(at) / (normalized_ ? 255.0 : 1.0);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
        return Value<uint16_t>(at) / (normalized_ ? 65535.0 : 1.0);
      case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
        return Value<uint32_t>(at);
      case TINYGLTF_COMPONENT_TYPE_BYTE:
        return Value<int8_t>(at) / (normalized_ ? 127.0 : 1.0);
      case TINYGLTF_COMPONENT_TYPE_SHORT:
        return Value<int16_t>(at) / (normalized_ ? 32767.0 : 1.0);
      default:
        return 0;
    }
  }

 private:
  template <typename T>
  static double Value(const unsigned char* at) {
    T value;
    std::memcpy(&value, at, sizeof value);
    return value;
  }

  const unsigned char* data_ = nullptr;
  size_t count_ = 0, stride_ = 0, width_ = 0;
  int type_ = 0;
  bool normalized_ = false;
};

/// What tinygltf asks for while it reads.
struct Reading {
  const FileReader& files;
  std::optional<Error> missing;  ///< the first file that could not be read

  static bool ReadFile(std::vector<unsigned char>* out, std::string*, const std::string& name,
                       void* self) {
    auto& reading = *static_cast<Reading*>(self);
    const auto bytes = reading.files(name);
    if (!bytes && !reading.missing) reading.missing = bytes.error();
    if (bytes) out->assign(bytes->begin(), bytes->end());
    return bytes.has_value();
  }
  static bool KeepImage(tinygltf::Image* image, int, std::string*, std::string*, int, int,
                        const unsigned char* bytes, int size, void*) {
    image->image.assign(bytes, bytes + std::max(0, size));
    return true;
  }
};

Result<tinygltf::Model> ModelFrom(std::string_view bytes, std::string_view name, Reading* reading) {
  tinygltf::TinyGLTF loader;
  tinygltf::FsCallbacks files{};
  files.FileExists = [](const std::string&, void*) { return true; };
  files.ExpandFilePath = [](const std::string& path, void*) { return path; };
  files.ReadWholeFile = Reading::ReadFile;
  files.user_data = reading;
  loader.SetFsCallbacks(files);
  loader.SetImageLoader(Reading::KeepImage, nullptr);
  tinygltf::Model model;
  std::string error, warning;
  const auto size = static_cast<unsigned>(bytes.size());
  bool good = false;
  try {
    good = bytes.starts_with("glTF")
               ? loader.LoadBinaryFromMemory(&model, &error, &warning,
                                             reinterpret_cast<const unsigned char*>(bytes.data()),
                                             size)
               : loader.LoadASCIIFromString(&model, &error, &warning, bytes.data(), size, "");
  } catch (const std::exception& thrown) {
    error = thrown.what();
  }
  if (reading->missing) return tl::unexpected<Error>(*reading->missing);
  if (good) return model;
  std::replace(error.begin(), error.end(), '\n', ' ');
  return Damaged(fmt::format("{} is no glTF that can be read: {}", name, error));
}

/// sRGB bytes of a linear colour.
uint32_t Srgb(const std::vector<double>& linear) {
  uint32_t packed = 0;
  for (size_t i = 0; i < 3; ++i) {
    const double c = i < linear.size() ? glm::clamp(linear[i], 0.0, 1.0) : 1.0;
    const double s = c <= 0.0031308 ? c * 12.92 : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
    packed = packed << 8 | static_cast<uint32_t>(std::lround(s * 255));
  }
  return std::max(packed, 1u);
}

class GltfReader {
 public:
  GltfReader(const tinygltf::Model& model, std::string_view name) : model_(model), name_(name) {}

  Result<Asset> Read() {
    if (auto good = ReadMaterials(); !good) return Fail(good);
    const auto* scene = Find(model_.scenes, std::max(0, model_.defaultScene));
    if (scene == nullptr) return Damaged(fmt::format("{} has no scene", name_));
    for (const int node : scene->nodes) {
      if (auto good = AddNode(node, Mat4(1), 0); !good) return Fail(good);
    }
    return mesh_.Finish(name_);
  }

 private:
  Result<void> ReadMaterials() {
    for (const tinygltf::Material& given : model_.materials) {
      const auto& surface = given.pbrMetallicRoughness;
      Material material;
      material.name = given.name;
      material.color_rgb = Srgb(surface.baseColorFactor);
      if (surface.baseColorFactor.size() > 3) {
        material.opacity = glm::clamp(surface.baseColorFactor[3], 0.0, 1.0);
      }
      material.metallic = glm::clamp(surface.metallicFactor, 0.0, 1.0);
      material.roughness = glm::clamp(surface.roughnessFactor, 0.0, 1.0);
      if (const auto* texture = Find(model_.textures, surface.baseColorTexture.index)) {
        auto image = ImageOf(*texture);
        if (!image) return Fail(image);
        material.image = std::move(*image);
      }
      materials_.push_back(std::make_shared<const Material>(std::move(material)));
    }
    return {};
  }

  Result<std::shared_ptr<const Image>> ImageOf(const tinygltf::Texture& texture) const {
    const auto* source = Find(model_.images, texture.source);
    if (source == nullptr) return Damaged(fmt::format("{}: a texture without an image", name_));
    const std::string_view bytes(reinterpret_cast<const char*>(source->image.data()),
                                 source->image.size());
    std::string name = source->uri.empty() ? source->name : source->uri;
    if (name.empty()) name = fmt::format("image{}", texture.source);
    auto image = ImageFrom(bytes, name);
    if (!image) return Fail(image);
    return std::make_shared<const Image>(std::move(*image));
  }

  static Mat4 TransformOf(const tinygltf::Node& node) {
    if (node.matrix.size() == 16) return glm::make_mat4(node.matrix.data());
    Mat4 transform(1);
    if (node.translation.size() == 3) {
      transform[3] = Vec4(node.translation[0], node.translation[1], node.translation[2], 1);
    }
    if (node.rotation.size() == 4) {
      const glm::dquat turn(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
      transform = transform * glm::mat4_cast(glm::normalize(turn));
    }
    for (int i = 0; i < 3 && node.scale.size() == 3; ++i) {
      transform[i] *= node.scale[static_cast<size_t>(i)];
    }
    return transform;
  }

  Result<void> AddNode(int index, const Mat4& parent, int depth) {
    const auto* node = Find(model_.nodes, index);
    if (node == nullptr) return Damaged(fmt::format("{}: a node that isn't there", name_));
    if (depth > kDeepestNode || ++nodes_ > kMostAssetFaces) {
      return Damaged(fmt::format("{}: nodes in nodes without end", name_));
    }
    const Mat4 transform = parent * TransformOf(*node);
    if (const auto* mesh = Find(model_.meshes, node->mesh)) {
      for (const auto& primitive : mesh->primitives) {
        if (auto good = AddPrimitive(primitive, transform); !good) return good;
      }
    }
    for (const int child : node->children) {
      if (auto good = AddNode(child, transform, depth + 1); !good) return good;
    }
    return {};
  }

  Result<void> AddPrimitive(const tinygltf::Primitive& primitive, const Mat4& transform) {
    const bool triangles = primitive.mode == TINYGLTF_MODE_TRIANGLES || primitive.mode == -1;
    const auto position = primitive.attributes.find("POSITION");
    if (!triangles || position == primitive.attributes.end()) return {};  // points, lines, strips
    const auto points = Numbers::From(model_, position->second, 3);
    if (!points) return Fail(points);
    std::optional<Numbers> uvs, indices;
    const auto uv = primitive.attributes.find("TEXCOORD_0");
    if (uv != primitive.attributes.end()) {
      const auto read = Numbers::From(model_, uv->second, 2);
      if (!read) return Fail(read);
      uvs = *read;
    }
    if (primitive.indices >= 0) {
      const auto read = Numbers::From(model_, primitive.indices, 1);
      if (!read) return Fail(read);
      indices = *read;
    }
    return AddTriangles(*points, uvs, indices, primitive.material, transform);
  }

  Result<void> AddTriangles(const Numbers& points, const std::optional<Numbers>& uvs,
                            const std::optional<Numbers>& indices, int material,
                            const Mat4& transform) {
    const size_t count = indices ? indices->count() : points.count();
    const bool inside_out = glm::determinant(glm::dmat3(transform)) < 0;
    const auto* worn = Find(materials_, material);
    for (size_t i = 0; i + 2 < count; i += 3) {
      std::vector<AssetMesh::Corner> face(3);
      for (size_t k = 0; k < 3; ++k) {
        const size_t at = indices ? static_cast<size_t>(indices->At(i + k, 0)) : i + k;
        if (at >= points.count() || (uvs && at >= uvs->count())) {
          return Damaged(fmt::format("{}: a triangle's corner that isn't there", name_));
        }
        const Vec4 p(points.At(at, 0), points.At(at, 1), points.At(at, 2), 1);
        face[k].point = Vec3(transform * p);
        // Images lie with their upper edge at v = 0 in glTF.
        if (uvs) face[k].uv = Vec2(uvs->At(at, 0), 1 - uvs->At(at, 1));
      }
      if (inside_out) std::swap(face[1], face[2]);
      mesh_.Add(face, worn ? *worn : nullptr, uvs.has_value());
    }
    if (mesh_.faces() <= kMostAssetFaces) return {};
    return Fail(ErrorCode::kLimitReached,
                fmt::format("{} has more than {} faces", name_, kMostAssetFaces),
                "reduce the model before it is inserted");
  }

  const tinygltf::Model& model_;
  std::string_view name_;
  std::vector<std::shared_ptr<const Material>> materials_;
  size_t nodes_ = 0;
  AssetMesh mesh_;
};

}  // namespace

Result<Asset> AssetFromGltf(std::string_view bytes, std::string_view name,
                            const FileReader& files) {
  Reading reading{files, std::nullopt};
  const auto model = ModelFrom(bytes, name, &reading);
  if (!model) return Fail(model);
  return GltfReader(*model, name).Read();
}

}  // namespace parti::grammar
