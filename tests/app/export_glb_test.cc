// glTF read back by tinygltf, and held against the MUSTs of the glTF 2.0 specification.
#include "app/export_glb.h"

#include <gtest/gtest.h>
#include <tiny_gltf.h>

#include <array>
#include <cstring>
#include <filesystem>
#include <limits>
#include <set>

#include "base/text_file.h"
#include "grammar/asset.h"
#include "tests/app/sample_models.h"

namespace parti::app {
namespace {

uint32_t WordAt(const std::string& bytes, size_t offset) {
  uint32_t word = 0;
  std::memcpy(&word, bytes.data() + offset, 4);
  return word;
}

tinygltf::Model Load(const std::string& bytes) {
  tinygltf::Model model;
  std::string error, warning;
  const bool loaded = tinygltf::TinyGLTF().LoadBinaryFromMemory(
      &model, &error, &warning, reinterpret_cast<const unsigned char*>(bytes.data()),
      static_cast<unsigned>(bytes.size()));
  EXPECT_TRUE(loaded) << error;
  EXPECT_EQ(error + warning, "");
  return model;
}

template <typename T>
std::vector<T> Read(const tinygltf::Model& model, int accessor_index) {
  const auto& accessor = model.accessors.at(static_cast<size_t>(accessor_index));
  const auto& view = model.bufferViews.at(static_cast<size_t>(accessor.bufferView));
  std::vector<T> values(accessor.count);
  std::memcpy(values.data(), model.buffers[0].data.data() + view.byteOffset + accessor.byteOffset,
              values.size() * sizeof(T));
  return values;
}

using Float3 = std::array<float, 3>;
Vec3 Vector(const Float3& f) { return {f[0], f[1], f[2]}; }

struct ReadSurface {
  std::vector<Vec3> positions, normals;
  std::vector<uint32_t> indices;
  std::vector<Vec3> Corners() const {
    std::vector<Vec3> corners;
    for (const uint32_t i : indices) corners.push_back(positions[i]);
    return corners;
  }
};

ReadSurface Surface(const tinygltf::Model& model, const tinygltf::Primitive& primitive) {
  ReadSurface surface;
  for (const auto& f : Read<Float3>(model, primitive.attributes.at("POSITION"))) {
    surface.positions.push_back(Vector(f));
  }
  for (const auto& f : Read<Float3>(model, primitive.attributes.at("NORMAL"))) {
    surface.normals.push_back(Vector(f));
  }
  surface.indices = Read<uint32_t>(model, primitive.indices);
  return surface;
}

ModelMesh Sample() { return ModelMeshFrom(tests::Courtyard()); }
std::string SampleBytes() {
  const auto bytes = GltfBytes(Sample(), GltfForm::kBinary);
  EXPECT_TRUE(bytes) << FormatError(bytes.error());
  return bytes.value_or("");
}

TEST(ExportGlb, ContainerIsAsTheSpecificationSays) {
  const std::string bytes = SampleBytes();
  ASSERT_GT(bytes.size(), 28u);
  EXPECT_EQ(bytes.substr(0, 4), "glTF");
  EXPECT_EQ(WordAt(bytes, 4), 2u);
  EXPECT_EQ(WordAt(bytes, 8), bytes.size());
  const uint32_t json_length = WordAt(bytes, 12);
  EXPECT_EQ(json_length % 4, 0u);
  EXPECT_EQ(bytes.substr(16, 4), "JSON");
  const size_t second = 20 + json_length;
  EXPECT_EQ(WordAt(bytes, second) % 4, 0u);
  EXPECT_EQ(bytes.substr(second + 4, 3), "BIN");
  EXPECT_EQ(second + 8 + WordAt(bytes, second), bytes.size());
}

TEST(ExportGlb, AccessorsLieWithinTheirViewsAndNameTheirBounds) {
  const tinygltf::Model model = Load(SampleBytes());
  EXPECT_EQ(model.asset.version, "2.0");
  ASSERT_EQ(model.buffers.size(), 1u);
  for (const auto& view : model.bufferViews) {
    EXPECT_EQ(view.byteOffset % 4, 0u);
    EXPECT_LE(view.byteOffset + view.byteLength, model.buffers[0].data.size());
    EXPECT_GT(view.byteLength, 0u);
  }
  for (const auto& mesh : model.meshes) {
    for (const auto& primitive : mesh.primitives) {
      const int index = primitive.attributes.at("POSITION");
      const auto& accessor = model.accessors.at(static_cast<size_t>(index));
      Float3 low{}, high{};
      low.fill(std::numeric_limits<float>::max());
      high.fill(-std::numeric_limits<float>::max());
      for (const Float3& p : Read<Float3>(model, index)) {
        for (int i = 0; i < 3; ++i) {
          low[i] = std::min(low[i], p[i]);
          high[i] = std::max(high[i], p[i]);
        }
      }
      for (int i = 0; i < 3; ++i) {
        EXPECT_EQ(static_cast<float>(accessor.minValues.at(i)), low[i]);
        EXPECT_EQ(static_cast<float>(accessor.maxValues.at(i)), high[i]);
      }
      const size_t vertices = accessor.count;
      for (const uint32_t i : Read<uint32_t>(model, primitive.indices)) ASSERT_LT(i, vertices);
      EXPECT_EQ(model.accessors[primitive.attributes.at("NORMAL")].count, vertices);
      EXPECT_EQ(model.accessors[primitive.indices].count % 3, 0u);
    }
  }
}

TEST(ExportGlb, OneNodeAndMeshForEachSymbolAndAMaterialForEachColour) {
  const tinygltf::Model model = Load(SampleBytes());
  std::vector<std::string> names;
  for (const int i : model.scenes.at(0).nodes) {
    const auto& node = model.nodes.at(static_cast<size_t>(i));
    names.push_back(node.name);
    EXPECT_EQ(model.meshes.at(static_cast<size_t>(node.mesh)).name, node.name);
  }
  EXPECT_EQ(names, (std::vector<std::string>{"Garden", "Mass", "Shed", "Sign"}));
  std::set<std::string> materials;
  for (const auto& material : model.materials) {
    materials.insert(material.name);
    EXPECT_EQ(material.doubleSided, material.name.ends_with("_two_sided"));
  }
  EXPECT_EQ(materials, (std::set<std::string>{"color_C8A084", "plain", "plain_two_sided"}));
  const auto& color = model.materials[1].pbrMetallicRoughness.baseColorFactor;
  EXPECT_NEAR(color[0], 0.5776, 1e-4);  // 0xC8 by the sRGB curve
}

TEST(ExportGlb, NormalsAgreeWithWindingAndBodiesAreClosedAndOutward) {
  const tinygltf::Model model = Load(SampleBytes());
  for (const auto& mesh : model.meshes) {
    for (const auto& primitive : mesh.primitives) {
      const ReadSurface s = Surface(model, primitive);
      const std::vector<Vec3> corners = s.Corners();
      for (size_t i = 0; i < corners.size(); i += 3) {
        const Vec3 winding =
            glm::normalize(glm::cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i]));
        for (size_t k = i; k < i + 3; ++k) {
          EXPECT_NEAR(glm::length(s.normals[s.indices[k]]), 1, 1e-6);
          EXPECT_GT(glm::dot(winding, s.normals[s.indices[k]]), 0.9999);
        }
      }
      if (mesh.name != "Mass" && mesh.name != "Shed") continue;
      EXPECT_TRUE(tests::IsClosed(s.positions, s.indices)) << mesh.name;
      const double volume = mesh.name == "Mass" ? (14.2 * 5.8 + 9.6 * 6.8 - 5.2 * 7.2) * 7.3
                                                : 3.3 * 3.1 * (2.9 + 4.1);
      EXPECT_NEAR(tests::SignedVolume(corners), volume, 1e-3) << mesh.name;
    }
  }
}

