#include "app/scene_from_model.h"

#include <gtest/gtest.h>

#include <set>

#include "render/offscreen.h"
#include "tests/app/sample_models.h"
#include "tests/grammar/geometry_support.h"
#include "tests/support/golden.h"

namespace parti::app {
namespace {

using grammar::ShapeIndex;
using render::Scene;

Scene SceneOf(const grammar::ShapeTree& tree) {
  Scene scene;
  AddModel(tree, &scene);
  return scene;
}

TEST(AddModel, EachLeafIsAFaceSetWithItsIdAndNoInnerShapeIs) {
  const grammar::ShapeTree tree = tests::TownHouse();
  const Scene scene = SceneOf(tree);
  std::set<uint32_t> ids;
  for (const render::Faces& faces : scene.faces) {
    EXPECT_FALSE(faces.corners.empty());
    EXPECT_EQ(faces.closed, tree[faces.id - 1].item.type == grammar::ItemType::kVolume);
    ids.insert(faces.id);
  }
  std::set<uint32_t> leaves;
  for (const ShapeIndex i : tree.Leaves()) leaves.insert(i + 1);
  EXPECT_EQ(ids, leaves);
  EXPECT_GT(leaves.size(), 100u);
}

TEST(AddModel, SeveralLotsHaveTheirOwnIds) {
  const grammar::ShapeTree tree = tests::Courtyard();
  Scene scene;
  const grammar::ShapeTree* const trees[] = {&tree, &tree};
  AddModels(trees, &scene);
  std::set<uint32_t> ids;
  for (const render::Faces& faces : scene.faces) ids.insert(faces.id);
  EXPECT_EQ(ids.size(), scene.faces.size());
}

TEST(AddModel, GivenColoursStayAndOthersAreOneForEachSymbol) {
  const grammar::ShapeTree tree = tests::Courtyard();
  const Scene scene = SceneOf(tree);
  ASSERT_EQ(scene.faces.size(), 5u);
  EXPECT_NEAR(scene.faces[1].color.r, 0xC8 / 255.0, 1e-6);
  EXPECT_EQ(scene.faces[2].color, scene.faces[3].color);  // both sheds
  EXPECT_NE(scene.faces[0].color, scene.faces[2].color);
  for (const render::Faces& faces : scene.faces) {
    for (int i = 0; i < 3; ++i) {
      EXPECT_GE(faces.color[i], 0);
      EXPECT_LE(faces.color[i], 1);
    }
  }
}

/// A square of 2 m on the ground that wears an image 1 m wide, far out.
grammar::ShapeTree Paved(uint32_t color_rgb) {
  grammar::Item lot = grammar::tests::Lot("5000,0 5002,0 5002,2 5000,2");
  grammar::Material material;
  material.image = std::make_shared<const grammar::Image>(grammar::Image{"paving.png", "PNG"});
  grammar::Paint paint;
  paint.material = std::make_shared<const grammar::Material>(material);
  paint.map = grammar::TextureMap{{1, 0, 0}, {0, 0, -1}, {0.25, 0}};
  lot.paint = std::make_shared<const grammar::Paint>(paint);
  lot.color_rgb = color_rgb;
  return grammar::ShapeTree(lot, "Lot");
}

TEST(AddModel, ImagesAreWornWhereTheyLieAndWhiteUnlessTinted) {
  const Scene scene = SceneOf(Paved(0));
  ASSERT_EQ(scene.faces.size(), 1u);
  const render::Faces& faces = scene.faces[0];
  ASSERT_TRUE(faces.image);
  EXPECT_EQ(*faces.image, "PNG");
  EXPECT_EQ(faces.color, render::Vec3f(1, 1, 1));
  ASSERT_EQ(faces.uvs.size(), faces.corners.size());
  for (size_t i = 0; i < faces.uvs.size(); ++i) {
    const double u = faces.corners[i].x + 0.25 - faces.uvs[i].x;
    EXPECT_NEAR(u, std::round(u), 1e-6) << "shifted by whole images";
    EXPECT_LE(std::abs(faces.uvs[i].x), 4) << "near 0, where float is finest";
  }
  EXPECT_NEAR(SceneOf(Paved(0xC80000)).faces[0].color.r, 0xC8 / 255.0, 1e-6);
}

TEST(AddModel, SharedEdgesAreDrawnOnce) {
  const grammar::ShapeTree tree = tests::TownHouse();
  size_t own = 0;
  for (const ShapeIndex i : tree.Leaves()) own += grammar::EdgesOf(tree[i].item).size();
  const Scene scene = SceneOf(tree);
  ASSERT_EQ(scene.lines.size(), 1u);
  EXPECT_LT(scene.lines[0].ends.size() / 2, own * 2 / 3);
}

TEST(AddStroke, LiesWhereItWasDrawnAndIsAsWideAsItsPressure) {
  Scene scene;
  AddStroke({{{10, 20}, 0, 0.0}, {{30, 20}, 0.1, 1.0}, {{30, 50}, 0.2, std::nullopt}}, &scene, 2);
  ASSERT_EQ(scene.ink.size(), 1u);
  const render::Ink& ink = scene.ink[0];
  EXPECT_EQ(ink.points, (std::vector<render::Vec2f>{{20, 40}, {60, 40}, {60, 100}}));
  EXPECT_EQ(ink.widths_px, (std::vector<float>{3, 9, 6}));
  AddStroke({}, &scene);
  EXPECT_EQ(scene.ink.size(), 1u);
}

TEST(AddSuggestion, IsAWireFrameOnTop) {
  Scene scene;
  const auto box = grammar::BoxFrom({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {4, 3, 2}});
  AddSuggestion(grammar::EdgesOf(*box), &scene);
  ASSERT_EQ(scene.lines.size(), 1u);
  EXPECT_EQ(scene.lines[0].ends.size(), 24u);
  EXPECT_TRUE(scene.lines[0].on_top);
  EXPECT_GT(scene.lines[0].dash_px, 0);
  EXPECT_TRUE(scene.faces.empty());
}

/// Draws with the best renderer there is.
render::Image Draw(const Scene& scene, const Camera& camera) {
  auto renderer = render::OffscreenRenderer::Create();
  EXPECT_TRUE(renderer) << FormatError(renderer.error());
  auto image = (*renderer)->Draw(scene, camera);
  EXPECT_TRUE(image) << FormatError(image.error());
  return image.value_or(render::Image{});
}

TEST(ScenePicture, TownHouse) {
  const Scene scene = SceneOf(tests::TownHouse());
  const Camera camera = AutoView(render::BoundsOf(scene, true), 800, 500);
  parti::tests::ExpectGolden(Draw(scene, camera), "app_town_house");
}

TEST(ScenePicture, CourtyardWithSuggestionAndStroke) {
  const grammar::ShapeTree tree = tests::Courtyard();
  Scene scene = SceneOf(tree);
  const Camera camera = AutoView(render::BoundsOf(scene, true), 800, 500);
  const auto storey =
      grammar::BoxFrom({{17.1, 4.1, 4.4}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {3.3, 3, 3.1}});
  AddSuggestion(grammar::EdgesOf(*storey), &scene);
  const Segment3 lifted{{17.1, 4.1, 7.5}, {17.1, 7.1, 7.5}};
  AddLiftedLines({{lifted}}, &scene);
  const View view(camera);
  Stroke stroke;
  for (int i = 0; i <= 30; ++i) {
    const double t = i / 30.0;
    const Vec2 wobble(1.5 * std::sin(8 * t), 0);
    stroke.push_back({*view.Project(lifted.a + (lifted.b - lifted.a) * t) + wobble, 0.01 * i,
                      std::sin(kPi * t)});
  }
  AddStroke(stroke, &scene);
  parti::tests::ExpectGolden(Draw(scene, camera), "app_courtyard");
}

}  // namespace
}  // namespace parti::app
