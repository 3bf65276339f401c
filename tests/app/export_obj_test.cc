// OBJ read back by tinyobjloader.
#include "app/export_obj.h"

#include <gtest/gtest.h>
#include <tiny_obj_loader.h>

#include <filesystem>
#include <limits>
#include <sstream>

#include "base/text_file.h"
#include "tests/app/sample_models.h"

namespace parti::app {
namespace {

struct ReadObj {
  tinyobj::attrib_t attributes;
  std::vector<tinyobj::shape_t> shapes;
  std::vector<tinyobj::material_t> materials;

  std::vector<Vec3> points() const {
    std::vector<Vec3> points;
    const auto& v = attributes.vertices;
    for (size_t i = 0; i + 2 < v.size(); i += 3) points.emplace_back(v[i], v[i + 1], v[i + 2]);
    return points;
  }
};

ReadObj Load(const ObjText& text) {
  ReadObj read;
  std::string warning, error;
  std::istringstream obj(text.obj), mtl(text.mtl);
  tinyobj::MaterialStreamReader materials(mtl);
  EXPECT_TRUE(tinyobj::LoadObj(&read.attributes, &read.shapes, &read.materials, &warning, &error,
                               &obj, &materials, false))
      << error;
  EXPECT_EQ(error + warning, "");
  return read;
}

ModelMesh Sample() { return ModelMeshFrom(tests::Courtyard()); }

TEST(ExportObj, GroupsAreSymbolsAndMaterialsAreColours) {
  const ReadObj read = Load(*ObjTextOf(Sample(), "house.mtl"));
  std::vector<std::string> names;
  for (const auto& shape : read.shapes) names.push_back(shape.name);
  EXPECT_EQ(names, (std::vector<std::string>{"Garden", "Mass", "Shed", "Sign"}));
  ASSERT_EQ(read.materials.size(), 2u);
  for (const auto& shape : read.shapes) {
    for (const int material : shape.mesh.material_ids) {
      const bool colored = shape.name == "Mass";
      EXPECT_EQ(read.materials.at(static_cast<size_t>(material)).name,
                colored ? "color_C8A084" : "plain");
    }
  }
  EXPECT_NEAR(read.materials[1].diffuse[0], 0xC8 / 255.0, 1e-4);
}

TEST(ExportObj, ImagesLieBesideTheFileAndCornersSayWhereInThem) {
  grammar::Item wall;
  wall.scope.size = Vec3(2, 1, 0);
  grammar::Material material;
  material.name = "bricks";
  material.image = std::make_shared<const grammar::Image>(grammar::Image{"bricks.png", "PNG"});
  wall.paint = std::make_shared<const grammar::Paint>(grammar::Paint{
      std::make_shared<const grammar::Material>(material),
      grammar::TextureMap{Vec3(0.5, 0, 0), Vec3(0, 1, 0), Vec2(0, 0)}, std::nullopt});
  const ModelMesh mesh = ModelMeshFrom(grammar::ShapeTree(wall, "Wall"));
  const ReadObj read = Load(*ObjTextOf(mesh, "wall.mtl"));
  ASSERT_EQ(read.materials.size(), 1u);
  EXPECT_EQ(read.materials[0].diffuse_texname, "bricks.png");
  EXPECT_EQ(read.attributes.texcoords.size(), 2 * 4u);
  const auto folder = std::filesystem::temp_directory_path() / "parti_obj_images";
  std::filesystem::create_directories(folder);
  ASSERT_TRUE(ExportObj(mesh, (folder / "wall.obj").string()));
  EXPECT_EQ(ReadFile((folder / "bricks.png").string()).value_or(""), "PNG");
  std::filesystem::remove_all(folder);
}

TEST(ExportObj, NormalsAgreeWithWindingAndBodiesAreClosedAndOutward) {
  const ReadObj read = Load(*ObjTextOf(Sample(), "house.mtl"));
  const std::vector<Vec3> points = read.points();
  for (const auto& shape : read.shapes) {
    std::vector<uint32_t> triangles;
    std::vector<Vec3> corners;
    for (size_t i = 0; i < shape.mesh.indices.size(); ++i) {
      EXPECT_EQ(shape.mesh.num_face_vertices[i / 3], 3);
      triangles.push_back(static_cast<uint32_t>(shape.mesh.indices[i].vertex_index));
      corners.push_back(points.at(triangles.back()));
    }
    for (size_t i = 0; i < corners.size(); i += 3) {
      const Vec3 winding =
          glm::normalize(glm::cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i]));
      const auto& n = read.attributes.normals;
      const auto at = static_cast<size_t>(shape.mesh.indices[i].normal_index) * 3;
      EXPECT_GT(glm::dot(winding, Vec3(n.at(at), n.at(at + 1), n.at(at + 2))), 0.9999);
    }
    if (shape.name != "Mass" && shape.name != "Shed") continue;
    EXPECT_TRUE(tests::IsClosed(points, triangles)) << shape.name;
    EXPECT_GT(tests::SignedVolume(corners), 60) << shape.name;
  }
}

TEST(ExportObj, ShapesShareNoCorners) {
  const ObjText text = *ObjTextOf(Sample(), "house.mtl");
  std::istringstream lines(text.obj);
  int corners = 0;
  for (std::string line; std::getline(lines, line);) corners += line.starts_with("v ") ? 1 : 0;
  EXPECT_EQ(corners, 4 + 2 * 10 + 2 * 8 + 3);
}

TEST(ExportObj, WithoutColoursThereIsNoMaterialFile) {
  ModelMesh mesh = Sample();
  for (ModelPart& part : mesh.parts) part.color_rgb = 0;
  const ObjText text = *ObjTextOf(mesh, "house.mtl");
  EXPECT_EQ(text.mtl, "");
  EXPECT_EQ(text.obj.find("mtl"), std::string::npos);
  Load(text);
}

TEST(ExportObj, WritesBothFilesAndTheOneNamesTheOther) {
  const auto folder = std::filesystem::path(testing::TempDir());
  const std::string path = (folder / "parti_export.obj").string();
  ASSERT_TRUE(ExportObj(Sample(), path));
  const std::string obj = *ReadFile(path);
  EXPECT_NE(obj.find("mtllib parti_export.mtl\n"), std::string::npos);
  EXPECT_EQ(obj, ObjTextOf(Sample(), "parti_export.mtl")->obj) << "same model, same bytes";
  EXPECT_NE(ReadFile((folder / "parti_export.mtl").string())->find("color_C8A084"),
            std::string::npos);
}

TEST(ExportObj, BlanksInSymbolsDoNotBreakTheLine) {
  ModelMesh mesh = Sample();
  mesh.parts[0].symbol = "Front garden\n";
  EXPECT_EQ(Load(*ObjTextOf(mesh, "x.mtl")).shapes.front().name, "Front_garden_");
}

TEST(ExportObj, FailuresAreErrors) {
  const auto nothing = ExportObj(ModelMesh(), "house.obj");
  ASSERT_FALSE(nothing);
  EXPECT_EQ(nothing.error().code, ErrorCode::kNothingMade);
  EXPECT_NE(nothing.error().message.find("house.obj"), std::string::npos);
  EXPECT_EQ(ExportObj(Sample(), "/no/such/folder/house.obj").error().code, ErrorCode::kFile);
}

}  // namespace
}  // namespace parti::app