TEST(ExportGlb, SameModelGivesSameBytes) { EXPECT_EQ(SampleBytes(), SampleBytes()); }

TEST(ExportGlb, TextFormHoldsTheSameModel) {
  const auto text = GltfBytes(Sample(), GltfForm::kText);
  ASSERT_TRUE(text) << FormatError(text.error());
  tinygltf::Model model;
  std::string error, warning;
  ASSERT_TRUE(tinygltf::TinyGLTF().LoadASCIIFromString(&model, &error, &warning, text->data(),
                                                       static_cast<unsigned>(text->size()), ""))
      << error;
  EXPECT_EQ(model.buffers.at(0).data, Load(SampleBytes()).buffers.at(0).data);
}

TEST(ExportGlb, NamesThatAreNotUtf8AreMadeSo) {
  ModelMesh mesh = Sample();
  mesh.parts[0].symbol = "Gar\xff\xfe";
  mesh.parts[4].symbol = "";
  const auto bytes = GltfBytes(mesh, GltfForm::kBinary);
  ASSERT_TRUE(bytes);
  const tinygltf::Model model = Load(*bytes);
  EXPECT_EQ(model.nodes.front().name, "Gar__");
  EXPECT_EQ(model.nodes.back().name, "Unnamed");
}

TEST(ExportGlb, NothingToExportIsAnError) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const ModelMesh nothing[] = {{},
                               {{{"Empty", 0, false, {}}}},
                               {{{"Line", 0, false, {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}}}},
                               {{{"Nan", 0, true, {{nan, 0, 0}, {1, 0, 0}, {0, 1, 0}}}}}};
  for (const ModelMesh& mesh : nothing) {
    const auto exported = ExportGltf(PartsOf(mesh), GltfForm::kBinary, "house.glb");
    ASSERT_FALSE(exported);
    EXPECT_EQ(exported.error().code, ErrorCode::kNothingMade);
    EXPECT_NE(exported.error().message.find("house.glb"), std::string::npos);
    EXPECT_FALSE(std::filesystem::exists("house.glb"));
  }
}

/// `mesh`, with the number of parts that were asked for.
ModelParts Counted(const ModelMesh& mesh, size_t* asked) {
  ModelParts parts = PartsOf(mesh);
  parts.visit = [visit = parts.visit, asked](const PartSink& sink) {
    visit([&](const ModelPart& part) { return ++*asked, sink(part); });
  };
  return parts;
}

TEST(ExportGlb, WhatDoesNotFitIsRefusedToTheByte) {
  const ModelMesh sample = Sample();
  const size_t needed = Load(SampleBytes()).buffers.at(0).data.size();
  size_t asked = 0;
  const auto fits = GltfBytes(Counted(sample, &asked), GltfForm::kBinary, needed);
  EXPECT_EQ(fits.value_or(""), SampleBytes());
  EXPECT_EQ(asked, 2 * sample.parts.size()) << "it was not counted first";
  for (const GltfForm form : {GltfForm::kBinary, GltfForm::kText}) {
    const auto exported = ExportGltf(PartsOf(sample), form, "house.glb", needed - 1);
    ASSERT_FALSE(exported);
    EXPECT_EQ(exported.error().code, ErrorCode::kLimitReached);
    EXPECT_EQ(exported.error().message, "house.glb: the model is too large for glTF (4 GB)");
    EXPECT_FALSE(exported.error().hint.empty());
    EXPECT_FALSE(std::filesystem::exists("house.glb"));
  }
}

TEST(ExportGlb, CountingStopsWhereTheLimitIsReachedAndWhatSurelyFitsIsNotCounted) {
  const ModelMesh sample = Sample();
  size_t asked = 0;
  EXPECT_FALSE(GltfBytes(Counted(sample, &asked), GltfForm::kBinary, 100));
  EXPECT_EQ(asked, 1u) << "the first part has more than that";
  asked = 0;
  EXPECT_TRUE(GltfBytes(Counted(sample, &asked), GltfForm::kBinary));
  EXPECT_EQ(asked, sample.parts.size());
}

TEST(ExportGlb, PartsOfTreesAreThoseOfTheirMeshAndNoMoreThanWasSaid) {
  for (const grammar::ShapeTree& tree : {tests::Courtyard(), tests::TownHouse()}) {
    const ModelMesh mesh = ModelMeshFrom(tree);
    const ModelParts parts = PartsOf({&tree});
    const auto bytes = GltfBytes(parts, GltfForm::kBinary);
    ASSERT_TRUE(bytes) << FormatError(bytes.error());
    EXPECT_EQ(*bytes, GltfBytes(mesh, GltfForm::kBinary).value_or(""));
    EXPECT_GE(parts.most_triangles, PartsOf(mesh).most_triangles);
    EXPECT_EQ(TriangleCount(std::array{&tree}), PartsOf(mesh).most_triangles);
  }
}

TEST(ExportGlb, FilesThatCannotBeWrittenAreErrors) {
  const ModelMesh sample = Sample();
  const auto exported = ExportGltf(PartsOf(sample), GltfForm::kBinary, "/no/such/folder/house.glb");
  ASSERT_FALSE(exported);
  EXPECT_EQ(exported.error().code, ErrorCode::kFile);
}

/// A wall of 2 x 1 m that wears an image.
ModelMesh Papered() {
  grammar::Item wall;
  wall.scope.size = Vec3(2, 1, 0);
  grammar::Material material;
  material.name = "bricks";
  material.opacity = 0.5;
  const auto image = grammar::ImageFrom(
      ReadFile(std::string(PARTI_SOURCE_DIR) + "/assets/models/bricks.png").value_or(""),
      "bricks.png");
  EXPECT_TRUE(image);
  material.image = std::make_shared<const grammar::Image>(*image);
  grammar::Paint paint{std::make_shared<const grammar::Material>(material),
                       grammar::TextureMap{Vec3(0.5, 0, 0), Vec3(0, 1, 0), Vec2(0, 0)},
                       std::nullopt};
  wall.paint = std::make_shared<const grammar::Paint>(paint);
  return ModelMeshFrom(grammar::ShapeTree(wall, "Wall"));
}

TEST(ExportGlb, CarriesImagesAndTextureCoordinates) {
  const auto bytes = GltfBytes(Papered(), GltfForm::kBinary);
  ASSERT_TRUE(bytes) << FormatError(bytes.error());
  // Read as an asset, and so all the way round.
  const auto asset = grammar::AssetFromGltf(*bytes, "wall.glb", [](const std::string& name) {
    return Result<std::string>(Fail(ErrorCode::kFile, name));
  });
  ASSERT_TRUE(asset) << FormatError(asset.error());
  ASSERT_EQ(asset->mesh->paints.size(), 1u);
  const grammar::Paint& worn = asset->mesh->paints[0];
  EXPECT_EQ(worn.material->image->bytes, Papered().parts[0].material->image->bytes);
  EXPECT_NEAR(worn.material->opacity, 0.5, 1e-6);
  EXPECT_NEAR(glm::distance(worn.map->At(Vec3(1, 1, 0)), Vec2(1, 1)), 0, 1e-6);
  EXPECT_EQ(*bytes, GltfBytes(Papered(), GltfForm::kBinary).value_or("")) << "the same each time";
}

}  // namespace
}  // namespace parti::app
